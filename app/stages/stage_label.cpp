#include "app/stages/stages.h"

#include <algorithm>

#include "app/physiology/physiology.h"
#include "app/stages/parts.h"
#include "app/ui/widgets.h"
#include "model/textbook/textbook.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// The "i" in a circle.
void draw_info_mark(const Ui& ui, ImVec2 centre, bool lit) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius = 6.5F * ui.theme.scale;
    const ImU32 colour = lit ? ui.theme.accent : ui.theme.dim_text;
    list.AddCircle(centre, radius, colour, 0, ui.theme.hairline_px);
    const ImVec2 size = text_size(ui.theme.fonts.small, "i");
    draw_text(list, ui.theme.fonts.small, {centre.x - size.x / 2.0F, centre.y - size.y / 2.0F},
              colour, "i");
}

}  // namespace

float draw_stage_label(Ui& ui, Physiology& physiology, Stage stage, const Rect& area) {
    const Theme& theme = ui.theme;
    const StageText& text = text_of(stage);
    ImGui::SetCursorScreenPos(area.min);
    ImGui::PushID(text.key);
    ImGui::PushFont(theme.fonts.small);
    const float line = ImGui::GetTextLineHeight();
    ImGui::PushTextWrapPos(area.max.x - ImGui::GetWindowPos().x);
    const float icon = line + 8.0F * theme.scale;
    // Without room for both, the name is shown before the quantity.
    const float beside = area.width() - icon;
    const bool has_icon =
        !ui.as_picture && text_size(theme.fonts.small, text.short_name).x <= beside;
    const float room = has_icon || ui.as_picture ? beside : area.width();
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
    say_of_last_item(
        ui, {.id = std::string("label:") + text.key, .text = "", .tip = "Open this stage large"});
    if (pressed) physiology.view.open = stage;
    ImGui::PopTextWrapPos();
    ImGui::PopFont();

    const float below = area.min.y + size.y;
    if (!has_icon) {
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
    say_of_last_item(
        ui, {.id = std::string("explain:") + text.key, .text = "", .tip = "What happens here?"});
    ImGui::PopID();
    return below;
}

void draw_reach(Ui& ui, const Rect& label, Stage stage, const std::string& text) {
    const float top = label.max.y - text_size(ui.theme.fonts.small, text).y;
    if (text.empty() || top < label.min.y) return;
    draw_text(*ImGui::GetWindowDrawList(), ui.theme.fonts.small, {label.min.x, top},
              ui.theme.dim_text, text);
    note_rect(ui.rects, std::string("reach:") + text_of(stage).key, {label.min.x, top}, label.max,
              text);
}

// Explanation of a stage: in the body, in the model, and the facts that the model leaves out.

namespace {

void draw_paragraph(const Ui& ui, const char* heading, const char* text) {
    ImGui::PushFont(ui.theme.fonts.small);
    dim_text(ui, heading);
    ImGui::PopFont();
    ImGui::TextUnformatted(text);
    ImGui::Dummy({1.0F, 0.25F * ui.theme.gap_px});
}

// Measured facts, each with its source.
void draw_measured_facts(const Ui& ui, const std::string& key) {
    std::string facts;
    for (const TextbookFact& fact : textbook()) {
        if (fact.sure == Sure::from_memory) continue;
        if (std::ranges::find(fact.stages, key) == fact.stages.end()) continue;
        facts += (facts.empty() ? "" : "\n") + sentence_of(fact);
    }
    if (!facts.empty()) draw_paragraph(ui, "Measured", facts.c_str());
}

void draw_way(Ui& ui, Physiology& physiology, Stage stage) {
    const std::size_t at = index_of(stage);
    const auto to = [&](const char* id, const char* label, bool enabled, std::size_t next) {
        if (button(ui, {.id = id, .label = label, .enabled = enabled}))
            physiology.view.explained = kStages[next];
    };
    to("explain:previous", "Previous stage", at > 0, at - 1);
    flow_on(button_width("Next stage"), ui.theme.gap_px);
    to("explain:next", "Next stage", at + 1 < kStages.size(), at + 1);
    flow_on(button_width("Close"), ui.theme.gap_px);
    if (button(ui, {.id = "explain:close", .label = "Close"})) physiology.view.explained.reset();
}

}  // namespace

void draw_explain_window(Ui& ui, Physiology& physiology, const Rect& beside) {
    if (!physiology.view.explained) return;
    const Stage stage = *physiology.view.explained;
    const StageText& text = text_of(stage);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = std::min(400.0F * ui.theme.scale, screen.x - 2.0F * ui.theme.gap_px);
    const float left = std::min(beside.max.x + ui.theme.gap_px, screen.x - width - ui.theme.gap_px);
    const float top = beside.min.y + ui.theme.gap_px;
    ImGui::SetNextWindowPos({left, top}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, screen.y - top - ui.theme.gap_px});
    bool open = true;
    const std::string title = std::string(text.name) + "###explain";
    if (ImGui::Begin(title.c_str(), &open,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
        ImGui::PushTextWrapPos(width - ui.theme.padding_px - ImGui::GetStyle().ScrollbarSize);
        draw_paragraph(ui, "In the body", text.in_body);
        draw_paragraph(ui, "In the model", text.in_model);
        draw_paragraph(ui, "Equation and section", text.equation);
        draw_paragraph(ui, "Left out", text.left_out);
        draw_paragraph(ui, "Ours, not the paper's", text.ours);
        draw_paragraph(ui, "Sources", text.source);
        if (physiology.view.textbook) draw_measured_facts(ui, text.key);
        ImGui::PopTextWrapPos();
        draw_way(ui, physiology, stage);
        const ImVec2 min = ImGui::GetWindowPos();
        note_rect(ui.rects, "explanation", min, min + ImGui::GetWindowSize(), text.key);
    }
    ImGui::End();
    if (!open) physiology.view.explained.reset();
}

}  // namespace tact
