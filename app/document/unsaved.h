// No document is replaced, no file written over and no window closed while the only copy of what
// somebody made is in memory, or in the file about to be written.
#pragma once

#include <filesystem>
#include <string>

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// Unsaved changes of the open document go to a file of their own, which heads the recent ones.
// Empty: no changes. An Error: they could not be kept, and the document has to stay.
Expected<std::filesystem::path> keep_unsaved(Workspace& work);

// The sentence that says so.
void refuse_to_replace(Ui& ui, const std::string& reason);

// A sentence, though what it comes from may lack its stop.
std::string with_stop(std::string text);

// The file as it is now holds what was never seen here.
bool is_changed_outside(const Document& document, const std::filesystem::path& file);

// Until the autosave under way is on the disk: what is written or moved next comes after it.
void wait_for_autosave(const Workspace& work);

}  // namespace tact
