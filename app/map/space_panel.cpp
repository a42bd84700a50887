#include "app/map/map.h"
#include "app/map/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/progress/progress.h"
#include "app/ui/widgets.h"
#include "model/set/set_told_apart.h"
#include "model/subset/confusable.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

void draw_overlay_choice(Ui& ui, const Workspace& work, ShownMap& shown_map) {
    if (work.document.set.ratings.empty()) return;
    constexpr const char* kOverlay = "Overlay ratings";
    flow_on(check_width(ui.theme, kOverlay), 1.5F * ui.theme.gap_px);
    check(ui,
          {.id = "check:overlay ratings",
           .label = kOverlay,
           .tip = "Lays the map of what people said over the predicted one, turned and sized to "
                  "fit it best: rings, with a line from each to its prediction."},
          shown_map.show_people);
}

void draw_move_tool(Ui& ui, ShownMap& shown_map) {
    flow_on(chip_width(ui, "Move"), 1.5F * ui.theme.gap_px);
    bool& on = shown_map.move_tool;
    const Item item{
        .id = "tool:move",
        .label = "Move",
        .tip =
            "M: a point that is dragged is put there: its pattern is searched. Without the "
            "tool Alt and a drag do the same, where the window manager leaves Alt free.",
        .value = on ? "on" : "off"};
    if (toggle(ui, item, on)) on = !on;
}

void draw_controls(Ui& ui, Workspace& work, ShownMap& shown_map) {
    constexpr std::array kDimensions{Choice{3, "3-D"}, Choice{2, "2-D"}};
    constexpr const char* kReset = "Reset view";
    if (draw_segments(ui, kDimensions, shown_map.dimensions)) document_changed(work);
    draw_overlay_choice(ui, work, shown_map);
    draw_map_look(ui, shown_map);
    draw_move_tool(ui, shown_map);
    // Every map begins unturned: the way back is of use only after that.
    if (shown_map.camera == SpaceCamera{}) return;
    const float width = ImGui::CalcTextSize(kReset).x;
    flow_on(width, 2.0F * ui.theme.gap_px);
    if (row_link(ui, {.id = "link:reset view", .label = kReset})) shown_map.camera = SpaceCamera{};
}

// How far the exact map is, under the pane's title.
void draw_progress_line(Ui& ui, float share) {
    const Theme& theme = ui.theme;
    const ImVec2 low = ImGui::GetCursorScreenPos() - ImVec2{0.0F, ImGui::GetStyle().ItemSpacing.y};
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = std::max(2.0F, std::round(2.0F * theme.scale));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, low + ImVec2{width, height}, faded(theme.dim_text, 0.25F));
    const float done = width * std::clamp(share, 0.0F, 1.0F);
    list.AddRectFilled(low, low + ImVec2{done, height}, theme.accent);
    note_rect(ui.rects, "map:progress", low, low + ImVec2{width, height});
}

// The pattern that takes most of the time, if there is one, and what is left without it.
struct Dominant {
    std::size_t row = 0;
    std::string words;
};

std::optional<Dominant> dominant(const PatternSet& set) {
    const auto& all = set.vibrations;
    const auto longest = std::ranges::max_element(all, {}, own_duration_s);
    if (longest == all.end()) return std::nullopt;
    const auto row = static_cast<std::size_t>(longest - all.begin());
    const double rest_s = expected_map_s(set, row);
    if (rest_s > 0.5 * expected_map_s(set)) return std::nullopt;
    return Dominant{row, longest->name + " lasts " + significant(own_duration_s(*longest), 2) +
                             " s: without it, " + estimate_text(rest_s) + "."};
}

// Behind the words on it, at the cursor.
void draw_way_out(Ui& ui, Workspace& work, const Dominant& one) {
    constexpr const char* kTakeOut = "Take it out of the set";
    flow_on(ImGui::CalcTextSize(kTakeOut).x, ui.theme.gap_px);
    const Item item{.id = "link:take out", .label = kTakeOut, .tip = "Ctrl+Z brings it back."};
    if (!link(ui, item)) return;
    ui.waiting.emplace_back([&ui, &work, row = one.row] {
        select_only(work, row);
        remove_selected(ui, work);
    });
}

