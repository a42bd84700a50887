#include "app/wave_strip/wave_strip.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "app/document/editing.h"
#include "app/document/pattern_looks.h"
#include "app/ui/widgets.h"
#include "app/wave_strip/note_grips.h"
#include "app/wave_strip/strip_picture.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr float kReachPx = 7.0F;
constexpr float kLeastHeightPx = 96.0F;
constexpr float kClickPx = 3.0F;  // moved less, a press is a click
constexpr double kBeyond = 1.06;  // the end is seen, and can be taken

TimeRange whole(const Pattern& pattern) { return {0.0, kBeyond * pattern.duration_s}; }

void zoom(StripState& strip, const Pattern& pattern, const StripScale& scale) {
    const float wheel = ImGui::GetIO().MouseWheel;
    if (wheel == 0.0F) return;
    const TimeRange all = whole(pattern);
    const double at_s = to_value(scale.amplitude.x, ImGui::GetIO().MousePos.x);
    const double factor = std::pow(1.25, -static_cast<double>(wheel));
    const TimeRange view = zoomed(strip.view.value_or(all), factor, at_s, all.end_s);
    strip.view = view.length_s() < all.end_s ? std::optional(view) : std::nullopt;
}

void take(Workspace& work, GripKind kind, const Pattern& changed) {
    if (!is_shared(kind, changed)) return edit_current_pattern(work, changed);
    edit_patterns(work, [&](Pattern& pattern) { copy_change(kind, changed, pattern); });
}

std::string label_of(const Workspace& work, const std::string& verb, GripKind kind) {
    const Vibration& current = *current_vibration(work);
    const auto* pattern = std::get_if<Pattern>(&current.source);
    const bool shared = pattern != nullptr && is_shared(kind, *pattern);
    const std::string what = name_of(kind);
    return verb + " " + (shared ? of_selection(work, what) : what + " of " + current.name);
}

void complain_of_transients(Ui& ui) {
    complain(ui,
             "A pattern has at most " + grouped_digits(limits::kMaxTransients) + " transients.");
}

void choose(Ui& ui, StripState& strip, const Grip& grip) {
    strip.chosen = grip;
    ui.field.active = kChosenValue;  // arrows nudge it
}

// Where nothing lies the tools of notes and ticks begin one, which follows the mouse.
void begin_drawing(Ui& ui, Workspace& work, StripState& strip, const Pattern& pattern,
                   const StripScale& scale) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Plot& lane = scale.amplitude;
    if (!lane.area.contains(mouse)) return;
    Pattern changed = pattern;
    if (scale.tool == StripTool::notes) {
        const auto more = with_note_added(pattern, scale, mouse);
        if (!more) return;
        changed.rhythm = *more;
        take(work, GripKind::note, changed);
        const auto drawn = end_of_note_at(changed, scale, mouse);
        strip.has_just_drawn = true;
        if (drawn) strip.held = GripHold{*drawn, changed, scale, mouse, true, "Draw a note of"};
    } else if (scale.tool == StripTool::ticks) {
        const auto added =
            add_transient(changed, to_value(lane.x, mouse.x), to_value(lane.y, mouse.y));
        if (!added) return complain_of_transients(ui);
        edit_current_pattern(work, changed);
        strip.has_just_drawn = true;
        strip.held = GripHold{*added, changed, scale, mouse, true, "Add"};
        choose(ui, strip, *added);
    }
}

void press(Ui& ui, Workspace& work, StripState& strip, const Pattern& pattern,
           const StripScale& scale, std::optional<Grip> under) {
    strip.chosen.reset();
    strip.has_just_drawn = false;
    if (!under) return begin_drawing(ui, work, strip, pattern, scale);
    strip.held = GripHold{*under, pattern, scale, ImGui::GetIO().MousePos};
    if (is_single(under->kind)) choose(ui, strip, *under);
}

void drag(Workspace& work, GripHold& held, float scale) {
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 way = io.MousePos - held.pressed;
    held.moved = held.moved || std::hypot(way.x, way.y) > kClickPx * scale;
    if (!held.moved) return;
    take(work, held.grip.kind,
         dragged(held.before, held.grip, held.scale,
                 {held.pressed, io.MousePos, io.KeyShift, io.KeyAlt}));
}

void put_point(Ui& ui, Workspace& work, StripState& strip, GripKind line, double time_s) {
    const Pattern* pattern = editable_pattern(*current_vibration(work));
    if (pattern == nullptr) return;
    Pattern changed = *pattern;
    const auto point = add_point(changed, line, time_s);
    if (!point) return;
    edit_current_pattern(work, changed);
    commit_step(ui, work, label_of(work, "Add point to", point->kind));
    choose(ui, strip, *point);
}

