// The program with its window on the screen.
#pragma once

#include <filesystem>
#include <vector>

#include "model/common/expected.h"

namespace tact {

// Opens the window on the sets, or on the last session without any; returns when it is closed.
Expected<Done> run_main_window(const std::vector<std::filesystem::path>& sets);

}  // namespace tact