// What a preview is worth where nothing better comes unasked, and what the exact map would take.
// The height that this takes.
float draw_waiting(Ui& ui, Workspace& work, ShownMap& shown_map) {
    if (ui.as_picture || map_state(work, shown_map) != MapState::preview) return 0.0F;
    const PatternSet& set = work.document.set;
    const bool waits = exact_waits(work, shown_map);
    const std::string words =
        preview_words(*shown_map.transition.shown, waits, expected_map_s(set));
    if (words.empty()) return 0.0F;
    const float top = ImGui::GetCursorPosY();
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, {.id = "map:preview", .text = words});
    ImGui::PopTextWrapPos();
    if (!waits) return ImGui::GetCursorPosY() - top + ui.theme.gap_px;
    constexpr const char* kCompute = "Compute it";
    flow_on(ImGui::CalcTextSize(kCompute).x, ui.theme.gap_px);
    if (link(ui, {.id = "link:compute exact", .label = kCompute})) compute_exact(work, shown_map);
    if (const auto one = dominant(set)) {
        dim_text(ui, one->words);
        draw_way_out(ui, work, *one);
    }
    return ImGui::GetCursorPosY() - top + ui.theme.gap_px;
}

// The patterns are there at once, in a ring, each beside what is most like it, from which they
// drift to their places.
void draw_waiting(Ui& ui, const Workspace& work, ShownMap& shown_map, const Rect& area) {
    follow_ring(work, shown_map);
    const std::size_t count = work.document.set.vibrations.size();
    ui.ages.try_emplace(kWaitingRing, ShownAge{nullptr, false, ui.time_s});
    const float radius = 0.36F * std::min(area.width(), area.height());
    const auto many = static_cast<float>(std::max<std::size_t>(count, 1));
    const float apart_px = 2.0F * std::numbers::pi_v<float> * radius / many;
    const float dot_px = std::clamp(0.4F * apart_px, 1.0F, 7.0F * ui.theme.scale);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t k = 0; k < count; ++k) {
        const RingDirection to = ring_direction(shown_map.ring, k, count);
        const ImVec2 at = area.centre() + ImVec2{radius * static_cast<float>(to.right),
                                                 -radius * static_cast<float>(to.up)};
        draw_disc(list, ui.theme, at, dot_px, faded(look_of(ui, work, k).colour, 0.55F));
    }
    const float half = 0.62F * radius;
    const Rect words{area.centre() - ImVec2{half, half}, area.centre() + ImVec2{half, half}};
    draw_empty(list, ui.theme, words, "Computing the space", "A preview comes first.");
    note_rect(ui.rects, "map:waiting", words.min, words.max, std::to_string(count));
}

void draw_nothing(Ui& ui, Workspace& work, ShownMap& shown_map, const Rect& area, MapState state) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (shown_side(work) != Side::both && shown_set(work).vibrations.size() < 2) {
        return draw_empty(
            list, ui.theme, area, "Shown: " + shown_patterns_text(work),
            "A map takes two: View > Intended and measured patterns brings the others.");
    }
    const std::size_t count = work.document.set.vibrations.size();
    if (state == MapState::too_large) {
        const auto one = dominant(work.document.set);
        draw_empty(list, ui.theme, area,
                   "This map takes " + estimate_text(expected_map_s(work.document.set)),
                   patterns_text(count) + "." + (one ? " " + one->words : ""));
        ImGui::SetCursorScreenPos(
            {area.centre().x - 70.0F * ui.theme.scale, area.centre().y + 60.0F * ui.theme.scale});
        if (primary_button(ui, {.id = "button:compute anyway", .label = "Compute anyway"})) {
            compute_exact(work, shown_map);
        }
        if (one) draw_way_out(ui, work, *one);
        return;
    }
    if (count < 2) {
        draw_empty(list, ui.theme, area, "The space needs at least two patterns",
                   "Add patterns on the left: their distance here is how different they feel.");
        return;
    }
    draw_waiting(ui, work, shown_map, area);
}

// At the top: the foot has the axes and what the mouse can do. How high it is.
float draw_remark(const Ui& ui, const Rect& area, ImU32 colour, const std::string& text) {
    if (text.empty()) return 0.0F;
    const ImFont* font = ui.theme.fonts.small;
    draw_text(*ImGui::GetWindowDrawList(), font, area.min, colour,
              shortened(font, text, area.width()));
    return text_size(font, text).y;
}

// A number in the largest type, and beside it what it is. Where the next one may begin.
float draw_headline_number(const Ui& ui, ImVec2 corner, ImU32 ink, const std::string& number,
                           const std::string& what) {
    const Fonts& fonts = ui.theme.fonts;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_text(list, fonts.headline, corner, ink, number);
    const float x = corner.x + text_size(fonts.headline, number).x + ui.theme.gap_px;
    const float lower = 0.8F * (text_size(fonts.headline, "0").y - text_size(fonts.small, "0").y);
    draw_text(list, fonts.small, {x, corner.y + lower}, ui.theme.dim_text, what);
    return x + text_size(fonts.small, what).x;
}

