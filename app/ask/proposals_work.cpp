#include "app/ask/proposals_work.h"

#include <algorithm>

#include "app/map/map_follow.h"
#include "devices/calibration/rendering.h"
#include "model/common/parallel.h"
#include "model/set/set_waveforms.h"

namespace tact {

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
