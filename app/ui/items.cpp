// Widgets that say themselves: buttons, links, segments, rings, boxes, chips, rows of lists, texts.
#include <imgui_internal.h>

#include <cmath>

#include "app/ui/parts.h"
#include "app/ui/widgets.h"
#include "model/text/shown_text.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kSegmentPadPx = 9.0F;
constexpr float kSegmentIconPx = 25.0F;  // with the gap behind it
constexpr float kChipPadPx = 5.0F;
constexpr float kChipPadYPx = 3.0F;
constexpr float kBoxPx = 14.0F;
constexpr float kBoxGapPx = 7.0F;

void draw_box(const Theme& theme, ImVec2 corner, float size_px, bool on, bool lit) {
    // GetColorU32 fades disabled items.
    const auto ink = [](ImU32 colour) { return ImGui::GetColorU32(colour); };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 far_corner = corner + ImVec2{size_px, size_px};
    const float rounding = 3.0F * theme.scale;
    list.AddRectFilled(corner, far_corner, ink(on ? theme.accent : theme.field), rounding);
    if (!on || lit) {
        const ImU32 edge = on ? theme.text : lit ? theme.accent : theme.dim_text;
        list.AddRect(corner, far_corner, ink(edge), rounding, 0, whole_px(theme.hairline_px));
    }
    if (!on) return;
    const ImVec2 tick[] = {corner + ImVec2{0.23F, 0.53F} * size_px,
                           corner + ImVec2{0.42F, 0.72F} * size_px,
                           corner + ImVec2{0.78F, 0.30F} * size_px};
    list.AddPolyline(tick, 3, ink(readable_on(theme.accent)), 0, 1.8F * theme.scale);
}

// A word in small type on a highlighted plate, in the middle of this height.
bool draw_plate(const Ui& ui, const Item& item, bool lit, float height_px, bool has_edge) {
    const Theme& theme = ui.theme;
    const std::string& text = item.label;
    const ImVec2 pad{kChipPadPx * theme.scale, kChipPadYPx * theme.scale};
    const ImVec2 plate = text_size(theme.fonts.small, text) + pad * 2.0F;
    const ImVec2 top = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(item.id.c_str(), {plate.x, height_px});
    const bool over = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    const ImVec2 corner{top.x, top.y + std::round(0.5F * (height_px - plate.y))};
    // GetColorU32 fades disabled items.
    const auto ink = [](ImU32 colour) { return ImGui::GetColorU32(colour); };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (lit) {
        list.AddRectFilled(corner, corner + plate, ink(faded(theme.accent, 0.28F)),
                           theme.rounding_px);
    }
    // Under the mouse it gets an edge, never the background of the chosen one.
    if (has_edge || over) {
        const ImU32 edge = lit && has_edge ? ink(theme.accent)
                           : over          ? ink(theme.dim_text)
                                           : ImGui::GetColorU32(ImGuiCol_Border);
        list.AddRect(corner, corner + plate, edge, theme.rounding_px, 0, theme.hairline_px);
    }
    draw_text(list, theme.fonts.small, corner + pad, ink(lit ? theme.text : theme.dim_text), text);
    if (over) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return pressed;
}

enum class LinkTo { action, name };

// With this room above and below the words. An action is a quiet button: its background reaches a
// little beyond the words, so that these stay aligned.
bool draw_link(const Ui& ui, const Item& item, float pad_px, LinkTo to = LinkTo::action) {
    const char* const text = item.label.c_str();
    const ImVec2 size = ImGui::CalcTextSize(text);
    const ImVec2 corner = ImGui::GetCursorScreenPos() + ImVec2{0.0F, pad_px};
    const bool pressed = ImGui::InvisibleButton(item.id.c_str(), {size.x, size.y + 2.0F * pad_px});
    const bool lit = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    const bool is_name = to == LinkTo::name;
    // GetColorU32 fades disabled items.
    const ImU32 ink = ImGui::GetColorU32(is_item_disabled() ? ui.theme.dim_text
                                         : is_name          ? ui.theme.accent
                                                            : ui.theme.text);
    if (!is_name) {
        const ImVec2 beyond{3.0F * ui.theme.scale, ui.theme.scale};
        const ImU32 ground = lit ? ui.theme.hover : faded(ui.theme.text, 0.07F);
        ImGui::GetWindowDrawList()->AddRectFilled(corner - beyond, corner + size + beyond,
                                                  ImGui::GetColorU32(ground), ui.theme.rounding_px);
    }
    ImGui::GetWindowDrawList()->AddText(corner, ink, text);
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (lit && is_name) {
        const float thick = whole_px(ui.theme.hairline_px);
        draw_level_line(*ImGui::GetWindowDrawList(), corner.y + size.y + 0.5F * thick, corner.x,
                        corner.x + size.x, thick, ink);
    }
    return pressed;
}

