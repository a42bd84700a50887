#include "app/window/window.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "app/ask/ask.h"
#include "app/calibrate/calibrate.h"
#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/export/export.h"
#include "app/lesson/lesson.h"
#include "app/library/library.h"
#include "app/map/map.h"
#include "app/measured/measured.h"
#include "app/model_bench/model_bench.h"
#include "app/opening/opening.h"
#include "app/physiology/physiology.h"
#include "app/planning/planning.h"
#include "app/play/play.h"
#include "app/sounds/sounds.h"
#include "app/stages/stages.h"
#include "app/study/study.h"
#include "app/subset/subset.h"
#include "app/tables/tables.h"
#include "app/transform/transform.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/map/mds.h"
#include "viz/drawing/body_cache.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kStatusHeightPx = 26.0F;
constexpr float kFingerPx = 44.0F;  // high enough to be hit by one
constexpr double kStatusFadeS = 8.0;

// Scale of everything on screen. Text for a class or a participant grows with the window.
float wanted_scale(const App& app) {
    const ImVec2 window_px = ImGui::GetIO().DisplaySize;
    const float scale = app.ui.content_scale * app.ui.text_scale;
    if (is_study_running(app.studying)) return scale * wanted_page_scale(app.ui, window_px);
    if (is_presenting(app.lesson)) return app.ui.text_scale * presented_growth(window_px);
    return scale;
}

double status_left_s(const App& app) {
    if (app.ui.status.text.empty()) return 0.0;
    const bool stays = app.ui.status.is_error || !app.ui.status.more.empty();
    if (stays || !app.ui.status.is_seen) {
        return std::numeric_limits<double>::infinity();
    }
    return std::max(0.0, app.ui.status.since_s + kStatusFadeS - app.ui.time_s);
}

