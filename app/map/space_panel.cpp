// The perceptual space of the set, following the document.

#include <algorithm>
#include <cstdio>
#include <limits>
#include <utility>

#include "app/document/editing.h"
#include "app/document/pattern_looks.h"
#include "app/document/pressing.h"
#include "app/document/shown_side.h"
#include "app/map/map_follow.h"
#include "app/map/map_look.h"
#include "app/map/space_panel.h"
#include "app/map/unshifted_map.h"
#include "app/progress/failure.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/space/space_view.h"

namespace tact {

namespace {

// The shown map's rows are those of the set it was computed for, which an edit may have changed:
// the row of each is found in the document by name.
std::vector<std::optional<std::size_t>> places_in_document(const Workspace& work,
                                                           const ShownMap& shown_map) {
    const auto& shown = shown_map.transition.shown->request.set->vibrations;
    const auto& now = work.document.set.vibrations;
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

void draw_overlay_choice(Ui& ui, const Workspace& work, ShownMap& shown_map) {
    if (work.document.set.ratings.empty()) return;
    constexpr const char* kOverlay = "Overlay ratings";
    flow_on(ImGui::GetFrameHeight() + ImGui::CalcTextSize(kOverlay).x, 1.5F * ui.theme.gap_px);
    ImGui::Checkbox(kOverlay, &shown_map.show_people);
    note_item(ui.rects, "check:overlay ratings", shown_map.show_people ? "on" : "off");
    draw_tooltip(ui,
                 "Lays the map of what people said over the predicted one, turned and sized to "
                 "fit it best: rings, with a line from each to its prediction.");
}

void draw_move_tool(Ui& ui, ShownMap& shown_map) {
    const bool beside = flow_on(chip_width(ui, "Move"), 1.5F * ui.theme.gap_px);
    if (beside) {  // the link before stands lower
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        ImGui::SetCursorScreenPos({corner.x, corner.y - ImGui::GetStyle().FramePadding.y});
    }
    if (draw_switch(ui, "move tool", "Move", shown_map.move_tool)) {
        shown_map.move_tool = !shown_map.move_tool;
    }
    note_item(ui.rects, "tool:move", shown_map.move_tool ? "on" : "off");
    draw_tooltip(ui,
                 "A point that is dragged is put there: its pattern is searched. Without the tool "
                 "Alt and a drag do the same.");
}

void draw_controls(Ui& ui, Workspace& work, ShownMap& shown_map) {
    const auto choose = [&](const char* label, int dimensions) {
        if (draw_radio(ui, label, shown_map.dimensions == dimensions) &&
            shown_map.dimensions != dimensions) {
            shown_map.dimensions = dimensions;
            document_changed(work);
        }
        note_item(ui.rects, std::string("radio:") + label);
    };
    constexpr const char* kReset = "Reset view";
    choose("3-D", 3);
    ImGui::SameLine(0.0F, 1.5F * ui.theme.gap_px);
    choose("2-D", 2);
    draw_overlay_choice(ui, work, shown_map);
    draw_map_look(ui, shown_map);
    draw_move_tool(ui, shown_map);
    // Every map begins unturned: the way back is of use only after that.
    if (shown_map.camera == SpaceCamera{}) return;
    const float width = ImGui::CalcTextSize(kReset).x;
    flow_on(width, 2.0F * ui.theme.gap_px);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({corner.x, corner.y + ImGui::GetStyle().FramePadding.y});
    if (link(ui, "reset view", kReset)) shown_map.camera = SpaceCamera{};
    note_item(ui.rects, "link:reset view");
}

void draw_nothing(Ui& ui, Workspace& work, ShownMap& shown_map, const Rect& area, MapState state) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (shown_side(work) != Side::both && shown_set(work).vibrations.size() < 2) {
        return draw_empty(list, ui.theme, area, "Shown: " + shown_patterns_text(work),
                          "A map takes two. View > Intended and measured shows all of them.");
    }
    const std::size_t count = work.document.set.vibrations.size();
    if (state == MapState::too_large) {
        const double minutes = expected_map_s(work.document.set) / 60.0;
        const std::string time =
            minutes < 2.0 ? "minutes" : "about " + significant(minutes, 2) + " minutes";
        draw_empty(list, ui.theme, area, std::to_string(count) + " patterns are many",
                   "A map of them takes " + time +
                       ". \"tactspace predict\" in a terminal is made for such sets.");
        ImGui::SetCursorScreenPos(
            {area.centre().x - 70.0F * ui.theme.scale, area.centre().y + 60.0F * ui.theme.scale});
        if (ImGui::Button("Compute anyway")) {
            shown_map.compute_large_of = work.document_number;
            document_changed(work);
        }
        note_item(ui.rects, "button:compute anyway");
        return;
    }
    if (count < 2) {
        draw_empty(list, ui.theme, area, "The space needs at least two patterns",
                   "Add patterns on the left: their distance here is how different they feel.");
        return;
    }
    draw_empty(list, ui.theme, area, "Computing the space",
               "The first map of a set takes a moment.");
}

SpaceScene scene_of(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                    const std::vector<std::string>& labels, const std::vector<PatternLook>& looks,
                    const Eigen::MatrixXd& points,
                    const std::vector<std::optional<std::size_t>>& places) {
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
    scene.point_hint = shown_map.move_tool ? "drag it to where it should be" : kHoldHelp;
    scene.moves = shown_map.move_tool;
    return scene;
}

std::vector<std::size_t> rows_selected_too(const Workspace& work,
                                           const std::vector<std::optional<std::size_t>>& places) {
    std::vector<std::size_t> rows;
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (places[k] && work.selection.others.contains(*places[k])) rows.push_back(k);
    }
    return rows;
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
                     const std::vector<std::optional<std::size_t>>& places) {
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
SpacePaneAction taken(Workspace& work, const SpaceAction& action,
                      const std::vector<std::optional<std::size_t>>& places) {
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

// At the top: the foot has the axes and what the mouse can do.
void draw_remarks(const Ui& ui, const Rect& area, const std::string& verdict,
                  const std::string& ghosts) {
    ImVec2 corner = area.min;
    const auto line = [&](ImU32 colour, const std::string& text) {
        if (text.empty()) return;
        const ImFont* font = ui.theme.fonts.small;
        draw_text(*ImGui::GetWindowDrawList(), font, corner, colour,
                  shortened(font, text, area.width()));
        corner.y += text_size(font, text).y;
    };
    line(ui.theme.warning, verdict);
    line(ui.theme.dim_text, ghosts);
}

// A number in the large role, and beside it what it is. Where the next one may begin.
float draw_headline_number(const Ui& ui, ImVec2 corner, ImU32 ink, const std::string& number,
                           const std::string& what) {
    const Fonts& fonts = ui.theme.fonts;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_text(list, fonts.large, corner, ink, number);
    const float x = corner.x + text_size(fonts.large, number).x + ui.theme.gap_px;
    const float lower = 0.8F * (text_size(fonts.large, "0").y - text_size(fonts.small, "0").y);
    draw_text(list, fonts.small, {x, corner.y + lower}, ui.theme.dim_text, what);
    return x + text_size(fonts.small, what).x;
}

// How well the map fits, and its weakest pair: what one looks for first. The height that it takes;
// none where there is no room for it.
float draw_headline(Ui& ui, Workspace& work, const ShownMap& shown_map, const Rect& area,
                    const std::vector<std::optional<std::size_t>>& places) {
    const LiveMap& map = *shown_map.transition.shown;
    const Theme& theme = ui.theme;
    const float height = text_size(theme.fonts.large, "0").y + theme.gap_px;
    const float least_px = 380.0F * theme.scale;
    if (area.width() < least_px || area.height() < 8.0F * height || map.sorted_pm.empty()) return 0;
    const MapState state = map_state(work, shown_map);
    const ImU32 ink = state == MapState::exact ? theme.text : theme.dim_text;
    float x = area.min.x;
    if (map.space.verdict != MdsVerdict::trivial) {
        char stress[16];
        std::snprintf(stress, sizeof stress, "%.3f", map.space.stress1);
        x = draw_headline_number(ui, area.min, ink, stress,
                                 "stress-1, " + stress_label(map.space.stress1)) +
            3.0F * theme.gap_px;
    }
    const auto [a, b] = pair_at(map.prediction.pm.size, map.closest);
    const auto& all = map.request.set->vibrations;
    const std::string pm = significant(map.sorted_pm.front());
    const float used = x + text_size(theme.fonts.large, pm).x + theme.gap_px;
    const std::string preview = state == MapState::preview ? ", preview" : "";
    const std::string what = shortened(
        theme.fonts.small, "PM, closest pair " + all[a].name + " \u2013 " + all[b].name + preview,
        std::max(0.0F, area.max.x - used));
    const ImVec2 corner{x, area.min.y};
    const float right = draw_headline_number(ui, corner, ink, pm, what);
    ImGui::SetCursorScreenPos(corner);
    const bool pressed = ImGui::InvisibleButton("closest pair", {right - x, height - theme.gap_px});
    note_item(ui.rects, "map:closest", all[a].name + "|" + all[b].name);
    if (places[a] && places[b]) {
        if (ImGui::IsItemHovered()) work.selection.hovered_pair = {*places[a], *places[b]};
        if (pressed) choose_pair(work, *places[a], *places[b]);
    }
    draw_tooltip(ui, "PM of the two that people will confuse first. A click chooses them.");
    ImGui::SetCursorScreenPos({area.min.x, area.min.y + height});
    return height;
}

}  // namespace

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

SpacePaneAction draw_space_panel(Ui& ui, Workspace& work, ShownMap& shown_map,
                                 const MapMarks& marks) {
    if (!ui.as_picture) draw_controls(ui, work, shown_map);
    const MapState state = map_state(work, shown_map);
    const bool failed =
        state != MapState::too_large && draw_failure(ui, "space", failure_of(shown_map.full_job));
    shown_map.has_headline = false;
    Rect area = rest_of_pane();
    if (area.empty()) return {};
    const bool has_points = shown_map.transition.shown && shown_map.transition.to.rows() >= 2 &&
                            shown_map.transition.shown->space.verdict != MdsVerdict::constant;
    const bool constant =
        shown_map.transition.shown && shown_map.transition.to.rows() >= 2 && !has_points;
    if (constant && state != MapState::too_large) {
        draw_empty(
            *ImGui::GetWindowDrawList(), ui.theme, area, "No map",
            verdict_text(shown_map.transition.shown->space, work.document.set.vibrations.size()));
        return {};
    }
    if (!has_points || state == MapState::none || state == MapState::too_large ||
        work.document.set.vibrations.size() < 2) {
        if (!failed) draw_nothing(ui, work, shown_map, area, state);
        return {};
    }
    const auto places = places_in_document(work, shown_map);
    // Not one of its names is in the list: it looks stale at once, and its numbers go.
    const bool is_of_another =
        std::ranges::none_of(places, [](const auto& at) { return at.has_value(); });
    const float headline_px =
        is_of_another ? 0.0F : draw_headline(ui, work, shown_map, area, places);
    shown_map.has_headline = headline_px > 0.0F;
    area.min.y += headline_px;
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
    scene.stale = looks_stale(ui, "space", shown_map.transition.shown, state == MapState::stale) ||
                  is_of_another;
    decorate(decor, scene);
    const auto& people = marks.people;
    if (people) {
        scene.ghosts = &*people;
        scene.ghost_opacity = 1.0;
        note_rect(ui.rects, "overlay", area.min, area.max, marks.people_text);
    }
    std::string ghosts_text = marks.people_text;
    if (!people && shows_unshifted(shown_map.transition)) {
        ghosts_text = kUnshiftedText;
        note_rect(ui.rects, "unshifted", area.min, area.max);
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
    draw_map_legend(ui, shown_map, area);
    note_points(ui, shown_map, area, labels, points);
    note_maybes(ui, shown_map, area, marks.maybes, points);
    draw_remarks(ui, area, verdict_text(shown_map.transition.shown->space, shown.size()),
                 ghosts_text);
    return done;
}

}  // namespace tact
