// Tables of what the program knows itself, for the manual.
#pragma once

#include <string>
#include <string_view>

#include "app/manual/manual.h"
#include "model/common/expected.h"

namespace tact {

// "stages", "stages_left_out", "metrics", "devices", "sets", "targets", "maps", "receptors",
// "pattern", "model", "study" or "textbook".
Expected<std::string> table_html(std::string_view name);

std::string keys_html(const ManualSource& source);
std::string menus_html(const ManualSource& source);

// Every command of the command line with its options; its section is called "command-NAME".
std::string commands_html(const ManualSource& source);

}  // namespace tact
