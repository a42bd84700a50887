// Pairs that people may confuse, and what would separate them.

#include <algorithm>
#include <string_view>
#include <vector>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/progress/progress.h"
#include "app/subset/parts.h"
#include "app/subset/subset.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

void draw_share_slider(Ui& ui, SubsetState& picking) {
    constexpr Field kShare{.id = "closest_percent",
                           .label = "Share",
                           .format = "%.3g %%",
                           .slider = {0.5, 30.0},
                           .typed = {0.5, 100.0},
                           .step = 0.5,
                           .snap = 0.5,
                           .normal = 5.0};
    const float width = 204.0F * ui.theme.scale;
    flow_on(width, ui.theme.gap_px);
    double percent = 100.0 * picking.share;
    if (draw_short_field(ui, kShare, width, percent).changed) picking.share = percent / 100.0;
    note_item(ui.rects, "subset:share", std::to_string(picking.share));
}

void draw_reference(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                    SubsetState& picking) {
    if (const auto pair = chosen_pair(work, shown_map)) {
        flow_on(button_width("Take the chosen pair"), ui.theme.gap_px);
        if (button(ui, {.id = "button:reference",
                        .label = "Take the chosen pair",
                        .tip = "A pair you know: people tell these two apart just so. All that are "
                               "no farther apart are listed."})) {
            picking.reference_a = work.document.set.vibrations[pair->current].name;
            picking.reference_b = work.document.set.vibrations[pair->partner].name;
        }
    }
    ImGui::PushFont(ui.theme.fonts.small);
    dim_text(ui, picking.reference_a.empty()
                     ? "No pair taken yet."
                     : picking.reference_a + " \u2013 " + picking.reference_b);
    ImGui::PopFont();
}

void draw_threshold(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                    SubsetState& picking) {
    std::vector ways{
        Choice{TooClose::felt, "Felt step",
               "Pairs of which no number differs by the least change that people are taken to "
               "feel: see Model, What people feel. Most sets have none."},
        Choice{TooClose::share, "Closest", "This share of the set's pairs, the closest ones."},
        Choice{TooClose::picked, "Among the picked",
               "The closest pairs within the picked subset; a change has to part a pattern from "
               "the others of the subset only."},
        Choice{TooClose::reference, "Reference pair", "Pairs no farther apart than one you know."}};
    if (!work.document.set.ratings.empty()) {
        ways.push_back(
            {TooClose::ratings, "Rated closest", "The pairs that people rated most alike."});
    }
    draw_segments(ui, ways, picking.too_close);
    if (picking.too_close == TooClose::reference) {
        draw_reference(ui, work, shown_map, picking);
    } else if (picking.too_close != TooClose::felt) {
        draw_share_slider(ui, picking);
    }
}

const std::string& name_of(const TooClosePairs& pairs, std::size_t row) {
    return pairs.of->request.set->vibrations[row].name;
}

// "1 felt step", "2.3 felt steps".
std::string felt_steps_text(double steps) {
    const std::string text = significant(steps, 2);
    return text + (text == "1" ? " felt step" : " felt steps");
}

// Which pairs are listed: what "too close" means here.
std::string criterion_of(const TooClosePairs& pairs, const SubsetState& picking) {
    const std::string share = exact_percent(pairs.share);
    switch (pairs.by) {
        case TooClose::felt:
            return "within a felt step";
        case TooClose::share:
            return "among the closest " + share;
        case TooClose::picked:
            return "among the closest " + share + " of the picked";
        case TooClose::reference:
            return "no farther apart than " + picking.reference_a + " \u2013 " +
                   picking.reference_b;
        case TooClose::ratings:
            return "among the " + share + " rated closest";
    }
    return {};
}