const ShownVerdicts& verdicts_of(ShownMap& shown_map) {
    constexpr std::size_t kMost = 100;
    ShownVerdicts& known = shown_map.verdicts;
    if (known.of == shown_map.transition.shown) return known;
    known = {shown_map.transition.shown};
    const PatternSet& set = *known.of->request.set;
    known.is_known = set.vibrations.size() <= kMost;
    for (std::size_t i = 0; known.is_known && i < set.vibrations.size(); ++i) {
        for (std::size_t j = i + 1; j < set.vibrations.size(); ++j) {
            const PairVerdict verdict = pair_verdict(set, i, j);
            known.same += verdict == PairVerdict::same;
            known.close += verdict == PairVerdict::close;
        }
    }
    return known;
}

// What the numbers come to, at the right end of their line where there is room.
void draw_verdict(Ui& ui, ShownMap& shown_map, const Rect& area, float used_px) {
    const ShownVerdicts& verdicts = verdicts_of(shown_map);
    if (!verdicts.is_known) return;
    std::string words = "No pair within two felt steps";
    ImU32 ink = ui.theme.dim_text;
    if (verdicts.close > 0) {
        words = counted(verdicts.close, "pair", "pairs") + " may be confused";
        ink = ui.theme.warning;
    }
    if (verdicts.same > 0) {
        words = counted(verdicts.same, "pair", "pairs") + " the same" +
                (verdicts.close > 0 ? ", " + words : "");
        ink = ui.theme.error;
    }
    const Fonts& fonts = ui.theme.fonts;
    const ImVec2 size = text_size(fonts.small, words);
    const ImVec2 corner{area.max.x - size.x,
                        area.min.y + 0.8F * (text_size(fonts.headline, "0").y - size.y)};
    if (corner.x < used_px + 3.0F * ui.theme.gap_px) return;
    draw_text(*ImGui::GetWindowDrawList(), fonts.small, corner, ink, words);
    note_rect(ui.rects, "map:verdict", corner, corner + size, words);
}

const ShownTold& told_of(const Workspace& work, ShownMap& shown_map) {
    const auto& map = shown_map.transition.shown;
    ShownTold& known = shown_map.told;
    if (known.of == map && known.revision == work.revision) return known;
    known = {map, work.revision, {}, {}};
    // Trials are of the patterns as they are meant.
    const PatternSet& set = work.document.set;
    if (set.told_apart.empty() || map->request.rendered_by) return known;
    known.words = told_apart_words(set, map->prediction.pm, map->sorted_pm.front());
    known.help = told_apart_help(set, map->prediction.pm);
    return known;
}

// Beside the verdict by PM, and no part of it: what one person told apart. The height it takes.
float draw_told_apart(Ui& ui, const Workspace& work, ShownMap& shown_map, const Rect& area) {
    const ShownTold& told = told_of(work, shown_map);
    if (told.words.empty()) return 0.0F;
    const ImFont* font = ui.theme.fonts.small;
    const std::string words = shortened(font, told.words, area.width());
    const ImVec2 size = text_size(font, words);
    draw_text(*ImGui::GetWindowDrawList(), font, area.min, ui.theme.dim_text, words);
    ImGui::SetCursorScreenPos(area.min);
    ImGui::Dummy(size);
    say_of_last_item(ui, {.id = "map:told apart", .text = told.words, .tip = told.help});
    return size.y + 0.5F * ui.theme.gap_px;
}

