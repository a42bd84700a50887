// The manual from within the window: the installed page, or one that is made in the background and
// kept, in the reader's browser.
//
// Source    XDG Base Directory Specification 0.8; xdg-open of xdg-utils
// Output    where the page is, in the status line, whether or not there is a browser
// Left out  what a browser says of it.
#pragma once

#include <filesystem>

#include "app/manual/manual_state.h"
#include "app/ui/ui.h"

namespace tact {

// Beside a program in bin/, as packages have it.
std::filesystem::path installed_manual(const std::filesystem::path& program);

// A page per version, in the cache folder; empty without a home.
std::filesystem::path kept_manual();

// Opens a page at once, or as soon as it is made.
void open_manual(Ui& ui, ManualState& manual);

// Once a frame: opens what was made.
void take_manual(Ui& ui, ManualState& manual);

}  // namespace tact