// A triangle with a "!", because colour alone does not tell errors; returns its width.
float draw_error_sign(const Theme& theme, ImVec2 left_middle) {
    const float half = 0.5F * ImGui::GetTextLineHeight();
    const ImVec2 at{left_middle.x + half, left_middle.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddTriangleFilled({at.x, at.y - half}, {at.x + half, at.y + 0.8F * half},
                           {at.x - half, at.y + 0.8F * half}, theme.error);
    const ImVec2 size = text_size(theme.fonts.small, "!");
    draw_text(list, theme.fonts.small, {at.x - 0.5F * size.x, at.y + 0.1F * half - 0.5F * size.y},
              readable_on(theme.error), "!");
    return 2.0F * half + theme.gap_px;
}

void draw_dismissal(Ui& ui, ImVec2 left_middle) {
    const float side = ImGui::GetFrameHeight();
    ImGui::SetCursorScreenPos({left_middle.x, left_middle.y - 0.5F * side});
    ImGui::PushStyleColor(ImGuiCol_Button, 0);
    ImGui::PushStyleColor(ImGuiCol_Border, 0);
    const Item dismiss{.id = "status:dismiss", .label = "\u00d7", .tip = "Dismiss (Esc)"};
    const bool away = button(ui, dismiss, {side, side});
    ImGui::PopStyleColor(2);
    if (away) ui.status = {};
}

// The link behind the message; returns its width.
float draw_more(Ui& ui, ImVec2 left_middle) {
    if (ui.status.more.empty()) return 0.0F;
    const ImVec2 size = text_size(ui.theme.fonts.regular, ui.status.more);
    ImGui::SetCursorScreenPos({left_middle.x, left_middle.y - 0.5F * size.y});
    if (link(ui, {.id = "link:status more", .label = ui.status.more}))
        ui.waiting.push_back(ui.status.show_more);
    return size.x + ui.theme.gap_px;
}

// The message, cut if there is no room, and its close button.
void draw_said(App& app, const Rect& area) {
    Ui& ui = app.ui;
    const Theme& theme = ui.theme;
    const ImFont* font = theme.fonts.regular;
    float x = area.min.x;
    if (ui.status.is_error) x += draw_error_sign(theme, {x, area.centre().y});
    const float more = ui.status.more.empty() ? 0.0F : text_size(font, ui.status.more).x;
    const float room = area.max.x - x - ImGui::GetFrameHeight() - more - 2.0F * theme.gap_px;
    const std::string shown = shortened(font, ui.status.text, room);
    const ImVec2 size = text_size(font, shown);
    ImGui::SetCursorScreenPos({x, area.centre().y - 0.5F * size.y});
    draw_text(*ImGui::GetWindowDrawList(), font, ImGui::GetCursorScreenPos(),
              ui.status.is_error ? theme.error : theme.dim_text, shown);
    ImGui::Dummy(size);
    if (shown != ui.status.text) draw_tooltip(ui, ui.status.text.c_str());
    note_rect(ui.rects, "status", area.min, area.max, ui.status.text);
    if (!ui.status.is_error && ui.status.more.empty()) return;
    x += size.x + theme.gap_px;
    x += draw_more(ui, {x, area.centre().y});
    draw_dismissal(ui, {x, area.centre().y});
}

void draw_status_line(App& app, const Rect& area) {
    const Theme& theme = app.ui.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float width = is_computing(app) ? 160.0F * theme.scale : 0.0F;
    ImGui::SetCursorScreenPos(
        {area.min.x + theme.padding_px, area.centre().y - 0.5F * ImGui::GetTextLineHeight()});
    const bool is_reading = draw_opening(app.ui, app.opening);
    if (!is_reading && !app.ui.status.text.empty() && status_left_s(app) > 0.0) {
        draw_said(app, {{area.min.x + theme.padding_px, area.min.y},
                        {area.max.x - width - 2.0F * theme.padding_px, area.max.y}});
    }
    if (!is_computing(app)) return;
    const ImVec2 min{area.max.x - width - theme.padding_px, area.centre().y - 2.0F * theme.scale};
    const ImVec2 max{area.max.x - theme.padding_px, min.y + 4.0F * theme.scale};
    list.AddRectFilled(min, max, theme.field, 2.0F * theme.scale);
    const float share = std::clamp(app.shown_map.full_job.progress(), 0.0F, 1.0F);
    list.AddRectFilled(min, {min.x + (max.x - min.x) * share, max.y}, theme.accent,
                       2.0F * theme.scale);
}

void draw_status(App& app, const Rect& area) {
    ImGui::SetNextWindowPos(area.min);
    ImGui::SetNextWindowSize(area.size());
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0F, 0.0F));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0F, 1.0F));  // a low window
    ImGui::Begin("status", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    draw_status_line(app, area);
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void take_row_click(App& app) {
    const std::optional<RowClick> click =
        std::exchange(app.pattern_panes.list.clicked, std::nullopt);
    if (!click || click->index >= app.work.document.set.vibrations.size()) return;
    if (click->shift) {
        select_through(app.work, click->index);
    } else if (click->ctrl) {
        toggle_selected(app.work, click->index);
    } else {
        select_only(app.work, click->index);
    }
}

constexpr std::size_t kThumbnailSamples = 10'000;  // in a frame: about 1 ms, drawn

// A picture waits for all of them.
void begin_thumbnails(App& app) {
    if (has_jobs(app.ui)) app.work.cache.samples_left = kThumbnailSamples;
    app.work.cache.behind = false;
    follow_render_job(app.work.cache, app.ui.wake);
}

// Stages that have just come are drawn first. Thumbnails wait for one frame and no longer: while a
// number is dragged, stages may come with every frame.
void collect_before_thumbnails(App& app) {
    const auto stages = app.physiology.stages;
    collect_results(app);
    VibrationCache& cache = app.work.cache;
    cache.put_off = app.physiology.stages != stages && !cache.put_off;
    if (cache.put_off) cache.samples_left = 0;
}

void run_waiting(App& app) {
    for (const auto& act : std::exchange(app.ui.waiting, {})) act();
    follow_another_document(app);
}

// Everything that holds a pattern by name.
void follow_renaming(App& app, const Renaming& renaming) {
    const auto each = [&renaming](auto& names) {
        for (std::string& name : names) follow(renaming, name);
    };
    follow_renaming(app.lesson, renaming);
    follow(renaming, app.play.felt_on_hover);
    if (auto& sounding = app.play.sounding) {
        each(sounding->names);
        follow(renaming, sounding->as_played.name);
    }
    each(app.importing.patterns);
    follow(renaming, app.picking.reference_a);
    follow(renaming, app.picking.reference_b);
    follow(renaming, app.steps.from);
    follow(renaming, app.steps.to);
    follow(renaming, app.transform.other);
    each(app.pad.corners);
    follow(renaming, app.proposals.varied);
    follow(renaming, app.proposals.put.name);
    if (auto& opened = app.picking.opened) {
        follow(renaming, opened->first);
        follow(renaming, opened->second);
    }
}

void follow_progress(App& app) {
    if (!is_computing(app)) return app.shown_map.progress.reset();
    const float share = app.shown_map.full_job.progress();
    // A newer request restarts the job.
    const bool begun = app.shown_map.progress && share >= app.shown_map.progress->share;
    app.shown_map.progress =
        MapProgress{share, begun ? app.shown_map.progress->since_s : app.ui.time_s};
}

void follow_playhead(App& app) {
    const double duration_s = shown_duration_s(app.work);
    // A device that plays has its own clock.
    if (!is_sounding(app.play))
        app.timeline.playhead = advanced(app.timeline.playhead, app.ui.frame_s, duration_s);
    if (!app.timeline.playhead.playing) return;
    app.timeline.range = unless_whole(
        followed(shown_range(app.timeline, duration_s), app.timeline.playhead.at_s, duration_s),
        duration_s);
}

// Using the mouse again ends the keyboard mode.
void follow_input_mode(App& app, std::span<const KeyPress> pressed) {
    ImGuiIO& io = ImGui::GetIO();
    // Space plays while panes have the keyboard.
    const bool is_over = app.ui.dialog != kNoDialog || app.ui.chooser.is_open || is_popup_open();
    // Space is a note there.
    const bool taps = app.ui.dialog == kTappingDialog;
    if (is_over && !taps && was_pressed(pressed, key::kSpace)) press_focused(app.ui);
    for (const KeyPress& press : pressed) {
        if (press.code != key::kTab || press.alt) continue;
        app.ui.keyboard_mode = true;
        app.ui.rects.tab_order.step = press.shift ? -1 : 1;
        app.ui.rects.tab_order.by_pane = press.ctrl;
    }
    if (io.MouseClicked[0] || io.MouseClicked[1]) {
        app.ui.keyboard_mode = false;
        app.ui.rects.tab_order.has_begun = true;
    }
    if (app.ui.keyboard_mode) {
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    } else {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    }
    if (io.MouseClicked[0]) app.ui.field.locked.clear();
    app.ui.field.nudges_on = false;
    const bool moved = io.MouseDelta.x != 0.0F || io.MouseDelta.y != 0.0F;
    if (moved) app.ui.hover_since_s = app.ui.time_s;
    app.ui.has_pressed = !moved && (app.ui.has_pressed || io.MouseClicked[0] || io.MouseClicked[1]);
    const bool acted = moved || io.MouseClicked[0] || io.MouseClicked[1] || !pressed.empty();
    if (acted && !app.ui.status.is_seen) {
        app.ui.status.is_seen = true;
        app.ui.status.since_s = app.ui.time_s;
    }
}

// Every pane marks the same patterns: picked ones, and those that are too close.
void follow_marks(App& app) {
    app.work.selection.too_close = too_close_names(app.layout, app.picking);
    app.work.selection.picked = picked_names(app.shown_map, app.picking);
    app.work.selection.is_pick_preview = app.picking.pick && is_unsettled(*app.picking.pick);
    follow_unfelt(app.work, app.shown_map);
    follow_stale(app.work);
}

// Input, and results since the last frame.
void begin_frame(App& app, std::span<const KeyPress> pressed, double time_s) {
    app.ui.frame_s = std::clamp(time_s - app.ui.time_s, 0.0, 0.1);
    app.ui.time_s = time_s;
    begin_thumbnails(app);
    take_escape(app.ui, app.timeline, app.play, was_pressed(pressed, key::kEscape));
    app.play.held = is_study_running(app.studying);
    app.play.gapless = app.play.held || app.ui.dialog == kCalibrateDialog;
    follow_class(classroom_of(app));
    follow_sound(app.ui, app.work, app.timeline, app.rendered, app.play);
    use_device(app.studying, app.play.device);
    follow_playhead(app);
    follow_input_mode(app, pressed);
    const bool is_free = !is_in_the_middle(app) && !ImGui::IsAnyItemActive();
    follow_opening(app.ui, app.work, app.opening, is_free);
    follow_another_document(app);
    collect_before_thumbnails(app);
    watch_pointed(app.ui, app.lesson);
    app.ui.presenting = is_presenting(app.lesson);
    follow_progress(app);
    begin_pointing(app.timeline, app.physiology);
    app.work.selection.hovered_last = app.work.selection.hovered;
    app.work.selection.hovered.reset();
    app.work.selection.rested.reset();
    app.work.selection.suggested.reset();
    app.work.selection.on_track = false;
    follow_marks(app);
    follow_reach(app.work.cache, app.work.document.set, app.work.revision);
    app.work.selection.hovered_pair_last =
        std::exchange(app.work.selection.hovered_pair, std::nullopt);
    follow_import(app.ui, app.work, app.importing);
    follow_tables(app.ui, app.work, app.layout, app.table, app.importing);
    follow_sounds(app.ui, app.sounds);
    follow_library(app.ui, app.work, app.library);
    follow_calibrate(app.ui, app.play, app.calibrating);
    follow_study(app.ui, app.work, app.play, app.studying);
    follow_training(app.ui, app.model_bench);
    if (app.ui.theme.scale != wanted_scale(app)) app.ui.fonts_outdated = true;
}

// Beside the pane of a narrow window a card would leave room to neither.
void keep_card_above_or_below(App& app) {
    if (!is_narrow(app.ui.theme)) return;
    if (app.lesson.dock == DockSide::right) app.lesson.dock = DockSide::bottom;
    if (app.lesson.dock == DockSide::left) app.lesson.dock = DockSide::top;
}

void draw_panes(App& app, std::span<const KeyPress> all_pressed) {
    keep_card_above_or_below(app);
    if (!is_presenting(app.lesson)) draw_menus(app);
    const std::vector<KeyPress> pressed =
        take_lesson_keys(lesson_context(app), app.lesson, all_pressed);
    run_shortcuts(app, pressed);
    follow_changes(app);
    if (is_presenting(app.lesson)) {
        draw_presentation(app);
        return run_waiting(app);
    }
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float gap = app.ui.theme.splitter_px;
    const float menu = ImGui::GetFrameHeight();
    const float top = menu + transport_height(app.ui) + gap;
    const float foot = kStatusHeightPx * app.ui.theme.scale;
    draw_transport_bar(app.ui, app.work, app.timeline, app.shown_map, app.rendered, app.play,
                       {{gap, menu}, {screen.x - gap, top - gap}});
    const LessonPlaces places =
        lesson_places(app.ui, app.lesson, {{gap, top}, {screen.x - gap, screen.y - foot}});
    const Rect& columns = places.rest;
    if (app.studying.is_open) {
        draw_study_columns(app, columns);
    } else {
        draw_columns(app, columns);
    }
    take_row_click(app);
    run_waiting(app);
    draw_status(app, {{0.0F, screen.y - foot}, screen});
    draw_explain_window(app.ui, app.physiology, physiology_area(app, columns));
    draw_lesson_card(lesson_context(app), app.lesson, places);
    draw_pointed(app.ui, columns);
    run_waiting(app);
}

// The set of a lesson is not the person's document: the lesson's autosave keeps it.
void keep_what_is_unsaved(App& app) {
    if (!app.lesson.aside) autosave_if_due(app.ui, app.work);
    autosave_lesson_if_due(app.ui, app.work, app.lesson);
}

}  // namespace

