// Every parameter of the selected patterns: drag, type or nudge.

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/patterns/parts.h"
#include "app/patterns/patterns.h"
#include "app/ui/widgets.h"
#include "app/wave_strip/wave_strip.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr std::array kKinds{
    Choice{ModulationKind::product, "Ring",
           "Times sin(2 pi f t), Eq. 7 of the paper: the strength swells twice a cycle.",
           Icon::ring},
    Choice{ModulationKind::am, "Tremolo",
           "Times 1 + m sin(2 pi f t): the strength swells once a cycle, by the depth m.",
           Icon::tremolo}};

// Adds the rate at which the strength swells, which the frequency alone does not tell.
void draw_kind(Ui& ui, Workspace& work, const Modulation& modulation) {
    draw_label(ui, "Kind", segments_width(ui, kKinds));
    ModulationKind kind = modulation.kind;
    if (draw_segments(ui, kKinds, kind)) {
        edit_patterns(work, [kind](Pattern& p) { p.modulation.kind = kind; });
        commit_step(ui, work, "Change " + of_selection(work, "modulation kind"));
    }
    if (modulation.frequency_hz <= 0.0) return;
    const double beats = (kind == ModulationKind::product ? 2.0 : 1.0) * modulation.frequency_hz;
    const std::string words = significant_digits(beats, 4) + " beats/s";
    dim_text_beside(ui, {.id = "editor:beats", .text = words});
}

void draw_modulation(Ui& ui, Workspace& work, const Pattern& pattern) {
    const Modulation& modulation = pattern.modulation;
    Field frequency = field_of(numbers::kModulation, "modulation_hz");
    frequency.snap = 1.0 / pattern.duration_s;
    edit_number(ui, work, numbers::kModulation, frequency, "modulation",
                [](auto& p) { return &p.modulation.frequency_hz; });
    Field depth = field_of(numbers::kDepth, "depth");
    depth.enabled = modulation.kind == ModulationKind::am;
    if (!depth.enabled) depth.help = "Tremolo has a depth; Ring has none.";
    edit_number(ui, work, numbers::kDepth, depth, "depth",
                [](auto& p) { return &p.modulation.depth; });
    draw_kind(ui, work, modulation);
}

void draw_times(Ui& ui, Workspace& work) {
    edit_number(ui, work, numbers::kAttack, field_of(numbers::kAttack, "attack_ms"), "attack",
                [](auto& p) { return &p.attack_s; });
    edit_number(ui, work, numbers::kRelease, field_of(numbers::kRelease, "release_ms"), "release",
                [](auto& p) { return &p.release_s; });
    edit_number(ui, work, numbers::kDuration, field_of(numbers::kDuration, "duration_s"),
                "duration", [](auto& p) { return &p.duration_s; });
}

// Shown only for a chosen pair: the closest one stands in the map's own panes.
void draw_partner(Ui& ui, const Workspace& work, const ShownMap& shown_map) {
    const auto pair = chosen_pair(work, shown_map);
    if (!pair || pair->kind != PartnerKind::chosen) return;
    const auto& all = work.document.set.vibrations;
    // Names both, because the chosen one stays when another pattern comes into the editor.
    const std::string head = "PM of " + all[pair->current].name + " to " + all[pair->partner].name;
    const auto rows =
        shown_map.transition.shown ? rows_in_map(work, shown_map, *pair) : std::nullopt;
    std::string words = head + ": not computed yet";
    if (rows) {
        const LiveMap& map = *shown_map.transition.shown;
        words = head + ": " + grouped(map.prediction.pm(rows->first, rows->second)) + " of " +
                grouped(largest_pm(map));
        const MapState state = map_state(work, shown_map);
        if (state == MapState::preview) words += ", a preview";
        if (state == MapState::stale) words += ", of before the last change";
    }
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui,
             {.id = "editor:partner",
              .text = words,
              .tip = "The pair that is chosen. PM is a weighted rank among all pairs of the set; "
                     "behind it stands the set's largest."});
    ImGui::PopTextWrapPos();
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
    // A note describes the opened file; it does not follow edits.
    const bool edited = work.unsaved && !is_saved(work.document.saved, vibration);
    ImGui::TextWrapped("%s%s", edited ? "Note, from before the edit: " : "",
                       shown_lines(vibration.note).c_str());
    ImGui::PopFont();
    ImGui::PopStyleColor();
}

// The strip's share of a low pane, in which it stands among the fields.
constexpr float kStripShare = 0.42F;

