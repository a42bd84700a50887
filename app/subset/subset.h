// Picking, too close, how sure.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/map/map.h"
#include "app/patterns/patterns.h"
#include "app/play/play.h"
#include "app/report/report.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/evaluation/metric.h"
#include "model/grouping/set_groups.h"
#include "model/pattern/pattern_parameter.h"
#include "model/study/ratings.h"
#include "model/subset/separation.h"
#include "model/subset/subset.h"
#include "model/subset/subset_stability.h"

namespace tact {

// What the Subset tab asks for, and what its jobs have found.

// What to pick, and by what.
struct PickRequest {
    std::shared_ptr<const LiveMap> map;  // of the patterns; PM is its own
    SubsetProblem problem;
    bool by_ratings = false;  // else by the metric
    Metric metric = Metric::pm;
    std::size_t unfelt = 0;    // that are there and not locked ...
    bool with_unfelt = false;  // ... and may be picked; otherwise left out

    bool operator==(const PickRequest&) const = default;
};

// The question, and how far apart the patterns are by what it asks for, if a pick has found that.
struct PickTask {
    PickRequest question;
    std::shared_ptr<const Dissimilarity> apart{};
    NumberMark mark{};  // as in Pick
};

struct Pick {
    PickRequest request;
    std::shared_ptr<const Dissimilarity> dissimilarity;
    std::string fault;  // why it is missing
    SubsetAnswer answer;
    NumberMark mark{};       // of the ratings, where it is by them
    bool is_so_far = false;  // found before the search ended; nothing is proven of it
};

struct PickCurve {
    PickRequest request;
    std::vector<CurvePoint> points;
    NumberMark mark{};
};

struct SeparationRequest {
    std::shared_ptr<const LiveMap> map;
    std::size_t changed = 0;
    double threshold = 0.0;
    std::vector<std::size_t> from{};  // rows that count; empty: all
    std::optional<double> share{};    // of the closest pairs, again with each change
    bool by_a_step = false;           // and no other within a felt step

    bool operator==(const SeparationRequest&) const = default;
};

struct FoundSeparations {
    SeparationRequest request;
    std::vector<Separation> all;
};

struct StabilityRequest {
    std::shared_ptr<const Pick> pick;
    std::size_t draws = 100;

    bool operator==(const StabilityRequest&) const = default;
};

struct FoundStability {
    StabilityRequest request;
    Stability stability;
};

// The groups of a map's patterns, by PM.
struct GroupsRequest {
    std::shared_ptr<const LiveMap> map;

    bool operator==(const GroupsRequest&) const = default;
};

struct FoundGroups {
    GroupsRequest request;
    SetGroups groups;
};

// The tree cut, kept while neither changes.
struct CutGroups {
    std::shared_ptr<const FoundGroups> of;
    std::size_t count = 0;
    std::vector<PatternGroup> groups;
    std::vector<std::size_t> colours;   // of each, as of patterns; kApart: of one pattern, none
    std::vector<std::size_t> group_of;  // by row of the map; kApart: in none
};
inline constexpr std::size_t kApart = static_cast<std::size_t>(-1);

enum class SubsetView { pick, confusable, stability, groups };

// What is too close for comfort.
enum class TooClose {
    felt,       // no number differs by a felt step: most sets have no such pair
    share,      // a share of the set's pairs, the closest
    picked,     // the same share of the pairs within the picked subset
    reference,  // all that are no farther apart than a pair the person knows
    ratings     // the same share of the pairs as people rated them
};

// The pairs that are too close, kept while nothing they depend on changes.
struct TooClosePairs {
    std::shared_ptr<const LiveMap> of;
    TooClose by = TooClose::felt;
    double share = 0.0;
    std::string reference;
    std::vector<std::size_t> picked;    // rows; empty unless by them
    double threshold = 0.0;             // in the matrix's own unit
    std::size_t count = 0;              // of all such pairs ...
    std::vector<ConfusablePair> pairs;  // ... of which the closest are kept
    NumberMark mark{};                  // of the ratings, where it is by them
};

// A change that was to part a pair: whether it did is known once the map is exact.
struct AppliedChange {
    std::string changed;  // names
    std::string other;
    std::uint64_t revision = 0;  // of the document with the change
};

inline constexpr int kUsualCount = 8;

struct SubsetState {
    SubsetView view = SubsetView::pick;
    int count = kUsualCount;
    int usual_count = kUsualCount;  // as many as can be, up to that; until another one is chosen
    bool with_unfelt = false;       // those that nobody feels may be picked, too
    SubsetObjective objective = SubsetObjective::max_min;
    bool by_ratings = false;
    Metric metric = Metric::pm;
    bool grow_asked = false;                 // in this frame: as many patterns as are to be picked
    std::optional<std::size_t> alternative;  // looked at in the map instead of the best

