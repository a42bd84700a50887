#include "app/wave_strip/wave_strip.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/ui/widgets.h"
#include "app/wave_strip/parts.h"
#include "model/set/felt_versions.h"
#include "model/set/layers.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr float kReachPx = 7.0F;
constexpr float kLeastHeightPx = 96.0F;
constexpr float kClickPx = 3.0F;  // a shorter movement is a click
constexpr double kBeyond = 1.06;  // keeps the end visible, with room for its grip

TimeRange view_of(const StripTime& time, const Pattern& pattern) {
    const TimeRange shown = fitted(time.range, pattern.duration_s);
    return {shown.start_s, shown.start_s + kBeyond * shown.length_s()};
}

// The wheel zooms about the mouse; with Shift, or sideways, it pans, and so does a drag with the
// middle button.
void zoom_and_pan(StripTime& time, const Pattern& pattern, const StripScale& scale) {
    const ImGuiIO& io = ImGui::GetIO();
    const Axis& axis = scale.amplitude.x;
    const double whole_s = pattern.duration_s;
    TimeRange shown = fitted(time.range, whole_s);
    const double per_px = (axis.high - axis.low) / static_cast<double>(axis.high_px - axis.low_px);
    constexpr float kWheelPx = 60.0F;
    float by_px = kWheelPx * ((io.KeyShift ? -io.MouseWheel : 0.0F) - io.MouseWheelH);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Middle)) by_px -= io.MouseDelta.x;
    if (by_px != 0.0F) shown = panned(shown, static_cast<double>(by_px) * per_px, whole_s);
    if (!io.KeyShift && io.MouseWheel != 0.0F) {
        const double factor = std::pow(1.25, -static_cast<double>(io.MouseWheel));
        shown = zoomed(shown, factor, to_value(axis, io.MousePos.x), whole_s);
    }
    if (by_px != 0.0F || io.MouseWheel != 0.0F) time.range = unless_whole(shown, whole_s);
}

// The ticks below the lanes: a drag there moves the playhead, a double click shows the whole
// pattern.
Rect ruler_of(const Rect& area, const StripScale& scale) {
    return {{scale.frequency.area.min.x, scale.frequency.area.max.y}, area.max};
}

void scrub(StripState& strip, StripTime& time, const Pattern& pattern, const StripScale& scale) {
    const double at_s = to_value(scale.amplitude.x, ImGui::GetIO().MousePos.x);
    time.playhead_s = std::clamp(at_s, 0.0, pattern.duration_s);
    if (!ImGui::IsItemActive()) strip.is_scrubbed = false;
}

void take(Workspace& work, GripKind kind, const Pattern& changed) {
    if (!is_shared(kind, changed)) return edit_current_pattern(work, changed);
    edit_patterns(work, [&](Pattern& pattern) { copy_change(kind, changed, pattern); });
}

std::string label_of(const Workspace& work, const std::string& verb, GripKind kind) {
    const Pattern* pattern = shown_pattern(work);
    const bool shared = pattern != nullptr && is_shared(kind, *pattern);
    const std::string what = name_of(kind);
    return verb + " " + (shared ? of_selection(work, what) : what + " of " + shown_name(work));
}

void complain_of_transients(Ui& ui) {
    complain(ui,
             "A pattern has at most " + grouped_digits(limits::kMaxTransients) + " transients.");
}

void choose(Ui& ui, StripState& strip, const Grip& grip) {
    strip.chosen = grip;
    ui.field.active = kChosenValue;  // arrows nudge it
}

// At an empty place, the tools of notes and ticks add an item, which follows the mouse.
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
        if (!drawn) return;
        strip.held = GripHold{*drawn, changed, scale, mouse, true, "Draw a note of"};
        choose_note(strip, changed, drawn->index);
        ui.field.active = kChosenValue;
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

// With the tool of notes, a press on a note also chooses it; with Shift, it only chooses.
bool press_note(Ui& ui, StripState& strip, const Pattern& pattern, const Grip& grip) {
    if (ImGui::GetIO().KeyShift) {
        toggle_note(strip, pattern, grip.index);
        ui.field.active = kChosenValue;
        return false;
    }
    const std::vector<NoteSteps> all = steps_of_notes(pattern);
    if (!std::ranges::binary_search(strip.notes.onsets, all[grip.index].first)) {
        choose_note(strip, pattern, grip.index);
    }
    ui.field.active = kChosenValue;
    return true;
}

