// The dialog that measures an actuator: what to play, what was recorded, how many g that makes at
// each frequency, and what the table is to say of itself.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "app/calibrate/calibrate_dialog.h"
#include "app/calibrate/calibrate_state.h"
#include "app/calibrate/measuring_response.h"
#include "app/play/playing.h"
#include "app/ui/dialog.h"
#include "app/ui/widgets.h"
#include "viz/charts/response_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kDialogPx = 620.0F;
constexpr float kPlotPx = 150.0F;
constexpr Range kToneRangeHz{1.0, 2000.0};

void wrapped_dim(const App& app, const std::string& text) {
    ImGui::PushTextWrapPos(0.0F);
    dim_text(app, text);
    ImGui::PopTextWrapPos();
}

void heading(const App& app, const char* text) {
    ImGui::Spacing();
    ImGui::PushFont(app.theme.fonts.semibold);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
}

std::string percent(double share) { return significant(100.0 * share, 2) + " %"; }

double signal_s(const CalibrationParams& params) {
    const Drive drive = calibration_plan(params).drive;
    return static_cast<double>(drive.samples.size()) / drive.rate_hz;
}

void draw_kind(App& app, bool& changed) {
    CalibrationParams& params = app.calibrate->params;
    draw_chips_label(app, "Signal");
    const auto choice = [&](const char* id, const char* text, bool sweep, const char* tip) {
        if (draw_chip(app, id, text, params.is_sweep == sweep) && params.is_sweep != sweep) {
            params.is_sweep = sweep;
            changed = true;
        }
        note_item(app.rects, std::string("calibrate:") + id);
        draw_tooltip(app, tip);
        ImGui::SameLine(0.0F, 2.0F * app.theme.scale);
    };
    choice("tones", "stepped tones", false,
           "A tone at each sixth of an octave and at three levels: tells distortion, and whether "
           "twice the drive is twice the g");
    choice("sweep", "sweep", true, "One sine that rises: shorter, and at one level only");
    ImGui::NewLine();
    changed |= draw_number_entry(app, "calibrate:low", "From", params.low_hz, kToneRangeHz, "Hz");
    changed |= draw_number_entry(app, "calibrate:high", "To", params.high_hz, kToneRangeHz, "Hz");
    params.high_hz = std::max(params.high_hz, params.low_hz);
}

void draw_playing(App& app) {
    const double whole_s = signal_s(app.calibrate->params);
    const double at_s = std::clamp(app.play.status.position_s, 0.0, whole_s);
    const std::string text = significant(at_s, 2) + " s of " + significant(whole_s, 2) + " s";
    if (ImGui::Button("Stop")) silence(app);
    note_item(app.rects, "button:stop signal");
    ImGui::SameLine(0.0F, app.theme.gap_px);
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, app.theme.accent);
    ImGui::ProgressBar(whole_s > 0.0 ? static_cast<float>(at_s / whole_s) : 0.0F,
                       {220.0F * app.theme.scale, 0.0F}, text.c_str());
    ImGui::PopStyleColor();
    note_item(app.rects, "calibrate:playing", text);
}

void draw_signal_part(App& app) {
    CalibrateState& state = *app.calibrate;
    heading(app, "1  Play the signal while the sensor records");
    bool changed = false;
    ImGui::BeginDisabled(state.is_playing);
    draw_kind(app, changed);
    ImGui::EndDisabled();
    if (changed) look_at_recording(app);
    const std::string most = percent(state.params.levels.back());
    wrapped_dim(app, significant(signal_s(state.params), 3) + " s on " + device_text(app) +
                         ", up to " + most +
                         " of full scale whatever the level of the bar. Begin " +
                         "recording before it, and end after it.");
    if (state.is_playing) return draw_playing(app);
    ImGui::BeginDisabled(!can_sound(app));
    if (ImGui::Button("Play the signal")) play_calibration_signal(app);
    ImGui::EndDisabled();
    note_item(app.rects, "button:play signal");
    ImGui::SameLine(0.0F, app.theme.gap_px);
    if (ImGui::Button("Save as WAV...")) save_calibration_signal_dialog(app);
    note_item(app.rects, "button:save signal");
    draw_tooltip(app, "To play it by other means, at full level");
}

void draw_recording_part(App& app) {
    CalibrateState& state = *app.calibrate;
    heading(app, "2  Open what it recorded");
    if (ImGui::Button("Open recording...")) open_calibration_recording_dialog(app);
    note_item(app.rects, "button:open recording");
    draw_tooltip(app, "A table (.csv, .txt) or .wav of one or three axes");
    if (state.recording.empty()) return;
    ImGui::SameLine(0.0F, app.theme.gap_px);
    const float room = ImGui::GetContentRegionAvail().x;
    const std::string name = state.recording.filename().string();
    dim_text(app, shortened(app.theme.fonts.regular, name, room));
    note_item(app.rects, "calibrate:recording", name);
    const bool is_wave = extension_of(state.recording) == ".wav";
    if (draw_recording_fields(app, state.fields, is_wave)) look_at_recording(app);
}

