// How sure the picked subset is, when what is uncertain in the model is drawn at random.

#include <algorithm>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/progress/progress.h"
#include "app/subset/parts.h"
#include "app/subset/subset.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr const char* kTestVariants = "Test 100 variants";
constexpr std::size_t kVariants = 100;
constexpr const char* kTestHelp =
    "Thresholds of each receptor type within 6 dB, choices the paper leaves open, weights near the "
    "trained ones: 100 models, and what each would pick.";

// Why variants of the model say nothing of a subset; empty where they do.
std::string obstacle_to_asking(const Pick* pick) {
    if (pick == nullptr) return "Nothing is picked yet: see Pick.";
    if (is_of_preview(pick->request))
        return "The subset is of a preview: ask once the map is exact.";
    if (pick->request.by_ratings || pick->request.metric != Metric::pm) {
        return "Only a subset picked by PM hangs on the model's numbers.";
    }
    return pick->is_so_far ? "The search for the subset is not at its end: see Pick." : "";
}

void draw_ask(Ui& ui, const ShownMap& shown_map, SubsetState& picking) {
    const bool busy = picking.stability_job.busy();
    const Pick* pick = shown_pick(shown_map, picking);
    const std::string obstacle = obstacle_to_asking(pick);
    if (primary_button(ui, {.id = "button:draw models",
                            .label = kTestVariants,
                            .tip = kTestHelp,
                            .enabled = !busy && obstacle.empty()})) {
        ask_for_stability(ui, picking, kVariants);
    }
    if (busy) {
        ImGui::SameLine();
        if (draw_progress(ui, {"Testing variants", picking.stability_job.progress(), "stability"},
                          true)) {
            picking.stability_job.cancel();
        }
    } else if (draw_failure(ui, "stability", picking.stability_job.failure())) {
        return;
    } else if (!obstacle.empty()) {
        reading_text(ui, ui.theme.dim_text, {.id = "stability obstacle", .text = obstacle});
    }
}

void draw_share(Ui& ui, const std::string& name, double share, bool is_member) {
    const Theme& theme = ui.theme;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(shown_text(name).c_str());
    ImGui::TableNextColumn();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x - 48.0F * theme.scale;
    const float height = ImGui::GetTextLineHeight();
    const Rect bar = rect_at({corner.x, corner.y + 0.25F * height}, {width, 0.5F * height});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(bar.min, bar.max, theme.field, 2.0F * theme.scale);
    list.AddRectFilled(bar.min, {bar.min.x + width * static_cast<float>(share), bar.max.y},
                       is_member ? theme.series : theme.dim_text, 2.0F * theme.scale);
    draw_text(list, theme.fonts.small, {bar.max.x + theme.gap_px, corner.y}, theme.dim_text,
              percent(share));
    ImGui::Dummy({width, height});
    note_rect(ui.rects, "stability:" + name, bar.min, bar.max, std::to_string(share));
}

void draw_shares(Ui& ui, const SubsetState& picking, const Stability& stability) {
    const auto names = names_of(*found_stability(picking)->request.pick->request.map->request.set);
    ImGui::BeginChild("shares", {0.0F, rest_or_lines(4.0F).height()});
    if (ImGui::BeginTable("shares", 2, ImGuiTableFlags_NoSavedSettings)) {
        for (const std::size_t k : ever_picked(stability)) {
            draw_share(ui, names[k], stability.share_picked[k],
                       std::ranges::binary_search(stability.subset.members, k));
        }
        ImGui::EndTable();
    }
    ImGui::EndChild();
}

}  // namespace

void draw_stability_view(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                         SubsetState& picking) {
    const Stability* stability = shown_stability(picking);
    // Below what it is for, until there is an answer to stand above.
    const bool busy = picking.stability_job.busy();
    const bool first = stability == nullptr &&
                       obstacle_to_asking(shown_pick(shown_map, picking)).empty() && !busy &&
                       picking.stability_job.failure().empty();
    if (!first) draw_ask(ui, shown_map, picking);
    if (stability == nullptr) {
        const Rect area = rest_of_pane();
        if (area.empty()) return;
        constexpr const char* kTitle = "How sure is this subset?";
        constexpr const char* kReason =
            "The model has numbers nobody knows exactly. Vary them at random, and see who stays "
            "picked and how far each point moves.";
        if (first) {
            const Item item{.id = "button:draw models", .label = kTestVariants, .tip = kTestHelp};
            if (draw_empty_with(ui, area, kTitle, kReason, item))
                ask_for_stability(ui, picking, kVariants);
        } else {
            draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, kTitle, kReason);
        }
        return;
    }
    const std::string text = "The same subset in " + percent(stability->share_same) +
                             " of the draws, the same weakest pair in " +
                             percent(stability->share_weakest) +
                             ". In the map, each ellipse holds half of the draws of its point.";
    ImGui::PushFont(ui.theme.fonts.small);
    reading_text(ui, ui.theme.dim_text, {.id = "subset:stability", .text = text});
    if (is_pick_stale(work, shown_map, picking)) {
        reading_text(ui.theme.warning, "These numbers are of the subset before the last change.");
    }
    ImGui::PopFont();
    draw_shares(ui, picking, *stability);
}

}  // namespace tact
