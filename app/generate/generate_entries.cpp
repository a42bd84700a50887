#include "app/generate/parts.h"

#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kNumberWidthPx = 62.0F;

}  // namespace

Unit unit_of(Parameter parameter) {
    switch (parameter) {
        case Parameter::amplitude:
            return {"g", 1.0};
        case Parameter::frequency:
        case Parameter::modulation:
            return {"Hz", 1.0};
        case Parameter::unit:
        case Parameter::attack:
        case Parameter::release:
            return {"ms", 1000.0};
        case Parameter::duration:
            return {"s", 1.0};
        default:
            return {"", 1.0};
    }
}

std::vector<std::string> words_in(const std::string& text) {
    std::vector<std::string> words;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t begin = std::min(text.find_first_not_of(",; ", at), text.size());
        const std::size_t end = std::min(text.find_first_of(",; ", begin), text.size());
        if (end > begin) words.push_back(text.substr(begin, end - begin));
        at = end;
    }
    return words;
}

std::optional<std::string> draw_entry(Ui& ui, GenerateState& generating, const std::string& id,
                                      const std::string& shown, float width) {
    const bool typing = generating.typing == id;
    std::string text = typing ? generating.text : shown;
    ImGui::SetNextItemWidth(width);
    ImGui::InputText(("##" + id).c_str(), &text);
    note_item(ui.rects, "generate:" + id, text);
    if (ImGui::IsItemActivated()) generating.draft_before_typing = generating.draft;
    if (!ImGui::IsItemActive()) {
        const bool escaped = ImGui::IsKeyPressed(ImGuiKey_Escape, false);
        if (typing && ImGui::IsItemDeactivated() && escaped) {
            generating.takes_back = true;
            generating.refused.clear();
        }
        if (typing) generating.typing.clear();
        return std::nullopt;
    }
    generating.typing = id;
    generating.text = text;
    return text == shown ? std::nullopt : std::optional(text);
}

void draw_number(Ui& ui, const std::string& id, double& value, Range allowed, const Unit& unit) {
    double shown = unit.times * value;
    const NumberEntry entry{
        .id = id,
        .label = id,
        .format = "%.6g",
        .rules = {{unit.times * allowed.low, unit.times * allowed.high}, unit.name},
        .width_px = kNumberWidthPx * ui.theme.scale,
        .live = true};
    if (enter_number(ui, entry, shown)) {
        value = std::clamp(shown / unit.times, allowed.low, allowed.high);
    }
    note_item(ui.rects, "generate:" + id, significant_digits(shown, 6));
}

void draw_whole(Ui& ui, const std::string& id, int& value, Range allowed) {
    const NumberEntry entry{.id = id,
                            .label = id,
                            .format = "%.9g",
                            .rules = {allowed, "", true},
                            .width_px = kNumberWidthPx * ui.theme.scale,
                            .live = true};
    enter_whole(ui, entry, value);
    note_item(ui.rects, "generate:" + id, std::to_string(value));
}

bool option_chip(Ui& ui, const std::string& id, const char* text, bool lit, const char* help) {
    const Item item{
        .id = "generate:" + id, .label = text, .tip = help, .value = lit ? "chosen" : ""};
    const bool pressed = toggle(ui, item, lit);
    ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    return pressed;
}

bool option_link(Ui& ui, const char* id, const char* text) {
    const bool pressed = row_link(ui, {.id = std::string("generate:") + id, .label = text});
    ImGui::SameLine(0.0F, 2.0F * ui.theme.gap_px);
    return pressed;
}

void leave_gap(const Ui& ui) { ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.theme.gap_px); }

void beside(const Ui& ui, const char* text) {
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    dim_text(ui, text);
}

void draw_remark(Ui& ui, GenerateState& generating, const std::string& id, bool is_typed,
                 const std::string& remark, const std::string& fault) {
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    if (!fault.empty()) {
        generating.takes_back = true;
        generating.refused = id;
        generating.refusal = fault;
    } else if (is_typed && generating.refused == id) {
        generating.refused.clear();
    }
    if (generating.refused != id) {
        return dim_text(ui, {.id = "generate:remark " + id, .text = remark});
    }
    const std::string words = fault.empty() ? "Not taken: " + generating.refusal : fault;
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(ui.theme.error));
    plain_text(ui, {.id = "generate:fault", .text = words});
    ImGui::PopStyleColor();
}

}  // namespace tact
