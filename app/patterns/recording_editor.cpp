#include "app/patterns/parts.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/ui/widgets.h"
#include "app/wave_strip/wave_strip.h"
#include "model/common/portable.h"
#include "model/signal/waveform.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr double kMsPerS = 1000.0;
constexpr double kShortestS = 0.001;
constexpr float kPicturePx = 150.0F;

RecordingCut whole(const Waveform& recording) {
    RecordingCut none;
    none.part_s = {0.0, duration_s(recording)};
    return none;
}

// Another recording, or an earlier version by undo: the cut begins with the recording in the set.
void follow_recording(RecordingEditor& editor, const Vibration& vibration) {
    const auto& measurement = std::get<Measurement>(vibration.source);
    const bool is_known = editor.name == vibration.name && editor.after == measurement.waveform;
    if (is_known && editor.cut != whole(*editor.before.waveform)) return;
    editor.name = vibration.name;
    editor.before = measurement;
    editor.note_before = vibration.note;
    editor.after = measurement.waveform;
    editor.cut = whole(*measurement.waveform);
}

void follow_trace(const Ui& ui, RecordingEditor& editor) {
    editor.job.want(
        TraceRequest{editor.after, editor.most_points},
        [](const TraceRequest& request, std::stop_token, std::atomic<float>&) {
            TraceParams params;
            params.most_points = request.most_points;
            return std::optional(TraceAnswer{request, traced(*request.recording, params)});
        },
        ui.wake, JobPolicy::finish);
}

void draw_source(Ui& ui, const Workspace& work, const Measurement& measurement) {
    dim_text(ui, measurement.synthetic ? "Synthetic measurement: simulated, not recorded"
                                       : "Measured waveform");
    const bool has_file = !measurement.path.empty();
    ImGui::TextWrapped(
        "%s", has_file ? shown_text(measurement.path).c_str() : "Its file is made on saving.");
    std::string words = significant(duration_s(*measurement.waveform)) + " s, peak " +
                        significant(peak_g(*measurement.waveform)) + " g";
    if (has_file) words += ", " + significant(measurement.scale_g) + " g at full scale";
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, {.id = "recording", .text = words});
    ImGui::PopTextWrapPos();
    if (!measurement.measures.empty()) {
        const std::string& name = current_vibration(work)->name;
        const std::string since = words_on_twin(work.stale, name);
        wrapped_text(ui, {.id = "measures", .text = "Measures " + measurement.measures + since});
    }
}

// The recording, and over it the curves of the traced pattern.
void draw_picture(const Ui& ui, const Workspace& work, const Measurement& measurement,
                  const TraceAnswer* answer) {
    const Theme& theme = ui.theme;
    const Rect area = rect_at(ImGui::GetCursorScreenPos(), {ImGui::GetContentRegionAvail().x,
                                                            std::round(kPicturePx * theme.scale)});
    ImGui::Dummy(area.size());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (answer == nullptr) {
        return draw_text(list, theme.fonts.small, area.min, theme.dim_text, "Being traced...");
    }
    const Pattern& pattern = answer->traced.pattern;
    const Waveform& waveform = *measurement.waveform;
    const StripScale scale =
        strip_scale(pattern, peak_g(waveform), area, theme, {0.0, duration_s(waveform)});
    const ImU32 colour = look_of(ui, work, work.selection.current).colour;
    draw_strip_picture(list, theme, area, {pattern, scale, &waveform, colour});
}

void put_cut(Workspace& work, RecordingEditor& editor) {
    RecordingCut& how = editor.cut;
    const double length_s = how.part_s.high - how.part_s.low;
    how.fade_in_s = std::min(how.fade_in_s, length_s);
    how.fade_out_s = std::min(how.fade_out_s, length_s);
    const Measurement& before = editor.before;
    Measurement recording = before;
    std::string note = editor.note_before;
    if (how != whole(*before.waveform)) {
        recording.waveform = std::make_shared<const Waveform>(cut(*before.waveform, how));
        recording.path.clear();  // saving writes a file of its own
        recording.scale_g = 1.0;
        if (!note.empty()) note += " ";
        note += cut_note(how, duration_s(*before.waveform), before.path);
    }
    editor.after = recording.waveform;
    edit_current_recording(work, recording, note);
}