std::string point_text(const ResponsePoint& point) {
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

void draw_response_plot(App& app, const CalibrationResult& result) {
    std::vector<ResponseMark> table;
    std::vector<ResponseMark> refused;
    for (const ResponsePoint& point : result.points) {
        table.push_back({point.frequency_hz, point.g_per_full_scale});
    }
    for (const MeasuredTone& tone : result.tones) {
        if (tone.accepted || tone.tone.level <= 0.0) continue;
        refused.push_back({tone.tone.frequency_hz, tone.amplitude_g / tone.tone.level});
    }
    const ImVec2 size{ImGui::GetContentRegionAvail().x, kPlotPx * app.theme.scale};
    const Rect area = rect_at(ImGui::GetCursorScreenPos(), size);
    const ResponseAction action = draw_response("response", app.theme, area, {table, refused});
    note_rect(app.rects, "calibrate:response", area.min, area.max,
              std::to_string(result.points.size()));
    const std::string text =
        action.hovered ? point_text(result.points[*action.hovered]) : summary_of(result);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    note_item(app.rects, "calibrate:summary", text);
    if (refused.empty()) return;
    wrapped_dim(app,
                "Left out, drawn as rings: 10 % of distortion or more, or less than 20 dB above "
                "the noise.");
}

void draw_result_part(App& app) {
    const CalibrateState& state = *app.calibrate;
    heading(app, "3  g at full scale");
    const ResponseAnswer* const answer = current_answer(state);
    if (answer != nullptr && answer->fault.empty()) {
        draw_response_plot(app, answer->result);
        for (const std::string& remark : answer->remarks) wrapped_dim(app, "It was " + remark);
        return;
    }
    const ImVec2 size{ImGui::GetContentRegionAvail().x, kPlotPx * app.theme.scale};
    const Rect area = rect_at(ImGui::GetCursorScreenPos(), size);
    ImGui::Dummy(size);
    const bool waits = state.recording.empty();
    const bool failed = answer != nullptr;
    draw_empty(*ImGui::GetWindowDrawList(), app.theme, area,
               waits    ? "No recording yet"
               : failed ? "Cannot be used"
                        : "Measuring",
               waits    ? "The response will stand here."
               : failed ? answer->fault
                        : "The recording is compared with the signal.");
    note_rect(app.rects, "calibrate:waits", area.min, area.max, failed ? answer->fault : "");
}

void draw_words(App& app, const char* id, const char* label, const char* hint, std::string& text) {
    draw_label(app, label);
    ImGui::SetNextItemWidth(-1.0F);
    ImGui::InputTextWithHint((std::string("##") + id).c_str(), hint, &text);
    note_item(app.rects, id, text);
}

void draw_about_part(App& app) {
    Calibration& about = app.calibrate->about;
    heading(app, "4  What it was, for the file");
    draw_words(app, "calibrate:actuator", "Actuator", "its name", about.actuator);
    draw_words(app, "calibrate:mounting", "Mounting", "how it was held or fixed", about.mounting);
    draw_words(app, "calibrate:gain", "Gain", "of amplifier and mixer: another makes it invalid",
               about.gain_note);
    draw_words(app, "calibrate:sensor", "Sensor", "what it was recorded with", about.sensor);
    draw_number_entry(app, "calibrate:mass", "Moved mass", about.load_mass_g, {0.0, 1e5}, "g");
    draw_number_entry(app, "calibrate:excursion", "Travel", about.excursion_limit_mm, {0.0, 100.0},
                      "mm to either side at most; 0: not known");
    draw_number_entry(app, "calibrate:rms", "Heat", about.rms_limit, {0.0, 1.0},
                      "of full scale, rms over a second at most; 0: not known");
}

// They scroll where the screen is too low for them: the buttons below stay in sight.
void draw_parts(App& app) {
    float& content_px = app.calibrate->content_px;
    const float most = 0.9F * ImGui::GetIO().DisplaySize.y - 4.0F * ImGui::GetFrameHeight();
    const float height = content_px > 0.0F ? std::min(content_px, most) : most;
    ImGui::BeginChild("parts", {0.0F, height});
    wrapped_dim(app, "How many g the actuator on " + device_text(app) +
                         " gives at each frequency, by an accelerometer fixed to it");
    draw_signal_part(app);
    draw_recording_part(app);
    draw_result_part(app);
    draw_about_part(app);
    content_px = ImGui::GetCursorPosY();
    ImGui::EndChild();
}

}  // namespace

void draw_calibrate(App& app) {
    if (!begin_dialog(app, "Calibrate", kDialogPx)) return;
    ImGui::PushStyleColor(ImGuiCol_FrameBg, dialog_field(app.theme));
    ImGui::PushStyleColor(ImGuiCol_Button, dialog_field(app.theme));
    draw_parts(app);
    const ResponseAnswer* const answer = current_answer(*app.calibrate);
    const bool is_ready = answer != nullptr && !answer->result.points.empty();
    ImGui::PopStyleColor(2);
    const bool takes = draw_ends(app, "Save and use", is_ready);
    if (takes) save_and_use_calibration(app);
    if (app.dialog == Dialog::none && app.calibrate->is_playing) silence(app);
}

}  // namespace tact
