#include "app/map/unshifted_map.h"

#include <algorithm>
#include <utility>

#include "app/map/map_turn.h"

namespace tact {

namespace {

bool is_shifted(const LiveMapRequest& request) {
    return request.set->model.coding.tables.threshold != default_tables().threshold;
}

LiveMapRequest without_shifts(const LiveMapRequest& request) {
    LiveMapRequest unshifted = request;
    PatternSet set = *request.set;
    set.model.coding.tables.threshold = default_tables().threshold;
    unshifted.set = std::make_shared<const PatternSet>(std::move(set));
    unshifted.preview = false;
    return unshifted;
}

// As is_same_work would find, without a copy of the set in every frame.
bool is_without_shifts(const LiveMapRequest& unshifted, const LiveMapRequest& shown) {
    PerceptualModelParams model = shown.set->model;
    model.coding.tables.threshold = default_tables().threshold;
    return !unshifted.preview && unshifted.dimensions == shown.dimensions &&
           unshifted.rendered_by == shown.rendered_by && unshifted.set->model == model &&
           std::ranges::equal(unshifted.set->vibrations, shown.set->vibrations, {},
                              &Vibration::source, &Vibration::source);
}

}  // namespace

bool keeps_anchor(const MapTransition& before, const LiveMap& fresh) {
    if (fresh.request.preview) return true;
    if (!is_shifted(fresh.request)) return false;
    return before.anchor && !is_shifted(before.anchor->request) &&
           before.anchor_points.cols() == fresh.space.points.cols();
}

bool shows_unshifted(const MapTransition& map) {
    if (!map.shown || !map.anchor || map.anchor == map.shown) return false;
    if (map.anchor_points.cols() != map.to.cols()) return false;
    return is_shifted(map.shown->request) &&
           is_without_shifts(map.anchor->request, map.shown->request);
}

void follow_unshifted(const Ui& ui, ShownMap& shown_map) {
    MapTransition& map = shown_map.transition;
    if (!map.shown || !has_jobs(ui) || map.shown->request.preview) return;
    const LiveMapRequest& shown = map.shown->request;
    if (!is_shifted(shown) || shows_unshifted(map) || needs_asking(*shown.set)) return;
    if (std::exchange(shown_map.unshifted_asked_of, map.shown) != map.shown) {
        shown_map.unshifted_job.ask(without_shifts(shown), LiveMapWork{}, ui.wake,
                                    JobPolicy::supersede, is_same_work);
    }
    auto unshifted = shown_map.unshifted_job.latest();
    if (!unshifted || !is_without_shifts(unshifted->request, shown)) return;
    map.anchor_points = aligned_to_anchor(map, *unshifted);
    map.anchor = std::move(unshifted);
    map.ghost = ghosts_of(*map.shown, map);
}

}  // namespace tact
