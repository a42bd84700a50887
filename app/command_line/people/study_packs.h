// A study that another program asks: out as a pack, back as participants.
#pragma once

#include <filesystem>
#include <vector>

#include "app/command_line/commands.h"
#include "model/common/expected.h"
#include "model/io/studies_out/psych_ds.h"
#include "model/set/pattern_set.h"
#include "model/study/study_record.h"

namespace tact {

// Errors: the folder is there and holds something, with which these files could be mixed up.
Expected<Done> write_new_folder(const std::filesystem::path& folder,
                                const std::vector<DatasetFile>& files);

// `set` has the design that is packed.
Expected<Done> pack_study(const StudyCommand& command, const PatternSet& set);

// `header`: of the study as it is packed from this set. Nothing is written if any file is at fault.
Expected<Done> unpack_study(const StudyCommand& command, StudyHeader header);

}  // namespace tact
