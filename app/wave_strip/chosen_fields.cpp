// The numbers of the chosen point, transient or notes, typed and nudged like all others.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <variant>

#include "app/document/editing.h"
#include "app/ui/widgets.h"
#include "app/wave_strip/parts.h"
#include "app/wave_strip/wave_strip.h"
#include "model/pattern/pattern_numbers.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr double kMs = 1000.0;

using Write = std::function<void(Pattern&, double)>;

void draw_chosen(Ui& ui, Workspace& work, const Field& field, double value, const std::string& what,
                 const Write& write) {
    ImGui::TableNextColumn();
    double edited = value;
    const FieldEdit edit = draw_field(ui, field, edited);
    const Vibration* vibration = current_vibration(work);
    if (edit.changed && edited != value) {
        Pattern changed = *shown_pattern(work);
        write(changed, edited);
        edit_current_pattern(work, changed);
    }
    if (edit.finished) commit_step(ui, work, "Change " + what + " of " + vibration->name);
}

Field time_field(const Range& room_s) {
    Field field = field_of(numbers::kTime, "chosen_time_ms");
    field.slider = field.typed = numbers::kTime.shown(room_s);
    field.help = nullptr;
    return field;
}

template <class Point>
void draw_time(Ui& ui, Workspace& work, const Pattern& pattern, std::vector<Point> Pattern::*curve,
               std::size_t k, const std::string& what) {
    const std::vector<Point>& points = pattern.*curve;
    draw_chosen(ui, work, time_field(room_of(points, k, pattern.duration_s)),
                kMs * points[k].time_s, what,
                [curve, k](Pattern& p, double ms) { (p.*curve)[k].time_s = ms / kMs; });
}

void draw_amplitude_point(Ui& ui, Workspace& work, const Pattern& pattern, std::size_t k) {
    const AmplitudePoint& point = pattern.amplitude_curve[k];
    const std::string what = name_of(GripKind::amplitude_point);
    draw_time(ui, work, pattern, &Pattern::amplitude_curve, k, what);
    draw_chosen(ui, work, field_of(numbers::kCurveValue, kChosenValue), 100.0 * point.value, what,
                [k](Pattern& p, double percent) { p.amplitude_curve[k].value = percent / 100.0; });
}

void draw_frequency_point(Ui& ui, Workspace& work, const Pattern& pattern, std::size_t k) {
    const FrequencyPoint& point = pattern.frequency_curve[k];
    const std::string what = name_of(GripKind::frequency_point);
    draw_time(ui, work, pattern, &Pattern::frequency_curve, k, what);
    draw_chosen(ui, work, field_of(numbers::kPointFrequency, kChosenValue), point.frequency_hz,
                what, [k](Pattern& p, double hz) { p.frequency_curve[k].frequency_hz = hz; });
}

void draw_transient(Ui& ui, Workspace& work, const Pattern& pattern, std::size_t k) {
    const Transient& transient = pattern.transients[k];
    const std::string what = name_of(GripKind::transient);
    draw_chosen(ui, work, time_field({0.0, pattern.duration_s}), kMs * transient.time_s, what,
                [k](Pattern& p, double ms) { p.transients[k].time_s = ms / kMs; });
    draw_chosen(ui, work, field_of(numbers::kTransientPeak, kChosenValue), transient.amplitude_g,
                what, [k](Pattern& p, double g) { p.transients[k].amplitude_g = g; });
    draw_chosen(ui, work, field_of(numbers::kTransientFrequency, "chosen_hz"),
                transient.frequency_hz, what,
                [k](Pattern& p, double hz) { p.transients[k].frequency_hz = hz; });
    draw_chosen(ui, work, field_of(numbers::kTransientDuration, "chosen_duration_ms"),
                kMs * transient.duration_s, what,
                [k](Pattern& p, double ms) { p.transients[k].duration_s = ms / kMs; });
    ImGui::TableNextColumn();
    constexpr std::array kShapes{Choice{TransientShape::sine, "sine"},
                                 Choice{TransientShape::square, "square"}};
    draw_label(ui, "Shape", segments_width(ui, kShapes));
    TransientShape shape = transient.shape;
    if (!draw_segments(ui, kShapes, shape)) return;
    Pattern changed = pattern;
    changed.transients[k].shape = shape;
    edit_current_pattern(work, changed);
    commit_step(ui, work, "Change shape of a transient of " + current_vibration(work)->name);
}

