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

std::string compare_words(const Ui& ui, const Workspace& work) {
    constexpr float kMostPx = 180.0F;  // of the name
    const std::string& pinned = work.selection.pinned;
    if (pinned.empty()) return "Compare with\u2026";
    return "compared with " + shortened(ui.theme.fonts.regular, pinned, kMostPx * ui.theme.scale);
}

void draw_compare_menu(Ui& ui, Workspace& work) {
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

constexpr const char* kUnpin = "\u00d7";
constexpr const char* kFold = "Fold";

}  // namespace

void draw_strip(Ui& ui, Physiology& physiology) {
    const float gap = 2.0F * ui.theme.scale;
    const ShownDifference& difference = physiology.view.difference;
    draw_stage_chip(ui, physiology, "all", "All stages", !physiology.view.open, std::nullopt);
    for (const Stage stage : kStages) {
        const StageText& text = text_of(stage);
        flow_on(chip_width(ui, text.short_name), gap);
        draw_stage_chip(ui, physiology, text.key, text.short_name, physiology.view.open == stage,
                        difference.a ? difference.stages[index_of(stage)] : std::nullopt);
        char tip[160];
        std::snprintf(tip, sizeof tip, "%s: %s", text.name, text.detail);
        draw_tooltip(ui, tip);
    }
}

PhysiologyDeed draw_strip_links(Ui& ui, Workspace& work, bool tour_begun) {
    const bool pinned = !work.selection.pinned.empty();
    const std::string compare = compare_words(ui, work);
    const char* const tour = tour_begun ? "Resume the tour" : "Tour";
    const float gap = 2.0F * ui.theme.padding_px;
    const auto width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
    const float unpin_px = pinned ? ui.theme.gap_px + width(kUnpin) : 0.0F;
    const float all_px = width(compare) + unpin_px + width(tour) + width(kFold) + 2.0F * gap;
    const float low = ImGui::GetItemRectMin().y;
    const float high = ImGui::GetItemRectMax().y;
    if (flow_on(all_px, gap)) {
        const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
        const float down = std::floor(0.5F * (high - low - ImGui::GetTextLineHeight()));
        ImGui::SetCursorScreenPos({right - all_px, low + down});
    }
    ImGui::BeginGroup();
    PhysiologyDeed deed = PhysiologyDeed::none;
    if (link(ui, "compare", compare)) ImGui::OpenPopup("compare with");
    note_item(ui.rects, "compare with");
    if (pinned) {
        ImGui::SameLine();
        if (link(ui, "unpin", kUnpin)) work.selection.pinned.clear();
        note_item(ui.rects, "unpin");
        draw_tooltip(ui, "Show one pattern again");
    }
    flow_on(width(tour), gap);
    if (link(ui, "tour", tour)) deed = PhysiologyDeed::tour;
    note_item(ui.rects, "start tour");
    flow_on(width(kFold), gap);
    if (link(ui, "fold", kFold)) deed = PhysiologyDeed::fold;
    note_item(ui.rects, "stages:fold");
    draw_tooltip(ui, "The stages in one row, and room for the map");
    ImGui::EndGroup();
    draw_compare_menu(ui, work);
    return deed;
}

}  // namespace tact