// Disabled it looks like any other button.
bool draw_primary(Ui& ui, const char* label, ImVec2 size) {
    const Theme& theme = ui.theme;
    const ImGuiItemFlags flags = ImGui::GetCurrentContext()->CurrentItemFlags;
    if ((flags & ImGuiItemFlags_Disabled) != 0) return ImGui::Button(label, size);
    ImGui::PushStyleColor(ImGuiCol_Button, theme.accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, mixed(theme.accent, theme.text, 0.15F));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, mixed(theme.accent, theme.text, 0.30F));
    ImGui::PushStyleColor(ImGuiCol_Text, readable_on(theme.accent));
    const bool pressed = ImGui::Button(label, size);
    ImGui::PopStyleColor(4);
    note_item(ui.rects, "primary:" + std::string(label, ImGui::FindRenderedTextEnd(label)));
    return pressed;
}

bool draw_segment(const Ui& ui, const char* words, bool chosen, std::optional<Icon> icon) {
    const Theme& theme = ui.theme;
    const ImVec2 size{segment_width(ui, words, bool(icon)), ImGui::GetFrameHeight()};
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(words, size);
    const bool lit = ImGui::IsItemHovered() || (ui.keyboard_mode && ImGui::IsItemFocused());
    // GetColorU32 fades disabled items.
    const auto ink = [](ImU32 colour) { return ImGui::GetColorU32(colour); };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, corner + size, ink(theme.field));
    if (chosen) {
        list.AddRectFilled(corner, corner + size, ink(faded(theme.accent, 0.34F)),
                           theme.rounding_px);
        list.AddRect(corner, corner + size, ink(theme.accent), theme.rounding_px, 0,
                     theme.hairline_px);
    } else if (lit) {
        list.AddRectFilled(corner, corner + size, ink(theme.hover), theme.rounding_px);
    }
    const ImU32 colour = ink(chosen || lit ? theme.text : theme.dim_text);
    float left = kSegmentPadPx * theme.scale;
    if (icon) {
        const ImVec2 middle{left + 9.0F * theme.scale, 0.5F * size.y};
        draw_icon(list, *icon, corner + middle, 12.0F * theme.scale, colour);
        left += kSegmentIconPx * theme.scale;
    }
    list.AddText(corner + ImVec2{left, ImGui::GetStyle().FramePadding.y}, colour, words);
    if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return pressed;
}

bool draw_radio(const Ui& ui, const char* label, bool chosen) {
    const Theme& theme = ui.theme;
    const float s = theme.scale;
    const ImVec2 size{18.0F * s + ImGui::CalcTextSize(label).x, ImGui::GetFrameHeight()};
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(label, size);
    const bool lit = ImGui::IsItemHovered() || (ui.keyboard_mode && ImGui::IsItemFocused());
    // GetColorU32 fades disabled items.
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

bool draw_check(const Theme& theme, const char* label, bool& on) {
    ImGuiWindow& window = *ImGui::GetCurrentWindow();
    if (window.SkipItems) return false;
    const ImVec2 corner = window.DC.CursorPos;
    const float pad = ImGui::GetStyle().FramePadding.y;
    const ImRect area{corner, corner + ImVec2{check_width(theme, label), ImGui::GetFrameHeight()}};
    const ImGuiID id = window.GetID(label);
    ImGui::ItemSize(area, pad);  // words beside it stand on its line
    if (!ImGui::ItemAdd(area, id)) return false;
    bool over = false;
    bool held = false;
    const bool pressed = ImGui::ButtonBehavior(area, id, &over, &held);
    if (pressed) {
        on = !on;
        ImGui::MarkItemEdited(id);
    }
    const float box = whole_px(kBoxPx * theme.scale);
    const ImVec2 at{std::round(corner.x),
                    std::round(corner.y + 0.5F * (ImGui::GetFrameHeight() - box))};
    draw_box(theme, at, box, on, over || ImGui::IsItemFocused());
    const ImVec2 words{corner.x + box + kBoxGapPx * theme.scale, corner.y + pad};
    ImGui::GetWindowDrawList()->AddText(words, ImGui::GetColorU32(theme.text), label,
                                        ImGui::FindRenderedTextEnd(label));
    return pressed;
}

// Words, and the name that ImGui knows an item by.
std::string named(const Item& item) { return label_of(item.label) + "###" + item.id; }

template <class Draw>
bool drawn(Ui& ui, const Item& item, const Draw& draw) {
    const bool is_disabled = !item.enabled || !item.why_not.empty();
    ImGui::BeginDisabled(is_disabled);
    const bool pressed = draw();
    say_of_last_item(ui, {.id = item.id,
                          .text = item.label,
                          .tip = item.why_not.empty() ? item.tip : item.why_not,
                          .value = item.value});
    ImGui::EndDisabled();
    return pressed && !is_disabled;
}

}  // namespace

