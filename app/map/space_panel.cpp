// The perceptual space of the set, following the document.

#include <algorithm>
#include <cstdio>

#include "app/document/editing.h"
#include "app/document/pattern_looks.h"
#include "app/document/shown_side.h"
#include "app/map/map_follow.h"
#include "app/map/map_look.h"
#include "app/map/space_panel.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/space/space_view.h"

namespace tact {

namespace {

// The shown map's rows are those of the set it was computed for, which an edit may have changed:
// the row of each is found in the document by name.
std::vector<std::optional<std::size_t>> places_in_document(const App& app) {
    const auto& shown = app.map.shown->request.set->vibrations;
    const auto& now = app.document.set.vibrations;
    std::vector<std::optional<std::size_t>> places(shown.size());
    std::unordered_map<std::string_view, std::size_t> by_name;
    for (std::size_t k = 0; k < now.size(); ++k) by_name.emplace(now[k].name, k);
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const bool in_place = k < now.size() && now[k].name == shown[k].name;
        if (in_place) {
            places[k] = k;
        } else if (const auto found = by_name.find(shown[k].name); found != by_name.end()) {
            places[k] = found->second;
        }
    }
    return places;
}

void draw_overlay_choice(App& app) {
    if (app.document.set.ratings.empty()) return;
    constexpr const char* kOverlay = "Overlay ratings";
    flow_on(ImGui::GetFrameHeight() + ImGui::CalcTextSize(kOverlay).x, 1.5F * app.theme.gap_px);
    ImGui::Checkbox(kOverlay, &app.show_people);
    note_item(app.rects, "check:overlay ratings", app.show_people ? "on" : "off");
    draw_tooltip(app,
                 "Lays the map of what people said over the predicted one, turned and sized to "
                 "fit it best: rings, with a line from each to its prediction.");
}

void draw_controls(App& app) {
    const auto choose = [&app](const char* label, int dimensions) {
        if (draw_radio(app, label, app.dimensions == dimensions) && app.dimensions != dimensions) {
            app.dimensions = dimensions;
            document_changed(app);
        }
        note_item(app.rects, std::string("radio:") + label);
    };
    constexpr const char* kReset = "Reset view";
    choose("3-D", 3);
    ImGui::SameLine(0.0F, 1.5F * app.theme.gap_px);
    choose("2-D", 2);
    draw_overlay_choice(app);
    draw_map_look(app);
    // Every map begins unturned: the way back is of use only after that.
    if (app.camera == SpaceCamera{}) return;
    const float width = ImGui::CalcTextSize(kReset).x;
    flow_on(width, 2.0F * app.theme.gap_px);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({corner.x, corner.y + ImGui::GetStyle().FramePadding.y});
    if (link(app, "reset view", kReset)) app.camera = SpaceCamera{};
    note_item(app.rects, "link:reset view");
}

void draw_nothing(App& app, const Rect& area, MapState state) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (shown_side(app) != Side::both && shown_set(app).vibrations.size() < 2) {
        return draw_empty(list, app.theme, area, "Shown: " + shown_patterns_text(app),
                          "A map takes two. View > Intended and measured shows all of them.");
    }
    const std::size_t count = app.document.set.vibrations.size();
    if (state == MapState::too_large) {
        const double minutes = expected_map_s(app.document.set) / 60.0;
        const std::string time =
            minutes < 2.0 ? "minutes" : "about " + significant(minutes, 2) + " minutes";
        draw_empty(list, app.theme, area, std::to_string(count) + " patterns are many",
                   "A map of them takes " + time +
                       ". \"tactspace predict\" in a terminal is made for such sets.");
        ImGui::SetCursorScreenPos(
            {area.centre().x - 70.0F * app.theme.scale, area.centre().y + 60.0F * app.theme.scale});
        if (ImGui::Button("Compute anyway")) {
            app.compute_large_of = app.document_number;
            document_changed(app);
        }
        note_item(app.rects, "button:compute anyway");
        return;
    }
    if (count < 2) {
        draw_empty(list, app.theme, area, "The space needs at least two patterns",
                   "Add patterns on the left: their distance here is how different they feel.");
        return;
    }
    draw_empty(list, app.theme, area, "Computing the space",
               "The first map of a set takes a moment.");
}

std::string verdict_text(const PerceptualSpace& space, std::size_t patterns) {
    switch (space.verdict) {
        case MdsVerdict::constant:
            return "All pairs are equally alike: any map fits, so none is drawn.";
        case MdsVerdict::trivial:
            return std::to_string(patterns) +
                   " patterns always fit: stress says nothing, the picture little.";
        case MdsVerdict::colocated:
            return "Some different patterns fell onto one point.";
        case MdsVerdict::too_few:
        case MdsVerdict::fine:
            break;
    }
    return {};
}

