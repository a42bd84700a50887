// The most distinct patterns: how many, by what, how good, how sure.

#include <algorithm>
#include <array>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/play/play.h"
#include "app/progress/progress.h"
#include "app/subset/parts.h"
#include "app/subset/subset.h"
#include "app/ui/widgets.h"
#include "model/subset/set_subset.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

void draw_views(Ui& ui, const Workspace& work, const ShownMap& shown_map, SubsetState& picking) {
    bool is_first = true;
    for (const auto& [view, name] : {std::pair{SubsetView::pick, "Pick"},
                                     {SubsetView::groups, "Groups"},
                                     {SubsetView::confusable, "Too close"},
                                     {SubsetView::stability, "How sure"}}) {
        if (!is_first) flow_on(chip_width(ui, name), 2.0F * ui.theme.scale);
        is_first = false;
        if (chip(ui, {.id = std::string("subset:") + name, .label = name}, picking.view == view))
            picking.view = view;
    }
    if (shown_pick(shown_map, picking) == nullptr) return;
    flow_on(ImGui::CalcTextSize("Export...").x, 2.0F * ui.theme.gap_px);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({corner.x, corner.y + 2.0F * ui.theme.scale});
    if (link(ui, {.id = "link:export subset",
                  .label = "Export...",
                  .tip = "The picked patterns as a set, with a page of tables and the map."})) {
        export_subset_dialog(ui, work, shown_map, picking);
    }
}

// Where there are fewer than are to be picked.
void draw_grow(Ui& ui, const Workspace& work, SubsetState& picking) {
    const auto& all = work.document.set.vibrations;
    const auto there = std::ranges::count_if(all, [](const Vibration& v) { return !v.dropped; });
    if (there == 0 || there >= picking.count) return;
    const std::string words = "Grow to " + std::to_string(picking.count);
    flow_on(ImGui::CalcTextSize(words.c_str()).x, ui.theme.gap_px);
    picking.grow_asked = row_link(
        ui, {.id = "link:grow",
             .label = words,
             .tip = "Adds as many as are missing, each as far from all others as can be: from the "
                    "set's design space, or from patterns drawn around these."});
}

void draw_count(Ui& ui, SubsetState& picking) {
    ImGui::AlignTextToFramePadding();
    plain_text(ui, {.id = "subset label:count", .text = "Pick"});
    reset_by_label(ui, SubsetState{}.count, picking.count);
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    enter_whole_with_buttons(ui,
                             {.id = "count",
                              .label = "Pick",
                              .format = "%.9g",
                              .rules = {{2.0, 1000.0}},
                              .width_px = 96.0F * ui.theme.scale},
                             picking.count);
    say_of_last_item(ui, {.id = "subset:count",
                          .text = std::to_string(picking.count),
                          .tip = "How many patterns the subset has."});
}

void draw_objective(Ui& ui, SubsetState& picking) {
    constexpr std::array kObjectives{
        Choice{SubsetObjective::max_min, "Weakest pair",
               "The two that are most alike are as far apart as can be: nobody confuses any two."},
        Choice{SubsetObjective::max_sum, "Sum",
               "All pairs together are as far apart as can be; two of them may still be alike."}};
    flow_on(segments_width(ui, kObjectives), 1.5F * ui.theme.gap_px);
    draw_segments(ui, kObjectives, picking.objective);
}

