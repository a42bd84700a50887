#include "app/map/map.h"

#include <algorithm>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/map/parts.h"
#include "model/map/map_scale.h"
#include "model/map/procrustes.h"
#include "viz/drawing/plot.h"
#include "viz/space/space_view.h"

namespace tact {

namespace {

// Length of a PM. The map keeps only the order of PM, so the text says "about".
double length_of_pm(ShownMap& shown_map) {
    ShownScale& kept = shown_map.scale;
    const auto& map = shown_map.transition.shown;
    if (kept.of == map) return kept.length_of_one;
    // The points stand as in the map, or where they are held.
    const Eigen::MatrixXd& points = shown_map.transition.to;
    const bool is_held = shown_map.held && shown_map.held->points == points;
    kept = {map, is_held ? length_of_one(points, map->prediction.pm) : map->length_of_pm};
    return kept.length_of_one;
}

SpaceScene scene_of(const Ui& ui, const Workspace& work, ShownMap& shown_map,
                    const std::vector<std::string>& labels, const std::vector<PatternLook>& looks,
                    const Eigen::MatrixXd& points, const RowPlaces& places) {
    SpaceScene scene;
    scene.labels = labels;
    scene.looks = looks;
    scene.points = &points;
    scene.ghosts = &shown_map.transition.ghost;
    scene.ghost_opacity = ghost_opacity(ui, shown_map);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (places[k] == work.selection.current) scene.selected = k;
        if (places[k] && places[k] == work.selection.hovered_last) scene.pointed = k;
    }
    // The two of a cell of the matrix, whatever is selected.
    if (const auto& pair = work.selection.hovered_pair_last) {
        const auto row_of = [&places](std::size_t place) -> std::optional<std::size_t> {
            const auto found = std::ranges::find(places, std::optional(place));
            if (found == places.end()) return std::nullopt;
            return static_cast<std::size_t>(found - places.begin());
        };
        scene.selected = row_of(pair->first);
        scene.pointed = row_of(pair->second);
    }
    const Dissimilarity& pm = shown_map.transition.shown->prediction.pm;
    scene.dissimilarity = [&pm](std::size_t i, std::size_t j) { return pm(i, j); };
    scene.quantity = "PM";
    scene.length_of_one = length_of_pm(shown_map);
    scene.point_hint = shown_map.move_tool ? "drag it to where it should be" : kHoldHelp;
    scene.moves = shown_map.move_tool;
    return scene;
}

std::vector<Eigen::Vector3d> selected_points(const SpaceScene& scene,
                                             const Eigen::MatrixXd& points) {
    std::vector<Eigen::Vector3d> selected;
    if (scene.selected) {
        selected.push_back(point_of(points, static_cast<Eigen::Index>(*scene.selected)));
    }
    for (const std::size_t k : scene.selected_too) {
        selected.push_back(point_of(points, static_cast<Eigen::Index>(k)));
    }
    return selected;
}

// What a box or a lasso holds, instead of what was selected.
void select_enclosed(Workspace& work, const std::vector<std::size_t>& rows,
                     const RowPlaces& places) {
    bool is_first = true;
    for (const std::size_t row : rows) {
        if (!places[row]) continue;
        if (is_first) select_only(work, *places[row]);
        if (!is_first) work.selection.others.insert(*places[row]);
        is_first = false;
    }
    if (!is_first) work.selection.scroll_to_current = true;
}

// A click selects, with Ctrl too; what else was done is for the frame.
SpacePaneAction taken(Workspace& work, const SpaceAction& action, const RowPlaces& places) {
    SpacePaneAction done;
    if (action.hovered) done.hovered = places[*action.hovered];
    if (done.hovered) work.selection.hovered = done.hovered;
    if (action.pressed && places[*action.pressed]) {
        note_pressed(work, work.document.set.vibrations[*places[*action.pressed]]);
    }
    if (action.double_clicked) done.double_clicked = places[*action.double_clicked];
    if (action.clicked && places[*action.clicked]) {
        const std::size_t place = *places[*action.clicked];
        action.with_ctrl ? toggle_selected(work, place) : select_only(work, place);
        work.selection.scroll_to_current = true;
    }
    done.proposal_pressed = action.proposal_pressed;
    done.proposal_clicked = action.proposal_clicked;
    work.selection.on_track = action.on_track.has_value();
    if (action.moved && action.moved_to && places[*action.moved]) {
        done.moved = places[*action.moved];
        done.moved_to = *action.moved_to;
        done.move_ended = action.move_ended;
    }
    if (action.enclosed) select_enclosed(work, *action.enclosed, places);
    if (const auto& between = action.drawn_between) {
        if (places[between->a] && places[between->b]) {
            done.drawn_between = {*places[between->a], *places[between->b]};
        }
    }
    return done;
}

// Where every point is on the screen, for tests of the real window.
void note_points(Ui& ui, const ShownMap& shown_map, const Rect& area,
                 const std::vector<std::string>& labels, const Eigen::MatrixXd& points) {
    if (ui.rects.file.empty()) return;
    const SpaceProjection seen = projection(shown_map.camera, fit(points), area);
    for (std::size_t k = 0; k < labels.size(); ++k) {
        if (!points.row(static_cast<Eigen::Index>(k)).allFinite()) continue;  // hidden
        const ImVec2 at = seen(point_of(points, static_cast<Eigen::Index>(k))).at;
        note_rect(ui.rects, "point:" + labels[k], at, at);
    }
    if (is_moving(ui, shown_map)) note_rect(ui.rects, "points move", area.min, area.max);
}

// The two that the map joins by a line.
void note_pair(Ui& ui, const Rect& area, const SpaceScene& scene, const SpaceAction& action,
               const std::vector<std::string>& labels) {
    const auto pointed = action.hovered ? action.hovered : scene.pointed;
    if (!scene.selected || !pointed || *scene.selected == *pointed) return;
    note_rect(ui.rects, "map pair", area.min, area.max,
              labels[*scene.selected] + "|" + labels[*pointed]);
}

void note_maybes(Ui& ui, const ShownMap& shown_map, const Rect& area, const MapMaybes& maybes,
                 const Eigen::MatrixXd& points) {
    if (ui.rects.file.empty()) return;
    const SpaceProjection seen = projection(shown_map.camera, fit(points), area);
    const auto note = [&](const char* what, const Eigen::MatrixXd& places,
                          const std::vector<std::string>& words) {
        for (Eigen::Index k = 0; k < places.rows(); ++k) {
            const ImVec2 at = seen(point_of(places, k)).at;
            const auto number = static_cast<std::size_t>(k);
            note_rect(ui.rects, what + std::to_string(k + 1), at, at,
                      number < words.size() ? words[number] : "");
        }
    };
    note("proposal:", maybes.proposals, maybes.proposal_names);
    note("track:", maybes.track, maybes.track_words);
}

}  // namespace

