#include "app/stages/parts.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <numeric>
#include <optional>

#include "app/document/editing.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kLabelColumnPx = 96.0F;

// Height of each stage in the overview, in units. Signals share the height that pictures leave.
constexpr std::array<float, kStages.size()> kUnits{1.0F, 2.1F, 1.8F, 3.2F, 2.1F,
                                                   2.2F, 1.7F, 0.9F, 1.1F};
constexpr std::array<float, kStages.size()> kPairUnits{0.9F, 2.1F, 3.3F, 3.2F, 3.0F,
                                                       2.2F, 3.0F, 1.1F, 1.1F};
constexpr float kLowestUnitPx = 28.0F;  // with less, the column scrolls
constexpr float kLowestPairUnitPx = 36.0F;
constexpr float kScrolledPairUnitPx = 72.0F;  // used while it scrolls, so that lanes are
                                              // comfortably high

// The least and the largest useful height of a picture, in heights of small text.
struct PictureHeight {
    float least;
    float most;
};

std::optional<PictureHeight> picture_height(Stage stage, bool is_pair) {
    // A pair has a line of words between its pictures; the choice of networks stands above both.
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

// Whether all patterns have one range, which is then shown once.
bool have_one_reach(const Workspace& work, const std::vector<ShownStages>& patterns, Stage stage) {
    return !patterns.empty() &&
           reach_text(work, patterns.front(), stage) == reach_text(work, patterns.back(), stage);
}

// Text wrapped within the size, cut with "..."; in less than one line, one line.
std::string fitted(const ImFont& font, const std::string& text, const ImVec2& size) {
    const float room_px = std::max(size.y, font.FontSize) + 0.5F;
    const auto fits = [&](const std::string& some) {
        return font.CalcTextSizeA(font.FontSize, FLT_MAX, size.x, some.c_str()).y <= room_px;
    };
    std::string some = text;
    while (!some.empty() && !fits(some == text ? text : some + "\u2026")) {
        const auto is_middle = [&] { return (some.back() & '\xC0') == '\x80'; };
        while (some.size() > 1 && is_middle()) some.pop_back();
        some.pop_back();
        while (some.ends_with(' ')) some.pop_back();
    }
    return some == text ? text : some + "\u2026";
}

// Remarks on the stage, under its name; the tooltip has those that do not fit.
void draw_short_remark(Ui& ui, const ShownStages& shown, Stage stage, const Rect& area) {
    const std::string whole = short_remark(*shown.live, stage);
    if (whole.empty()) return;
    const ImFont& font = font_or_current(ui.theme.fonts.small);
    const std::string text = fitted(font, whole, area.size());
    const ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, area.width(), text.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(area.min, area.max, true);
    list.AddText(&font, font.FontSize, area.min, ui.theme.warning, text.c_str(), nullptr,
                 area.width());
    list.PopClipRect();
    const ImVec2 end{area.min.x + size.x, std::min(area.max.y, area.min.y + size.y)};
    note_rect(ui.rects, std::string("remark:") + text_of(stage).key, area.min, end, whole);
    ImGui::SetCursorScreenPos(area.min);
    ImGui::Dummy({std::max(1.0F, end.x - area.min.x), std::max(1.0F, end.y - area.min.y)});
    draw_tooltip(ui, stage_remark(*shown.live, stage).c_str());
}

}  // namespace

void draw_overview(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                   const std::vector<ShownStages>& patterns) {
    const Theme& theme = ui.theme;
    const float gap = 0.75F * theme.gap_px;
    const float free = ImGui::GetContentRegionAvail().y - gap * static_cast<float>(kStages.size());
    float lowest = patterns.size() > 1 ? kLowestPairUnitPx : kLowestUnitPx;
    // A picture cannot be scrolled, and a clicker cannot scroll a single pattern; two would be too
    // small.
    if (ui.as_picture || (ui.presenting && patterns.size() < 2)) lowest = 1.0F;
    const StageHeights heights =
        stage_heights(theme, free, lowest * theme.scale, patterns.size() > 1);
    const float height = std::accumulate(heights.begin(), heights.end(), 0.0F) +
                         gap * static_cast<float>(kStages.size());
    const bool scrolls = height > ImGui::GetContentRegionAvail().y + 1.0F;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    // The wheel moves through time if only a part of it is shown.
    const bool zoomed_in = is_zoomed_in(timeline, shown_duration_s(work));
    ImGuiWindowFlags flags = sideways_if_narrow(ui, ImGui::GetContentRegionAvail().x);
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
        if (patterns.size() == 1) {
            Rect rest{{corner.x, named}, words.max};
            rest.max.y -= draw_textbook_sign(ui, physiology, patterns[0], stage, rest);
            draw_short_remark(ui, patterns[0], stage, rest);
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

}  // namespace tact