void press(Ui& ui, Workspace& work, StripState& strip, const Pattern& pattern,
           const StripScale& scale, std::optional<Grip> under) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    strip.chosen.reset();
    strip.has_just_drawn = false;
    const bool draws_notes = scale.tool == StripTool::notes;
    if (under && is_note(under->kind) && draws_notes) {
        if (!press_note(ui, strip, pattern, *under)) return;
    } else {
        strip.notes = {};
    }
    if (!under && draws_notes && ImGui::GetIO().KeyShift) {
        strip.box = NoteBox{mouse.x, mouse.x, scale};
        return;
    }
    if (!under) return begin_drawing(ui, work, strip, pattern, scale);
    strip.held = GripHold{*under, pattern, scale, mouse};
    strip.held->notes = strip.notes;
    if (is_single(under->kind)) choose(ui, strip, *under);
}

void drag(Ui& ui, Workspace& work, StripState& strip) {
    GripHold& held = *strip.held;
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 way = io.MousePos - held.pressed;
    held.moved = held.moved || std::hypot(way.x, way.y) > kClickPx * ui.theme.scale;
    if (!held.moved) return;
    const GripDrag by{held.pressed, io.MousePos, io.KeyShift, io.KeyAlt};
    if (drag_chosen_notes(ui, work, strip, by)) return;
    const Pattern changed = dragged(held.before, held.grip, held.scale, by);
    take(work, held.grip.kind, changed);
    if (!strip.notes.empty()) choose_note(strip, changed, held.grip.index);
}

void put_point(Ui& ui, Workspace& work, StripState& strip, GripKind line, double time_s) {
    const Pattern* pattern = editable_layer(work);
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
    if (held.moved && held.notes.onsets.size() > 1) {
        return commit_step(ui, work, "Change " + of_selection(work, "notes"));
    }
    if (held.moved) return commit_step(ui, work, label_of(work, held.verb, held.grip.kind));
    // A click on one of several chooses it alone.
    if (!held.notes.empty()) choose_note(strip, held.before, held.grip.index);
    if (strip.tool != StripTool::curves) return;
    put_point(ui, work, strip, held.grip.kind, to_value(held.scale.amplitude.x, held.pressed.x));
}

