#include "app/ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "app/ui/number_field.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kLabelColumnPx = 104.0F;
constexpr float kChipPadPx = 5.0F;
constexpr float kEntryWidthPx = 86.0F;
constexpr float kLeastBarPx = 36.0F;

ImVec4 colour4(ImU32 colour) { return ImGui::ColorConvertU32ToFloat4(colour); }

// The longest form that fits, or none: half a number would be a wrong one.
std::string fitting(const std::vector<std::string>& forms, const ImFont* font, float room_px) {
    for (const std::string& form : forms) {
        if (text_size(font, form).x <= room_px) return form;
    }
    return {};
}

// Of a name a part is better than nothing, if it is enough to know it by.
std::string cut(const std::string& name, const ImFont* font, float room_px) {
    if (text_size(font, name).x <= room_px) return name;
    return room_px < 4.0F * font_or_current(font).FontSize ? "" : shortened(font, name, room_px);
}

void draw_title_part(Ui& ui, const ImFont* font, ImVec2 corner, ImU32 colour,
                     const std::string& text, const std::string& noted) {
    if (text.empty()) return;
    draw_text(*ImGui::GetWindowDrawList(), font, corner, colour, text);
    note_rect(ui.rects, noted, corner, corner + text_size(font, text), text);
}

// The title goes first; the detail has what it leaves, the right end what both leave.
void draw_pane_title(Ui& ui, Layout& layout, Pane pane, const PaneTitle& title) {
    const Theme& theme = ui.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight()};
    const Fonts& fonts = theme.fonts;
    const std::string head = shortened(fonts.semibold, title.title, size.x);
    float used = text_size(fonts.semibold, head).x + theme.gap_px;
    draw_title_part(ui, fonts.semibold, corner, theme.text, head, "title text:" + title.title);
    const std::string detail = cut(title.detail, fonts.regular, size.x - used);
    draw_title_part(ui, fonts.regular, corner + ImVec2{used, 0.0F}, theme.dim_text, detail,
                    "title detail:" + title.title);
    if (!detail.empty()) used += text_size(fonts.regular, detail).x + 2.0F * theme.gap_px;
    const std::string right = fitting(title.right, fonts.regular, size.x - used);
    const float right_px = text_size(fonts.regular, right).x;
    draw_title_part(ui, fonts.regular, corner + ImVec2{size.x - right_px, 0.0F}, theme.dim_text,
                    right, "title right:" + title.title);
    ImGui::Dummy(size);
    const bool over = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(corner, corner + size);
    if (over && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !ImGui::IsAnyItemActive()) {
        layout.maximised = layout.maximised ? std::nullopt : std::optional(pane);
    }
    note_rect(ui.rects, "title:" + title.title, corner, corner + size,
              title.right.empty() ? "" : title.right.front());
}

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

