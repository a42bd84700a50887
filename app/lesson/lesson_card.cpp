#include "app/lesson/lesson.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "app/lesson/parts.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr Range kCardShare{0.15, 0.5};
constexpr const char* kHideSource = "Hide the source";
// Largest share of the window that the card may take for its words and options: at a side, and at
// the top or bottom.
constexpr float kMostOfWidth = 0.6F;
constexpr float kMostOfHeight = 0.7F;

bool is_upright(DockSide side) { return side == DockSide::left || side == DockSide::right; }

constexpr float kMeasure = 60.0F;  // letters on a line; longer lines are hard to follow

// The length of a line that is easy to read.
float measure_px(const Ui& ui, const LessonState& state) {
    constexpr std::string_view kLetters = "the quick brown fox jumps over the lazy dog";
    const ImFont* font = lesson_fonts(ui, state).text;
    return kMeasure * text_size(font, kLetters).x / static_cast<float>(kLetters.size());
}

// At the top or bottom the card is as high as its words, except while editing.
bool is_low(const LessonState& state) { return !is_upright(state.dock) && !state.editing; }

bool is_same_place(const CardGrowth& a, const CardGrowth& b) {
    return a.step == b.step && a.dock == b.dock && a.area.x == b.area.x && a.area.y == b.area.y &&
           a.font_px == b.font_px;
}

CardGrowth growth_at(const Ui& ui, const LessonState& state, const Rect& area) {
    return {*state.step, state.dock, area.size(), lesson_fonts(ui, state).text->FontSize, 0.0F};
}

// Wide enough to read and to show all its words, and no wider. A low card is as high as its words.
float card_px(const Ui& ui, const LessonState& state, const Rect& area) {
    if (is_low(state)) {
        const float most = kMostOfHeight * area.height();
        return std::round(std::min(state.low_card_px > 0.0F ? state.low_card_px : most, most));
    }
    const bool upright = is_upright(state.dock);
    const float all = upright ? area.width() : area.height();
    const float least = (upright ? 250.0F : 80.0F) * ui.theme.scale;
    const float most = static_cast<float>(kCardShare.high) * all;
    const float read = upright ? measure_px(ui, state) + 2.0F * ui.theme.padding_px : most;
    const float wanted = std::min({std::max(state.card_share * all, least), read, most});
    const bool grown = is_same_place(state.grown, growth_at(ui, state, area));
    const float needed = grown ? std::min(state.grown.width_px, kMostOfWidth * all) : 0.0F;
    return std::round(std::max(wanted, needed));
}

// Widens a card that is too low for its words. `words_px`: their height.
void grow_card(const Ui& ui, LessonState& state, const Rect& area, const Rect& card,
               float words_px) {
    if (!is_upright(state.dock) || state.editing || words_px <= card.height()) return;
    state.grown = growth_at(ui, state, area);
    // A little more than in proportion, because lines rarely break exactly at their end.
    state.grown.width_px = std::ceil(1.06F * card.width() * words_px / card.height());
}

std::string text_in(const LessonState& state, const std::string& text) {
    const LessonAnswers* answers = answers_of(state);
    return filled(text, answers == nullptr ? LessonNumbers{} : answers->numbers);
}

// Its numbers are still being computed: a sentence without them would be incomplete.
bool lacks_numbers(const LessonState& state, const std::string& text) {
    const LessonAnswers* answers = answers_of(state);
    const auto is_known = [answers](const std::string& placeholder) {
        return answers != nullptr && answers->numbers.contains(placeholder);
    };
    return state.job.busy() && !std::ranges::all_of(placeholders_in(text), is_known);
}

void draw_text_of(Ui& ui, const LessonState& state, const LessonStep& step) {
    const std::string text = lacks_numbers(state, step.text) ? "The model computes the numbers."
                                                             : text_in(state, step.text);
    wrapped_text(ui, {.id = "lesson:text", .text = text});
    read_out(ui, text);
}

