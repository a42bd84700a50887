#include "app/map/map_turn.h"

#include <limits>
#include <string_view>
#include <unordered_map>

#include "model/map/procrustes.h"

namespace tact {

namespace {

Eigen::MatrixXd picked(const Eigen::MatrixXd& points, const std::vector<Eigen::Index>& rows) {
    Eigen::MatrixXd result(static_cast<Eigen::Index>(rows.size()), points.cols());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        result.row(static_cast<Eigen::Index>(k)) = points.row(rows[k]);
    }
    return result;
}

}  // namespace

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

SavedPlaces saved_places(const LiveMap& map, const MapPlaces& kept) {
    const auto& saved = kept.at;
    const auto columns = static_cast<std::size_t>(map.space.points.cols());
    SavedPlaces places;
    std::vector<const std::vector<double>*> found;
    const auto& now = map.request.set->vibrations;
    for (std::size_t k = 0; k < now.size(); ++k) {
        const auto at = saved.find(now[k].name);
        if (at == saved.end() || at->second.size() != columns) continue;
        places.rows.push_back(static_cast<Eigen::Index>(k));
        found.push_back(&at->second);
    }
    places.points.resize(static_cast<Eigen::Index>(found.size()), map.space.points.cols());
    for (std::size_t k = 0; k < found.size(); ++k) {
        for (std::size_t d = 0; d < columns; ++d) {
            places.points(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(d)) =
                (*found[k])[d];
        }
    }
    return places;
}

Eigen::MatrixXd turned_onto(const Eigen::MatrixXd& points, const std::vector<Eigen::Index>& rows,
                            const Eigen::MatrixXd& target) {
    return transformed(procrustes(picked(points, rows), target, false), points);
}

bool tells_turn(std::size_t common, Eigen::Index dimensions) {
    return common >= static_cast<std::size_t>(dimensions) + 1;
}

Eigen::MatrixXd aligned_to_anchor(const MapTransition& map, const LiveMap& fresh) {
    const Eigen::MatrixXd& points = fresh.space.points;
    const SavedPlaces saved = saved_places(fresh, fresh.request.set->map_places);
    const bool tells = tells_turn(saved.rows.size(), points.cols());
    const bool lay_whole = static_cast<Eigen::Index>(saved.rows.size()) == points.rows();
    if (tells && lay_whole) return turned_onto(points, saved.rows, saved.points);
    if (map.anchor && map.anchor_points.cols() == points.cols()) {
        const Common common = common_rows(fresh, *map.anchor);
        return turned_onto(points, common.here, picked(map.anchor_points, common.there));
    }
    if (tells) return turned_onto(points, saved.rows, saved.points);
    if (!map.shown || map.to.cols() != points.cols()) return points;
    const Common common = common_rows(fresh, *map.shown);
    if (!tells_turn(common.here.size(), points.cols())) return points;
    return turned_onto(points, common.here, picked(map.to, common.there));
}

Eigen::MatrixXd ghosts_of(const LiveMap& map, const MapTransition& anchored) {
    const Eigen::MatrixXd& points = map.space.points;
    Eigen::MatrixXd ghosts = Eigen::MatrixXd::Constant(points.rows(), points.cols(),
                                                       std::numeric_limits<double>::quiet_NaN());
    if (!anchored.anchor || anchored.anchor_points.cols() != points.cols()) return ghosts;
    const Common common = common_rows(map, *anchored.anchor);
    for (std::size_t k = 0; k < common.here.size(); ++k) {
        ghosts.row(common.here[k]) = anchored.anchor_points.row(common.there[k]);
    }
    return ghosts;
}

}  // namespace tact
