// What the Subset tab asks for, and what its jobs have found.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/jobs/query.h"
#include "app/map/live_map.h"
#include "model/evaluation/metric.h"
#include "model/grouping/set_groups.h"
#include "model/pattern/pattern_parameter.h"
#include "model/study/ratings.h"
#include "model/subset/separation.h"
#include "model/subset/subset.h"
#include "model/subset/subset_stability.h"

namespace tact {

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

}  // namespace tact
