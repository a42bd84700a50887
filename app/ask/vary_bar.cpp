#include "app/ask/ask.h"

#include <algorithm>

#include "app/progress/progress.h"
#include "app/ui/widgets.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

// The numbers that varying and moving may change.
void draw_free_numbers(Ui& ui, ProposalsState& state) {
    const std::string words = state.held.empty()
                                  ? "May change: all"
                                  : "Held: " + std::to_string(state.held.size()) +
                                        (state.held.size() == 1 ? " number" : " numbers");
    flow_on(ImGui::CalcTextSize(words.c_str()).x, 1.5F * ui.theme.gap_px);
    if (row_link(ui, {.id = "link:free numbers",
                      .label = words,
                      .tip = "Which numbers may change, here and when a point is put somewhere "
                             "(Alt+drag)."})) {
        ImGui::OpenPopup("free numbers");
    }
    float width = 0.0F;
    for (const PatternParameter parameter : kPatternParameters) {
        width = std::max(width, check_width(ui.theme, traits(parameter).name));
    }
    open_beside_pane(ui.theme, width + 2.0F * ui.theme.padding_px);
    if (!ImGui::BeginPopup("free numbers")) return;
    ImGui::PushFont(ui.theme.fonts.semibold);
    ImGui::TextUnformatted("Numbers that may change");
    ImGui::PopFont();
    for (const PatternParameter parameter : kPatternParameters) {
        const auto held = std::ranges::find(state.held, parameter);
        bool is_free = held == state.held.end();
        if (check(ui,
                  {.id = std::string("free:") + traits(parameter).key,
                   .label = traits(parameter).name},
                  is_free)) {
            if (is_free) state.held.erase(held);
            if (!is_free) state.held.push_back(parameter);
        }
    }
    ImGui::EndPopup();
}

// The varied pattern and its distance stand above the numbers, so that the numbers do not move.
void draw_found(Ui& ui, const ProposalsState& state) {
    dim_text(ui, shortened(ui.theme.fonts.regular, "Neighbours of " + state.varied,
                           ImGui::GetContentRegionAvail().x));
    const auto found = found_variants(state);
    const std::string failure = state.variants.failure();
    const std::string words = !failure.empty()       ? failure
                              : !found               ? "searching"
                              : found->request.exact ? "click one to take it, hold to feel it"
                                                     : "a preview; click to take, hold to feel";
    flow_on(ImGui::CalcTextSize(words.c_str()).x, 1.5F * ui.theme.gap_px);
    dim_text(ui, {.id = "vary:found",
                  .text = words,
                  .value = found ? std::to_string(found->patterns.size()) : ""});
}

void draw_put_bar(Ui& ui, ProposalsState& state) {
    if (!state.put.job.asked()) return;
    const std::string doing = "Putting " + state.put.name + " there";
    if (draw_progress(ui, {doing.c_str(), state.put.job.progress(), "put"}, true))
        stop_putting(state);
}

void draw_gap_bar(Ui& ui, ProposalsState& state) {
    if (!is_filling(state)) return;
    if (draw_progress(ui, {"Filling the gap", state.gap.progress(), "gap"}, true))
        stop_filling(state);
}

}  // namespace

void draw_vary_bar(Ui& ui, const Workspace& work, ProposalsState& state) {
    draw_put_bar(ui, state);
    draw_gap_bar(ui, state);
    if (state.varied.empty()) return;
    if (!place_named(work.document.set, state.varied)) return stop_varying(state);
    draw_found(ui, state);
    const float width = 250.0F * ui.theme.scale;
    draw_short_field(ui,
                     {.id = "how_far",
                      .label = "How far",
                      .format = "%.3g steps",
                      .slider = {1.0, 20.0},
                      .typed = {0.5, 100.0},
                      .step = 0.5,
                      .snap = 0.5,
                      .help = "How many felt steps each is away, all numbers together.",
                      .normal = 3.0},
                     width, state.how_far);
    note_item(ui.rects, "vary:how far");
    const auto word = [&](const Item& item) {
        flow_on(ImGui::CalcTextSize(item.label.c_str()).x, 1.5F * ui.theme.gap_px);
        return row_link(ui, item);
    };
    const std::string others = std::to_string(VaryQuestion{}.count) + " others, as far away.";
    if (word({.id = "link:vary again", .label = "Others (V)", .tip = others})) ++state.vary_seed;
    draw_free_numbers(ui, state);
    if (word({.id = "link:vary stop", .label = "Done", .tip = "The pattern does not change."}))
        return stop_varying(state);
}

}  // namespace tact
