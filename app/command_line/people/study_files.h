// What a command makes of a study's folder: who counts by its options.
#pragma once

#include <vector>

#include "app/command_line/commands.h"
#include "model/common/expected.h"
#include "model/io/studies_out/psych_ds.h"
#include "model/set/pattern_set.h"
#include "model/study/study_results.h"

namespace tact {

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

}  // namespace tact
