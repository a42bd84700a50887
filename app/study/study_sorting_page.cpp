// Sorting: patterns as numbered tokens, dragged or put by key into boxes that are groups.

#include <algorithm>
#include <cmath>

#include "app/study/study.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

using What = StudyEvent::What;

constexpr float kTokenPx = 56.0F;
constexpr std::size_t kDigits = 9;
constexpr std::size_t kMostKeys = kDigits + 26;

// The key that puts a pattern into a group: 1 to 9, then a, b, c ...
char32_t key_of(std::size_t group) {
    const std::size_t sign = group < kDigits ? U'1' + group : U'a' + (group - kDigits);
    return static_cast<char32_t>(sign);
}

// Boxes on the screen: as many as asked for; of free ones always an empty one more.
std::size_t box_count(const StudyRun& run) {
    if (run.asked_groups > 0) return static_cast<std::size_t>(run.asked_groups);
    std::size_t used = 0;
    for (const std::size_t group : run.groups) {
        if (group != kUnsorted) used = std::max(used, group + 1);
    }
    return std::clamp<std::size_t>(used + 1, 2, run.groups.size());
}

struct SortingLayout {
    Rect tray;
    std::vector<Rect> boxes;
};

SortingLayout layout_of(const Ui& ui, const Rect& area, std::size_t boxes) {
    const float gap = ui.theme.padding_px;
    SortingLayout layout;
    // As high as a token, where that leaves enough to the groups.
    const float token = kTokenPx * ui.theme.scale + 2.0F * ui.theme.padding_px;
    const float tray = std::clamp(token, 0.24F * area.height(), 0.36F * area.height());
    layout.tray = {area.min, {area.max.x, area.min.y + tray}};
    const std::size_t columns = boxes <= 3 ? boxes : (boxes <= 8 ? 4 : 5);
    const std::size_t rows = (boxes + columns - 1) / columns;
    const Rect field{{area.min.x, layout.tray.max.y + gap}, area.max};
    const float width = (field.width() + gap) / static_cast<float>(columns);
    const float height = (field.height() + gap) / static_cast<float>(rows);
    for (std::size_t k = 0; k < boxes; ++k) {
        const ImVec2 corner{field.min.x + static_cast<float>(k % columns) * width,
                            field.min.y + static_cast<float>(k / columns) * height};
        layout.boxes.push_back(rect_at(corner, {width - gap, height - gap}));
    }
    return layout;
}

// The number that a participant knows a pattern by: names would tell what was designed.
std::string token_name(const StudyRun& run, std::size_t pattern) {
    const auto place = std::ranges::find(run.training, pattern) - run.training.begin();
    return std::to_string(place + 1);
}

// Patterns in the order of their numbers.
std::vector<std::size_t> in_group(const StudyRun& run, std::size_t group) {
    std::vector<std::size_t> members;
    for (const std::size_t pattern : run.training) {
        if (run.groups[pattern] == group) members.push_back(pattern);
    }
    return members;
}

Rect token_rect(const Ui& ui, const Rect& box, std::size_t k, std::size_t count) {
    const float gap = ui.theme.gap_px;
    const Rect inner = inset(box, ui.theme.padding_px);
    float side = kTokenPx * ui.theme.scale;
    // Smaller where they would not fit.
    for (; side > 20.0F * ui.theme.scale; side *= 0.85F) {
        const auto columns = std::max(1.0F, std::floor((inner.width() + gap) / (side + gap)));
        if (std::ceil(static_cast<float>(count) / columns) * (side + gap) <= inner.height() + gap) {
            break;
        }
    }
    const auto columns =
        static_cast<std::size_t>(std::max(1.0F, std::floor((inner.width() + gap) / (side + gap))));
    const ImVec2 corner{inner.min.x + static_cast<float>(k % columns) * (side + gap),
                        inner.min.y + static_cast<float>(k / columns) * (side + gap)};
    return rect_at(corner, {side, side});
}

