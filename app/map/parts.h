// Parts that the files of this room share.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/ui/ui.h"
#include "model/perceptual_model/refinement.h"

namespace tact {

// The exact map of a large set, in place of its preview: from what a person looks at outwards, and
// over a restart of the program.
//
// Left out  what is computed of it (model/perceptual_model/refinement.h)

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
    // (app/jobs/jobs.h). May be empty.
    std::function<bool()> is_over{};
};

// All tiles, in lots: each as large as makes parts a pleasure to follow and costs little. Takes up
// the file, and removes it in the end. False when stopped, or over before all are made.
bool refine(Refinement& refinement, const PredictOptions& options, const Refining& how);

// What a preview is worth and what comes next; empty where nothing need be said.
std::string preview_words(const LiveMap& map, bool exact_waits, double exact_s);

// How a map lies: distances say nothing of where up is, so a new map is turned onto an earlier one.

// Rows of the vibrations that two maps have in common, by name.
struct Common {
    std::vector<Eigen::Index> here;
    std::vector<Eigen::Index> there;
};

Common common_rows(const LiveMap& map, const LiveMap& earlier);

// As it was saved with the set: rows of this map, and where those were.
struct SavedPlaces {
    std::vector<Eigen::Index> rows;
    Eigen::MatrixXd points;
};

SavedPlaces saved_places(const LiveMap& map, const MapPlaces& kept);

// Rows of `points` onto the rows of `target`, and all others with them.
Eigen::MatrixXd turned_onto(const Eigen::MatrixXd& points, const std::vector<Eigen::Index>& rows,
                            const Eigen::MatrixXd& target);

// Fewer points in common tell no turn.
bool tells_turn(std::size_t common, Eigen::Index dimensions);

// Aligned to how the same set lay before, or to the last exact map; before this document has one,
// to its saved map, or to the preview on screen.
Eigen::MatrixXd aligned_to_anchor(const MapTransition& map, const LiveMap& fresh);

// The anchor's points, row by row of `map`; NaN for patterns that it has not.
Eigen::MatrixXd ghosts_of(const LiveMap& map, const MapTransition& anchored);

// Where the points were before thresholds were shifted or a receptor type was removed: ghosts,
// until the thresholds are the program's again.
//
// Output    an anchor of the map on screen whose thresholds are the program's; if none was ever
//           shown, such as for a set that was opened so or edited since, it is made in the
//           background
// Left out  sets whose maps wait for a word

inline constexpr const char* kUnshiftedText = "Rings: with the thresholds as they come";

// Whether `fresh` leaves the anchor as it is: previews do, and maps of shifted thresholds where it
// has none.
bool keeps_anchor(const MapTransition& before, const LiveMap& fresh);

// The anchor is the map on screen but for its thresholds, which are shifted.
bool shows_unshifted(const MapTransition& map);

// Once a frame: asks for the map without shifts, and takes it.
void follow_unshifted(const Ui& ui, ShownMap& shown_map);

}  // namespace tact
