// No document is replaced, no file written over and no window closed while the only copy of what
// somebody made is in memory, or in the file about to be written.
#pragma once

#include <filesystem>
#include <string>

#include "app/window/app.h"

namespace tact {

// Unsaved changes of the open document go to a file of their own, which heads the recent ones.
// Empty: there were none. An Error: they could not be kept, and the document has to stay.
Expected<std::filesystem::path> keep_unsaved(App& app);

// The sentence that says so.
void refuse_to_replace(App& app, const std::string& reason);

// Whether the window may close: what is unsaved is kept for the next start. Where it cannot be, the
// window stays and asks. A study under way ends first; its answers are on the disk.
bool may_close(App& app);
void quit(App& app);

// The file as it is now holds what was never seen here.
bool is_changed_outside(const Document& document, const std::filesystem::path& file);

// What was wrong with the session at the start, and what was recovered: a notice.
void tell_of_start(App& app);

}  // namespace tact