void draw_source(Ui& ui, const Workspace& work, SubsetState& picking) {
    const bool has_ratings = !work.document.set.ratings.empty();
    const char* shown = picking.by_ratings && has_ratings ? "Ratings" : traits(picking.metric).name;
    const float s = ui.theme.scale;
    const bool beside = flow_on(84.0F * s, 1.5F * ui.theme.gap_px);
    const float room = beside ? ImGui::GetContentRegionAvail().x : 120.0F * s;
    const std::string help = picking.by_ratings && has_ratings ? "Ratings: what people said."
                                                               : metric_help(picking.metric);
    const Item source{.id = "subset:source",
                      .label = shown,
                      .tip = "What says how far apart two patterns are. " + help};
    drop_down(
        ui, source, std::min(120.0F * s, room),
        [&] {
            for (const Metric metric : kMetrics) {
                const Item item{.id = std::string("subset source:") + traits(metric).key,
                                .label = traits(metric).name,
                                .tip = metric_help(metric)};
                const bool chosen = !picking.by_ratings && picking.metric == metric;
                if (!option(ui, item, chosen)) continue;
                picking.metric = metric;
                picking.by_ratings = false;
            }
            const Item ratings{.id = "subset source:ratings", .label = "Ratings"};
            if (has_ratings && option(ui, ratings, picking.by_ratings)) picking.by_ratings = true;
        },
        ImGuiComboFlags_HeightRegular);
}

void draw_proof(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                const SubsetState& picking, const Pick& pick) {
    const SubsetAnswer& answer = pick.answer;
    const bool by_sum = pick.request.problem.objective == SubsetObjective::max_sum;
    std::string text = by_sum ? "Proven: no other subset has a larger sum."
                              : "Proven: in no other subset is the weakest pair farther apart.";
    ImU32 colour = ui.theme.dim_text;
    if (answer.proof == SubsetProof::ties_open) {
        text = "No weakest pair can be farther apart; the sum was not settled in time.";
        colour = ui.theme.warning;
    } else if (answer.proof == SubsetProof::open) {
        const std::string found = !pick.is_so_far     ? "The best found in time"
                                  : picking.cancelled ? "The best when it was cancelled"
                                                      : "The best by now";
        text = found + "; no " + (by_sum ? "sum" : "weakest pair") + " is above " +
               worth_text(answer.bound) + ".";
        colour = ui.theme.warning;
    }
    if (is_of_preview(pick.request)) {
        text = "A preview, by coarse envelopes; picked again once the map is exact.";
        colour = ui.theme.warning;
    }
    if (is_pick_stale(work, shown_map, picking)) {
        text = map_state(work, shown_map) == MapState::stale ? "From before the last change."
                                                             : "By the settings before.";
        colour = ui.theme.warning;
    }
    // Beside the headline, or where it has no room there below it.
    const ImFont* small = ui.theme.fonts.small;
    if (flow_on(text_size(small, text).x, 1.5F * ui.theme.gap_px)) {
        const float lower = ui.theme.fonts.regular->FontSize - small->FontSize;
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.8F * lower);
    }
    ImGui::PushFont(ui.theme.fonts.small);
    reading_text(ui, colour, {.id = "subset:proof", .text = text});
    ImGui::PopFont();
}

// What can be done with the two that are most alike.
void draw_weakest_pair(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                       PlayState& play, SubsetState& picking, const Pick& pick,
                       const std::string& a, const std::string& b) {
    std::string names = a + " \u2013 " + b;
    // Where the headline is the sum, this is beside it.
    const Subset& subset = *shown_subset(shown_map, picking);
    if (pick.request.problem.objective == SubsetObjective::max_sum) {
        names = "weakest pair " + worth_text(subset.weakest_dissimilarity) + ": " + names;
    }
    const std::string shown =
        shortened(ui.theme.fonts.regular, names, ImGui::GetContentRegionAvail().x);
    if (name_link(ui, {.id = "link:weakest pair",
                       .label = shown,
                       .tip = names + ": shows the two in every pane.",
                       .value = a + "|" + b})) {
        open_pair(work, picking, a, b);
    }
    const auto first = place_named(work.document.set, a);
    const auto second = place_named(work.document.set, b);
    if (!first || !second) return;
    const bool plays = timeline.playhead.playing;
    const char* act = plays ? "Stop" : "Play both";
    flow_on(ImGui::CalcTextSize(act).x, 1.5F * ui.theme.gap_px);
    if (link(ui, {.id = "link:play pair",
                  .label = act,
                  .tip = "One after the other; without a device silently, the first alone."})) {
        plays ? stop_playing(timeline, play) : play_pair(ui, work, timeline, play, *first, *second);
    }
    if (pick.request.by_ratings || pick.request.metric != Metric::pm) return;
    constexpr const char* kAsk = "What would separate them?";
    flow_on(ImGui::CalcTextSize(kAsk).x, 1.5F * ui.theme.gap_px);
    if (link(ui, {.id = "link:separate pair",
                  .label = kAsk,
                  .tip = "The smallest change of one number that brings one of the two farther "
                         "from all others of the subset."})) {
        ask_about_picked(ui, work, shown_map, picking, a, b);
    }
}