// The column is no wider than is useful: in a maximised pane a slider would stand far from its
// number, and popups of the fields have room beside it.
void keep_narrow(const Theme& theme) {
    constexpr float kMostPx = 640.0F;
    ImGuiWindow& window = *ImGui::GetCurrentWindow();
    const float right = ImGui::GetCursorScreenPos().x + kMostPx * theme.scale;
    for (ImRect* room : {&window.ContentRegionRect, &window.WorkRect}) {
        room->Max.x = std::min(room->Max.x, right);
    }
}

void draw_nothing_to_edit(Ui& ui, Workspace& work) {
    if (draw_empty_with(ui, rest_of_pane(), "Nothing to edit", "Make a pattern, or open a set.",
                        {.id = "button:new pattern", .label = "New pattern"})) {
        ui.waiting.emplace_back([&ui, &work] { add_pattern(ui, work); });
    }
}

// The reason why it cannot be edited.
void draw_lock(Ui& ui, Workspace& work, const Vibration& vibration) {
    if (!vibration.locked) return;
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, "Locked: picked in every subset, and not edited.");
    ImGui::PopTextWrapPos();
    flow_on(ImGui::CalcTextSize("Unlock").x, ui.theme.gap_px);
    if (link(ui, {.id = "link:unlock", .label = "Unlock"})) {
        ui.waiting.emplace_back([&ui, &work] { toggle_locked(ui, work); });
    }
}

// Problems that the map reports.
void draw_warnings(Ui& ui, const Workspace& work, const Vibration& vibration) {
    if (work.selection.too_close.contains(vibration.name)) {
        coloured_text(
            ui, ui.theme.warning,
            {.id = "editor:too close", .text = "In a pair that is listed in Subset, Too close."});
    }
    if (work.selection.unfelt.contains(vibration.name)) {
        coloured_text(ui, ui.theme.warning,
                      {.id = "editor:not felt", .text = "Not felt: no receptor answers to it."});
    }
}

void draw_tone(Ui& ui, Workspace& work, const Pattern& pattern) {
    edit_number(ui, work, numbers::kAmplitude, field_of(numbers::kAmplitude, "amplitude_g"),
                "amplitude", [](auto& p) { return &p.amplitude_g; });
    draw_carrier_fields(ui, work, pattern);
    draw_modulation(ui, work, pattern);
}

enum class Columns { one, two };

