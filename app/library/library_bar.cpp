#include <imgui.h>
// After imgui.h.
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <string>
#include <vector>

#include "app/document/editing.h"
#include "app/library/library.h"
#include "app/library/parts.h"
#include "app/progress/progress.h"
#include "app/ui/widgets.h"
#include "model/io/formats/write_effect.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kShapeBoxPx = 150.0F;

// What the mouse has drawn since the last frame, without gaps where it was fast.
void take_stroke(LibraryState& state, const Rect& box, bool begins) {
    const ImVec2 at = ImGui::GetIO().MousePos;
    const ImVec2 moved = begins ? ImVec2{} : ImGui::GetIO().MouseDelta;
    const auto part_at = [&box](float x) {
        const float share = std::clamp((x - box.min.x) / box.width(), 0.0F, 0.9999F);
        return static_cast<std::size_t>(share * static_cast<float>(kShapeParts));
    };
    const auto strength_at = [&box](float y) {
        return std::clamp(static_cast<double>((box.max.y - y) / box.height()), 0.0, 1.0);
    };
    if (state.drawn.empty()) state.drawn.assign(kShapeParts, 0.0);
    const std::size_t from = part_at(at.x - moved.x);
    const std::size_t to = part_at(at.x);
    const double first = strength_at(at.y - moved.y);
    const double last = strength_at(at.y);
    const std::size_t steps = from < to ? to - from : from - to;
    for (std::size_t k = 0; k <= steps; ++k) {
        const double share = steps == 0 ? 1.0 : static_cast<double>(k) / static_cast<double>(steps);
        state.drawn[from < to ? from + k : from - k] = std::lerp(first, last, share);
    }
    forget_alike(state);
    state.by = LibraryColumn::match;
    state.descending = false;
}

// Where a shape is drawn by hand: over its whole width once, then where it is drawn again.
void draw_shape_box(Ui& ui, LibraryState& state, const Rect& box) {
    const Theme& theme = ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::SetCursorScreenPos(box.min);
    ImGui::InvisibleButton("shape", box.size());
    say_of_last_item(ui, {.id = "library:shape",
                          .text = state.drawn.empty() ? "" : "drawn",
                          .tip = "Draw strength over time, and what is like it comes first."});
    if (ImGui::IsItemActive()) take_stroke(state, box, ImGui::IsItemActivated());
    list.AddRectFilled(box.min, box.max, theme.field, theme.rounding_px);
    if (state.drawn.empty()) {
        const std::string words = "draw a shape";
        const ImVec2 size = text_size(theme.fonts.small, words);
        draw_text(list, theme.fonts.small,
                  {box.centre().x - size.x / 2.0F, box.centre().y - size.y / 2.0F}, theme.dim_text,
                  words);
        return;
    }
    const float each = box.width() / static_cast<float>(kShapeParts);
    for (std::size_t k = 0; k < state.drawn.size(); ++k) {
        const float left = box.min.x + each * static_cast<float>(k);
        const float top = box.max.y - box.height() * static_cast<float>(state.drawn[k]);
        list.AddRectFilled({left, top}, {left + each, box.max.y}, theme.accent);
    }
}

void draw_target_choice(Ui& ui, const Workspace& work, LibraryState& state, float width_px) {
    const auto chosen = target_format_of(state.target);
    const std::string shown = chosen ? traits(*chosen).title : "as they are";
    const std::string before = state.target;
    const auto choice = [&](const std::string& key, const char* words) {
        const Item item{.id = "library target:" + key, .label = words};
        if (option(ui, item, state.target == key)) state.target = key;
    };
    drop_down(ui,
              {.id = "library:target",
               .label = shown,
               .tip = "What is compared: the entries as they are, or as they come back from the "
                      "files of another program. So what can take a pattern's place there is "
                      "found."},
              width_px, [&] {
                  choice("", "as they are");
                  for (const TargetTraits& one : target_formats()) choice(one.key, one.title);
              });
    if (state.target != before) ask_alike_again(ui, work, state);
}

// Whether the answer is of a pattern, or by a model, that is another one by now.
bool is_outdated(const PatternSet& set, const AlikeRequest& request) {
    if (request.question.model != set.model) return true;
    if (request.entry) return false;
    const auto place = place_named(set, request.wanted);
    return place && !(set.vibrations[*place].source == request.question.wanted.source);
}

}  // namespace

