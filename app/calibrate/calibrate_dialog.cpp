// The dialog that measures an actuator: what to play, what was recorded, how many g that makes at
// each frequency, and what the table is to say of itself.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/calibrate/calibrate.h"
#include "app/play/play.h"
#include "app/progress/progress.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/charts/response_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kDialogPx = 620.0F;
constexpr float kPlotPx = 150.0F;
constexpr Range kToneRangeHz{1.0, 2000.0};

void wrapped_dim(const Ui& ui, const std::string& text) {
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, text);
    ImGui::PopTextWrapPos();
}

void heading(const Ui& ui, const char* text) {
    ImGui::Spacing();
    ImGui::PushFont(ui.theme.fonts.semibold);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

double signal_s(const CalibrationParams& params) {
    const Drive drive = calibration_plan(params).drive;
    return static_cast<double>(drive.samples.size()) / drive.rate_hz;
}

void draw_kind(Ui& ui, CalibrateState& calibrating, bool& changed) {
    CalibrationParams& params = calibrating.params;
    draw_label(ui, "Signal");
    const auto choice = [&](const char* id, const char* text, bool sweep, const char* tip) {
        const Item item{.id = std::string("calibrate:") + id, .label = text, .tip = tip};
        const bool is_chosen = params.is_sweep == sweep;
        if (toggle(ui, item, is_chosen) && !is_chosen) {
            params.is_sweep = sweep;
            changed = true;
        }
        ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    };
    choice("tones", "stepped tones", false,
           "A tone at each sixth of an octave and at three levels: tells distortion, and whether "
           "twice the drive is twice the g");
    choice("sweep", "sweep", true, "A sine that rises three times, each time stronger");
    ImGui::NewLine();
    const CalibrationParams normal;
    changed |= draw_number_row(ui, {"calibrate:low", "From", normal.low_hz, kToneRangeHz, "Hz"},
                               params.low_hz);
    changed |= draw_number_row(ui, {"calibrate:high", "To", normal.high_hz, kToneRangeHz, "Hz"},
                               params.high_hz);
    params.high_hz = std::max(params.high_hz, params.low_hz);
}

void draw_playing(Ui& ui, Timeline& timeline, PlayState& play, const CalibrateState& calibrating) {
    const double whole_s = signal_s(calibrating.params);
    const double at_s = std::clamp(play.status.position_s, 0.0, whole_s);
    const std::string text = significant(at_s, 2) + " s of " + significant(whole_s, 2) + " s";
    if (button(ui, {.id = "button:stop signal", .label = "Stop"})) silence(timeline, play);
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ui.theme.accent);
    ImGui::ProgressBar(whole_s > 0.0 ? static_cast<float>(at_s / whole_s) : 0.0F,
                       {220.0F * ui.theme.scale, 0.0F}, text.c_str());
    ImGui::PopStyleColor();
    note_item(ui.rects, "calibrate:playing", text);
}

void draw_signal_part(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                      CalibrateState& calibrating) {
    heading(ui, "1  Play the signal while the sensor records");
    bool changed = false;
    ImGui::BeginDisabled(calibrating.is_playing);
    draw_kind(ui, calibrating, changed);
    ImGui::EndDisabled();
    if (changed) look_at_recording(ui, calibrating);
    const std::string most = percent(calibrating.params.levels.back());
    const bool has_device = can_be_calibrated(play);
    wrapped_dim(ui, significant(signal_s(calibrating.params), 3) + " s on " +
                        (has_device ? device_text(play) : "an audio output, once one is chosen") +
                        ", up to " + most + " of full scale whatever the playback level. Begin " +
                        "recording before it, and end after it.");
    if (calibrating.is_playing) return draw_playing(ui, timeline, play, calibrating);
    constexpr const char* kNoOutput = "Choose an audio output in Play > Devices... first";
    if (button(ui, {.id = "button:play signal",
                    .label = "Play the signal",
                    .why_not = can_sound(play) ? "" : kNoOutput})) {
        play_calibration_signal(ui, timeline, play, calibrating);
    }
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    if (button(ui, {.id = "button:save signal",
                    .label = "Save as WAV...",
                    .tip = "To play it by other means, at full level"})) {
        save_calibration_signal_dialog(ui, work, calibrating);
    }
}