SpacePaneAction draw_space_scene(Ui& ui, Workspace& work, ShownMap& shown_map,
                                 const MapMarks& marks, const RowPlaces& places, const Rect& area) {
    std::vector<std::string> labels;
    std::vector<std::string> words;  // as they stand in the map
    std::vector<PatternLook> looks;
    const auto& shown = shown_map.transition.shown->request.set->vibrations;
    for (std::size_t k = 0; k < shown.size(); ++k) {
        labels.push_back(shown[k].name);
        const bool unfelt = work.selection.unfelt.contains(shown[k].name);
        words.push_back(unfelt ? shown[k].name + " (not felt)" : shown[k].name);
        looks.push_back(places[k] ? look_of(ui, work, *places[k])
                                  : PatternLook{ui.theme.dim_text, true});
    }
    Eigen::MatrixXd points = eased_points(ui, shown_map);
    if (marks.hidden) {
        points.row(static_cast<Eigen::Index>(*marks.hidden))
            .setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    const MapDecor decor = map_decor(ui, shown_map, marks, looks);
    SpaceScene scene = scene_of(ui, work, shown_map, words, looks, points, places);
    const std::vector<std::size_t> selected_too = rows_selected_too(work, places);
    scene.selected_too = selected_too;
    scene.stale = looks_stale(ui, "space", shown_map.transition.shown,
                              map_state(work, shown_map) == MapState::stale);
    decorate(decor, scene);
    const auto& people = marks.people;
    if (people) {
        scene.ghosts = &*people;
        scene.ghost_opacity = 1.0;
        note_rect(ui.rects, "overlay", area.min, area.max, marks.people_text);
    }
    if (std::exchange(shown_map.frame_asked, false)) {
        frame_points(shown_map.camera, fit(points), area, selected_points(scene, points));
    }
    scene.takes_place = marks.takes_place;
    if (marks.hidden && scene.selected == marks.hidden) scene.selected.reset();
    if (marks.hidden && scene.pointed == marks.hidden) scene.pointed.reset();
    const SpaceAction action = draw_space("space", ui.theme, area, scene, shown_map.camera);
    SpacePaneAction done = taken(work, action, places);
    done.placed_at = action.placed_at;
    note_pair(ui, area, scene, action, labels);
    if (action.right_clicked) done.menu_asked = places[*action.right_clicked];
    note_points(ui, shown_map, area, labels, points);
    note_maybes(ui, shown_map, area, marks.maybes, points);
    return done;
}

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
