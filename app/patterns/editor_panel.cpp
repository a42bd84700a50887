// Every parameter of the selected patterns: drag, type or nudge.

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/document/editing.h"
#include "app/map/map_follow.h"
#include "app/map/pair.h"
#include "app/patterns/editor_panel.h"
#include "app/patterns/pattern_fields.h"
#include "app/patterns/recording_editor.h"
#include "app/ui/widgets.h"
#include "app/wave_strip/wave_strip.h"
#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

void draw_modulation(Ui& ui, Workspace& work, const Pattern& pattern) {
    const Modulation& modulation = pattern.modulation;
    edit_number(
        ui, work,
        {.id = "modulation_hz",
         .label = "Modulation",
         .format = "%.4g Hz",
         .slider = traits(PatternParameter::modulation).slider,
         .typed = traits(PatternParameter::modulation).range,
         .step = 1.0,
         .snap = 1.0 / pattern.duration_s,
         .help = "Frequency of the amplitude modulation; 0: not modulated."},
        "modulation", [](const Pattern& p) { return p.modulation.frequency_hz; },
        [](Pattern& p, double value) { p.modulation.frequency_hz = value; });
    const bool am = modulation.kind == ModulationKind::am;
    edit_number(
        ui, work,
        {.id = "depth",
         .label = "Depth",
         .format = "%.3g",
         .slider = traits(PatternParameter::depth).slider,
         .typed = traits(PatternParameter::depth).range,
         .step = 0.05,
         .snap = 0.01,
         .help = am ? "m of 1 + m sin(2 pi f t)."
                    : "Only for the kind 1 + m sin: the product with a sine has no depth.",
         .enabled = am},
        "depth", [](const Pattern& p) { return p.modulation.depth; },
        [](Pattern& p, double value) { p.modulation.depth = value; });
    const float room =
        radio_width(ui, "product") + radio_width(ui, "1 + m sin") + 2.0F * ui.theme.gap_px;
    draw_label(ui, "Kind", room);
    const auto choose = [&](const char* label, ModulationKind kind) {
        if (draw_radio(ui, label, modulation.kind == kind) && modulation.kind != kind) {
            edit_patterns(work, [kind](Pattern& p) { p.modulation.kind = kind; });
            commit_step(ui, work, "Change " + of_selection(work, "modulation kind"));
        }
        note_item(ui.rects, std::string("radio:") + label);
    };
    choose("product", ModulationKind::product);
    draw_tooltip(ui, "sin(2 pi f t): Eq. 7 of the paper; the envelope has twice the frequency.");
    flow_on(radio_width(ui, "1 + m sin"), 2.0F * ui.theme.gap_px);
    choose("1 + m sin", ModulationKind::am);
}

Field ramp(PatternParameter parameter, const char* id, const char* label, const char* help) {
    return {.id = id,
            .label = label,
            .format = "%.4g ms",
            .slider = in_ms(traits(parameter).slider),
            .typed = in_ms(traits(parameter).range),
            .step = 5.0,
            .snap = 1.0,
            .help = help};
}

void draw_times(Ui& ui, Workspace& work) {
    edit_number(
        ui, work,
        ramp(PatternParameter::attack, "attack_ms", "Attack",
             "Linear rise at the beginning of every note."),
        "attack", [](const Pattern& p) { return 1000.0 * p.attack_s; },
        [](Pattern& p, double value) { p.attack_s = value / 1000.0; });
    edit_number(
        ui, work,
        ramp(PatternParameter::release, "release_ms", "Release",
             "Linear fall at the end of every note."),
        "release", [](const Pattern& p) { return 1000.0 * p.release_s; },
        [](Pattern& p, double value) { p.release_s = value / 1000.0; });
    edit_number(
        ui, work,
        {.id = "duration_s",
         .label = "Duration",
         .format = "%.4g s",
         .slider = {0.05, 10.0},
         .typed = limits::kDurationS,
         .step = 0.05,
         .snap = 0.05,
         .logarithmic = true,
         .help = "The model was validated at 1 s. Shorter patterns of a set are padded with "
                 "silence to its longest. Typed values reach 60 s."},
        "duration", [](const Pattern& p) { return p.duration_s; },
        [](Pattern& p, double value) { p.duration_s = value; });
}

