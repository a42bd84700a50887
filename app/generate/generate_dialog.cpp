// The dialog for candidates: what may vary, what that makes, and a look at some of it.

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/generate/generate.h"
#include "app/generate/parts.h"
#include "app/progress/progress.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kDialogWidthPx = 860.0F;
constexpr std::size_t kMostPreviews = 8;
constexpr std::size_t kFewestPreviews = 4;  // that share the width: fewer leave some of it
constexpr float kPreviewHeightPx = 34.0F;

std::string patterns(std::size_t count) { return counted(count, "pattern", "patterns"); }

// Where the combinations went that are no new patterns.
std::string losses(const GeneratePlan& plan) {
    const Rejections& rejected = plan.found.rejected;
    const std::size_t known = plan.found.kept.size() - plan.add.fresh.size();
    const std::array<std::pair<std::size_t, const char*>, 5> parts{
        {{plan.found.doubles, plan.found.doubles == 1 ? "double" : "doubles"},
         {rejected.band, "outside the device band"},
         {rejected.displacement, "with too much displacement"},
         {rejected.detectability, "not detectable enough"},
         {known, "in the set already"}}};
    std::string text = counted(plan.found.combinations, "combination", "combinations");
    for (const auto& [count, what] : parts) {
        if (count > 0) text += ", " + grouped_digits(count) + " " + what;
    }
    return text;
}

// A stale plan, of the draft as it was a moment ago, is dimmed until the new one is there.
void draw_counts(Ui& ui, const GeneratePlan* plan, bool stale) {
    const Theme& theme = ui.theme;
    const bool fault = plan != nullptr && !plan->fault.empty();
    const Said head{.id = "generate:count",
                    .text = plan == nullptr ? "Counting..."
                            : fault         ? "No patterns"
                                            : patterns(plan->add.fresh.size())};
    ImGui::PushFont(theme.fonts.large);
    stale ? dim_text(ui, head) : plain_text(ui, head);
    ImGui::PopFont();
    if (plan == nullptr) {
        dim_text(ui, "");
        return dim_text(ui, "");
    }
    if (fault) {
        return coloured_text(ui, theme.error, {.id = "generate:design fault", .text = plan->fault});
    }
    dim_text(ui, {.id = "generate:losses", .text = losses(*plan)});
    dim_text(ui, {.id = "generate:time",
                  .text = "With them the set has " + patterns(plan->add.patterns_after) +
                          "; its map takes " + estimate_text(plan->add.map_s) +
                          " at first, by a rough estimate"});
}

// Some of them, evenly from the first to the last.
void draw_previews(Ui& ui, Workspace& work, const GeneratePlan* plan) {
    const Theme& theme = ui.theme;
    const float s = theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const float name_px = theme.fonts.small != nullptr ? theme.fonts.small->FontSize : 13.0F * s;
    const float height = kPreviewHeightPx * s + name_px + 4.0F * s;
    ImGui::Dummy({width, height});
    if (plan == nullptr || plan->add.fresh.empty()) return;
    const std::vector<Candidate>& all = plan->add.fresh;
    const std::size_t count = std::min(all.size(), kMostPreviews);
    const float each = width / static_cast<float>(std::max(count, kFewestPreviews));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // One scale for all of them: what is stronger looks stronger.
    double reach_g = 0.0;
    for (const Candidate& candidate : all) {
        reach_g = std::max(reach_g, candidate.pattern.amplitude_g);
    }
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t place = count == 1 ? 0 : k * (all.size() - 1) / (count - 1);
        const ImVec2 low{corner.x + static_cast<float>(k) * each, corner.y};
        const Rect area = rect_at(low, {each - theme.gap_px, kPreviewHeightPx * s});
        list.AddRectFilled(area.min, area.max, theme.field, theme.rounding_px);
        Vibration vibration;
        vibration.name = "candidate preview " + std::to_string(k);
        vibration.source = all[place].pattern;
        draw_thumbnail(ui, work, inset(area, 3.0F * s), vibration, theme.series, reach_g);
        draw_text(list, theme.fonts.small, {low.x, area.max.y + 3.0F * s}, theme.dim_text,
                  shortened(theme.fonts.small, all[place].name, area.width()));
        note_rect(ui.rects, "generate:preview " + std::to_string(k), area.min, area.max,
                  all[place].name);
        ImGui::SetCursorScreenPos(area.min);
        ImGui::InvisibleButton(("preview " + std::to_string(k)).c_str(), area.size());
        if (ImGui::IsItemActive()) note_pressed(work, vibration);
        draw_tooltip(ui, (all[place].name + "\n" + kHoldHelp).c_str());
    }
    ImGui::SetCursorScreenPos({corner.x, corner.y + height + ImGui::GetStyle().ItemSpacing.y});
}

void close(Ui& ui, GenerateState& generating) {
    ui.dialog = kNoDialog;
    generating.asking.reset();
    ImGui::CloseCurrentPopup();
}

void take(Ui& ui, Workspace& work, GenerateState& generating, const GeneratePlan& plan,
          Before before) {
    const GenerateOutcome& outcome = before == Before::kept ? plan.add : plan.replace;
    if (outcome.patterns_after > kMostUnasked && !generating.asking) {
        generating.asking = before;
        return;
    }
    add_candidates(ui, work, generating, plan, before);
    close(ui, generating);
}

