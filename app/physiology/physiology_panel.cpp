// The middle column: what the fingertip and the nerves make of the selected vibration, stage by
// stage, and where another one parts from it.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

#include "app/document/editing.h"
#include "app/document/pattern_looks.h"
#include "app/physiology/physiology_panel.h"
#include "app/physiology/receptor_stage.h"
#include "app/physiology/stage_pair.h"
#include "app/physiology/stage_strip.h"
#include "app/physiology/stage_views.h"
#include "app/progress/failure.h"
#include "app/timeline/time_rows.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kLabelColumnPx = 96.0F;

// Height of each stage in the overview, in units. Signals have what the pictures leave.
constexpr std::array<float, kStages.size()> kUnits{1.0F, 2.1F, 1.8F, 3.2F, 2.1F,
                                                   2.2F, 1.7F, 0.9F, 1.1F};
constexpr std::array<float, kStages.size()> kPairUnits{0.9F, 2.1F, 3.3F, 3.2F, 3.0F,
                                                       2.2F, 3.0F, 1.1F, 1.1F};
constexpr float kLowestUnitPx = 28.0F;  // below, the column scrolls
constexpr float kLowestPairUnitPx = 36.0F;
constexpr float kScrolledPairUnitPx = 72.0F;  // once it scrolls, lanes are as high as is good

// What a picture needs, and what it makes good use of, in heights of small text.
struct PictureHeight {
    float least;
    float most;
};

std::optional<PictureHeight> picture_height(Stage stage, bool is_pair) {
    // Of two, with a line of words between them; the choice of networks stands above both.
    if (stage == Stage::spectrum) {
        return is_pair ? PictureHeight{12.6F, 14.0F} : PictureHeight{5.6F, 14.0F};
    }
    if (stage == Stage::receptors) {
        return is_pair ? PictureHeight{10.8F, 14.5F} : PictureHeight{4.0F, 22.0F};
    }
    if (stage == Stage::networks) {
        return is_pair ? PictureHeight{11.6F, 14.0F} : PictureHeight{4.0F, 14.0F};
    }
    return std::nullopt;
}

// The patterns on screen: the current one, then the pinned one; without those whose stages are on
// their way.
std::vector<ShownStages> shown_patterns(Ui& ui, const Workspace& work,
                                        const Physiology& physiology) {
    std::vector<ShownStages> patterns;
    const PatternSet& set = work.document.set;
    const auto add = [&](const std::shared_ptr<const LiveStages>& live, std::size_t index,
                         bool pinned) {
        const Vibration& wanted = set.vibrations[index];
        // Another pattern's signals would be worse than none.
        if (!live || live->request.vibration.name != wanted.name) return;
        const bool behind =
            live->request.vibration.source != wanted.source || live->request.model != set.model;
        const bool stale = looks_stale(ui, pinned ? "pinned stages" : "stages", live, behind);
        patterns.push_back({live, look_of(ui, work, index), stale, pinned});
    };
    add(physiology.stages, work.selection.current, false);
    const auto pinned = place_named(set, work.selection.pinned);
    if (pinned && !patterns.empty()) add(physiology.pinned_stages, *pinned, true);
    return patterns;
}

void follow_difference(Physiology& physiology, const std::vector<ShownStages>& patterns) {
    ShownDifference& known = physiology.view.difference;
    if (patterns.size() < 2) {
        known = {};
        return;
    }
    const auto& a = patterns[0].live;
    const auto& b = patterns[1].live;
    if (known.a == a && known.b == b) return;
    known = {a, b, stage_differences(*a, *b), {}, 0.0};
    if (a->neural.code.central_spikes.size() == b->neural.code.central_spikes.size()) {
        known.nc =
            nc_dissimilarity(a->neural.code, b->neural.code, a->request.model.channel_weight);
    }
    for (const Stage stage : kStages) {
        known.signals[index_of(stage)] = signal_differences(*a, *b, stage);
    }
}

