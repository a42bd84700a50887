// The dialog of devices: a list, the chosen one, and its settings.

#include "app/play/play.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "devices/device_list.h"
#include "devices/hid/hid_actuator.h"
#include "devices/hid/hid_port.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// The facts about a device: "ALSA, 4 channels, 48000 Hz, 8.7 ms".
std::string facts_of(const DeviceInfo& device) {
    std::string text = device.interface;
    if (!device.server_output.empty()) text += ", on \"" + device.output_name + "\"";
    if (device.is_server && device.server_output.empty()) {
        text += ", a sound server that does not say which output it plays on";
    } else if (!device.channels.empty()) {
        const std::size_t count = device.channels.size();
        text += ", " + std::to_string(count) + (count == 1 ? " channel" : " channels");
        if (device.rate_hz > 0.0) text += ", " + significant(device.rate_hz, 6) + " Hz";
    }
    if (device.latency_s > 0.0) text += ", " + significant(1e3 * device.latency_s, 2) + " ms";
    return text;
}

void draw_device_row(Ui& ui, Timeline& timeline, PlayState& play, const DeviceInfo& device) {
    const Theme& theme = ui.theme;
    const bool chosen = device.id == play.choice.id;
    ImGui::PushID(device.id.c_str());
    const Item item{
        .id = "choose:" + device.id, .label = device.name, .value = chosen ? "chosen" : ""};
    if (radio(ui, item, chosen) && !chosen) {
        choose_device(ui, timeline, play, remembered_choice(play, device.id));
    }
    ImGui::PopID();
    ImGui::Indent(18.0F * theme.scale);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, facts_of(device));
    const std::string trouble = chosen ? device_trouble(play) : device.trouble;
    if (!trouble.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, theme.warning);
        plain_text(ui, {.id = "device trouble", .text = trouble});
        ImGui::PopStyleColor();
    }
    ImGui::PopTextWrapPos();
    ImGui::Unindent(18.0F * theme.scale);
}

void draw_list(Ui& ui, Timeline& timeline, PlayState& play) {
    const Item silent{.id = "choose:silent",
                      .label = "No device: the playhead moves, nothing is felt"};
    if (radio(ui, silent, play.choice.id.empty())) choose_device(ui, timeline, play, {});
    if (play.listed) {
        const auto listed = play.listed;
        for (const DeviceInfo& device : *listed) draw_device_row(ui, timeline, play, device);
    }
    const bool is_missing = !play.choice.id.empty() && !chosen_device(play);
    const bool is_none = play.listed && play.listed->empty();
    const bool has_cards_fault = play.choice.id.empty() && !play.cards_fault.empty();
    if (const std::string fault = hid_fault(); !fault.empty()) {
        ImGui::PushTextWrapPos(0.0F);
        dim_text(ui, fault);
        ImGui::PopTextWrapPos();
    }
    if (!is_missing && !is_none && !has_cards_fault) return;
    ImGui::PushTextWrapPos(0.0F);
    if (is_missing) ImGui::TextUnformatted(shown_text(device_text(play)).c_str());
    dim_text(ui, {.id = "device advice", .text = device_trouble(play)});
    ImGui::PopTextWrapPos();
}

// A row whose label and id it is: one of a few names.
bool draw_names(Ui& ui, const Item& row, const std::vector<std::string>& names, int& chosen) {
    draw_label(ui, row.label.c_str(), 200.0F * ui.theme.scale);
    const auto at = static_cast<std::size_t>(chosen);
    bool changed = false;
    drop_down(
        ui, {.id = "combo:" + row.id, .label = at < names.size() ? names[at] : "", .tip = row.tip},
        200.0F * ui.theme.scale,
        [&] {
            for (std::size_t k = 0; k < names.size(); ++k) {
                const Item item{.id = "choose:" + row.id + " " + names[k], .label = names[k]};
                if (!option(ui, item, k == at)) continue;
                chosen = static_cast<int>(k);
                changed = true;
            }
        },
        ImGuiComboFlags_HeightRegular);
    return changed;
}

void draw_channel(Ui& ui, const DeviceInfo& device, DeviceChoice& choice) {
    if (device.channels.empty()) return;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < device.channels.size(); ++k) {
        const std::string number = std::to_string(k + 1);
        const std::string& name = device.channels[k];
        names.push_back(name == number ? number : number + ", " + name);
    }
    int channel = choice.channel - 1;
    if (draw_names(ui, {.id = "channel", .label = "Channel"}, names, channel)) {
        choice.channel = channel + 1;
    }
    if (!device.is_server || !device.server_output.empty()) return;
    constexpr int kCounts[] = {0, 1, 2, 4, 6, 8};
    const std::vector<std::string> counts{"2, or as many as needed", "1", "2", "4", "6", "8"};
    int at = 0;
    for (int k = 0; k < 6; ++k) at = kCounts[k] == choice.of_channels ? k : at;
    const Item outputs{
        .id = "outputs",
        .label = "Outputs",
        .tip =
            "Outputs of the card behind the sound server, which mixes what does not match: with "
            "the card's own number of outputs each channel stays by itself."};
    if (draw_names(ui, outputs, counts, at)) choice.of_channels = kCounts[at];
}

