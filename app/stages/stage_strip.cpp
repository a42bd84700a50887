#include "app/stages/parts.h"

#include <cmath>

#include "app/document/editing.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr const char* kAllStages = "All stages";

// A stage in the strip, or all of them; below it, the distance of two patterns at this stage.
void draw_stage_chip(Ui& ui, Physiology& physiology, const Item& item, std::optional<Stage> stage,
                     std::optional<double> difference) {
    const bool pressed = chip(ui, item, physiology.view.open == stage);
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
    physiology.view.open = physiology.view.open == stage ? std::nullopt : stage;
}

std::string compare_words(const Ui& ui, const Workspace& work) {
    constexpr float kMostPx = 180.0F;  // the name's width
    const std::string& pinned = work.selection.pinned;
    if (pinned.empty()) return "Compare with\u2026";
    return "compared with " + shortened(ui.theme.fonts.regular, pinned, kMostPx * ui.theme.scale);
}

constexpr const char* kUnpin = "\u00d7";
constexpr const char* kFold = "Fold";
constexpr const char* kTextbook = "Textbook";
constexpr const char* kMore = "More\u2026";
constexpr const char* kHint =
    "Space plays silently, in slow motion; drag in any plot to move through time; a stage's name "
    "opens it large.";

const char* tour_words(bool tour_begun) { return tour_begun ? "Resume the tour" : "Tour"; }

