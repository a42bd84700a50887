// What one stage is about: in the body, in the model, and what neither says.

#include "app/physiology/physiology_panel.h"
#include "app/physiology/stages.h"
#include "app/ui/widgets.h"

namespace tact {

namespace {

void draw_paragraph(const App& app, const char* heading, const char* text) {
    ImGui::PushFont(app.theme.fonts.small);
    dim_text(app, heading);
    ImGui::PopFont();
    ImGui::TextUnformatted(text);
    ImGui::Dummy({1.0F, 0.25F * app.theme.gap_px});
}

void draw_way(App& app, Stage stage) {
    const std::size_t at = index_of(stage);
    ImGui::BeginDisabled(at == 0);
    if (ImGui::Button("Previous stage")) app.physiology.explained = kStages[at - 1];
    ImGui::EndDisabled();
    flow_on(button_width("Next stage"), app.theme.gap_px);
    ImGui::BeginDisabled(at + 1 == kStages.size());
    if (ImGui::Button("Next stage")) app.physiology.explained = kStages[at + 1];
    note_item(app.rects, "explain:next");
    ImGui::EndDisabled();
    flow_on(button_width("Close"), app.theme.gap_px);
    if (ImGui::Button("Close")) app.physiology.explained.reset();
    note_item(app.rects, "explain:close");
}

}  // namespace

void draw_explain_window(App& app, const Rect& beside) {
    if (!app.physiology.explained) return;
    const Stage stage = *app.physiology.explained;
    const StageText& text = text_of(stage);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = std::min(400.0F * app.theme.scale, screen.x - 2.0F * app.theme.gap_px);
    const float left =
        std::min(beside.max.x + app.theme.gap_px, screen.x - width - app.theme.gap_px);
    const float top = beside.min.y + app.theme.gap_px;
    ImGui::SetNextWindowPos({left, top}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSizeConstraints({width, 0.0F}, {width, screen.y - top - app.theme.gap_px});
    bool open = true;
    const std::string title = std::string(text.name) + "###explain";
    if (ImGui::Begin(title.c_str(), &open,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing)) {
        ImGui::PushTextWrapPos(width - app.theme.padding_px - ImGui::GetStyle().ScrollbarSize);
        draw_paragraph(app, "In the body", text.in_body);
        draw_paragraph(app, "In the model", text.in_model);
        draw_paragraph(app, "Equation and section", text.equation);
        draw_paragraph(app, "Left out", text.left_out);
        draw_paragraph(app, "Ours, not the paper's", text.ours);
        ImGui::PopTextWrapPos();
        draw_way(app, stage);
        const ImVec2 min = ImGui::GetWindowPos();
        note_rect(app.rects, "explanation", min, min + ImGui::GetWindowSize(), text.key);
    }
    ImGui::End();
    if (!open) app.physiology.explained.reset();
}

}  // namespace tact