void let_go(Ui& ui, Workspace& work, StripState& strip) {
    const GripHold held = *strip.held;
    strip.held.reset();
    if (held.moved) return commit_step(ui, work, label_of(work, held.verb, held.grip.kind));
    if (strip.tool != StripTool::curves) return;
    put_point(ui, work, strip, held.grip.kind, to_value(held.scale.amplitude.x, held.pressed.x));
}

void put_transient(Ui& ui, Workspace& work, StripState& strip, double time_s, double amplitude_g) {
    const Pattern* pattern = editable_pattern(*current_vibration(work));
    if (pattern == nullptr) return;
    Pattern changed = *pattern;
    const auto added = add_transient(changed, time_s, amplitude_g);
    if (!added) return complain_of_transients(ui);
    edit_current_pattern(work, changed);
    commit_step(ui, work, label_of(work, "Add", added->kind));
    choose(ui, strip, *added);
}

void change_rhythm(Ui& ui, Workspace& work, const std::string& verb, const Rhythm& rhythm) {
    edit_patterns(work, [&rhythm](Pattern& pattern) { pattern.rhythm = rhythm; });
    commit_step(ui, work, label_of(work, verb, GripKind::note));
}

void double_click(Ui& ui, Workspace& work, StripState& strip, const Pattern& pattern,
                  const StripScale& scale, std::optional<Grip> under) {
    strip.held.reset();
    // The first of the two presses drew what lies there now.
    if (std::exchange(strip.has_just_drawn, false)) return;
    if (under && is_single(under->kind)) {
        strip.chosen = under;
        (void)remove_chosen(ui, work, strip);
    } else if (under && is_note(under->kind)) {
        change_rhythm(ui, work, "Remove a note from", with_note_removed(pattern.rhythm, *under));
    } else if (const auto more = with_note_added(pattern, scale, ImGui::GetIO().MousePos)) {
        change_rhythm(ui, work, "Add a note to", *more);
    } else if (!under && scale.amplitude.area.contains(ImGui::GetIO().MousePos)) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        put_transient(ui, work, strip, to_value(scale.amplitude.x, mouse.x),
                      to_value(scale.amplitude.y, mouse.y));
    }
}

// As high as the person made it. Before that, in a wide pane it has the height for its width, where
// the pane has it, and all that its fields leave: it is what is drawn on by hand.
float wanted_height_px(const Ui& ui, const StripState& strip, ImVec2 room) {
    constexpr float kByWidth = 0.16F;
    constexpr float kOfPane = 0.35F;
    constexpr float kWidePx = 900.0F;
    constexpr float kFieldsPx = 500.0F;
    const float own_px = strip.height * ui.theme.scale;
    if (strip.height != StripState{}.height) return own_px;
    const auto most_px = static_cast<float>(kStripHeight.high) * ui.theme.scale;
    const float by_width_px = std::min(kByWidth * room.x, kOfPane * room.y);
    const float left_px =
        room.x < kWidePx * ui.theme.scale ? 0.0F : room.y - kFieldsPx * ui.theme.scale;
    return std::max(own_px, std::min(std::max(by_width_px, left_px), most_px));
}

void draw_height_bar(const Ui& ui, StripState& strip, float shown_px) {
    ImGui::InvisibleButton("strip height",
                           {ImGui::GetContentRegionAvail().x, ui.theme.splitter_px});
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
        ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                                  ui.theme.hover);
    }
    if (ImGui::IsItemActivated()) {
        strip.height = std::max(strip.height, shown_px / ui.theme.scale);
    }
    if (!ImGui::IsItemActive()) return;
    const double height =
        static_cast<double>(strip.height + ImGui::GetIO().MouseDelta.y / ui.theme.scale);
    strip.height = static_cast<float>(std::clamp(height, kStripHeight.low, kStripHeight.high));
}

void note_grips(Ui& ui, const Pattern& pattern, const StripScale& scale) {
    if (ui.rects.file.empty()) return;
    const ImVec2 kHalf{2.0F, 2.0F};
    for (const PlacedGrip& placed : placed_grips(pattern, scale)) {
        note_rect(ui.rects,
                  std::string("grip:") + name_of(placed.grip.kind) + ":" +
                      std::to_string(placed.grip.index),
                  placed.at - kHalf, placed.at + kHalf);
    }
    for (const NoteBlock& block : note_blocks(pattern, scale)) {
        note_rect(ui.rects, "note:" + std::to_string(block.index), block.area.min, block.area.max);
    }
    note_rect(ui.rects, "strip:amplitude", scale.amplitude.area.min, scale.amplitude.area.max);
    note_rect(ui.rects, "strip:frequency", scale.frequency.area.min, scale.frequency.area.max);
}

void follow_pattern(StripState& strip, const std::string& name) {
    if (strip.pattern == name) return;
    const float height = strip.height;
    const StripTool tool = strip.tool;
    strip = {};
    strip.height = height;
    strip.tool = tool;
    strip.pattern = name;
}