// What the subset is worth by what was asked for, large: its weakest pair, or its sum.
void draw_headline(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                   PlayState& play, SubsetState& picking, const Pick& pick, const Subset& subset) {
    const std::string a = name_of(pick, subset.weakest.first);
    const std::string b = name_of(pick, subset.weakest.second);
    ImGui::PushFont(ui.theme.fonts.headline);
    const bool by_sum = pick.request.problem.objective == SubsetObjective::max_sum;
    const double worth = worth_of(subset, pick.request.problem.objective);
    plain_text(ui, {.id = by_sum ? "subset:sum" : "subset:weakest",
                    .text = worth_text(worth),
                    .value = shortest_digits(worth)});
    ImGui::PopFont();
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    const float lower = ui.theme.fonts.headline->FontSize - ui.theme.fonts.regular->FontSize;
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.8F * lower);
    const std::string what = quantity_of(pick.request, pick.mark) +
                             (by_sum ? ", the sum of all pairs" : " of the weakest pair");
    dim_text(ui, shortened(ui.theme.fonts.regular, what, ImGui::GetContentRegionAvail().x));
    draw_proof(ui, work, shown_map, picking, pick);
    draw_weakest_pair(ui, work, timeline, shown_map, play, picking, pick, a, b);
}

// Those that nobody feels, and whether they may be picked.
void draw_unfelt_choice(Ui& ui, SubsetState& picking) {
    const std::size_t count = picking.asked.unfelt;
    if (count == 0) return;
    const std::string words = picking.with_unfelt
                                  ? std::to_string(count) + " not felt may be picked."
                                  : left_out_words(count) + ": nobody could tell it from nothing.";
    ImGui::PushFont(ui.theme.fonts.small);
    reading_text(ui, picking.with_unfelt ? ui.theme.warning : ui.theme.dim_text,
                 {.id = "subset:unfelt", .text = words});
    ImGui::PopFont();
    const char* act = picking.with_unfelt ? "Leave out" : "Include";
    flow_on(ImGui::CalcTextSize(act).x, ui.theme.gap_px);
    if (link(ui, {.id = "link:include unfelt",
                  .label = act,
                  .tip = "No receptor of the model answers to them. Locked ones are picked in any "
                         "case."})) {
        picking.with_unfelt = !picking.with_unfelt;
    }
}

// True where there is a subset to draw.
bool draw_pick_state(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                     SubsetState& picking) {
    if (is_picking(picking)) {
        if (draw_progress(ui, {"Picking", picking.pick_job.progress(), "picking"}))
            cancel_picking(picking);
    } else if (picking.cancelled) {
        dim_text(ui, "Cancelled.");
        ImGui::SameLine();
        if (link(ui, {.id = "link:pick again", .label = "Pick again"})) picking.asked = {};
    }
    const bool failed = draw_failure(ui, "subset", picking.pick_job.failure());
    (void)draw_failure(ui, "curve", picking.curve_job.failure());
    if (shown_pick(shown_map, picking) != nullptr) return true;
    if (failed) return false;
    const bool has_fault = picking.pick && !picking.pick->fault.empty() && !is_picking(picking);
    const Rect area = rest_of_pane();
    if (area.empty()) return false;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (work.document.set.vibrations.size() < 2) {
        draw_empty(list, ui.theme, area, "Nothing to pick from",
                   "It takes two patterns to be alike or far apart.");
    } else if (is_picking(picking)) {
        draw_empty(list, ui.theme, area, "Picking",
                   "With many patterns it takes some seconds to prove that no others are better.");
    } else {
        draw_empty(list, ui.theme, area,
                   has_fault ? "Nothing can be picked so" : "Nothing picked yet",
                   has_fault ? picking.pick->fault
                             : "The subset is picked as soon as there is a space above.");
        if (has_fault) note_rect(ui.rects, "subset:fault", area.min, area.max, picking.pick->fault);
    }
    return false;
}

}  // namespace