struct CutField {
    Field field;
    double shown;  // the shown number is its value times this
    const char* what;
};

void draw_cut_field(Ui& ui, Workspace& work, RecordingEditor& editor, const CutField& cut_field,
                    double& value) {
    double edited = cut_field.shown * value;
    const FieldEdit edit = draw_field(ui, cut_field.field, edited);
    if (edit.changed && edited != cut_field.shown * value) {
        value = edited / cut_field.shown;
        put_cut(work, editor);
    }
    if (edit.finished) {
        commit_step(ui, work, std::string("Change ") + cut_field.what + " of " + editor.name);
    }
}

Field time_field(const char* id, const char* label, const Range& ms, double normal,
                 const char* help) {
    return {.id = id,
            .label = label,
            .format = "%.5g ms",
            .slider = ms,
            .typed = ms,
            .step = 5.0,
            .snap = 1.0,
            .help = help,
            .normal = normal};
}

void draw_cut_fields(Ui& ui, Workspace& work, RecordingEditor& editor) {
    const double length_s = duration_s(*editor.before.waveform);
    RecordingCut& cut = editor.cut;
    draw_cut_field(ui, work, editor,
                   {{.id = "gain_db",
                     .label = "Gain",
                     .format = "%.3g dB",
                     .slider = {-40.0, 20.0},
                     .typed = {-120.0, 60.0},
                     .step = 1.0,
                     .snap = 0.5,
                     .help = "Relative to the recording as it came into the editor.",
                     .normal = 0.0},
                    1.0,
                    "gain"},
                   cut.gain_db);
    draw_cut_field(ui, work, editor,
                   {time_field("from_ms", "From", {0.0, kMsPerS * (cut.part_s.high - kShortestS)},
                               0.0, "Where the part begins that is kept."),
                    kMsPerS, "beginning"},
                   cut.part_s.low);
    draw_cut_field(
        ui, work, editor,
        {time_field("to_ms", "To", {kMsPerS * (cut.part_s.low + kShortestS), kMsPerS * length_s},
                    kMsPerS * length_s, "Where the part ends that is kept."),
         kMsPerS, "end"},
        cut.part_s.high);
    const Range fade_ms{0.0, kMsPerS * (cut.part_s.high - cut.part_s.low)};
    draw_cut_field(ui, work, editor,
                   {time_field("fade_in_ms", "Fade in", fade_ms, 0.0,
                               "Half of a raised cosine from the beginning."),
                    kMsPerS, "fade"},
                   cut.fade_in_s);
    draw_cut_field(
        ui, work, editor,
        {time_field("fade_out_ms", "Fade out", fade_ms, 0.0, "Half of a raised cosine to the end."),
         kMsPerS, "fade"},
        cut.fade_out_s);
}

std::string trace_words(const TracedPattern& traced) {
    const Pattern& pattern = traced.pattern;
    std::string words = std::to_string(pattern.amplitude_curve.size()) + " points of amplitude";
    if (!pattern.frequency_curve.empty()) {
        words += ", " + std::to_string(pattern.frequency_curve.size()) + " of frequency";
    }
    words += ": within " + significant(traced.amplitude_error_g) + " g";
    if (traced.frequency_is_a_guess) {
        return words + " of it; it is too short to measure its frequency, so " +
               significant(pattern.carriers[0].frequency_hz) + " Hz are a guess";
    }
    return words + " and " + significant(traced.frequency_error_hz) + " Hz of it";
}

// Adds the pattern as the recording's partner, so that panes compare the two.
void make_parametric(Ui& ui, Workspace& work, const RecordingEditor& editor,
                     const TracedPattern& traced) {
    Vibration fresh;
    fresh.name = editor.name + " parametric";
    fresh.source = traced.pattern;
    fresh.note = "Traced from " + editor.name + ": " + trace_words(traced) + ".";
    add_vibrations(ui, work, {fresh}, "Make " + editor.name + " parametric");
    if (const auto recording = place_named(work.document.set, editor.name)) {
        choose_pair(work, work.selection.current, *recording);
    }
}