// Edits the chosen notes during a gesture, which is one step when it ends.
template <class With>
void draw_note_number(Ui& ui, Workspace& work, StripState& strip, const Field& field, double value,
                      With with) {
    ImGui::TableNextColumn();
    double edited = value;
    const FieldEdit edit = draw_field(ui, field, edited);
    const Pattern before = *shown_pattern(work);
    if (edit.changed && edited != value) {
        const Expected<NotesEdit> notes = with(before, edited);
        if (!notes) return complain(ui, notes.error().message);
        take_rhythm(work, before, notes->pattern);
        strip.notes = notes->chosen;
    }
    if (edit.finished) commit_step(ui, work, "Change " + of_selection(work, "notes"));
}

// Each field has the number of the first note; the others keep their offsets from it.
void draw_note_times(Ui& ui, Workspace& work, StripState& strip, const Pattern& pattern,
                     const NoteSteps& first) {
    const double unit_ms = kMs * pattern.rhythm.unit_s;
    const Range ms{0.0, kMs * pattern.duration_s};
    const auto steps_of = [unit_ms](double value) {
        return static_cast<std::ptrdiff_t>(std::llround(value / unit_ms));
    };
    const auto from = static_cast<std::ptrdiff_t>(first.first);
    draw_note_number(
        ui, work, strip,
        {.id = kChosenValue,
         .label = "Start",
         .format = "%.5g ms",
         .slider = ms,
         .typed = ms,
         .step = unit_ms,
         .snap = unit_ms,
         .help = "When the first of the chosen notes begins; the others keep their distance."},
        unit_ms * static_cast<double>(first.first), [&](const Pattern& p, double to) {
            return with_notes_moved(p, strip.notes, steps_of(to) - from);
        });
    const Range length_ms{unit_ms, std::max(unit_ms, ms.high)};
    draw_note_number(ui, work, strip,
                     {.id = "chosen_length_ms",
                      .label = "Length",
                      .format = "%.5g ms",
                      .slider = length_ms,
                      .typed = length_ms,
                      .step = unit_ms,
                      .snap = unit_ms,
                      .help = "How long each of the chosen notes is held, up to the next note."},
                     unit_ms * static_cast<double>(first.last + 1 - first.first),
                     [&](const Pattern& p, double to) {
                         const auto steps = std::max<std::ptrdiff_t>(1, steps_of(to));
                         return with_notes_held(p, strip.notes, static_cast<std::size_t>(steps));
                     });
}

void draw_note_kind(Ui& ui, Workspace& work, StripState& strip, const Pattern& pattern,
                    const NoteSteps& first) {
    const std::string& text = pattern.rhythm.text;
    const NoteKind kind = kind_of(pattern.rhythm, text[first.first % text.size()]);
    constexpr double kNinth = 100.0 / 9.0;
    draw_note_number(ui, work, strip,
                     {.id = "chosen_strength",
                      .label = "Strength",
                      .format = "%.3g %%",
                      .slider = {kNinth, 100.0},
                      .typed = numbers::kVelocity.shown(limits::kVelocity),
                      .step = kNinth,
                      .snap = kNinth,
                      .help = "How strong the first of the chosen notes is, as a share of the "
                              "amplitude; the others keep their differences to it."},
                     100.0 * kind.velocity, [&](const Pattern& p, double to) {
                         return with_notes_changed(p, strip.notes, to / 100.0 - kind.velocity, 1.0);
                     });
    Field pitch = field_of(numbers::kPitch, "chosen_pitch");
    pitch.label = "Pitch";
    pitch.help =
        "What the carriers' frequencies are multiplied by while the first of the chosen notes "
        "sounds; the others keep their ratios to it.";
    draw_note_number(ui, work, strip, pitch, kind.pitch, [&](const Pattern& p, double to) {
        return with_notes_changed(p, strip.notes, 0.0, to / kind.pitch);
    });
}

