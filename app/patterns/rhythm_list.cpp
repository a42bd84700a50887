#include "app/patterns/patterns.h"

#include <imgui.h>

#include <algorithm>

#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/pattern/rhythm.h"
#include "model/perceptual_model/rhythm_envelope.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr std::uint64_t kMostListed = 5000;
constexpr float kRhythmRowPx = 24.0F;
constexpr float kListHeightPx = 190.0F;
constexpr float kEnvelopeHeightPx = 54.0F;

std::uint64_t size_of(const RhythmChoice& choice) {
    if (choice.list == RhythmList::euclidean) return static_cast<std::uint64_t>(choice.steps);
    return necklace_count(static_cast<std::size_t>(choice.steps),
                          static_cast<std::size_t>(choice.notes));
}

std::vector<std::string> texts_of(const RhythmChoice& choice) {
    const auto steps = static_cast<std::size_t>(choice.steps);
    std::vector<std::string> texts;
    if (choice.list == RhythmList::euclidean) {
        for (std::size_t k = 1; k <= steps; ++k) texts.push_back(euclidean_rhythm(steps, k));
    } else if (size_of(choice) <= kMostListed) {
        texts = necklaces(steps, static_cast<std::size_t>(choice.notes));
        std::ranges::stable_sort(texts, std::greater<>{}, evenness);
    }
    for (std::string& text : texts) {
        text = with_note_length(text, static_cast<std::size_t>(choice.note_steps));
    }
    return texts;
}

void keep_texts(RhythmChoice& choice) {
    const bool current = choice.made_list == choice.list && choice.made_steps == choice.steps &&
                         choice.made_notes == choice.notes &&
                         choice.made_note_steps == choice.note_steps;
    if (current) return;
    choice.texts = texts_of(choice);
    choice.made_list = choice.list;
    choice.made_steps = choice.steps;
    choice.made_notes = choice.notes;
    choice.made_note_steps = choice.note_steps;
}

void draw_count(Ui& ui, const char* id, const char* label, int normal, int& value, int most) {
    value = std::clamp(value, 1, most);
    enter_whole_with_buttons(ui,
                             {.id = id,
                              .label = label,
                              .format = "%.9g",
                              .rules = {{1.0, static_cast<double>(most)}},
                              .width_px = 100.0F * ui.theme.scale},
                             value);
    note_item(ui.rects, std::string("rhythm list:") + id, std::to_string(value));
    ImGui::SameLine();
    dim_text(ui, label);
    reset_by_label(ui, normal, value);
}

bool choice_toggle(Ui& ui, const char* text, bool lit, const char* help) {
    return toggle(ui,
                  {.id = std::string("rhythm list:") + text,
                   .label = text,
                   .tip = help,
                   .value = lit ? "chosen" : ""},
                  lit);
}

void draw_kind(Ui& ui, RhythmChoice& choice) {
    const float gap = 2.0F * ui.theme.scale;
    if (choice_toggle(
            ui, "Necklaces", choice.list == RhythmList::necklaces,
            "All rhythms with this number of steps and notes; rotations of one another count "
            "once.")) {
        choice.list = RhythmList::necklaces;
    }
    ImGui::SameLine(0.0F, gap);
    if (choice_toggle(ui, "Euclidean", choice.list == RhythmList::euclidean,
                      "For every number of notes the rhythm that spreads them most evenly.")) {
        choice.list = RhythmList::euclidean;
    }
    draw_count(ui, "steps", "steps", RhythmChoice{}.steps, choice.steps,
               static_cast<int>(kMostListSteps));
    if (choice.list == RhythmList::necklaces) {
        flow_on(120.0F * ui.theme.scale, 2.0F * ui.theme.gap_px);
        draw_count(ui, "notes", "notes", RhythmChoice{}.notes, choice.notes, choice.steps);
    }
    ImGui::AlignTextToFramePadding();
    dim_text(ui, "Notes of");
    const std::pair<const char*, int> lengths[] = {
        {"1 step", 1}, {"2 steps", 2}, {"3 steps", 3}, {"as long as can be", 0}};
    for (const auto& [text, steps] : lengths) {
        flow_on(chip_width(ui, text), steps == 1 ? ui.theme.gap_px : gap);
        if (choice_toggle(ui, text, choice.note_steps == steps,
                          "Every note is held so long, but never into the next.")) {
            choice.note_steps = steps;
        }
    }
}

void draw_row(Ui& ui, const std::string& text, bool lit, RhythmListAction& action) {
    const Theme& theme = ui.theme;
    const float s = theme.scale;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x);
    const ImVec2 size{width, kRhythmRowPx * s};
    if (ImGui::InvisibleButton(text.c_str(), size)) action.pressed = text;
    note_item(ui.rects, "rhythm:" + text, lit ? "chosen" : "");
    const bool over = ImGui::IsItemHovered() || ImGui::IsItemFocused();
    if (over) action.hovered = text;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (lit || over) {
        list.AddRectFilled(corner, corner + size, lit ? faded(theme.accent, 0.28F) : theme.hover,
                           theme.rounding_px);
    }
    const std::string number = with_decimals(evenness(text), 2);
    const ImVec2 extent = text_size(theme.fonts.small, number);
    draw_text(list, theme.fonts.small,
              {corner.x + width - extent.x - 8.0F * s, corner.y + (size.y - extent.y) / 2.0F},
              theme.dim_text, number);
    const float room = width - extent.x - 24.0F * s;
    const float cell = std::min(16.0F * s, room / static_cast<float>(text.size()));
    const ImVec2 low{corner.x + 6.0F * s, corner.y + (size.y - 14.0F * s) / 2.0F};
    draw_rhythm_cells(theme, rect_at(low, {cell * static_cast<float>(text.size()), 14.0F * s}),
                      text);
}

