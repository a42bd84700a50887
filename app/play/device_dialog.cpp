// The dialog of devices: what there is, which one plays, and how.

#include <cstdio>

#include "app/play/calibrating.h"
#include "app/play/play_panels.h"
#include "app/play/playing.h"
#include "app/ui/dialog.h"
#include "app/ui/widgets.h"
#include "devices/device_list.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// "ALSA, 4 channels, 48000 Hz, 8.7 ms": what is known of it.
std::string facts_of(const DeviceInfo& device) {
    std::string text = device.interface;
    if (device.is_server) {
        text += ", a sound server: it may move what plays to another output when its own goes";
    } else if (!device.channels.empty()) {
        const std::size_t count = device.channels.size();
        text += ", " + std::to_string(count) + (count == 1 ? " channel" : " channels");
        if (device.rate_hz > 0.0) text += ", " + significant(device.rate_hz, 6) + " Hz";
    }
    if (device.latency_s > 0.0) text += ", " + significant(1e3 * device.latency_s, 2) + " ms";
    return text;
}

void draw_device_row(App& app, const DeviceInfo& device) {
    const Theme& theme = app.theme;
    const bool chosen = device.id == app.play.choice.id;
    ImGui::PushID(device.id.c_str());
    if (draw_radio(app, device.name.c_str(), chosen) && !chosen) {
        choose_device(app, remembered_choice(app, device.id));
    }
    note_item(app.rects, "choose:" + device.id, chosen ? "chosen" : "");
    ImGui::PopID();
    ImGui::Indent(18.0F * theme.scale);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(app, facts_of(device));
    const std::string trouble = chosen ? device_trouble(app) : device.trouble;
    if (!trouble.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme.warning);
        ImGui::TextUnformatted(trouble.c_str());
        ImGui::PopStyleColor();
        note_item(app.rects, "device trouble", trouble);
    }
    ImGui::PopTextWrapPos();
    ImGui::Unindent(18.0F * theme.scale);
}

void draw_list(App& app) {
    if (draw_radio(app, "Silent: the playhead moves, nothing is felt",
                   app.play.choice.id.empty())) {
        choose_device(app, {});
    }
    note_item(app.rects, "choose:silent");
    if (app.play.listed) {
        const auto listed = app.play.listed;
        for (const DeviceInfo& device : *listed) draw_device_row(app, device);
    }
    const bool is_missing = !app.play.choice.id.empty() && !chosen_device(app);
    const bool is_none = app.play.listed && app.play.listed->empty();
    if (!is_missing && !is_none) return;
    ImGui::PushTextWrapPos(0.0F);
    if (is_missing) ImGui::TextUnformatted(device_text(app).c_str());
    dim_text(app, device_trouble(app));
    ImGui::PopTextWrapPos();
    note_item(app.rects, "device advice", device_trouble(app));
}

// One of a few, by its name in a combo.
bool draw_combo(App& app, const char* label, const char* id, const std::vector<std::string>& names,
                int& chosen) {
    draw_label(app, label, 200.0F * app.theme.scale);
    ImGui::SetNextItemWidth(200.0F * app.theme.scale);
    const auto at = static_cast<std::size_t>(chosen);
    bool changed = false;
    if (ImGui::BeginCombo(id, at < names.size() ? names[at].c_str() : "")) {
        for (std::size_t k = 0; k < names.size(); ++k) {
            if (ImGui::Selectable(names[k].c_str(), k == at)) {
                chosen = static_cast<int>(k);
                changed = true;
            }
            note_item(app.rects, std::string("choose:") + (id + 2) + " " + names[k]);
        }
        ImGui::EndCombo();
    }
    note_item(app.rects, std::string("combo:") + (id + 2), at < names.size() ? names[at] : "");
    return changed;
}

void draw_channel(App& app, const DeviceInfo& device, DeviceChoice& choice) {
    if (device.channels.empty()) return;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < device.channels.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        const std::string& name = device.channels[k];
        names.push_back(name == number ? number : number + ", " + name);
    }
    int channel = choice.channel - 1;
    if (draw_combo(app, "Channel", "##channel", names, channel)) choice.channel = channel + 1;
    if (!device.is_server) return;
    constexpr int kCounts[] = {0, 1, 2, 4, 6, 8};
    const std::vector<std::string> counts{"2, or as many as needed", "1", "2", "4", "6", "8"};
    int at = 0;
    for (int k = 0; k < 6; ++k) at = kCounts[k] == choice.of_channels ? k : at;
    if (draw_combo(app, "Outputs", "##outputs", counts, at)) {
        choice.of_channels = kCounts[at];
    }
    draw_tooltip(app,
                 "Of the card behind the sound server, which mixes what does not match: with the "
                 "card's own number of outputs each channel stays by itself.");
}