// Name and what is plotted, left of the plots; the name opens the stage, the "i" explains it.
// Where it ends.
float draw_stage_label(Ui& ui, Physiology& physiology, Stage stage, const Rect& area) {
    const Theme& theme = ui.theme;
    const StageText& text = text_of(stage);
    ImGui::SetCursorScreenPos(area.min);
    ImGui::PushID(text.key);
    ImGui::PushFont(theme.fonts.small);
    const float line = ImGui::GetTextLineHeight();
    ImGui::PushTextWrapPos(area.max.x - ImGui::GetWindowPos().x);
    const float icon = line + 8.0F * theme.scale;
    const float room = area.width() - icon;
    const bool wraps = area.height() >= 2.0F * line;
    const bool fits = text_size(theme.fonts.small, text.name).x <= room;
    const std::string name =
        wraps || fits ? text.name : shortened(theme.fonts.small, text.short_name, room);
    const ImVec2 size = ImGui::CalcTextSize(name.c_str(), nullptr, false, room);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool pressed = ImGui::InvisibleButton("open", size);
    const bool over = !ui.as_picture && (ImGui::IsItemHovered() || ImGui::IsItemFocused());
    if (over) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    list.AddText(nullptr, 0.0F, area.min, over ? theme.accent : theme.text, name.c_str(), nullptr,
                 room);
    draw_tooltip(ui, "Open this stage large");
    note_item(ui.rects, std::string("label:") + text.key);
    if (pressed) physiology.view.open = stage;
    ImGui::PopTextWrapPos();
    ImGui::PopFont();

    const float below = area.min.y + size.y;
    if (ui.as_picture) {
        ImGui::PopID();
        return below;
    }
    const ImVec2 centre{area.max.x - icon * 0.6F, area.min.y + line * 0.5F};
    ImGui::SetCursorScreenPos({centre.x - icon * 0.5F, centre.y - icon * 0.5F});
    if (ImGui::InvisibleButton("i", {icon, icon})) {
        const bool open = physiology.view.explained == stage;
        physiology.view.explained = open ? std::nullopt : std::optional(stage);
    }
    draw_info_mark(ui, centre, ImGui::IsItemHovered() || ImGui::IsItemFocused());
    note_item(ui.rects, std::string("explain:") + text.key);
    draw_tooltip(ui, "What happens here?");
    ImGui::PopID();
    return below;
}

using StageHeights = std::array<float, kStages.size()>;

StageHeights stage_heights(const Theme& theme, float free, float lowest_unit, bool is_pair) {
    const auto& units = is_pair ? kPairUnits : kUnits;
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    const float unit =
        std::max(free / std::accumulate(units.begin(), units.end(), 0.0F), lowest_unit);
    StageHeights heights{};
    float signal_units = 0.0F;
    float left = free;
    for (const Stage stage : kStages) {
        const std::size_t k = index_of(stage);
        const auto picture = picture_height(stage, is_pair);
        if (!picture) {
            signal_units += units[k];
            continue;
        }
        heights[k] = std::clamp(unit * units[k], picture->least * text_px, picture->most * text_px);
        left -= heights[k];
    }
    float signal_unit = left / signal_units;
    if (signal_unit < lowest_unit) {
        signal_unit =
            is_pair ? std::max(lowest_unit, kScrolledPairUnitPx * theme.scale) : lowest_unit;
    }
    for (const Stage stage : kStages) {
        const std::size_t k = index_of(stage);
        if (!picture_height(stage, is_pair)) heights[k] = signal_unit * units[k];
    }
    return heights;
}

// How far up and down signals reach, at the foot of the label of a stage that has the room.
void draw_reach(Ui& ui, const Rect& label, Stage stage, const std::string& text) {
    const float top = label.max.y - text_size(ui.theme.fonts.small, text).y;
    if (text.empty() || top < label.min.y) return;
    draw_text(*ImGui::GetWindowDrawList(), ui.theme.fonts.small, {label.min.x, top},
              ui.theme.dim_text, text);
    note_rect(ui.rects, std::string("reach:") + text_of(stage).key, {label.min.x, top}, label.max,
              text);
}