    TooClose too_close = TooClose::felt;
    double share = 0.05;
    std::string reference_a;  // names; empty: none chosen yet
    std::string reference_b;
    TooClosePairs pairs;
    std::optional<std::pair<std::string, std::string>> opened;  // names of a pair
    bool change_second = false;                                 // of the open pair
    std::optional<AppliedChange> applied{};                     // not yet checked

    int group_count = 0;                // 0: the usual one, until another one is chosen ...
    std::optional<double> cut;          // ... or where the tree is cut, PM
    std::set<std::string> kept_groups;  // names that stand for groups, and are locked for that

    std::filesystem::path export_to;  // both: when a subset has been picked and the frame is done
    std::filesystem::path report_to;

    // The answers may be of an earlier document.
    Query<PickTask, Pick> pick_job;
    Query<PickTask, PickCurve> curve_job;
    Query<SeparationRequest, FoundSeparations> separation_job;
    Query<StabilityRequest, FoundStability> stability_job;
    Query<GroupsRequest, FoundGroups> groups_job;
    PickRequest asked;
    PickRequest curve_asked;
    bool cancelled = false;  // by the person, until something else is asked for
    std::shared_ptr<const Pick> pick;
    std::shared_ptr<const PickCurve> curve;
    std::shared_ptr<const FoundSeparations> separations;
    std::shared_ptr<const FoundGroups> groups;
    CutGroups cut_groups;
    // The newest first: an answer is there again when undo leads back to what it was asked of.
    std::vector<std::shared_ptr<const FoundStability>> stabilities;
};

// The members of the subset on screen: their rows, and the keys that play them.

inline constexpr std::size_t kPlayKeys = 9;  // 1 to 9

// A row in a list of that width: with a picture of the waveform where there is room for one.
float member_row_px(const Ui& ui, float width_px);

// Draws the pattern of that name, the `number`-th from 1 on. Its menu is that of every pattern.
PatternAction draw_member(Ui& ui, Workspace& work, const std::string& name, std::size_t number);

// Plays once the `number`-th of the subset on screen, from 1 on; says so if it is missing.
void play_picked(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                 PlayState& play, const SubsetState& picking, std::size_t number);

// Pairs that are too close, of the map on screen, and what would separate one of them.

const TooClosePairs& too_close_pairs(const ShownMap& shown_map, SubsetState& picking);

// Opens a pair: it is shown in the other panes, and something may be asked about it.
void open_pair(Workspace& work, SubsetState& picking, const std::string& a, const std::string& b);
// The open one where the map on screen still has it; rows of the map, the first one less.
std::optional<std::pair<std::size_t, std::size_t>> opened_rows(const ShownMap& shown_map,
                                                               const SubsetState& picking);

// Why the pattern of a row cannot be changed: "locked", "measured", "removed"; empty: it can.
std::string fixed_because(const Workspace& work, const ShownMap& shown_map, std::size_t row);

// The one of the open pair to be changed: the one chosen, or the only one that may be.
std::size_t row_to_change(const Workspace& work, const ShownMap& shown_map,
                          const SubsetState& picking, std::pair<std::size_t, std::size_t> rows);

// What would be asked about it, and why that is impossible now; empty: it is possible.
SeparationRequest separation_request(const ShownMap& shown_map, SubsetState& picking,
                                     std::size_t row);
std::string separation_obstacle(const Workspace& work, const ShownMap& shown_map,
                                const SubsetState& picking, std::size_t row);
void ask_for_separation(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                        SubsetState& picking, std::size_t row);

// The same in one go for a pair of the picked subset.
void ask_about_picked(const Ui& ui, Workspace& work, const ShownMap& shown_map,
                      SubsetState& picking, const std::string& a, const std::string& b);

// And for any pair, by what counts as too close now; the first of them is to be changed.
void ask_about_pair(const Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking,
                    const std::string& a, const std::string& b);

// Whether the two are listed as too close.
bool is_listed(const TooClosePairs& pairs, const std::string& a, const std::string& b);

// Says of an applied change, once the map is exact, whether the pair is still listed.
void check_applied(Ui& ui, const Workspace& work, const ShownMap& shown_map, SubsetState& picking);

// Applies a change as one step.
void apply_separation(Ui& ui, Workspace& work, std::size_t place, const Separation& separation);

// The picked subset as files: the set itself, a page about it, and its map; or the page alone.
//
//     subset.tactspace.json   the picked patterns, with what people said of them
//     report.html             what feels the same, what was proven (app/report)
//     map.png, map.svg        the whole set, the picked ones bright
//
// Exact     same subset, same bytes.

// All files, each whole or not at all; makes the folder.
Expected<Done> write_subset(const std::filesystem::path& folder, const Report& report);

// From the window. Both wait until an exact subset of the set as it is has been picked.
void export_subset_dialog(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                          SubsetState& picking);
void export_subset(Ui& ui, SubsetState& picking, const std::filesystem::path& folder);

void export_report_dialog(Ui& ui, const Workspace& work, SubsetState& picking);
void export_report(Ui& ui, SubsetState& picking, const std::filesystem::path& file);

// Writes what is asked for: between two frames, as it draws pictures.
void continue_subset_export(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                            SubsetState& picking);

// Keeping the picked subset, and what is asked about it, in step with the document.

// Takes what the jobs have finished; asks again if the document or the question has changed.
void follow_subset(const Ui& ui, const Workspace& work, const Layout& layout,
                   const ShownMap& shown_map, SubsetState& picking);

// The subset on screen, of the map on screen; null: none. It may answer an earlier question ...
const Pick* shown_pick(const ShownMap& shown_map, const SubsetState& picking);
// ... and then is not that of the present document.
bool is_pick_stale(const Workspace& work, const ShownMap& shown_map, const SubsetState& picking);
// By coarse envelopes: shown at once, and asked for again when the map is exact.
bool is_of_preview(const PickRequest& request);
// Another may take its place without a further question: it is by a preview, or was found by now.
bool is_unsettled(const Pick& pick);
// Names of the members of the subset on screen.
std::set<std::string> picked_names(const ShownMap& shown_map, const SubsetState& picking);
// The best one, or the alternative that is looked at.
const Subset* shown_subset(const ShownMap& shown_map, const SubsetState& picking);
// A search runs, or follow_subset has not yet taken what it found.
bool is_picking(const SubsetState& picking);
bool is_subset_busy(const SubsetState& picking);  // with anything
void cancel_picking(SubsetState& picking);

// Variants of the model, asked of the subset on screen; null: nobody asked yet.
void ask_for_stability(const Ui& ui, SubsetState& picking, std::size_t draws);
const FoundStability* found_stability(const SubsetState& picking);
const Stability* shown_stability(const SubsetState& picking);

// What the Subset tab marks in the map and in the list.

MapMarks subset_marks(const Theme& theme, const Layout& layout, const ShownMap& shown_map,
                      SubsetState& picking);

// Names of the patterns that are in a pair that is too close, while that is what is shown.
std::set<std::string> too_close_names(const Layout& layout, const SubsetState& picking);

// The most distinct patterns, those that are too close, and how sure that is.

// What was asked for in the menu of a member is for the frame.
PatternAction draw_subset_panel(Ui& ui, Workspace& work, Timeline& timeline,
                                const ShownMap& shown_map, PlayState& play, SubsetState& picking);

}  // namespace tact
