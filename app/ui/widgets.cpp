#include "app/ui/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "app/ui/parts.h"
#include "model/text/shown_text.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

ImVec4 colour4(ImU32 colour) { return ImGui::ColorConvertU32ToFloat4(colour); }

constexpr float kTooltipPx = 320.0F;

// Below its item, or above at the bottom of the screen; beside the menu for a row of a menu: never
// over the next item to press. For a whole picture it stands at the mouse.
void place_tooltip(const Theme& theme, const char* text) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    if (high.y - low.y > 3.0F * ImGui::GetFrameHeight()) return;
    const ImVec2 pad = ImGui::GetStyle().WindowPadding;
    const float width = kTooltipPx * theme.scale - pad.x;
    const ImVec2 size = ImGui::CalcTextSize(text, nullptr, false, width) + pad * 2.0F;
    const ImVec2 room = ImGui::GetIO().DisplaySize - size;
    const float gap = 0.5F * theme.gap_px;
    const ImGuiWindow& window = *ImGui::GetCurrentWindowRead();
    const auto kind = window.Flags & (ImGuiWindowFlags_Popup | ImGuiWindowFlags_Modal);
    ImVec2 place{low.x, high.y + gap <= room.y ? high.y + gap : low.y - gap - size.y};
    if (kind == ImGuiWindowFlags_Popup) {
        const float beside = window.Pos.x + window.Size.x + gap;
        place = {beside <= room.x ? beside : window.Pos.x - gap - size.x, low.y};
    }
    ImGui::SetNextWindowPos({std::clamp(place.x, 0.0F, std::max(0.0F, room.x)),
                             std::clamp(place.y, 0.0F, std::max(0.0F, room.y))});
}

// The longest form that fits, or none: half a number would be wrong.
std::string fitting(const std::vector<std::string>& forms, const ImFont* font, float room_px) {
    for (const std::string& form : forms) {
        if (text_size(font, form).x <= room_px) return form;
    }
    return {};
}

// Part of a name is better than nothing, if it can be recognised.
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

// Only a pane of several can be maximised: with a single one, *Fold* leads to the others, and in a
// narrow window buttons do.
bool is_alone(const Theme& theme, const Layout& layout, Pane pane) {
    return is_narrow(theme) ||
           (layout.arrangement == Arrangement::physiology && pane == Pane::physiology);
}

// Room that the detail leaves to the right end, which shows a state, such as several edited
// patterns.
float kept_px(const ImFont* font, const std::vector<std::string>& forms, float gap_px) {
    return forms.empty() || forms.back().empty() ? 0.0F : text_size(font, forms.back()).x + gap_px;
}

// The title has precedence; the detail gets the rest beside the shortest form of the right end, and
// the right end the rest of both.
void draw_pane_title(Ui& ui, Layout& layout, Pane pane, const PaneTitle& title) {
    const Theme& theme = ui.theme;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{ImGui::GetContentRegionAvail().x, text_size(theme.fonts.title, "0").y};
    const Fonts& fonts = theme.fonts;
    const std::string head = shortened(fonts.title, title.title, size.x);
    float used = text_size(fonts.title, head).x + theme.gap_px;
    draw_title_part(ui, fonts.title, corner, theme.text, head, "title text:" + title.title);
    // On the line of the title.
    const float lower = 0.8F * (size.y - text_size(fonts.regular, "0").y);
    float end_px = size.x;
    constexpr const char* kRestore = "Restore";
    if (layout.maximised == pane && !is_alone(theme, layout, pane)) {
        end_px -= text_size(fonts.regular, kRestore).x;
        ImGui::SetCursorScreenPos(corner + ImVec2{end_px, lower});
        if (link(ui, {.id = "link:restore",
                      .label = kRestore,
                      .tip = "All panes again (F6). A double click on the title does it, too."})) {
            layout.maximised.reset();
        }
        end_px -= 2.0F * theme.gap_px;
        ImGui::SetCursorScreenPos(corner);
    }
    const float kept = kept_px(fonts.regular, title.right, 2.0F * theme.gap_px);
    const std::string detail = cut(title.detail, fonts.regular, end_px - used - kept);
    draw_title_part(ui, fonts.regular, corner + ImVec2{used, lower}, theme.dim_text, detail,
                    "title detail:" + title.title);
    if (!detail.empty()) used += text_size(fonts.regular, detail).x + 2.0F * theme.gap_px;
    const std::string right = fitting(title.right, fonts.regular, end_px - used);
    const float right_px = text_size(fonts.regular, right).x;
    draw_title_part(ui, fonts.regular, corner + ImVec2{end_px - right_px, lower}, theme.dim_text,
                    right, "title right:" + title.title);
    ImGui::Dummy(size);
    const bool over = ImGui::IsWindowHovered() && ImGui::IsMouseHoveringRect(corner, corner + size);
    if (over && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && !ImGui::IsAnyItemActive()) {
        layout.maximised = layout.maximised ? std::nullopt : std::optional(pane);
    }
    const std::string told = title.right.empty() ? "" : title.right.front();
    note_rect(ui.rects, "title:" + title.title, corner, corner + size, told);
    if (!told.empty()) read_out(ui, title.title + ": " + told);
}

