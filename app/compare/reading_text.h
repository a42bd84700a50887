// Text to be read as sentences: on people, proofs and results.
#pragma once

#include <imgui.h>

#include <string>

namespace tact {

// In the current font, in lines of readable length that break only at spaces, so that numbers stay
// whole.
void reading_text(ImU32 colour, const std::string& text);

}  // namespace tact
