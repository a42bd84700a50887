// What a person works on: the document, its undo steps, what of it is looked at, and what is
// unsaved.
#pragma once

#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include "app/document/changes.h"
#include "app/document/edited_document.h"
#include "app/document/selection.h"
#include "app/document/vibration_cache.h"
#include "app/session/session.h"
#include "model/set/felt_versions.h"
#include "model/set/measured_twin.h"

namespace tact {

// Files of other programs' effects that the document was made of.
struct EffectFiles {
    std::vector<std::filesystem::path> paths;
    std::vector<std::vector<Vibration>> read;  // each vibration of theirs, as each map has read it
};

struct DocumentEffects {
    std::vector<EffectFiles> files;
    bool is_told = false;  // by which maps they were read, above the list of patterns
};

struct Workspace {
    EditedDocument document;            // with its undo steps
    std::uint64_t revision = 1;         // of document.set, every change during a drag too
    std::uint64_t document_number = 1;  // tells the open one from all others; part of each request
    std::uint64_t documents = 1;        // that were numbered so far
    DocumentChanges changes;
    DocumentEffects effects;
    Selection selection;
    Side side = Side::both;  // of the set: in the map, the matrix and what follows them
    VibrationCache cache;
    StalePatterns stale;             // what of the set is not as it was felt or measured ...
    EditedDocument::State stale_of;  // ... as of this step
    bool own_heights = false;        // waveforms fill their rows, instead of one scale of g for all
    Session session;
    std::vector<Vibration> clipboard;    // what was copied here last ...
    std::string clipboard_text;          // ... and as the desktop has it: a set file
    bool unsaved = false;                // the document differs from its file ...
    std::uint64_t unsaved_revision = 0;  // ... as of this revision
    bool autosave_pending = false;
    double autosave_due_s = 0.0;
    double unkept_since_s = 0.0;              // the first change that is pending
    std::future<std::string> autosave_write;  // under way; its value is the error
    std::string autosave_error;               // why unsaved changes are in memory alone
};

}  // namespace tact
