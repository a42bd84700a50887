// The exact map of a large set, in place of its preview: from what a person looks at outwards, and
// over a restart of the program.
//
// Left out  what is computed of it (model/perceptual_model/refinement.h)
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "model/perceptual_model/refinement.h"

namespace tact {

// Rows of the set, the most wanted first: told by the window while the work runs.
class WantedRows {
  public:
    void tell(std::vector<std::size_t> rows);
    std::vector<std::size_t> now() const;

  private:
    mutable std::mutex mutex_;
    std::vector<std::size_t> rows_;
};

// What a person looks at in the shown map: what the mouse is on, what is selected, then what the
// camera sees, then what lies outside of the pane; both by how near the current pattern they lie.
std::vector<std::size_t> rows_looked_at(const Workspace& work, const ShownMap& shown_map);

// The file that keeps what is finished of a set's map: beside the set, or with the autosave of one
// that has no file. Empty: nothing can be kept.
std::filesystem::path map_checkpoint(const Workspace& work);

// Whether it holds something of this very set.
bool has_checkpoint(const Workspace& work);

struct Refining {
    const PatternSet& set;
    const WantedRows* wanted = nullptr;
    std::filesystem::path checkpoint;  // empty: none
    // A part is there; whether it is in the file as well.
    std::function<void(const Refinement&, bool)> partly;
    double parts_from_s = 1.5;  // work that is expected to take less shows its end alone
    double part_s = 0.4;        // expected time of a lot, at least
    double cells = 0.0;         // of all the work, where some of it is done; 0: what is open
    // Asked after each lot: the rest is for another call, where work takes turns
    // (app/jobs/turns.h). May be empty.
    std::function<bool()> is_over{};
};

// All tiles, in lots: each as large as makes parts a pleasure to follow and costs little. Takes up
// the file, and removes it in the end. False when stopped, or over before all are made.
bool refine(Refinement& refinement, const PredictOptions& options, const Refining& how);

// What a preview is worth and what comes next; empty where nothing need be said.
std::string preview_words(const LiveMap& map, bool exact_waits, double exact_s);

}  // namespace tact
