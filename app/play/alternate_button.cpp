#include "app/play/parts.h"

#include <array>
#include <string>

#include "app/document/workspace.h"
#include "app/play/play.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kSides = 1.5F;    // width of the letters alone, in units of its height
constexpr float kNamePx = 84.0F;  // width of every name: longer names end in three dots
constexpr float kMarkPx = 4.5F;   // radius

// "A", mark and name, "|", and the same for B.
struct Sides {
    std::array<std::string, 2> names;  // as shown
    std::array<std::string, 2> whole;
    std::array<PatternLook, 2> looks;
};

std::optional<Sides> sides_of(const Ui& ui, const Workspace& work, const ShownMap& shown_map,
                              const PlayState& play) {
    const auto pair = alternating_pair(work, shown_map, play);
    if (!pair) return std::nullopt;
    Sides sides;
    sides.whole = {pair->first, pair->second};
    for (std::size_t k = 0; k < 2; ++k) {
        const auto place = place_named(work.document.set, sides.whole[k]);
        if (!place) return std::nullopt;
        sides.looks[k] = look_of(ui, work, *place);
        sides.names[k] =
            shortened(ui.theme.fonts.regular, sides.whole[k], kNamePx * ui.theme.scale);
    }
    return sides;
}

float letter_width(const Ui& ui, const char* letter) {
    return text_size(ui.theme.fonts.semibold, letter).x;
}

float mark_room(const Ui& ui) { return (2.0F * kMarkPx + 9.0F) * ui.theme.scale; }

float name_room(const Ui& ui) { return mark_room(ui) + kNamePx * ui.theme.scale; }

// The side that plays now.
std::optional<std::size_t> sounding_side(const PlayState& play) {
    const std::optional<Sounding>& sounding = play.sounding;
    if (!sounding || sounding->names.size() != 2 || sounding->rests_until_s) return std::nullopt;
    return sounding->at;
}

// Mark and name; a dash without a pattern.
void draw_name(const Ui& ui, const std::optional<Sides>& sides, std::size_t side, ImVec2 corner,
               ImU32 ink) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 text{corner.x + mark_room(ui), corner.y + ImGui::GetStyle().FramePadding.y};
    if (!sides) return draw_text(list, theme.fonts.regular, text, theme.dim_text, "\u2013");
    draw_pattern_mark(list, theme,
                      {corner.x + 0.5F * mark_room(ui), corner.y + 0.5F * ImGui::GetFrameHeight()},
                      kMarkPx * theme.scale, sides->looks[side], theme.pane);
    draw_text(list, theme.fonts.regular, text, ink, sides->names[side]);
}

void draw_sides(const Ui& ui, const PlayState& play, const std::optional<Sides>& sides, bool names,
                ImVec2 corner, float width) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool in_turn = play.sounding && play.sounding->names.size() == 2;
    const auto sounds = sounding_side(play);
    const float gap = names ? 0.75F * theme.gap_px : 0.0F;
    float inner = 2.0F * gap + (names ? 2.0F * name_room(ui) : 0.0F);
    for (const char* letter : {"A", "|", "B"}) inner += letter_width(ui, letter);
    float x = corner.x + 0.5F * (width - inner);
    const float y = corner.y + ImGui::GetStyle().FramePadding.y;
    for (std::size_t k = 0; k < 2; ++k) {
        const bool is_bright = sounds == k || (play.alternates && !in_turn);
        const ImU32 ink = is_bright ? theme.accent : in_turn ? theme.dim_text : theme.text;
        const char* letter = k == 0 ? "A" : "B";
        draw_text(list, theme.fonts.semibold, {x, y}, ink, letter);
        x += letter_width(ui, letter);
        if (names) {
            draw_name(ui, sides, k, {x, corner.y},
                      in_turn && sounds != k ? theme.dim_text : theme.text);
            x += name_room(ui);
        }
        if (k == 1) break;
        const float end = x + letter_width(ui, "|") + 2.0F * gap;
        // A short name stands in the middle of its room.
        const float unused = names && sides ? kNamePx * theme.scale -
                                                  text_size(theme.fonts.regular, sides->names[0]).x
                                            : 0.0F;
        draw_text(list, theme.fonts.semibold, {x + gap - 0.5F * unused, y}, theme.dim_text, "|");
        x = end;
    }
}

}  // namespace

float alternate_width(const Ui& ui, bool names) {
    const float letters = kSides * ImGui::GetFrameHeight();
    return names ? letters + 1.5F * ui.theme.gap_px + 2.0F * name_room(ui) : letters;
}

void draw_alternate(Ui& ui, const Workspace& work, const ShownMap& shown_map, PlayState& play,
                    bool names) {
    const Theme& theme = ui.theme;
    const auto known = sides_of(ui, work, shown_map, play);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size{alternate_width(ui, names), ImGui::GetFrameHeight()};
    if (ImGui::InvisibleButton("alternate", size)) toggle_alternating(play);
    const bool over = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    note_item(ui.rects, "transport:A|B", play.alternates ? "on" : "off");
    if (known) {
        note_item(ui.rects, "alternate:pair", "A " + known->whole[0] + " | B " + known->whole[1]);
    }
    std::string tip = known ? "A is " + known->whole[0] + ", B is " + known->whole[1] + ". " : "";
    tip +=
        "Plays the current pattern, A, and its partner, B, in turn; X swaps them. The partner is "
        "the pattern compared with; without one, the pattern chosen in the matrix or map, or the "
        "closest one.";
    draw_tooltip(ui, tip.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (play.alternates || over) {
        list.AddRectFilled(corner, corner + size,
                           play.alternates ? faded(theme.accent, 0.28F) : theme.hover,
                           theme.rounding_px);
    }
    draw_sides(ui, play, known, names, corner, size.x);
    ImGui::SameLine(0.0F, theme.gap_px * 0.5F);
}

}  // namespace tact