void put_transient(Ui& ui, Workspace& work, StripState& strip, double time_s, double amplitude_g) {
    const Pattern* pattern = editable_layer(work);
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
    strip.notes = {};
    // The first press of the double click drew this item.
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

// The height set by the person. Its default in a wide pane is proportional to the width, within
// limits of the pane, and takes all room that the fields leave.
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

void note_grips(Ui& ui, const Pattern& pattern, const StripScale& scale, const Rect& ruler) {
    if (ui.rects.file.empty()) return;
    const ImVec2 half{2.0F, 2.0F};
    for (const PlacedGrip& placed : placed_grips(pattern, scale)) {
        note_rect(ui.rects,
                  std::string("grip:") + name_of(placed.grip.kind) + ":" +
                      std::to_string(placed.grip.index),
                  placed.at - half, placed.at + half);
    }
    for (const NoteBlock& block : note_blocks(pattern, scale)) {
        note_rect(ui.rects, "note:" + std::to_string(block.index), block.area.min, block.area.max);
    }
    note_rect(ui.rects, "strip:amplitude", scale.amplitude.area.min, scale.amplitude.area.max);
    note_rect(ui.rects, "strip:ruler", ruler.min, ruler.max);
    note_rect(ui.rects, "strip:frequency", scale.frequency.area.min, scale.frequency.area.max);
}

// The wave shown dim below the pattern: the recording that measures it, or its partner if that is a
// recording.
struct Ghost {
    const Waveform* waveform = nullptr;
    std::string words;
};

Ghost ghost_of(const Workspace& work, const Vibration& vibration) {
    const auto& all = work.document.set.vibrations;
    const auto measurement_of = [](const Vibration& one) {
        return std::get_if<Measurement>(&one.source);
    };
    auto found = std::ranges::find_if(all, [&](const Vibration& one) {
        const Measurement* measurement = measurement_of(one);
        return measurement != nullptr && measurement->measures == vibration.name;
    });
    if (found == all.end()) {
        found = std::ranges::find_if(all, [&](const Vibration& one) {
            return one.name == work.selection.pinned && measurement_of(one) != nullptr;
        });
    }
    if (found == all.end()) return {};
    const Measurement& measurement = *measurement_of(*found);
    const std::string since =
        measurement.measures.empty() ? "" : words_on_twin(work.stale, found->name);
    return {measurement.waveform.get(),
            "beneath: " + found->name + (measurement.synthetic ? ", synthetic" : "") + since};
}

// The sum of the other layers, starting where the open one begins; none if there are no layers, or
// the pattern is long.
void follow_other_layers(const Workspace& work, std::optional<LayersBeneath>& beneath) {
    const LayeredPattern* layered = current_layers(work);
    if (layered == nullptr || duration_s(*layered) * kModelRateHz > kMostSamplesAtOnce) {
        beneath.reset();
        return;
    }
    if (beneath && beneath->revision == work.revision) return;
    LayeredPattern others = *layered;
    const std::size_t open = open_layer(work);
    for (std::size_t k = 0; k < others.layers.size(); ++k) {
        others.layers[k].mute = k == open || !sounds(*layered, k);
        others.layers[k].solo = false;
    }
    beneath = LayersBeneath{work.revision, render(others)};
    std::vector<double>& samples = beneath->waveform.samples_g;
    const auto before = static_cast<std::ptrdiff_t>(
        std::min(samples.size(), sample_count(layered->layers[open].offset_s, kModelRateHz)));
    samples.erase(samples.begin(), samples.begin() + before);
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

// A scroll through the pane that brings the strip under the mouse continues in the pane.
void follow_wheel(StripState& strip, bool hovered) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F) strip.is_scrolled_past = false;
    if (io.MouseWheel != 0.0F && !hovered) strip.is_scrolled_past = true;
}

// Where the mouse is, over the strip that is the last item.
struct StripMouse {
    const Pattern& pattern;
    const StripScale& scale;
    std::optional<Grip> under;
    bool hovered;
    bool on_ruler;
};

void take_mouse(Ui& ui, Workspace& work, StripState& strip, StripTime& time,
                const StripMouse& mouse) {
    if (mouse.on_ruler && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        time.range = {};
    } else if (mouse.on_ruler && ImGui::IsItemActivated()) {
        strip.is_scrubbed = true;
    } else if (mouse.hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        double_click(ui, work, strip, mouse.pattern, mouse.scale, mouse.under);
    } else if (ImGui::IsItemActivated()) {
        press(ui, work, strip, mouse.pattern, mouse.scale, mouse.under);
    }
    if (strip.is_scrubbed) scrub(strip, time, mouse.pattern, mouse.scale);
    if (strip.held && ImGui::IsItemActive()) drag(ui, work, strip);
    if (strip.held && !ImGui::IsItemActive()) let_go(ui, work, strip);
    if (strip.box) strip.box->to_px = ImGui::GetIO().MousePos.x;
    if (strip.box && !ImGui::IsItemActive()) {
        choose_boxed(strip, mouse.pattern, kClickPx * ui.theme.scale);
        if (!strip.notes.empty()) ui.field.active = kChosenValue;
    }
}

}  // namespace

