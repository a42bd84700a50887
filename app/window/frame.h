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

// Carries changes of the document to everything that holds patterns by name, or files beside the
// document. Part of each frame.
void follow_changes(App& app);

// Draws everything into the current ImGui frame. `time_s` never decreases.
void draw_frame(App& app, std::span<const KeyPress> pressed, double time_s);

// The panes without side effects, for a picture: no input, no playing, no jobs, no autosave.
void draw_still_window(App& app);

// Another frame is needed without input, because something moves.
bool wants_another_frame(const App& app);

// Seconds until the next frame is needed without input: for progress, a fading status line, the
// autosave. Infinite: no frame is needed.
double next_wake_s(const App& app);

// The full map is being computed: its progress should be drawn from time to time.
bool is_computing(const App& app);

// The same for a comparison with people, or a check of findings.
bool is_comparing(const App& app);

// An App with theme and layout, ready for start_session(); make_theme() makes its fonts.
App make_app();

// Theme, fonts and style for the current ImGui context, scaled by app.ui.content_scale x
// app.ui.text_scale, and larger for a participant. The atlas must be empty.
void make_theme(App& app);

// The program with its window on the screen: opens it on the sets, or without any on the last
// session; returns when it is closed.
Expected<Done> run_main_window(const std::vector<std::filesystem::path>& sets);

}  // namespace tact
