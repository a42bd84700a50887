// Glyphs that a lesson needs, and the outline around the item that its step points at.
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "app/lesson/lesson.h"
#include "viz/drawing/fonts.h"

namespace tact {

namespace {

// Only the shown language counts: letters of another one are not needed.
std::string shown_text_of(LessonStep step) {
    step.words.clear();
    std::string all;
    for (const std::string& text : texts_of(step)) all += text;
    return all;
}

}  // namespace

std::string drawn_text(const LessonState& state) {
    if (!state.step || !state.shown) return {};
    std::string all = state.shown->name + state.shown->about;
    for (const LessonStep& step : state.shown->steps) all += shown_text_of(step) + step.source;
    return all;
}

void follow_glyphs(Ui& ui, LessonState& state) {
    const LessonStep* step = step_of(state);
    if (step == nullptr || ui.theme.fonts.regular == nullptr) return;
    std::u32string lacking = without_glyph(*ui.theme.fonts.regular, shown_text_of(*step));
    // Fonts are loaded once for these characters: no font may have them.
    if (!lacking.empty() && lacking != state.lacking) ui.fonts_outdated = true;
    state.lacking = std::move(lacking);
}

void watch_pointed(Ui& ui, const LessonState& state) {
    const LessonStep* step = step_of(state);
    ui.rects.watched = step == nullptr ? std::string() : step->point_at;
    ui.rects.watched_at.reset();
}

void draw_pointed(const Ui& ui, const Rect& within) {
    if (!ui.rects.watched_at || ImGui::GetIO().DisplaySize.x <= 0.0F) return;
    const Rect& at = *ui.rects.watched_at;
    const float grow = 3.0F * ui.theme.scale;
    const ImVec2 low{std::max(at.min.x - grow, within.min.x),
                     std::max(at.min.y - grow, within.min.y)};
    const ImVec2 high{std::min(at.max.x + grow, within.max.x),
                      std::min(at.max.y + grow, within.max.y)};
    if (low.x >= high.x || low.y >= high.y) return;
    ImGui::GetForegroundDrawList()->AddRect(low, high, ui.theme.accent, ui.theme.rounding_px, 0,
                                            2.0F * ui.theme.scale);
}

}  // namespace tact