void draw_note_actions(Ui& ui, Workspace& work, StripState& strip) {
    ImGui::TableNextColumn();
    const std::size_t count = strip.notes.onsets.size();
    ImGui::AlignTextToFramePadding();
    dim_text(ui, {.id = "notes chosen", .text = counted(count, "note", "notes")});
    for (const auto& [label, times, help] :
         {std::tuple{"Double", 2, "Ctrl+D: the notes once more, right after themselves."},
          std::tuple{"Repeat 4 times", kRepeats, "R: the notes four times in all."}}) {
        flow_on(button_width(label), ui.theme.gap_px);
        if (button(ui, {.id = std::string("notes:") + label, .label = label, .tip = help}))
            (void)repeat_notes(ui, work, strip, times);
        if (strip.notes.empty()) return;
    }
}

void draw_notes(Ui& ui, Workspace& work, StripState& strip, const Pattern& pattern) {
    const std::vector<NoteSteps> all = steps_of_notes(pattern);
    const auto found = std::ranges::find(all, strip.notes.onsets.front(), &NoteSteps::first);
    if (found == all.end()) return;
    const NoteSteps first = *found;
    draw_note_times(ui, work, strip, pattern, first);
    draw_note_kind(ui, work, strip, pattern, first);
    draw_note_actions(ui, work, strip);
}

int columns_in(const Ui& ui, float width_px) {
    constexpr float kFieldPx =
        274.0F;  // label, slider and entry on one line, and the cell's padding
    return std::clamp(static_cast<int>(width_px / (kFieldPx * ui.theme.scale)), 1, 3);
}

int count_of(GripKind kind) {
    if (is_note(kind)) return 5;
    return kind == GripKind::transient ? 5 : 2;
}

// The chosen item of the pattern in the editor; of several notes, the first.
std::optional<Grip> chosen_of(const Workspace& work, const StripState& strip) {
    const Pattern* pattern = shown_pattern(work);
    if (has_chosen_notes(work, strip)) return Grip{GripKind::note};
    const bool is_there = strip.chosen && pattern != nullptr && shown_name(work) == strip.pattern &&
                          exists(*pattern, *strip.chosen);
    return is_there ? strip.chosen : std::nullopt;
}

}  // namespace

float chosen_fields_px(const Ui& ui, const Workspace& work, const StripState& strip) {
    const auto chosen = chosen_of(work, strip);
    if (!chosen) return 0.0F;
    const int columns = columns_in(ui, ImGui::GetContentRegionAvail().x);
    const int rows = (count_of(chosen->kind) + columns - 1) / columns;
    return static_cast<float>(rows) * ImGui::GetFrameHeightWithSpacing() +
           2.0F * ImGui::GetStyle().ItemSpacing.y;
}

void draw_chosen_fields(Ui& ui, Workspace& work, StripState& strip) {
    const auto chosen = chosen_of(work, strip);
    if (!chosen) return;
    const Pattern pattern = *shown_pattern(work);
    const int columns = columns_in(ui, ImGui::GetContentRegionAvail().x);
    ImGui::BeginDisabled(current_vibration(work)->locked);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {ui.theme.gap_px, 0.0F});
    if (ImGui::BeginTable("chosen", columns,
                          ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoPadOuterX)) {
        const std::size_t k = chosen->index;
        if (chosen->kind == GripKind::amplitude_point) draw_amplitude_point(ui, work, pattern, k);
        if (chosen->kind == GripKind::frequency_point) draw_frequency_point(ui, work, pattern, k);
        if (chosen->kind == GripKind::transient) draw_transient(ui, work, pattern, k);
        if (chosen->kind == GripKind::note) draw_notes(ui, work, strip, pattern);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
    ImGui::EndDisabled();
    // ImGui's own separator is one pixel at any scale.
    const Rect rest = rest_of_pane();
    draw_level_line(*ImGui::GetWindowDrawList(), rest.min.y, rest.min.x, rest.max.x,
                    ui.theme.hairline_px, ui.theme.line);
    ImGui::Dummy({1.0F, ui.theme.hairline_px});
}

}  // namespace tact
