// Pairs that people may confuse, and what would separate them.

#include <algorithm>
#include <cstdio>

#include "app/compare/bench_follow.h"
#include "app/document/editing.h"
#include "app/map/pair.h"
#include "app/subset/separation_follow.h"
#include "app/subset/subset_views.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

void draw_share_slider(App& app) {
    SubsetState& state = *app.subset;
    flow_on(150.0F * app.theme.scale, app.theme.gap_px);
    ImGui::SetNextItemWidth(150.0F * app.theme.scale);
    auto percent = static_cast<float>(100.0 * state.share);
    if (ImGui::SliderFloat("##share", &percent, 0.5F, 30.0F, "closest %.1f %%",
                           ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput)) {
        state.share = static_cast<double>(percent) / 100.0;
    }
    note_item(app.rects, "subset:share", std::to_string(state.share));
}

void draw_reference(App& app) {
    SubsetState& state = *app.subset;
    if (const auto pair = chosen_pair(app)) {
        flow_on(button_width("Take the chosen pair"), app.theme.gap_px);
        if (ImGui::Button("Take the chosen pair")) {
            state.reference_a = app.document.set.vibrations[pair->current].name;
            state.reference_b = app.document.set.vibrations[pair->partner].name;
        }
        note_item(app.rects, "button:reference");
        draw_tooltip(app,
                     "A pair you know: people tell these two apart just so. All that are no "
                     "farther apart are listed.");
    }
    ImGui::PushFont(app.theme.fonts.small);
    dim_text(app, state.reference_a.empty() ? "No pair taken yet."
                                            : state.reference_a + " \u2013 " + state.reference_b);
    ImGui::PopFont();
}

void draw_threshold(App& app) {
    SubsetState& state = *app.subset;
    const auto choose = [&](const char* name, TooClose by, const char* help, bool first) {
        if (!first) flow_on(radio_width(app, name), 1.5F * app.theme.gap_px);
        if (draw_radio(app, name, state.too_close == by)) state.too_close = by;
        note_item(app.rects, std::string("radio:") + name);
        draw_tooltip(app, help);
    };
    choose("Closest", TooClose::share, "The closest pairs of this set, so many of them.", true);
    choose("Among the picked", TooClose::picked,
           "The closest pairs within the picked subset; a change has to part a pattern from the "
           "others of the subset only.",
           false);
    choose("Reference pair", TooClose::reference, "Pairs no farther apart than one you know.",
           false);
    if (!app.document.set.ratings.empty()) {
        choose("Rated closest", TooClose::ratings, "The pairs that people rated most alike.",
               false);
    }
    if (state.too_close == TooClose::reference) {
        draw_reference(app);
    } else {
        draw_share_slider(app);
    }
}

const std::string& name_of(const TooClosePairs& pairs, std::size_t row) {
    return pairs.of->request.set->vibrations[row].name;
}

// What the list has, or why it has nothing.
std::string summary_of(const App& app, const TooClosePairs& pairs) {
    const SubsetState& state = *app.subset;
    if (pairs.by == TooClose::picked && pairs.picked.size() < 2) {
        return "Nothing is picked yet: see Pick.";
    }
    if (pairs.by == TooClose::reference && state.reference_a.empty()) {
        return "Click a pattern in the map, then another one, and take them.";
    }
    if (pairs.pairs.empty()) return "No pair is too close.";
    const std::string total = grouped_digits(pairs.count) + (pairs.count == 1 ? " pair" : " pairs");
    if (pairs.count == pairs.pairs.size()) return total + ", the closest first";
    return "The closest " + grouped_digits(pairs.pairs.size()) + " of " + total;
}

void draw_pair(App& app, const TooClosePairs& pairs, const ConfusablePair& pair, bool open) {
    const std::string& a = name_of(pairs, pair.a);
    const std::string& b = name_of(pairs, pair.b);
    const std::string text = grouped(pair.dissimilarity) + "   " + a + " \u2013 " + b;
    const std::string shown =
        shortened(app.theme.fonts.regular, text, ImGui::GetContentRegionAvail().x);
    if (ImGui::Selectable(shown.c_str(), open)) open_pair(app, a, b);
    note_item(app.rects, "too close:" + a + "|" + b, text);
    if (shown != text) draw_tooltip(app, text.c_str());
}

void draw_pair_list(App& app, const TooClosePairs& pairs) {
    ImGui::PushFont(app.theme.fonts.small);
    const std::string summary = summary_of(app, pairs);
    coloured_note(app.theme.dim_text, summary);
    ImGui::PopFont();
    note_item(app.rects, "too close", summary);
    const auto opened = opened_rows(app);
    ImGui::BeginChild("pairs");
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(pairs.pairs.size()));
    while (clipper.Step()) {
        for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
            ImGui::PushID(k);
            const ConfusablePair& pair = pairs.pairs[static_cast<std::size_t>(k)];
            draw_pair(app, pairs, pair, opened == std::pair(pair.a, pair.b));
            ImGui::PopID();
        }
    }
    ImGui::EndChild();
}

// Which of the two is changed. One that may not says why.
void draw_change_choice(App& app, std::pair<std::size_t, std::size_t> rows) {
    SubsetState& state = *app.subset;
    const std::size_t changed = row_to_change(app, rows);
    ImGui::AlignTextToFramePadding();
    dim_text(app, "Change");
    for (const std::size_t row : {rows.first, rows.second}) {
        const std::string why = fixed_because(app, row);
        const std::string name = app.map.shown->request.set->vibrations[row].name;
        const std::string text = name + (why.empty() ? "" : "  (" + why + ")");
        flow_on(radio_width(app, text.c_str()), app.theme.gap_px);
        ImGui::BeginDisabled(!why.empty());
        if (draw_radio(app, text.c_str(), changed == row)) {
            state.change_second = row == rows.second;
        }
        ImGui::EndDisabled();
        note_item(app.rects, row == rows.second ? "radio:change second" : "radio:change first",
                  text);
    }
}

