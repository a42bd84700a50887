#include "app/ui/ui.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <optional>
#include <utility>

namespace tact {

void say(Ui& ui, const std::string& text) { ui.status = {text, false, ui.time_s}; }

void complain(Ui& ui, const std::string& text) { ui.status = {text, true, ui.time_s}; }

void set_text_scale(Ui& ui, float scale) {
    ui.text_scale = scale;
    ui.fonts_outdated = true;
}

void step_text_scale(Ui& ui, float factor) {
    set_text_scale(ui, std::clamp(ui.text_scale * factor, 0.75F, 2.0F));
}

void set_theme(Ui& ui, bool dark) {
    ui.dark = dark;
    ui.fonts_outdated = true;  // the theme is made again with them
}

constexpr double kBehindS = 0.3;

bool looks_stale(Ui& ui, const std::string& pane, std::shared_ptr<const void> shown, bool stale) {
    if (ui.as_picture) return stale;
    ShownAge& age = ui.ages[pane];
    const bool goes_on = stale && age.stale && age.of == shown;
    age = {std::move(shown), stale, goes_on ? age.since_s : ui.time_s};
    return stale && ui.time_s - age.since_s >= kBehindS;
}

double aging_wake_s(const Ui& ui) {
    double wake_s = std::numeric_limits<double>::infinity();
    for (const auto& [pane, age] : ui.ages) {
        const double left_s = age.since_s + kBehindS - ui.time_s;
        if (age.stale && left_s > 0.0) wake_s = std::min(wake_s, left_s + 0.001);
    }
    return wake_s;
}

WidgetRects widget_rects_wanted() {
    const char* file = std::getenv("TACTSPACE_WIDGET_RECTS");  // NOLINT(concurrency-mt-unsafe)
    WidgetRects rects;
    if (file != nullptr) rects.file = file;
    return rects;
}

void note_rect(WidgetRects& rects, const std::string& name, ImVec2 min, ImVec2 max,
               const std::string& value) {
    if (!rects.watched.empty() && name == rects.watched) rects.watched_at = Rect{min, max};
    if (rects.file.empty()) return;
    // In its first frame, a list that opens is only measured, at another place.
    if (ImGui::GetCurrentWindowRead()->Hidden) return;
    const auto pixel = [](float position) { return std::to_string(static_cast<int>(position)); };
    std::string line = value;
    std::ranges::replace(line, '\n', ' ');
    rects.lines += name + "\t" + pixel(min.x) + "\t" + pixel(min.y) + "\t" + pixel(max.x) + "\t" +
                   pixel(max.y) + "\t" + line + "\n";
}

void note_item(WidgetRects& rects, const std::string& name, const std::string& value) {
    note_stop(rects.tab_order);
    note_rect(rects, name, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), value);
}

void write_rects(WidgetRects& rects) {
    if (rects.file.empty()) return;
    if (ImGui::IsMousePosValid())
        note_rect(rects, "pointer", ImGui::GetMousePos(), ImGui::GetMousePos());
    if (rects.lines != rects.written) {
        // Renamed into place, so that a reader never sees half a file.
        std::filesystem::path fresh = rects.file;
        fresh += ".new";
        std::ofstream(fresh) << rects.lines;
        std::error_code ignored;
        std::filesystem::rename(fresh, rects.file, ignored);
    }
    rects.written = std::exchange(rects.lines, {});
}

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
