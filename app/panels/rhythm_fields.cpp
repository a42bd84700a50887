#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/editing.h"
#include "app/panels/pattern_fields.h"

namespace tact {

namespace {

// One rhythm step: a click turns rest into note, note into hold (where it can), hold into rest.
std::string stepped(std::string text, std::size_t step) {
    const bool can_hold = step > 0 && text[step - 1] != '-';
    if (text[step] == '-') {
        text[step] = 'x';
    } else if (text[step] == 'x' && can_hold) {
        text[step] = '=';
    } else {
        text[step] = '-';
        // A hold needs a note before it.
        for (std::size_t k = step + 1; k < text.size() && text[k] == '='; ++k) text[k] = '-';
    }
    return text;
}

void set_rhythm(App& app, const std::string& text) {
    edit_patterns(app, [&text](Pattern& p) { p.rhythm.text = text; });
    commit_step(app, "Change " + of_selection(app, "rhythm"));
}

void draw_rhythm_grid(App& app, const Rhythm& rhythm) {
    const Theme& theme = app.theme;
    const std::size_t steps = rhythm.text.size();
    const float width = ImGui::GetContentRegionAvail().x;
    const float cell = std::min(20.0F * theme.scale, width / static_cast<float>(steps));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t k = 0; k < steps; ++k) {
        const char mark = rhythm.text[k];
        const ImVec2 min{corner.x + static_cast<float>(k) * cell, corner.y};
        const float gap = 1.5F * theme.scale;
        // A held step joins the one before it.
        const float left = mark == '=' ? min.x - gap : min.x + gap;
        ImGui::SetCursorScreenPos(min);
        ImGui::PushID(static_cast<int>(k));
        const bool pressed = ImGui::InvisibleButton("step", {cell, cell});
        note_item(app.rects, "step:" + std::to_string(k), std::string(1, mark));
        ImU32 colour = mark == '-' ? theme.field : theme.accent;
        if (ImGui::IsItemHovered()) colour = mark == '-' ? theme.hover : theme.text;
        list.AddRectFilled({left, min.y + gap}, {min.x + cell - gap, min.y + cell - gap}, colour,
                           2.0F * theme.scale);
        ImGui::PopID();
        if (pressed) set_rhythm(app, stepped(rhythm.text, k));
    }
    ImGui::SetCursorScreenPos({corner.x, corner.y + cell});
    ImGui::Dummy({width, 2.0F * theme.scale});
}

}  // namespace

void draw_rhythm_fields(App& app, const Pattern& pattern) {
    EditorState& state = app.editor;
    draw_label(app, "Rhythm", 120.0F * app.theme.scale);
    if (!state.rhythm_typing) state.rhythm_text = pattern.rhythm.text;
    ImGui::SetNextItemWidth(-1.0F);
    const char* long_hint = "one note throughout; x=-x note, hold, rest";
    const bool has_room = button_width(long_hint) <= ImGui::GetContentRegionAvail().x;
    ImGui::InputTextWithHint("##rhythm", has_room ? long_hint : "one note", &state.rhythm_text);
    draw_tooltip(app, "x note, = hold, - rest; the text repeats. Empty: one note throughout.");
    note_item(app.rects, "rhythm", pattern.rhythm.text);
    state.rhythm_typing = ImGui::IsItemActive();
    const std::string fault = rhythm_fault(state.rhythm_text);
    if (state.rhythm_typing && fault.empty() && state.rhythm_text != pattern.rhythm.text) {
        edit_patterns(app, [&state](Pattern& p) { p.rhythm.text = state.rhythm_text; });
    }
    if (ImGui::IsItemDeactivatedAfterEdit()) {
        // Up to where the text was a rhythm it was taken.
        commit_step(app, "Change " + of_selection(app, "rhythm"));
        if (!fault.empty()) {
            complain(app, "Rhythm: " + fault + "; the pattern keeps " +
                              (pattern.rhythm.text.empty() ? "one note throughout"
                                                           : "\"" + pattern.rhythm.text + "\""));
        }
    }
    if (state.rhythm_typing && !fault.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(app.theme.error));
        ImGui::TextWrapped("%s", fault.c_str());
        ImGui::PopStyleColor();
    }
    if (pattern.rhythm.text.empty()) {
        draw_label(app, "", 120.0F * app.theme.scale);
        if (link(app, "make grid", "Make a rhythm")) set_rhythm(app, "x=--x=--");
        note_item(app.rects, "link:make a rhythm");
        return;
    }
    draw_rhythm_grid(app, pattern.rhythm);
    edit_number(app,
                {.id = "unit_ms",
                 .label = "Step",
                 .format = "%.4g ms",
                 .slider = {5.0, 500.0},
                 .typed = {1.0, 10'000.0},
                 .step = 5.0,
                 .snap = 1.0,
                 .logarithmic = true,
                 .help = "Length of one x, = or -. The text repeats to fill the duration."},
                1000.0 * pattern.rhythm.unit_s, "rhythm step",
                [](Pattern& p, double value) { p.rhythm.unit_s = value / 1000.0; });
}

}  // namespace tact