std::string count_text(const LessonState& state) {
    return std::to_string(*state.step + 1) + " of " + std::to_string(state.lesson->steps.size());
}

void draw_count(Ui& ui, const LessonState& state) {
    ImGui::PushFont(lesson_fonts(ui, state).small);
    dim_text(ui, count_text(state));
    ImGui::PopFont();
}

float move_px(const Ui& ui, const LessonState& state) {
    return text_size(lesson_fonts(ui, state).small, "Move").x;
}

void draw_move(Ui& ui, LessonState& state) {
    ImGui::PushFont(lesson_fonts(ui, state).small);
    if (link(ui, {.id = "lesson:move",
                  .label = "Move",
                  .tip = "To the next edge of the window; its inner edge can be dragged"})) {
        move_card(state);
    }
    ImGui::PopFont();
}

void draw_title(Ui& ui, const LessonState& state, const LessonStep& step) {
    ImGui::PushFont(lesson_fonts(ui, state).head);
    wrapped_text(text_in(state, step.title));
    read_out(ui, text_in(state, step.title));
    ImGui::PopFont();
    ImGui::Spacing();
}

// Explains the boxes shown in place of letters.
void draw_lacking(Ui& ui, const LessonState& state) {
    if (state.lacking.empty() || ui.fonts_outdated) return;
    const std::string text = "No font of this computer has all letters of this step. " +
                             std::string(package_for(state.lacking)) + " has them.";
    coloured_text(ui, ui.theme.warning, {.id = "lesson:lacking", .text = text});
}

// The editor shows the whole source.
std::string told_source(const LessonState& state, const LessonStep& step) {
    return state.editing ? step.source : source_for_class(step);
}

void draw_source_link(Ui& ui, LessonState& state, const LessonStep& step) {
    ImGui::PushFont(lesson_fonts(ui, state).small);
    const bool is_shown = state.shows_source;
    if (link(ui, {.id = "lesson:source",
                  .label = is_shown ? kHideSource : "Source",
                  .value = is_shown ? told_source(state, step) : ""})) {
        state.shows_source = !is_shown;
    }
    ImGui::PopFont();
}

void draw_source_text(Ui& ui, const LessonState& state, const LessonStep& step) {
    const std::string source = told_source(state, step);
    if (source.empty() || !state.shows_source) return;
    ImGui::PushFont(lesson_fonts(ui, state).small);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, source);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

void draw_source(Ui& ui, LessonState& state, const LessonStep& step) {
    if (!told_source(state, step).empty()) draw_source_link(ui, state, step);
    draw_source_text(ui, state, step);
}

struct WayWords {
    const char* on;  // empty: no next step
    const char* leave;
};

WayWords way_words(const LessonState& state) {
    const bool last = *state.step + 1 == state.lesson->steps.size();
    const bool hides = hides_answer(state);
    return {hides  ? "Reveal"
            : last ? nullptr
                   : "Next",
            last              ? "Finish"
            : state.is_tour   ? "Leave the tour"
            : state.is_of_set ? "Leave"
                              : "Leave the lesson"};
}

void draw_head(Ui& ui, LessonState& state, const LessonStep& step, float width) {
    draw_count(ui, state);
    ImGui::SameLine(width - move_px(ui, state));
    draw_move(ui, state);
    draw_title(ui, state, step);
    draw_lacking(ui, state);
}

constexpr const char* kBack = "Back";

float way_width(const Ui& ui, const WayWords& words) {
    const float on = words.on == nullptr ? 0.0F : ui.theme.gap_px + button_width(words.on);
    return button_width(kBack) + on + ui.theme.gap_px + button_width(words.leave);
}

