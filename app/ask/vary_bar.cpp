#include "app/ask/vary_bar.h"

#include <cstdio>

#include "app/ask/maybes_follow.h"
#include "app/ui/failure.h"
#include "app/ui/widgets.h"

namespace tact {

void draw_vary_bar(Ui& ui, const Workspace& work, MaybesState& state) {
    if (state.varied.empty()) return;
    if (!place_named(work.document.set, state.varied)) return stop_varying(state);
    ImGui::AlignTextToFramePadding();
    dim_text(ui, "Neighbours of " + state.varied + ": how far");
    const float width = 170.0F * ui.theme.scale;
    flow_on(width, ui.theme.gap_px);
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
    const auto word = [&](const char* id, const char* text, const char* help) {
        flow_on(ImGui::CalcTextSize(text).x, 1.5F * ui.theme.gap_px);
        const bool pressed = link(ui, id, text);
        note_item(ui.rects, std::string("link:") + id);
        draw_tooltip(ui, help);
        return pressed;
    };
    if (word("vary again", "Others (V)", "Eight others, as far away.")) ++state.vary_seed;
    if (word("vary stop", "Done", "The pattern stays as it is.")) return stop_varying(state);
    const auto found = found_variants(state);
    flow_on(120.0F * ui.theme.scale, 1.5F * ui.theme.gap_px);
    const std::string failure = failure_of(state.variants.job);
    dim_text(ui, !failure.empty() ? failure
                 : found          ? "a preview; click one to take it, hold to feel it"
                                  : "searching");
    note_item(ui.rects, "vary:found", found ? std::to_string(found->patterns.size()) : "");
}

}  // namespace tact
