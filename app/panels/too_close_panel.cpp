// Pairs that people may confuse, and what would separate them.

#include <algorithm>
#include <cstdio>

#include "app/bench_follow.h"
#include "app/editing.h"
#include "app/map_follow.h"
#include "app/panels/panels.h"
#include "app/panels/subset_views.h"
#include "app/subset_follow.h"
#include "app/widgets.h"
#include "viz/marks.h"
#include "viz/plot.h"

namespace tact {

namespace {

void draw_share_slider(App& app) {
    SubsetState& state = *app.subset;
    flow_on(150.0F * app.theme.scale, app.theme.gap_px);
    ImGui::SetNextItemWidth(150.0F * app.theme.scale);
    auto percent = static_cast<float>(100.0 * state.share);
    if (ImGui::SliderFloat("##share", &percent, 0.5F, 30.0F, "closest %.1f %%",
                           ImGuiSliderFlags_AlwaysClamp)) {
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

const std::string& name_of(const TooClosePairs& pairs, std::size_t place) {
    return pairs.of->request.set->vibrations[place].name;
}

void draw_pair_list(App& app, const TooClosePairs& pairs) {
    SubsetState& state = *app.subset;
    ImGui::BeginChild("pairs");
    for (std::size_t k = 0; k < pairs.pairs.size(); ++k) {
        const ConfusablePair& pair = pairs.pairs[k];
        const std::string& a = name_of(pairs, pair.a);
        const std::string& b = name_of(pairs, pair.b);
        ImGui::PushID(static_cast<int>(k));
        const bool open =
            state.open_pair && state.open_pair->a == pair.a && state.open_pair->b == pair.b;
        const std::string text = grouped(pair.dissimilarity) + "   " + a + " \u2013 " + b;
        if (ImGui::Selectable(text.c_str(), open)) {
            state.open_pair = pair;
            const auto first = place_named(app.document.set, a);
            const auto second = place_named(app.document.set, b);
            if (first && second) choose_pair(app, *first, *second);
        }
        note_item(app.rects, "too close:" + a + "|" + b, text);
        ImGui::PopID();
    }
    if (pairs.pairs.empty()) dim_text(app, "No pair is too close.");
    ImGui::EndChild();
}

// Which of the two is changed: the one that may be.
std::size_t changed_one(App& app, const TooClosePairs& pairs) {
    SubsetState& state = *app.subset;
    const ConfusablePair& pair = *state.open_pair;
    const auto may_change = [&](std::size_t place) {
        const auto now = place_named(app.document.set, name_of(pairs, place));
        if (!now) return false;
        const Vibration& vibration = app.document.set.vibrations[*now];
        return !vibration.locked && std::holds_alternative<Pattern>(vibration.source);
    };
    const bool first = may_change(pair.a);
    const bool second = may_change(pair.b);
    if (first != second) state.change_second = second;
    ImGui::AlignTextToFramePadding();
    dim_text(app, "Change");
    for (const bool is_second : {false, true}) {
        const std::size_t place = is_second ? pair.b : pair.a;
        const std::string& name = name_of(pairs, place);
        flow_on(radio_width(app, name.c_str()), app.theme.gap_px);
        ImGui::BeginDisabled(!may_change(place));
        if (draw_radio(app, name.c_str(), state.change_second == is_second)) {
            state.change_second = is_second;
        }
        ImGui::EndDisabled();
        note_item(app.rects, is_second ? "radio:change second" : "radio:change first", name);
    }
    return state.change_second ? pair.b : pair.a;
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
    dim_text(app, "then " + grouped(separation.nearest) + " from its closest, " +
                      set.vibrations[separation.nearest_to].name);
    ImGui::PopFont();
    ImGui::PopID();
}

void draw_found(App& app, const SeparationRequest& asked) {
    SubsetState& state = *app.subset;
    const bool busy = state.separation_job && state.separation_job->busy();
    const std::shared_ptr<const FoundSeparations> found = state.separations;
    const bool answers = found && found->request == asked;
    if (busy) {
        char text[32];
        std::snprintf(text, sizeof text, "searching, %d %%",
                      static_cast<int>(100.0F * state.separation_job->progress()));
        dim_text(app, text);
        ImGui::SameLine();
        if (link(app, "cancel separation", "Cancel")) state.separation_job->cancel();
        note_item(app.rects, "link:cancel separation");
        return;
    }
    if (!answers) return;
    if (found->all.empty()) {
        coloured_note(app, app.theme.dim_text,
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
void draw_open_pair(App& app, const TooClosePairs& pairs) {
    SubsetState& state = *app.subset;
    const std::size_t changed = changed_one(app, pairs);
    const Vibration& vibration = pairs.of->request.set->vibrations[changed];
    const SeparationRequest asked{pairs.of, changed, pairs.threshold};
    const bool possible = state.separation_job && map_state(app) == MapState::exact &&
                          state.too_close != TooClose::ratings && !vibration.locked &&
                          std::holds_alternative<Pattern>(vibration.source);
    ImGui::BeginDisabled(!possible);
    if (ImGui::Button("What would separate them?")) state.separation_job->submit(asked);
    note_item(app.rects, "button:separate");
    ImGui::EndDisabled();
    draw_tooltip(app,
                 "The smallest change of one number that brings the pattern farther than this "
                 "from all others. PM depends on the set: it is ranked anew with each change.");
    draw_found(app, asked);
}

}  // namespace

void draw_too_close_view(App& app) {
    draw_threshold(app);
    if (!app.map.shown || app.map.shown->prediction.pm.size < 2) return;
    const TooClosePairs& pairs = too_close_pairs(app);
    SubsetState& state = *app.subset;
    const std::size_t n = app.map.shown->prediction.pm.size;
    if (state.open_pair && state.open_pair->b >= n) state.open_pair.reset();
    const Rect area = rest_of_pane();
    if (area.width() < 40.0F || area.height() < 30.0F) return;
    const float left = state.open_pair ? 0.46F * area.width() : area.width();
    ImGui::BeginChild("left", {left, area.height()});
    draw_pair_list(app, pairs);
    ImGui::EndChild();
    if (!state.open_pair) return;
    ImGui::SetCursorScreenPos({area.min.x + left + app.theme.gap_px, area.min.y});
    ImGui::BeginChild("right", {area.width() - left - app.theme.gap_px, area.height()});
    draw_open_pair(app, pairs);
    ImGui::EndChild();
}

}  // namespace tact
