#include "app/ui/widgets.h"

#include <imgui.h>
// After imgui.h.
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/ui/parts.h"
#include "viz/drawing/imgui_versions.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr const char* kMixed = "mixed";

// State for ImGui's callback while text is edited: a step changes the text itself.
struct Stepping {
    Ui* ui;
    const NumberEntry* entry;
    double value;
    bool stepped = false;
};

// Turns of the wheel in whole steps; touch pads turn by less.
int whole_turns(Ui& ui) {
    ui.field.wheel += ImGui::GetIO().MouseWheel;
    const float whole = std::trunc(ui.field.wheel);
    ui.field.wheel -= whole;
    return static_cast<int>(whole);
}

double step_of(const NumberEntry& entry, double value) {
    const ImGuiIO& io = ImGui::GetIO();
    double step = entry.step;
    if (step <= 0.0 && value != 0.0) {
        step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 1.0);
    }
    if (step <= 0.0) step = 0.1;
    if (entry.rules.whole) step = std::max(1.0, std::round(step));
    if (io.KeyShift) return kCoarse * step;
    return io.KeyAlt && !entry.rules.whole ? kFine * step : step;
}

// Up, down and the wheel in the entry. ImGui changes an active field only from inside its callback.
int on_step(ImGuiInputTextCallbackData* field) {
    Stepping& stepping = *static_cast<Stepping*>(field->UserData);
    const NumberEntry& entry = *stepping.entry;
    int steps = 0;
    if (field->EventFlag == ImGuiInputTextFlags_CallbackHistory) {
        steps = field->EventKey == ImGuiKey_UpArrow ? 1 : -1;
    } else if (ImGui::GetHoveredID() == ImGui::GetActiveID()) {
        steps = whole_turns(*stepping.ui);
    }
    if (steps == 0) return 0;
    const std::string_view text{field->Buf, static_cast<std::size_t>(field->BufTextLen)};
    const auto typed = typed_number(text, stepping.value, entry.rules);
    // Unchanged text stands for the number itself, with the digits that are not shown.
    const bool as_it_was = !typed || text == shown_number(entry.format, stepping.value);
    const double from = as_it_was ? stepping.value : typed->value;
    const double to = from + steps * step_of(entry, from);
    const auto [low, high] = entry.rules.allowed;
    const std::string shown = shown_number("%.9g", std::clamp(to, low, high));
    field->DeleteChars(0, field->BufTextLen);
    field->InsertChars(0, shown.c_str());
    stepping.stepped = true;
    return 0;
}

void complain_of(Ui& ui, const NumberEntry& entry, const std::string& sentence) {
    complain(ui, entry.label.empty() ? sentence : entry.label + ": " + sentence);
}

void frame_in_red(const Ui& ui) {
    ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                        ui.theme.error, ui.theme.rounding_px, 0,
                                        1.5F * ui.theme.hairline_px);
}

// The error in a text; empty: no error.
std::string fault_of(const NumberEntry& entry, const Expected<TypedNumber>& typed) {
    if (!typed) return typed.error().message;
    if (typed->remark.empty()) return {};
    const bool is_most = typed->value == entry.rules.allowed.high;
    return (is_most ? "at most " : "at least ") + shown_number(entry.format, typed->value);
}

// Sums are not computed; if one may be meant, the message tells so. "+0.1" is 0.1.
std::string meaning_of(const NumberEntry& entry, const std::string& text,
                       const Expected<TypedNumber>& typed) {
    if (!text.starts_with('+') || !typed || typed->factor) return {};
    return shown_number(entry.format, typed->value) + " itself; +10% and *2 change what is there";
}

// A plate beneath the entry while typing: the error of the text, or its meaning.
void show_words_on(Ui& ui, const NumberEntry& entry, const NumberTyping& typing) {
    if (typing.text == typing.first || typing.text.empty()) return;
    const auto typed = typed_number(typing.text, typing.before, entry.rules);
    const std::string fault = fault_of(entry, typed);
    const std::string words = fault.empty() ? meaning_of(entry, typing.text, typed) : fault;
    if (words.empty()) return;
    if (!fault.empty()) frame_in_red(ui);
    const Theme& theme = ui.theme;
    const ImU32 ink = fault.empty() ? theme.warning : theme.error;
    const ImVec2 pad{4.0F * theme.scale, 2.0F * theme.scale};
    const ImVec2 size = text_size(theme.fonts.small, words) + pad * 2.0F;
    const float rightmost = std::max(0.0F, ImGui::GetIO().DisplaySize.x - size.x);
    const ImVec2 corner{std::min(ImGui::GetItemRectMin().x, rightmost),
                        ImGui::GetItemRectMax().y + 2.0F * theme.scale};
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.AddRectFilled(corner, corner + size, theme.pane, theme.rounding_px);
    list.AddRect(corner, corner + size, ink, theme.rounding_px, 0, theme.hairline_px);
    draw_text(list, theme.fonts.small, corner + pad, ink, words);
    note_rect(ui.rects, "words on typed", corner, corner + size, words);
}

// Takes the number in the text; without one, the old number stays.
NumberEdit take_number(Ui& ui, const NumberEntry& entry, NumberTyping& typing, double& value) {
    if (typing.text == typing.first) {  // back to its value before all steps
        const bool stepped = typing.taken != typing.first;
        return {std::exchange(value, typing.before) != typing.before || stepped, false,
                Along::back};
    }
    if (typing.text == typing.taken || typing.text.empty()) return {};
    const auto typed = typed_number(typing.text, value, entry.rules);
    if (!typed) {
        complain_of(ui, entry, typed.error().message);
        typing.refused = typing.entry;
        return {};
    }
    if (!typed->remark.empty()) {
        complain_of(ui, entry, typed->remark);
        typing.refused = typing.entry;  // the text is not the typed one
    }
    const bool changed = std::exchange(value, typed->value) != typed->value || entry.mixed;
    if (typed->factor) return {changed, false, Along::factor, *typed->factor};
    return {changed, false, Along::same};
}

