// The live map, the matrix.
#pragma once

#include <Eigen/Core>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/rendering/rendering.h"
#include "app/ui/ui.h"
#include "model/map/mds.h"
#include "model/pattern/pattern_parameter.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/perceptual_model/refinement.h"
#include "model/set/pattern_set.h"
#include "model/subset/close_groups.h"
#include "viz/drawing/geometry.h"
#include "viz/space/space_view.h"

namespace tact {

// The predicted space of a set, computed in the background: from the document to the map.
//
// Two runs answer each edit: a preview with coarse envelopes and one start, which always finishes
// and follows a drag, and the full run, whose numbers are those of the command line. Where the
// full run takes long the preview is the first map, and the full run makes it exact in place, in
// parts.
//
// Exact     the full run depends on the set alone, not on what was shown before.

// Above this many patterns, or this long by estimate, a map is made only when asked for.
inline constexpr std::size_t kMostLivePatterns = 1000;
inline constexpr double kLongestUnaskedS = 60.0;

// Rough time of a first exact map on this machine: its comparison of envelopes, which is nearly all
// of it. A pair takes the product of its own two lengths, but for pairs with the longest patterns:
// their envelopes sound to the end (dtw_batches.h).
double expected_map_s(const PatternSet& set);
double expected_map_s(const PatternSet& set, std::size_t without);  // one of its patterns
double expected_map_s(std::vector<double> durations_s);
double expected_map_s(std::size_t patterns, double longest_s);  // all of one length

bool needs_asking(const PatternSet& set);

// Rough time that all cores take to fill this number of cells by dynamic time warping.
double expected_dtw_s(double cells);

// How coarse the envelopes of a preview are: the more cells its pairs have, the coarser.
struct PreviewGrain {
    std::size_t decimation = 10;  // of 10 kHz
    // Pairs of pairs, of 100, whose order differs from the exact one: the most that was measured
    // with the bundled sets and 38 Pulsar presets; half of that is common.
    int most_flips = 4;
};

// None: there are too many patterns for a preview in seconds.
std::optional<PreviewGrain> preview_grain(const PatternSet& set);

// That of a map; none for an exact one.
std::optional<PreviewGrain> preview_grain(const Prediction& prediction);

struct LiveMap;
class WantedRows;

struct LiveMapRequest {
    std::uint64_t revision = 0;  // of the document
    std::uint64_t document = 0;  // its number
    std::shared_ptr<const PatternSet> set;
    int dimensions = 3;
    bool preview = false;
    std::optional<RenderedBy> rendered_by{};  // the patterns as a device plays them
    // How the full run goes about it; the answer does not depend on these.
    std::shared_ptr<const LiveMap> coarse{};     // the preview of this very set, or null
    std::shared_ptr<const WantedRows> wanted{};  // what becomes exact first, or null
    std::filesystem::path checkpoint{};          // keeps what is finished; empty: nothing does
};

// Whether both have one answer: names, notes and locks make no difference to the model.
bool is_same_work(const LiveMapRequest& a, const LiveMapRequest& b);

// The rows of each matrix with alike ones beside each other (group_tree.h).
struct RowOrders {
    std::vector<std::size_t> pm;
    std::vector<std::size_t> nc;
    std::vector<std::size_t> oc;
};

// One answer: a snapshot that panels draw as long as they like.
struct LiveMap {
    LiveMapRequest request;
    Prediction prediction;
    PerceptualSpace space;
    double seconds = 0.0;                      // it took; 0: not to be told
    std::shared_ptr<const PatternSet> played;  // what was compared: the set, or what a device plays
    // Share of the pairs whose PM comes of exact values, 0..1. At 1 a preview has PM itself, and
    // its points are on their way.
    double exact_share = 0.0;
    bool is_kept = false;  // what is finished of it is in a file
    // Facts of all pairs: of half a million, no frame could wait for them.
    std::vector<double> sorted_pm;  // ascending
    std::size_t closest = 0;        // the pair of the least PM, in condensed order
    // By PM, to each row; as pages have it, what nobody feels is close to nothing.
    std::vector<NearestNeighbour> nearest;
    // As they are told everywhere: without rounding noise (as_ranked()). PM has none.
    Dissimilarity nc;
    Dissimilarity oc;
    RowOrders alike;
    double length_of_pm = 0.0;  // of one PM in the space (map_scale.h)
};

// Fills in the facts of a map that has its matrices and its points.
void note_facts(LiveMap& map);

// Largest PM of all pairs; 0 without pairs.
double largest_pm(const LiveMap& map);

// PM of every pair, as a matrix file has it.
std::string matrix_csv(const LiveMap& map);

// The maps that are kept for undo, and the pairs of all of them: 64 bytes each. An edit of one
// pattern keeps its code, too: 180 kB for each second of it.
inline constexpr std::size_t kKeptMaps = 50;
inline constexpr std::size_t kKeptPairs = 500'000;

// The work of one job. It keeps its answers: an edit of one pattern costs one row of the last, a
// preview starts from where the points were, and a set as it was before, by undo, costs nothing.
class LiveMapWork {
  public:
    explicit LiveMapWork(int threads = 0) : threads_(threads) {}

