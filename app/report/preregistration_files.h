// A plan frozen in a folder: the file that a study is held against later, and a page to deposit.
#pragma once

#include <filesystem>

#include "model/common/expected.h"
#include "model/planning/preregistration.h"

namespace tact {

// Makes the folder. An Error if there is a preregistration already: it is written once.
Expected<Done> write_preregistration(const std::filesystem::path& folder,
                                     const Preregistration& plan);

}  // namespace tact
