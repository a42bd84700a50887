#include "app/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include "app/bench_follow.h"
#include "app/commands.h"
#include "app/dialogs.h"
#include "app/editing.h"
#include "app/exports.h"
#include "app/files.h"
#include "app/map_follow.h"
#include "app/panels/panels.h"
#include "app/tour.h"
#include "app/widgets.h"
#include "model/mds.h"
#include "viz/marks.h"

namespace tact {

namespace {

constexpr float kStatusHeightPx = 26.0F;
constexpr double kStatusFadeS = 8.0;

// "exact in 0.8 s", "preview", "computing 40 %": what the numbers on screen are.
std::string map_state_text(const App& app) {
    char text[96];
    const bool busy = is_computing(app);
    const int percent = busy ? static_cast<int>(100.0F * app.full_job->progress()) : 0;
    switch (map_state(app)) {
        case MapState::none:
            if (!busy) return {};
            std::snprintf(text, sizeof text, "computing, %d %%", percent);
            return text;
        case MapState::too_large:
            return "map waits";
        case MapState::exact:
            if (app.map.shown->seconds <= 0.0) return "exact";
            std::snprintf(text, sizeof text, "exact, %.2g s", app.map.shown->seconds);
            return text;
        case MapState::preview:
            std::snprintf(text, sizeof text, "preview; exact %d %%", percent);
            return text;
        case MapState::stale:
            std::snprintf(text, sizeof text, "of an earlier state; computing, %d %%", percent);
            return text;
    }
    return {};
}

// "exact, 5.8 s", or where there is no room for that "exact".
std::vector<std::string> map_state_forms(const App& app) {
    const std::string whole = map_state_text(app);
    return {whole, whole.substr(0, whole.find(','))};
}

std::vector<std::string> space_title_right(const App& app) {
    if (!app.map.shown || app.map.to.rows() < 2) return map_state_forms(app);
    const PerceptualSpace& space = app.map.shown->space;
    if (space.verdict == MdsVerdict::constant) return map_state_forms(app);
    char stress[32];
    std::snprintf(stress, sizeof stress, "stress-1 %.3f", space.stress1);
    const std::string worded = std::string(stress) + ", " + stress_label(space.stress1);
    const std::vector<std::string> state = map_state_forms(app);
    return {worded + "    " + state[0], worded + "    " + state[1],
            std::string(stress) + "    " + state[1], worded, stress};
}

std::vector<std::string> together_forms(const App& app) {
    if (app.selection.others.empty()) return {};
    const std::string count = std::to_string(app.selection.others.size() + 1);
    return {count + " edited together", count + " together", count};
}

PaneTitle bench_title(const App& app) {
    switch (app.bench) {
        case BenchTab::matrix:
            return {"Matrix", "dissimilarity of every pair", map_state_forms(app)};
        case BenchTab::compare:
            return {"Compare", "metrics against people", {}};
        case BenchTab::shepard:
            return {"Shepard", "how well the map fits", {}};
        case BenchTab::why:
            return {"Why", "are these two different?", {}};
        case BenchTab::model:
            return {"Model", "parameters of PM", {}};
    }
    return {};
}

PaneTitle title_of(const App& app, Pane pane) {
    const std::size_t count = app.document.set.vibrations.size();
    const Vibration* current = current_vibration(app);
    const std::string name = current == nullptr ? "" : current->name;
    switch (pane) {
        case Pane::patterns:
            return {"Patterns", "", {std::to_string(count)}};
        case Pane::editor:
            return {"Editor", name, together_forms(app)};
        case Pane::physiology:
            return {"Physiology", name, {}};
        case Pane::space:
            return {"Perceptual space", "", space_title_right(app)};
        case Pane::matrix:
            return bench_title(app);
    }
    return {};
}

void draw_bench(App& app) {
    const auto tab = [&app](BenchTab which, const char* name) {
        if (draw_chip(app, name, name, app.bench == which)) app.bench = which;
        note_item(app.rects, std::string("tab:") + name);
    };
    tab(BenchTab::matrix, "Matrix");
    for (const auto& [which, name] : {std::pair{BenchTab::compare, "Compare"},
                                      {BenchTab::shepard, "Shepard"},
                                      {BenchTab::why, "Why"},
                                      {BenchTab::model, "Model"}}) {
        flow_on(chip_width(app, name), 2.0F * app.theme.scale);
        tab(which, name);
    }
    switch (app.bench) {
        case BenchTab::matrix:
            return draw_matrix_panel(app);
        case BenchTab::compare:
            return draw_compare_panel(app);
        case BenchTab::shepard:
            return draw_shepard_panel(app);
        case BenchTab::why:
            return draw_why_panel(app);
        case BenchTab::model:
            return draw_model_panel(app);
    }
}

void draw_content(App& app, Pane pane) {
    switch (pane) {
        case Pane::patterns:
            return draw_set_panel(app);
        case Pane::editor:
            return draw_editor_panel(app);
        case Pane::physiology:
            return draw_physiology_panel(app);
        case Pane::space:
            return draw_space_panel(app);
        case Pane::matrix:
            return draw_bench(app);
    }
}

void draw(App& app, Pane pane, const Rect& area) {
    draw_pane(app, pane, area, title_of(app, pane), [&app, pane] { draw_content(app, pane); });
}

// What a column or a row of panes needs for its content at this size of text, as a share of the
// window; in a small window the others need room, too.
double least_share(const App& app, float wanted_px, float total_px, float most) {
    return static_cast<double>(std::min(wanted_px * app.theme.scale / total_px, most));
}

struct LayoutLimits {
    Range left{0.14, 0.40};
    Range right{0.18, 0.58};
    Range left_split{0.15, 0.80};
    Range right_split{0.20, 0.85};
};

LayoutLimits layout_limits(const App& app, const Rect& area) {
    LayoutLimits limits;
    limits.left.low = std::max(0.14, least_share(app, 276.0F, area.width(), 0.28F));
    limits.right.low = std::max(0.18, least_share(app, 300.0F, area.width(), 0.34F));
    limits.left_split.low = std::max(0.15, least_share(app, 150.0F, area.height(), 0.40F));
    limits.right_split.high = 1.0 - std::max(0.15, least_share(app, 240.0F, area.height(), 0.46F));
    return limits;
}

// The shares as they are on screen; the person's own stay as they were for a larger window.
Layout within(const LayoutLimits& limits, Layout layout) {
    const auto keep = [](float& share, const Range& range) {
        share = std::clamp(share, static_cast<float>(range.low), static_cast<float>(range.high));
    };
    keep(layout.left, limits.left);
    keep(layout.right, limits.right);
    keep(layout.left_split, limits.left_split);
    keep(layout.right_split, limits.right_split);
    return layout;
}

// A bar that starts from the share on screen.
void move_splitter(App& app, const Splitter& splitter, float shown, float& share) {
    const float before = shown;
    draw_splitter(app, splitter, shown);
    if (shown != before) share = shown;
}

void draw_splitters(App& app, const Rect& area, const LayoutLimits& limits, const Layout& shown) {
    const float bar = app.theme.splitter_px;
    const float width = area.width();
    const float height = area.height();
    const float x1 = area.min.x + std::round(shown.left * width);
    const float x2 = area.max.x - std::round(shown.right * width);
    const float y1 = area.min.y + std::round(shown.left_split * height);
    const float y2 = area.min.y + std::round(shown.right_split * height);
    Layout& layout = app.layout;
    move_splitter(app,
                  {"left", {{x1, area.min.y}, {x1 + bar, area.max.y}}, true, width, limits.left},
                  shown.left, layout.left);
    move_splitter(
        app, {"left split", {{area.min.x, y1}, {x1, y1 + bar}}, false, height, limits.left_split},
        shown.left_split, layout.left_split);
    // The right share grows when its bar moves left.
    float from_left = 1.0F - layout.right;
    move_splitter(app,
                  {"right",
                   {{x2 - bar, area.min.y}, {x2, area.max.y}},
                   true,
                   width,
                   {1.0 - limits.right.high, 1.0 - limits.right.low}},
                  1.0F - shown.right, from_left);
    if (from_left != 1.0F - layout.right) layout.right = 1.0F - from_left;
    move_splitter(
        app, {"right split", {{x2, y2}, {area.max.x, y2 + bar}}, false, height, limits.right_split},
        shown.right_split, layout.right_split);
}

// Three columns, two of them split; the bars between them move the shares.
void draw_columns(App& app, const Rect& area) {
    if (app.layout.maximised) return draw(app, *app.layout.maximised, area);
    const float bar = app.theme.splitter_px;
    const LayoutLimits limits = layout_limits(app, area);
    const Layout layout = within(limits, app.layout);
    const float x1 = area.min.x + std::round(layout.left * area.width());
    const float x2 = area.max.x - std::round(layout.right * area.width());
    const float y1 = area.min.y + std::round(layout.left_split * area.height());
    const float y2 = area.min.y + std::round(layout.right_split * area.height());

    draw(app, Pane::patterns, {area.min, {x1, y1}});
    draw(app, Pane::editor, {{area.min.x, y1 + bar}, {x1, area.max.y}});
    draw(app, Pane::physiology, {{x1 + bar, area.min.y}, {x2 - bar, area.max.y}});
    draw(app, Pane::space, {{x2, area.min.y}, {area.max.x, y2}});
    draw(app, Pane::matrix, {{x2, y2 + bar}, area.max});

    draw_splitters(app, area, limits, layout);
}

double status_left_s(const App& app) {
    if (app.status.text.empty()) return 0.0;
    if (app.status.is_error) return std::numeric_limits<double>::infinity();
    return std::max(0.0, app.status.since_s + kStatusFadeS - app.time_s);
}

void draw_status_line(App& app, const Rect& area, ImDrawList& list) {
    const Theme& theme = app.theme;
    const float y = area.centre().y - ImGui::GetTextLineHeight() / 2.0F;
    const float width = is_computing(app) ? 160.0F * theme.scale : 0.0F;
    const float room = area.width() - width - 3.0F * theme.padding_px;
    if (!app.status.text.empty() && status_left_s(app) > 0.0) {
        draw_text(list, theme.fonts.regular, {area.min.x + theme.padding_px, y},
                  app.status.is_error ? theme.error : theme.dim_text,
                  shortened(theme.fonts.regular, app.status.text, room));
        note_rect(app.rects, "status", area.min, area.max, app.status.text);
    }
    if (!is_computing(app)) return;
    const ImVec2 min{area.max.x - width - theme.padding_px, area.centre().y - 2.0F * theme.scale};
    const ImVec2 max{area.max.x - theme.padding_px, min.y + 4.0F * theme.scale};
    list.AddRectFilled(min, max, theme.field, 2.0F * theme.scale);
    const float share = std::clamp(app.full_job->progress(), 0.0F, 1.0F);
    list.AddRectFilled(min, {min.x + (max.x - min.x) * share, max.y}, theme.accent,
                       2.0F * theme.scale);
}

void draw_status(App& app, const Rect& area) {
    ImGui::SetNextWindowPos(area.min);
    ImGui::SetNextWindowSize(area.size());
    ImGui::Begin("status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    draw_status_line(app, area, *ImGui::GetWindowDrawList());
    ImGui::End();
}

void take_row_click(App& app) {
    const std::optional<RowClick> click = std::exchange(app.set_panel.clicked, std::nullopt);
    if (!click || click->index >= app.document.set.vibrations.size()) return;
    if (click->shift) {
        select_through(app, click->index);
    } else if (click->ctrl) {
        toggle_selected(app, click->index);
    } else {
        select_only(app, click->index);
    }
}

void run_waiting(App& app) {
    for (const auto run : std::exchange(app.waiting, {})) run(app);
}

void follow_progress(App& app) {
    if (!is_computing(app)) return app.map_progress.reset();
    const float share = app.full_job->progress();
    // A newer request begins again.
    const bool begun = app.map_progress && share >= app.map_progress->share;
    app.map_progress = MapProgress{share, begun ? app.map_progress->since_s : app.time_s};
}

void follow_playhead(App& app) {
    const double duration_s = shown_duration_s(app);
    app.playhead = advanced(app.playhead, app.frame_s, duration_s);
    if (!app.playhead.playing) return;
    app.time_range = followed(fitted(app.time_range, duration_s), app.playhead.at_s, duration_s);
}

// Where the middle column is, for what opens beside it.
Rect physiology_area(const App& app, const Rect& columns) {
    if (app.layout.maximised) return columns;
    const Layout shown = within(layout_limits(app, columns), app.layout);
    return {{columns.min.x + shown.left * columns.width(), columns.min.y},
            {columns.max.x - shown.right * columns.width(), columns.max.y}};
}

// The mouse, once used again, ends the keyboard's way through the widgets.
void follow_input_mode(App& app, std::span<const KeyPress> pressed) {
    ImGuiIO& io = ImGui::GetIO();
    for (const KeyPress& press : pressed) {
        if (press.code == key::kTab && !press.ctrl) app.keyboard_mode = true;
    }
    if (io.MouseClicked[0] || io.MouseClicked[1]) app.keyboard_mode = false;
    if (app.keyboard_mode) {
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    }
    // Half of the world types 1,5: in a number the comma is a point.
    if (std::exchange(app.editor.typing_number, false)) {
        for (ImWchar& sign : io.InputQueueCharacters) {
            if (sign == ',') sign = '.';
        }
    }
    const bool moved = io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F;
    if (moved) app.hover_since_s = app.time_s;
}

}  // namespace

void draw_frame(App& app, std::span<const KeyPress> pressed, double time_s) {
    app.frame_s = std::clamp(time_s - app.time_s, 0.0, 0.1);
    app.time_s = time_s;
    follow_playhead(app);
    follow_input_mode(app, pressed);
    take_answers(app);
    follow_progress(app);
    app.selection.hovered_last = app.selection.hovered;
    app.selection.hovered.reset();

    draw_menus(app);
    run_shortcuts(app, pressed);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float gap = app.theme.splitter_px;
    const float menu = ImGui::GetFrameHeight();
    const float top = menu + transport_height(app) + gap;
    const float foot = kStatusHeightPx * app.theme.scale;
    draw_transport_bar(app, {{gap, menu}, {screen.x - gap, top - gap}});
    draw_columns(app, {{gap, top}, {screen.x - gap, screen.y - foot}});
    take_row_click(app);
    run_waiting(app);
    draw_status(app, {{0.0F, screen.y - foot}, screen});
    draw_explain_window(app, physiology_area(app, {{gap, top}, {screen.x - gap, screen.y - foot}}));
    draw_tour(app, {{gap, top}, {screen.x - gap, screen.y - foot}});
    draw_dialogs(app);
    draw_palette(app, pressed);
    follow_current(app);
    follow_bench(app);
    autosave_if_due(app);
    write_rects(app.rects);
}

bool is_computing(const App& app) { return app.full_job && app.full_job->busy(); }

bool is_bench_computing(const App& app) {
    return app.comparison_job && (app.comparison_job->busy() || app.findings_job->busy());
}

bool wants_another_frame(const App& app) {
    const bool hover_rests = app.time_s - app.hover_since_s < 0.5;
    const bool tilts = app.time_s - app.physiology.tilt_since_s < 0.3;
    return app.playhead.playing || is_exporting(app) || tilts || is_moving(app) || hover_rests ||
           app.fonts_outdated || app.selection.hovered != app.selection.hovered_last ||
           app.physiology.crosshair_s != app.physiology.crosshair_last_s;
}

double next_wake_s(const App& app) {
    double wake_s = std::numeric_limits<double>::infinity();
    if (is_computing(app) || is_bench_computing(app)) wake_s = 0.1;  // progress
    if (app.autosave_pending) wake_s = std::min(wake_s, 0.5);
    // A little later than it fades, lest the clock's last digit asks for it twice.
    if (status_left_s(app) > 0.0) wake_s = std::min(wake_s, status_left_s(app) + 0.01);
    return wake_s;
}

App make_app() {
    App app;
    app.rects = widget_rects_wanted();
    app.committed = std::make_shared<const PatternSet>();
    return app;
}

std::string drawn_text(const PatternSet& set) {
    std::string text = set.name;
    for (const Vibration& vibration : set.vibrations) text += vibration.name + vibration.note;
    return text;
}

void make_theme(App& app) {
    const float scale = app.content_scale * app.text_scale;
    app.theme = app.dark ? dark_theme(scale) : light_theme(scale);
    app.theme.fonts = load_fonts(*ImGui::GetIO().Fonts, scale, drawn_text(app.document.set));
    ImGui::GetStyle() = ImGuiStyle();
    apply(app.theme, ImGui::GetStyle());
    app.fonts_outdated = false;
}

}  // namespace tact