float words_px(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

// Places the popup that begins next: below its button, and within the pane.
void open_below(const Theme& theme, const Rect& asked) {
    const float middle = ImGui::GetWindowPos().x + 0.5F * ImGui::GetWindowSize().x;
    const bool at_right = asked.centre().x > middle;
    ImGui::SetNextWindowPos(
        {at_right ? asked.max.x : asked.min.x, asked.max.y + 0.5F * theme.gap_px},
        ImGuiCond_Appearing, {at_right ? 1.0F : 0.0F, 0.0F});
}

void draw_patterns_to_compare(Ui& ui, Workspace& work) {
    for (const Vibration& vibration : work.document.set.vibrations) {
        if (&vibration == current_vibration(work)) continue;
        const Item item{.id = "pin:" + vibration.name, .label = vibration.name};
        if (option(ui, item, work.selection.pinned == vibration.name))
            work.selection.pinned = vibration.name;
    }
}

StagesAction draw_links(Ui& ui, Workspace& work, Physiology& physiology, bool tour_begun,
                        float gap_px) {
    StagesAction action = StagesAction::none;
    check(
        ui,
        {.id = "textbook",
         .label = kTextbook,
         .tip = "What was measured in skin, fibres, brain and people, with its sources, over each "
                "stage, and where the model parts from it"},
        physiology.view.textbook);
    const std::string compare = compare_words(ui, work);
    flow_on(words_px(compare), gap_px);
    if (row_link(ui, {.id = "compare with", .label = compare})) ImGui::OpenPopup("compare with");
    if (!work.selection.pinned.empty()) {
        ImGui::SameLine();
        const Item unpin{.id = "unpin", .label = kUnpin, .tip = "Show one pattern again"};
        if (row_link(ui, unpin)) work.selection.pinned.clear();
    }
    const char* tour = tour_words(tour_begun);
    flow_on(words_px(tour), gap_px);
    if (row_link(ui, {.id = "start tour", .label = tour})) action = StagesAction::tour;
    flow_on(words_px(kFold), gap_px);
    const Item fold{
        .id = "stages:fold", .label = kFold, .tip = "The stages in one row, and room for the map"};
    if (row_link(ui, fold)) action = StagesAction::fold;
    return action;
}

// The links as a menu, for a pane without room for them.
StagesAction draw_more(Ui& ui, Workspace& work, Physiology& physiology, bool tour_begun) {
    if (link(ui, {.id = "stages:more", .label = kMore})) ImGui::OpenPopup("more of the stages");
    if (!ImGui::IsPopupOpen("more of the stages")) return StagesAction::none;
    open_below(ui.theme, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
    if (!ImGui::BeginPopup("more of the stages")) return StagesAction::none;
    StagesAction action = StagesAction::none;
    if (ImGui::BeginMenu("Compare with")) {
        draw_patterns_to_compare(ui, work);
        ImGui::EndMenu();
    }
    const auto row = [&](const char* words, const char* id, bool enabled = true) {
        const bool chosen = draw_menu_row(ui.theme, {.words = words, .enabled = enabled});
        note_item(ui.rects, id);
        return chosen;
    };
    bool& textbook = physiology.view.textbook;
    if (row(textbook ? "Without the textbook" : "Textbook over the stages", "textbook")) {
        textbook = !textbook;
    }
    const bool pinned = !work.selection.pinned.empty();
    if (row("Show one pattern again", "unpin", pinned)) work.selection.pinned.clear();
    if (row(tour_words(tour_begun), "start tour")) action = StagesAction::tour;
    if (row("Fold into one row", "stages:fold")) action = StagesAction::fold;
    ImGui::PushTextWrapPos(260.0F * ui.theme.scale);
    dim_text(ui, kHint);
    ImGui::PopTextWrapPos();
    ImGui::EndPopup();
    return action;
}

}  // namespace

StagesAction draw_strip(Ui& ui, Workspace& work, Physiology& physiology, bool tour_begun) {
    const float gap = 2.0F * ui.theme.scale;
    const ShownDifference& difference = physiology.view.difference;
    float all_px = chip_width(ui, kAllStages);
    for (const Stage stage : kStages) all_px += gap + chip_width(ui, text_of(stage).short_name);
    const bool in_line = all_px <= ImGui::GetContentRegionAvail().x;
    if (in_line && !physiology.view.open) draw_hint(ui, "physiology", kHint);
    draw_stage_chip(ui, physiology, {.id = "stage:all", .label = kAllStages}, {}, {});
    for (const Stage stage : kStages) {
        const StageText& text = text_of(stage);
        flow_on(chip_width(ui, text.short_name), gap);
        const Item item{.id = std::string("stage:") + text.key,
                        .label = text.short_name,
                        .tip = std::string(text.name) + ": " + text.detail};
        draw_stage_chip(ui, physiology, item, stage,
                        difference.a ? difference.stages[index_of(stage)] : std::nullopt);
    }
    if (ui.presenting) return StagesAction::none;

    const float apart = 2.0F * ui.theme.padding_px;
    const float unpin_px =
        work.selection.pinned.empty() ? 0.0F : ui.theme.gap_px + words_px(kUnpin);
    const float links_px = check_width(ui.theme, kTextbook) + words_px(compare_words(ui, work)) +
                           unpin_px + words_px(tour_words(tour_begun)) + words_px(kFold) +
                           3.0F * apart;
    const Rect last{ImGui::GetItemRectMin(), ImGui::GetItemRectMax()};
    const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
    const bool beside = last.max.x + apart + links_px <= right;
    const bool as_menu = !beside && !in_line;
    const float width = as_menu ? words_px(kMore) : links_px;
    if (flow_on(width, apart)) {
        const float height = as_menu ? ImGui::GetTextLineHeight() : ImGui::GetFrameHeight();
        const float down = std::floor(0.5F * (last.height() - height));
        ImGui::SetCursorScreenPos({right - width, last.min.y + down});
    }
    ImGui::BeginGroup();
    const StagesAction action = as_menu ? draw_more(ui, work, physiology, tour_begun)
                                        : draw_links(ui, work, physiology, tour_begun, apart);
    ImGui::EndGroup();
    if (ImGui::IsPopupOpen("compare with")) {
        open_below(ui.theme, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
    }
    if (ImGui::BeginPopup("compare with")) {
        draw_patterns_to_compare(ui, work);
        ImGui::EndPopup();
    }
    return action;
}

}  // namespace tact