// The tone; rhythm and times stand below or beside it.
void draw_numbers(Ui& ui, Workspace& work, PatternPanes& pattern_panes, const Pattern& pattern,
                  Columns columns) {
    const auto draw_in_time = [&] {
        draw_rhythm_fields(ui, work, pattern_panes, pattern);
        draw_times(ui, work);
    };
    if (columns == Columns::one) {
        keep_narrow(ui.theme);
        draw_tone(ui, work, pattern);
        return draw_in_time();
    }
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {0.75F * ui.theme.gap_px, 0.0F});
    if (ImGui::BeginTable("numbers", 2,
                          ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoPadOuterX)) {
        ImGui::TableNextColumn();
        draw_tone(ui, work, pattern);
        ImGui::TableNextColumn();
        draw_in_time();
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

void draw_fields(Ui& ui, Workspace& work, PatternPanes& pattern_panes, const ShownMap& shown_map,
                 Columns columns) {
    const Vibration shown = *current_vibration(work);  // edits below replace the document's own
    draw_lock(ui, work, shown);
    if (columns == Columns::one && shown_pattern(work) != nullptr) draw_add_layer(ui, work);
    if (columns == Columns::one) draw_warnings(ui, work, shown);
    // Arrow keys nudge the last touched number of this pattern, not of the one before.
    const std::string open = shown_name(work);
    if (std::exchange(pattern_panes.editor.active_pattern, open) != open) {
        ui.field.active.clear();
    }
    ImGui::BeginDisabled(shown.locked);
    if (const Pattern* open_pattern = shown_pattern(work)) {
        const Pattern pattern = *open_pattern;
        draw_numbers(ui, work, pattern_panes, pattern, columns);
    } else if (std::holds_alternative<LayeredPattern>(shown.source)) {
        wrapped_text("This layer is a recording: it has a gain and a begin.");
    } else {
        keep_narrow(ui.theme);
        draw_recording_editor(ui, work, pattern_panes.recording);
    }
    ImGui::EndDisabled();
    // Numbers stay in place when the map arrives.
    if (columns == Columns::two) draw_warnings(ui, work, shown);
    draw_partner(ui, work, shown_map);
    draw_note(ui, work, shown);
}

enum class ChosenFields { below, elsewhere };

void draw_strip(Ui& ui, Workspace& work, StripState& strip, Timeline& timeline,
                const StripRoom& room, ChosenFields fields) {
    StripTime time{timeline.range, timeline.playhead.at_s};
    ImGui::BeginDisabled(current_vibration(work)->locked);
    draw_wave_strip(ui, work, strip, time, room);
    ImGui::EndDisabled();
    timeline.range = time.range;
    timeline.playhead.at_s = time.playhead_s;
    if (strip.pointed_s) timeline.crosshair_s = strip.pointed_s;
    if (fields == ChosenFields::below) draw_chosen_fields(ui, work, strip);
}

// A narrow pane: the strip above the numbers; in a low pane it stands among them, and scrolls.
void draw_column(Ui& ui, Workspace& work, PatternPanes& pattern_panes, Timeline& timeline,
                 const ShownMap& shown_map) {
    const float room_px = ImGui::GetContentRegionAvail().y;
    const bool low = room_px < 2.2F * strip_height(ui, pattern_panes.strip);
    const auto draw_within = [&](float most_px) {
        draw_layers_bar(ui, work, pattern_panes.layers, room_px);
        draw_strip(ui, work, pattern_panes.strip, timeline, {most_px}, ChosenFields::below);
    };
    if (!low) draw_within(1e4F);
    const float width_px = ImGui::GetContentRegionAvail().x;
    if (ImGui::BeginChild("fields", {}, false, sideways_if_narrow(ui, width_px))) {
        if (low) draw_within(kStripShare * room_px);
        if (!low && !current_vibration(work)->locked) {
            draw_hint(ui, "editor",
                      "Drag a slider: its point in the map moves. Type for an exact value; arrow "
                      "keys nudge.");
        }
        draw_fields(ui, work, pattern_panes, shown_map, Columns::one);
    }
    ImGui::EndChild();
}

constexpr std::array kTools{
    Choice{StripTool::notes, "Notes",
           "B: drag to draw a note, its edges to resize it, its top for its strength."},
    Choice{StripTool::curves, "Curves", "C: lines of amplitude and frequency, and their points."},
    Choice{StripTool::ticks, "Ticks", "K: a press puts a transient, a drag moves it."}};

// Height of the card at the bottom in this much room; nullopt if too little would be left above it.
float foot_height_px(const Ui& ui, const DrawFoot& draw_foot, float room_px, float used_px) {
    constexpr Range kFootPx{64.0, 130.0};
    constexpr float kShare = 0.15F;
    constexpr float kLeastAbovePx = 150.0F;
    const float s = ui.theme.scale;
    const float wanted_px = std::clamp(kShare * room_px, static_cast<float>(kFootPx.low) * s,
                                       static_cast<float>(kFootPx.high) * s) +
                            ui.theme.gap_px;
    return draw_foot && room_px - used_px - wanted_px >= kLeastAbovePx * s ? wanted_px : 0.0F;
}

// Stands at the end of the row of tools.
void draw_add_layer_beside(Ui& ui, Workspace& work) {
    flow_on(button_width("Add layer"), ui.theme.gap_px);
    draw_add_layer(ui, work);
}

// The strip as high as the pane, above the card; without room for both, the card is left out. The
// numbers of the selection stand among the others if those are visible: otherwise the strip would
// jump under the mouse.
void draw_drawing(Ui& ui, Workspace& work, PatternPanes& pattern_panes, Timeline& timeline,
                  const DrawFoot& draw_foot, ChosenFields fields) {
    StripState& strip = pattern_panes.strip;
    const bool below = fields == ChosenFields::below;
    if (!below) {
        draw_segments(ui, kTools, strip.tool, "strip tool:");
        draw_add_layer_beside(ui, work);
    }
    draw_layers_bar(ui, work, pattern_panes.layers, ImGui::GetContentRegionAvail().y);
    const float room_px = ImGui::GetContentRegionAvail().y;
    const float chosen_px = below ? chosen_fields_px(ui, work, strip) : 0.0F;
    const float foot_px = foot_height_px(ui, draw_foot, room_px, chosen_px);
    draw_strip(ui, work, strip, timeline, {.most_px = room_px - chosen_px - foot_px, .fills = true},
               fields);
    if (foot_px <= 0.0F) return;
    ImGui::BeginChild("foot");
    draw_foot();
    ImGui::EndChild();
}

struct BandWidths {
    float numbers_px;
    float drawing_px;  // nullopt: no room for both
};

constexpr float kTwoColumnsPx = 548.0F;

BandWidths band_widths(const Ui& ui, float room_px) {
    constexpr float kMostPx = 640.0F;
    constexpr float kLeastDrawingPx = 360.0F;
    const float s = ui.theme.scale;
    const float numbers_px = std::clamp(0.44F * room_px, kTwoColumnsPx * s, kMostPx * s);
    const float drawing_px = room_px - numbers_px - 2.0F * ui.theme.gap_px;
    if (drawing_px < kLeastDrawingPx * s) return {room_px, 0.0F};
    return {numbers_px, drawing_px};
}

// Switches between numbers, and drawing with one of its tools.
void draw_tabs(Ui& ui, PatternPanes& pattern_panes) {
    EditorTab& tab = pattern_panes.editor.tab;
    std::vector<Choice<std::optional<StripTool>>> all{
        {std::nullopt, "Numbers", "All of them. The strip has the other place."}};
    for (const auto& tool : kTools) all.push_back({tool.value, tool.words, tool.help});
    std::optional<StripTool> shown = pattern_panes.strip.tool;
    if (tab == EditorTab::numbers) shown.reset();
    if (!draw_segments(ui, all, shown, "strip tool:")) return;
    tab = shown ? EditorTab::drawing : EditorTab::numbers;
    if (shown) pattern_panes.strip.tool = *shown;
}

// A wide pane: the strip at the left, the numbers in two columns at the right; without room for
// both, one of them at a time.
std::optional<NeighbourAction> draw_band(Ui& ui, Workspace& work, PatternPanes& pattern_panes,
                                         Timeline& timeline, const ShownMap& shown_map,
                                         const DrawFoot& draw_foot) {
    const BandWidths widths = band_widths(ui, ImGui::GetContentRegionAvail().x);
    const EditorTab tab = pattern_panes.editor.tab;
    const bool has_both = widths.drawing_px > 0.0F;
    if (!has_both) {
        draw_tabs(ui, pattern_panes);
        draw_add_layer_beside(ui, work);
    }
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    if (has_both || tab == EditorTab::drawing) {
        ImGui::BeginChild("drawing", {widths.drawing_px, 0.0F});
        draw_drawing(ui, work, pattern_panes, timeline, draw_foot,
                     has_both ? ChosenFields::elsewhere : ChosenFields::below);
        ImGui::EndChild();
        if (!has_both) return std::nullopt;
    }
    ImGui::SetCursorScreenPos(
        {corner.x + (has_both ? widths.drawing_px + 2.0F * ui.theme.gap_px : 0.0F), corner.y});
    std::optional<NeighbourAction> done;
    const auto draw_closest = [&] {
        if (const auto neighbour = neighbour_of(work, shown_map)) {
            done = draw_neighbour_card(ui, work, shown_map, *neighbour);
        } else {
            // reserves its place until it is known
            ImGui::Dummy({1.0F, ImGui::GetTextLineHeight()});
        }
        ImGui::Spacing();
    };
    ImGui::BeginChild("numbers");
    if (has_both) draw_closest();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing,
                        {ImGui::GetStyle().ItemSpacing.x, 3.0F * ui.theme.scale});
    const float width_px = ImGui::GetContentRegionAvail().x;
    if (ImGui::BeginChild("fields", {}, false, sideways_if_narrow(ui, width_px))) {
        if (has_both) draw_chosen_fields(ui, work, pattern_panes.strip);
        draw_fields(ui, work, pattern_panes, shown_map, Columns::two);
        if (!has_both) draw_closest();
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
    ImGui::EndChild();
    return done;
}

}  // namespace

