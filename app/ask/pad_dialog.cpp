#include "app/ask/ask.h"

#include <imgui.h>

#include <algorithm>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/set/pattern_set.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kPadPx = 300.0F;
constexpr float kMarginPx = 8.0F;  // marks reach past the pad
constexpr const char* kMixName = "mix";

std::vector<Pattern> corner_patterns(const PatternSet& set, const PadState& pad) {
    std::vector<Pattern> corners;
    for (const std::string& name : pad.corners) {
        if (const Pattern* pattern = pattern_named(set, name)) corners.push_back(*pattern);
    }
    return corners;
}

void keep_mix(const PatternSet& set, PadState& pad) {
    std::vector<Pattern> corners = corner_patterns(set, pad);
    if (corners.empty()) return;
    const bool is_same =
        pad.mixed_of == corners && pad.mixed_right == pad.right && pad.mixed_down == pad.down;
    if (is_same) return;
    pad.mix = mixed_among(corners, pad.right, pad.down);
    pad.mixed_of = std::move(corners);
    pad.mixed_right = pad.right;
    pad.mixed_down = pad.down;
}

Vibration mixed_vibration(const PadState& pad) {
    Vibration felt;
    felt.name = kMixName;
    felt.source = pad.mix;
    return felt;
}

// The point under the mouse, inside the square; its mix is played while the button is held there.
void take_pad_mouse(Ui& ui, Workspace& work, PadState& pad, const Rect& square) {
    ImGui::SetCursorScreenPos(square.min);
    ImGui::InvisibleButton("pad", square.size());
    const std::string place = fixed_digits(pad.right, 3) + " " + fixed_digits(pad.down, 3);
    note_item(ui.rects, "pad", place);
    if (!ImGui::IsItemActive()) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto share = [](float at, float from, float extent) {
        return std::clamp(static_cast<double>((at - from) / extent), 0.0, 1.0);
    };
    pad.right = share(mouse.x, square.min.x, square.width());
    pad.down = pad.mixed_of.size() > 2 ? share(mouse.y, square.min.y, square.height()) : 0.0;
    keep_mix(work.document.set, pad);
    const ImVec2 moved = ImGui::GetIO().MouseDelta;
    const bool rests = moved.x == 0.0F && moved.y == 0.0F;
    if (rests) work.selection.pressed = mixed_vibration(pad);
}

// The pattern of a corner: its mark, and its name towards the middle.
void draw_corner(const Ui& ui, const Workspace& work, const Rect& square, std::size_t k,
                 const std::string& name, bool alone_below) {
    const auto place = place_named(work.document.set, name);
    if (!place) return;
    const Theme& theme = ui.theme;
    const bool right = k % 2 == 1;
    const bool below = k >= 2;
    const float x = alone_below ? square.centre().x : right ? square.max.x : square.min.x;
    const ImVec2 at{x, below ? square.max.y : square.min.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_pattern_mark(list, theme, at, 6.0F * theme.scale, look_of(ui, work, *place), theme.hover);
    const std::string shown = shortened(theme.fonts.small, name, 0.45F * square.width());
    const ImVec2 size = text_size(theme.fonts.small, shown);
    const float off = 10.0F * theme.scale;
    const float left = alone_below ? at.x + off : right ? at.x - off - size.x : at.x + off;
    const float top = below ? at.y - off - size.y : at.y + off;
    draw_text(list, theme.fonts.small, {left, top}, theme.text, shown);
}

void draw_square(Ui& ui, const Workspace& work, const PadState& pad, const Rect& square) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(square.min, square.max, theme.field, theme.rounding_px);
    for (int k = 1; k < 4; ++k) {
        const float share = 0.25F * static_cast<float>(k);
        const ImVec2 at = square.min + square.size() * share;
        list.AddLine({at.x, square.min.y}, {at.x, square.max.y}, theme.line, theme.hairline_px);
        list.AddLine({square.min.x, at.y}, {square.max.x, at.y}, theme.line, theme.hairline_px);
    }
    const bool alone = pad.corners.size() == 3;
    for (std::size_t k = 0; k < pad.corners.size(); ++k) {
        draw_corner(ui, work, square, k, pad.corners[k], alone && k == 2);
    }
    const ImVec2 at{square.min.x + static_cast<float>(pad.right) * square.width(),
                    square.min.y + static_cast<float>(pad.down) * square.height()};
    list.AddCircleFilled(at, 7.0F * theme.scale, theme.accent);
    list.AddCircle(at, 7.0F * theme.scale, theme.text, 0, 1.5F * theme.scale);
}