    // Nothing when stopped. `progress` runs 0..1.
    std::optional<LiveMap> operator()(const LiveMapRequest& request, std::stop_token stop,
                                      std::atomic<float>& progress);

    // The same; `partly` gets previews (request.preview) of a full run that is under way.
    using Partly = std::function<void(LiveMap)>;
    std::optional<LiveMap> in_parts(const LiveMapRequest& request, std::stop_token stop,
                                    std::atomic<float>& progress, const Partly& partly);

  private:
    struct Run;          // one request
    struct Unfinished {  // where turns are taken (app/jobs/jobs.h): the exact run of a request
        LiveMapRequest request;
        Refinement refinement;
        double cells;  // of all of it
        std::shared_ptr<const LiveMap> shown;
        double seconds;  // it took by now
    };

    std::optional<LiveMap> kept(const LiveMapRequest& request);
    void keep(const LiveMap& map);
    std::shared_ptr<const PatternSet> played(const LiveMapRequest& request, std::stop_token stop);
    std::vector<std::shared_ptr<const PatternCode>> codes_of(const Run& run);
    std::optional<LiveMap> previewed(const Run& run);
    std::optional<LiveMap> full(Run& run);
    std::optional<Unfinished> begun(Run& run);
    std::optional<Prediction> exact(Run& run);
    LiveMap part(Run& run, LiveMap map);

