#include "app/measured/measured.h"

#include <imgui.h>

#include <array>
#include <optional>
#include <string>

#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kNumberPx = 90.0F;

bool draw_unit(Ui& ui, AccelerationOptions& options) {
    bool changed = false;
    draw_label(ui, "Unit");
    const auto choice = [&](const char* id, const char* text,
                            std::optional<AccelerationUnit> unit) {
        const bool chosen = options.unit == unit;
        const Item item{.id = std::string("import:unit ") + id, .label = text};
        if (toggle(ui, item, chosen) && !chosen) {
            options.unit = unit;
            changed = true;
        }
        ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    };
    choice("file", "as the file says", std::nullopt);
    choice("g", "g", AccelerationUnit::g);
    choice("m/s2", "m/s\u00b2", AccelerationUnit::m_per_s2);
    choice("V", "V", AccelerationUnit::volt);
    ImGui::NewLine();
    // A file with voltages as numbers needs the volts, too.
    if (options.unit.value_or(AccelerationUnit::volt) == AccelerationUnit::volt) {
        const bool is_known = options.unit.has_value();
        const AccelerationOptions normal;
        changed |=
            draw_number_row(ui,
                            {"import:sensitivity", "Sensitivity", normal.sensitivity_v_per_g,
                             limits::kSensitivityVPerG,
                             is_known ? "V/g, of the sensor"
                                      : "V/g, of the sensor: needed where the file is in volts"},
                            options.sensitivity_v_per_g);
        changed |= draw_number_row(ui,
                                   {"import:offset", "Offset", normal.offset_v, limits::kOffsetV,
                                    "V, of the sensor at 0 g"},
                                   options.offset_v);
    }
    return changed;
}

bool draw_axis(Ui& ui, AccelerationOptions& options) {
    bool changed = false;
    draw_label(ui, "Axis");
    constexpr std::array<const char*, 4> kNames{"all as one", "1", "2", "3"};
    for (std::size_t axis = 0; axis < kNames.size(); ++axis) {
        const bool chosen = options.axis == axis;
        const Item item{.id = std::string("import:axis ") + kNames[axis],
                        .label = kNames[axis],
                        .tip = axis > 0 ? ""
                                        : "Three axes are made one of the same energy (DFT321): "
                                          "the skin hardly tells directions of vibration apart.",
                        .value = chosen ? "chosen" : ""};
        if (toggle(ui, item, chosen) && !chosen) {
            options.axis = axis;
            changed = true;
        }
        ImGui::SameLine(0.0F, 2.0F * ui.theme.scale);
    }
    ImGui::NewLine();
    return changed;
}

}  // namespace

AccelerationOptions options_of(const RecordingFields& fields) {
    AccelerationOptions options = fields.options;
    const bool has_sensor = options.unit.value_or(AccelerationUnit::volt) == AccelerationUnit::volt;
    if (!has_sensor) options.sensitivity_v_per_g = options.offset_v = 0.0;  // not shown
    if (fields.rate_hz > 0.0) options.rate_hz = fields.rate_hz;
    if (fields.full_scale > 0.0) options.full_scale = fields.full_scale;
    return options;
}

bool draw_recording_fields(Ui& ui, RecordingFields& fields, bool has_wave) {
    bool changed = draw_unit(ui, fields.options);
    changed |= draw_axis(ui, fields.options);
    changed |=
        draw_number_row(ui, {"import:rate", "Rate", 0.0, {0.0, 1e7}, "Hz; 0: from the time column"},
                        fields.rate_hz);
    if (has_wave) {
        changed |= draw_number_row(ui,
                                   {"import:full scale",
                                    "Full scale",
                                    0.0,
                                    {0.0, limits::kScaleG.high},
                                    "of .wav files, in the unit; 0: as their sidecar says"},
                                   fields.full_scale);
    }
    return changed;
}

bool draw_number_row(Ui& ui, const NumberRow& row, double& value) {
    draw_label(ui, row.label);
    const bool reset = reset_by_label(ui, row.normal, value);
    const bool entered = enter_number(ui,
                                      {.id = row.id,
                                       .label = row.label,
                                       .format = "%.6g",
                                       .rules = {row.range, leading_unit(row.unit)},
                                       .width_px = kNumberPx * ui.theme.scale},
                                      value);
    note_item(ui.rects, row.id, shortest_digits(value));
    ImGui::SameLine();
    dim_text(ui, row.unit);
    return reset || entered;
}

}  // namespace tact