void draw_trace_fields(Ui& ui, Workspace& work, RecordingEditor& editor,
                       const TraceAnswer* answer) {
    constexpr Range kPoints{4.0, static_cast<double>(limits::kMaxCurvePoints)};
    auto points = static_cast<double>(editor.most_points);
    const FieldEdit edit =
        draw_field(ui,
                   {.id = "trace_points",
                    .label = "Points",
                    .format = "%.0f",
                    .slider = {kPoints.low, 200.0},
                    .typed = kPoints,
                    .step = 1.0,
                    .snap = 1.0,
                    .help = "Most points of each curve; they are set where they matter most.",
                    .normal = static_cast<double>(TraceParams{}.most_points)},
                   points);
    if (edit.changed) editor.most_points = static_cast<std::size_t>(std::lround(points));
    constexpr const char* kMake = "Make parametric";
    draw_label(ui, "", button_width(kMake));
    const bool pressed = primary_button(
        ui,
        {.id = "button:make parametric",
         .label = kMake,
         .tip = "A new pattern beside the recording: its amplitude and its strongest frequency as "
                "curves of one carrier. Phase, noise and further frequencies are lost; PM between "
                "the two tells whether that is felt.",
         .enabled = answer != nullptr});
    if (answer == nullptr) return;
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, {.id = "traced", .text = trace_words(answer->traced)});
    ImGui::PopTextWrapPos();
    if (pressed) make_parametric(ui, work, editor, answer->traced);
}

}  // namespace

Waveform cut(const Waveform& recording, const RecordingCut& how) {
    const Waveform part = part_of(recording, how.part_s.low, how.part_s.high);
    const double gain = portable::pow(10.0, how.gain_db / 20.0);
    Waveform result = faded(with_gain(part, gain), how.fade_in_s, how.fade_out_s);
    for (double& sample_g : result.samples_g)
        sample_g = static_cast<double>(static_cast<float>(sample_g));
    return result;
}

std::string cut_note(const RecordingCut& how, double length_s, const std::string& path) {
    std::vector<std::string> parts;
    if (how.gain_db != 0.0) {
        parts.push_back((how.gain_db > 0.0 ? "+" : "") + significant_digits(how.gain_db, 4) +
                        " dB");
    }
    if (how.part_s != Range{0.0, length_s}) {
        parts.push_back(significant_digits(how.part_s.low, 6) + " to " +
                        significant_digits(how.part_s.high, 6) + " s");
    }
    if (how.fade_in_s > 0.0 || how.fade_out_s > 0.0) {
        parts.push_back("fades of " + significant_digits(kMsPerS * how.fade_in_s, 4) + " and " +
                        significant_digits(kMsPerS * how.fade_out_s, 4) + " ms");
    }
    if (parts.empty()) return {};
    std::string note = "Cut" + (path.empty() ? std::string() : " from " + path) + ": ";
    for (std::size_t k = 0; k < parts.size(); ++k) note += (k == 0 ? "" : ", ") + parts[k];
    return note + ".";
}

void draw_recording_editor(Ui& ui, Workspace& work, RecordingEditor& editor) {
    const Vibration* vibration = current_vibration(work);
    if (vibration == nullptr || !std::holds_alternative<Measurement>(vibration->source)) return;
    const Measurement measurement = std::get<Measurement>(vibration->source);
    follow_recording(editor, *vibration);
    follow_trace(ui, editor);
    const std::shared_ptr<const TraceAnswer> answer = editor.job.current();
    draw_picture(ui, work, measurement, answer.get());
    draw_source(ui, work, measurement);
    draw_cut_fields(ui, work, editor);
    draw_trace_fields(ui, work, editor, answer.get());
}

}  // namespace tact