void draw_box(const Ui& ui, const Rect& box, const std::string& label, bool is_target) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(box.min, box.max, is_target ? theme.hover : theme.pane,
                       theme.pane_rounding_px);
    list.AddRect(box.min, box.max, is_target ? theme.accent : theme.line, theme.pane_rounding_px, 0,
                 theme.hairline_px);
    const ImVec2 size = text_size(theme.fonts.small, label);
    draw_text(list, theme.fonts.small, box.max - size - ImVec2{8.0F, 6.0F} * theme.scale,
              theme.dim_text, label);
}

// What a token's release means: a click plays, a drag puts it where it was let go.
void release(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
             const SortingLayout& layout, std::size_t pattern) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const ImVec2 way = ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0F);
    if (std::hypot(way.x, way.y) < 6.0F * ui.theme.scale) {
        return act(ui, work, play, studying, {What::play, pattern, 0.0, {}, {}});
    }
    if (layout.tray.contains(mouse))
        return act(ui, work, play, studying, {What::put, pattern, -1.0, {}, {}});
    for (std::size_t k = 0; k < layout.boxes.size(); ++k) {
        if (layout.boxes[k].contains(mouse)) {
            return act(ui, work, play, studying,
                       {What::put, pattern, static_cast<double>(k), {}, {}});
        }
    }
}

void draw_token(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                const SortingLayout& layout, std::size_t pattern, const Rect& place) {
    const Theme& theme = ui.theme;
    const std::string name = token_name(*studying.run, pattern);
    ImGui::SetCursorScreenPos(place.min);
    ImGui::InvisibleButton(("token " + name).c_str(), place.size());
    const bool is_held = ImGui::IsItemActive();
    const bool is_lit = is_held || ImGui::IsItemHovered();
    const bool is_released = ImGui::IsItemDeactivated();
    if (ImGui::IsItemActivated()) studying.held = pattern;
    note_rect(ui.rects, "study:token " + name, place.min, place.max,
              studying.run->groups[pattern] == kUnsorted
                  ? "unsorted"
                  : std::to_string(studying.run->groups[pattern] + 1));
    note_rect(ui.rects, "study:felt " + name, place.min, place.max,
              std::to_string(studying.run->felt_sorting[pattern]));
    const ImVec2 shift =
        is_held ? ImGui::GetMouseDragDelta(ImGuiMouseButton_Left, 0.0F) : ImVec2{0, 0};
    const Rect at{place.min + shift, place.max + shift};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at.min, at.max, is_lit ? theme.hover : theme.field, theme.pane_rounding_px);
    if (studying.run->playing == pattern) {
        list.AddRectFilled(at.min, {at.min.x + played_share(ui, studying) * at.width(), at.max.y},
                           faded(theme.accent, 0.45F), theme.pane_rounding_px);
    }
    const bool is_chosen = studying.held == pattern;
    list.AddRect(at.min, at.max, is_chosen ? theme.accent : theme.line, theme.pane_rounding_px, 0,
                 (is_chosen ? 2.0F : 1.0F) * theme.scale);
    // What was not felt yet is hollow.
    const bool is_felt = studying.run->felt_sorting[pattern] > 0;
    centred_text(theme.fonts.large, is_felt ? theme.text : theme.dim_text, at,
                 at.centre().y - 0.5F * text_size(theme.fonts.large, name).y, name);
    if (is_released) release(ui, work, play, studying, layout, pattern);
}