constexpr Field kLatency{
    .id = "latency_offset_ms",
    .label = "Latency offset",
    .format = "%.0f ms",
    .slider = {-50.0, 200.0},
    .typed = {-1000.0, 1000.0},
    .step = 1.0,
    .snap = 1.0,
    .help = "Felt so much later than the device says: the playhead waits for it",
    .normal = 0.0};

constexpr Field kWholeBuffer{
    .id = "whole_buffer_ms",
    .label = "Buffer in studies",
    .format = "%.0f ms",
    .slider = {50.0, 500.0},
    .typed = {20.0, 2000.0},
    .step = 10.0,
    .snap = 10.0,
    .help =
        "Sound rendered ahead in studies and calibrations, where no play may have gaps: more "
        "where plays are cut short, and each begins that much later",
    .normal = 1e3 * kBufferS};

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

void draw_calibration_links(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                            PlayState& play) {
    if (can_be_calibrated(play)) {
        if (link(ui, {.id = "link:calibrate",
                      .label = "Calibrate...",
                      .tip = "With an accelerometer on the actuator: how many g it gives"})) {
            ui.dialog = kCalibrateDialog;
        }
        ImGui::SameLine(0.0F, ui.theme.padding_px);
    }
    if (link(ui, {.id = "link:load calibration",
                  .label = "Load calibration...",
                  .tip = "A file that an earlier calibration of this actuator has left"})) {
        load_calibration_dialog(ui, work, timeline, rendered, play);
    }
}

// The strength of drives: from a calibration, or from the full scale in g.
void draw_strength(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                   PlayState& play) {
    const std::string calibrated = calibration_text(play);
    if (!calibrated.empty()) {
        ImGui::PushTextWrapPos(0.0F);
        plain_text(ui, {.id = "calibrated", .text = calibrated});
        ImGui::PopTextWrapPos();
        dim_text(ui, "at a level of 100 % patterns have the strength they say");
        if (link(ui, {.id = "link:no calibration", .label = "Use none"}))
            use_calibration(ui, work, timeline, rendered, play, {});
        ImGui::SameLine(0.0F, ui.theme.padding_px);
        draw_calibration_links(ui, work, timeline, rendered, play);
        return;
    }
    Field full_scale = kFullScale;
    full_scale.normal = PlayState{}.full_scale_g;
    if (draw_field(ui, full_scale, play.full_scale_g).changed) begin_softly(play);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.warning);
    plain_text(ui, {.id = "uncalibrated", .text = "Uncalibrated"});
    ImGui::PopStyleColor();
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    dim_text(ui, "what is felt in g is not known");
    const Item protect{
        .id = "check:protect",
        .label = "Protect the actuator",
        .tip =
            "Leaves out what is slower than 16 Hz, fades both ends of a pattern in 5 ms and "
            "stops after a minute on end. Without it an actuator may be harmed."};
    if (check(ui, protect, play.is_protected)) begin_softly(play);
    draw_calibration_links(ui, work, timeline, rendered, play);
}

void draw_choice(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                 PlayState& play) {
    const std::optional<DeviceInfo> device = chosen_device(play);
    if (!device) return;
    draw_divider(ui.theme);
    DeviceChoice choice = play.choice;
    draw_channel(ui, *device, choice);
    double offset_ms = 1e3 * choice.latency_offset_s;
    if (draw_field(ui, kLatency, offset_ms).changed) choice.latency_offset_s = 1e-3 * offset_ms;
    choose_device(ui, timeline, play, choice);
    if (device->is_server || !device->channels.empty()) {
        double buffer_ms = 1e3 * play.whole_buffer_s;
        if (draw_field(ui, kWholeBuffer, buffer_ms).changed) play.whole_buffer_s = 1e-3 * buffer_ms;
    }
    draw_strength(ui, work, timeline, rendered, play);
    if (play.status.dropouts > 0) {
        ImGui::PushTextWrapPos(0.0F);
        const std::string gaps = significant(static_cast<double>(play.status.dropouts));
        dim_text(ui, gaps + (gaps == "1" ? " gap" : " gaps") +
                         " since it was opened: the computer was too slow");
        ImGui::PopTextWrapPos();
    }
}

}  // namespace

void draw_devices(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                  PlayState& play) {
    if (!begin_dialog(ui, kDevicesDialog)) return;
    draw_list(ui, timeline, play);
    draw_choice(ui, work, timeline, rendered, play);
    ImGui::Spacing();
    if (button(ui, {.id = "button:test buzz",
                    .label = "Test buzz",
                    .tip = "150 Hz for 0.3 s, at the playback level",
                    .enabled = can_sound(play)})) {
        play_test_buzz(ui, timeline, play);
    }
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    if (button(ui, {.id = "button:refresh", .label = "Refresh"})) refresh_devices(ui, play);
    if (const auto ask = controller_request()) {
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        if (button(ui, {.id = "button:connect",
                        .label = "Connect a controller...",
                        .tip = "The browser asks which one this page may use"})) {
            ask();
        }
    }
    if (play.list_job.busy()) {
        ImGui::SameLine(0.0F, ui.theme.gap_px);
        dim_text(ui, "looking...");
    }
    end_dialog(ui);
}

}  // namespace tact
