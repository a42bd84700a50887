#include "app/window/view_pictures.h"

#include <algorithm>
#include <atomic>
#include <cstdio>

#include "app/document/editing.h"
#include "app/document/pattern_looks.h"
#include "app/document/shown_side.h"
#include "app/map/live_map.h"
#include "app/map/map_follow.h"
#include "app/map/matrix_panel.h"
#include "app/map/space_panel.h"
#include "app/measured/import_follow.h"
#include "app/model_bench/training_follow.h"
#include "app/stages/physiology_panel.h"
#include "app/subset/subset_follow.h"
#include "app/ui/widgets.h"
#include "app/window/app.h"
#include "app/window/columns.h"
#include "app/window/frame.h"

namespace tact {

namespace {

std::shared_ptr<const LiveStages> stages_of(const LiveStagesRequest& request) {
    std::atomic<float> progress = 0.0F;
    return std::make_shared<const LiveStages>(*compute_live_stages(request, {}, progress));
}

// Edits may be ahead of the jobs; stages take no time worth waiting for.
void bring_up_to_date(App& app) {
    const PatternSet& set = app.work.document.set;
    const auto follow = [&](std::shared_ptr<const LiveStages>& shown, std::size_t index) {
        const LiveStagesRequest request = stages_request(set, index, rendered_by(app.rendered));
        if (!shown || shown->request != request) shown = stages_of(request);
    };
    if (app.work.selection.current < set.vibrations.size())
        follow(app.physiology.stages, app.work.selection.current);
    if (const auto pinned = place_named(set, app.work.selection.pinned))
        follow(app.physiology.pinned_stages, *pinned);
}

void compute_map(App& app, const PatternSet& set, int threads) {
    const LiveMapRequest request{app.work.revision, std::make_shared<const PatternSet>(set),
                                 app.shown_map.dimensions, false, rendered_by(app.rendered)};
    std::atomic<float> progress = 0.0F;
    LiveMapWork work(threads);
    if (auto map = work(request, {}, progress)) {
        map->seconds = 0.0;  // never the same twice
        show_map(app.ui, app.shown_map, std::make_shared<const LiveMap>(*std::move(map)));
    }
}

const char* quantity_name(MatrixQuantity quantity) {
    switch (quantity) {
        case MatrixQuantity::pm:
            return "PM, predicted dissimilarity of every pair";
        case MatrixQuantity::nc:
            return "NC, neural coding of every pair";
        case MatrixQuantity::oc:
            return "OC, rhythm of every pair";
    }
    return "";
}

PaneTitle physiology_title(const App& app) {
    PaneTitle title{"Physiology", "", {}};
    if (const Vibration* current = current_vibration(app.work)) title.detail = current->name;
    if (!app.work.selection.pinned.empty())
        title.detail += "   compared with   " + app.work.selection.pinned;
    if (app.rendered.on) title.detail += "   " + rendered_words(app.rendered);
    char at[64];
    std::snprintf(at, sizeof at, "at %.3f s of %.3f s", app.timeline.playhead.at_s,
                  shown_duration_s(app.work));
    title.right = {at};
    return title;
}

PaneTitle space_title(const App& app) {
    PaneTitle title{"Perceptual space", app.work.document.set.name, {}};
    if (app.rendered.on) title.detail += "   " + rendered_words(app.rendered);
    if (shown_side(app.work) != Side::both) title.detail += "   " + shown_patterns_text(app.work);
    if (map_state(app.work, app.shown_map) == MapState::stale)
        title.detail += "   before the last change";
    if (map_state(app.work, app.shown_map) == MapState::preview) title.detail += "   preview";
    if (!app.shown_map.transition.shown ||
        app.shown_map.transition.shown->space.verdict == MdsVerdict::constant)
        return title;
    const PerceptualSpace& space = app.shown_map.transition.shown->space;
    char text[96];
    std::snprintf(text, sizeof text, "predicted by PM, stress-1 %.3f, %s", space.stress1,
                  fit_label(space).c_str());
    title.right = {text};
    return title;
}

void draw_view(App& app, PictureView view) {
    const Rect area = rect_at({0.0F, 0.0F}, ImGui::GetIO().DisplaySize);
    switch (view) {
        case PictureView::window:
            return draw_frame(app, {}, 1.0);
        case PictureView::physiology:
            return draw_pane(
                app.ui, app.layout, Pane::physiology, area, physiology_title(app), [&app] {
                    draw_physiology_panel(app.ui, app.work, app.timeline, app.physiology, false);
                });
        case PictureView::space:
            return draw_pane(app.ui, app.layout, Pane::space, area, space_title(app), [&app] {
                draw_space_panel(app.ui, app.work, app.shown_map, map_marks(app));
            });
        case PictureView::matrix:
            return draw_pane(
                app.ui, app.layout, Pane::matrix, area,
                {"Matrix", quantity_name(app.shown_map.quantity), {rendered_words(app.rendered)}},
                [&app] { draw_matrix_panel(app.ui, app.work, app.shown_map); });
    }
}

}  // namespace

std::shared_ptr<StillView> opened_view(const PatternSet& set, const ViewChoice& choice) {
    auto view = std::make_shared<StillView>(make_app());
    App& app = view->app;
    app.ui.rects = {};
    app.ui.motion = false;
    app.work.document = {set, {}, set};
    app.work.unsaved_revision = app.work.revision;  // nothing to keep
    app.rendered.on = choice.rendered_by.has_value();
    app.rendered.by = choice.rendered_by.value_or(RenderedBy{});
    if (const auto& calibration = app.rendered.by.calibration) {
        app.play.calibration = std::make_shared<const Calibration>(*calibration);
    }
    app.shown_map.dimensions = choice.dimensions;
    if (choice.view != PictureView::physiology) compute_map(app, set, choice.threads);
    if (choice.pattern >= set.vibrations.size()) return view;
    app.work.selection.current = choice.pattern;
    app.physiology.stages = stages_of(stages_request(set, choice.pattern, choice.rendered_by));
    app.physiology.view.open = choice.stage;
    app.physiology.view.tilted = choice.tilted;
    if (!choice.pinned) return view;
    app.work.selection.pinned = set.vibrations[*choice.pinned].name;
    app.physiology.pinned_stages =
        stages_of(stages_request(set, *choice.pinned, choice.rendered_by));
    return view;
}

std::shared_ptr<StillView> still_view(const App& app) {
    auto view = std::make_shared<StillView>(make_app());
    App& still = view->app;
    still.ui.rects = {};
    still.ui.motion = false;
    still.work.document = app.work.document;
    still.work.revision = app.work.revision;
    still.work.unsaved_revision = app.work.revision;
    still.work.unsaved = app.work.unsaved;
    still.work.selection = app.work.selection;
    still.work.selection.hovered.reset();
    still.layout = app.layout;
    still.ui.dark = app.ui.dark;
    still.physiology.stages = app.physiology.stages;
    still.work.selection.pinned = app.work.selection.pinned;
    still.physiology.pinned_stages = app.physiology.pinned_stages;
    still.timeline.playhead = app.timeline.playhead;
    still.timeline.playhead.playing = false;
    still.timeline.range = app.timeline.range;
    still.physiology.view = app.physiology.view;
    still.timeline.crosshair_s.reset();
    still.physiology.view.hovered.reset();
    still.physiology.view.explained.reset();
    still.shown_map.cancelled = app.shown_map.cancelled;
    still.work.document_number = app.work.document_number;
    still.shown_map.compute_large_of = app.shown_map.compute_large_of;
    still.work.side = app.work.side;
    still.picking = still_subset(app.picking);
    still.model_bench.training = still_training(app.model_bench.training);
    still.shown_map.transition = app.shown_map.transition;
    still.shown_map.look = app.shown_map.look;
    still.shown_map.camera = app.shown_map.camera;
    still.shown_map.dimensions = app.shown_map.dimensions;
    still.shown_map.quantity = app.shown_map.quantity;
    still.layout.bench = app.layout.bench;
    still.model_bench.panel = app.model_bench.panel;
    still.rendered.on = app.rendered.on;
    still.rendered.by = app.rendered.by;
    still.rendered.at_bar_level = app.rendered.at_bar_level;
    still.rendered.shown = app.rendered.shown;
    still.work.selection.search = app.work.selection.search;
    still.ui.dismissed_hints = app.ui.dismissed_hints;
    bring_up_to_date(still);
    return view;
}

Picture view_picture(StillView& of, PictureView view, double at_s, const PictureSize& size) {
    App& still = of.app;
    still.ui.dark = size.dark;
    still.ui.as_picture = view != PictureView::window;
    still.timeline.playhead.at_s = at_s;
    follow_reach(still.work.cache, still.work.document.set, still.work.revision);
    const double duration_s = shown_duration_s(still.work);
    still.timeline.range = followed(fitted(still.timeline.range, duration_s), at_s, duration_s);
    PictureOptions options;
    options.dark = size.dark;
    options.scale = size.scale;
    options.svg_ids = size.svg_ids;
    options.extra_text = drawn_text(still.work.document.set);
    options.has_panes = view == PictureView::window;
    return drawn(size, options, [&still, view](const Theme& theme) {
        still.ui.theme = theme;
        draw_view(still, view);
    });
}

}  // namespace tact