// In one row, or in as many as the card needs.
void draw_way(const LessonContext& context, LessonState& state, bool in_one_row) {
    Ui& ui = context.ui;
    const WayWords words = way_words(state);
    const bool last = *state.step + 1 == state.lesson->steps.size();
    const auto beside = [&](const char* next) {
        if (in_one_row) return ImGui::SameLine(0.0F, ui.theme.gap_px);
        flow_on(button_width(next), ui.theme.gap_px);
    };
    if (button(ui, {.id = "tour:back", .label = kBack, .enabled = *state.step > 0}))
        step_back(context, state);
    if (words.on != nullptr) {
        beside(words.on);
        if (button(ui, {.id = "tour:next", .label = words.on})) step_on(context, state);
    }
    beside(words.leave);
    if (button(ui, {.id = last ? "tour:finish" : "tour:leave", .label = words.leave}))
        ui.waiting.emplace_back([context, &state] {
            before_lesson_goes(context, state, [context, &state] { leave_lesson(context, state); });
        });
}

// On the line of the buttons, in smaller type.
void beside_buttons(const Ui& ui, const LessonState& state) {
    ImGui::SameLine(0.0F, 2.0F * ui.theme.gap_px);
    const float small = text_size(lesson_fonts(ui, state).small, "Move").y;
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 0.5F * (ImGui::GetFrameHeight() - small));
}

// Items at the right of the first line of a low card.
float head_width(const Ui& ui, const LessonState& state, bool with_source) {
    const float source = text_size(lesson_fonts(ui, state).small, kHideSource).x;
    return way_width(ui, way_words(state)) + 2.0F * ui.theme.gap_px + move_px(ui, state) +
           (with_source ? 2.0F * ui.theme.gap_px + source : 0.0F);
}

void draw_way_at_right(const LessonContext& context, LessonState& state, const LessonStep& step,
                       bool with_source) {
    Ui& ui = context.ui;
    const float rest = ImGui::GetContentRegionAvail().x - head_width(ui, state, with_source);
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, rest));
    draw_way(context, state, true);
    beside_buttons(ui, state);
    if (with_source) {
        draw_source_link(ui, state, step);
        ImGui::SameLine(0.0F, 2.0F * ui.theme.gap_px);
    }
    draw_move(ui, state);
}

// Columns of a low card: its head, its words, and the rest of the width for the buttons and a
// question.
struct CardColumns {
    float head_px;
    float text_px;
    float gap_px;
};

// Nullopt if the card is too narrow.
std::optional<CardColumns> card_columns(const Ui& ui, const LessonState& state, float width) {
    const float line = measure_px(ui, state);
    const CardColumns columns{0.6F * line, 1.4F * line, 2.0F * ui.theme.padding_px};
    const float way = way_width(ui, way_words(state)) + 2.0F * ui.theme.gap_px + move_px(ui, state);
    const float rest = width - columns.head_px - columns.text_px - 2.0F * columns.gap_px;
    return rest >= way ? std::optional(columns) : std::nullopt;
}

void draw_in_columns(const LessonContext& context, LessonState& state, const LessonStep& step,
                     const CardColumns& columns) {
    Ui& ui = context.ui;
    const bool asks = question_of(state) != nullptr;
    const ImVec2 between{0.5F * columns.gap_px, 0.0F};
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, between);
    if (ImGui::BeginTable("card", 3,
                          ImGuiTableFlags_NoPadOuterX | ImGuiTableFlags_NoSavedSettings)) {
        // puts the words on the line of the buttons
        const float pad = ImGui::GetStyle().FramePadding.y;
        ImGui::TableSetupColumn("head", ImGuiTableColumnFlags_WidthFixed, columns.head_px);
        ImGui::TableSetupColumn("text", ImGuiTableColumnFlags_WidthFixed, columns.text_px);
        ImGui::TableSetupColumn("way", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableNextColumn();
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() + pad);
        draw_count(ui, state);
        draw_title(ui, state, step);
        draw_lacking(ui, state);
        ImGui::TableNextColumn();
        ImGui::SetCursorPosY(ImGui::GetCursorPosY() + pad);
        draw_text_of(ui, state, step);
        draw_source(ui, state, step);
        ImGui::TableNextColumn();
        draw_way_at_right(context, state, step, false);
        if (asks) draw_lesson_question(context, state, *step.question);
        ImGui::EndTable();
    }
    ImGui::PopStyleVar();
}