// The wave of the mix, whole.
void draw_wave(Ui& ui, Workspace& work, const PadState& pad, ImVec2 corner, float width_px) {
    const Theme& theme = ui.theme;
    const float words_px = text_size(theme.fonts.small, "0").y;
    const Rect picture = rect_at(corner, {width_px, 48.0F * theme.scale});
    ImGui::SetCursorScreenPos(corner);
    ImGui::Dummy({width_px, picture.height() + 0.5F * theme.gap_px + words_px});
    draw_thumbnail(ui, work, picture, mixed_vibration(pad), theme.series, shown_reach_g(work));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = picture.max.y + 0.5F * theme.gap_px;
    const std::string end = significant_digits(pad.mix.duration_s, 3) + " s";
    draw_text(list, theme.fonts.small, {picture.min.x, y}, theme.dim_text, "0");
    draw_text(list, theme.fonts.small, {picture.max.x - text_size(theme.fonts.small, end).x, y},
              theme.dim_text, end);
}

std::string pad_words(const PadState& pad) {
    constexpr std::size_t kMostNamed = 3;
    std::string words = "Amplitude " + significant(pad.mix.amplitude_g) + " g";
    const std::vector<Carrier>& carriers = pad.mix.carriers;
    for (std::size_t k = 0; k < std::min(kMostNamed, carriers.size()); ++k) {
        const char* before = k > 0 ? ", " : carriers.size() > 1 ? "; carriers " : "; carrier ";
        words += before + significant(carriers[k].frequency_hz);
    }
    words += " Hz";
    if (carriers.size() <= kMostNamed) return words;
    return words + " and " + std::to_string(carriers.size() - kMostNamed) + " more";
}

void add_mix(Ui& ui, Workspace& work, const PadState& pad) {
    const auto first = place_named(work.document.set, pad.corners.front());
    if (!first) return;
    select_only(work, *first);
    std::string name = "mix of " + pad.corners.front();
    if (pad.corners.size() > 1) name += " and " + std::to_string(pad.corners.size() - 1) + " more";
    if (pad.corners.size() == 2) name = "mix of " + pad.corners[0] + " and " + pad.corners[1];
    Vibration kept = mixed_vibration(pad);
    kept.name = name;
    add_vibrations(ui, work, {std::move(kept)}, "Add " + name);
    say(ui, "Added " + name + ". Ctrl+Z takes it back.");
}

}  // namespace

std::vector<std::string> pad_corners(const Workspace& work) {
    std::vector<std::size_t> places{work.selection.current};
    for (const std::size_t other : selected_indices(work)) {
        if (other != work.selection.current) places.push_back(other);
    }
    std::vector<std::string> corners;
    for (const std::size_t place : places) {
        if (place >= work.document.set.vibrations.size()) continue;
        const Vibration& vibration = work.document.set.vibrations[place];
        const bool has_room = corners.size() < kMostCorners;
        if (has_room && std::holds_alternative<Pattern>(vibration.source)) {
            corners.push_back(vibration.name);
        }
    }
    return corners;
}

void open_pad(Ui& ui, const Workspace& work, PadState& pad) {
    pad.corners = pad_corners(work);
    if (pad.corners.size() < 2) {
        return say(ui,
                   "Select two to four patterns made of parameters first: they become the "
                   "corners.");
    }
    pad.right = 0.5;
    pad.down = pad.corners.size() > 2 ? 0.5 : 0.0;
    keep_mix(work.document.set, pad);
    ui.dialog = kPadDialog;
}

void draw_pad_dialog(Ui& ui, Workspace& work, PadState& pad) {
    const float s = ui.theme.scale;
    constexpr float kRoundingPx = 2.0F;
    const float around_px = kMarginPx + ui.theme.padding_px / s + kRoundingPx;
    if (!begin_dialog(ui, kPadDialog, kPadPx + 2.0F * around_px, DialogSide::right)) return;
    keep_mix(work.document.set, pad);
    coloured_text(ui.theme.dim_text,
                  "Drag inside; rest with the button held to feel it there. Rhythms are morphed: "
                  "notes move, stretch, split and fade.");
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float margin = kMarginPx * s;
    const float height = pad.corners.size() > 2 ? kPadPx * s : 0.4F * kPadPx * s;
    const Rect square = rect_at({corner.x + margin, corner.y + margin}, {kPadPx * s, height});
    take_pad_mouse(ui, work, pad, square);
    draw_square(ui, work, pad, square);
    draw_wave(ui, work, pad, {square.min.x, square.max.y + margin}, square.width());
    ImGui::SetCursorScreenPos({corner.x, ImGui::GetCursorScreenPos().y});
    dim_text(ui, {.id = "pad:words", .text = pad_words(pad)});
    if (draw_ends(ui, "Keep it", pad.mixed_of.size() > 1)) add_mix(ui, work, pad);
}

}  // namespace tact