void draw_recording_part(Ui& ui, const Workspace& work, CalibrateState& calibrating) {
    heading(ui, "2  Open what it recorded");
    if (button(ui, {.id = "button:open recording",
                    .label = "Open recording...",
                    .tip = "A table (.csv, .txt) or .wav of one or three axes"})) {
        open_calibration_recording_dialog(ui, work, calibrating);
    }
    if (calibrating.recording.empty()) return;
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    const float room = ImGui::GetContentRegionAvail().x;
    const std::string name = calibrating.recording.filename().string();
    dim_text(ui, {.id = "calibrate:recording",
                  .text = shortened(ui.theme.fonts.regular, name, room),
                  .value = name});
    const bool is_wave = extension_of(calibrating.recording) == ".wav";
    if (draw_recording_fields(ui, calibrating.fields, is_wave)) look_at_recording(ui, calibrating);
}

std::string point_text(const ResponsePoint& point) {
    if (point.unknown) {
        return significant(point.frequency_hz) + " Hz: not known, and nothing is sent around it";
    }
    return significant(point.frequency_hz) + " Hz: " + significant(point.g_per_full_scale) +
           " g at full scale, distortion " + percent(point.thd) + ", off proportion " +
           percent(point.nonlinearity);
}

// The worst of each, in one line.
std::string summary_of(const CalibrationResult& result) {
    const auto taken = std::ranges::count_if(result.tones, &MeasuredTone::accepted);
    const auto worst = [&](auto what) {
        const auto most = std::ranges::max_element(result.points, {}, what);
        return percent((*most).*what) + " at " + significant(most->frequency_hz) + " Hz";
    };
    std::string text = std::to_string(taken) + " of " + std::to_string(result.tones.size()) +
                       " tones are good. Most distortion: " + worst(&ResponsePoint::thd) + ".";
    const bool has_levels = result.tones.size() > result.points.size();
    if (has_levels) text += " Most off proportion: " + worst(&ResponsePoint::nonlinearity) + ".";
    return text;
}

void draw_response_plot(Ui& ui, const CalibrationResult& result) {
    std::vector<ResponseMark> table;
    std::vector<ResponseMark> refused;
    for (const ResponsePoint& point : result.points) {
        table.push_back({point.frequency_hz, point.g_per_full_scale});
    }
    for (const MeasuredTone& tone : result.tones) {
        if (tone.accepted || tone.tone.level <= 0.0) continue;
        refused.push_back({tone.tone.frequency_hz, tone.amplitude_g / tone.tone.level});
    }
    const ImVec2 size{ImGui::GetContentRegionAvail().x, kPlotPx * ui.theme.scale};
    const Rect area = rect_at(ImGui::GetCursorScreenPos(), size);
    const ResponseAction action = draw_response("response", ui.theme, area, {table, refused});
    note_rect(ui.rects, "calibrate:response", area.min, area.max,
              std::to_string(result.points.size()));
    const std::string text =
        action.hovered ? point_text(result.points[*action.hovered]) : summary_of(result);
    ImGui::PushTextWrapPos(0.0F);
    plain_text(ui, {.id = "calibrate:summary", .text = text});
    ImGui::PopTextWrapPos();
    if (refused.empty()) return;
    wrapped_dim(ui, "Left out, drawn as rings: " + words_on_left_out() + ".");
}

// Where the table may err, which no number of it tells.
void draw_doubts(Ui& ui, const CalibrationResult& result) {
    for (std::size_t k = 0; k < result.remarks.size(); ++k) {
        coloured_text(ui, ui.theme.warning,
                      {.id = "calibrate:remark " + std::to_string(k),
                       .text = result.remarks[k] + ".",
                       .value = result.remarks[k]});
    }
}