// Points have a dark background to glow on.
void draw_ground(const Theme& theme, const Rect& area) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(area.min, area.max);  // ImGui's own leaves half of the padding out
    const int first = list.VtxBuffer.Size;
    list.AddRectFilled(area.min, area.max, theme.pane, theme.pane_rounding_px);
    const ImU32 low = theme.is_dark ? mixed(theme.pane, IM_COL32_BLACK, 0.28F)
                                    : mixed(theme.pane, theme.dim_text, 0.10F);
    ImGui::ShadeVertsLinearColorGradientKeepAlpha(&list, first, list.VtxBuffer.Size, area.min,
                                                  {area.min.x, area.max.y}, theme.pane, low);
    list.PopClipRect();
}

}  // namespace

ImGuiWindowFlags sideways_if_narrow(const Ui& ui, float width_px) {
    constexpr float kNarrowPx = 180.0F;
    return width_px < kNarrowPx * ui.theme.scale ? ImGuiWindowFlags_HorizontalScrollbar
                                                 : ImGuiWindowFlags_None;
}

void draw_pane(Ui& ui, Layout& layout, Pane pane, const Rect& area, const PaneTitle& title,
               const std::function<void()>& content) {
    ImGui::SetNextWindowPos(area.min);
    ImGui::SetNextWindowSize(area.size());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.theme.pane_rounding_px);
    // It scrolls if large text makes its content too wide.
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                        ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus;
    const std::string id = "pane " + std::to_string(static_cast<int>(pane));
    if (ImGui::Begin(id.c_str(), nullptr, kFlags | sideways_if_narrow(ui, area.width()))) {
        note_rect(ui.rects, "pane:" + title.title, area.min, area.max);
        if (title.has_ground) draw_ground(ui.theme, area);
        draw_pane_title(ui, layout, pane, title);
        content();
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

bool is_narrow(const Theme& theme) {
    constexpr float kNarrowPx = 560.0F;
    return ImGui::GetIO().DisplaySize.x < kNarrowPx * theme.scale;
}

bool is_item_disabled() { return (ImGui::GetItemFlags() & ImGuiItemFlags_Disabled) != 0; }

void draw_divider(const Theme& theme) {
    const ImGuiWindow& window = *ImGui::GetCurrentWindow();
    const float thick = whole_px(theme.hairline_px);
    // From edge to edge of its window, like ImGui's own, which is one pixel at every scale.
    draw_level_line(*ImGui::GetWindowDrawList(), ImGui::GetCursorScreenPos().y + 0.5F * thick,
                    window.Pos.x, window.Pos.x + window.Size.x, thick,
                    ImGui::GetColorU32(ImGuiCol_Separator));
    ImGui::Dummy({0.0F, thick - 1.0F});
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
    if (ui.presenting || ui.dismissed_hints.contains(id)) return;
    ImGui::PushID(id);
    ImGui::PushStyleColor(ImGuiCol_Text, colour4(ui.theme.dim_text));
    const float button = ImGui::GetContentRegionMax().x - button_width("\u00d7");
    ImGui::PushTextWrapPos(button - ui.theme.gap_px);
    ImGui::PushFont(ui.theme.fonts.fine);
    ImGui::TextUnformatted(text);
    ImGui::PopFont();
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::SameLine(button);
    if (small_button(
            ui, {.id = std::string("hint:") + id, .label = "\u00d7", .tip = "Dismiss this hint"})) {
        ui.dismissed_hints.insert(id);
    }
    ImGui::PopID();
}

void draw_tooltip(const Ui& ui, const char* text) {
    constexpr double kRestS = 0.6;
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    if (ImGui::GetIO().MouseDown[0] || ui.has_pressed) return;
    if (ImGui::IsItemActive()) return;  // the person who types needs to see the neighbourhood
    if (ui.time_s - ui.hover_since_s < kRestS) return;
    // It looks the same over items that are disabled, coloured or in small letters.
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1.0F);
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.text);
    ImGui::PushFont(ui.theme.fonts.regular);
    place_tooltip(ui.theme, text);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(kTooltipPx * ui.theme.scale);
    ImGui::TextUnformatted(shown_lines(text).c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopFont();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
}

