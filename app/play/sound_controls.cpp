// The part of the transport bar about the device: its name, its level, and a light for clipping.

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "app/play/play.h"
#include "app/ui/widgets.h"
#include "devices/device/playback.h"
#include "devices/hid/hid_actuator.h"
#include "devices/hid/hid_port.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kDeviceWidthPx = 176.0F;
constexpr float kNarrowDeviceWidthPx = 64.0F;
constexpr float kLevelWidthPx = 176.0F;
constexpr float kMeterWidthPx = 64.0F;
constexpr float kLightPx = 10.0F;
constexpr double kQuietestDb = -48.0;

constexpr const char* kPlays = "What plays: at 1\u00d7 it is felt.";

bool is_device_chosen(const PlayState& play) { return !play.choice.id.empty(); }

// Share of the meter's width: its left end is -48 dB of full scale.
float meter_share(double of_full_scale) {
    if (of_full_scale <= 0.0) return 0.0F;
    const double db = 20.0 * std::log10(of_full_scale);
    return static_cast<float>(std::clamp(1.0 - db / kQuietestDb, 0.0, 1.0));
}

void draw_device_item(Ui& ui, Timeline& timeline, PlayState& play, const DeviceInfo& device) {
    const bool chosen = device.id == play.choice.id;
    const Item item{
        .id = "device:" + device.id, .label = device.name, .value = chosen ? "chosen" : ""};
    if (menu_item(ui, item, device.interface.c_str(), chosen)) {
        choose_device(ui, timeline, play, remembered_choice(play, device.id));
    }
}

void draw_device_menu(Ui& ui, Timeline& timeline, PlayState& play) {
    // Without covering the button that opens it.
    ImGui::SetNextWindowPos(
        {ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + 0.5F * ui.theme.gap_px},
        ImGuiCond_Appearing);
    if (!ImGui::BeginPopup("device menu")) return;
    const std::string trouble = device_trouble(play);
    if (!trouble.empty()) {
        ImGui::PushTextWrapPos(320.0F * ui.theme.scale);
        dim_text(ui, {.id = "device advice", .text = trouble});
        ImGui::PopTextWrapPos();
        draw_divider(ui.theme);
    }
    const Item silent{.id = "device:silent", .label = "No device"};
    if (menu_item(ui, silent, nullptr, !is_device_chosen(play)))
        choose_device(ui, timeline, play, {});
    const auto listed = play.listed;  // a copy: choosing may change it
    for (std::size_t k = 0; listed && k < listed->size(); ++k)
        draw_device_item(ui, timeline, play, (*listed)[k]);
    draw_divider(ui.theme);
    if (const std::string fault = hid_fault(); !fault.empty()) {
        ImGui::PushTextWrapPos(320.0F * ui.theme.scale);
        dim_text(ui, {.id = "device:no controllers", .text = fault});
        ImGui::PopTextWrapPos();
        draw_divider(ui.theme);
    }
    if (const auto ask = controller_request()) {
        if (menu_item(ui, {.id = "device:connect", .label = "Connect a controller..."})) ask();
    }
    if (menu_item(ui, {.id = "device:refresh", .label = "Refresh devices"}))
        refresh_devices(ui, play);
    if (menu_item(ui, {.id = "device:dialog", .label = "Devices..."})) ui.dialog = kDevicesDialog;
    ImGui::EndPopup();
}

float device_width(const Ui& ui, bool wide) {
    return (wide ? kDeviceWidthPx : kNarrowDeviceWidthPx) * ui.theme.scale;
}

// What plays, in one word, for a bar that has no room for a name.
const char* device_word(const PlayState& play) {
    if (!is_device_chosen(play)) return "None";
    if (play.for_ear) return "By ear";
    const std::optional<DeviceInfo> info = chosen_device(play);
    if (!info) return "Gone";
    switch (info->kind) {
        case DeviceKind::audio:
            return "Sound";
        case DeviceKind::hid:
            return "Pad";
        case DeviceKind::phone:
            return "Phone";
    }
    return "";
}