constexpr Field kLatency{
    .id = "latency_offset_ms",
    .label = "Latency offset",
    .format = "%.0f ms",
    .slider = {-50.0, 200.0},
    .typed = {-1000.0, 1000.0},
    .step = 1.0,
    .snap = 1.0,
    .help = "Felt so much later than the device says: the playhead waits for it"};

constexpr Field kFullScale{
    .id = "full_scale_g",
    .label = "Full scale",
    .format = "%.2f g",
    .slider = {0.1, 10.0},
    .typed = {1e-3, 1e3},
    .step = 0.1,
    .snap = 0.1,
    .help =
        "The acceleration that full scale is taken for. The actuator may well do another: "
        "strengths within a set are in proportion, but uncalibrated."};

void draw_calibration_links(App& app) {
    if (can_be_calibrated(app)) {
        if (link(app, "calibrate", "Calibrate...")) app.dialog = Dialog::calibrate;
        note_item(app.rects, "link:calibrate");
        draw_tooltip(app, "With an accelerometer on the actuator: how many g it gives");
        ImGui::SameLine(0.0F, app.theme.padding_px);
    }
    if (link(app, "load calibration", "Load calibration...")) load_calibration_dialog(app);
    note_item(app.rects, "link:load calibration");
    draw_tooltip(app, "A file that an earlier calibration of this actuator has left");
}

// How drives get their strength: by a calibration, or by what full scale is taken for.
void draw_strength(App& app) {
    const std::string calibrated = calibration_text(app);
    if (!calibrated.empty()) {
        ImGui::PushTextWrapPos(0.0F);
        ImGui::TextUnformatted(calibrated.c_str());
        ImGui::PopTextWrapPos();
        note_item(app.rects, "calibrated", calibrated);
        dim_text(app, "at a level of 100 % patterns have the strength they say");
        if (link(app, "no calibration", "Use none")) use_calibration(app, {});
        note_item(app.rects, "link:no calibration");
        ImGui::SameLine(0.0F, app.theme.padding_px);
        draw_calibration_links(app);
        return;
    }
    draw_field(app, kFullScale, app.play.full_scale_g);
    ImGui::PushStyleColor(ImGuiCol_Text, app.theme.warning);
    ImGui::TextUnformatted("Uncalibrated");
    ImGui::PopStyleColor();
    note_item(app.rects, "uncalibrated");
    ImGui::SameLine(0.0F, app.theme.gap_px);
    dim_text(app, "what is felt in g is not known");
    ImGui::Checkbox("Protect the actuator", &app.play.is_protected);
    note_item(app.rects, "check:protect", app.play.is_protected ? "on" : "off");
    draw_tooltip(app,
                 "Leaves out what is slower than 16 Hz, fades both ends of a pattern in 5 ms and "
                 "stops after a minute on end. Without it an actuator may be harmed.");
    draw_calibration_links(app);
}

void draw_choice(App& app) {
    const std::optional<DeviceInfo> device = chosen_device(app);
    if (!device) return;
    ImGui::Separator();
    DeviceChoice choice = app.play.choice;
    draw_channel(app, *device, choice);
    double offset_ms = 1e3 * choice.latency_offset_s;
    if (draw_field(app, kLatency, offset_ms).changed) choice.latency_offset_s = 1e-3 * offset_ms;
    choose_device(app, choice);
    draw_strength(app);
    if (app.play.status.dropouts > 0) {
        ImGui::PushTextWrapPos(0.0F);
        const std::string gaps = significant(static_cast<double>(app.play.status.dropouts));
        dim_text(app, gaps + (gaps == "1" ? " gap" : " gaps") +
                          " since it was opened: the computer was too slow");
        ImGui::PopTextWrapPos();
    }
}

}  // namespace

void draw_devices(App& app) {
    if (!begin_dialog(app, "Devices")) return;
    ImGui::PushStyleColor(ImGuiCol_FrameBg, dialog_field(app.theme));
    ImGui::PushStyleColor(ImGuiCol_Button, dialog_field(app.theme));
    draw_list(app);
    draw_choice(app);
    ImGui::Spacing();
    ImGui::BeginDisabled(!can_sound(app));
    if (ImGui::Button("Test buzz")) play_test_buzz(app);
    note_item(app.rects, "button:test buzz");
    draw_tooltip(app, "150 Hz for 0.3 s, at the level of the bar");
    ImGui::EndDisabled();
    ImGui::SameLine(0.0F, app.theme.gap_px);
    if (ImGui::Button("Refresh")) refresh_devices(app);
    note_item(app.rects, "button:refresh");
    if (app.play.list_job && app.play.list_job->busy()) {
        ImGui::SameLine(0.0F, app.theme.gap_px);
        dim_text(app, "looking...");
    }
    ImGui::PopStyleColor(2);
    end_dialog(app);
}

}  // namespace tact