void take_keys(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
               std::span<const KeyPress> pressed, std::size_t boxes) {
    const std::vector<std::size_t>& order = studying.run->training;
    const auto place = studying.held ? std::ranges::find(order, *studying.held) : order.end();
    const auto at = static_cast<std::size_t>(place - order.begin());
    if (was_pressed(pressed, key::kRight)) studying.held = order[(at + 1) % order.size()];
    if (place == order.end() && was_pressed(pressed, key::kRight)) studying.held = order.front();
    if (was_pressed(pressed, key::kLeft)) {
        studying.held = order[(at + order.size() - 1) % order.size()];
    }
    if (!studying.held) return;
    if (was_pressed(pressed, key::kSpace))
        act(ui, work, play, studying, {What::play, *studying.held, 0.0, {}, {}});
    if (was_typed(pressed, U'0'))
        act(ui, work, play, studying, {What::put, *studying.held, -1.0, {}, {}});
    for (std::size_t k = 0; k < std::min(boxes, kMostKeys); ++k) {
        if (was_typed(pressed, key_of(k))) {
            act(ui, work, play, studying,
                {What::put, *studying.held, static_cast<double>(k), {}, {}});
        }
    }
}

std::string task_text(const StudyRun& run) {
    if (run.cut_short >= kCallAfter) return kCallText;
    if (run.feels_again) return "That was cut short: feel it once more";
    if (unsorted_count(run) == 0 && unfelt_count(run) > 0) {
        return "Feel each number before you go on: " + std::to_string(unfelt_count(run)) +
               (unfelt_count(run) == 1 ? " is left" : " are left");
    }
    if (run.asked_groups > 0) {
        return "Sort them into " + std::to_string(run.asked_groups) +
               " groups: what feels alike goes together";
    }
    return "Sort them into as many groups as you like: what feels alike goes together";
}

}  // namespace

void draw_sorting_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                       const Rect& area, std::span<const KeyPress> pressed) {
    take_keys(ui, work, play, studying, pressed, box_count(*studying.run));
    const StudyRun& run = *studying.run;
    const Theme& theme = ui.theme;
    const float top = area.min.y;
    centred_text(theme.fonts.large, theme.text, area, top, task_text(run));
    const ImVec2 done = go_on_size(theme);
    const float foot = done.y + 2.0F * theme.padding_px;
    const std::size_t boxes = box_count(run);
    const SortingLayout layout = layout_of(
        ui, {{area.min.x, top + 48.0F * theme.scale}, {area.max.x, area.max.y - foot}}, boxes);
    const bool drags = ImGui::IsMouseDragging(ImGuiMouseButton_Left);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    draw_box(ui, layout.tray, "still to sort", drags && layout.tray.contains(mouse));
    note_rect(ui.rects, "study:tray", layout.tray.min, layout.tray.max);
    note_rect(ui.rects, "study:may feel", area.min, area.max,
              may_play(run, ui.time_s) ? "yes" : "no");
    for (std::size_t k = 0; k < boxes; ++k) {
        const Rect& box = layout.boxes[k];
        std::string label = "group " + std::to_string(k + 1);
        if (k >= kDigits && k < kMostKeys) {
            label += std::string(", key ") + static_cast<char>(key_of(k));
        }
        draw_box(ui, box, label, drags && box.contains(mouse));
        note_rect(ui.rects, "study:group " + std::to_string(k + 1), box.min, box.max);
    }
    // Places first: a token that is let go changes them.
    std::vector<std::pair<std::size_t, Rect>> tokens;
    for (std::size_t k = 0; k <= boxes; ++k) {
        const std::vector<std::size_t> members = in_group(run, k < boxes ? k : kUnsorted);
        const Rect& box = k < boxes ? layout.boxes[k] : layout.tray;
        for (std::size_t m = 0; m < members.size(); ++m) {
            tokens.emplace_back(members[m], token_rect(ui, box, m, members.size()));
        }
    }
    for (const auto& [pattern, place] : tokens)
        draw_token(ui, work, play, studying, layout, pattern, place);
    const ImVec2 corner{area.centre().x - 0.5F * done.x, area.max.y - theme.padding_px - done.y};
    draw_go_on(ui, work, play, studying, {corner, area.max}, "Done");
}

}  // namespace tact
