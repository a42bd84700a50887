#include "app/map/map.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/document/workspace.h"
#include "app/map/parts.h"
#include "model/set/likeness.h"
#include "model/system/process.h"

namespace tact {

namespace {

constexpr double kEaseS = 0.18;
constexpr double kGhostS = 1.6;
constexpr double kInTurnS = 2.0;  // an exact map that takes longer leaves the cores to the preview
constexpr double kSeenS = 0.5;    // a ring that was there for less has hardly been seen

double smooth(double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

bool is_news(const ShownMap& shown_map, const std::shared_ptr<const LiveMap>& map) {
    if (!map || map == shown_map.transition.shown) return false;
    if (map->request.document != shown_map.of_document) return false;
    if (!shown_map.transition.shown) return true;
    const LiveMapRequest& shown = shown_map.transition.shown->request;
    if (map->request.revision != shown.revision) return map->request.revision > shown.revision;
    if (!shown.preview || !map->request.preview) return shown.preview;
    return map->exact_share > 0.0 && map->exact_share >= shown_map.transition.shown->exact_share;
}

// The set, with the places that its map had when the set was last like this, if they are known:
// the new map is turned to them.
PatternSet set_to_lay(const Workspace& work) {
    PatternSet set = shown_set(work);
    const MapPlaces* places = work.document.places();
    set.map_places = places == nullptr ? MapPlaces{} : *places;
    return set;
}

bool are_known(const MapPlaces* places, const MapTransition& map) {
    return places != nullptr &&
           saved_places(*map.shown, *places).rows.size() == static_cast<std::size_t>(map.to.rows());
}

// As large as the map, in its first two dimensions.
Eigen::MatrixXd ring_for(const Eigen::MatrixXd& map, const WaitingRing& waiting) {
    Eigen::MatrixXd ring = Eigen::MatrixXd::Zero(map.rows(), map.cols());
    const double radius = map.rowwise().norm().maxCoeff();
    for (Eigen::Index k = 0; k < map.rows() && map.cols() > 1; ++k) {
        const RingDirection to = ring_direction(waiting, static_cast<std::size_t>(k),
                                                static_cast<std::size_t>(map.rows()));
        ring(k, 0) = radius * to.right;
        ring(k, 1) = radius * to.up;
    }
    return ring;
}

Eigen::MatrixXd places_of(const LiveMap& map, const ShownMap& shown_map) {
    const auto& held = shown_map.held;
    const bool is_held = held && held->revision == map.request.revision &&
                         held->points.rows() == map.space.points.rows() &&
                         held->points.cols() == map.space.points.cols();
    return is_held ? held->points : aligned_to_anchor(shown_map.transition, map);
}

void ask_exact(const Ui& ui, ShownMap& shown_map, LiveMapRequest request) {
    shown_map.full_job.ask(
        std::move(request),
        [full = LiveMapWork()](const LiveMapRequest& asked, std::stop_token stop,
                               std::atomic<float>& progress,
                               const LiveMapWork::Partly& partly) mutable {
            return full.in_parts(asked, std::move(stop), progress, partly);
        },
        ui.wake, JobPolicy::supersede, is_same_work);
}

// A preview that failed is waited for no longer.
void ask_in_turn(const Ui& ui, ShownMap& shown_map) {
    auto request = std::exchange(shown_map.exact_in_turn, std::nullopt);
    if (!request || shown_map.cancelled) return;
    const auto& shown = shown_map.transition.shown;
    if (shown && shown->request.preview && shown->request.document == request->document &&
        shown->request.revision == request->revision &&
        shown->request.rendered_by == request->rendered_by) {
        request->coarse = shown;
    }
    shown_map.wanted = std::make_shared<WantedRows>();
    request->wanted = shown_map.wanted;
    ask_exact(ui, shown_map, std::move(*request));
}

// A map that was stopped by the end of the program, or by another document, continues.
void take_up_exact(const Workspace& work, ShownMap& shown_map) {
    if (needs_asking(work.document.set) && has_checkpoint(work)) {
        shown_map.compute_large_of = work.document_number;
    }
}

}  // namespace

void follow_ring(const Workspace& work, ShownMap& shown_map) {
    WaitingRing& ring = shown_map.ring;
    if (ring.document == work.document_number && ring.revision == work.revision) return;
    const std::vector<std::size_t> order = order_by_likeness(work.document.set);
    ring = {work.document_number, work.revision, std::vector<std::size_t>(order.size())};
    for (std::size_t k = 0; k < order.size(); ++k) ring.position[order[k]] = k;
}

RingDirection ring_direction(const WaitingRing& ring, std::size_t place, std::size_t count) {
    const bool is_known = ring.position.size() == count && place < count;
    const auto position = static_cast<double>(is_known ? ring.position[place] : place);
    const double turn =
        2.0 * std::numbers::pi * position / static_cast<double>(std::max<std::size_t>(count, 1));
    return {std::cos(turn), std::sin(turn)};
}

void show_map(const Ui& ui, ShownMap& shown_map, std::shared_ptr<const LiveMap> map) {
    MapTransition next;
    next.since_s = ui.time_s;
    next.to = places_of(*map, shown_map);
    next.from = next.to;
    next.ghost = ghosts_of(*map, shown_map.transition);
    const auto waited = ui.ages.find(kWaitingRing);
    const bool is_first = shown_map.transition.shown == nullptr;
    if (is_first && waited != ui.ages.end() && ui.time_s - waited->second.since_s > kSeenS) {
        next.from = ring_for(next.to, shown_map.ring);
    }
    if (shown_map.transition.shown && shown_map.transition.to.cols() == next.to.cols()) {
        const Common common = common_rows(*map, *shown_map.transition.shown);
        const Eigen::MatrixXd now = eased_points(ui, shown_map);
        for (std::size_t k = 0; k < common.here.size(); ++k) {
            next.from.row(common.here[k]) = now.row(common.there[k]);
        }
    }
    const bool keeps = keeps_anchor(shown_map.transition, *map);
    next.anchor = keeps ? shown_map.transition.anchor : map;
    next.anchor_points = keeps ? shown_map.transition.anchor_points : next.to;
    next.shown = std::move(map);
    shown_map.transition = std::move(next);
}

void take_maps(const Ui& ui, ShownMap& shown_map) {
    const bool is_previewed = !shown_map.preview_job.busy();  // before its answer is taken
    for (const auto* job : {&shown_map.preview_job, &shown_map.full_job}) {
        if (auto map = job->latest(); is_news(shown_map, map))
            show_map(ui, shown_map, std::move(map));
    }
    if (is_previewed) ask_in_turn(ui, shown_map);
    follow_unshifted(ui, shown_map);
}

void request_maps(const Ui& ui, const Workspace& work, ShownMap& shown_map,
                  const RenderingState& rendered) {
    if (!has_jobs(ui)) return;  // a picture without a window computes its map itself
    shown_map.maps_asked = work.revision;
    shown_map.cancelled = false;
    // Another document is another map: the last one says nothing of it.
    if (std::exchange(shown_map.of_document, work.document_number) != work.document_number) {
        shown_map.transition = {};
        take_up_exact(work, shown_map);
    }
    shown_map.exact_in_turn.reset();
    const PatternSet& set = work.document.set;
    const bool has_preview = preview_grain(set).has_value();
    const bool waits = exact_waits(work, shown_map);
    if (waits) shown_map.full_job.cancel();
    if (!has_preview) shown_map.preview_job.cancel();
    if (waits && !has_preview) return;
    LiveMapRequest request{work.revision,
                           work.document_number,
                           std::make_shared<const PatternSet>(set_to_lay(work)),
                           shown_map.dimensions,
                           false,
                           rendered_by(rendered)};
    if (!waits && needs_asking(set) && !request.rendered_by) {
        request.checkpoint = map_checkpoint(work);
    }
    // An exact map that does not give way would take half of the preview's processors.
    const bool is_in_the_way = has_preview && threads_weigh_alike();
    if (is_in_the_way) shown_map.full_job.cancel();
    const bool in_turn = is_in_the_way || (has_preview && expected_map_s(set) > kInTurnS);
    if (!waits && in_turn) shown_map.exact_in_turn = request;
    if (!waits && !in_turn) ask_exact(ui, shown_map, request);
    const auto& shown = shown_map.transition.shown;
    const bool is_shown = shown && shown->request.revision == work.revision;
    if (!has_preview || (is_shown && shown->request.preview)) {
        return ask_in_turn(ui, shown_map);
    }
    request.preview = true;
    shown_map.preview_job.ask(request, LiveMapWork{}, ui.wake, JobPolicy::finish);
}

void follow_map(const Ui& ui, const Workspace& work, ShownMap& shown_map,
                const RenderingState& rendered) {
    if (shown_map.maps_asked != work.revision) request_maps(ui, work, shown_map, rendered);
    if (shown_map.wanted && shown_map.full_job.busy()) {
        shown_map.wanted->tell(rows_looked_at(work, shown_map));
    }
}

void note_map_places(Workspace& work, ShownMap& shown_map) {
    if (map_state(work, shown_map) != MapState::exact || holds_places(work, shown_map)) return;
    const MapTransition& map = shown_map.transition;
    if (map.shown->space.verdict == MdsVerdict::constant) return;
    if (std::exchange(shown_map.places_noted_of, map.shown) == map.shown) return;
    if (are_known(work.document.places(), map)) return;
    const auto& all = map.shown->request.set->vibrations;
    if (all.size() != work.document.set.vibrations.size()) return;  // of one side alone
    if (!tells_turn(all.size(), map.to.cols())) return;
    MapPlaces places;
    for (std::size_t k = 0; k < all.size(); ++k) {
        auto& place = places.at[all[k].name];
        for (Eigen::Index d = 0; d < map.to.cols(); ++d) {
            place.push_back(map.to(static_cast<Eigen::Index>(k), d));
        }
    }
    work.document.note_places(std::move(places));
}

bool exact_waits(const Workspace& work, const ShownMap& shown_map) {
    return shown_map.compute_large_of != work.document_number && needs_asking(work.document.set);
}

void compute_exact(const Workspace& work, ShownMap& shown_map) {
    shown_map.compute_large_of = work.document_number;
    shown_map.maps_asked = 0;
}

MapState map_state(const Workspace& work, const ShownMap& shown_map) {
    const std::size_t count = work.document.set.vibrations.size();
    if (exact_waits(work, shown_map) && !preview_grain(work.document.set))
        return MapState::too_large;
    if (!shown_map.transition.shown || count == 0) return MapState::none;
    const LiveMapRequest& shown = shown_map.transition.shown->request;
    if (shown.document != work.document_number) return MapState::none;
    if (shown.revision != work.revision) return MapState::stale;
    return shown.preview ? MapState::preview : MapState::exact;
}

void hold_places(const Workspace& work, ShownMap& shown_map, Eigen::Index row,
                 const Eigen::RowVectorXd& at) {
    Eigen::MatrixXd points = shown_map.transition.to;
    if (row >= points.rows() || at.size() != points.cols()) return;
    points.row(row) = at;
    shown_map.held = HeldPlaces{work.revision, std::move(points)};
}

bool holds_places(const Workspace& work, const ShownMap& shown_map) {
    return shown_map.held && shown_map.held->revision == work.revision;
}

void follow_unfelt(Workspace& work, ShownMap& shown_map) {
    const auto& shown = shown_map.transition.shown;
    ShownUnfelt& found = shown_map.unfelt;
    if (found.of == shown && found.revision == work.revision) return;
    found = {shown, work.revision};
    work.selection.unfelt.clear();
    if (!shown) return;
    const auto& then = shown->request.set->vibrations;
    const auto& codes = shown->prediction.codes;
    for (const std::size_t k : unfelt(codes)) {
        const auto now = place_named(work.document.set, then[k].name);
        if (!now || work.document.set.vibrations[*now].source != then[k].source) continue;
        work.selection.unfelt.insert(then[k].name);
    }
}

Eigen::MatrixXd eased_points(const Ui& ui, const ShownMap& shown_map) {
    if (!ui.motion) return shown_map.transition.to;
    const double share = smooth((ui.time_s - shown_map.transition.since_s) / kEaseS);
    return shown_map.transition.from +
           share * (shown_map.transition.to - shown_map.transition.from);
}

double ghost_opacity(const Ui& ui, const ShownMap& shown_map) {
    if (shows_unshifted(shown_map.transition)) return 1.0;
    if (!ui.motion) return 0.0;
    return std::clamp(1.0 - (ui.time_s - shown_map.transition.since_s) / kGhostS, 0.0, 1.0);
}

bool is_moving(const Ui& ui, const ShownMap& shown_map) {
    const MapTransition& map = shown_map.transition;
    if (!ui.motion || !map.shown) return false;
    // Parts of a first map leave no ghosts: between them no frame need be drawn.
    const bool has_ghosts = map.ghost.array().isFinite().any();
    return ui.time_s - map.since_s < (has_ghosts ? kGhostS : kEaseS);
}

}  // namespace tact
