#include "app/ui/number_field.h"

#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viz/drawing/marks.h"

namespace tact {

namespace {

// What ImGui asks back about while text is edited: the step of an arrow changes the text itself.
struct Stepping {
    const NumberEntry* entry;
    double value;
    bool stepped = false;
};

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

// Up and down in the entry. ImGui lets an active field be changed only from inside.
int on_step(ImGuiInputTextCallbackData* field) {
    Stepping& stepping = *static_cast<Stepping*>(field->UserData);
    const NumberEntry& entry = *stepping.entry;
    const std::string_view text{field->Buf, static_cast<std::size_t>(field->BufTextLen)};
    const auto typed = typed_number(text, stepping.value, entry.rules);
    // What stands there as it was is the number itself, with the digits that are not shown.
    const bool as_it_was = !typed || text == shown_number(entry.format, stepping.value);
    const double from = as_it_was ? stepping.value : typed->value;
    const double step = step_of(entry, from);
    const double to = from + (field->EventKey == ImGuiKey_UpArrow ? step : -step);
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

// What is wrong with the text, beneath the entry, while it is typed.
void show_fault(const Ui& ui, const NumberEntry& entry, const NumberTyping& typing) {
    if (typing.text == typing.first || typing.text.empty()) return;
    const auto typed = typed_number(typing.text, typing.before, entry.rules);
    if (typed && typed->remark.empty()) return;
    frame_in_red(ui);
    const ImVec2 below{ImGui::GetItemRectMin().x,
                       ImGui::GetItemRectMax().y + 2.0F * ui.theme.scale};
    draw_text_halo(
        *ImGui::GetForegroundDrawList(), ui.theme.fonts.small, below, ui.theme.error, ui.theme.pane,
        ui.theme.scale,
        typed ? typed->remark.substr(0, typed->remark.find(':')) : typed.error().message);
}

// The number that the text stands for; where it stands for none, the one that was.
double taken_number(Ui& ui, const NumberEntry& entry, NumberTyping& typing, double value) {
    if (typing.text == typing.first) return typing.before;
    if (typing.text == typing.taken || typing.text.empty()) return value;
    const auto typed = typed_number(typing.text, value, entry.rules);
    if (!typed) {
        complain_of(ui, entry, typed.error().message);
        typing.refused = typing.entry;
        return value;
    }
    if (!typed->remark.empty()) complain_of(ui, entry, typed->remark);
    return typed->value;
}

// While it is typed: half a number may be out of range or none.
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

bool enter_number(Ui& ui, const NumberEntry& entry, double& value) {
    NumberTyping& typing = ui.field.typing;
    const std::string name = "##" + entry.id;
    const ImGuiID id = ImGui::GetID(name.c_str());
    const int frame = ImGui::GetFrameCount();
    // One that went from the screen in the middle of being typed is not taken up again.
    const bool was_typed = typing.entry == id && typing.frame >= frame - 1;
    const std::string shown = shown_number(entry.format, value);
    std::string text = was_typed ? typing.text : shown;
    Stepping stepping{&entry, value, false};
    ImGui::SetNextItemWidth(entry.width_px);
    ImGui::InputText(name.c_str(), &text,
                     ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_CallbackHistory,
                     on_step, &stepping);
    if (typing.refused == id && !was_typed) frame_in_red(ui);
    if (ImGui::IsItemActive()) {
        if (!was_typed) typing = {id, frame, shown, shown, value, shown, 0};
        typing.frame = frame;
        typing.text = text;
        const double before = value;
        if (!stepping.stepped) {
            show_fault(ui, entry, typing);
            if (entry.live) value = live_number(entry, typing);
            return value != before;
        }
        value = taken_number(ui, entry, typing, value);
        typing.taken = text;
        join_steps(ui, entry.label);
        return value != before;
    }
    if (!was_typed) return false;
    typing.text = text;
    const double before = value;
    if (entry.live) value = typing.before;
    const double taken = taken_number(ui, entry, typing, value);
    typing.entry = 0;
    value = taken;
    // Esc takes the steps of arrows back with it.
    ui.field.nudges_on = text == typing.first && ui.field.nudged == entry.label;
    return value != before;
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
    ImGui::PushButtonRepeat(true);
    for (const int step : {-1, 1}) {
        ImGui::SameLine(0.0F, gap);
        if (ImGui::Button(step < 0 ? "-" : "+", {button, button})) value += step;
    }
    ImGui::PopButtonRepeat();
    value = std::clamp(value, static_cast<int>(low), static_cast<int>(high));
    ImGui::PopID();
    ImGui::EndGroup();
    return value != before;
}

}  // namespace tact
