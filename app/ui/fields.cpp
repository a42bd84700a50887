// Rows of a number: its label, slider and typed entry. Declared in app/ui/widgets.h.

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/ui/number_field.h"
#include "app/ui/widgets.h"

namespace tact {

namespace {

constexpr float kLabelColumnPx = 104.0F;
constexpr float kEntryWidthPx = 86.0F;
constexpr float kLeastBarPx = 36.0F;

// The part of the slider up to its value, drawn over the frame.
void draw_fill(const Ui& ui, float share) {
    const ImVec2 min = ImGui::GetItemRectMin();
    const ImVec2 max = ImGui::GetItemRectMax();
    const float x = min.x + (max.x - min.x) * std::clamp(share, 0.0F, 1.0F);
    const ImU32 fill = (ui.theme.accent & ~IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 90);
    ImGui::GetWindowDrawList()->AddRectFilled(min, {x, max.y}, fill, ui.theme.rounding_px);
}

float share_of(const Field& field, double value) {
    const auto [low, high] = field.slider;
    if (field.logarithmic) {
        return static_cast<float>(std::log(std::max(value, low) / low) / std::log(high / low));
    }
    return static_cast<float>((value - low) / (high - low));
}

double snapped(const Field& field, double value) {
    if (field.snap > 0.0) value = std::round(value / field.snap) * field.snap;
    return std::clamp(value, field.slider.low, field.slider.high);
}

// One step from where it is, typed values beyond the slider too, onto the next multiple of `snap`
// on the way.
double nudged(const Field& field, double value, double step) {
    constexpr double kSame = 1e-9;  // of a multiple: 0.3 is three tenths
    double to = value + step;
    if (field.snap > 0.0 && std::abs(step) >= field.snap) {
        const double multiples = to / field.snap;
        to = field.snap *
             (step > 0.0 ? std::floor(multiples + kSame) : std::ceil(multiples - kSame));
    }
    return std::clamp(to, field.typed.low, field.typed.high);
}

// Left and right nudge the field that was touched last, unless text is being typed.
bool nudge(Ui& ui, const Field& field, double& value) {
    if (ui.field.active != field.id || ImGui::GetIO().WantTextInput) return false;
    if (ImGui::IsAnyItemActive() || ui.keyboard_mode || !field.enabled) return false;
    const bool right = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_RightArrow));
    const bool left = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_LeftArrow));
    if (right == left) return false;
    const ImGuiIO& io = ImGui::GetIO();
    const double times = io.KeyShift ? kCoarse : io.KeyAlt ? kFine : 1.0;
    const double step = times * std::max(field.step, field.snap);
    const double before = std::exchange(value, nudged(field, value, right ? step : -step));
    join_steps(ui, field.id);
    return value != before;
}

bool draw_bar(Ui& ui, const Field& field, double& value) {
    // No input: there is an entry for that, and Tab would turn the bar into another one.
    const ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat |
                                   ImGuiSliderFlags_NoInput |
                                   (field.logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    double moved = value;
    ImGui::PushItemFlag(ImGuiItemFlags_NoTabStop, true);  // the entry beside it is one
    const bool changed = ImGui::SliderScalar("##bar", ImGuiDataType_Double, &moved,
                                             &field.slider.low, &field.slider.high, "", flags);
    ImGui::PopItemFlag();
    if (changed) value = snapped(field, moved);
    draw_fill(ui, share_of(field, value));
    note_item(ui.rects, std::string("slider:") + field.id, std::to_string(value));
    return changed;
}

bool draw_entry(Ui& ui, const Field& field, double& value, float width_px) {
    const bool entered = enter_number(ui,
                                      {.id = "entry",
                                       .label = field.label,
                                       .format = field.format,
                                       .rules = {field.typed, unit_in(field.format)},
                                       .width_px = width_px,
                                       .step = std::max(field.step, field.snap)},
                                      value);
    note_item(ui.rects, std::string("entry:") + field.id, std::to_string(value));
    return entered;
}

// A ring on the field that arrow keys nudge.
void draw_nudge_ring(Ui& ui, const Field& field) {
    if (ui.field.active != field.id || !field.enabled || ui.as_picture) return;
    const float s = ui.theme.scale;
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin() - ImVec2{s, s},
                                        ImGui::GetItemRectMax() + ImVec2{s, s}, ui.theme.accent,
                                        ui.theme.rounding_px, 0, 1.5F * ui.theme.hairline_px);
    note_item(ui.rects, "nudged by arrows", field.id);
}

// A locked field takes nothing, but what is typed at it is not meant for the window either.
void follow_locked(Ui& ui, const Field& field, const Rect& row) {
    const bool over = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(row.min, row.max);
    const bool locked = (ImGui::GetItemFlags() & ImGuiItemFlags_Disabled) != 0;
    if (!over || !locked || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
    ui.field.locked = field.id;
    ui.field.active.clear();
}

float label_column(const Ui& ui) { return kLabelColumnPx * ui.theme.scale; }

struct FieldRow {
    bool stacked = false;  // the label above the rest
    float bar_px = 0.0F;   // none: no slider
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
    if (field.help != nullptr) draw_tooltip(ui, field.help);

    bool touched = false;
    const ImVec2 begin = ImGui::GetCursorScreenPos();
    if (row.bar_px > 0.0F) {
        ImGui::SetNextItemWidth(row.bar_px);
        edit.changed = draw_bar(ui, field, value);
        edit.finished = ImGui::IsItemDeactivatedAfterEdit();
        touched = ImGui::IsItemActivated();
        ImGui::SameLine(0.0F, ui.theme.gap_px);
    }
    if (draw_entry(ui, field, value, row.entry_px)) edit.changed = edit.finished = true;
    touched |= ImGui::IsItemActivated();
    if (touched) ui.field.active = field.id;
    draw_nudge_ring(ui, field);
    follow_locked(ui, field, {begin, ImGui::GetItemRectMax()});
    if (nudge(ui, field, value)) edit.changed = edit.finished = true;
    ImGui::EndDisabled();
    ImGui::PopID();
    return edit;
}

}  // namespace tact