SpaceScene scene_of(const App& app, const std::vector<std::string>& labels,
                    const std::vector<PatternLook>& looks, const Eigen::MatrixXd& points,
                    const std::vector<std::optional<std::size_t>>& places) {
    SpaceScene scene;
    scene.labels = labels;
    scene.looks = looks;
    scene.points = &points;
    scene.ghosts = &app.map.ghost;
    scene.ghost_opacity = ghost_opacity(app);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (places[k] == app.selection.current) scene.selected = k;
        if (places[k] && places[k] == app.selection.hovered_last) scene.pointed = k;
    }
    // The two of a cell of the matrix, whatever is selected.
    if (const auto& pair = app.selection.hovered_pair_last) {
        const auto row_of = [&places](std::size_t place) -> std::optional<std::size_t> {
            const auto found = std::ranges::find(places, std::optional(place));
            if (found == places.end()) return std::nullopt;
            return static_cast<std::size_t>(found - places.begin());
        };
        scene.selected = row_of(pair->first);
        scene.pointed = row_of(pair->second);
    }
    const Dissimilarity& pm = app.map.shown->prediction.pm;
    scene.dissimilarity = [&pm](std::size_t i, std::size_t j) { return pm(i, j); };
    scene.quantity = "PM";
    scene.stale = false;  // a drag would flicker; the title says what state the map is in
    return scene;
}

// A click selects; what else was done is for the frame.
SpacePaneAction taken(App& app, const SpaceAction& action,
                      const std::vector<std::optional<std::size_t>>& places) {
    SpacePaneAction done;
    if (action.hovered) done.hovered = places[*action.hovered];
    if (done.hovered) app.selection.hovered = done.hovered;
    if (action.double_clicked) done.double_clicked = places[*action.double_clicked];
    if (action.clicked && places[*action.clicked]) {
        select_only(app, *places[*action.clicked]);
        app.selection.scroll_to_current = true;
    }
    return done;
}

// Where every point is on the screen, for tests of the real window.
void note_points(App& app, const Rect& area, const std::vector<std::string>& labels,
                 const Eigen::MatrixXd& points) {
    if (app.rects.file.empty()) return;
    const SpaceFit placed = fit(points);
    for (std::size_t k = 0; k < labels.size(); ++k) {
        const Projected at =
            project(app.camera, placed, area, point_of(points, static_cast<Eigen::Index>(k)));
        note_rect(app.rects, "point:" + labels[k], at.at, at.at);
    }
}

}  // namespace

SpacePaneAction draw_space_panel(App& app, const MapMarks& marks) {
    if (!app.as_picture) draw_controls(app);
    const MapState state = map_state(app);
    const Rect area = rest_of_pane();
    if (area.empty()) return {};
    const bool has_points = app.map.shown && app.map.to.rows() >= 2 &&
                            app.map.shown->space.verdict != MdsVerdict::constant;
    const bool constant = app.map.shown && app.map.to.rows() >= 2 && !has_points;
    if (constant && state != MapState::too_large) {
        draw_empty(*ImGui::GetWindowDrawList(), app.theme, area, "No map",
                   verdict_text(app.map.shown->space, app.document.set.vibrations.size()));
        return {};
    }
    if (!has_points || state == MapState::none || state == MapState::too_large ||
        app.document.set.vibrations.size() < 2) {
        draw_nothing(app, area, state);
        return {};
    }
    const auto places = places_in_document(app);
    std::vector<std::string> labels;
    std::vector<PatternLook> looks;
    const auto& shown = app.map.shown->request.set->vibrations;
    for (std::size_t k = 0; k < shown.size(); ++k) {
        labels.push_back(shown[k].name);
        looks.push_back(places[k] ? look_of(app, *places[k])
                                  : PatternLook{app.theme.dim_text, true});
    }
    const Eigen::MatrixXd points = eased_points(app);
    const MapDecor decor = map_decor(app, marks, looks);
    SpaceScene scene = scene_of(app, labels, looks, points, places);
    decorate(decor, scene);
    const auto& people = marks.people;
    if (people) {
        scene.ghosts = &*people;
        scene.ghost_opacity = 1.0;
        note_rect(app.rects, "overlay", area.min, area.max);
    }
    const SpaceAction action = draw_space("space", app.theme, area, scene, app.camera);
    const SpacePaneAction done = taken(app, action, places);
    const auto pointed = action.hovered ? action.hovered : scene.pointed;
    if (scene.selected && pointed && *scene.selected != *pointed) {
        note_rect(app.rects, "map pair", area.min, area.max,
                  labels[*scene.selected] + "|" + labels[*pointed]);
    }
    if (!app.as_picture) draw_point_menu(app, action, places);
    draw_map_legend(app, area);
    note_points(app, area, labels, points);
    const std::string verdict = verdict_text(app.map.shown->space, shown.size());
    if (!verdict.empty()) {
        // At the top: the foot has the axes and what the mouse can do.
        draw_text(*ImGui::GetWindowDrawList(), app.theme.fonts.small, area.min, app.theme.warning,
                  shortened(app.theme.fonts.small, verdict, area.width()));
    }
    return done;
}

}  // namespace tact
