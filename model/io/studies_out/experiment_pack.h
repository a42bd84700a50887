// A pairwise study for programs that run experiments: stimuli, the trials of each participant as
// this program would ask them, and a script that asks them.
//
//     stimuli/01-NAME.wav   16 bits, one scale for all: what the strongest reaches is full scale
//     trials.csv            participant,trial,left,right,left_file,right_file
//     study.json, study.js  names, files, words and the fingerprint of what is felt
//     experiment.html, .js  for jsPsych 7 or 8; or experiment.py for PsychoPy
//     README.txt
//
// Source    jspsych.org, psychopy.org
// Input     a set with its study; sorting is not packed
// Output    files by their paths. The answers are read back by
//           model/io/studies_out/packed_answers.h
// Exact     same input, same bytes
#pragma once

#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/io/studies_out/psych_ds.h"
#include "model/set/pattern_set.h"

namespace tact {

enum class PackFor { jspsych, psychopy };
inline constexpr const char* kPackNames[] = {"jspsych", "psychopy"};

// "P01": also the participant's part of the trials.
std::string packed_participant(std::size_t number);

// Errors: fewer than three patterns, as the order of a single pair cannot be mixed; a pattern that
// is no waveform of one channel a file can hold.
Expected<std::vector<DatasetFile>> pack_files(const PatternSet& set, PackFor what,
                                              std::size_t participants);

}  // namespace tact