// Told only of a pair that was chosen: the closest one stands in the map's own panes.
void draw_partner(Ui& ui, const Workspace& work, const ShownMap& shown_map) {
    const auto pair = chosen_pair(work, shown_map);
    if (!pair || pair->kind != PartnerKind::chosen) return;
    const auto& all = work.document.set.vibrations;
    // Both are named: the one that was chosen stays, whichever pattern comes into the editor.
    const std::string head = "PM of " + all[pair->current].name + " to " + all[pair->partner].name;
    const auto rows =
        shown_map.transition.shown ? rows_in_map(work, shown_map, *pair) : std::nullopt;
    std::string words = head + ": not computed yet";
    if (rows) {
        const LiveMap& map = *shown_map.transition.shown;
        words = head + ": " + significant(map.prediction.pm(rows->first, rows->second)) + " of " +
                significant(largest_pm(map));
        const MapState state = map_state(work, shown_map);
        if (state == MapState::preview) words += ", a preview";
        if (state == MapState::stale) words += ", of before the last change";
    }
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, words);
    ImGui::PopTextWrapPos();
    note_item(ui.rects, "editor:partner", words);
    draw_tooltip(
        ui,
        "The pair that is chosen. PM is a weighted rank among all pairs of the set; behind it "
        "stands the set's largest.");
}

bool is_saved(const PatternSet& saved, const Vibration& vibration) {
    return std::ranges::any_of(saved.vibrations, [&vibration](const Vibration& v) {
        return v.name == vibration.name && v.source == vibration.source;
    });
}

void draw_note(const Ui& ui, const Workspace& work, const Vibration& vibration) {
    if (vibration.note.empty()) return;
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::ColorConvertU32ToFloat4(ui.theme.dim_text));
    ImGui::PushFont(ui.theme.fonts.small);
    // A note describes what was opened; it does not follow edits.
    const bool edited = work.unsaved && !is_saved(work.document.saved, vibration);
    ImGui::TextWrapped("%s%s", edited ? "Note, from before the edit: " : "",
                       shown_lines(vibration.note).c_str());
    ImGui::PopFont();
    ImGui::PopStyleColor();
}

// Of a low pane, in which the strip stands among the fields.
constexpr float kStripShare = 0.42F;

// What follows in the window is no wider than is of use: a slider as wide as a maximised pane
// stands far from its number, and what opens beside the fields has room there.
void keep_narrow(const Theme& theme) {
    constexpr float kMostPx = 640.0F;
    ImGuiWindow& window = *ImGui::GetCurrentWindow();
    const float right = ImGui::GetCursorScreenPos().x + kMostPx * theme.scale;
    for (ImRect* room : {&window.ContentRegionRect, &window.WorkRect}) {
        room->Max.x = std::min(room->Max.x, right);
    }
}

