// Files are read in the background, and put into the document.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/ui/ui.h"
#include "model/common/expected.h"
#include "model/io/set/load.h"

namespace tact {

// What is being read for the document, in the background, and what could not be read.

struct OpeningRequest {
    std::vector<std::filesystem::path> paths;
    bool adds = false;           // to the open set; default: in its place
    bool partly = false;         // of several paths, those that cannot be read are left out
    std::uint64_t document = 0;  // the number of the open one when it was asked for
    std::uint64_t number = 0;    // tells it from those before it
    double since_s = 0.0;        // on the clock of frames
};

struct OpeningAnswer {
    OpeningRequest request;
    // Whoever puts it into the document takes it away: recordings of a set may have a GB.
    std::shared_ptr<Expected<Loaded>> loaded;
};

struct Opening {
    Query<OpeningRequest, OpeningAnswer> job;
    std::optional<OpeningRequest> asked;  // which is being read, or waits to be shown
    std::uint64_t requests = 0;           // that were numbered so far
    std::vector<std::string> left_out;    // of what was opened last, each "FILE: what was expected"
};

// Opening files, and adding them to the set, in the background: a frame never waits for a file.
//
// Input     paths of sets, folders, recordings and effects, as model/io/set/load.h takes them
// Output    another document, or one undoable step in the open one; an error changes nothing
// Valid     One opening at a time. A newer one takes the place of an older; what is to be added
//           while something is read is refused. What was read waits while a question, a dialog or
//           a hand is on the document, and is added to no other set than it was asked for.
// Left out  a job, as before the window is there: then files are read in place.

// As one set, in the place of the open one. Unsaved changes of that one are kept in a file of their
// own; where they cannot be, it stays.
void open_paths(Ui& ui, Workspace& work, Opening& opening,
                const std::vector<std::filesystem::path>& paths, bool partly = false);

// Behind the current pattern, as one step; names that are taken get a number.
void add_paths(Ui& ui, Workspace& work, Opening& opening,
               const std::vector<std::filesystem::path>& paths, bool partly = false);

// Asks for a set, a recording, an effect file, or a folder of them.
void ask_for_vibrations(Ui& ui, const Workspace& work, const std::string& title,
                        const std::function<void(const std::filesystem::path&)>& take);

// Asks for what add_paths() takes.
void add_dialog(Ui& ui, Workspace& work, Opening& opening);

// Once a frame. `is_free`: nothing lies over the document, and no hand is on it.
void follow_opening(Ui& ui, Workspace& work, Opening& opening, bool is_free);

bool is_opening(const Opening& opening);
void cancel_opening(Ui& ui, Opening& opening);

// "Reading buzz.haptic, 40 %", with Cancel, at the cursor; false where reading has just begun and
// the line at the foot is better left to what was said last.
bool draw_opening(Ui& ui, Opening& opening);

// The files that could not be read, each with its reason.
void tell_left_out(Ui& ui, const Opening& opening);

}  // namespace tact