void draw_pane(Ui& ui, Layout& layout, Pane pane, const Rect& area, const PaneTitle& title,
               const std::function<void()>& content) {
    ImGui::SetNextWindowPos(area.min);
    ImGui::SetNextWindowSize(area.size());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.theme.pane_rounding_px);
    constexpr ImGuiWindowFlags kFlags =
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
        ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse;
    const std::string id = "pane " + std::to_string(static_cast<int>(pane));
    if (ImGui::Begin(id.c_str(), nullptr, kFlags)) {
        note_rect(ui.rects, "pane:" + title.title, area.min, area.max);
        draw_pane_title(ui, layout, pane, title);
        content();
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

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

float radio_width(const Ui& ui, const char* label) {
    return 18.0F * ui.theme.scale + ImGui::CalcTextSize(label).x;
}

bool draw_radio(const Ui& ui, const char* label, bool chosen) {
    const Theme& theme = ui.theme;
    const float s = theme.scale;
    const ImVec2 size{radio_width(ui, label), ImGui::GetFrameHeight()};
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(label, size);
    const bool lit = ImGui::IsItemHovered() || (ui.keyboard_mode && ImGui::IsItemFocused());
    // GetColorU32 fades what is disabled.
    const auto ink = [](ImU32 colour) { return ImGui::GetColorU32(colour); };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 centre{corner.x + 6.0F * s, corner.y + size.y * 0.5F};
    list.AddCircle(centre, 5.5F * s, ink(chosen || lit ? theme.accent : theme.dim_text), 0,
                   theme.hairline_px);
    if (chosen) list.AddCircleFilled(centre, 3.2F * s, ink(theme.accent));
    list.AddText({corner.x + 18.0F * s, corner.y + ImGui::GetStyle().FramePadding.y},
                 ink(chosen || lit ? theme.text : theme.dim_text), label);
    return pressed;
}

bool flow_on(float width_px, float gap_px) {
    const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
    const bool beside = ImGui::GetItemRectMax().x + gap_px + width_px <= right;
    if (beside) ImGui::SameLine(0.0F, gap_px);
    return beside;
}

float button_width(const char* label) {
    return ImGui::CalcTextSize(label).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

void draw_splitter(Ui& ui, const Splitter& splitter, float& share) {
    const Rect& bar = splitter.bar;
    ImGui::SetNextWindowPos(bar.min);
    ImGui::SetNextWindowSize(bar.size());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoBackground |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin(splitter.id, nullptr, kFlags)) {
        ImGui::InvisibleButton("bar", bar.size());
        if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
            ImGui::SetMouseCursor(splitter.upright ? ImGuiMouseCursor_ResizeEW
                                                   : ImGuiMouseCursor_ResizeNS);
            ImGui::GetWindowDrawList()->AddRectFilled(bar.min, bar.max, ui.theme.accent,
                                                      ui.theme.rounding_px);
        }
        if (ImGui::IsItemActive()) {
            const ImVec2 delta = ImGui::GetIO().MouseDelta;
            const float moved = (splitter.upright ? delta.x : delta.y) / splitter.total_px;
            share = std::clamp(share + moved, static_cast<float>(splitter.share.low),
                               static_cast<float>(splitter.share.high));
        }
        note_item(ui.rects, std::string("splitter:") + splitter.id);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void draw_hint(Ui& ui, const char* id, const char* text) {
    if (ui.dismissed_hints.contains(id)) return;
    ImGui::PushID(id);
    ImGui::PushStyleColor(ImGuiCol_Text, colour4(ui.theme.dim_text));
    const float button = ImGui::GetContentRegionMax().x - button_width("\u00d7");
    ImGui::PushTextWrapPos(button - ui.theme.gap_px);
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::SameLine(button);
    if (ImGui::SmallButton("\u00d7")) ui.dismissed_hints.insert(id);
    note_item(ui.rects, std::string("hint:") + id);
    draw_tooltip(ui, "Dismiss this hint");
    ImGui::PopID();
}

void draw_tooltip(const Ui& ui, const char* text) {
    constexpr float kRestS = 0.4F;
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    if (ImGui::GetCurrentContext() == nullptr || ImGui::GetIO().MouseDown[0]) return;
    if (ImGui::IsItemActive()) return;  // who types there knows, and has to see what is beside
    if (ui.time_s - ui.hover_since_s < static_cast<double>(kRestS)) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(320.0F * ui.theme.scale);
    ImGui::TextUnformatted(text);
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    return text;
}

void dim_text(const Ui& ui, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour4(ui.theme.dim_text));
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopStyleColor();
}

float chip_width(const Ui& ui, const char* text) {
    return text_size(ui.theme.fonts.small, text).x + 2.0F * kChipPadPx * ui.theme.scale;
}

bool draw_chip(const Ui& ui, const char* id, const char* text, bool lit) {
    const Theme& theme = ui.theme;
    const ImVec2 pad{kChipPadPx * theme.scale, 3.0F * theme.scale};
    const ImVec2 size = text_size(theme.fonts.small, text) + pad * 2.0F;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(id, size);
    const bool over = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (lit || over) {
        list.AddRectFilled(corner, corner + size, lit ? faded(theme.accent, 0.28F) : theme.hover,
                           theme.rounding_px);
    }
    draw_text(list, theme.fonts.small, corner + pad, lit || over ? theme.text : theme.dim_text,
              text);
    if (over) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return pressed;
}

void coloured_text(ImU32 colour, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

void draw_info_mark(const Ui& ui, ImVec2 centre, bool lit) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float radius = 6.5F * ui.theme.scale;
    const ImU32 colour = lit ? ui.theme.accent : ui.theme.dim_text;
    list.AddCircle(centre, radius, colour, 0, ui.theme.hairline_px);
    const ImVec2 size = text_size(ui.theme.fonts.small, "i");
    draw_text(list, ui.theme.fonts.small, {centre.x - size.x / 2.0F, centre.y - size.y / 2.0F},
              colour, "i");
}

bool link(const Ui& ui, const char* id, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(id, size);
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    ImGui::GetWindowDrawList()->AddText(corner, ui.theme.accent, text.c_str());
    if (lit) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
        ImGui::GetWindowDrawList()->AddLine(
            {corner.x, corner.y + size.y}, {corner.x + size.x, corner.y + size.y}, ui.theme.accent);
    }
    return pressed;
}

Rect rest_of_pane() {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    return rect_at(corner, ImGui::GetContentRegionAvail());
}

}  // namespace tact
