// What pages of a study are made of: large buttons, words in the middle.

#include <algorithm>

#include "app/study/study.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

bool was_typed(std::span<const KeyPress> pressed, char32_t sign) {
    return std::ranges::any_of(pressed, [sign](const KeyPress& p) {
        return p.sign == sign && !p.ctrl && !p.alt && !p.super;
    });
}

void centred_text(const ImFont* font, ImU32 colour, const Rect& area, float y,
                  const std::string& text) {
    const std::string shown = shortened(font, text, area.width());
    draw_text(*ImGui::GetWindowDrawList(), font,
              {area.centre().x - 0.5F * text_size(font, shown).x, y}, colour, shown);
}

float played_share(const Ui& ui, const StudyState& studying) {
    const StudyRun& run = *studying.run;
    if (!run.playing) return 0.0F;
    const double duration_s = run.duration_s[*run.playing];
    if (duration_s <= 0.0) return 1.0F;
    const double left_s = run.playing_until_s - ui.time_s;
    return static_cast<float>(std::clamp(1.0 - left_s / duration_s, 0.0, 1.0));
}

bool draw_feel_button(Ui& ui, const StudyState& studying, const Rect& area,
                      const FeelButton& button) {
    const Theme& theme = ui.theme;
    ImGui::SetCursorScreenPos(area.min);
    ImGui::BeginDisabled(!button.is_enabled);
    const bool pressed = ImGui::InvisibleButton(button.id, area.size());
    const bool is_lit = button.is_enabled && ImGui::IsItemHovered();
    ImGui::EndDisabled();
    const char* state =
        button.is_playing ? "playing " : (button.is_enabled ? "ready " : "waiting ");
    note_rect(ui.rects, button.id, area.min, area.max, state + std::to_string(button.times));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(area.min, area.max, is_lit ? theme.hover : theme.field,
                       theme.pane_rounding_px);
    if (button.is_playing) {
        const float x = area.min.x + played_share(ui, studying) * area.width();
        list.AddRectFilled(area.min, {x, area.max.y}, faded(theme.accent, 0.45F),
                           theme.pane_rounding_px);
    }
    const bool is_plain = button.is_enabled || button.is_playing;
    list.AddRect(area.min, area.max, button.times > 0 ? theme.accent : theme.line,
                 theme.pane_rounding_px, 0, theme.hairline_px);
    const float middle = area.centre().y - (button.key.empty() ? 0.5F : 0.9F) *
                                               text_size(theme.fonts.large, button.label).y;
    centred_text(theme.fonts.large, is_plain ? theme.text : theme.dim_text, area, middle,
                 button.label);
    centred_text(theme.fonts.small, theme.dim_text, area, middle + 28.0F * theme.scale, button.key);
    return pressed && button.is_enabled;
}

ImVec2 go_on_size(const Theme& theme) { return {184.0F * theme.scale, 48.0F * theme.scale}; }

void draw_go_on(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                const Rect& area, const char* label) {
    ImGui::SetCursorScreenPos(area.min);
    const bool may = studying.run && may_go_on(*studying.run, ui.time_s);
    if (primary_button(ui,
                       {.id = "study:go on",
                        .label = label,
                        .enabled = may,
                        .value = may ? "ready" : "waiting"},
                       go_on_size(ui.theme))) {
        act(ui, work, play, studying, {StudyEvent::What::go_on, 0, 0.0, {}, {}});
    }
}

}  // namespace tact