    int threads_;                                      // 0: all cores
    std::vector<std::shared_ptr<const LiveMap>> all_;  // exact ones; used last, last
    std::shared_ptr<const LiveMap> last_;
    std::optional<RenderedSet> rendered_;  // the last one
    std::optional<Unfinished> unfinished_;
};

// The map on screen, and what is shown of it.

// The map on screen eases from where its points were to where they are. What it is aligned to is
// the last exact map: chained alignments of previews would slowly turn it. While thresholds are
// shifted, that is the last map with thresholds as they come.
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

// Keeping the map on screen in step with the document.

// The map of a very large set waits until asked for.
void request_maps(const Ui& ui, const Workspace& work, ShownMap& shown_map,
                  const RenderingState& rendered);
// Asks again if the document has changed since: once a frame, whoever changed it.
void follow_map(const Ui& ui, const Workspace& work, ShownMap& shown_map,
                const RenderingState& rendered);

// Takes what the jobs have finished, aligns it to what is shown and starts the transition.
void take_maps(const Ui& ui, ShownMap& shown_map);

// Keeps with the document where the points of its exact map are, to be saved with it and to lie
// there again after undo.
void note_map_places(Workspace& work, ShownMap& shown_map);

// The ring of the open document, once for each state of it; and which way from its middle a pattern
// lies there, up being positive.
void follow_ring(const Workspace& work, ShownMap& shown_map);
struct RingDirection {
    double right, up;
};
RingDirection ring_direction(const WaitingRing& ring, std::size_t place, std::size_t count);

// Since when the patterns have stood in a ring and waited for their first map, in Ui::ages.
inline constexpr const char* kWaitingRing = "the ring before the first map";

// Puts a map on the screen, aligned to the one before it; the first comes out of that ring.
void show_map(const Ui& ui, ShownMap& shown_map, std::shared_ptr<const LiveMap> map);

// One point goes to `at`, and all others stay where they are, until the next edit.
void hold_places(const Workspace& work, ShownMap& shown_map, Eigen::Index row,
                 const Eigen::RowVectorXd& at);
bool holds_places(const Workspace& work, const ShownMap& shown_map);

// Tells the selection which patterns no receptor answers to, as the shown map has found; of those
// edited since it is not known.
void follow_unfelt(Workspace& work, ShownMap& shown_map);

// What is on screen: is it the document's own, exact map?
enum class MapState {
    none,       // nothing was computed yet, or there is nothing to compute
    too_large,  // the set waits for a word of the person, and is too large for a preview
    exact,
    preview,  // of the present document, from coarse envelopes
    stale     // of an earlier document
};
MapState map_state(const Workspace& work, const ShownMap& shown_map);

// The exact map of so large a set has to be asked for, and was not yet. compute_exact() asks.
bool exact_waits(const Workspace& work, const ShownMap& shown_map);
void compute_exact(const Workspace& work, ShownMap& shown_map);

// Positions of the shown map's patterns in this frame, eased; one row each.
Eigen::MatrixXd eased_points(const Ui& ui, const ShownMap& shown_map);
double ghost_opacity(const Ui& ui, const ShownMap& shown_map);

// Something still moves: frames must follow.
bool is_moving(const Ui& ui, const ShownMap& shown_map);

// What the map shows of the patterns' parameters, and of what other rooms mark in it.

// Places of patterns that there are not (app/ask); no rows: none.
struct MapMaybes {
    Eigen::MatrixXd proposals{};
    std::vector<std::string> proposal_names{};
    std::optional<std::size_t> lit{};
    Eigen::MatrixXd track{};
    std::vector<std::string> track_words{};
    Eigen::MatrixXd cloud{};
    std::optional<Eigen::RowVectorXd> wanted{};
    std::optional<Eigen::RowVectorXd> reached{};
};

// What other rooms lay over the map; rows of the shown map.
struct MapMarks {
    std::vector<std::size_t> chosen{};        // a subset: others step back
    std::vector<SpaceLink> links{};           // pairs that are too close
    std::vector<PatternLook> looks{};         // instead of the patterns' own; empty: none
    std::vector<Eigen::Matrix3Xd> spread{};   // where each place might be as well
    std::optional<Eigen::MatrixXd> people{};  // the map of the ratings, laid over this one
    std::string people_text{};                // whose it is
    std::optional<std::size_t> hidden{};      // is not to be seen yet
    bool takes_place = false;                 // the left button says where something is to be
    MapMaybes maybes{};
};

// What a scene borrows while it is drawn.
struct MapDecor {
    std::vector<std::vector<std::size_t>> paths;
    std::vector<std::size_t> faint;
    MapMarks marks;
};

// Looks get new colours if the person asked for that.
MapDecor map_decor(const Ui& ui, ShownMap& shown_map, const MapMarks& marks,
                   std::vector<PatternLook>& looks);
void decorate(const MapDecor& decor, SpaceScene& scene);

// The link that opens the choices, for the row of the map's controls.
void draw_map_look(Ui& ui, ShownMap& shown_map);

// What the colours mean, in the upper right corner of the map.
void draw_map_legend(Ui& ui, ShownMap& shown_map, const Rect& area);

// The rows of the map on screen as places in the document, which may have been edited since.

// Place of every row of the map; empty: the pattern is gone, or has another name.
using RowPlaces = std::vector<std::optional<std::size_t>>;

// There must be a map.
RowPlaces places_in_document(const Workspace& work, const ShownMap& shown_map);

// The map on screen is of another document, or not one of its patterns is left in this one: it says
// nothing of that. Without a map: false.
bool shows_another_set(const Workspace& work, const ShownMap& shown_map);

// The rows of what is selected beside the current pattern, in ascending order.
std::vector<std::size_t> rows_selected_too(const Workspace& work, const RowPlaces& places);

// The dissimilarity of every pair.

void draw_matrix_panel(Ui& ui, Workspace& work, ShownMap& shown_map);

// The two patterns that are held against each other.

// The current pattern and the one it is held against.
enum class PartnerKind { chosen, pinned, closest };
struct ChosenPair {
    std::size_t current = 0;
    std::size_t partner = 0;
    PartnerKind kind = PartnerKind::chosen;
};

// The pair chosen by a click, then the pinned one, then the closest by PM. Empty with fewer than
// two patterns.
std::optional<ChosenPair> chosen_pair(const Workspace& work, const ShownMap& shown_map);

// The current pattern and the closest one by PM, whatever was chosen.
std::optional<ChosenPair> closest_pair(const Workspace& work, const ShownMap& shown_map);

// Their rows in the map on screen, which there must be; none where it leaves one of them out.
std::optional<std::pair<std::size_t, std::size_t>> rows_in_map(const Workspace& work,
                                                               const ShownMap& shown_map,
                                                               const ChosenPair& pair);

// Who is most like a pattern: the closest in the map by PM.

inline constexpr std::size_t kSimilarOnes = 5;

// Selects the pattern at a place of the document and the closest to it, and says how far they are.
void select_similar(Ui& ui, Workspace& work, const ShownMap& shown_map, std::size_t place);

// The map itself: what of the document it shows, and what the person does in it.

// What the person did in the map, for the frame to act on: rows of the document.
struct SpacePaneAction {
    std::optional<std::size_t> hovered{};
    std::optional<std::size_t> double_clicked{};
    // Alt+drag of a point: its place in the document, where to in the map, and whether it is let
    // go.
    std::optional<std::size_t> moved{};
    Eigen::RowVectorXd moved_to{};
    bool move_ended = false;
    std::optional<Eigen::RowVectorXd> placed_at{};  // where marks take a place
    std::optional<std::size_t> menu_asked{};        // of this point
    std::optional<std::size_t> proposal_pressed{};  // of the marks' proposals
    std::optional<std::size_t> proposal_clicked{};
    std::optional<std::pair<std::size_t, std::size_t>>
        drawn_between{};  // Ctrl+drag, first to second
};

// `places` are those of the rows of the map on screen, which there must be. A click selects, with
// Ctrl too; the rest is for the frame.
SpacePaneAction draw_space_scene(Ui& ui, Workspace& work, ShownMap& shown_map,
                                 const MapMarks& marks, const RowPlaces& places, const Rect& area);

// The pane of the map: its controls, its headline, and what it says while there is no map.

SpacePaneAction draw_space_panel(Ui& ui, Workspace& work, ShownMap& shown_map,
                                 const MapMarks& marks);

// Why a map says little; empty: it says what it shows.
std::string verdict_text(const PerceptualSpace& space, std::size_t patterns);

}  // namespace tact
