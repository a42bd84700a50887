// A study's folder: who counts, its report, what is said of people.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

#include "app/command_line/commands.h"
#include "model/common/expected.h"
#include "model/evaluation/individuals.h"
#include "model/io/studies_out/psych_ds.h"
#include "model/set/pattern_set.h"
#include "model/study/agreement.h"
#include "model/study/study_record.h"
#include "model/study/study_results.h"

namespace tact {

// What is said of how alike people rate, wherever a command says it: one text, one set of keys.

// Lines under "people"; "" of fewer than two people.
std::string text_of(const InterRater& raters);

// A line on each that is known.
std::string text_of(const OrderEffects& effects);
nlohmann::json json_of(const OrderEffects& effects);

// A table of people, what the dimensions lead from and to, and who is not in it.
std::string text_of(const IndividualWeights& weights);
nlohmann::json json_of(const IndividualWeights& weights);

// What a command makes of a study's folder: who counts by its options.

struct CollectedStudy {
    std::vector<StudyRecord> records;  // of one kind, felt from this set
    StudyResults results;
    CollectRule rule;          // by which
    bool has_changed = false;  // the patterns, since they were felt
};

// By the design's rule and the command's own. Remarks go to standard error; exclusions with a
// reason are recorded in the folder.
Expected<CollectedStudy> collected_study(const StudyCommand& command, const PatternSet& set);

// Where participants of a set are looked for: where the command says, or beside the set's file, as
// the window has it.
std::filesystem::path study_folder_of(const StudyCommand& command);

// What an archive takes of it.
StudyDataset dataset_of(const PatternSet& set, const CollectedStudy& study);

// A study that another program asks: out as a pack, back as participants.

// Errors: the folder is there and holds something, with which these files could be mixed up.
Expected<Done> write_new_folder(const std::filesystem::path& folder,
                                const std::vector<DatasetFile>& files);

// `set` has the design that is packed.
Expected<Done> pack_study(const StudyCommand& command, const PatternSet& set);

// `header`: of the study as it is packed from this set. Nothing is written if any file is at fault.
Expected<Done> unpack_study(const StudyCommand& command, StudyHeader header);

}  // namespace tact
