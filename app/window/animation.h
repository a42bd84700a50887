// Pictures of the program as it is: a view, and the animation as numbered pictures.
//
// They are drawn between the window's frames, as ImGui draws one thing at a time; of an animation
// one at a time, so that the window goes on answering.
//
// Input     the program as it is when an export begins; edits meanwhile are not in it
// Output    whole files, also of an export that is cancelled; the status line says where
#pragma once

#include <filesystem>

#include "app/window/app.h"

namespace tact {

void export_animation(App& app, const std::filesystem::path& folder);
void cancel_animation(App& app);

// One step of a lesson as SVG, as the program would open on it.
std::string step_picture(const Lesson& lesson, std::size_t step);

// Something waits to be drawn by continue_exports(), which draws one picture and belongs between
// two frames.
bool is_exporting(const App& app);
void continue_exports(App& app);

}  // namespace tact