void draw_device_button(Ui& ui, Timeline& timeline, PlayState& play, bool wide) {
    const Theme& theme = ui.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{device_width(ui, wide), ImGui::GetFrameHeight()};
    const std::string text = device_text(play);
    const std::string trouble = device_trouble(play);
    const Item item{.id = "device",
                    .label = "",
                    .tip = text + ". " + (trouble.empty() ? kPlays : trouble),
                    .value = text};
    if (button(ui, item, size)) ImGui::OpenPopup("device menu");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 pad = ImGui::GetStyle().FramePadding;
    const bool is_lost = is_device_chosen(play) && !trouble.empty();
    const ImU32 ink = is_lost                  ? theme.warning
                      : is_device_chosen(play) ? theme.text
                                               : theme.dim_text;
    // Looks and stands like a combo of ImGui; a word alone is as wide as the button.
    if (wide) {
        ImGui::RenderArrow(&list, {corner.x + size.x - size.y + pad.y, corner.y + pad.y},
                           theme.text, ImGuiDir_Down);
    }
    const float room = size.x - 2.0F * pad.x - (wide ? size.y - pad.x : 0.0F);
    draw_text(list, theme.fonts.regular, corner + pad, ink,
              shortened(theme.fonts.regular, wide ? text : device_word(play), room));
    draw_device_menu(ui, timeline, play);
}

void draw_level(Ui& ui, PlayState& play) {
    const Field field{.id = "level_percent",
                      .label = "Level",
                      .format = "%.3g %%",
                      .slider = {0.0, 100.0},
                      .typed = {0.0, 100.0},
                      .step = 1.0,
                      .snap = 1.0,
                      .help =
                          "How strong everything is felt, also while it plays. Every "
                          "start begins at 10 %: strengths are uncalibrated.",
                      .normal = 100.0 * PlayState{}.level};
    double percent = 100.0 * play.level;
    const float width = kLevelWidthPx * ui.theme.scale;
    if (draw_short_field(ui, field, width, percent).changed) play.level = 0.01 * percent;
    note_item(ui.rects, "level", std::to_string(play.level));
}

void draw_meter(Ui& ui, const PlayState& play) {
    const Theme& theme = ui.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{kMeterWidthPx * theme.scale, ImGui::GetFrameHeight()};
    ImGui::InvisibleButton("##meter", size);
    say_of_last_item(
        ui, {.id = "meter",
             .text = std::to_string(play.meter),
             .tip = "What the device is given, from -48 dB to full scale; the line is the limit"});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y1 = corner.y + size.y * 0.38F;
    const float y2 = corner.y + size.y * 0.62F;
    list.AddRectFilled({corner.x, y1}, {corner.x + size.x, y2}, theme.field, 2.0F * theme.scale);
    const float lit = size.x * meter_share(play.meter);
    if (lit > 0.0F) {
        list.AddRectFilled({corner.x, y1}, {corner.x + lit, y2}, theme.series, 2.0F * theme.scale);
    }
    const float limit = corner.x + size.x * meter_share(kCeiling);
    list.AddLine({limit, y1 - 2.0F * theme.scale}, {limit, y2 + 2.0F * theme.scale}, theme.dim_text,
                 theme.hairline_px);
}

void draw_clip_light(Ui& ui, PlayState& play) {
    const Theme& theme = ui.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{2.0F * kLightPx * theme.scale, ImGui::GetFrameHeight()};
    if (ImGui::InvisibleButton("##clip", size)) play.clip_light = false;
    say_of_last_item(
        ui, {.id = "clip",
             .text = play.clip_light ? "on" : "off",
             .tip = play.clip_light
                        ? "Too strong for full scale: the whole pattern was turned down, its "
                          "shape is kept. Lower the level; a click puts the light out."
                        : "Lights up where a pattern had to be turned down"});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 centre = corner + size * 0.5F;
    const float radius = 0.45F * kLightPx * theme.scale;
    if (play.clip_light) {
        list.AddCircleFilled(centre, radius, theme.error);
    } else {
        list.AddCircle(centre, radius, theme.line, 0, theme.trace_px);
    }
}

}  // namespace

float sound_controls_width(const Ui& ui, const PlayState& play, SoundParts parts) {
    float width = device_width(ui, parts.wide);
    if (!is_device_chosen(play)) return width;
    width += kLevelWidthPx * ui.theme.scale + ui.theme.gap_px;
    if (parts.meter) {
        width += (kMeterWidthPx + 2.0F * kLightPx) * ui.theme.scale + 1.5F * ui.theme.gap_px;
    }
    return width;
}

void draw_sound_controls(Ui& ui, Timeline& timeline, PlayState& play, SoundParts parts) {
    draw_device_button(ui, timeline, play, parts.wide);
    if (!is_device_chosen(play)) return;
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    draw_level(ui, play);
    if (!parts.meter) return;
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    draw_meter(ui, play);
    ImGui::SameLine(0.0F, 0.5F * ui.theme.gap_px);
    draw_clip_light(ui, play);
}

}  // namespace tact
