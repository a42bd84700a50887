// Where the person left the window: sizes of panes, camera, looks, device, and the open document.
#pragma once

#include <filesystem>
#include <vector>

#include "app/window/app.h"
#include "model/common/expected.h"

namespace tact {

// Starts with the paths, or takes up the session where it was left, or shows the example set. An
// Error if the paths cannot be opened.
Expected<Done> start_session(App& app, const std::vector<std::filesystem::path>& paths);

// Sizes of the panes and the camera, to and from the session.
void keep_layout(App& app);
void restore_layout(App& app);

void end_session(App& app);

// The program ends in the middle of a frame: what is unsaved is kept for the next start. An Error:
// it is lost.
Expected<Done> keep_before_end(App& app);

// Whether the window may close: what is unsaved is kept for the next start. Where it cannot be, the
// window stays and asks. A study under way ends first; its answers are on the disk.
bool may_close(App& app);
// The same when a person asks for it: who was never told that unsaved changes are kept is told.
bool close_window(App& app);
void quit(App& app);

// What was wrong with the session at the start, and what was recovered: a notice.
void tell_of_start(App& app);

}  // namespace tact