// So that it is said once.
bool have_one_reach(const Workspace& work, const std::vector<ShownStages>& patterns, Stage stage) {
    return !patterns.empty() &&
           reach_text(work, patterns.front(), stage) == reach_text(work, patterns.back(), stage);
}

void draw_overview(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                   const std::vector<ShownStages>& patterns) {
    const Theme& theme = ui.theme;
    const float gap = 0.75F * theme.gap_px;
    const float free = ImGui::GetContentRegionAvail().y - gap * static_cast<float>(kStages.size());
    float lowest = patterns.size() > 1 ? kLowestPairUnitPx : kLowestUnitPx;
    // Nobody can scroll a picture, and no clicker a single pattern; two would be too small.
    if (ui.as_picture || (ui.presenting && patterns.size() < 2)) lowest = 1.0F;
    const StageHeights heights =
        stage_heights(theme, free, lowest * theme.scale, patterns.size() > 1);
    const float height = std::accumulate(heights.begin(), heights.end(), 0.0F) +
                         gap * static_cast<float>(kStages.size());
    const bool scrolls = height > ImGui::GetContentRegionAvail().y + 1.0F;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    // The wheel moves through time where there is more of it than is shown.
    const bool zoomed_in = timeline.range.length_s() < shown_duration_s(work) - 1e-9;
    ImGuiWindowFlags flags = ImGuiWindowFlags_None;
    if (!scrolls) flags |= ImGuiWindowFlags_NoScrollbar;
    if (!scrolls || zoomed_in || ImGui::GetIO().KeyCtrl)
        flags |= ImGuiWindowFlags_NoScrollWithMouse;
    ImGui::BeginChild("overview", ImGui::GetContentRegionAvail(), false, flags);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float label = kLabelColumnPx * theme.scale;
    float top = corner.y;
    for (const Stage stage : kStages) {
        const float bottom = top + heights[index_of(stage)];
        const Rect area{{corner.x + label, top}, {corner.x + width, bottom}};
        const Rect words{{corner.x, top}, {corner.x + label, bottom}};
        const float named = draw_stage_label(ui, physiology, stage, words);
        if (have_one_reach(work, patterns, stage)) {
            const float line = text_size(theme.fonts.small, "X").y;
            draw_reach(ui, {{corner.x, named}, {words.max.x, std::min(bottom, named + line)}},
                       stage, reach_text(work, patterns[0], stage));
        }
        StageSize size;
        size.time_axis = stage == kStages.back();
        draw_patterns(ui, work, timeline, physiology, patterns, stage, area, size);
        top = bottom + gap;
    }
    ImGui::SetCursorScreenPos({corner.x, top - gap});
    ImGui::Dummy({1.0F, 0.0F});
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

// One line: the stage's name, what is plotted, its controls at the right end, and between them what
// misleads where it fits, else below.
void draw_large(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                const std::vector<ShownStages>& patterns, Stage stage) {
    const Rect pane = rest_of_pane();
    const ImFont* font = ui.theme.fonts.small;
    const StageText& text = text_of(stage);
    const float name_px = text_size(font, text.name).x + 32.0F * ui.theme.scale;
    const bool has_controls = stage == Stage::receptors && !ui.as_picture;
    const float controls_px = has_controls ? view_choice_px(ui) : 0.0F;
    StageSize size;
    size.large = true;
    size.time_axis =
        stage != Stage::spectrum && stage != Stage::receptors && stage != Stage::networks;
    Rect line{pane.min, {pane.max.x, pane.min.y + ImGui::GetFrameHeight()}};
    const float down = std::floor(0.5F * (line.height() - text_size(font, "X").y));
    if (has_controls) {
        const float left = std::max(pane.min.x, pane.max.x - controls_px);
        size.controls = {left, line.min.y};
        if (left < pane.min.x + name_px) size.controls = {pane.min.x, line.max.y};
        if (left >= pane.min.x + name_px) line.max.x = left - ui.theme.gap_px;
    }
    const ImVec2 words = line.min + ImVec2{0.0F, down};
    draw_stage_label(ui, physiology, stage, {words, {words.x + name_px, line.max.y}});
    const float detail_px = words.x + name_px + ui.theme.gap_px;
    const std::string detail = shortened(font, text.detail, line.max.x - detail_px);
    draw_text(*ImGui::GetWindowDrawList(), font, {detail_px, words.y}, ui.theme.dim_text, detail);
    const float beside_px = detail_px + text_size(font, detail).x + 3.0F * ui.theme.gap_px;
    float top = line.max.y;
    if (size.controls && size.controls->y >= line.max.y) top += line.height();
    top += draw_remark(ui, patterns, stage, {{beside_px, words.y}, line.max},
                       {{pane.min.x, top}, pane.max});
    top += 0.5F * ui.theme.gap_px;
    Rect plots{{pane.min.x, top}, pane.max};
    if (!patterns.empty() && (stage == Stage::receptors || stage == Stage::networks)) {
        const float line_px = text_size(font, "X").y;
        plots.max.y -= line_px + ui.theme.gap_px;
        const Rect foot{{pane.min.x, pane.max.y - 1.1F * line_px}, pane.max};
        if (stage == Stage::receptors) draw_receptor_key(ui, physiology, patterns.front(), foot);
        if (stage == Stage::networks) draw_network_key(ui, patterns.front(), foot);
    }
    draw_patterns(ui, work, timeline, physiology, patterns, stage, plots, size);
}

constexpr std::array kRowStages{Stage::vibration, Stage::spikes, Stage::central, Stage::brain};

void draw_row(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
              const std::vector<ShownStages>& patterns, const Rect& area) {
    const float gap = 1.5F * ui.theme.gap_px;
    const float count = static_cast<float>(kRowStages.size());
    const float width = (area.width() - gap * (count - 1.0F)) / count;
    const float label = text_size(ui.theme.fonts.small, "X").y + 0.5F * ui.theme.gap_px;
    float left = area.min.x;
    for (const Stage stage : kRowStages) {
        Rect cell{{left, area.min.y}, {left + width, area.max.y}};
        draw_stage_label(ui, physiology, stage, {cell.min, {cell.max.x, cell.min.y + label}});
        cell.min.y += label;
        if (stage == Stage::vibration && cell.height() > 4.0F * label) {
            const float line = text_size(ui.theme.fonts.small, "X").y;
            draw_reach(ui, {cell.min, {cell.max.x, cell.min.y + line}}, stage,
                       reach_text(work, patterns[0], stage));
            cell.min.y += line;
        }
        StageSize size;
        size.names = false;
        draw_patterns(ui, work, timeline, physiology, patterns, stage, cell, size);
        left += width + gap;
    }
}

// What was moved in the spectrum is a change of the set's model.
void move_threshold(Ui& ui, Workspace& work, Physiology& physiology) {
    const auto move = std::exchange(physiology.view.threshold_move, std::nullopt);
    if (!move) return;
    constexpr Range kTable = kThresholdTable.values;
    Curve& curve = work.document.set.model.coding.tables.threshold[index_of(move->type)];
    const double by = move->db / 20.0;
    const auto [low, high] = std::ranges::minmax(curve.value);
    if (by != 0.0 && low + by >= kTable.low && high + by <= kTable.high) {
        for (double& value : curve.value) value += by;
        model_changed(work);
    }
    if (move->is_last) {
        commit_step(ui, work, std::string("Move threshold of ") + traits(move->type).name);
    }
}

void fit_time(const Workspace& work, Timeline& timeline) {
    const double duration_s = shown_duration_s(work);
    timeline.range = fitted(timeline.range, duration_s);
    timeline.playhead.at_s = std::clamp(timeline.playhead.at_s, 0.0, duration_s);
}

}  // namespace