std::optional<NeighbourAction> draw_editor_panel(Ui& ui, Workspace& work,
                                                 PatternPanes& pattern_panes, Timeline& timeline,
                                                 const ShownMap& shown_map,
                                                 const DrawFoot& draw_foot) {
    const Vibration* vibration = current_vibration(work);
    if (vibration == nullptr) {
        draw_nothing_to_edit(ui, work);
        return std::nullopt;
    }
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (room.x >= kTwoColumnsPx * ui.theme.scale &&
        !std::holds_alternative<Measurement>(vibration->source)) {
        return draw_band(ui, work, pattern_panes, timeline, shown_map, draw_foot);
    }
    const auto neighbour = neighbour_of(work, shown_map);
    const float card_px = neighbour ? neighbour_card_px(ui, work, shown_map, *neighbour) : 0.0F;
    const float foot_px = foot_height_px(ui, draw_foot, room.y, card_px);
    ImGui::BeginChild("editor", {room.x, std::max(1.0F, room.y - card_px - foot_px)});
    draw_column(ui, work, pattern_panes, timeline, shown_map);
    ImGui::EndChild();
    if (foot_px > 0.0F) {
        ImGui::BeginChild("foot", {room.x, foot_px - ui.theme.gap_px});
        draw_foot();
        ImGui::EndChild();
    }
    if (!neighbour) return std::nullopt;
    return draw_neighbour_card(ui, work, shown_map, *neighbour);
}

}  // namespace tact