// What the list has, or why it has nothing.
std::string summary_of(const SubsetState& picking, const TooClosePairs& pairs) {
    if (pairs.by == TooClose::picked && pairs.picked.size() < 2) {
        return "Nothing is picked yet: see Pick.";
    }
    if (pairs.by == TooClose::reference && picking.reference_a.empty()) {
        return "Click a pattern in the map, then another one, and take them.";
    }
    if (pairs.by == TooClose::felt && pairs.pairs.empty()) {
        return "Any two differ by a felt step in some number. By PM two may be close all the same: "
               "see Closest.";
    }
    if (pairs.pairs.empty()) return "None is closer than this.";
    const std::string total = grouped_digits(pairs.count) + (pairs.count == 1 ? " pair" : " pairs");
    const std::string which =
        " " + criterion_of(pairs, picking) +
        (pairs.mark == NumberMark{} ? "" : ", by " + of_counted("ratings", pairs.mark));
    if (pairs.count == pairs.pairs.size()) return total + which;
    return "The first " + grouped_digits(pairs.pairs.size()) + " of " + total + which;
}

void draw_pair(Ui& ui, Workspace& work, SubsetState& picking, const TooClosePairs& pairs,
               const ConfusablePair& pair, float column_px, bool open) {
    const std::string& a = name_of(pairs, pair.a);
    const std::string& b = name_of(pairs, pair.b);
    const std::string value = worth_text(pair.dissimilarity);
    const std::string names = a + " \u2013 " + b;
    const ImFont* font = ui.theme.fonts.regular;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float begin = column_px + 1.5F * ui.theme.gap_px;
    const std::string shown =
        shortened(font, names, std::max(1.0F, ImGui::GetContentRegionAvail().x - begin));
    if (option(ui,
               {.id = "too close:" + a + "|" + b,
                .label = "",
                .tip = shown == names ? "" : names,
                .value = value + "   " + names},
               open)) {
        open_pair(work, picking, a, b);
    }
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_text(list, font, {corner.x + column_px - text_size(font, value).x, corner.y},
              ui.theme.text, value);
    draw_text(list, font, {corner.x + begin, corner.y}, ui.theme.text, shown);
}

const char* unit_of(const TooClosePairs& pairs) {
    return pairs.by == TooClose::ratings ? "rating" : "PM";
}

// Above the numbers what they are.
void draw_unit(const Ui& ui, const TooClosePairs& pairs, float column_px) {
    const ImFont* small = ui.theme.fonts.small;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size = text_size(small, unit_of(pairs));
    draw_text(*ImGui::GetWindowDrawList(), small, {corner.x + column_px - size.x, corner.y},
              ui.theme.dim_text, unit_of(pairs));
    ImGui::Dummy({column_px, size.y});
}

// As wide as the widest of the numbers, which stand at its right, and what they are.
float value_column_px(const Ui& ui, const TooClosePairs& pairs) {
    float widest = text_size(ui.theme.fonts.small, unit_of(pairs)).x;
    for (const ConfusablePair& pair : pairs.pairs) {
        widest =
            std::max(widest, text_size(ui.theme.fonts.regular, worth_text(pair.dissimilarity)).x);
    }
    return widest;
}

void draw_pair_list(Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking,
                    const TooClosePairs& pairs) {
    const std::string summary = summary_of(picking, pairs);
    if (pairs.pairs.empty()) {
        const Rect area = rest_or_lines(3.0F);
        const bool waits = (pairs.by == TooClose::picked && pairs.picked.size() < 2) ||
                           (pairs.by == TooClose::reference && picking.reference_a.empty());
        draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area,
                   waits ? "No pairs to show yet" : "No pair is " + criterion_of(pairs, picking),
                   summary);
        return note_rect(ui.rects, "too close", area.min, area.max, summary);
    }
    ImGui::PushFont(ui.theme.fonts.small);
    reading_text(ui, ui.theme.dim_text, {.id = "too close", .text = summary});
    ImGui::PopFont();
    const auto opened = opened_rows(shown_map, picking);
    const float column_px = value_column_px(ui, pairs);
    draw_unit(ui, pairs, column_px);
    ImGui::BeginChild("pairs");
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(pairs.pairs.size()));
    while (clipper.Step()) {
        for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
            const ConfusablePair& pair = pairs.pairs[static_cast<std::size_t>(k)];
            draw_pair(ui, work, picking, pairs, pair, column_px,
                      opened == std::pair(pair.a, pair.b));
        }
    }
    ImGui::EndChild();
}

