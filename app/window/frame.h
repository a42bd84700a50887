// One frame of the program: input, answers of the jobs, menus, panes, dialogs.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "app/screen/input_queue.h"
#include "app/window/app.h"
#include "model/common/expected.h"

namespace tact {

// What was done to the document reaches those who hold patterns by their names, or files beside it.
// Part of each frame.
void follow_changes(App& app);

// Draws everything into the current ImGui frame. `time_s` never runs backwards.
void draw_frame(App& app, std::span<const KeyPress> pressed, double time_s);

// The panes as they stand, for a picture: nothing is taken in, played, asked for or kept.
void draw_still_window(App& app);

// Another frame is needed without input: something moves.
bool wants_another_frame(const App& app);

// Without input, when the next frame is needed at the latest: for progress, for a line at the foot
// that fades, for the copy on the disk. Infinite: not at all.
double next_wake_s(const App& app);

// The full run is under way: its progress is worth a look now and then.
bool is_computing(const App& app);

// So is a comparison with people, or a check of findings.
bool is_comparing(const App& app);

// An App with theme and layout, ready for start_session(); fonts are made by make_theme().
App make_app();

// Theme, fonts and style for the current ImGui context, at app.ui.content_scale x
// app.ui.text_scale, and larger for a participant. The atlas must be empty.
void make_theme(App& app);

// The program with its window on the screen: opens it on the sets, or on the last session without
// any; returns when it is closed.
Expected<Done> run_main_window(const std::vector<std::filesystem::path>& sets);

}  // namespace tact
