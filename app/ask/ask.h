// Asking the map: steps between two patterns.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/map/map.h"
#include "app/rendering/rendering.h"
#include "app/ui/ui.h"
#include "model/ask/gap.h"
#include "model/ask/reach.h"
#include "model/ask/steps.h"
#include "model/ask/vary.h"
#include "model/morph/morph.h"

namespace tact {

// Filling the gap between the picked patterns: the question and its answer.

struct GapRequest {
    std::uint64_t revision = 0;  // document's revision
    std::shared_ptr<const PatternSet> set;
    std::vector<std::size_t> picked;       // places in the set
    std::vector<PatternParameter> free{};  // numbers that may change if there is no design space
    std::size_t missing = 1;
    std::uint64_t seed = 1;
    std::optional<RenderedBy> rendered_by{};

    bool operator==(const GapRequest&) const = default;
};

struct FoundGap {
    GapRequest request;
    std::vector<Pattern> chosen;
    GapAnswer answer;
    std::size_t candidates = 0;
    bool all_there_are = false;  // the design space is finite, and all of it was compared
    bool coarse = false;         // computed from coarse envelopes
};

// The search is under way while asked() has a request.
using GapQuery = Query<GapRequest, FoundGap>;

// Proposed patterns shown in the map: the track of a number, a suggestion, neighbours.

// A question: the places of these patterns in the map, each in the place of the pattern of `row`.
struct ProposalsRequest {
    std::shared_ptr<const LiveMap> map;
    Eigen::MatrixXd points;  // the map as shown
    std::size_t row = 0;
    std::vector<Pattern> patterns{};
    std::optional<VaryQuestion> vary{};  // makes the patterns first
    bool exact = false;                  // false: from coarse envelopes, a quick preview

    bool operator==(const ProposalsRequest& other) const {
        return map == other.map && row == other.row && patterns == other.patterns &&
               vary == other.vary && exact == other.exact && points.rows() == other.points.rows() &&
               points.cols() == other.points.cols() && points == other.points;
    }
};

struct FoundProposals {
    ProposalsRequest request;
    std::vector<Pattern> patterns;
    Eigen::MatrixXd places;  // one row per pattern
};

using ProposalsQuery = Query<ProposalsRequest, FoundProposals>;

// A point was moved: asks for the pattern that belongs to its new place.
struct ReachRequest {
    ProposalsRequest where;  // the map and the row; its patterns are ignored
    ReachQuestion question;

    bool operator==(const ReachRequest& other) const {
        return where == other.where && question.pattern == other.question.pattern &&
               question.target.size() == other.question.target.size() &&
               question.target == other.question.target && question.seed == other.question.seed &&
               question.free == other.question.free && question.steps == other.question.steps;
    }
};

struct FoundReach {
    ReachRequest request;
    Reached reached;
};

// Patterns around one, kept until that pattern or the numbers that may change are others.
struct KeptSurroundings {
    std::optional<Pattern> of;
    std::vector<PatternParameter> free;
    FeltSteps steps;
    std::vector<Pattern> patterns;
};

struct PutThere {
    std::string name;                          // the moved pattern; empty: no pattern is moved
    std::optional<Eigen::RowVectorXd> wanted;  // a place in the map
    bool is_dragged = false;                   // in this frame
    std::optional<Eigen::RowVectorXd> aim;     // target of the last move, until the next edit ...
    std::uint64_t aim_of = 0;                  // ... after this revision
    KeptSurroundings around;
    ProposalsQuery cloud;                 // the places that can be reached
    Query<ReachRequest, FoundReach> job;  // the search after the mouse button was released
};

struct ProposalsState {
    ProposalsQuery track;        // a preview, soon followed by ...
    ProposalsQuery exact_track;  // ... the exact track
    ProposalsQuery suggestion;
    ProposalsQuery variants;                   // a preview, soon followed by ...
    ProposalsQuery exact_variants;             // ... the exact places
    std::optional<RestedNumber> rested;        // the number whose track is shown
    double rested_until_s = 0.0;               // the track disappears then, unless the mouse is on
                                               // it
    std::optional<SuggestedChange> suggested;  // in the last frame
    std::string varied;                        // name of the varied pattern; empty: no pattern is
                                               // varied
    double how_far = 3.0;                      // felt steps
    std::uint64_t vary_seed = 1;
    std::vector<PatternParameter> held;  // numbers that varying and moving keep
    PutThere put;
    GapQuery gap;
};

// Filling the gap in a pick, and growing a pick to a number of patterns. Each search runs in the
// background, and its answer is one step of undo.

// Searches the pattern that is farthest from all picked ones; without a pick, from all of the set.
void fill_the_gap(Ui& ui, const Workspace& work, const ShownMap& shown_map, ProposalsState& state);

// Searches the patterns that are missing to `count`.
void grow_to(Ui& ui, const Workspace& work, const ShownMap& shown_map, ProposalsState& state,
             std::size_t count);

// Once a frame: puts found patterns into the set, and reports their distance and whether it is
// proven.
void follow_gap(Ui& ui, Workspace& work, ProposalsState& state);
void stop_filling(ProposalsState& state);
bool is_filling(const ProposalsState& state);

// "PM 31.0 of 66.0 or more from all others: the farthest of 36 of the design space, proven."
std::string sentence_on(const FoundGap& found);

// The pad of up to four patterns: its corners and the place of the mix.

struct PadState {
    std::vector<std::string> corners;  // names
    double right = 0.5;
    double down = 0.5;

