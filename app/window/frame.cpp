#include "app/window/frame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include "app/calibrate/calibrate_state.h"
#include "app/calibrate/measuring_response.h"
#include "app/compare/bench_follow.h"
#include "app/document/editing.h"
#include "app/document/files.h"
#include "app/document/pattern_looks.h"
#include "app/export/exports.h"
#include "app/map/map_follow.h"
#include "app/measured/import_follow.h"
#include "app/measured/import_state.h"
#include "app/model_bench/training_follow.h"
#include "app/physiology/physiology_follow.h"
#include "app/physiology/physiology_panel.h"
#include "app/play/play_panels.h"
#include "app/play/playing.h"
#include "app/study/study_follow.h"
#include "app/study/study_pages.h"
#include "app/subset/subset_follow.h"
#include "app/subset/subset_marks.h"
#include "app/subset/subset_state.h"
#include "app/tour/tour.h"
#include "app/ui/widgets.h"
#include "app/window/animation.h"
#include "app/window/columns.h"
#include "app/window/commands.h"
#include "app/window/dialogs.h"
#include "app/window/jobs.h"
#include "model/map/mds.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kStatusHeightPx = 26.0F;
constexpr double kStatusFadeS = 8.0;

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

// A picture waits for all of them.
void begin_thumbnails(App& app) {
    constexpr std::size_t kSamplesAFrame = 30'000;  // about 1 ms
    if (app.full_job) app.cache.samples_left = kSamplesAFrame;
    app.cache.behind = false;
}

void run_waiting(App& app) {
    for (const auto& act : std::exchange(app.waiting, {})) act();
}

// Who holds a pattern by its name.
void follow_renaming(App& app, const Renaming& renaming) {
    const auto each = [&renaming](auto& names) {
        for (std::string& name : names) follow(renaming, name);
    };
    follow(renaming, app.tour.before.pinned);
    follow(renaming, app.play.felt_on_hover);
    if (auto& sounding = app.play.sounding) {
        each(sounding->names);
        follow(renaming, sounding->as_played.name);
    }
    each(app.import->patterns);
    follow(renaming, app.subset->reference_a);
    follow(renaming, app.subset->reference_b);
    if (auto& opened = app.subset->opened) {
        follow(renaming, opened->first);
        follow(renaming, opened->second);
    }
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
    // What sounds has a clock of its own.
    if (!is_sounding(app)) app.playhead = advanced(app.playhead, app.frame_s, duration_s);
    if (!app.playhead.playing) return;
    app.time_range = followed(fitted(app.time_range, duration_s), app.playhead.at_s, duration_s);
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
    if (io.MouseClicked[0]) app.editor.locked_field.clear();
    app.editor.nudges_on = false;
    const bool moved = io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F;
    if (moved) app.hover_since_s = app.time_s;
}

}  // namespace

void follow_changes(App& app) {
    const DocumentChanges changes = std::exchange(app.changes, {});
    for (const Renaming& renaming : changes.renamings) follow_renaming(app, renaming);
    if (changes.saved_from) keep_participants(app, *changes.saved_from);
}

void draw_frame(App& app, std::span<const KeyPress> pressed, double time_s) {
    app.frame_s = std::clamp(time_s - app.time_s, 0.0, 0.1);
    app.time_s = time_s;
    begin_thumbnails(app);
    take_escape(app, was_pressed(pressed, key::kEscape));
    app.play.held = is_study_running(app);
    follow_sound(app);
    use_device(*app.study, app.play.device);
    follow_playhead(app);
    follow_input_mode(app, pressed);
    take_answers(app);
    follow_progress(app);
    app.selection.hovered_last = app.selection.hovered;
    app.selection.hovered.reset();
    app.selection.too_close = too_close_names(app);
    app.selection.hovered_pair_last = std::exchange(app.selection.hovered_pair, std::nullopt);
    follow_import(app);
    follow_calibrate(app);
    follow_study(app);
    follow_training(app);
    if (is_study_running(app)) {
        draw_study_pages(app, pressed);
        autosave_if_due(app);
        write_rects(app.rects);
        return;
    }

    draw_menus(app);
    run_shortcuts(app, pressed);
    follow_changes(app);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float gap = app.theme.splitter_px;
    const float menu = ImGui::GetFrameHeight();
    const float top = menu + transport_height(app) + gap;
    const float foot = kStatusHeightPx * app.theme.scale;
    draw_transport_bar(app, {{gap, menu}, {screen.x - gap, top - gap}});
    const Rect columns{{gap, top}, {screen.x - gap, screen.y - foot}};
    if (app.study->is_open) {
        draw_study_columns(app, columns);
    } else {
        draw_columns(app, columns);
    }
    take_row_click(app);
    run_waiting(app);
    draw_status(app, {{0.0F, screen.y - foot}, screen});
    draw_explain_window(app, physiology_area(app, columns));
    draw_tour(app, columns);
    draw_dialogs(app);
    draw_palette(app, pressed);
    run_waiting(app);
    follow_changes(app);
    follow_map(app);
    follow_current(app);
    follow_bench(app);
    follow_subset(app);
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
    return app.playhead.playing || is_sounding(app) || app.play.meter > 0.0 || app.cache.behind ||
           is_study_playing(app) || is_exporting(app) || tilts || is_moving(app) || hover_rests ||
           app.fonts_outdated || app.selection.hovered != app.selection.hovered_last ||
           app.selection.hovered_pair != app.selection.hovered_pair_last ||
           app.crosshair_s != app.crosshair_last_s;
}

double next_wake_s(const App& app) {
    double wake_s = std::numeric_limits<double>::infinity();
    if (is_computing(app) || is_bench_computing(app) || is_subset_busy(app) || is_training(app)) {
        wake_s = 0.1;  // progress
    }
    if (app.autosave_pending) wake_s = std::min(wake_s, 0.5);
    wake_s = std::min(wake_s, study_wake_s(app));
    // A little later than it fades, lest the clock's last digit asks for it twice.
    if (status_left_s(app) > 0.0) wake_s = std::min(wake_s, status_left_s(app) + 0.01);
    return wake_s;
}

App make_app() {
    App app;
    app.rects = widget_rects_wanted();
    app.committed = std::make_shared<const PatternSet>();
    app.study = make_study();
    app.import = make_import();
    app.calibrate = std::make_shared<CalibrateState>();
    app.subset = std::make_shared<SubsetState>();
    app.training = std::make_shared<TrainingState>();
    return app;
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
