#include "app/stages/parts.h"

#include <algorithm>
#include <cfloat>
#include <string>

#include "app/physiology/physiology.h"
#include "app/timeline/timeline.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// The pattern's name beside its row of plots, with a mark in its colour because coloured small text
// is hard to read, and more words below.
struct RowName {
    std::string id;
    std::string name;
    std::string more{};
    PatternLook look;
};

float mark_room_px(const Theme& theme) { return theme.gap_px + 2.6F * theme.mark_px; }

void draw_row_name(Ui& ui, const Rect& place, const RowName& row) {
    const Theme& theme = ui.theme;
    const ImFont* font = theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    const float left = place.min.x + mark_room_px(theme);
    const bool has_more = !row.more.empty() && place.height() >= 2.2F * text_px;
    const float height = (has_more ? 2.2F : 1.1F) * text_px;
    if (place.height() < 0.9F * text_px) return;
    float top = std::round(place.centre().y - 0.5F * height);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_pattern_mark(list, theme,
                      {place.min.x + theme.gap_px + theme.mark_px, top + 0.55F * text_px},
                      0.85F * theme.mark_px, row.look, theme.pane);
    const auto line = [&](const std::string& words, ImU32 colour) {
        const std::string text = shortened(font, words, place.max.x - left);
        draw_text(list, font, {left, top}, colour, text);
        top += 1.1F * text_px;
        return text_size(font, text);
    };
    const ImVec2 corner{left, top};
    const ImVec2 size = line(row.name, theme.text);
    note_rect(ui.rects, row.id, corner, corner + size,
              row.more.empty() ? row.name : row.name + ", " + row.more);
    if (has_more) line(row.more, theme.dim_text);
}

// The paper's number for a pair at this stage, if it has one.
std::string paper_number(const Physiology& physiology, Stage stage) {
    if (stage == Stage::brain) return "NC " + significant(physiology.view.difference.nc);
    if (stage != Stage::envelope || !physiology.view.pair_oc) return {};
    return "OC " + significant(*physiology.view.pair_oc);
}

// "L-0-half: a gate, ...".
std::string of_pattern(const std::string& name, std::string remark) {
    const auto begins_it = [&](Receptor type) { return remark.starts_with(traits(type).name); };
    if (std::ranges::none_of(kReceptors, begins_it)) remark.front() = lower_case(remark).front();
    return name + ": " + remark;
}

// Room for names at the right of all plots: as wide as needed, within limits.
float row_names_px(const Ui& ui, const std::vector<ShownStages>& patterns, float width_px) {
    float words_px = text_size(ui.theme.fonts.small, "difference").x;
    for (const ShownStages& shown : patterns) {
        const std::string& name = shown.live->request.vibration.name;
        words_px = std::max(words_px, text_size(ui.theme.fonts.small, name).x);
    }
    return std::min(words_px + 1.0F + mark_room_px(ui.theme), 0.22F * width_px);
}

}  // namespace

