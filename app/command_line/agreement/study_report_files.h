// All of a study in a folder: tables, a page, and the scripts that compute their numbers again.
#pragma once

#include "app/command_line/commands.h"
#include "app/command_line/people/study_files.h"
#include "model/common/expected.h"
#include "model/set/pattern_set.h"

namespace tact {

// Into the folder `command.report`, which is made; files that are there are replaced.
Expected<Done> write_study_report(const StudyCommand& command, const PatternSet& set,
                                  CollectedStudy study);

}  // namespace tact
