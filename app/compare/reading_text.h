// Text that is read, not looked up: what is said of people, of proofs and of results.
#pragma once

#include <imgui.h>

#include <string>

namespace tact {

// In the current font, in lines no wider than the eye can follow, broken at spaces alone: numbers
// stay whole.
void reading_text(ImU32 colour, const std::string& text);

}  // namespace tact