void draw_fields(Ui& ui, Workspace& work, PatternPanes& pattern_panes, const ShownMap& shown_map) {
    const Vibration* vibration = current_vibration(work);
    if (vibration == nullptr) {
        if (draw_empty_with(ui, rest_of_pane(), "Nothing to edit", "Make a pattern, or open a set.",
                            "New pattern")) {
            ui.waiting.emplace_back([&ui, &work] { add_pattern(ui, work); });
        }
        note_item(ui.rects, "button:new pattern");
        return;
    }
    // Over the fields, or where the pane is low among them, so that it scrolls away.
    const bool low =
        ImGui::GetContentRegionAvail().y < 2.2F * strip_height(ui, pattern_panes.strip);
    const float strip_most_px = low ? kStripShare * ImGui::GetContentRegionAvail().y : 1e4F;
    const auto draw_strip = [&] {
        ImGui::BeginDisabled(vibration->locked);
        draw_wave_strip(ui, work, pattern_panes.strip, strip_most_px);
        ImGui::EndDisabled();
        vibration = current_vibration(work);
    };
    if (!low) draw_strip();
    if (!ImGui::BeginChild("fields")) {
        ImGui::EndChild();
        return;
    }
    if (low) draw_strip();
    // Inside, so that it scrolls away where the pane is low.
    if (!low && !vibration->locked) {
        draw_hint(ui, "editor",
                  "Drag a slider: its point in the map moves. Type for an exact value; arrow keys "
                  "nudge.");
    }
    if (vibration->locked) {
        ImGui::PushTextWrapPos(0.0F);
        dim_text(ui, "Locked: picked in every subset, and not edited.");
        ImGui::PopTextWrapPos();
        flow_on(ImGui::CalcTextSize("Unlock").x, ui.theme.gap_px);
        if (link(ui, "unlock", "Unlock")) {
            ui.waiting.emplace_back([&ui, &work] { toggle_locked(ui, work); });
        }
        note_item(ui.rects, "link:unlock");
    }
    if (work.selection.too_close.contains(vibration->name)) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
        ImGui::TextWrapped("In a pair that is listed in Subset, Too close.");
        ImGui::PopStyleColor();
        note_item(ui.rects, "editor:too close");
    }
    if (work.selection.unfelt.contains(vibration->name)) {
        ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
        ImGui::TextWrapped("Not felt: no receptor answers to it.");
        ImGui::PopStyleColor();
        note_item(ui.rects, "editor:not felt");
    }
    // Arrow keys nudge what was touched last in this pattern, not in the one before.
    if (std::exchange(pattern_panes.editor.active_pattern, vibration->name) != vibration->name) {
        ui.field.active.clear();
    }
    const Vibration shown = *vibration;  // edits below replace the document's own
    ImGui::BeginDisabled(shown.locked);
    keep_narrow(ui.theme);
    if (const auto* pattern = std::get_if<Pattern>(&shown.source)) {
        edit_number(
            ui, work,
            {.id = "amplitude_g",
             .label = "Amplitude",
             .format = "%.3g g",
             .slider = traits(PatternParameter::amplitude).slider,
             .typed = traits(PatternParameter::amplitude).range,
             .step = 0.05,
             .snap = 0.01,
             .help = "Peak acceleration of the sum of carriers. Typed values reach 50 g."},
            "amplitude", [](const Pattern& p) { return p.amplitude_g; },
            [](Pattern& p, double value) { p.amplitude_g = value; });
        draw_carrier_fields(ui, work, *pattern);
        draw_modulation(ui, work, *pattern);
        draw_rhythm_fields(ui, work, pattern_panes, *pattern);
        draw_times(ui, work);
    } else {
        draw_recording_editor(ui, work, pattern_panes.recording);
    }
    ImGui::EndDisabled();
    draw_partner(ui, work, shown_map);
    draw_note(ui, work, shown);
    ImGui::EndChild();
}

}  // namespace

std::optional<NeighbourAction> draw_editor_panel(Ui& ui, Workspace& work,
                                                 PatternPanes& pattern_panes,
                                                 const ShownMap& shown_map) {
    const auto neighbour = ui.as_picture ? std::nullopt : neighbour_of(work, shown_map);
    const float card_px = neighbour ? neighbour_card_px(ui, work, shown_map, *neighbour) : 0.0F;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    ImGui::BeginChild("editor", {room.x, std::max(1.0F, room.y - card_px)});
    draw_fields(ui, work, pattern_panes, shown_map);
    ImGui::EndChild();
    if (!neighbour) return std::nullopt;
    return draw_neighbour_card(ui, work, shown_map, *neighbour);
}

}  // namespace tact
