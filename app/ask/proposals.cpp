#include "app/ask/ask.h"

#include <algorithm>

#include "app/ask/parts.h"
#include "app/document/editing.h"
#include "app/map/map.h"
#include "devices/calibration/rendering.h"
#include "model/common/parallel.h"
#include "model/set/pattern_set.h"

namespace tact {

namespace {

constexpr double kTrackStaysS = 2.0;

// The track stays for a while after the mouse has left the slider, so that the mouse can reach it.
void follow_rested(const Ui& ui, const Workspace& work, ProposalsState& state) {
    if (work.selection.rested) {
        state.rested = work.selection.rested;
        state.rested_until_s = ui.time_s + kTrackStaysS;
        return;
    }
    const Vibration* current = current_vibration(work);
    if (!state.rested) return;
    if (work.selection.on_track) state.rested_until_s = ui.time_s + kTrackStaysS;
    const bool is_gone = ui.time_s > state.rested_until_s || current == nullptr ||
                         current->name != state.rested->name;
    if (is_gone) state.rested.reset();
}

std::optional<ProposalsRequest> vary_request(const Workspace& work, const ShownMap& shown_map,
                                             const ProposalsState& state) {
    const auto place = place_named(work.document.set, state.varied);
    if (!place) return std::nullopt;
    const auto* pattern = std::get_if<Pattern>(&work.document.set.vibrations[*place].source);
    auto request = request_for(work, shown_map, state.varied, {});
    if (!request || pattern == nullptr) return std::nullopt;
    VaryQuestion question{*pattern};
    question.how_far = state.how_far;
    question.seed = state.vary_seed;
    question.steps = work.document.set.felt_steps;
    question.model = work.document.set.model;
    question.free = free_of(state);
    request->vary = question;
    return request;
}

// The exact places of the same neighbours, once they are known.
std::optional<ProposalsRequest> exact_variants(const ProposalsState& state) {
    const auto found = state.variants.current();
    if (!found || found->patterns.empty()) return std::nullopt;
    ProposalsRequest request = found->request;
    request.vary.reset();
    request.patterns = found->patterns;
    request = exactly(std::move(request), found->patterns.size());
    return request.exact ? std::optional(request) : std::nullopt;
}

}  // namespace

void follow_proposals(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                      ProposalsState& state) {
    if (!has_jobs(ui)) return;
    const auto want = [&ui](ProposalsQuery& query, std::optional<ProposalsRequest> request) {
        query.want(std::move(request), ProposalsWork{}, ui.wake);
    };
    follow_rested(ui, work, state);
    const auto& rested = state.rested;
    const auto track =
        rested ? request_for(work, shown_map, rested->name, rested->patterns) : std::nullopt;
    want(state.track, track);
    // The exact job starts after the preview is there, as it would delay the preview.
    const bool is_previewed = track && state.track.current() != nullptr;
    const auto exact = is_previewed ? exactly(*track, track->patterns.size()) : ProposalsRequest{};
    want(state.exact_track, exact.exact ? std::optional(exact) : std::nullopt);
    state.suggested = work.selection.suggested;
    const auto& suggested = state.suggested;
    auto ghost = suggested ? request_for(work, shown_map, suggested->name, {suggested->changed})
                           : std::nullopt;
    want(state.suggestion, ghost ? std::optional(exactly(*std::move(ghost), 1)) : std::nullopt);
    want(state.variants,
         state.varied.empty() ? std::nullopt : vary_request(work, shown_map, state));
    want(state.exact_variants, exact_variants(state));
}

bool is_asking(const ProposalsState& state) {
    return state.track.busy() || state.exact_track.busy() || state.suggestion.busy() ||
           state.variants.busy() || state.exact_variants.busy() || is_filling(state) ||
           state.put.cloud.busy() || state.put.job.busy();
}

MapMaybes shown_proposals(const ShownMap& shown_map, const ProposalsState& state) {
    MapMaybes shown;
    const Eigen::Index columns = shown_map.transition.to.cols();
    const auto exact = state.exact_track.current();
    const auto track = exact ? exact : state.track.current();
    if (track && state.rested && track->places.cols() == columns) {
        shown.track = track->places;
        shown.track_words = state.rested->words;
        for (std::string& words : shown.track_words) {
            if (!exact) words += " (preview)";
        }
    }
    if (const auto all = found_variants(state); all && all->places.cols() == columns) {
        shown.proposals = all->places;
        for (Eigen::Index k = 0; k < all->places.rows(); ++k) {
            shown.proposal_names.push_back("neighbour " + std::to_string(k + 1));
        }
    }
    const auto& suggested = state.suggested;
    const auto ghost = state.suggestion.current();
    if (suggested && ghost && ghost->places.rows() == 1 && ghost->places.cols() == columns) {
        shown.proposals = ghost->places;
        shown.proposal_names = {suggested->words};
        shown.lit = 0;
    }
    show_put(shown, columns, state);
    return shown;
}

bool can_vary(const Workspace& work) {
    const Vibration* current = current_vibration(work);
    return current != nullptr && editable_pattern(*current) != nullptr &&
           work.document.set.vibrations.size() >= 3;
}

void vary(Ui& ui, const Workspace& work, ProposalsState& state) {
    const Vibration* current = current_vibration(work);
    if (current == nullptr || editable_pattern(*current) == nullptr) {
        return say(
            ui, "Only a pattern without layers that is no recording and not locked can be varied.");
    }
    if (work.document.set.vibrations.size() < 3) {
        return say(ui, "Neighbours are shown in the map: it needs three patterns.");
    }
    const bool again = state.varied == current->name;
    if (again) ++state.vary_seed;
    state.varied = current->name;
}

void stop_varying(ProposalsState& state) { state.varied.clear(); }

std::shared_ptr<const FoundProposals> found_variants(const ProposalsState& state) {
    const auto preview = state.variants.current();
    const auto exact = state.exact_variants.current();
    return exact && preview && exact->patterns == preview->patterns ? exact : preview;
}

void take_variant(Ui& ui, Workspace& work, ProposalsState& state, std::size_t k) {
    const auto found = found_variants(state);
    const auto place = place_named(work.document.set, state.varied);
    if (!found || !place || k >= found->patterns.size()) return;
    Vibration& vibration = work.document.edit().vibrations[*place];
    if (editable_pattern(vibration) == nullptr) return;
    vibration.source = found->patterns[k];
    vibration.generated = false;
    select_only(work, *place);
    document_changed(work);
    commit_step(ui, work, "Vary " + vibration.name);
    say(ui, vibration.name + " is its neighbour now. V varies that one, Ctrl+Z takes it back.");
    stop_varying(state);
}

namespace {

constexpr Eigen::Index kMostMappedAgain = 60;  // points of a map that is computed for each pattern

}  // namespace

std::optional<FoundProposals> ProposalsWork::operator()(const ProposalsRequest& request,
                                                        std::stop_token stop,
                                                        std::atomic<float>& progress) {
    FoundProposals found{request, request.patterns, {}};
    if (request.vary) {
        auto patterns = varied(*request.vary, 0, stop);
        if (!patterns) return std::nullopt;
        found.patterns = *std::move(patterns);
    }
    if (!prepare(request, stop)) return std::nullopt;
    const auto count = static_cast<Eigen::Index>(found.patterns.size());
    found.places.resize(count, request.points.cols());
    const auto& by = request.map->request.rendered_by;
    const bool maps_again = request.exact && request.points.rows() <= kMostMappedAgain;
    // A map computed again for each pattern uses all cores by itself; quick places use one core
    // each.
    std::atomic<Eigen::Index> done = 0;
    const auto place_one = [&](std::size_t k) {
        Waveform waveform = render(found.patterns[k]);
        if (by) waveform = rendering(*by, waveform).waveform;
        const auto place =
            maps_again ? point_->mapped_again(waveform, stop) : (*point_)(waveform, stop, 1);
        if (place) found.places.row(static_cast<Eigen::Index>(k)) = place->at;
        progress = static_cast<float>(++done) / static_cast<float>(count);
    };
    const bool all = parallel_for(found.patterns.size(), maps_again ? 1 : 0, stop, place_one);
    if (!all || stop.stop_requested()) return std::nullopt;
    return found;
}

std::optional<FoundReach> ProposalsWork::operator()(const ReachRequest& request,
                                                    std::stop_token stop,
                                                    std::atomic<float>& progress) {
    if (!prepare(request.where, stop)) return std::nullopt;
    ReachOptions options;
    options.stop = stop;
    options.progress = [&progress](double share) { progress = static_cast<float>(share); };
    if (const auto& by = request.where.map->request.rendered_by) {
        options.felt = [&by](const Waveform& meant) { return rendering(*by, meant).waveform; };
    }
    auto reached = reach(request.question, *point_, options);
    if (!reached) return std::nullopt;
    return FoundReach{request, *std::move(reached)};
}

bool ProposalsWork::prepare(const ProposalsRequest& request, const std::stop_token& stop) {
    const bool same_map = of_ == request.map && row_ == request.row && exact_ == request.exact &&
                          points_.cols() == request.points.cols() && points_ == request.points;
    if (point_ && same_map) return true;
    std::shared_ptr<const Prediction> base;
    const bool is_coarse = request.map->request.preview;
    if (request.exact || is_coarse) base = {request.map, &request.map->prediction};
    point_ = MovedPoint::of({own_waveforms(*request.map->played), request.map->request.set->model,
                             request.points, std::move(base)},
                            request.row, 0, stop);
    of_ = request.map;
    row_ = request.row;
    points_ = request.points;
    exact_ = request.exact;
    return point_.has_value();
}

ProposalsRequest exactly(ProposalsRequest request, std::size_t patterns) {
    const PatternSet& set = *request.map->played;
    const double rows = static_cast<double>(patterns);
    const double pairs = 0.5 * static_cast<double>(set.vibrations.size());
    const double each_s = expected_map_s(set) / std::max(1.0, pairs);
    request.exact = !request.map->request.preview && rows * each_s <= kLongestExactS;
    return request;
}

// A request for the map on screen; nullopt if that map belongs to an earlier revision, or the
// pattern is missing from it or longer than all others.
std::optional<ProposalsRequest> request_for(const Workspace& work, const ShownMap& shown_map,
                                            const std::string& name,
                                            std::vector<Pattern> patterns) {
    const MapTransition& map = shown_map.transition;
    const MapState state = map_state(work, shown_map);
    if (state != MapState::exact && state != MapState::preview) return std::nullopt;
    if (map.to.rows() < 3 || map.shown->space.verdict == MdsVerdict::constant) return std::nullopt;
    const auto row = place_named(*map.shown->request.set, name);
    if (!row) return std::nullopt;
    const double longest = longest_s(*map.shown->played);
    std::erase_if(patterns, [&](const Pattern& p) { return p.duration_s > longest; });
    return ProposalsRequest{map.shown, map.to, *row, std::move(patterns), {}};
}

std::vector<PatternParameter> free_of(const ProposalsState& state) {
    std::vector<PatternParameter> free;
    for (const PatternParameter parameter : kPatternParameters) {
        const bool is_held = std::ranges::find(state.held, parameter) != state.held.end();
        if (!is_held) free.push_back(parameter);
    }
    return free;
}

}  // namespace tact