void begin_pointing(Timeline& timeline, Physiology& physiology) {
    timeline.crosshair_last_s = timeline.crosshair_s;
    timeline.crosshair_s.reset();
    physiology.view.hovered_last = physiology.view.hovered;
    physiology.view.hovered.reset();
}

PhysiologyDeed draw_physiology_row(Ui& ui, Workspace& work, Timeline& timeline,
                                   Physiology& physiology) {
    const Vibration* vibration = current_vibration(work);
    if (vibration == nullptr) {
        draw_empty(*ImGui::GetWindowDrawList(), ui.theme, rest_of_pane(), "No vibration to show",
                   "Press New on the left to make one, or open a set.");
        return PhysiologyDeed::none;
    }
    fit_time(work, timeline);
    const float links = button_width("All stages");
    const Rect rest = rest_of_pane();
    const std::vector<ShownStages> patterns = shown_patterns(ui, work, physiology);
    const Rect row{rest.min, {rest.max.x - links - ui.theme.gap_px, rest.max.y}};
    const bool failed = draw_failure(ui, "physiology", failure_of(physiology.stages_job));
    if (!failed && patterns.empty()) {
        draw_empty(*ImGui::GetWindowDrawList(), ui.theme, row, "Computing",
                   "The receptors and nerves of " + vibration->name + " are on their way.");
    }
    physiology.view.open.reset();
    follow_difference(physiology, {});  // a row shows one pattern
    if (!failed && !patterns.empty()) {
        draw_row(ui, work, timeline, physiology, {patterns.front()}, row);
    }
    // Last, as they stand at the right end: Tab goes from left to right.
    ImGui::SetCursorScreenPos({rest.max.x - links, rest.min.y});
    ImGui::BeginGroup();
    PhysiologyDeed deed = physiology.view.open ? PhysiologyDeed::unfold : PhysiologyDeed::none;
    if (link(ui, "unfold", "All stages")) deed = PhysiologyDeed::unfold;
    note_item(ui.rects, "stages:unfold");
    if (link(ui, "close stages", "Close")) deed = PhysiologyDeed::close;
    note_item(ui.rects, "stages:close");
    draw_tooltip(ui, "They come back by Stages in one row, in the View menu");
    ImGui::EndGroup();
    return deed;
}

