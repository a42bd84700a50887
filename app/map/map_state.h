// The map on screen, and what is shown of it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "app/map/live_map.h"
#include "model/pattern/pattern_parameter.h"
#include "viz/space/space_view.h"

namespace tact {

// The map on screen eases from where its points were to where they are. What it is aligned to is
// the last exact map: chained alignments of previews would slowly turn it. While thresholds are
// shifted, that is the last map with thresholds as they come (unshifted_map.h).
struct MapTransition {
    std::shared_ptr<const LiveMap> shown;
    std::shared_ptr<const LiveMap> anchor;  // the last exact one ...
    Eigen::MatrixXd anchor_points;          // ... as it was shown
    Eigen::MatrixXd from;                   // aligned positions, one row a pattern of `shown`
    Eigen::MatrixXd to;
    Eigen::MatrixXd ghost;  // of the anchor, row by row; NaN for new patterns
    double since_s = -10.0;
};

// Where the points of one revision stay, whatever its own map is: one was put somewhere else, and
// how near it came can be seen as long as the others stand still.
struct HeldPlaces {
    std::uint64_t revision = 0;
    Eigen::MatrixXd points;
};

enum class MatrixQuantity { pm, nc, oc };

// How far the exact map is, and since when: what the time left is told from.
struct MapProgress {
    float share = 0.0F;
    double since_s = 0.0;
};

// By what the map is coloured, joined and filtered.
struct MapLook {
    std::optional<PatternParameter> colour;
    bool is_chosen = false;  // by the person; otherwise many patterns choose their own colour
    std::optional<PatternParameter> path;
    int clusters = 0;  // 0: none
    std::optional<PatternParameter> filter;
    Range passes{0.0, 0.0};  // of the filter
    bool show_pairs = true;
    bool show_spread = true;
};

// The number that explains most of the shown map, kept while it stays.
struct ShownExplained {
    std::shared_ptr<const LiveMap> of;
    std::optional<PatternParameter> by;
    double share = 0.0;
};

// Groups of the shown map, kept while it stays.
struct ShownClusters {
    std::shared_ptr<const LiveMap> of;
    int count = 0;
    std::vector<std::size_t> group;
};

// Patterns that differ in one number alone, in its order, as long as the map stays.
struct ShownPaths {
    std::shared_ptr<const LiveMap> of;
    std::optional<PatternParameter> along;
    std::vector<std::vector<std::size_t>> paths;
};

// The largest value of the matrix on screen, kept while that stays: it is looked for among all
// pairs.
struct ShownLargest {
    std::shared_ptr<const LiveMap> of;
    MatrixQuantity quantity = MatrixQuantity::pm;
    double value = 0.0;
};

// How many pairs of the shown map may be confused, by felt steps, kept while it stays.
struct ShownVerdicts {
    std::shared_ptr<const LiveMap> of;
    std::size_t same = 0;
    std::size_t close = 0;
    bool is_known = false;  // not of very many
};

// What one person told apart on one device of the shown pairs, kept while both stay.
struct ShownTold {
    std::shared_ptr<const LiveMap> of;
    std::uint64_t revision = 0;
    std::string words;  // empty: nothing was measured, or it does not count any more
    std::string help;
};

// What a length of the map is in PM, kept while that stays.
struct ShownScale {
    std::shared_ptr<const LiveMap> of;
    double length_of_one = 0.0;
};

// The order of the matrix's rows, kept while what it is of stays.
struct ShownOrder {
    std::shared_ptr<const LiveMap> of;
    MatrixQuantity quantity = MatrixQuantity::pm;
    bool is_clustered = true;
    std::vector<std::size_t> order;   // rows of the map, as the matrix has them
    std::vector<std::string> labels;  // in that order
    bool is_held = false;             // as it was before something began to be dragged
};

// Which map and which document those that are not felt were found in.
struct ShownUnfelt {
    std::shared_ptr<const LiveMap> of;
    std::uint64_t revision = 0;
};

// The patterns in a ring until the first map is there, each beside what is most like it.
struct WaitingRing {
    std::uint64_t document = 0;
    std::uint64_t revision = 0;
    std::vector<std::size_t> position;  // in the ring, of each pattern of the set
};

struct ShownMap {
    Query<LiveMapRequest, LiveMap> preview_job;
    Query<LiveMapRequest, LiveMap> full_job;
    Query<LiveMapRequest, LiveMap> unshifted_job;
    // The full run of a set that takes long waits here for its preview.
    std::optional<LiveMapRequest> exact_in_turn;
    std::shared_ptr<WantedRows> wanted;                 // of the full run under way
    std::shared_ptr<const LiveMap> unshifted_asked_of;  // the map shown then
    bool show_people = false;                           // their map over the predicted one
    std::optional<MapProgress> progress;                // while it is being computed
    bool cancelled = false;                             // by the person, until the next edit
    std::uint64_t compute_large_of = 0;  // the document whose very large map was asked for
    std::uint64_t maps_asked = 0;        // revision that maps were asked for last
    MapTransition transition;
    std::optional<HeldPlaces> held;
    MapLook look;
    ShownExplained explained;
    ShownClusters clusters;
    ShownPaths paths;
    ShownLargest largest;
    ShownScale scale;
    ShownVerdicts verdicts;
    ShownTold told;
    bool clustered_matrix = true;  // rows as a tree of clusters has them, not as the list
    ShownOrder order;
    std::shared_ptr<const LiveMap> places_noted_of;  // whose places the document has
    std::uint64_t of_document = 0;                   // number of the one that the map is of
    ShownUnfelt unfelt;
    WaitingRing ring;
    std::size_t menu_of = 0;  // the pattern whose menu is open in the map
    SpaceCamera camera;
    Rect pane;                  // that it was drawn in last; empty: not drawn yet
    bool has_headline = false;  // stress stands there, in the frame before: not in the title, too
    bool move_tool = false;     // a drag of a point puts it there, as with Alt
    bool frame_asked = false;   // what is selected is to fill the pane
    int dimensions = 3;
    MatrixQuantity quantity = MatrixQuantity::pm;
};

}  // namespace tact