void draw_rows(Ui& ui, const RhythmChoice& choice,
               const std::function<bool(const std::string&)>& chosen, RhythmListAction& action) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 1.0F));
    if (ImGui::BeginChild("rhythms", {0.0F, kListHeightPx * ui.theme.scale})) {
        if (choice.texts.empty()) {
            const ImVec2 corner = ImGui::GetCursorScreenPos();
            draw_empty(*ImGui::GetWindowDrawList(), ui.theme,
                       rect_at(corner, ImGui::GetContentRegionAvail()), "Too many to list",
                       "Choose fewer steps or notes.");
        }
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(choice.texts.size()));
        while (clipper.Step()) {
            for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
                const std::string& text = choice.texts[static_cast<std::size_t>(k)];
                draw_row(ui, text, chosen(text), action);
            }
        }
    }
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

// Spans the whole pattern, from 0 to its largest value.
void draw_envelope(Ui& ui, RhythmChoice& choice, const Pattern& pattern) {
    // A rhythm repeats, so the beginning of a minute is enough; a frame cannot wait for all of it.
    constexpr double kLongestS = 4.0;
    const Pattern shown = with_duration(pattern, std::min(pattern.duration_s, kLongestS));
    if (choice.previewed != shown || choice.envelope.empty()) {
        choice.previewed = shown;
        choice.envelope = rhythm_envelope(render(shown).samples_g, EnvelopeParams{});
    }
    const Theme& theme = ui.theme;
    const ImVec2 size{ImGui::GetContentRegionAvail().x, kEnvelopeHeightPx * theme.scale};
    const Rect area = rect_at(ImGui::GetCursorScreenPos(), size);
    ImGui::Dummy(size);
    note_item(ui.rects, "rhythm envelope", pattern.rhythm.text);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(area.min, area.max, theme.field, theme.rounding_px);
    const Rect inner = inset(area, 4.0F * theme.scale);
    Plot plot;
    plot.area = inner;
    plot.x = {0.0, shown.duration_s, Scale::linear, inner.min.x, inner.max.x};
    plot.y = {0.0, 1.0, Scale::linear, inner.max.y, inner.min.y};
    draw_signal(list, theme, plot, choice.envelope, kModelRateHz, theme.series, TraceStyle::filled);
}

}  // namespace

void draw_rhythm_cells(const Theme& theme, const Rect& area, const std::string& text) {
    const float cell = area.width() / static_cast<float>(std::max<std::size_t>(text.size(), 1));
    const float gap = std::min(1.0F * theme.scale, cell / 4.0F);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    float height = area.height();  // note of this step
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '-') height = area.height();
        if (starts_note(text[k])) {
            height = static_cast<float>(kind_of({}, text[k]).velocity) * area.height();
        }
        const float left = area.min.x + static_cast<float>(k) * cell;
        list.AddRectFilled({text[k] == '=' ? left - gap : left + gap, area.max.y - height},
                           {left + cell - gap, area.max.y},
                           text[k] == '-' ? theme.field : theme.series, 1.5F * theme.scale);
    }
}

std::string rhythm_summary(const std::string& text) {
    return counted(onsets(text).size(), "note", "notes") + " on " +
           counted(text.size(), "step", "steps") + ", evenness " + with_decimals(evenness(text), 2);
}

RhythmListAction draw_rhythm_list(Ui& ui, RhythmChoice& choice, const Pattern& pattern,
                                  const std::function<bool(const std::string&)>& chosen,
                                  const std::string& all) {
    draw_kind(ui, choice);
    keep_texts(choice);
    const std::uint64_t size = size_of(choice);
    dim_text(ui, {.id = "rhythm list:count",
                  .text = grouped_digits(size) + (size == 1 ? " rhythm" : " rhythms") +
                          ", the most even first; evenness at the right",
                  .value = grouped_digits(size)});
    RhythmListAction action;
    draw_rows(ui, choice, chosen, action);
    Pattern shown = pattern;
    if (action.hovered) shown.rhythm.text = *action.hovered;
    draw_envelope(ui, choice, shown);
    const std::string words = shown.rhythm.text.empty()
                                  ? std::string("one note throughout")
                                  : shown.rhythm.text + "   " + rhythm_summary(shown.rhythm.text);
    dim_text(ui, shortened(ui.theme.fonts.regular, words, ImGui::GetContentRegionAvail().x));
    if (!all.empty() && !choice.texts.empty())
        action.all = link(ui, {.id = "link:all rhythms", .label = all});
    // Without keyboard navigation ImGui leaves an open list to the mouse.
    const bool escape = ImGui::IsKeyPressed(ImGuiKey_Escape, false);
    if (escape && !ImGui::IsAnyItemActive()) ImGui::CloseCurrentPopup();
    return action;
}

}  // namespace tact
