#include "app/ui/recording_fields.h"

#include <imgui.h>

#include <array>
#include <optional>
#include <string>

#include "app/ui/number_field.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kNumberPx = 90.0F;

bool draw_unit(App& app, AccelerationOptions& options) {
    bool changed = false;
    draw_chips_label(app, "Unit");
    const auto choice = [&](const char* id, const char* text,
                            std::optional<AccelerationUnit> unit) {
        if (draw_chip(app, id, text, options.unit == unit) && options.unit != unit) {
            options.unit = unit;
            changed = true;
        }
        note_item(app.rects, std::string("import:unit ") + id);
        ImGui::SameLine(0.0F, 2.0F * app.theme.scale);
    };
    choice("file", "as the file says", std::nullopt);
    choice("g", "g", AccelerationUnit::g);
    choice("m/s2", "m/s\u00b2", AccelerationUnit::m_per_s2);
    choice("V", "V", AccelerationUnit::volt);
    ImGui::NewLine();
    if (options.unit == AccelerationUnit::volt) {
        changed |=
            draw_number_entry(app, "import:sensitivity", "Sensitivity", options.sensitivity_v_per_g,
                              limits::kSensitivityVPerG, "V/g, of the sensor");
        changed |= draw_number_entry(app, "import:offset", "Offset", options.offset_v,
                                     limits::kOffsetV, "V, of the sensor at 0 g");
    }
    return changed;
}

bool draw_axis(App& app, AccelerationOptions& options) {
    bool changed = false;
    draw_chips_label(app, "Axis");
    constexpr std::array<const char*, 4> kNames{"all as one", "1", "2", "3"};
    for (std::size_t axis = 0; axis < kNames.size(); ++axis) {
        if (draw_chip(app, kNames[axis], kNames[axis], options.axis == axis) &&
            options.axis != axis) {
            options.axis = axis;
            changed = true;
        }
        if (axis == 0) {
            draw_tooltip(app,
                         "Three axes are made one of the same energy (DFT321): the skin "
                         "hardly tells directions of vibration apart.");
        }
        ImGui::SameLine(0.0F, 2.0F * app.theme.scale);
    }
    ImGui::NewLine();
    return changed;
}

}  // namespace

AccelerationOptions options_of(const RecordingFields& fields) {
    AccelerationOptions options = fields.options;
    if (fields.rate_hz > 0.0) options.rate_hz = fields.rate_hz;
    if (fields.full_scale > 0.0) options.full_scale = fields.full_scale;
    return options;
}

bool draw_recording_fields(App& app, RecordingFields& fields, bool has_wave) {
    bool changed = draw_unit(app, fields.options);
    changed |= draw_axis(app, fields.options);
    changed |= draw_number_entry(app, "import:rate", "Rate", fields.rate_hz, {0.0, 1e7},
                                 "Hz; 0: from the time column");
    if (has_wave) {
        changed |= draw_number_entry(app, "import:full scale", "Full scale", fields.full_scale,
                                     {0.0, limits::kScaleG.high},
                                     "of .wav files, in the unit; 0: as their sidecar says");
    }
    return changed;
}

void draw_chips_label(App& app, const char* label) {
    draw_label(app, label);
    const float chip = text_size(app.theme.fonts.small, label).y + 6.0F * app.theme.scale;
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.5F * (ImGui::GetFrameHeight() - chip));
}

bool draw_number_entry(App& app, const char* id, const char* label, double& value, Range range,
                       const char* unit) {
    draw_label(app, label);
    const bool entered = enter_number(app,
                                      {.id = id,
                                       .label = label,
                                       .format = "%.6g",
                                       .rules = {range, leading_unit(unit)},
                                       .width_px = kNumberPx * app.theme.scale},
                                      value);
    note_item(app.rects, id, shortest_digits(value));
    ImGui::SameLine();
    dim_text(app, unit);
    return entered;
}

}  // namespace tact