float segment_width(const Ui& ui, const char* words, bool has_icon) {
    const float pads_px = 2.0F * kSegmentPadPx + (has_icon ? kSegmentIconPx : 0.0F);
    return std::round(ImGui::CalcTextSize(words).x + pads_px * ui.theme.scale);
}

float check_width(const Theme& theme, const char* label) {
    return whole_px(kBoxPx * theme.scale) + kBoxGapPx * theme.scale +
           ImGui::CalcTextSize(label, nullptr, true).x;
}

float chip_width(const Ui& ui, const char* text) {
    return text_size(ui.theme.fonts.small, text).x + 2.0F * kChipPadPx * ui.theme.scale;
}

void say_of_last_item(Ui& ui, const Said& said) {
    note_item(ui.rects, said.id, said.value.value_or(said.text));
    if (!said.tip.empty()) draw_tooltip(ui, said.tip.c_str());
}

bool button(Ui& ui, const Item& item, ImVec2 size) {
    return drawn(ui, item, [&] { return ImGui::Button(named(item).c_str(), size); });
}

bool small_button(Ui& ui, const Item& item) {
    return drawn(ui, item, [&] { return ImGui::SmallButton(named(item).c_str()); });
}

bool primary_button(Ui& ui, const Item& item, ImVec2 size) {
    return drawn(ui, item, [&] { return draw_primary(ui, named(item).c_str(), size); });
}

bool link(Ui& ui, const Item& item) {
    return drawn(ui, item, [&] { return draw_link(ui, item, 0.0F); });
}

bool row_link(Ui& ui, const Item& item) {
    return drawn(ui, item, [&] { return draw_link(ui, item, ImGui::GetStyle().FramePadding.y); });
}

bool name_link(Ui& ui, const Item& item) {
    return drawn(ui, item, [&] { return draw_link(ui, item, 0.0F, LinkTo::name); });
}

bool chip(Ui& ui, const Item& item, bool lit) {
    const float words_px = text_size(ui.theme.fonts.small, item.label).y;
    const float height_px = words_px + 2.0F * kChipPadYPx * ui.theme.scale;
    return drawn(ui, item, [&] { return draw_plate(ui, item, lit, height_px, false); });
}

bool toggle(Ui& ui, const Item& item, bool on) {
    return drawn(ui, item, [&] { return draw_plate(ui, item, on, ImGui::GetFrameHeight(), true); });
}

bool check(Ui& ui, Item item, bool& on) {
    return drawn(ui, item, [&] {
        const bool pressed = draw_check(ui.theme, named(item).c_str(), on);
        if (!item.value) item.value = on ? "on" : "off";
        return pressed;
    });
}

bool radio(Ui& ui, const Item& item, bool chosen) {
    return drawn(ui, item, [&] { return draw_radio(ui, item.label.c_str(), chosen); });
}

bool segment(Ui& ui, const Item& item, bool chosen, std::optional<Icon> icon) {
    return drawn(ui, item, [&] { return draw_segment(ui, item.label.c_str(), chosen, icon); });
}

bool option(Ui& ui, const Item& item, bool chosen, ImGuiSelectableFlags flags, ImVec2 size) {
    return drawn(ui, item,
                 [&] { return ImGui::Selectable(named(item).c_str(), chosen, flags, size); });
}

bool menu_item(Ui& ui, const Item& item, const char* keys, bool checked) {
    return drawn(ui, item, [&] { return ImGui::MenuItem(named(item).c_str(), keys, checked); });
}

void drop_down(Ui& ui, const Item& item, float width_px, const std::function<void()>& rows,
               ImGuiComboFlags flags) {
    drawn(ui, item, [&] {
        if (width_px != 0.0F) ImGui::SetNextItemWidth(width_px);
        if (!ImGui::BeginCombo(("##" + item.id).c_str(), label_of(item.label).c_str(), flags)) {
            return false;
        }
        rows();
        ImGui::EndCombo();
        return false;
    });
}

void plain_text(Ui& ui, const Said& said) {
    ImGui::TextUnformatted(shown_lines(said.text).c_str());
    say_of_last_item(ui, said);
}

void dim_text(Ui& ui, const Said& said) {
    dim_text(ui, said.text);
    say_of_last_item(ui, said);
}

void dim_text_beside(Ui& ui, const Said& said) {
    dim_text_beside(ui, said.text);
    say_of_last_item(ui, said);
}

void wrapped_text(Ui& ui, const Said& said) {
    wrapped_text(said.text);
    say_of_last_item(ui, said);
}

void coloured_text(Ui& ui, ImU32 colour, const Said& said) {
    coloured_text(colour, said.text);
    say_of_last_item(ui, said);
}

}  // namespace tact