void draw_wave_strip(Ui& ui, Workspace& work, StripState& strip, StripTime& time,
                     const StripRoom& room) {
    const Pattern* source = shown_pattern(work);
    if (source == nullptr) return;
    const Vibration vibration = shown_vibration(work);
    const Pattern pattern = *source;  // edits below replace the document's own
    follow_pattern(strip, shown_name(work));
    if (strip.chosen && !exists(pattern, *strip.chosen)) strip.chosen.reset();
    strip.notes =
        strip.tool == StripTool::notes ? kept_choice(pattern, strip.notes) : ChosenNotes{};
    const Waveform* waveform = waveform_in_time(work.cache, vibration);
    const float least_px = kLeastHeightPx * ui.theme.scale;
    const float most_px = std::max(least_px, room.most_px);
    const float wanted_px = wanted_height_px(ui, strip, ImGui::GetContentRegionAvail());
    const float height_px = room.fills ? most_px : std::min(wanted_px, most_px);
    const Rect area = rect_at(ImGui::GetCursorScreenPos(),
                              {ImGui::GetContentRegionAvail().x, std::round(height_px)});
    follow_other_layers(work, strip.beneath);
    const Ghost ghost = strip.beneath ? Ghost{&strip.beneath->waveform, "beneath: the other layers"}
                                      : ghost_of(work, vibration);
    const double peak = std::max(peak_in_time(work.cache, vibration),
                                 ghost.waveform == nullptr ? 0.0 : peak_g(*ghost.waveform));
    const StripScale scale =
        strip.held ? strip.held->scale
                   : strip_scale(pattern, peak, area, ui.theme, view_of(time, pattern), strip.tool);
    const Rect ruler = ruler_of(area, scale);
    ImGui::InvisibleButton("wave strip", area.size());
    note_rect(ui.rects, "strip tool", area.min, area.max, name_of(strip.tool));
    note_rect(ui.rects, "wave strip", area.min, area.max);  // only for the mouse: Tab skips it
    const bool hovered = ImGui::IsItemHovered();
    const auto under =
        hovered ? grip_at(pattern, scale, ImGui::GetIO().MousePos, kReachPx * ui.theme.scale)
                : std::nullopt;
    note_rect(ui.rects, "strip:under", area.min, area.max,
              under ? name_of(under->kind) : "nothing");
    follow_wheel(strip, hovered);
    if (hovered && !strip.is_scrolled_past) {
        ImGui::SetItemUsingMouseWheel();
        zoom_and_pan(time, pattern, scale);
    }
    const bool on_ruler = hovered && ruler.contains(ImGui::GetIO().MousePos);
    take_mouse(ui, work, strip, time, {pattern, scale, under, hovered, on_ruler});
    if (strip.held)
        note_rect(ui.rects, "strip:held", area.min, area.max, name_of(strip.held->grip.kind));
    strip.pointed_s.reset();
    if (hovered) strip.pointed_s = to_value(scale.amplitude.x, ImGui::GetIO().MousePos.x);
    const PatternLook look = look_of(ui, work, work.selection.current);
    draw_strip_picture(*ImGui::GetWindowDrawList(), ui.theme, area,
                       {pattern, scale, waveform, look.colour, strip.chosen,
                        strip.held ? std::optional(strip.held->grip) : under, hovered, strip.notes,
                        strip.box, time.playhead_s, ghost.waveform, ghost.words, on_ruler});
    if (ghost.waveform != nullptr) {
        note_rect(ui.rects, "strip:ghost", area.min, area.max, ghost.words);
    }
    note_grips(ui, pattern, scale, ruler);
    if (!room.fills) draw_height_bar(ui, strip, area.height());
}

float strip_height(const Ui& ui, const StripState& strip) {
    return std::round(strip.height * ui.theme.scale) + ui.theme.splitter_px;
}

bool remove_chosen(Ui& ui, Workspace& work, StripState& strip) {
    if (remove_notes(ui, work, strip)) return true;
    if (!strip.chosen || shown_name(work) != strip.pattern) return false;
    const Pattern* pattern = editable_layer(work);
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
    follow_pattern(strip, shown_name(work));
    if (kind != GripKind::transient) return put_point(ui, work, strip, kind, time_s);
    const Pattern* pattern = editable_layer(work);
    if (pattern != nullptr) put_transient(ui, work, strip, time_s, pattern->amplitude_g);
}

void choose_next(Ui& ui, const Workspace& work, StripState& strip, int step) {
    const Pattern* pattern = editable_layer(work);
    if (pattern == nullptr) return;
    follow_pattern(strip, shown_name(work));
    if (strip.tool == StripTool::notes) return choose_next_note(ui, strip, *pattern, step);
    const auto next = next_single(*pattern, strip.chosen, step);
    if (!next) return say(ui, "The pattern has no points and no transients yet.");
    choose(ui, strip, *next);
}

}  // namespace tact
