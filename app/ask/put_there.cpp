#include "app/ask/ask.h"

#include <algorithm>
#include <utility>

#include "app/ask/parts.h"
#include "app/document/editing.h"
#include "app/map/map.h"
#include "model/text/numbers.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr std::size_t kCloud = 60;
constexpr std::uint64_t kPutSeed = 1;

const Pattern* pattern_to_put(const Workspace& work, const std::string& name) {
    const auto place = place_named(work.document.set, name);
    return place ? editable_pattern(work.document.set.vibrations[*place]) : nullptr;
}

// The surroundings are computed again for another pattern, or when other numbers may change.
const std::vector<Pattern>& kept_surroundings(KeptSurroundings& kept, const Pattern& pattern,
                                              const ProposalsState& state, const FeltSteps& steps) {
    std::vector<PatternParameter> free = free_of(state);
    const bool is_same = kept.of == pattern && kept.free == free && kept.steps == steps;
    if (!is_same) {
        kept.patterns = surroundings(pattern, free, steps, kCloud, kPutSeed);
        kept.of = pattern;
        kept.free = std::move(free);
        kept.steps = steps;
    }
    return kept.patterns;
}

}  // namespace

std::string sentence_on(const Reached& reached) {
    const std::string off =
        significant(reached.off_pm, 2) + " of " + significant(reached.largest_pm, 3);
    if (is_reached(reached)) return "About PM " + off + " from there.";
    return "About PM " + off +
           " from there: no change of these numbers reaches it; the rhythm would have to change.";
}

void move_point(Ui& ui, const Workspace& work, const ShownMap& shown_map, ProposalsState& state,
                const PointMove& move) {
    PutThere& put = state.put;
    if (move.place >= work.document.set.vibrations.size() || put.job.asked()) return;
    const Vibration& vibration = work.document.set.vibrations[move.place];
    const Pattern* pattern = editable_pattern(vibration);
    if (pattern == nullptr) {
        return say(
            ui, "Only a pattern without layers that is no recording and not locked can be moved.");
    }
    put.aim.reset();
    put.name = vibration.name;
    put.wanted = move.to;
    put.is_dragged = !move.ended;
    if (!move.ended) return;
    auto where = request_for(work, shown_map, put.name, {});
    if (!where) return stop_putting(state);
    ReachQuestion question{*pattern, move.to};
    question.free = free_of(state);
    question.steps = work.document.set.felt_steps;
    question.seed = kPutSeed;
    put.job.ask({exactly(*std::move(where), kReachTries), std::move(question)}, ProposalsWork{},
                ui.wake);
}

void follow_put(Ui& ui, Workspace& work, ShownMap& shown_map, ProposalsState& state) {
    PutThere& put = state.put;
    if (!has_jobs(ui)) return;
    if (put.aim_of != work.revision) put.aim.reset();
    const Pattern* pattern = pattern_to_put(work, put.name);
    if (pattern == nullptr && !put.name.empty()) stop_putting(state);
    const bool is_shown = pattern != nullptr && (put.is_dragged || put.job.asked());
    if (!is_shown && !put.name.empty()) stop_putting(state);
    put.cloud.want(is_shown ? request_for(work, shown_map, put.name,
                                          kept_surroundings(put.around, *pattern, state,
                                                            work.document.set.felt_steps))
                            : std::nullopt,
                   ProposalsWork{}, ui.wake);
    put.is_dragged = false;
    if (!put.job.asked()) return;
    const auto found = put.job.current();
    if (!found) {
        if (!put.job.busy() && !put.job.failure().empty()) stop_putting(state);
        return;
    }
    const auto place = place_named(work.document.set, put.name);
    Vibration& vibration = work.document.edit().vibrations[*place];
    vibration.source = found->reached.pattern;
    vibration.generated = false;
    select_only(work, *place);
    document_changed(work);
    commit_step(ui, work, "Put " + put.name + " there");
    say(ui, sentence_on(found->reached) + " Ctrl+Z takes it back.");
    put.aim = put.wanted;
    put.aim_of = work.revision;
    const ProposalsRequest& where = found->request.where;
    if (where.map == shown_map.transition.shown) {
        hold_places(work, shown_map, static_cast<Eigen::Index>(where.row), found->reached.at);
    }
    stop_putting(state);
}

void stop_putting(ProposalsState& state) {
    PutThere& put = state.put;
    put.name.clear();
    put.wanted.reset();
    put.is_dragged = false;
    put.job.leave();
}

void show_put(MapMaybes& shown, Eigen::Index columns, const ProposalsState& state) {
    const PutThere& put = state.put;
    if (!put.wanted && put.aim && put.aim->size() == columns) shown.wanted = put.aim;
    if (!put.wanted || put.wanted->size() != columns) return;
    shown.wanted = put.wanted;
    const auto cloud = put.cloud.current();
    if (!cloud || cloud->places.cols() != columns || cloud->places.rows() == 0) return;
    shown.cloud = cloud->places;
    Eigen::Index nearest = 0;
    (cloud->places.rowwise() - *put.wanted).rowwise().norm().minCoeff(&nearest);
    shown.reached = cloud->places.row(nearest);
}

}  // namespace tact
