// The state of the window between runs: sizes of panes, camera, looks, device, and the open
// document.
#pragma once

#include <filesystem>
#include <vector>

#include "app/window/app.h"
#include "model/common/expected.h"

namespace tact {

// Opens the paths, or restores the last session, or shows the example set. An Error if the paths
// cannot be opened.
Expected<Done> start_session(App& app, const std::vector<std::filesystem::path>& paths);

// Sizes of the panes and the camera, to and from the session.
void keep_layout(App& app);
void restore_layout(App& app);

void end_session(App& app);

// The program ends in the middle of a frame: unsaved changes are kept for the next start. An Error:
// they are lost.
Expected<Done> keep_before_end(App& app);

// Whether the window may close: unsaved changes are kept for the next start. If they cannot be
// kept, the window stays and asks. A running study ends first; its answers are on the disk.
bool may_close(App& app);
// The same if a person closes the window: the first time, a message tells that unsaved changes are
// kept.
bool close_window(App& app);
void quit(App& app);

// A notice on errors of the session at the start, and on recovered changes.
void tell_of_start(App& app);

}  // namespace tact