void draw_patterns(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                   const std::vector<ShownStages>& patterns, Stage stage, const Rect& area,
                   const StageSize& size) {
    if (patterns.empty()) return;
    const std::size_t rows = signals_of(*patterns[0].live, stage).size();
    const bool has_signals = rows > 0;
    Rect plots = area;
    StageSize upper = size;
    if (patterns.size() > 1) plots.max.x -= row_names_px(ui, patterns, area.width());
    const Rect names{{plots.max.x, area.min.y}, area.max};
    // All time axes end at one place, with or without lanes.
    if (has_signals && size.names) {
        upper.lanes_px = lane_names_px(ui, area.width());
        plots.max.x -= upper.lanes_px;
    }
    if (patterns.size() < 2)
        return draw_stage(ui, work, timeline, physiology, patterns[0], stage, plots, upper);
    const StageSize lower = upper;
    upper.time_axis = false;
    // Several rows are equally high between the axes; large ones have values.
    const float of_many = size.large ? 0.35F : 0.3F;
    const float share = rows > 1 ? of_many : 0.24F;
    const float axis = size.time_axis ? time_axis_height(ui) : 0.0F;
    const float text = font_or_current(ui.theme.fonts.small).FontSize;
    const float gap = std::min(0.5F * ui.theme.gap_px, 0.04F * area.height());
    const float free = area.height() - axis - 2.0F * gap;
    const float middle = has_signals ? std::max(text, share * free) : text * 1.2F;
    const float each = 0.5F * (free - middle);
    const float y1 = area.min.y + each + gap;
    const float y2 = y1 + middle + gap;
    const Rect above{plots.min, {plots.max.x, y1 - gap}};
    const Rect between{{plots.min.x, y1}, {plots.max.x, y2 - gap}};
    const Rect below{{plots.min.x, y2}, plots.max};
    draw_stage(ui, work, timeline, physiology, patterns[0], stage, above, upper);
    draw_stage_difference(ui, work, timeline, physiology, patterns[0], patterns[1], stage, between,
                          upper);
    draw_stage(ui, work, timeline, physiology, patterns[1], stage, below, lower);
    const std::string key = text_of(stage).key;
    // If both have the same range, the stage's label tells it.
    const bool apart =
        !size.large && reach_text(work, patterns[0], stage) != reach_text(work, patterns[1], stage);
    const auto name = [&](const char* row, const Rect& of, std::size_t k) {
        const ShownStages& shown = patterns[k];
        draw_row_name(ui, {{names.min.x, of.min.y}, {names.max.x, of.max.y}},
                      {row + key, shown.live->request.vibration.name,
                       apart ? reach_text(work, shown, stage) : std::string(), shown.look});
    };
    name("row a:", above, 0);
    name("row b:", {below.min, {below.max.x, below.max.y - axis}}, 1);
    if (!has_signals) return;
    draw_row_name(ui, {{names.min.x, between.min.y}, {names.max.x, between.max.y}},
                  {"row difference:" + key,
                   "difference",
                   paper_number(physiology, stage),
                   {difference_colour(ui.theme), false}});
}

float draw_remark(Ui& ui, const Physiology& physiology, const std::vector<ShownStages>& patterns,
                  Stage stage, const Rect& beside, const Rect& below) {
    if (patterns.empty()) return 0.0F;
    std::string remark = stage_remark(*patterns[0].live, stage, physiology.view.textbook);
    if (remark.empty()) return 0.0F;
    if (patterns.size() > 1 && stage != Stage::spectrum) {
        remark = of_pattern(patterns[0].live->request.vibration.name, remark);
    }
    const ImFont& font = font_or_current(ui.theme.fonts.small);
    const bool in_line = text_size(&font, remark).x <= beside.width();
    const Rect& place = in_line ? beside : below;
    float wrap_px = in_line ? 0.0F : place.width();
    float height = font.CalcTextSizeA(font.FontSize, FLT_MAX, wrap_px, remark.c_str()).y;
    std::string words = remark;
    // A low picture keeps most of its room.
    constexpr float kMostOfPicture = 0.4F;
    const bool is_cut = !in_line && height > kMostOfPicture * below.height();
    if (is_cut) {
        words = shortened(&font, remark, place.width());
        wrap_px = 0.0F;
        height = font.FontSize;
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(&font, font.FontSize, place.min, ui.theme.text, words.c_str(), nullptr, wrap_px);
    if (is_cut) {
        const ImVec2 cursor = ImGui::GetCursorScreenPos();
        ImGui::SetCursorScreenPos(place.min);
        ImGui::Dummy({place.width(), height});
        draw_tooltip(ui, remark.c_str());
        ImGui::SetCursorScreenPos(cursor);
    }
    note_rect(ui.rects, std::string("remark:") + text_of(stage).key, place.min,
              {place.max.x, place.min.y + height}, remark);
    return in_line ? 0.0F : height + ui.theme.gap_px;
}

}  // namespace tact