// Which of the two is changed. One that may not says why.
void draw_change_choice(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                        SubsetState& picking, std::pair<std::size_t, std::size_t> rows) {
    const std::size_t changed = row_to_change(work, shown_map, picking, rows);
    ImGui::AlignTextToFramePadding();
    dim_text(ui, "Change");
    for (const std::size_t row : {rows.first, rows.second}) {
        const std::string why = fixed_because(work, shown_map, row);
        const std::string name = shown_map.transition.shown->request.set->vibrations[row].name;
        const std::string text = name + (why.empty() ? "" : "  (" + why + ")");
        flow_on(segment_width(ui, text.c_str()), row == rows.first ? ui.theme.gap_px : 0.0F);
        const bool is_second = row == rows.second;
        const Item item{.id = is_second ? "radio:change second" : "radio:change first",
                        .label = text,
                        .enabled = why.empty()};
        if (segment(ui, item, changed == row)) picking.change_second = is_second;
    }
}

// Times are in ms, as in the editor.
std::string number(double value, std::string_view unit) {
    if (unit == "s") return significant(1000.0 * value) + " ms";
    const std::string text = significant(value);
    return unit.empty() ? text : text + " " + std::string(unit);
}

void draw_separation(Ui& ui, Workspace& work, SubsetState& picking, const FoundSeparations& found,
                     std::size_t k) {
    const Separation& separation = found.all[k];
    const ParameterTraits& about = traits(separation.parameter);
    const PatternSet& set = *found.request.map->request.set;
    const std::string text = std::string(about.name) + " " + number(separation.from, about.unit) +
                             " \u2192 " + number(separation.to, about.unit);
    if (small_button(ui, {.id = "apply:" + std::to_string(k), .label = "Apply", .value = text})) {
        const auto place =
            place_named(work.document.set, set.vibrations[found.request.changed].name);
        if (place) apply_separation(ui, work, *place, separation);
        if (place && picking.opened) {
            const std::string& changed = work.document.set.vibrations[*place].name;
            const auto& [a, b] = *picking.opened;
            picking.applied = AppliedChange{changed, changed == a ? b : a, work.revision};
        }
    }
    bool rested = ImGui::IsItemHovered();
    ImGui::SameLine();
    ImGui::TextUnformatted(text.c_str());
    rested |= ImGui::IsItemHovered();
    const auto& changed = set.vibrations[found.request.changed];
    if (const auto* own = std::get_if<Pattern>(&changed.source); own != nullptr && rested) {
        work.selection.suggested = SuggestedChange{
            changed.name, with_value(*own, separation.parameter, separation.to), text};
    }
    ImGui::PushFont(ui.theme.fonts.small);
    reading_text(ui.theme.dim_text, felt_steps_text(separation.steps) + "; new closest: " +
                                        set.vibrations[separation.nearest_to].name + ", PM " +
                                        grouped(separation.nearest));
    ImGui::PopFont();
}

void draw_search(Ui& ui, SubsetState& picking) {
    auto& job = picking.separation_job;
    if (draw_progress(ui, {"Separating", job.progress(), "separation"})) job.cancel();
}

void draw_found(Ui& ui, Workspace& work, SubsetState& picking, const SeparationRequest& asked) {
    const std::shared_ptr<const FoundSeparations> found = picking.separations;
    if (!found || found->request != asked) return;
    if (found->all.empty()) {
        reading_text(
            ui, ui.theme.dim_text,
            {.id = "separations",
             .text = "No change of a single number is enough, up to 16 felt steps of it. Change "
                     "the rhythm, or add a carrier.",
             .value = "none"});
        return;
    }
    note_rect(ui.rects, "separations", ImGui::GetCursorScreenPos(), ImGui::GetCursorScreenPos(),
              std::to_string(found->all.size()));
    for (std::size_t k = 0; k < found->all.size(); ++k)
        draw_separation(ui, work, picking, *found, k);
}

