// Unsaved changes outlive the program, whether it is closed, killed or crashes.
//
// The autosave holds the set and the path it belongs to in one file, so that no crash can pair a
// set with another one's path. Recordings are named by absolute path in it.
//
// Input     the document after each change; the caller waits for pauses
// Output    the document of the last run, or a set file of its own for what would be lost
// Left out  undo steps; versions before the last.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/session/document.h"
#include "app/session/session.h"
#include "model/common/expected.h"

namespace tact {

// Keeps the document if it has unsaved changes; otherwise forgets what was kept. An Error: they are
// only in memory.
Expected<Done> autosave(const Session& session, const Document& document);

struct Restored {
    std::optional<Document> document;  // none: nothing was open, or it cannot be read
    std::string remark;                // one sentence for the status line; may be empty
    bool is_error = false;             // of the remark
};

// The document of the last run with its unsaved changes. An autosave that cannot be read is kept
// aside.
Restored restore(Session& session);

// Moves unsaved changes of the last run, if any, to a recovered-YYYYMMDD-HHMMSS.tactspace.json
// that heads the recent files: for a start with another document. Empty: no changes.
Expected<std::filesystem::path> set_autosave_aside(Session& session);

// The same for instances that are gone; lists the new files in session.recovered. Called by
// open_session.
void recover_orphans(Session& session);

// The lock that the instance with this autosave holds while it runs.
std::filesystem::path lock_of(const std::filesystem::path& autosave_file);

}  // namespace tact