std::string quantity_of(const PickRequest& request, const NumberMark& mark) {
    if (request.by_ratings) return of_counted("rating", mark);
    return traits(request.metric).name;
}

Rect rest_or_lines(float lines) {
    Rect area = rest_of_pane();
    const float least = lines * ImGui::GetTextLineHeightWithSpacing();
    area.max.y = std::max(area.max.y, area.min.y + least);
    area.max.x = std::max(area.max.x, area.min.x + 1.0F);
    return area;
}

PatternAction draw_pick_view(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                             PlayState& play, SubsetState& picking) {
    draw_count(ui, picking);
    draw_grow(ui, work, picking);
    draw_objective(ui, picking);
    draw_source(ui, work, picking);
    draw_unfelt_choice(ui, picking);
    PatternAction action = PatternAction::none;
    if (!draw_pick_state(ui, work, shown_map, picking)) return action;
    const std::shared_ptr<const Pick> pick = picking.pick;  // kept while it is drawn
    draw_headline(ui, work, timeline, shown_map, play, picking, *pick,
                  *shown_subset(shown_map, picking));
    const Subset& subset = *shown_subset(shown_map, picking);
    const Rect area = rest_or_lines(5.0F);
    const float s = ui.theme.scale;
    const float list_px =
        member_row_px(ui, area.width()) * static_cast<float>(subset.members.size());
    const WordsWanted list{212.0F * s, 560.0F * s,
                           list_px + alternatives_px(ui, picking, *pick, area.width())};
    WordsAndPicture parts{area, {area.max, area.max}};
    if (has_curve(picking)) {
        parts = words_and_picture(area, list, {90.0F * s, 120.0F * s}, 1.5F * ui.theme.gap_px);
    }
    ImGui::BeginChild("members", parts.words.size());
    std::size_t number = 0;
    for (const std::size_t member : subset.members) {
        const PatternAction asked = draw_member(ui, work, name_of(*pick, member), ++number);
        if (asked != PatternAction::none) action = asked;
    }
    draw_alternatives(ui, picking, *pick);
    ImGui::EndChild();
    if (!parts.picture.empty()) draw_curve(ui, shown_map, picking, parts.picture);
    return action;
}

PatternAction draw_subset_panel(Ui& ui, Workspace& work, Timeline& timeline,
                                const ShownMap& shown_map, PlayState& play, SubsetState& picking) {
    PatternAction action = PatternAction::none;
    draw_views(ui, work, shown_map, picking);
    ImGui::Dummy({1.0F, 1.0F});
    ImGui::BeginChild("view");  // scrolls where the pane is low
    switch (picking.view) {
        case SubsetView::pick:
            action = draw_pick_view(ui, work, timeline, shown_map, play, picking);
            break;
        case SubsetView::groups:
            draw_groups_view(ui, work, shown_map, picking);
            break;
        case SubsetView::confusable:
            draw_too_close_view(ui, work, shown_map, picking);
            break;
        case SubsetView::stability:
            draw_stability_view(ui, work, shown_map, picking);
            break;
    }
    ImGui::EndChild();
    return action;
}

}  // namespace tact
