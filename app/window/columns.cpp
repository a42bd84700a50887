#include "app/window/window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/lesson/lesson.h"
#include "app/stages/stages.h"
#include "app/ui/widgets.h"
#include "viz/drawing/colour.h"

namespace tact {

namespace {

// The least share of the window that a column or row of panes needs at this size of text; capped in
// a small window, where the others need room, too.
double least_share(const App& app, float wanted_px, float total_px, float most) {
    return static_cast<double>(std::min(wanted_px * app.ui.theme.scale / total_px, most));
}

constexpr float kRowPx = 168.0F;  // height of stages

// Selecting shows many patterns and no editor; the arrangement for design has it.
bool has_editor(const App& app) { return app.layout.arrangement != Arrangement::select; }

bool is_folded(const App& app) { return app.layout.physiology != Fold::open; }

// The editor lies below the map and the answers, as wide as both; while the stages are open they
// have that room, and the editor stands below the list.
bool has_band(const App& app) { return has_editor(app) && is_folded(app); }

struct LayoutLimits {
    Range left{0.14, 0.40};
    Range right{0.18, 0.58};
    Range left_split{0.15, 0.80};
    Range right_split{0.20, 0.85};
    Range band{0.20, 0.70};
    float all_numbers = 0.0F;  // share of the band until the person moves its bar
};

LayoutLimits layout_limits(const App& app, const Rect& area) {
    LayoutLimits limits;
    const float list_px = has_band(app) ? 232.0F : 290.0F;
    limits.left.low = std::max(0.14, least_share(app, list_px, area.width(), 0.26F));
    limits.right.low = std::max(0.18, least_share(app, 300.0F, area.width(), 0.34F));
    // The map between them leads, and needs only room to be visible.
    if (is_folded(app)) limits.right.high = std::min(0.58, 0.75 - limits.left.low);
    limits.left_split.low = std::max(0.15, least_share(app, 150.0F, area.height(), 0.40F));
    limits.right_split.high = 1.0 - std::max(0.15, least_share(app, 240.0F, area.height(), 0.46F));
    limits.band.low = least_share(app, 150.0F, area.height(), 0.35F);
    limits.all_numbers = static_cast<float>(least_share(app, 256.0F, area.height(), 0.58F));
    return limits;
}

// Shares clamped for this window; the person's own are kept for a larger one.
Layout within(const LayoutLimits& limits, Layout layout) {
    const auto keep = [](float& share, const Range& range) {
        share = std::clamp(share, static_cast<float>(range.low), static_cast<float>(range.high));
    };
    keep(layout.left, limits.left);
    keep(layout.right, limits.right);
    keep(layout.left_split, limits.left_split);
    keep(layout.right_split, limits.right_split);
    if (layout.band == Layout{}.band) layout.band = std::max(layout.band, limits.all_numbers);
    keep(layout.band, limits.band);
    return layout;
}

float top_of_band(const Rect& area, const Layout& shown) {
    return area.max.y - std::round(shown.band * area.height());
}

// A bar that starts from the share on screen.
void move_splitter(App& app, const Splitter& splitter, float shown, float& share) {
    const float before = shown;
    draw_splitter(app.ui, splitter, shown);
    if (shown != before) share = shown;
}

// The same for a share that grows as its bar moves left or up. The splitter's limits are the
// share's.
void move_far_splitter(App& app, Splitter splitter, float shown, float& share) {
    splitter.share = {1.0 - splitter.share.high, 1.0 - splitter.share.low};
    float before_bar = 1.0F - shown;
    const float begun = before_bar;
    draw_splitter(app.ui, splitter, before_bar);
    if (before_bar != begun) share = 1.0F - before_bar;
}

void draw_splitters(App& app, const Rect& area, const LayoutLimits& limits, const Layout& shown) {
    const float bar = app.ui.theme.splitter_px;
    const float width = area.width();
    const float height = area.height();
    const float x1 = area.min.x + std::round(shown.left * width);
    const float x2 = area.max.x - std::round(shown.right * width);
    const float y1 = area.min.y + std::round(shown.left_split * height);
    const float y2 = area.min.y + std::round(shown.right_split * height);
    const float y3 = top_of_band(area, shown);
    const float end = has_band(app) ? y3 - bar : area.max.y;
    Layout& layout = app.layout;
    move_splitter(app,
                  {"left", {{x1, area.min.y}, {x1 + bar, area.max.y}}, true, width, limits.left},
                  shown.left, layout.left);
    if (has_band(app)) {
        move_far_splitter(
            app, {"band", {{x1 + bar, y3 - bar}, {area.max.x, y3}}, false, height, limits.band},
            shown.band, layout.band);
    } else if (has_editor(app)) {
        move_splitter(
            app,
            {"left split", {{area.min.x, y1}, {x1, y1 + bar}}, false, height, limits.left_split},
            shown.left_split, layout.left_split);
    }
    move_far_splitter(app,
                      {"right", {{x2 - bar, area.min.y}, {x2, end}}, true, width, limits.right},
                      shown.right, layout.right);
    if (is_folded(app)) return;
    move_splitter(
        app, {"right split", {{x2, y2}, {area.max.x, y2 + bar}}, false, height, limits.right_split},
        shown.right_split, layout.right_split);
}

// A share between a pane and its neighbour, and the direction in which the pane grows.
struct Edge {
    float Layout::*share;
    float sign;
    Range limits;
};

// The neighbour at the right gives way first; for a middle column the one at the left is next.
std::vector<Edge> upright_edges(const App& app, Pane pane, const LayoutLimits& limits) {
    if (pane == Pane::patterns) return {{&Layout::left, 1.0F, limits.left}};
    if (pane == Pane::editor) {
        return {{&Layout::left, has_band(app) ? -1.0F : 1.0F, limits.left}};
    }
    const bool is_right = pane == Pane::matrix || (pane == Pane::space && !is_folded(app));
    if (is_right) return {{&Layout::right, 1.0F, limits.right}};
    return {{&Layout::right, -1.0F, limits.right}, {&Layout::left, -1.0F, limits.left}};
}

std::vector<Edge> level_edges(const App& app, Pane pane, const LayoutLimits& limits) {
    if (has_band(app)) {
        if (pane == Pane::patterns) return {};
        return {{&Layout::band, pane == Pane::editor ? 1.0F : -1.0F, limits.band}};
    }
    if (pane == Pane::patterns && has_editor(app))
        return {{&Layout::left_split, 1.0F, limits.left_split}};
    if (pane == Pane::editor) return {{&Layout::left_split, -1.0F, limits.left_split}};
    if (is_folded(app)) return {};
    if (pane == Pane::space) return {{&Layout::right_split, 1.0F, limits.right_split}};
    if (pane == Pane::matrix) return {{&Layout::right_split, -1.0F, limits.right_split}};
    return {};
}

// False if no neighbour can give or take room.
bool move_edge(App& app, const LayoutLimits& limits, const std::vector<Edge>& edges, int steps) {
    constexpr float kStep = 0.02F;  // share of the window
    const Layout shown = within(limits, app.layout);
    for (const Edge& edge : edges) {
        const float moved =
            std::clamp(shown.*edge.share + edge.sign * kStep * static_cast<float>(steps),
                       static_cast<float>(edge.limits.low), static_cast<float>(edge.limits.high));
        if (moved == shown.*edge.share) continue;
        app.layout.*edge.share = moved;
        return true;
    }
    return false;
}

// Keys that move the bars.
void resize_pane_in_use(App& app, const Rect& area) {
    const int wider = std::exchange(app.in_use.wider, 0);
    const int higher = std::exchange(app.in_use.higher, 0);
    const Pane pane = app.in_use.pane;
    const LayoutLimits limits = layout_limits(app, area);
    const auto resize = [&](const std::vector<Edge>& edges, int steps, const char* more,
                            const char* less) {
        if (steps == 0) return;
        const bool moved = move_edge(app, limits, edges, steps);
        const std::string side = steps > 0 ? more : less;
        say(app.ui, name_of_pane(app, pane) + (moved ? ": " : " cannot be ") + side);
    };
    resize(upright_edges(app, pane, limits), wider, "wider", "narrower");
    resize(level_edges(app, pane, limits), higher, "higher", "lower");
}

void draw_left_column(App& app, const Rect& column, float split) {
    if (!has_editor(app) || has_band(app)) return draw_pane_of(app, Pane::patterns, column);
    const float y = column.min.y + std::round(split * column.height());
    draw_pane_of(app, Pane::patterns, {column.min, {column.max.x, y}});
    draw_pane_of(app, Pane::editor, {{column.min.x, y + app.ui.theme.splitter_px}, column.max});
}

// The map above the stages in a row, or alone. In the editor's band they stand at its bottom.
void draw_map_column(App& app, const Rect& column) {
    const float bar = app.ui.theme.splitter_px;
    const float row =
        app.layout.physiology == Fold::row && !has_band(app)
            ? std::round(std::min(kRowPx * app.ui.theme.scale, 0.3F * column.height()))
            : -bar;
    draw_pane_of(app, Pane::space, {column.min, {column.max.x, column.max.y - row - bar}});
    if (row <= 0.0F) return;
    draw_pane_of(app, Pane::physiology, {{column.min.x, column.max.y - row}, column.max});
}

struct PaneButton {
    Pane pane;
    const char* words;
};

constexpr float kChosenFill = 0.34F;  // as of chosen segments

constexpr std::array kPaneButtons = std::to_array<PaneButton>({{Pane::patterns, "List"},
                                                               {Pane::editor, "Editor"},
                                                               {Pane::space, "Map"},
                                                               {Pane::physiology, "Stages"},
                                                               {Pane::matrix, "Answers"}});

// What a step of a lesson speaks of comes with it, and a tab that was chosen, wherever that was.
// The person may then look at another pane.
void follow_shown(App& app) {
    PaneInUse& in_use = app.in_use;
    if (app.layout.maximised) in_use.pane = *std::exchange(app.layout.maximised, std::nullopt);
    if (std::exchange(in_use.bench, app.layout.bench) != app.layout.bench) {
        in_use.pane = Pane::matrix;
    }
    const LessonStep* step = step_of(app.lesson);
    if (std::exchange(in_use.step, app.lesson.step) != app.lesson.step && step != nullptr) {
        in_use.pane = shows_map(*step) ? Pane::space : Pane::physiology;
    }
    const bool is_offered =
        std::ranges::find(kPaneButtons, in_use.pane, &PaneButton::pane) != kPaneButtons.end();
    if (!is_offered) in_use.pane = Pane::space;  // of the view of studies
}

void draw_pane_buttons(App& app, const Rect& row) {
    const float gap = app.ui.theme.splitter_px;
    const auto count = static_cast<float>(kPaneButtons.size());
    const ImVec2 size{std::floor((row.width() - (count - 1.0F) * gap) / count), row.height()};
    for (const auto& [pane, words] : kPaneButtons) {
        const bool chosen = app.in_use.pane == pane;
        // Under the mouse as well, which a finger leaves where it was lifted.
        for (const ImGuiCol part : {ImGuiCol_Button, ImGuiCol_ButtonHovered}) {
            if (chosen) ImGui::PushStyleColor(part, faded(app.ui.theme.accent, kChosenFill));
        }
        const Item item{.id = std::string("pane button:") + words,
                        .label = words,
                        .value = chosen ? "chosen" : ""};
        if (button(app.ui, item, size)) app.in_use.pane = pane;
        if (chosen) ImGui::PopStyleColor(2);
        ImGui::SameLine(0.0F, gap);
    }
}

// The pane in use fills it, as one that is maximised does.
void draw_pane_alone(App& app, const Rect& area) {
    Pane pane = app.in_use.pane;
    const bool is_empty = app.work.document.set.vibrations.empty();
    if (is_empty && pane != Pane::patterns) pane = Pane::start;
    app.layout.maximised = pane;
    draw_pane_of(app, pane, area);
    app.layout.maximised.reset();
}

// A narrow window: one pane above a row of buttons for all of them.
void draw_one_of_panes(App& app, const Rect& area) {
    follow_shown(app);
    const float high = std::max(ImGui::GetFrameHeight(), 32.0F * app.ui.theme.scale);
    const Rect row{{area.min.x, area.max.y - high}, area.max};
    draw_pane_alone(app, {area.min, {area.max.x, row.min.y - app.ui.theme.splitter_px}});
    ImGui::SetNextWindowPos(row.min);
    ImGui::SetNextWindowSize(row.size());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoBackground |
                                        ImGuiWindowFlags_NoSavedSettings;
    if (ImGui::Begin("pane buttons", nullptr, kFlags)) draw_pane_buttons(app, row);
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace

Rect physiology_area(const App& app, const Rect& columns) {
    if (app.layout.maximised || is_narrow(app.ui.theme)) return columns;
    const Layout shown = within(layout_limits(app, columns), app.layout);
    return {{columns.min.x + shown.left * columns.width(), columns.min.y},
            {columns.max.x - shown.right * columns.width(), columns.max.y}};
}

void draw_columns(App& app, const Rect& area) {
    // It is never maximised, as all other panes are empty.
    if (app.layout.maximised == Pane::start) app.layout.maximised.reset();
    if (is_narrow(app.ui.theme)) return draw_one_of_panes(app, area);
    if (app.layout.maximised) return draw_pane_of(app, *app.layout.maximised, area);
    resize_pane_in_use(app, area);
    const float bar = app.ui.theme.splitter_px;
    const LayoutLimits limits = layout_limits(app, area);
    const Layout layout = within(limits, app.layout);
    const float x1 = area.min.x + std::round(layout.left * area.width());
    const float x2 = area.max.x - std::round(layout.right * area.width());
    const float y2 = area.min.y + std::round(layout.right_split * area.height());
    const float y3 = top_of_band(area, layout);
    const float end = has_band(app) ? y3 - bar : area.max.y;
    const Rect middle{{x1 + bar, area.min.y}, {x2 - bar, end}};

    draw_left_column(app, {area.min, {x1, area.max.y}}, layout.left_split);
    if (has_band(app) && app.work.document.set.vibrations.empty()) {
        return draw_pane_of(app, Pane::start, {{x1 + bar, area.min.y}, area.max});
    }
    if (is_folded(app)) {
        draw_map_column(app, middle);
        draw_pane_of(app, Pane::matrix, {{x2, area.min.y}, {area.max.x, end}});
        if (has_band(app)) draw_pane_of(app, Pane::editor, {{x1 + bar, y3}, area.max});
    } else {
        draw_pane_of(app, Pane::physiology, middle);
        draw_pane_of(app, Pane::space, {{x2, area.min.y}, {area.max.x, y2}});
        draw_pane_of(app, Pane::matrix, {{x2, y2 + bar}, area.max});
    }
    draw_splitters(app, area, limits, layout);
}

void draw_presentation(App& app) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float gap = app.ui.theme.splitter_px;
    const Rect all{{gap, gap}, {screen.x - gap, screen.y - gap}};
    const LessonPlaces places = lesson_places(app.ui, app.lesson, all);
    const LessonStep* step = step_of(app.lesson);
    const bool map = step != nullptr && shows_map(*step);
    draw_pane_of(app, map ? Pane::space : Pane::physiology, places.rest);
    draw_lesson_card(lesson_context(app), app.lesson, places);
    draw_pointed(app.ui, places.rest);
    draw_explain_window(app.ui, app.physiology, places.rest);
}

void draw_study_columns(App& app, const Rect& area) {
    if (app.layout.maximised) return draw_pane_of(app, *app.layout.maximised, area);
    constexpr float kDesign = 0.36F;
    constexpr float kPeople = 0.42F;
    const float bar = app.ui.theme.splitter_px;
    const float x = area.min.x + std::round(kDesign * area.width());
    const float y = area.min.y + std::round(kPeople * area.height());
    draw_pane_of(app, Pane::study_design, {area.min, {x, area.max.y}});
    draw_pane_of(app, Pane::study_people, {{x + bar, area.min.y}, {area.max.x, y}});
    draw_pane_of(app, Pane::study_answers, {{x + bar, y + bar}, area.max});
}

}  // namespace tact