void open_beside_pane(const Theme& theme, float width_px) {
    const ImGuiWindow* pane = ImGui::GetCurrentWindowRead()->RootWindow;
    const float top = ImGui::GetItemRectMin().y;
    const float gap = theme.gap_px;
    const float right = pane->Pos.x + pane->Size.x + gap;
    const bool at_right = right + width_px <= ImGui::GetIO().DisplaySize.x;
    const bool at_left = !at_right && pane->Pos.x - width_px - gap >= 0.0F;
    if (!at_left && !at_right) {
        // Over the end of the pane: buttons and fields stand at its beginning.
        return ImGui::SetNextWindowPos({right - 2.0F * gap, top}, ImGuiCond_Appearing,
                                       {1.0F, 0.0F});
    }
    ImGui::SetNextWindowPos({at_left ? pane->Pos.x - gap : right, top}, ImGuiCond_Appearing,
                            {at_left ? 1.0F : 0.0F, 0.0F});
}

bool draw_menu_row(const Theme& theme, const MenuRow& row) {
    // Keys stand clear of the longest words.
    constexpr float kBeforeKeysPx = 24.0F;
    const float room_px = kBeforeKeysPx * theme.scale - ImGui::GetStyle().ItemSpacing.x;
    ImGui::GetCurrentWindow()->DC.MenuColumns.DeclColumns(
        0.0F, ImGui::CalcTextSize(row.words, nullptr, true).x + room_px, 0.0F, 0.0F);
    // As wide as a sign: ImGui moves the words of all rows of the menu by it.
    const char* room = row.icon ? "     " : nullptr;
    const bool chosen = ImGui::MenuItemEx(row.words, room, row.keys, row.checked, row.enabled);
    if (row.icon) {
        const ImVec2 low = ImGui::GetItemRectMin();
        const float middle = 0.5F * (low.y + ImGui::GetItemRectMax().y);
        const float size = 11.0F * theme.scale;
        draw_icon(*ImGui::GetWindowDrawList(), *row.icon,
                  {low.x + 0.5F * (ImGui::GetStyle().ItemSpacing.x + size), middle}, size,
                  row.enabled ? theme.text : theme.dim_text);
    }
    return chosen;
}

void right_aligned(const std::string& text) {
    const float left = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    if (left > 0.0F) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + left);
    ImGui::TextUnformatted(shown_lines(text).c_str());
}

void dim_text(const Ui& ui, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour4(ui.theme.dim_text));
    ImGui::TextUnformatted(shown_lines(text).c_str());
    ImGui::PopStyleColor();
}

void dim_text_beside(const Ui& ui, const std::string& text) {
    flow_on(text_size(ui.theme.fonts.small, text).x, ui.theme.gap_px);
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, text);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

void wrapped_text(const std::string& text) {
    // The window may scale the font; lines are measured unscaled.
    const float scale = ImGui::GetFontSize() / ImGui::GetFont()->FontSize;
    std::string lines;
    for (const std::string& line :
         wrapped(ImGui::GetFont(), shown_lines(text), ImGui::GetContentRegionAvail().x / scale)) {
        lines += (lines.empty() ? "" : "\n") + line;
    }
    ImGui::TextUnformatted(lines.c_str());
}

bool draw_empty_with(Ui& ui, const Rect& area, const char* title, const std::string& reason,
                     const Item& item, bool is_primary) {
    const Theme& theme = ui.theme;
    const float below = ImGui::GetFrameHeight() + 1.5F * theme.gap_px;
    const Rect words{area.min, {area.max.x, std::max(area.min.y + 1.0F, area.max.y - below)}};
    draw_empty(*ImGui::GetWindowDrawList(), theme, words, title, reason);
    const auto lines = wrapped(theme.fonts.small, reason, area.width()).size();
    const float words_px = static_cast<float>(lines) * text_size(theme.fonts.small, "0").y;
    ImGui::SetCursorScreenPos({words.centre().x - 0.5F * button_width(item.label.c_str()),
                               words.centre().y + words_px + 1.5F * theme.gap_px});
    return is_primary ? primary_button(ui, item) : button(ui, item);
}

void coloured_text(ImU32 colour, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(shown_lines(text).c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

std::string label_of(const std::string& name) {
    std::string label = shown_text(name);
    for (std::size_t at = label.find("##"); at != label.npos; at = label.find("##", at)) {
        label.insert(at + 1, " ");
    }
    return label;
}

Rect rest_of_pane() {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    return rect_at(corner, ImGui::GetContentRegionAvail());
}

}  // namespace tact
