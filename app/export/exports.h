// Exports from the window: a view as a picture, stages as CSV, the animation as numbered pictures.
//
// Output    whole files; the status line says where
// Left out  drawing pictures, which takes the whole program: app/window/animation.h
#pragma once

#include <filesystem>

#include "app/pictures/frame_sequence.h"
#include "app/window/app.h"

namespace tact {

// The menu's commands: each asks for what it needs.
void export_view_dialog(App& app);
void export_stages_dialog(App& app);
void export_animation_dialog(App& app);

// Where to: after the dialogs.
void choose_picture(App& app);
void choose_frames(App& app);

// What the chooser's answer starts. PNG or SVG by the name's ending; the stage that is open, or
// all of them, with the files of "tactspace stages".
void export_view(App& app, const std::filesystem::path& file);
void export_stages(App& app, const std::filesystem::path& folder);

// The dialogs, and the progress of an animation.
void draw_exports(App& app);

}  // namespace tact