// How well the map fits, and its weakest pair: what one looks for first. The height that it takes;
// none where there is no room for it.
float draw_headline(Ui& ui, Workspace& work, ShownMap& shown_map, const Rect& area,
                    const RowPlaces& places) {
    const LiveMap& map = *shown_map.transition.shown;
    const Theme& theme = ui.theme;
    const float height = text_size(theme.fonts.headline, "0").y + theme.gap_px;
    const float least_px = 380.0F * theme.scale;
    if (area.width() < least_px || area.height() < 8.0F * height || map.sorted_pm.empty()) return 0;
    const MapState state = map_state(work, shown_map);
    const ImU32 ink = state == MapState::exact ? theme.text : theme.dim_text;
    float x = area.min.x;
    if (map.space.verdict != MdsVerdict::trivial) {
        // One of a preview would be read as that of the map.
        std::string stress = "preview";
        std::string what = "stress-1 follows";
        if (state != MapState::preview) {
            stress = with_decimals(map.space.stress1, 3);
            what = "stress-1, " + fit_label(map.space);
        } else if (exact_waits(work, shown_map)) {
            what = "has no stress-1";
        }
        note_rect(ui.rects, "map:stress", area.min, area.min, stress);
        x = draw_headline_number(ui, area.min, ink, stress, what) + 3.0F * theme.gap_px;
    }
    const auto [a, b] = pair_at(map.prediction.pm.size, map.closest);
    const auto& all = map.request.set->vibrations;
    const std::string pm = grouped(map.sorted_pm.front());
    const float used = x + text_size(theme.fonts.headline, pm).x + theme.gap_px;
    const std::string preview = state == MapState::preview ? ", preview" : "";
    const std::string what = shortened(
        theme.fonts.small, "PM, closest pair " + all[a].name + " \u2013 " + all[b].name + preview,
        std::max(0.0F, area.max.x - used));
    const ImVec2 corner{x, area.min.y};
    const float right = draw_headline_number(ui, corner, ink, pm, what);
    draw_verdict(ui, shown_map, area, right);
    ImGui::SetCursorScreenPos(corner);
    const bool pressed = ImGui::InvisibleButton("closest pair", {right - x, height - theme.gap_px});
    note_item(ui.rects, "map:closest", all[a].name + "|" + all[b].name);
    if (places[a] && places[b]) {
        if (ImGui::IsItemHovered()) work.selection.hovered_pair = {*places[a], *places[b]};
        if (pressed) choose_pair(work, *places[a], *places[b]);
    }
    draw_tooltip(ui, "PM of the two that people will confuse first. A click chooses them.");
    const float told = draw_told_apart(
        ui, work, shown_map, {{area.min.x, area.min.y + height - 0.5F * theme.gap_px}, area.max});
    ImGui::SetCursorScreenPos({area.min.x, area.min.y + height + told});
    return height + told;
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
            return "Degenerate: some different patterns fell onto one point.";
        case MdsVerdict::fine:
        case MdsVerdict::too_few:
            break;
    }
    if (space.is_interval) {
        return "Groups fall together in the map by order alone: this one goes by the size of "
               "differences.";
    }
    // Where the patterns are merely few, the headline's word says it.
    const bool has_collapsed =
        space.is_degenerate && space.points.rows() > 2 * space.points.cols() + 1;
    return has_collapsed ? "Degenerate: groups of patterns nearly fell together." : "";
}

SpacePaneAction draw_space_panel(Ui& ui, Workspace& work, ShownMap& shown_map,
                                 const MapMarks& marks) {
    if (shown_map.progress && !ui.as_picture) draw_progress_line(ui, shown_map.progress->share);
    if (!ui.as_picture) draw_controls(ui, work, shown_map);
    const MapState state = map_state(work, shown_map);
    const bool failed =
        state != MapState::too_large && draw_failure(ui, "space", shown_map.full_job.failure());
    shown_map.has_headline = false;
    Rect area = rest_of_pane();
    if (area.empty()) return {};
    // Nothing is shown of another set.
    const bool has_map = shown_map.transition.shown && shown_map.transition.to.rows() >= 2 &&
                         !shows_another_set(work, shown_map);
    const bool constant =
        has_map && shown_map.transition.shown->space.verdict == MdsVerdict::constant;
    const bool has_points = has_map && !constant;
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
    area.min.y += draw_waiting(ui, work, shown_map);
    if (area.empty()) return {};
    const RowPlaces places = places_in_document(work, shown_map);
    const float headline_px = draw_headline(ui, work, shown_map, area, places);
    shown_map.has_headline = headline_px > 0.0F;
    area.min.y += headline_px;
    // Names of points that lie high do not run into it.
    area.min.y += draw_remark(ui, area, ui.theme.warning,
                              verdict_text(shown_map.transition.shown->space, places.size()));
    if (area.empty()) return {};
    if (!ui.as_picture) shown_map.pane = area;
    const SpacePaneAction done = draw_space_scene(ui, work, shown_map, marks, places, area);
    if (marks.looks.empty()) draw_map_legend(ui, shown_map, area);
    std::string ghosts_text = marks.people_text;
    if (!marks.people && shows_unshifted(shown_map.transition)) {
        ghosts_text = kUnshiftedText;
        note_rect(ui.rects, "unshifted", area.min, area.max);
    }
    if (ghosts_text.empty() && holds_places(work, shown_map)) {
        ghosts_text = "The other points stay where they were until the next edit.";
        note_rect(ui.rects, "map:held", area.min, area.max);
    }
    // This one comes and goes during a drag, which must not move the map.
    draw_remark(ui, area, ui.theme.dim_text, ghosts_text);
    return done;
}

}  // namespace tact
