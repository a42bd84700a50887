// Exports from the window: a view as a picture, stages as CSV, the animation as numbered pictures.
//
// Pictures are drawn between the window's frames, as ImGui draws one thing at a time; of an
// animation one at a time, so that the window goes on answering.
//
// Input     the program as it is when an export begins; edits meanwhile are not in it
// Output    whole files, also of an export that is cancelled; the status line says where
#pragma once

#include <filesystem>

#include "app/pictures/frame_sequence.h"
#include "app/window/app.h"

namespace tact {

struct RunningAnimation {
    App still;  // what is drawn
    PictureView view = PictureView::physiology;
    PictureSize size;
    FrameSequence sequence;
    int done = 0;  // frames
    double begun_s = 0.0;
};

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
void export_animation(App& app, const std::filesystem::path& folder);
void cancel_animation(App& app);

// Something waits to be drawn by continue_exports(), which draws one picture and belongs between
// two frames.
bool is_exporting(const App& app);
void continue_exports(App& app);

// The dialogs, and the progress of an animation.
void draw_exports(App& app);

}  // namespace tact