void draw_library_folder(Ui& ui, const Workspace& work, Layout& layout, LibraryState& state) {
    const Item open{.id = "library:open", .label = "Open library\u2026"};
    const bool is_first = state.folder.empty();
    if (is_first ? primary_button(ui, open) : button(ui, open)) {
        ui.waiting.emplace_back([&] { open_library_dialog(ui, work, layout, state); });
    }
    if (is_first) return;
    flow_on(button_width("Read again"), ui.theme.gap_px);
    if (button(ui, {.id = "library:again",
                    .label = "Read again",
                    .tip = "Files that are new or have changed are read."})) {
        read_library_again(ui, state);
    }
    if (!state.library) return;
    const std::vector<std::string> reasons = reasons_left_out(*state.library);
    std::string told = shown_text(state.library->folder.filename().string()) + ", " +
                       counted(state.library->entries.size(), "entry", "entries");
    if (!reasons.empty()) told += ", " + counted(reasons.size(), "file", "files") + " not readable";
    dim_text_beside(ui, {.id = "library:told", .text = told});
    if (reasons.empty() || !ImGui::IsItemHovered()) return;
    constexpr std::size_t kMostLines = 12;
    std::string lines;
    for (const std::string& reason : reasons | std::views::take(kMostLines))
        lines += (lines.empty() ? "" : "\n") + shown_text(reason);
    if (reasons.size() > kMostLines)
        lines += "\nand " + grouped_digits(reasons.size() - kMostLines) + " more";
    draw_tooltip(ui, lines.c_str());
}

void draw_library_search(Ui& ui, const Workspace& work, LibraryState& state) {
    const float s = ui.theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float room = ImGui::GetContentRegionAvail().x;
    const float line = ImGui::GetFrameHeight();
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    const float box_px = std::min(kShapeBoxPx * s, 0.35F * room);
    const float left_px = room - box_px - ui.theme.gap_px;
    const Rect box{{corner.x + left_px + ui.theme.gap_px, corner.y},
                   {corner.x + room, corner.y + 2.0F * line + gap}};
    ImGui::SetNextItemWidth(left_px);
    ImGui::InputTextWithHint("##words", "a name, a tag, a format", &state.words);
    note_item(ui.rects, "library:words", state.words);
    const Vibration* current = current_vibration(work);
    const std::string full = current == nullptr ? "Like a pattern" : "Like " + current->name;
    const float target_px = std::min(170.0F * s, 0.5F * left_px);
    const float button_px = left_px - target_px - ui.theme.gap_px;
    const std::string words = shortened(ui.theme.fonts.regular, full,
                                        button_px - 2.0F * ImGui::GetStyle().FramePadding.x);
    if (button(ui,
               {.id = "library:like",
                .label = words,
                .tip = "The nearest first, by PM against the current pattern.",
                .enabled = current != nullptr,
                .value = full},
               {button_px, 0.0F})) {
        state.drawn.clear();
        find_alike(ui, work, state, *current);
    }
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    draw_target_choice(ui, work, state, target_px);
    const ImVec2 after = ImGui::GetCursorScreenPos();
    draw_shape_box(ui, state, box);
    ImGui::SetCursorScreenPos(after);
}

void draw_library_order(Ui& ui, const Workspace& work, LibraryState& state) {
    if (state.comparer.busy()) {
        if (draw_progress(ui, {"Comparing", state.comparer.progress(), "comparing"})) {
            state.comparer.cancel();
        }
        return;
    }
    std::string words;
    if (state.alike) {
        const LikeAnswer& answer = state.alike->answer;
        const AlikeRequest& request = state.alike->request;
        words = "like " + shown_text(request.wanted);
        if (!answer.is_wanted_felt) words += " (not felt: by rhythm alone)";
        if (is_outdated(work.document.set, request)) words += ", before it was changed";
        if (request.question.target) words += ", " + words_on(*request.question.target);
        if (answer.exported) {
            words += "; itself there: PM " + significant_digits(answer.exported->pm, 4) + ", " +
                     counted(nearer_than_exported(answer), "is", "are") + " nearer";
        }
        if (!answer.too_long.empty())
            words += "; " + counted(answer.too_long.size(), "is", "are") + " too long to compare";
        if (!answer.not_held.empty())
            words += "; " + counted(answer.not_held.size(), "recording", "recordings") +
                     " cannot be exported so";
    } else if (!state.drawn.empty()) {
        words = "like the drawn shape, whatever the length";
    }
    if (words.empty()) return;
    if (link(ui, {.id = "library:clear", .label = "Clear"})) {
        state.drawn.clear();
        forget_alike(state);
        if (state.by == LibraryColumn::match) state.by = LibraryColumn::file;
    }
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, {.id = "library:order", .text = words});
    ImGui::PopTextWrapPos();
}

}  // namespace tact