std::string words_of(const GeneratePlan& plan, Before before) {
    return before == Before::kept
               ? "Add " + patterns(plan.add.fresh.size())
               : "Replace " + grouped_digits(plan.generated_before) + " generated by " +
                     grouped_digits(plan.replace.fresh.size());
}

// Asks again if the patterns are enough to make every edit wait.
void draw_question(Ui& ui, Workspace& work, GenerateState& generating, const GeneratePlan& plan) {
    const Before before = *generating.asking;
    const GenerateOutcome& outcome = before == Before::kept ? plan.add : plan.replace;
    coloured_text(ui, ui.theme.warning,
                  {.id = "generate:question",
                   .text = "The set would have " + patterns(outcome.patterns_after) +
                           ". A first map of them takes " + estimate_text(outcome.map_s) +
                           ", and every edit of one waits for its share of it. You can go on "
                           "working meanwhile."});
    if (button(ui, {.id = "button:generate all the same",
                    .label = words_of(plan, before) + " all the same"})) {
        take(ui, work, generating, plan, before);
    }
    ImGui::SameLine();
    if (button(ui, {.id = "button:back", .label = "Back"})) generating.asking.reset();
}

void draw_buttons(Ui& ui, Workspace& work, GenerateState& generating, const GeneratePlan* plan) {
    const bool usable = plan != nullptr && plan->fault.empty();
    const bool add =
        primary_button(ui, {.id = "button:add candidates",
                            .label = usable ? words_of(*plan, Before::kept) : "Add patterns",
                            .enabled = usable && !plan->add.fresh.empty()});
    bool replace = false;
    if (usable && plan->generated_before > 0) {
        ImGui::SameLine();
        replace = button(ui, {.id = "button:replace generated",
                              .label = words_of(*plan, Before::replaced),
                              .tip = "Patterns that were edited, renamed or locked since they were "
                                     "generated stay.",
                              .enabled = !plan->replace.fresh.empty()});
    }
    ImGui::SameLine();
    const bool leave = button(ui, {.id = "button:cancel", .label = "Cancel"});
    if (add) take(ui, work, generating, *plan, Before::kept);
    if (replace) take(ui, work, generating, *plan, Before::replaced);
    if (leave) close(ui, generating);
}

// To the side they scroll where the window is too narrow for a range with all its words.
void draw_parameters(Ui& ui, GenerateState& generating) {
    // How high and wide the rows are is known from the last frame; in the first one, about.
    const float about = 10.0F * ImGui::GetFrameHeightWithSpacing();
    const bool is_wide = generating.row_px > ImGui::GetContentRegionAvail().x;
    const float bar = is_wide ? ImGui::GetStyle().ScrollbarSize : 0.0F;
    const float height = (generating.rows_px > 0.0F ? generating.rows_px : about) + bar;
    if (ImGui::BeginChild("parameters", {0.0F, height}, false,
                          ImGuiWindowFlags_HorizontalScrollbar)) {
        draw_factor_rows(ui, generating);
        const ImGuiWindow& rows = *ImGui::GetCurrentWindowRead();
        generating.rows_px = rows.DC.CursorMaxPos.y - rows.DC.CursorStartPos.y;
        generating.row_px = rows.DC.CursorMaxPos.x - rows.DC.CursorStartPos.x;
    }
    ImGui::EndChild();
}

}  // namespace

namespace {

// Whose numbers the design may have begun with.
void draw_what_is_left_out(Ui& ui, const Workspace& work) {
    const Vibration* current = current_vibration(work);
    const auto* pattern = current == nullptr ? nullptr : std::get_if<Pattern>(&current->source);
    if (pattern == nullptr || !is_drawn(*pattern)) return;
    coloured_text(ui, ui.theme.warning,
                  {.id = "generate:left out",
                   .text = "Candidates have no curves and no transients: those of " +
                           current->name + " stay its own."});
}

}  // namespace

void draw_generate_dialog(Ui& ui, Workspace& work, GenerateState& generating) {
    if (!begin_dialog(ui, kGenerateDialog, kDialogWidthPx)) return;
    // Esc leaves an entry first, then the dialog.
    const bool typing = !generating.typing.empty() || is_number_typed(ui);
    const bool popup = ImGui::IsPopupOpen("rhythms", ImGuiPopupFlags_AnyPopupId);
    dim_text(ui, "Give every parameter a number, several levels, or a range.");
    draw_what_is_left_out(ui, work);
    draw_parameters(ui, generating);
    draw_divider(ui.theme);
    draw_design_row(ui, generating);
    draw_constraint_rows(ui, generating);
    draw_divider(ui.theme);
    if (std::exchange(generating.takes_back, false)) {
        generating.draft = generating.draft_before_typing;
    }
    follow_generate(ui, work, generating);
    const std::shared_ptr<const GeneratePlan> plan = current_plan(work, generating);
    std::shared_ptr<const GeneratePlan> shown = plan;
    if (!shown) shown = generating.job.latest();
    draw_counts(ui, shown.get(), !plan);
    (void)draw_failure(ui, "generate", generating.job.failure());
    draw_previews(ui, work, shown.get());
    begin_foot(ui);
    ImGui::Spacing();
    if (generating.asking && plan && plan->fault.empty()) {
        draw_question(ui, work, generating, *plan);
    } else {
        draw_buttons(ui, work, generating, plan.get());
    }
    const bool escape = ImGui::IsKeyPressed(ImGuiKey_Escape, false);
    if (escape && !typing && !popup) close(ui, generating);
    end_foot();
}

}  // namespace tact
