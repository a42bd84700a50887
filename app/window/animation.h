// Pictures of the program: a view, and an animation as numbered pictures.
//
// They are drawn between the window's frames, because ImGui draws one thing at a time; an animation
// draws one picture between two frames, so that the window keeps answering.
//
// Input     the program as it is when an export begins; later edits are not in it
// Output    whole files, also of a cancelled export; the status line tells where
#pragma once

#include <filesystem>

#include "app/window/app.h"

namespace tact {

void export_animation(App& app, const std::filesystem::path& folder);
void cancel_animation(App& app);

// One step of a lesson as SVG, as the program would open on it.
std::string step_picture(const Lesson& lesson, std::size_t step);

// Whether continue_exports() has a picture to draw. It draws one, and must be called between two
// frames.
bool is_exporting(const App& app);
void continue_exports(App& app);

}  // namespace tact