// The two that are held against each other, one above the other on one scale of g.
void draw_both(Ui& ui, Workspace& work, const ShownMap& shown_map,
               std::pair<std::size_t, std::size_t> rows) {
    const float height = 44.0F * ui.theme.scale;
    for (const std::size_t row : {rows.first, rows.second}) {
        const auto& name = shown_map.transition.shown->request.set->vibrations[row].name;
        const auto place = place_named(work.document.set, name);
        if (!place) continue;
        ImGui::PushFont(ui.theme.fonts.small);
        dim_text(ui, shortened(ui.theme.fonts.small, name, ImGui::GetContentRegionAvail().x));
        ImGui::PopFont();
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const Rect area = rect_at(corner, {ImGui::GetContentRegionAvail().x, height});
        ImGui::Dummy(area.size());
        draw_thumbnail(ui, work, area, work.document.set.vibrations[*place],
                       look_of(ui, work, *place).colour, shown_reach_g(work), work.cache.axis_s);
        note_item(ui.rects, "too close picture:" + name);
    }
    ImGui::Spacing();
}

// The open pair: which to change, and the changes that would do.
void draw_open_pair(Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking,
                    std::pair<std::size_t, std::size_t> rows) {
    const float room = ImGui::GetContentRegionAvail().y;
    if (room > 300.0F * ui.theme.scale) draw_both(ui, work, shown_map, rows);
    draw_change_choice(ui, work, shown_map, picking, rows);
    const std::size_t row = row_to_change(work, shown_map, picking, rows);
    const SeparationRequest asked = separation_request(shown_map, picking, row);
    if (picking.separation_job.busy()) return draw_search(ui, picking);
    const std::string obstacle = separation_obstacle(work, shown_map, picking, row);
    const std::string from = asked.from.empty() ? "all others" : "the other picked ones";
    if (primary_button(
            ui, {.id = "button:separate",
                 .label = "What would separate them?",
                 .tip = "The smallest change of one number that brings the pattern farther than " +
                        worth_text(asked.threshold) + " from " + from +
                        ". PM depends on the set: it is ranked again with each change.",
                 .enabled = obstacle.empty(),
                 .value = obstacle})) {
        ask_for_separation(ui, work, shown_map, picking, row);
    }
    if (!obstacle.empty()) {
        reading_text(ui, ui.theme.dim_text, {.id = "separation obstacle", .text = obstacle});
    }
    (void)draw_failure(ui, "separation", picking.separation_job.failure());
    draw_found(ui, work, picking, asked);
}

}  // namespace

void draw_too_close_view(Ui& ui, Workspace& work, const ShownMap& shown_map, SubsetState& picking) {
    draw_threshold(ui, work, shown_map, picking);
    if (!shown_map.transition.shown || shown_map.transition.shown->prediction.pm.size < 2) {
        const bool few = work.document.set.vibrations.size() < 2;
        const Rect area = rest_of_pane();
        if (area.empty()) return;
        return draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area,
                          few ? "Nothing to compare" : "No pairs yet",
                          few ? "It takes two patterns to be too close."
                              : "They are listed once the space above is there.");
    }
    const TooClosePairs& pairs = too_close_pairs(shown_map, picking);
    const auto rows = opened_rows(shown_map, picking);
    const bool side_by_side = rest_of_pane().width() > 360.0F * ui.theme.scale;
    const Rect area = rest_or_lines(!rows || side_by_side ? 5.0F : 12.0F);
    // Side by side if there is room, otherwise the open pair below a short list.
    const float gap = ui.theme.gap_px;
    const ImVec2 list{rows && side_by_side ? 0.46F * area.width() : area.width(),
                      rows && !side_by_side ? 0.4F * area.height() : area.height()};
    ImGui::BeginChild("left", list);
    draw_pair_list(ui, work, shown_map, picking, pairs);
    ImGui::EndChild();
    if (!rows) return;
    const ImVec2 corner = side_by_side ? ImVec2{area.min.x + list.x + gap, area.min.y}
                                       : ImVec2{area.min.x, area.min.y + list.y + gap};
    ImGui::SetCursorScreenPos(corner);
    ImGui::BeginChild("right", area.max - corner);
    draw_open_pair(ui, work, shown_map, picking, *rows);
    ImGui::EndChild();
}

}  // namespace tact
