// Everything a pattern goes through as CSV texts, for the window and the command line alike.
//
// Input     the pattern's waveform, padded as in its set: the stages are those behind its numbers
// Output    numbers in the shortest form that reads back the same; in files of many cells or steps
//           those at zero are left out
#pragma once

#include <string>
#include <vector>

#include "app/physiology/stages.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/physiology/neural_coding.h"

namespace tact {

// What all files of a pattern are made from.
struct StageValues {
    Waveform waveform;
    PerceptualModelParams model;
    NeuralCodingStages neural;  // without layers
};

// `waveform` at 10 kHz.
StageValues stage_values(const Waveform& waveform, const PerceptualModelParams& model);

struct CsvFile {
    std::string name;  // "brain_waveform.csv"
    std::string text;
};

std::vector<std::string> stage_csv_names(Stage stage);

// The files of one stage: one, or two where it has two kinds of rows.
std::vector<CsvFile> stage_csv(const StageValues& values, Stage stage);

}  // namespace tact