    // The mix, kept until its corners or weights change.
    std::vector<Pattern> mixed_of;
    double mixed_right = -1.0;
    double mixed_down = -1.0;
    Pattern mix;
};

// The pad: a square with patterns in its corners. A point inside it is their mix, seen and felt.

// The selected parametric patterns, at most four, the one in the editor first.
std::vector<std::string> pad_corners(const Workspace& work);

// Opens the pad on these names; there must be at least two.
void open_pad(Ui& ui, const Workspace& work, PadState& pad);

// Enter adds the mix behind the first corner as one step of undo. Esc leaves the set unchanged.
inline constexpr Dialog kPadDialog{.title = "Mix on a pad", .is_of_document = true};
void draw_pad_dialog(Ui& ui, Workspace& work, PadState& pad);

// Recomputes proposed patterns when their question changes: the track of a number, a suggestion,
// variants.

// Call once a frame, after the panes: the rested number and the suggestion are those of this frame.
void follow_proposals(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                      ProposalsState& state);

bool is_asking(const ProposalsState& state);

// The proposals known so far, for the map on screen.
MapMaybes shown_proposals(const ShownMap& shown_map, const ProposalsState& state);

// Whether neighbours can be asked for: the pattern can be edited and is in a map, which needs three
// patterns.
bool can_vary(const Workspace& work);

// Asks for neighbours of the pattern in the editor; called again, for other ones.
void vary(Ui& ui, const Workspace& work, ProposalsState& state);
void stop_varying(ProposalsState& state);
std::shared_ptr<const FoundProposals> found_variants(const ProposalsState& state);

// Gives the pattern the numbers of its k-th neighbour: one step of undo.
void take_variant(Ui& ui, Workspace& work, ProposalsState& state, std::size_t k);

// Moving a point of the map: the search for the pattern that belongs to its new place, or comes
// nearest to it.

// Records that the mouse drags the point of a pattern in this frame, and whether it was released.
struct PointMove {
    std::size_t place = 0;  // the dragged pattern, in the document
    Eigen::RowVectorXd to;
    bool ended = false;
};
void move_point(Ui& ui, const Workspace& work, const ShownMap& shown_map, ProposalsState& state,
                const PointMove& move);

// Once a frame: puts the found pattern into the set as one step of undo, and reports its distance
// from the target. The target and the other points stay on screen until the next edit.
void follow_put(Ui& ui, Workspace& work, ShownMap& shown_map, ProposalsState& state);
void stop_putting(ProposalsState& state);

// The part of it that the map shows.
void show_put(MapMaybes& shown, Eigen::Index columns, const ProposalsState& state);

// "0.8 of 66 from there."
std::string sentence_on(const Reached& reached);

// State of the dialog "Steps between", and the answer of its job.

struct StepsRequest {
    StepsQuestion question;

    bool operator==(const StepsRequest&) const = default;
};

struct FoundSteps {
    StepsRequest request;
    EvenSteps steps;
};

struct StepsState {
    std::string from;  // names
    std::string to;
    int count = 5;  // including both ends
    StepMeasure measure = StepMeasure::pm;
    std::optional<PatternParameter> along;  // nullopt: all numbers in which the two differ

    Query<StepsRequest, FoundSteps> job;
    bool cancelled = false;  // cancelled by the person, until another question
};

// The dialog for even steps between two patterns.

// Enter adds the steps, Esc leaves the set unchanged. A row is played while it is held.
inline constexpr Dialog kStepsDialog{.title = "Steps between", .is_of_document = true};
void draw_steps_dialog(Ui& ui, Workspace& work, StepsState& state);

// Even steps between two patterns of the set: the question, and adding its answer to the set.

// Opens the dialog on these two names; if empty: the pattern in the editor and its partner, or the
// pattern after it.
void open_steps(Ui& ui, const Workspace& work, StepsState& state, const std::string& from,
                const std::string& to);

// The reason why the question cannot be asked, a sentence; empty if it can.
std::string steps_obstacle(const Workspace& work, const StepsState& state);
std::optional<StepsRequest> steps_request(const Workspace& work, const StepsState& state);

// Asks if the question differs from the last one and the dialog is open; stops the work when the
// dialog closes.
void follow_steps(const Ui& ui, const Workspace& work, StepsState& state);

bool is_placing(const StepsState& state);

// The answer to the current question; null until it is found.
std::shared_ptr<const FoundSteps> current_steps(const Workspace& work, const StepsState& state);

// Adds the patterns between the two behind the first of them: one step of undo.
void add_steps(Ui& ui, Workspace& work, const StepsState& state, const FoundSteps& found);

// The row above the map while a pattern is varied, or searched for a place.

void draw_vary_bar(Ui& ui, const Workspace& work, ProposalsState& state);

}  // namespace tact