// A low card too narrow for columns: its head stands beside the buttons, and stays visible while
// the words scroll.
void draw_low(const LessonContext& context, LessonState& state, const LessonStep& step) {
    Ui& ui = context.ui;
    const bool asks = question_of(state) != nullptr;
    const bool with_source = !told_source(state, step).empty();
    ImGui::AlignTextToFramePadding();
    draw_count(ui, state);
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    const float rest = ImGui::GetContentRegionAvail().x - head_width(ui, state, with_source);
    const float title =
        text_size(lesson_fonts(ui, state).head, text_in(state, step.title)).x + ui.theme.gap_px;
    const bool in_head = title <= rest;
    if (in_head) {
        ImGui::PushFont(lesson_fonts(ui, state).head);
        ImGui::TextUnformatted(text_in(state, step.title).c_str());
        ImGui::PopFont();
        ImGui::SameLine(0.0F, ui.theme.gap_px);
    }
    draw_way_at_right(context, state, step, with_source);
    if (!in_head) draw_title(ui, state, step);
    draw_lacking(ui, state);
    draw_text_of(ui, state, step);
    if (asks) draw_lesson_question(context, state, *step.question);
    draw_source_text(ui, state, step);
}

// A card at a side: everything in one column.
void draw_in_a_column(const LessonContext& context, LessonState& state, const LessonStep& step,
                      float width) {
    const bool asks = question_of(state) != nullptr;
    draw_head(context.ui, state, step, width);
    if (state.editing) {
        draw_step_editor(context, state);
    } else {
        draw_text_of(context.ui, state, step);
    }
    if (asks) draw_lesson_question(context, state, *step.question);
    draw_source(context.ui, state, step);
}

// Its inner edge can be dragged.
void draw_edge(Ui& ui, LessonState& state, const Rect& card, const Rect& area) {
    const float bar = ui.theme.splitter_px;
    const bool upright = is_upright(state.dock);
    const float total = upright ? area.width() : area.height();
    const bool before = state.dock == DockSide::left || state.dock == DockSide::top;
    const float card_size = upright ? card.width() : card.height();
    float share = before ? card_size / total : 1.0F - card_size / total;
    const float was = share;
    Rect edge = card;
    if (state.dock == DockSide::right)
        edge = {{card.min.x - bar, card.min.y}, {card.min.x, card.max.y}};
    if (state.dock == DockSide::left)
        edge = {{card.max.x, card.min.y}, {card.max.x + bar, card.max.y}};
    if (state.dock == DockSide::bottom)
        edge = {{card.min.x, card.min.y - bar}, {card.max.x, card.min.y}};
    if (state.dock == DockSide::top)
        edge = {{card.min.x, card.max.y}, {card.max.x, card.max.y + bar}};
    const Range range = before ? kCardShare : Range{1.0 - kCardShare.high, 1.0 - kCardShare.low};
    draw_splitter(ui, {"card edge", edge, upright, total, range}, share);
    if (share != was) state.card_share = before ? share : 1.0F - share;
}

}  // namespace

LessonFonts lesson_fonts(const Ui& ui, const LessonState& state) {
    const Fonts& fonts = ui.theme.fonts;
    if (state.presenting) return {fonts.presented, fonts.title, fonts.regular};
    return {fonts.regular, fonts.semibold, fonts.small};
}

