// Rows of a number: its label, slider and typed entry.

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "app/ui/parts.h"
#include "app/ui/widgets.h"
#include "model/text/numbers.h"
#include "viz/drawing/imgui_versions.h"

namespace tact {

namespace {

constexpr float kLabelColumnPx = 84.0F;
constexpr float kEntryWidthPx = 86.0F;
constexpr float kShortEntryPx = 52.0F;
constexpr float kLeastBarPx = 80.0F;

float share_of(const Field& field, double value) {
    const auto [low, high] = field.slider;
    if (field.logarithmic) {
        return static_cast<float>(std::log(std::max(value, low) / low) / std::log(high / low));
    }
    return static_cast<float>((value - low) / (high - low));
}

// Fills the part of the slider up to its value; if several values differ, the part between the
// smallest and the largest.
void draw_fill(const Ui& ui, const Field& field, double value) {
    const ImVec2 min = ImGui::GetItemRectMin();
    const ImVec2 max = ImGui::GetItemRectMax();
    const auto x = [&](double of) {
        return min.x + (max.x - min.x) * std::clamp(share_of(field, of), 0.0F, 1.0F);
    };
    const float from = field.mixed ? x(field.mixed->low) : min.x;
    const float to = field.mixed ? x(field.mixed->high) : x(value);
    const ImU32 fill = (ui.theme.accent & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 90);
    ImGui::GetWindowDrawList()->AddRectFilled({from, min.y}, {std::max(to, from + 1.0F), max.y},
                                              fill, ui.theme.rounding_px);
}

double snapped(const Field& field, double value) {
    if (field.snap > 0.0) value = multiple_of(field.snap, std::round(value / field.snap));
    return std::clamp(value, field.slider.low, field.slider.high);
}

// One step from the present value to the next multiple of `snap`; typed values beyond the slider
// step, too.
double nudged(const Field& field, double value, double step) {
    constexpr double kSame = 1e-9;  // tolerance in multiples: 0.3 is three tenths
    double to = value + step;
    if (field.snap > 0.0 && std::abs(step) >= field.snap) {
        const double multiples = to / field.snap;
        to = multiple_of(field.snap,
                         step > 0.0 ? std::floor(multiples + kSame) : std::ceil(multiples - kSame));
    }
    return std::clamp(to, field.typed.low, field.typed.high);
}

// Left and right nudge the last touched field, unless text is being typed, and so does the wheel
// over it: returns the number of steps.
int nudges(Ui& ui, const Field& field, int wheel) {
    // WantTextInput is no use here: it takes the first key after a text field has been left.
    if (ui.field.active != field.id || ImGui::IsAnyItemActive() || !field.enabled) return 0;
    if (ui.keyboard_mode) return wheel;
    const bool right = ImGui::IsKeyPressed(ImGuiKey_RightArrow);
    const bool left = ImGui::IsKeyPressed(ImGuiKey_LeftArrow);
    return wheel + (right ? 1 : 0) - (left ? 1 : 0);
}

void nudge(Ui& ui, const Field& field, int steps, double& value, FieldEdit& edit) {
    if (steps == 0) return;
    const ImGuiIO& io = ImGui::GetIO();
    const double times = io.KeyShift ? kCoarse : io.KeyAlt ? kFine : 1.0;
    const double before = std::exchange(
        value, nudged(field, value, steps * times * std::max(field.step, field.snap)));
    join_steps(ui, field.id);
    edit.changed |= value != before;
    edit.finished |= value != before;
    edit.along = Along::step;
}

// Whether the mouse is over the bar or the entry of the focused field.
int wheel_over(Ui& ui, const Field& field) {
    return ui.field.active == field.id && field.enabled ? wheel_steps(ui) : 0;
}

bool draw_bar(Ui& ui, const Field& field, double& value) {
    // No typed input in the bar: the entry is for that, and Tab would turn the bar into another
    // one.
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat | ImGuiSliderFlags_NoInput;
    // A linear slider over logarithms: ImGui's logarithmic one takes everything below a thousandth
    // for zero.
    const auto on_bar = [&](double of) {
        return field.logarithmic ? std::log(std::max(of, field.slider.low)) : of;
    };
    const double low = on_bar(field.slider.low);
    const double high = on_bar(field.slider.high);
    double moved = on_bar(value);
    ImGui::PushItemFlag(ImGuiItemFlags_NoTabStop, true);  // the entry beside it is a stop
    const bool changed =
        ImGui::SliderScalar("##bar", ImGuiDataType_Double, &moved, &low, &high, "", flags);
    ImGui::PopItemFlag();
    // The ends are exact to the bit.
    if (field.logarithmic) {
        moved = moved <= low    ? field.slider.low
                : moved >= high ? field.slider.high
                                : std::exp(moved);
    }
    if (changed) value = snapped(field, moved);
    draw_fill(ui, field, value);
    note_item(ui.rects, std::string("slider:") + field.id, std::to_string(value));
    return changed;
}

// In whole steps, without a unit.
bool is_count(const Field& field) {
    return field.snap == 1.0 && std::string_view(field.format) == "%.0f";
}

NumberEdit draw_entry(Ui& ui, const Field& field, double& value, float width_px) {
    if (ui.field.wanted == field.id) {
        focus_next_item();
        ui.field.wanted.clear();
    }
    const NumberEdit edit =
        edit_entry(ui,
                   {.id = "entry",
                    .label = field.label,
                    .format = field.format,
                    .rules = {field.typed, unit_in(field.format), is_count(field)},
                    .width_px = width_px,
                    .step = std::max(field.step, field.snap),
                    .mixed = field.mixed.has_value()},
                   value);
    note_item(ui.rects, std::string("entry:") + field.id,
              field.mixed ? "mixed" : std::to_string(value));
    if (ImGui::IsItemActive()) note_item(ui.rects, "typed", field.id);
    return edit;
}

// Its tooltip, and its default, which a double click restores: true then.
bool draw_label_help(Ui& ui, const Field& field) {
    std::string help = field.help == nullptr ? "" : field.help;
    if (field.normal && ImGui::IsItemHovered()) {
        help += (help.empty() ? "Double click: back to " : "\nDouble click: back to ") +
                shown_number(field.format, *field.normal);
    }
    const bool reset = field.normal && is_reset_asked(ui);
    if (!help.empty()) draw_tooltip(ui, help.c_str());
    return reset;
}

// A ring on the field that arrow keys nudge. After Tab they do not, and the ring is around the
// focus.
void draw_nudge_ring(Ui& ui, const Field& field) {
    const bool is_nudged = ui.field.active == field.id && !ui.keyboard_mode;
    if (!is_nudged || !field.enabled || ui.as_picture) return;
    const float s = ui.theme.scale;
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin() - ImVec2{s, s},
                                        ImGui::GetItemRectMax() + ImVec2{s, s}, ui.theme.accent,
                                        ui.theme.rounding_px, 0, 1.5F * ui.theme.hairline_px);
    note_item(ui.rects, "nudged by arrows", field.id);
}

// A locked field accepts nothing, but keys typed at it must not act on the window either.
void follow_locked(Ui& ui, const Field& field, const Rect& row) {
    const bool over = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(row.min, row.max);
    if (!over || !is_item_disabled() || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
    ui.field.locked = field.id;
    ui.field.active.clear();
}

float label_column(const Ui& ui) { return kLabelColumnPx * ui.theme.scale; }

struct FieldRow {
    bool stacked = false;  // the label above the rest
    float bar_px = 0.0F;   // empty: no slider
    float entry_px = 0.0F;
};

FieldRow field_row(const Ui& ui, const Field& field) {
    const float s = ui.theme.scale;
    const float width = ImGui::GetContentRegionAvail().x - field.right_room_px;
    const float entry = kEntryWidthPx * s;
    const float column =
        std::max(label_column(ui), ImGui::CalcTextSize(field.label).x + ui.theme.gap_px);
    const float bar = width - entry - ui.theme.gap_px;
    if (bar - column >= kLeastBarPx * s) return {false, bar - column, entry};
    if (bar >= kLeastBarPx * s) return {true, bar, entry};
    return {true, 0.0F, std::max(width, 1.0F)};
}

void draw_bar_and_entry(Ui& ui, const Field& field, const FieldRow& row, double& value,
                        FieldEdit& edit) {
    bool touched = false;
    int wheel = 0;
    const ImVec2 begin = ImGui::GetCursorScreenPos();
    if (row.bar_px > 0.0F) {
        ImGui::SetNextItemWidth(row.bar_px);
        if (draw_bar(ui, field, value)) {
            edit.changed = true;
            edit.along = Along::ratio;
        }
        edit.finished |= ImGui::IsItemDeactivatedAfterEdit();
        edit.over_bar = ImGui::IsItemHovered();
        edit.begun = touched = ImGui::IsItemActivated();
        wheel = wheel_over(ui, field);
        ImGui::SameLine(0.0F, ui.theme.gap_px);
    }
    const NumberEdit entered = draw_entry(ui, field, value, row.entry_px);
    if (entered.changed) {
        static_cast<NumberEdit&>(edit) = entered;
        edit.finished = true;
    }
    edit.begun |= entered.begun;
    touched |= ImGui::IsItemActivated();
    wheel += wheel_over(ui, field);
    if (touched) ui.field.active = field.id;
    draw_nudge_ring(ui, field);
    follow_locked(ui, field, {begin, ImGui::GetItemRectMax()});
    nudge(ui, field, nudges(ui, field, wheel), value, edit);
}

}  // namespace

void draw_label(const Ui& ui, const char* label, float room_px) {
    const float column = std::max(label_column(ui), ImGui::CalcTextSize(label).x + ui.theme.gap_px);
    const bool beside = ImGui::GetContentRegionAvail().x - column >= room_px;
    if (*label == '\0') {
        if (beside) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + column);
        return;
    }
    if (beside) ImGui::AlignTextToFramePadding();
    dim_text(ui, label);
    if (beside) ImGui::SameLine(0.0F, column - ImGui::GetItemRectSize().x);
}