void follow_changes(App& app) {
    follow_another_document(app);
    const DocumentChanges changes = std::exchange(app.work.changes, {});
    for (const Renaming& renaming : changes.renamings) follow_renaming(app, renaming);
    if (changes.saved_from) keep_participants(app.ui, app.work, app.studying, *changes.saved_from);
}

void draw_frame(App& app, std::span<const KeyPress> pressed, double time_s) {
    begin_frame(app, pressed, time_s);
    app.ui.reading.clear();
    if (is_study_running(app.studying)) {
        draw_study_pages(app.ui, app.work, app.play, app.studying, pressed);
        keep_what_is_unsaved(app);
        move_focus(app.ui);
        write_rects(app.ui.rects);
        return;
    }

    draw_panes(app, pressed);
    if (app.layout.bench != BenchTab::candidates) app.work.selection.table_order.clear();
    draw_dialogs(app);
    draw_palette(app, pressed);
    draw_over_presentation(app.ui, app.lesson);
    draw_shadows(app.ui.theme);
    run_waiting(app);
    follow_changes(app);
    hear_changes(app.ui, app.work, app.timeline, app.rendered, app.play);
    note_map_places(app.work, app.shown_map);
    follow_map(app.ui, app.work, app.shown_map, app.rendered);
    follow_current(app.ui, app.work, app.rendered, app.physiology);
    follow_pair(app.work, app.shown_map, app.physiology);
    follow_comparing(app.ui, app.work, app.layout, app.shown_map, app.comparing);
    if (app.layout.bench == BenchTab::device) {
        follow_rendering(app.ui, app.rendered, current_vibration(app.work));
    }
    follow_subset(app.ui, app.work, app.layout, app.shown_map, app.picking);
    check_applied(app.ui, app.work, app.shown_map, app.picking);
    follow_steps(app.ui, app.work, app.steps);
    follow_transform(app.ui, app.work, app.transform);
    follow_gap(app.ui, app.work, app.proposals);
    follow_put(app.ui, app.work, app.shown_map, app.proposals);
    follow_proposals(app.ui, app.work, app.shown_map, app.proposals);
    keep_what_is_unsaved(app);
    move_focus(app.ui);
    write_rects(app.ui.rects);
}