LessonPlaces lesson_places(const Ui& ui, const LessonState& state, const Rect& area) {
    if (!state.step) return {{}, area};
    const float size = card_px(ui, state, area);
    const float gap = ui.theme.splitter_px;
    LessonPlaces places{area, area};
    switch (state.dock) {
        case DockSide::right:
            places.card.min.x = area.max.x - size;
            places.rest.max.x = places.card.min.x - gap;
            break;
        case DockSide::left:
            places.card.max.x = area.min.x + size;
            places.rest.min.x = places.card.max.x + gap;
            break;
        case DockSide::bottom:
            places.card.min.y = area.max.y - size;
            places.rest.max.y = places.card.min.y - gap;
            break;
        case DockSide::top:
            places.card.max.y = area.min.y + size;
            places.rest.min.y = places.card.max.y + gap;
            break;
    }
    return places;
}

void draw_lesson_card(const LessonContext& context, LessonState& state,
                      const LessonPlaces& places) {
    const Rect& card = places.card;
    const LessonStep* shown = step_of(state);
    if (shown == nullptr || card.empty()) return;
    follow_glyphs(context.ui, state);
    const LessonStep step = *shown;  // the frame may go to another step
    const std::string count = count_text(state);
    Ui& ui = context.ui;
    const Theme& theme = ui.theme;
    const Rect& rest = places.rest;
    const Rect whole{{std::min(card.min.x, rest.min.x), std::min(card.min.y, rest.min.y)},
                     {std::max(card.max.x, rest.max.x), std::max(card.max.y, rest.max.y)}};
    ImGui::SetNextWindowPos(card.min);
    ImGui::SetNextWindowSize(card.size());
    ImGui::PushStyleColor(ImGuiCol_Border, theme.accent);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, theme.hairline_px * 1.5F);
    const bool low = is_low(state);
    const float bar_px = ImGui::GetStyle().ScrollbarSize;
    const float inner = card.width() - 2.0F * theme.padding_px - bar_px;
    const auto columns = low ? card_columns(ui, state, inner) : std::nullopt;
    // Lines at the top or bottom may be longer than at a side, by three quarters: the card is low.
    const float line = std::min(1.75F * measure_px(ui, state), inner);
    if (low && !columns) ImGui::SetNextWindowContentSize({line, 0.0F});
    const bool is_open =
        ImGui::Begin("tour", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
    // The frame belongs to the card alone, not to its buttons and fields.
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    if (is_open) {
        ImGui::PushFont(lesson_fonts(ui, state).text);
        const float bar = ImGui::GetScrollMaxY() > 0.0F ? ImGui::GetStyle().ScrollbarSize : 0.0F;
        const float width = card.width() - ImGui::GetStyle().WindowPadding.x - bar;
        if (columns) {
            draw_in_columns(context, state, step, *columns);
        } else if (low) {
            draw_low(context, state, step);
        } else {
            draw_in_a_column(context, state, step, width);
            ImGui::Spacing();
            draw_way(context, state, false);
        }
        const float end_px = ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y;
        const float words_px = std::ceil(end_px + ImGui::GetStyle().WindowPadding.y);
        if (low) state.low_card_px = words_px;
        grow_card(ui, state, whole, card, words_px);
        ImGui::PopFont();
        note_rect(ui.rects, "tour", card.min, card.max, count);
    }
    ImGui::End();
    if (!low) draw_edge(ui, state, card, whole);
}

void step_on(const LessonContext& context, LessonState& state) {
    if (!state.step) return;
    if (hides_answer(state)) {
        count_place(state, context.shown_map);
        state.tallies[*state.step].revealed = true;
        return;
    }
    go_to_step(context, state, *state.step + 1);
}

void step_back(const LessonContext& context, LessonState& state) {
    if (state.step && *state.step > 0) go_to_step(context, state, *state.step - 1);
}

void move_card(LessonState& state) {
    constexpr std::array<DockSide, 4> kNext{DockSide::bottom, DockSide::left, DockSide::top,
                                            DockSide::right};
    state.dock = kNext[static_cast<std::size_t>(state.dock)];
}

}  // namespace tact