PhysiologyDeed draw_physiology_panel(Ui& ui, Workspace& work, Timeline& timeline,
                                     Physiology& physiology, bool tour_begun) {
    const Vibration* vibration = current_vibration(work);
    if (vibration == nullptr) {
        draw_empty(*ImGui::GetWindowDrawList(), ui.theme, rest_of_pane(), "No vibration to show",
                   "Press New on the left to make one, or open a set.");
        return PhysiologyDeed::none;
    }
    fit_time(work, timeline);
    const std::vector<ShownStages> patterns = shown_patterns(ui, work, physiology);
    follow_difference(physiology, patterns);
    PhysiologyDeed deed = PhysiologyDeed::none;
    if (!ui.as_picture) deed = draw_strip(ui, work, physiology, tour_begun);
    // The links above may have turned to another range.
    fit_time(work, timeline);
    const bool failed = draw_failure(ui, "physiology", failure_of(physiology.stages_job)) ||
                        draw_failure(ui, "physiology", failure_of(physiology.pinned_job));
    if (patterns.empty() && failed) return deed;
    if (patterns.empty()) {
        draw_empty(*ImGui::GetWindowDrawList(), ui.theme, rest_of_pane(), "Computing",
                   "The receptors and nerves of " + vibration->name + " are on their way.");
        return deed;
    }
    if (physiology.view.open) {
        draw_large(ui, work, timeline, physiology, patterns, *physiology.view.open);
        move_threshold(ui, work, physiology);
    } else {
        draw_overview(ui, work, timeline, physiology, patterns);
    }
    return deed;
}

}  // namespace tact
