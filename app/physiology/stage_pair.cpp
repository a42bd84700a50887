#include "app/physiology/stage_pair.h"

#include <algorithm>
#include <cfloat>
#include <string>

#include "app/physiology/stage_remarks.h"
#include "app/physiology/stage_signals.h"
#include "app/timeline/time_rows.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// Whose signals these are, at the right end of a row of plots.
void draw_row_name(Ui& ui, const Rect& area, const std::string& name, const std::string& id,
                   ImU32 colour, bool top = false) {
    const ImFont* font = ui.theme.fonts.small;
    const float pad = 3.0F * ui.theme.scale;
    const std::string text = shortened(font, name, 0.5F * area.width());
    const ImVec2 size = text_size(font, text);
    if (area.height() < size.y) return;
    // Clear of what stands at the top right of some plots.
    const ImVec2 corner{area.max.x - size.x - pad, top ? area.min.y : area.max.y - size.y - pad};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner - ImVec2{pad, 0.0F}, corner + size + ImVec2{pad, 0.0F}, ui.theme.pane,
                       ui.theme.rounding_px);
    draw_text(list, font, corner, colour, text);
    note_rect(ui.rects, id, corner, corner + size, name);
}

// The number that the paper makes of a pair at this stage, where it makes one.
std::string difference_name(const Physiology& physiology, Stage stage) {
    const std::string name = "difference";
    if (stage == Stage::brain) return name + ", NC " + significant(physiology.view.difference.nc);
    if (stage != Stage::envelope || !physiology.view.pair_oc) return name;
    return name + ", OC " + significant(*physiology.view.pair_oc);
}

}  // namespace

void draw_patterns(Ui& ui, const Workspace& work, Timeline& timeline, Physiology& physiology,
                   const std::vector<ShownStages>& patterns, Stage stage, const Rect& area,
                   const StageSize& size) {
    if (patterns.empty()) return;
    if (patterns.size() < 2)
        return draw_stage(ui, work, timeline, physiology, patterns[0], stage, area, size);
    const std::size_t rows = signals_of(*patterns[0].live, stage).size();
    const bool has_signals = rows > 0;
    // Several rows are as high in between as above and below; large, they have names and values.
    const float of_many = size.large ? 0.35F : 0.3F;
    const float share = rows > 1 ? of_many : 0.24F;
    const float axis = size.time_axis ? time_axis_height(ui) : 0.0F;
    const float text = font_or_current(ui.theme.fonts.small).FontSize;
    const float middle = has_signals ? std::max(text, share * (area.height() - axis)) : text * 1.2F;
    const float each = 0.5F * (area.height() - axis - middle);
    const float y1 = area.min.y + each;
    const float y2 = y1 + middle;
    StageSize upper = size;
    upper.time_axis = false;
    // A name has its own line, but above networks, where it stands behind the first one's, and
    // where plots are too low to give one up.
    const bool has_line =
        stage == Stage::receptors || (has_signals && each >= 4.5F * text && middle >= 3.0F * text);
    const bool top = has_line || stage == Stage::networks;
    const ImVec2 named{0.0F, has_line ? 1.1F * text : 0.0F};
    draw_stage(ui, work, timeline, physiology, patterns[0], stage,
               {area.min + named, {area.max.x, y1}}, upper);
    draw_stage_difference(ui, work, timeline, physiology, patterns[0], patterns[1], stage,
                          {ImVec2{area.min.x, y1} + named, {area.max.x, y2}}, upper);
    draw_stage(ui, work, timeline, physiology, patterns[1], stage,
               {ImVec2{area.min.x, y2} + named, area.max}, size);
    const std::string key = text_of(stage).key;
    const auto name_of = [&](std::size_t k) { return patterns[k].live->request.vibration.name; };
    draw_row_name(ui, {area.min, {area.max.x, y1}}, name_of(0), "row a:" + key,
                  patterns[0].look.colour, top);
    draw_row_name(ui, {{area.min.x, y2}, {area.max.x, area.max.y - axis}}, name_of(1),
                  "row b:" + key, patterns[1].look.colour, top);
    if (!has_signals) return;
    draw_row_name(ui, {{area.min.x, y1}, {area.max.x, y2}}, difference_name(physiology, stage),
                  "row difference:" + key, difference_colour(ui.theme), top);
}

float draw_remark(Ui& ui, const std::vector<ShownStages>& patterns, Stage stage, const Rect& beside,
                  const Rect& below) {
    const std::string remark =
        patterns.empty() ? std::string() : stage_remark(*patterns[0].live, stage);
    if (remark.empty()) return 0.0F;
    const ImFont& font = font_or_current(ui.theme.fonts.small);
    const bool in_line = text_size(&font, remark).x <= beside.width();
    const Rect& place = in_line ? beside : below;
    const float wrap_px = in_line ? 0.0F : place.width();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddText(&font, font.FontSize, place.min, ui.theme.text, remark.c_str(), nullptr, wrap_px);
    const float height = font.CalcTextSizeA(font.FontSize, FLT_MAX, wrap_px, remark.c_str()).y;
    note_rect(ui.rects, std::string("remark:") + text_of(stage).key, place.min,
              {place.max.x, place.min.y + height}, remark);
    return in_line ? 0.0F : height + ui.theme.gap_px;
}

}  // namespace tact