void draw_result_part(Ui& ui, const CalibrateState& calibrating) {
    heading(ui, "3  Its strength at full scale, in g");
    const ResponseAnswer* const answer = current_answer(calibrating);
    if (answer != nullptr && answer->fault.empty()) {
        draw_response_plot(ui, answer->result);
        for (const std::string& remark : answer->remarks) wrapped_dim(ui, "Read: " + remark + ".");
        draw_doubts(ui, answer->result);
        return;
    }
    if (answer == nullptr && draw_failure(ui, "calibrate", calibrating.job.failure())) return;
    const ImVec2 size{ImGui::GetContentRegionAvail().x, kPlotPx * ui.theme.scale};
    const Rect area = rect_at(ImGui::GetCursorScreenPos(), size);
    ImGui::Dummy(size);
    const bool waits = calibrating.recording.empty();
    const bool failed = answer != nullptr;
    draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area,
               waits    ? "No recording yet"
               : failed ? "Cannot be used"
                        : "Measuring",
               waits    ? "The response will stand here."
               : failed ? answer->fault
                        : "The recording is compared with the signal.");
    note_rect(ui.rects, "calibrate:waits", area.min, area.max, failed ? answer->fault : "");
}

void draw_words(Ui& ui, const char* id, const char* label, const char* hint, std::string& text) {
    draw_label(ui, label);
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint((std::string("##") + id).c_str(), hint, &text);
    note_item(ui.rects, id, text);
}

void draw_about_part(Ui& ui, CalibrateState& calibrating) {
    Calibration& about = calibrating.about;
    heading(ui, "4  What it was, for the file");
    draw_words(ui, "calibrate:actuator", "Actuator", "its name", about.actuator);
    draw_words(ui, "calibrate:mounting", "Mounting", "how it was held or fixed", about.mounting);
    draw_words(ui, "calibrate:gain", "Gain", "of amplifier and mixer: another makes it invalid",
               about.gain_note);
    draw_words(ui, "calibrate:sensor", "Sensor", "what it was recorded with", about.sensor);
    const auto row = [&](const char* id, const char* label, double Calibration::*number,
                         double most, const char* unit) {
        const double normal = Calibration{}.*number;
        draw_number_row(ui, {id, label, normal, {0.0, most}, unit}, about.*number);
    };
    row("calibrate:mass", "Moved mass", &Calibration::load_mass_g, 1e5,
        "grams, with what it is fixed to; 0: not known");
    row("calibrate:excursion", "Travel", &Calibration::excursion_limit_mm, 100.0,
        "mm to either side at most; 0: not known");
    row("calibrate:rms", "Heat", &Calibration::rms_limit, 1.0,
        "of full scale, rms over a second at most; 0: not known");
}

void draw_parts(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                CalibrateState& calibrating) {
    const std::string actuator =
        can_be_calibrated(play) ? "the actuator on " + device_text(play) : "an actuator";
    wrapped_dim(ui, "How many g " + actuator +
                        " gives at each frequency, by an accelerometer fixed to it.");
    draw_signal_part(ui, work, timeline, play, calibrating);
    draw_recording_part(ui, work, calibrating);
    draw_result_part(ui, calibrating);
    draw_about_part(ui, calibrating);
}

}  // namespace

void draw_calibrate(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                    PlayState& play, CalibrateState& calibrating) {
    if (!begin_dialog(ui, kCalibrateDialog, kDialogPx)) return;
    draw_parts(ui, work, timeline, play, calibrating);
    const ResponseAnswer* const answer = current_answer(calibrating);
    const bool is_ready = answer != nullptr && !answer->result.points.empty();
    const bool takes = draw_ends(ui, "Save and use", is_ready);
    if (takes) save_and_use_calibration(ui, work, timeline, rendered, play, calibrating);
    if (ui.dialog == kNoDialog && calibrating.is_playing) silence(timeline, play);
}

}  // namespace tact
