#include "app/patterns/look_menu.h"

#include "app/document/editing.h"
#include "app/document/pattern_looks.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

// Room for a mark before the words of an item.
constexpr const char* kIndent = "      ";

// True where it is chosen, by mouse or keyboard.
bool look_item(Ui& ui, const std::string& text, const PatternLook& look, bool is_now) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool chosen = ImGui::MenuItem((kIndent + text).c_str(), nullptr, is_now);
    note_item(ui.rects, "row menu:" + text, is_now ? "chosen" : "");
    const float s = ui.theme.scale;
    draw_pattern_mark(*ImGui::GetWindowDrawList(), ui.theme,
                      {corner.x + 9.0F * s, corner.y + 0.5F * ImGui::GetTextLineHeight()}, 5.5F * s,
                      look, ImGui::GetColorU32(ImGuiCol_PopupBg));
    return chosen;
}

}  // namespace

void draw_look_menu(Ui& ui, Workspace& work, std::size_t index) {
    const bool is_open = ImGui::BeginMenu("Colour and mark");
    note_item(ui.rects, "row menu:Colour and mark");
    if (!is_open) return;
    const Vibration& vibration = work.document.set.vibrations[index];
    const PatternLook now = look_of(ui, work, index);
    const auto choose = [&](std::string colour, bool ring) {
        ui.waiting.emplace_back([&ui, &work, colour = std::move(colour), ring] {
            change_look(ui, work, colour, ring);
        });
    };
    const auto place = palette_place(vibration.colour);
    for (std::size_t k = 0; k < kPatternColourCount; ++k) {
        const PatternLook look{ui.theme.pattern[k], vibration.ring};
        const PatternColour& colour = kPatternColours[k];
        if (look_item(ui, colour.name, look, place == k)) choose(colour.hex, vibration.ring);
    }
    ImGui::Separator();
    for (const bool ring : {false, true}) {
        if (look_item(ui, ring ? "Ring" : "Disc", {now.colour, ring}, vibration.ring == ring)) {
            choose(vibration.colour, ring);
        }
    }
    ImGui::EndMenu();
}

}  // namespace tact
