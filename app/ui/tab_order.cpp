#include "app/ui/tab_order.h"

#include <imgui.h>
// After imgui.h.
#include <imgui_internal.h>

#include <algorithm>
#include <optional>

#include "app/ui/ui.h"

namespace tact {

namespace {

ImGuiID popup_on_top() {
    const auto& popups = ImGui::GetCurrentContext()->OpenPopupStack;
    return popups.empty() ? 0 : popups.back().PopupId;
}

// Stops that can be reached now: those of the topmost popup, or all.
std::vector<TabStop> reachable(const std::vector<TabStop>& stops) {
    const ImGuiContext& imgui = *ImGui::GetCurrentContext();
    if (imgui.OpenPopupStack.empty()) return stops;
    const ImGuiWindow* over = imgui.OpenPopupStack.back().Window;
    std::vector<TabStop> within;
    std::ranges::copy_if(stops, std::back_inserter(within), [over](const TabStop& stop) {
        return over != nullptr && stop.window->RootWindow == over->RootWindow;
    });
    return within;
}

std::optional<std::size_t> focused_among(const std::vector<TabStop>& stops) {
    const ImGuiContext& imgui = *ImGui::GetCurrentContext();
    const ImGuiID focus = imgui.ActiveId != 0 ? imgui.ActiveId : imgui.NavId;
    const auto found = std::ranges::find(stops, focus, &TabStop::id);
    if (focus == 0 || found == stops.end()) return std::nullopt;
    return static_cast<std::size_t>(found - stops.begin());
}

bool is_number(const TabOrder& order, const TabStop& stop) {
    return std::ranges::find(order.numbers, stop.id) != order.numbers.end();
}

// The next stop, cyclic. Without a focus, the first one, or the last. `by_number`: the next number,
// as in a table.
std::size_t next_stop(const std::vector<TabStop>& stops, const TabOrder& order, bool by_number) {
    const int step = order.step;
    const std::size_t count = stops.size();
    const auto from = order.has_begun ? focused_among(stops) : std::nullopt;
    if (!from) return step > 0 ? 0 : count - 1;
    const auto after = [&](std::size_t k) { return (k + count + (step > 0 ? 1 : -1)) % count; };
    const auto pane = [&](std::size_t k) { return stops[k].window->RootWindow; };
    std::size_t to = after(*from);
    if (by_number) {
        std::size_t number = to;
        while (number != *from && pane(number) == pane(*from) && !is_number(order, stops[number])) {
            number = after(number);
        }
        return number != *from && pane(number) == pane(*from) ? number : to;
    }
    if (!order.by_pane) return to;
    while (to != *from && pane(to) == pane(*from)) to = after(to);
    // The first stop of the next pane, in either direction.
    while (after(to) != to && step < 0 && pane(after(to)) == pane(to) && after(to) != *from) {
        to = after(to);
    }
    return to;
}

void focus_on(const TabStop& stop) {
    ImGuiContext& imgui = *ImGui::GetCurrentContext();
    const ImRect place{stop.left, stop.top, stop.right, stop.bottom};
    ImGui::ClearActiveID();  // its text is accepted
    ImGui::FocusWindow(stop.window);
    ImGui::SetNavID(stop.id, ImGuiNavLayer_Main, 0, ImGui::WindowRectAbsToRel(stop.window, place));
    ImGui::ScrollToBringRectIntoView(stop.window, place);
    imgui.NavDisableHighlight = false;
    if (!stop.is_typed_in) return;
    imgui.NavNextActivateId = stop.id;
    imgui.NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
}

void frame_focus(Ui& ui) {
    const Theme& theme = ui.theme;
    const ImGuiContext& imgui = *ImGui::GetCurrentContext();
    ImGuiWindow* window = imgui.NavWindow;
    if (window == nullptr || imgui.NavId == 0 || imgui.NavDisableHighlight) return;
    if (imgui.NavLayer != ImGuiNavLayer_Main) return;
    const ImRect place = ImGui::WindowRectRelToAbs(window, window->NavRectRel[imgui.NavLayer]);
    const float out = 2.0F * theme.scale;
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    list.PushClipRect(window->OuterRectClipped.Min, window->OuterRectClipped.Max);
    list.AddRect({place.Min.x - out, place.Min.y - out}, {place.Max.x + out, place.Max.y + out},
                 theme.accent, theme.rounding_px, 0, 2.0F * theme.hairline_px);
    list.PopClipRect();
    note_rect(ui.rects, "focus", place.Min, place.Max);
}

}  // namespace

void note_stop(TabOrder& order) {
    const ImGuiContext& imgui = *ImGui::GetCurrentContext();
    const ImGuiLastItemData& item = imgui.LastItemData;
    constexpr ImGuiItemFlags kNone =
        ImGuiItemFlags_Disabled | ImGuiItemFlags_NoNav | ImGuiItemFlags_NoTabStop;
    ImGuiWindow* window = imgui.CurrentWindow;
    // A multi-line text field has the flags of a group while it is active.
    const bool is_none = (item.InFlags & kNone) != 0 && item.ID != imgui.ActiveId;
    if (item.ID == 0 || is_none) return;
    const bool is_typed_in = (item.InFlags & ImGuiItemFlags_Inputable) != 0;
    // Windows with keys of their own have only text fields as stops.
    if (!is_typed_in && (window->Flags & ImGuiWindowFlags_NoNavInputs) != 0) return;
    if (window->DC.NavLayerCurrent != ImGuiNavLayer_Main) return;
    if (!order.stops.empty() && order.stops.back().id == item.ID) return;
    const ImRect& place = item.Rect;
    order.stops.push_back(
        {window, item.ID, place.Min.x, place.Min.y, place.Max.x, place.Max.y, is_typed_in});
}

void move_focus(Ui& ui) {
    TabOrder& order = ui.rects.tab_order;
    const std::vector<TabStop> stops =
        ui.keyboard_mode ? reachable(order.stops) : std::vector<TabStop>();
    if (order.step != 0 && !stops.empty()) {
        const NumberTyping& typing = ui.field.typing;
        const bool by_number = typing.entry != 0 && !order.by_pane &&
                               (typing.by_number || typing.text != typing.first);
        const TabStop& stop = stops[next_stop(stops, order, by_number)];
        focus_on(stop);
        ui.field.tabbed_on = by_number && is_number(order, stop);
    }
    const auto focused = focused_among(stops);
    const bool has_begun = order.has_begun || order.step != 0;
    const unsigned over = popup_on_top();
    const bool is_new = over != 0 && over != order.over;  // a popup begins at its first control
    order = {};
    order.has_begun = has_begun && !is_new;
    order.over = over;
    order.is_on_button = focused && !stops[*focused].is_typed_in;
    if (ui.keyboard_mode && !ui.as_picture) frame_focus(ui);
}

}  // namespace tact