// A scroll through the pane that brings the strip under the mouse goes on with the pane.
void follow_wheel(StripState& strip, bool hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F) strip.is_scrolled_past = false;
    if (io.MouseWheel != 0.0F && !hovered) strip.is_scrolled_past = true;
}

}  // namespace

void draw_wave_strip(Ui& ui, Workspace& work, StripState& strip, const StripRoom& room) {
    const Vibration* vibration = current_vibration(work);
    const auto* source = vibration == nullptr ? nullptr : std::get_if<Pattern>(&vibration->source);
    if (source == nullptr) return;
    const Pattern pattern = *source;  // edits below replace the document's own
    follow_pattern(strip, vibration->name);
    if (strip.chosen && !exists(pattern, *strip.chosen)) strip.chosen.reset();
    const Waveform* waveform = waveform_in_time(work.cache, *vibration);
    const float least_px = kLeastHeightPx * ui.theme.scale;
    const float most_px = std::max(least_px, room.most_px);
    const float wanted_px = wanted_height_px(ui, strip, ImGui::GetContentRegionAvail());
    const float height_px = room.fills ? most_px : std::min(wanted_px, most_px);
    const Rect area = rect_at(ImGui::GetCursorScreenPos(),
                              {ImGui::GetContentRegionAvail().x, std::round(height_px)});
    const double peak = peak_in_time(work.cache, *vibration);
    const StripScale scale = strip.held
                                 ? strip.held->scale
                                 : strip_scale(pattern, peak, area, ui.theme,
                                               strip.view.value_or(whole(pattern)), strip.tool);
    ImGui::InvisibleButton("wave strip", area.size());
    note_rect(ui.rects, "strip tool", area.min, area.max, name_of(strip.tool));
    note_rect(ui.rects, "wave strip", area.min, area.max);  // by the mouse alone: no stop of Tab
    const bool hovered = ImGui::IsItemHovered();
    const auto under =
        hovered ? grip_at(pattern, scale, ImGui::GetIO().MousePos, kReachPx * ui.theme.scale)
                : std::nullopt;
    follow_wheel(strip, hovered);
    if (hovered && !strip.is_scrolled_past) {
        ImGui::SetItemUsingMouseWheel();
        zoom(strip, pattern, scale);
    }
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        double_click(ui, work, strip, pattern, scale, under);
    } else if (ImGui::IsItemActivated()) {
        press(ui, work, strip, pattern, scale, under);
    }
    if (strip.held && ImGui::IsItemActive()) drag(work, *strip.held, ui.theme.scale);
    if (strip.held && !ImGui::IsItemActive()) let_go(ui, work, strip);
    const PatternLook look = look_of(ui, work, work.selection.current);
    draw_strip_picture(*ImGui::GetWindowDrawList(), ui.theme, area,
                       {pattern, scale, waveform, look.colour, strip.chosen,
                        strip.held ? std::optional(strip.held->grip) : under, hovered});
    note_grips(ui, pattern, scale);
    if (!room.fills) draw_height_bar(ui, strip, area.height());
}

float strip_height(const Ui& ui, const StripState& strip) {
    return std::round(strip.height * ui.theme.scale) + ui.theme.splitter_px;
}

bool remove_chosen(Ui& ui, Workspace& work, StripState& strip) {
    const Vibration* vibration = current_vibration(work);
    if (!strip.chosen || vibration == nullptr || vibration->name != strip.pattern) return false;
    const Pattern* pattern = editable_pattern(*vibration);
    if (pattern == nullptr || !exists(*pattern, *strip.chosen)) return false;
    Pattern changed = *pattern;
    const GripKind kind = strip.chosen->kind;
    remove(changed, *strip.chosen);
    strip.chosen.reset();
    edit_current_pattern(work, changed);
    commit_step(ui, work,
                label_of(work, kind == GripKind::transient ? "Remove" : "Remove point of", kind));
    return true;
}

void add_at(Ui& ui, Workspace& work, StripState& strip, GripKind kind, double time_s) {
    const Vibration* vibration = current_vibration(work);
    if (vibration == nullptr) return;
    follow_pattern(strip, vibration->name);
    if (kind != GripKind::transient) return put_point(ui, work, strip, kind, time_s);
    const Pattern* pattern = editable_pattern(*vibration);
    if (pattern != nullptr) put_transient(ui, work, strip, time_s, pattern->amplitude_g);
}

void choose_next(Ui& ui, const Workspace& work, StripState& strip, int step) {
    const Vibration* vibration = current_vibration(work);
    const Pattern* pattern = vibration == nullptr ? nullptr : editable_pattern(*vibration);
    if (pattern == nullptr) return;
    follow_pattern(strip, vibration->name);
    const auto next = next_single(*pattern, strip.chosen, step);
    if (!next) return say(ui, "The pattern has no points and no transients yet.");
    choose(ui, strip, *next);
}

}  // namespace tact
