// Files of every format, for the manual: small ones that are read by the program's own readers.
#pragma once

#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/pattern/pattern.h"

namespace tact {

// A file of assets/manual/examples, with its name above it.
Expected<std::string> example_html(std::string_view file);

// What effects are shown of: a swell with a tick in it.
Pattern manual_pattern();

// That pattern as a file of another program: "ahap", a key of model/io/effects_out/write_effect.h.
Expected<std::string> effect_html(std::string_view key);

}  // namespace tact
