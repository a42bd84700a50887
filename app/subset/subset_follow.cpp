#include "app/subset/subset.h"

#include <algorithm>

#include "app/jobs/jobs.h"
#include "app/map/map.h"
#include "app/subset/parts.h"
#include "model/set/set_ratings.h"
#include "model/subset/set_subset.h"
#include "model/system/pauses.h"
#include "model/tasks/set_pairs.h"

namespace tact {

namespace {

constexpr double kPickLimitS = 20.0;
constexpr double kPreviewLimitS = 2.0;  // the exact map soon asks again
constexpr double kCurveLimitS = 20.0;
// The limits of a search that holds the picture up: each turn has twice the time of the one before
// it, until the subset is proven.
constexpr double kFirstTurnS = 0.1;
constexpr double kLongestTurnS = 1.6;
constexpr std::size_t kAlternatives = 6;
constexpr std::size_t kMostOfCurve = 30;

const PatternSet& set_of(const PickRequest& request) { return *request.map->request.set; }

// How far apart the patterns are by what was asked for.
Expected<Dissimilarity> asked_dissimilarity(const PickRequest& request, std::stop_token stop,
                                            NumberMark& mark) {
    if (request.by_ratings) {
        const Expected<RatingStudy> study = study_of(set_of(request));
        if (!study) return study.error();
        mark = mark_of(*study);
        return mean_ratings(*study);
    }
    PairsRequest pairs{request.metric, false, &request.map->prediction};
    pairs.options.stop = std::move(stop);
    auto found = set_pairs(*request.map->played, pairs);
    if (!found) return Error{"stopped"};
    return std::move(found->apart);
}

bool holds_picture_up() { return work_takes_turns() && !is_pausable(); }

// Where it does: the request that took the last turn, what it found out before it searched, and the
// time of the next.
struct PickTurns {
    PickRequest of;
    double limit_s = kFirstTurnS;
    std::shared_ptr<const Dissimilarity> dissimilarity;
    NumberMark mark;
};

double pick_limit_s(const PickRequest& request, const PickTurns& turns) {
    const double limit_s = is_of_preview(request) ? kPreviewLimitS : kPickLimitS;
    return holds_picture_up() ? std::min(limit_s, turns.limit_s) : limit_s;
}

// Whether the search begins again, with more time, after the next frame.
bool takes_longer_turn(const Pick& pick, PickTurns& turns) {
    const bool is_proven =
        pick.answer.proof == SubsetProof::optimal && pick.answer.are_alternatives_proven;
    if (!holds_picture_up() || is_of_preview(pick.request) || is_proven ||
        turns.limit_s >= kLongestTurnS)
        return false;
    turns.limit_s *= 2.0;
    want_another_turn();
    return true;
}

// False: it cannot be found, and the pick says why.
bool find_dissimilarity(Pick& pick, std::stop_token stop, PickTurns& turns) {
    if (holds_picture_up() && turns.of != pick.request) turns = {pick.request, kFirstTurnS, {}, {}};
    if (!pick.dissimilarity && turns.dissimilarity) {
        pick.dissimilarity = turns.dissimilarity;
        pick.mark = turns.mark;
    }
    if (pick.dissimilarity) return true;
    auto matrix = asked_dissimilarity(pick.request, std::move(stop), pick.mark);
    if (!matrix) {
        pick.fault = matrix.error().message;
        return false;
    }
    pick.dissimilarity = std::make_shared<const Dissimilarity>(*std::move(matrix));
    if (holds_picture_up()) {
        turns.dissimilarity = pick.dissimilarity;
        turns.mark = pick.mark;
    }
    return true;
}

using PickPartly = Query<PickTask, Pick>::Partly;

std::optional<Pick> pick_subset(const PickTask& task, std::stop_token stop,
                                std::atomic<float>& progress, const PickPartly& give,
                                PickTurns& turns) {
    const PickRequest& request = task.question;
    Pick pick{request, task.apart, {}, {}, task.mark};
    const bool is_known = find_dissimilarity(pick, stop, turns);
    if (stop.stop_requested()) return std::nullopt;
    if (!is_known) return pick;
    SubsetOptions options;
    options.time_limit_s = pick_limit_s(request, turns);
    options.alternatives = kAlternatives;
    options.stop = stop;
    options.progress = [&progress](double share) { progress = static_cast<float>(share); };
    options.so_far = [&pick, &give](const SubsetAnswer& now) {
        Pick part = pick;
        part.answer = now;
        part.is_so_far = true;
        give(std::move(part));
    };
    auto answer = most_distinct_subset(*pick.dissimilarity, request.problem, options);
    if (stop.stop_requested()) return std::nullopt;
    if (answer) {
        pick.answer = *std::move(answer);
        if (takes_longer_turn(pick, turns)) {
            pick.is_so_far = true;
            give(std::move(pick));
            return std::nullopt;
        }
    } else {
        const std::string left_out =
            request.with_unfelt ? std::string() : left_out_words(request.unfelt);
        pick.fault = answer.error().message + (left_out.empty() ? "." : "; " + left_out + ".");
    }
    return pick;
}

// Work that remembers its turns.
auto picker() {
    return [turns = PickTurns()](const PickTask& task, std::stop_token stop,
                                 std::atomic<float>& progress, const PickPartly& give) mutable {
        return pick_subset(task, std::move(stop), progress, give, turns);
    };
}

std::optional<PickCurve> find_curve(const PickTask& task, std::stop_token stop,
                                    std::atomic<float>& progress) {
    SubsetOptions options;
    options.time_limit_s = holds_picture_up() ? kLongestTurnS : kCurveLimitS;
    options.stop = stop;
    options.progress = [&progress](double share) { progress = static_cast<float>(share); };
    PickCurve curve{task.question,
                    weakest_by_count(*task.apart, task.question.problem, kMostOfCurve, options),
                    task.mark};
    if (stop.stop_requested()) return std::nullopt;
    return curve;
}

std::optional<FoundStability> find_stability(const StabilityRequest& request, std::stop_token stop,
                                             std::atomic<float>& progress) {
    const Pick& pick = *request.pick;
    StabilityParams params;
    params.draws = request.draws;
    params.stop = stop;
    params.progress = [&progress](double share) { progress = static_cast<float>(share); };
    const LiveMap& map = *pick.request.map;
    auto stability = subset_stability(*map.played, pick.request.problem, pick.answer.best,
                                      map.space.points, params);
    if (!stability) return std::nullopt;
    return FoundStability{request, *std::move(stability)};
}

// People felt every pattern that they rated, so a request by ratings leaves none out; any other
// leaves out the patterns that nobody feels.
PickRequest request_of(const Workspace& work, const ShownMap& shown_map, SubsetState& picking) {
    PickRequest request{shown_map.transition.shown, {}, picking.by_ratings, picking.metric};
    if (work.document.set.ratings.empty()) request.by_ratings = false;
    const PatternSet& set = *request.map->request.set;
    std::vector<std::size_t> not_felt;
    if (!request.by_ratings) not_felt = unfelt(request.map->prediction.codes);
    request.unfelt = left_out_unfelt(set, not_felt).size();
    request.with_unfelt = picking.with_unfelt && request.unfelt > 0;
    if (request.with_unfelt) not_felt.clear();
    request.problem = subset_problem(set, 2, picking.objective, not_felt);
    // The usual count shrinks to what is possible; a count that was chosen stays.
    if (picking.count == picking.usual_count) {
        picking.count = picking.usual_count =
            static_cast<int>(possible_count(request.problem, set.vibrations.size(), kUsualCount));
    }
    request.problem.count = static_cast<std::size_t>(std::max(picking.count, 0));
    return request;
}

// The curve is the same for every count and objective.
PickRequest curve_request(PickRequest request) {
    request.problem.count = 2;
    request.problem.objective = SubsetObjective::max_min;
    return request;
}

// What the pick on hand was found by holds for another count or objective, too.
PickTask task_of(const SubsetState& picking, PickRequest question) {
    const Pick* pick = picking.pick.get();
    const bool is_known = pick != nullptr && pick->request.map == question.map &&
                          pick->request.by_ratings == question.by_ratings &&
                          pick->request.metric == question.metric;
    if (!is_known) return {std::move(question)};
    return {std::move(question), pick->dissimilarity, pick->mark};
}

void follow_pick(const Ui& ui, PickRequest request, SubsetState& picking) {
    if (request == picking.asked) return;
    picking.asked = request;
    picking.cancelled = false;
    picking.alternative.reset();
    picking.pick_job.ask(task_of(picking, std::move(request)), picker(), ui.wake);
}

// The curve begins as soon as the pick has the matrix for it.
void follow_curve(const Ui& ui, PickRequest request, SubsetState& picking) {
    picking.curve_asked = curve_request(std::move(request));
    const auto& asked = picking.curve_job.asked();
    if (picking.cancelled || (asked && asked->question == picking.curve_asked)) return;
    PickTask task = task_of(picking, picking.curve_asked);
    if (!task.apart) return picking.curve_job.leave();
    picking.curve_job.ask(std::move(task), find_curve, ui.wake);
}

template <class Request, class Answer>
void take(const Query<Request, Answer>& job, std::shared_ptr<const Answer>& answer) {
    if (auto latest = job.latest()) answer = std::move(latest);
}

constexpr std::size_t kKeptStabilities = 8;

void take_stability(SubsetState& picking) {
    auto latest = picking.stability_job.latest();
    auto& all = picking.stabilities;
    if (!latest || (!all.empty() && all.front() == latest)) return;
    all.insert(all.begin(), std::move(latest));
    if (all.size() > kKeptStabilities) all.pop_back();
}

// Whether variants of the model say the same of both: the map may have been left and come back.
bool is_same_pick(const Pick& a, const Pick& b) {
    if (&a == &b) return true;
    const LiveMapRequest& x = a.request.map->request;
    const LiveMapRequest& y = b.request.map->request;
    PickRequest same = a.request;
    same.map = b.request.map;
    return x.document == y.document && is_same_work(x, y) && same == b.request &&
           a.answer.best.members == b.answer.best.members &&
           std::ranges::equal(x.set->vibrations, y.set->vibrations, {}, &Vibration::name,
                              &Vibration::name);
}

}  // namespace

void follow_subset(const Ui& ui, const Workspace& work, const Layout& layout,
                   const ShownMap& shown_map, SubsetState& picking) {
    if (!has_jobs(ui)) return;
    take(picking.pick_job, picking.pick);
    take(picking.curve_job, picking.curve);
    take(picking.separation_job, picking.separations);
    take_stability(picking);
    const MapState state = map_state(work, shown_map);
    const bool is_current = state == MapState::exact || state == MapState::preview;
    const bool has_pairs = is_current && shown_map.transition.shown->prediction.pm.size > 1;
    const bool is_wanted = layout.bench == BenchTab::subset ||
                           layout.bench == BenchTab::candidates || work.selection.only_picked ||
                           !picking.export_to.empty() || !picking.report_to.empty();
    if (!is_wanted || !has_pairs) return;
    follow_groups(ui, shown_map, layout, picking);
    const PickRequest request = request_of(work, shown_map, picking);
    follow_pick(ui, request, picking);
    if (state == MapState::exact) follow_curve(ui, request, picking);
}

const Pick* shown_pick(const ShownMap& shown_map, const SubsetState& picking) {
    const Pick* pick = picking.pick.get();
    if (pick == nullptr || !shown_map.transition.shown || !pick->fault.empty()) return nullptr;
    const LiveMapRequest& of = pick->request.map->request;
    if (of.document != shown_map.transition.shown->request.document) return nullptr;
    const auto& picked = set_of(pick->request).vibrations;
    const auto& shown = shown_map.transition.shown->request.set->vibrations;
    const bool is_of_shown =
        std::ranges::equal(picked, shown, {}, &Vibration::name, &Vibration::name);
    return is_of_shown ? pick : nullptr;
}

bool is_of_preview(const PickRequest& request) { return request.map->request.preview; }

bool is_unsettled(const Pick& pick) { return is_of_preview(pick.request) || pick.is_so_far; }

std::set<std::string> picked_names(const ShownMap& shown_map, const SubsetState& picking) {
    const Subset* subset = shown_subset(shown_map, picking);
    if (subset == nullptr) return {};
    const auto& all = shown_map.transition.shown->request.set->vibrations;
    std::set<std::string> names;
    for (const std::size_t member : subset->members) names.insert(all[member].name);
    return names;
}

bool is_pick_stale(const Workspace& work, const ShownMap& shown_map, const SubsetState& picking) {
    const MapState state = map_state(work, shown_map);
    if (!picking.pick || (state != MapState::exact && state != MapState::preview)) return true;
    // A map that has just come is asked about at the end of its frame.
    return picking.pick->request != picking.asked ||
           picking.pick->request.map != shown_map.transition.shown;
}

const Subset* shown_subset(const ShownMap& shown_map, const SubsetState& picking) {
    const Pick* pick = shown_pick(shown_map, picking);
    if (pick == nullptr) return nullptr;
    const auto& alternative = picking.alternative;
    if (!alternative || *alternative >= pick->answer.alternatives.size()) return &pick->answer.best;
    return &pick->answer.alternatives[*alternative];
}

bool is_picking(const SubsetState& picking) {
    if (picking.pick_job.busy()) return true;
    const auto latest = picking.pick_job.latest();
    return latest && latest != picking.pick;
}

bool is_subset_busy(const SubsetState& picking) {
    return is_picking(picking) || picking.curve_job.busy() || picking.separation_job.busy() ||
           picking.stability_job.busy() || picking.groups_job.busy();
}

void cancel_picking(SubsetState& picking) {
    picking.pick_job.cancel();
    picking.curve_job.cancel();
    picking.cancelled = true;
}

void ask_for_stability(const Ui& ui, SubsetState& picking, std::size_t draws) {
    picking.stability_job.ask({picking.pick, draws}, find_stability, ui.wake);
}

const FoundStability* found_stability(const SubsetState& picking) {
    if (!picking.pick) return nullptr;
    const auto found = std::ranges::find_if(picking.stabilities, [&](const auto& one) {
        return is_same_pick(*one->request.pick, *picking.pick);
    });
    return found == picking.stabilities.end() ? nullptr : found->get();
}

const Stability* shown_stability(const SubsetState& picking) {
    const FoundStability* found = found_stability(picking);
    return found == nullptr ? nullptr : &found->stability;
}

}  // namespace tact