void draw_still_window(App& app) {
    begin_thumbnails(app);
    follow_marks(app);
    draw_panes(app, {});
}

bool is_computing(const App& app) { return app.shown_map.full_job.busy(); }

bool is_comparing(const App& app) {
    return app.comparing.comparison_job.busy() || app.comparing.findings_job.busy();
}

bool wants_another_frame(const App& app) {
    const bool hover_rests = app.ui.time_s - app.ui.hover_since_s < 0.5;
    const bool tilts = app.ui.time_s - app.physiology.view.tilt_since_s < 0.3;
    return app.timeline.playhead.playing || is_sounding(app.play) || app.play.meter > 0.0 ||
           app.work.cache.behind || app.physiology.put_off || is_study_playing(app.studying) ||
           is_exporting(app) || tilts || is_moving(app.ui, app.shown_map) || hover_rests ||
           app.ui.fonts_outdated || app.work.selection.hovered != app.work.selection.hovered_last ||
           app.work.selection.hovered_pair != app.work.selection.hovered_pair_last ||
           app.timeline.crosshair_s != app.timeline.crosshair_last_s;
}

double next_wake_s(const App& app) {
    double wake_s = std::numeric_limits<double>::infinity();
    if (is_computing(app) || is_comparing(app) || is_subset_busy(app.picking) ||
        is_training(app.model_bench) || is_opening(app.opening) || is_placing(app.steps) ||
        is_transforming(app.transform) || is_asking(app.proposals) ||
        is_predicting_loss(app.exports.effects) || is_writing_paper(app.exports.paper) ||
        is_planning(app.planning) || is_library_busy(app.library)) {
        wake_s = 0.1;  // progress
    }
    if (app.work.autosave_pending || is_autosaving(app.work) || app.lesson.keep_pending ||
        is_autosaving(app.lesson))
        wake_s = std::min(wake_s, 0.5);
    // Whether a participant's device is asleep is checked while the person looks.
    if (app.ui.dialog == kPhonesDialog) wake_s = std::min(wake_s, 1.0);
    wake_s = std::min({wake_s, study_wake_s(app.ui, app.studying), aging_wake_s(app.ui)});
    // A little after it has faded, so that rounding of the clock does not cause a second frame.
    if (status_left_s(app) > 0.0) wake_s = std::min(wake_s, status_left_s(app) + 0.01);
    return wake_s;
}

App make_app() {
    App app;
    app.ui.rects = widget_rects_wanted();
    return app;
}

void make_theme(App& app) {
    const float scale = wanted_scale(app);
    app.ui.theme = app.ui.dark ? dark_theme(scale) : light_theme(scale);
    app.ui.theme.bodies = std::make_shared<BodyCache>();
    app.ui.theme.fonts = load_fonts(*ImGui::GetIO().Fonts, scale,
                                    drawn_text(app.work.document.set) + drawn_text(app.lesson));
    ImGui::GetStyle() = ImGuiStyle();
    apply(app.ui.theme, ImGui::GetStyle());
    if (app.ui.for_fingers) {
        ImVec2& padding = ImGui::GetStyle().FramePadding;
        const float high_px = kFingerPx * app.ui.theme.scale;
        padding.y = 0.5F * (high_px - app.ui.theme.fonts.regular->FontSize);
    }
    app.ui.fonts_outdated = false;
}

}  // namespace tact
