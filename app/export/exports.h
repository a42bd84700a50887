// Exports from the window: a view as a picture, stages as CSV, the animation as numbered pictures.
//
// Output    whole files; the status line says where
// Left out  drawing pictures, which takes the whole program: app/window/animation.h
#pragma once

#include <filesystem>

#include "app/document/workspace.h"
#include "app/export/export_state.h"
#include "app/physiology/physiology_state.h"
#include "app/pictures/frame_sequence.h"
#include "app/rendering/rendering_state.h"
#include "app/ui/ui.h"

namespace tact {

// The menu's commands: each asks for what it needs.
void export_view_dialog(Ui& ui);
void export_stages_dialog(Ui& ui, const Workspace& work, const RenderingState& rendered,
                          const Physiology& physiology);
void export_animation_dialog(Ui& ui, const Workspace& work, ExportState& exports);

// Where to: after the dialogs.
void choose_picture(Ui& ui, const Workspace& work, const ExportState& exports);
void choose_frames(Ui& ui, const Workspace& work, const ExportState& exports);

// What the chooser's answer starts. PNG or SVG by the name's ending; the stage that is open, or
// all of them, with the files of "tactspace stages".
void export_view(ExportState& exports, const std::filesystem::path& file);
void export_stages(Ui& ui, const Workspace& work, const RenderingState& rendered,
                   const Physiology& physiology, const std::filesystem::path& folder);

// The dialogs, and the progress of an animation.
void draw_exports(Ui& ui, const Workspace& work, ExportState& exports);

}  // namespace tact
