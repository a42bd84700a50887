#include "app/physiology/stage_strip.h"

#include <cstdio>

#include "app/document/editing.h"
#include "app/physiology/stage_views.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

// A stage in the strip; beneath it, how far two patterns are apart there.
void draw_stage_chip(Ui& ui, Physiology& physiology, const char* key, const char* text, bool lit,
                     std::optional<double> difference) {
    const bool pressed = draw_chip(ui, key, text, lit);
    note_item(ui.rects, std::string("stage:") + key);
    if (difference) {
        const Theme& theme = ui.theme;
        const ImVec2 corner{ImGui::GetItemRectMin().x,
                            ImGui::GetItemRectMax().y + 1.0F * theme.scale};
        const ImVec2 end{ImGui::GetItemRectMax().x, corner.y + 3.0F * theme.scale};
        const float share = static_cast<float>(*difference);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(corner, end, theme.field);
        list.AddRectFilled(corner, {corner.x + share * (end.x - corner.x), end.y},
                           difference_colour(theme));
    }
    if (!pressed) return;
    const std::optional<Stage> stage = stage_named(key);
    physiology.view.open = physiology.view.open == stage ? std::nullopt : stage;
}

}  // namespace

void draw_strip(Ui& ui, Physiology& physiology) {
    const float gap = 2.0F * ui.theme.scale;
    const ShownDifference& difference = physiology.view.difference;
    draw_stage_chip(ui, physiology, "all", "All stages", !physiology.view.open, std::nullopt);
    for (const Stage stage : kStages) {
        const StageText& text = text_of(stage);
        ImGui::SameLine(0.0F, gap);
        const float wanted =
            text_size(ui.theme.fonts.small, text.short_name).x + 12.0F * ui.theme.scale;
        if (ImGui::GetContentRegionAvail().x < wanted) ImGui::NewLine();
        draw_stage_chip(ui, physiology, text.key, text.short_name, physiology.view.open == stage,
                        difference.a ? difference.stages[index_of(stage)] : std::nullopt);
        char tip[160];
        std::snprintf(tip, sizeof tip, "%s: %s", text.name, text.detail);
        draw_tooltip(ui, tip);
    }
    if (difference.a) ImGui::Dummy({1.0F, 1.0F * ui.theme.scale});
}

namespace {

// Below the link that opens it.
void draw_pin_list(Ui& ui, Workspace& work) {
    open_below_last_item(ui.theme);
    if (!ImGui::BeginPopup("compare with")) return;
    for (const Vibration& vibration : work.document.set.vibrations) {
        if (&vibration == current_vibration(work)) continue;
        if (ImGui::Selectable(vibration.name.c_str(), work.selection.pinned == vibration.name)) {
            work.selection.pinned = vibration.name;
        }
        note_item(ui.rects, "pin:" + vibration.name);
    }
    ImGui::EndPopup();
}

}  // namespace

bool draw_pin_choice(Ui& ui, Workspace& work, bool tour_begun) {
    const bool pinned = !work.selection.pinned.empty();
    const std::string text =
        pinned ? "compared with " + work.selection.pinned : "Compare with\u2026";
    if (link(ui, "compare", text)) ImGui::OpenPopup("compare with");
    note_item(ui.rects, "compare with");
    draw_pin_list(ui, work);
    if (pinned) {
        ImGui::SameLine();
        if (link(ui, "unpin", "\u00d7")) work.selection.pinned.clear();
        note_item(ui.rects, "unpin");
        draw_tooltip(ui, "Show one pattern again");
    }
    ImGui::SameLine(0.0F, 2.0F * ui.theme.padding_px);
    const bool tour_asked = link(ui, "tour", tour_begun ? "Resume the tour" : "Tour");
    note_item(ui.rects, "start tour");
    return tour_asked;
}

}  // namespace tact
