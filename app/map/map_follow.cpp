#include "app/map/map_follow.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_map>

#include "app/document/shown_side.h"
#include "model/map/procrustes.h"

namespace tact {

namespace {

constexpr double kEaseS = 0.18;
constexpr double kGhostS = 1.6;

// Rows of the vibrations that two maps have in common, by name.
struct Common {
    std::vector<Eigen::Index> here;
    std::vector<Eigen::Index> there;
};

Common common_rows(const LiveMap& map, const LiveMap& earlier) {
    std::unordered_map<std::string_view, Eigen::Index> places;
    const auto& before = earlier.request.set->vibrations;
    for (std::size_t k = 0; k < before.size(); ++k) {
        places.emplace(before[k].name, static_cast<Eigen::Index>(k));
    }
    Common common;
    const auto& now = map.request.set->vibrations;
    for (std::size_t k = 0; k < now.size(); ++k) {
        const auto found = places.find(now[k].name);
        if (found == places.end()) continue;
        common.here.push_back(static_cast<Eigen::Index>(k));
        common.there.push_back(found->second);
    }
    return common;
}

Eigen::MatrixXd picked(const Eigen::MatrixXd& points, const std::vector<Eigen::Index>& rows) {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()), points.cols());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        result.row(static_cast<Eigen::Index>(k)) = points.row(rows[k]);
    }
    return result;
}

Eigen::MatrixXd aligned_to_anchor(const MapTransition& map, const LiveMap& fresh) {
    const Eigen::MatrixXd& points = fresh.space.points;
    if (!map.anchor || map.anchor_points.cols() != points.cols()) return points;
    const Common common = common_rows(fresh, *map.anchor);
    const ProcrustesFit fit =
        procrustes(picked(points, common.here), picked(map.anchor_points, common.there), false);
    return transformed(fit, points);
}

double smooth(double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

bool is_news(const App& app, const std::shared_ptr<const LiveMap>& map) {
    if (!map || map == app.map.shown) return false;
    if (!app.map.shown) return true;
    const LiveMapRequest& shown = app.map.shown->request;
    if (map->request.revision != shown.revision) return map->request.revision > shown.revision;
    return shown.preview && !map->request.preview;
}

}  // namespace

void show_map(App& app, std::shared_ptr<const LiveMap> map) {
    MapTransition next;
    next.since_s = app.time_s;
    next.to = aligned_to_anchor(app.map, *map);
    next.from = next.to;
    next.ghost = Eigen::MatrixXd::Constant(next.to.rows(), next.to.cols(),
                                           std::numeric_limits<double>::quiet_NaN());
    if (app.map.shown && app.map.to.cols() == next.to.cols()) {
        const Common common = common_rows(*map, *app.map.shown);
        const Eigen::MatrixXd now = eased_points(app);
        for (std::size_t k = 0; k < common.here.size(); ++k) {
            next.from.row(common.here[k]) = now.row(common.there[k]);
        }
    }
    if (app.map.anchor && app.map.anchor_points.cols() == next.to.cols()) {
        const Common common = common_rows(*map, *app.map.anchor);
        for (std::size_t k = 0; k < common.here.size(); ++k) {
            next.ghost.row(common.here[k]) = app.map.anchor_points.row(common.there[k]);
        }
    }
    next.anchor = map->request.preview ? app.map.anchor : map;
    next.anchor_points = map->request.preview ? app.map.anchor_points : next.to;
    next.shown = std::move(map);
    app.map = std::move(next);
}

void make_map_jobs(App& app) {
    using MapJob = LatestJob<LiveMapRequest, LiveMap>;
    app.preview_job = std::make_unique<MapJob>(JobPolicy::finish, LiveMapWork{}, app.wake);
    app.full_job =
        std::make_unique<MapJob>(JobPolicy::supersede, LiveMapWork{}, app.wake, is_same_work);
    app.maps_asked = app.revision;  // until something changes or is asked for
}

void take_maps(App& app) {
    if (!app.full_job) return;
    for (const auto* job : {app.preview_job.get(), app.full_job.get()}) {
        if (auto map = job->latest(); is_news(app, map)) show_map(app, std::move(map));
    }
}

void request_maps(App& app) {
    if (!app.full_job) return;  // a picture without a window computes its map itself
    app.maps_asked = app.revision;
    app.map_cancelled = false;
    const PatternSet& set = app.document.set;
    if (needs_asking(set) && app.compute_large_of != app.document_number) {
        app.preview_job->cancel();
        app.full_job->cancel();
        return;
    }
    LiveMapRequest request{app.revision, std::make_shared<const PatternSet>(shown_set(app)),
                           app.dimensions, false, rendered_by(app.rendering)};
    app.full_job->submit(request);
    // A preview takes a hundredth of the work, and of one pattern changed again only a row of that.
    // One that lasts would come too late to be one.
    constexpr double kLongestPreviewS = 3.0;
    constexpr std::size_t kMostPreviewed = 300;
    if (set.vibrations.size() > kMostPreviewed) return;
    if (expected_map_s(set) / 100.0 > kLongestPreviewS) return;
    request.preview = true;
    app.preview_job->submit(request);
}

void follow_map(App& app) {
    if (app.maps_asked != app.revision) request_maps(app);
}

MapState map_state(const App& app) {
    const std::size_t count = app.document.set.vibrations.size();
    if (needs_asking(app.document.set) && app.compute_large_of != app.document_number)
        return MapState::too_large;
    if (!app.map.shown || count == 0) return MapState::none;
    const LiveMapRequest& shown = app.map.shown->request;
    if (shown.revision != app.revision) return MapState::stale;
    return shown.preview ? MapState::preview : MapState::exact;
}

Eigen::MatrixXd eased_points(const App& app) {
    if (!app.motion) return app.map.to;
    const double share = smooth((app.time_s - app.map.since_s) / kEaseS);
    return app.map.from + share * (app.map.to - app.map.from);
}

double ghost_opacity(const App& app) {
    if (!app.motion) return 0.0;
    return std::clamp(1.0 - (app.time_s - app.map.since_s) / kGhostS, 0.0, 1.0);
}

bool is_moving(const App& app) {
    return app.motion && app.map.shown && app.time_s - app.map.since_s < kGhostS;
}

}  // namespace tact