// While typing: half a number may be out of range, or not a number.
double live_number(const NumberEntry& entry, const NumberTyping& typing) {
    if (typing.text == typing.first) return typing.before;
    const auto typed = typed_number(typing.text, typing.before, entry.rules);
    return typed && typed->remark.empty() ? typed->value : typing.before;
}

}  // namespace

bool is_number_typed(const Ui& ui) {
    return ui.field.typing.frame > 0 && ui.field.typing.frame >= ImGui::GetFrameCount() - 1;
}

void join_steps(Ui& ui, const std::string& field) {
    constexpr double kPauseS = 0.7;
    const bool is_more = ui.field.nudged == field;
    ui.field.nudges_on = is_more && ui.time_s - ui.field.nudged_s < kPauseS;
    ui.field.nudged = field;
    ui.field.nudged_s = ui.time_s;
}

int wheel_steps(Ui& ui) {
    if (!ImGui::IsItemHovered()) return 0;
    // In the entry's first frame the pane beneath has been scrolled already.
    return take_wheel() ? whole_turns(ui) : 0;
}

bool is_reset_asked(const Ui& ui) {
    return !ui.as_picture && ImGui::IsItemHovered() &&
           ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
}

bool reset_by_label(const Ui& ui, double normal, double& value) {
    return is_reset_asked(ui) && std::exchange(value, normal) != normal;
}

bool reset_by_label(const Ui& ui, int normal, int& value) {
    return is_reset_asked(ui) && std::exchange(value, normal) != normal;
}

NumberEdit edit_entry(Ui& ui, const NumberEntry& entry, double& value) {
    NumberTyping& typing = ui.field.typing;
    const std::string name = "##" + entry.id;
    const ImGuiID id = ImGui::GetID(name.c_str());
    const int frame = ImGui::GetFrameCount();
    // An entry that left the screen while typing does not continue.
    const bool was_typed = typing.entry == id && typing.frame >= frame - 1;
    const std::string shown = entry.mixed ? kMixed : shown_number(entry.format, value);
    std::string text = was_typed ? typing.text : shown;
    Stepping stepping{&ui, &entry, value};
    ImGui::SetNextItemWidth(entry.width_px);
    ImGui::InputText(name.c_str(), &text,
                     ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackHistory |
                         ImGuiInputTextFlags_CallbackAlways,
                     on_step, &stepping);
    ui.rects.tab_order.numbers.push_back(id);
    if (typing.refused == id && !was_typed) frame_in_red(ui);
    NumberEdit edit;
    if (ImGui::IsItemActive()) {
        if (!was_typed) {
            const bool clicked = ImGui::GetIO().MouseDown[0];
            typing = {id, frame, shown, shown, value, shown, clicked || ui.field.tabbed_on, 0};
            ui.field.tabbed_on = false;
            edit.begun = true;
        }
        if (ImGui::IsItemHovered()) take_wheel();
        typing.frame = frame;
        typing.text = text;
        const double before = value;
        if (!stepping.stepped) {
            show_words_on(ui, entry, typing);
            if (entry.live) value = live_number(entry, typing);
            edit.changed = value != before;
            return edit;
        }
        edit = take_number(ui, entry, typing, value);
        edit.along = Along::step;
        typing.taken = text;
        join_steps(ui, entry.label);
        return edit;
    }
    if (!was_typed) return edit;
    typing.text = text;
    const double before = value;
    if (entry.live) value = typing.before;
    edit = take_number(ui, entry, typing, value);
    if (entry.live) edit.changed = value != before;
    typing.entry = 0;
    // Esc also takes back the steps of arrows.
    ui.field.nudges_on = text == typing.first && ui.field.nudged == entry.label;
    return edit;
}

bool enter_number(Ui& ui, const NumberEntry& entry, double& value) {
    return edit_entry(ui, entry, value).changed;
}

bool enter_whole(Ui& ui, const NumberEntry& entry, int& value) {
    double number = value;
    NumberEntry whole = entry;
    whole.rules.whole = true;
    if (!enter_number(ui, whole, number)) return false;
    value = static_cast<int>(number);
    return true;
}

bool enter_whole_with_buttons(Ui& ui, const NumberEntry& entry, int& value) {
    const float button = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto [low, high] = entry.rules.allowed;
    NumberEntry narrow = entry;
    narrow.width_px = std::max(1.0F, entry.width_px - 2.0F * (button + gap));
    const int before = value;
    ImGui::BeginGroup();
    ImGui::PushID(entry.id.c_str());
    enter_whole(ui, narrow, value);
    note_stop(ui.rects.tab_order);  // the group is not a stop, and the buttons are its arrow keys
    ImGui::PushButtonRepeat(true);
    for (const int step : {-1, 1}) {
        ImGui::SameLine(0.0F, gap);
        if (ImGui::Button(step < 0 ? "-" : "+", {button, button})) value += step;
        note_rect(ui.rects, "stepper:" + entry.id + (step < 0 ? " less" : " more"),
                  ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
    }
    ImGui::PopButtonRepeat();
    value = std::clamp(value, static_cast<int>(low), static_cast<int>(high));
    ImGui::PopID();
    ImGui::EndGroup();
    return value != before;
}

}  // namespace tact