FieldEdit draw_field(Ui& ui, const Field& field, double& value) {
    FieldEdit edit;
    ImGui::PushID(field.id);
    ImGui::BeginDisabled(!field.enabled);
    const FieldRow row = field_row(ui, field);
    draw_label(ui, field.label, row.stacked ? ImGui::GetContentRegionAvail().x : 0.0F);
    note_item(ui.rects, std::string("field label:") + field.id);
    if (draw_label_help(ui, field)) {
        edit.changed = edit.finished = value != *field.normal || field.mixed;
        value = *field.normal;
    }
    draw_bar_and_entry(ui, field, row, value, edit);
    ImGui::EndDisabled();
    ImGui::PopID();
    return edit;
}

FieldEdit draw_short_field(Ui& ui, const Field& field, float width_px, double& value) {
    FieldEdit edit;
    ImGui::PushID(field.id);
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    dim_text(ui, {.id = std::string("field label:") + field.id, .text = field.label});
    if (draw_label_help(ui, field)) {
        edit.changed = edit.finished = value != *field.normal;
        value = *field.normal;
    }
    const float gap = 0.5F * ui.theme.gap_px;
    const float label_px = ImGui::GetItemRectSize().x + gap;
    ImGui::SameLine(0.0F, gap);
    // As wide as the longest number with its unit.
    const std::string longest = shown_number(field.format, field.typed.high);
    const float entry_px =
        std::max(kShortEntryPx * ui.theme.scale,
                 ImGui::CalcTextSize(longest.c_str()).x + 3.0F * ImGui::GetStyle().FramePadding.x);
    const float bar_px = width_px - label_px - ui.theme.gap_px - entry_px;
    draw_bar_and_entry(ui, field, {false, std::max(bar_px, 1.0F), entry_px}, value, edit);
    ImGui::EndGroup();
    ImGui::PopID();
    return edit;
}

}  // namespace tact