std::string number(double value, const char* unit) {
    const std::string text = significant(value);
    return *unit == '\0' ? text : text + " " + unit;
}

void draw_separation(App& app, const FoundSeparations& found, std::size_t k) {
    const Separation& separation = found.all[k];
    const ParameterTraits& about = traits(separation.parameter);
    const PatternSet& set = *found.request.map->request.set;
    ImGui::PushID(static_cast<int>(k));
    if (ImGui::SmallButton("Apply")) {
        const auto place =
            place_named(app.document.set, set.vibrations[found.request.changed].name);
        if (place) apply_separation(app, *place, separation);
    }
    const std::string text = std::string(about.name) + " " + number(separation.from, about.unit) +
                             " \u2192 " + number(separation.to, about.unit);
    note_item(app.rects, "apply:" + std::to_string(k), text);
    ImGui::SameLine();
    ImGui::TextUnformatted(text.c_str());
    ImGui::PushFont(app.theme.fonts.small);
    coloured_note(app.theme.dim_text, "then " + grouped(separation.nearest) +
                                          " from its closest, " +
                                          set.vibrations[separation.nearest_to].name);
    ImGui::PopFont();
    ImGui::PopID();
}

void draw_search(App& app) {
    SubsetState& state = *app.subset;
    char text[32];
    std::snprintf(text, sizeof text, "searching, %d %%",
                  static_cast<int>(100.0F * state.separation_job->progress()));
    dim_text(app, text);
    ImGui::SameLine();
    if (link(app, "cancel separation", "Cancel")) state.separation_job->cancel();
    note_item(app.rects, "link:cancel separation");
}

void draw_found(App& app, const SeparationRequest& asked) {
    const std::shared_ptr<const FoundSeparations> found = app.subset->separations;
    if (!found || found->request != asked) return;
    if (found->all.empty()) {
        coloured_note(app.theme.dim_text,
                      "No change of a single number is enough. Change the rhythm, or add a "
                      "carrier.");
        note_item(app.rects, "separations", "none");
        return;
    }
    note_rect(app.rects, "separations", ImGui::GetCursorScreenPos(), ImGui::GetCursorScreenPos(),
              std::to_string(found->all.size()));
    for (std::size_t k = 0; k < found->all.size(); ++k) draw_separation(app, *found, k);
}

// The open pair: which to change, and the changes that would do.
void draw_open_pair(App& app, std::pair<std::size_t, std::size_t> rows) {
    constexpr const char* kAsk = "What would separate them?";
    draw_change_choice(app, rows);
    const std::size_t row = row_to_change(app, rows);
    const SeparationRequest asked = separation_request(app, row);
    if (app.subset->separation_job && app.subset->separation_job->busy()) return draw_search(app);
    const std::string obstacle = separation_obstacle(app, row);
    ImGui::BeginDisabled(!obstacle.empty());
    if (ImGui::Button(kAsk)) ask_for_separation(app, row);
    note_item(app.rects, "button:separate", obstacle);
    ImGui::EndDisabled();
    const std::string from = asked.from.empty() ? "all others" : "the other picked ones";
    draw_tooltip(app, ("The smallest change of one number that brings the pattern farther than " +
                       grouped(asked.threshold) + " from " + from +
                       ". PM depends on the set: it is ranked anew with each change.")
                          .c_str());
    if (!obstacle.empty()) {
        coloured_note(app.theme.dim_text, obstacle);
        note_item(app.rects, "separation obstacle", obstacle);
    }
    draw_found(app, asked);
}

}  // namespace

void draw_too_close_view(App& app) {
    draw_threshold(app);
    if (!app.map.shown || app.map.shown->prediction.pm.size < 2) {
        const bool few = app.document.set.vibrations.size() < 2;
        const Rect area = rest_of_pane();
        if (area.empty()) return;
        return draw_empty(*ImGui::GetWindowDrawList(), app.theme, area,
                          few ? "Nothing to compare" : "No pairs yet",
                          few ? "It takes two patterns to be too close."
                              : "They are listed once the space above is there.");
    }
    const TooClosePairs& pairs = too_close_pairs(app);
    const auto rows = opened_rows(app);
    const bool side_by_side = rest_of_pane().width() > 360.0F * app.theme.scale;
    const Rect area = rest_or_lines(!rows || side_by_side ? 5.0F : 12.0F);
    // Side by side where there is room, else the open pair below a short list.
    const float gap = app.theme.gap_px;
    const ImVec2 list{rows && side_by_side ? 0.46F * area.width() : area.width(),
                      rows && !side_by_side ? 0.4F * area.height() : area.height()};
    ImGui::BeginChild("left", list);
    draw_pair_list(app, pairs);
    ImGui::EndChild();
    if (!rows) return;
    const ImVec2 corner = side_by_side ? ImVec2{area.min.x + list.x + gap, area.min.y}
                                       : ImVec2{area.min.x, area.min.y + list.y + gap};
    ImGui::SetCursorScreenPos(corner);
    ImGui::BeginChild("right", area.max - corner);
    draw_open_pair(app, *rows);
    ImGui::EndChild();
}

}  // namespace tact
