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
#include "app/physiology/physiology_panel.h"
#include "app/subset/subset_follow.h"
#include "app/ui/widgets.h"
#include "app/window/app.h"
#include "app/window/frame.h"
#include "app/window/map_marks.h"
#include "app/window/still_view.h"

namespace tact {

namespace {

std::shared_ptr<const LiveStages> stages_of(const LiveStagesRequest& request) {
    std::atomic<float> progress = 0.0F;
    return std::make_shared<const LiveStages>(*compute_live_stages(request, {}, progress));
}

// Edits may be ahead of the jobs; stages take no time worth waiting for.
void bring_up_to_date(App& app) {
    const PatternSet& set = app.document.set;
    const auto follow = [&](std::shared_ptr<const LiveStages>& shown, std::size_t index) {
        const LiveStagesRequest request = stages_request(set, index, rendered_by(app.rendering));
        if (!shown || shown->request != request) shown = stages_of(request);
    };
    if (app.selection.current < set.vibrations.size()) follow(app.stages, app.selection.current);
    if (const auto pinned = place_named(set, app.pinned)) follow(app.pinned_stages, *pinned);
}

void compute_map(App& app, const PatternSet& set, int threads) {
    const LiveMapRequest request{app.revision, std::make_shared<const PatternSet>(set), 3, false,
                                 rendered_by(app.rendering)};
    std::atomic<float> progress = 0.0F;
    LiveMapWork work(threads);
    if (auto map = work(request, {}, progress)) {
        map->seconds = 0.0;  // never the same twice
        show_map(app, std::make_shared<const LiveMap>(*std::move(map)));
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
    if (const Vibration* current = current_vibration(app)) title.detail = current->name;
    if (!app.pinned.empty()) title.detail += "   compared with   " + app.pinned;
    if (app.rendering.on) title.detail += "   " + rendered_words(app.rendering);
    char at[64];
    std::snprintf(at, sizeof at, "at %.3f s of %.3f s", app.playhead.at_s, shown_duration_s(app));
    title.right = {at};
    return title;
}

PaneTitle space_title(const App& app) {
    PaneTitle title{"Perceptual space", app.document.set.name, {}};
    if (app.rendering.on) title.detail += "   " + rendered_words(app.rendering);
    if (shown_side(app) != Side::both) title.detail += "   " + shown_patterns_text(app);
    if (map_state(app) == MapState::stale) title.detail += "   before the last change";
    if (map_state(app) == MapState::preview) title.detail += "   preview";
    if (!app.map.shown || app.map.shown->space.verdict == MdsVerdict::constant) return title;
    const double stress1 = app.map.shown->space.stress1;
    char text[96];
    std::snprintf(text, sizeof text, "predicted by PM, stress-1 %.3f, %s", stress1,
                  stress_label(stress1).c_str());
    title.right = {text};
    return title;
}

void draw_view(App& app, PictureView view) {
    const Rect area = rect_at({0.0F, 0.0F}, ImGui::GetIO().DisplaySize);
    switch (view) {
        case PictureView::window:
            return draw_frame(app, {}, 1.0);
        case PictureView::physiology:
            return draw_pane(app, Pane::physiology, area, physiology_title(app),
                             [&app] { draw_physiology_panel(app, false); });
        case PictureView::space:
            return draw_pane(app, Pane::space, area, space_title(app),
                             [&app] { draw_space_panel(app, map_marks(app)); });
        case PictureView::matrix:
            return draw_pane(
                app, Pane::matrix, area,
                {"Matrix", quantity_name(app.matrix_quantity), {rendered_words(app.rendering)}},
                [&app] { draw_matrix_panel(app); });
    }
}

}  // namespace

std::shared_ptr<StillView> opened_view(const PatternSet& set, const ViewChoice& choice) {
    auto view = std::make_shared<StillView>(make_app());
    App& app = view->app;
    app.rects = {};
    app.motion = false;
    app.document = {set, {}, set};
    app.unsaved_revision = app.revision;  // nothing to keep
    app.rendering.on = choice.rendered_by.has_value();
    app.rendering.by = choice.rendered_by.value_or(RenderedBy{});
    if (const auto& calibration = app.rendering.by.calibration) {
        app.play.calibration = std::make_shared<const Calibration>(*calibration);
    }
    if (choice.view != PictureView::physiology) compute_map(app, set, choice.threads);
    if (choice.pattern >= set.vibrations.size()) return view;
    app.selection.current = choice.pattern;
    app.stages = stages_of(stages_request(set, choice.pattern, choice.rendered_by));
    app.physiology.open = choice.stage;
    app.physiology.tilted = choice.tilted;
    if (!choice.pinned) return view;
    app.pinned = set.vibrations[*choice.pinned].name;
    app.pinned_stages = stages_of(stages_request(set, *choice.pinned, choice.rendered_by));
    return view;
}

std::shared_ptr<StillView> still_view(const App& app) {
    auto view = std::make_shared<StillView>(make_app());
    App& still = view->app;
    still.rects = {};
    still.motion = false;
    still.document = app.document;
    still.revision = app.revision;
    still.unsaved_revision = app.revision;
    still.unsaved = app.unsaved;
    still.selection = app.selection;
    still.selection.hovered.reset();
    still.layout = app.layout;
    still.dark = app.dark;
    still.stages = app.stages;
    still.pinned = app.pinned;
    still.pinned_stages = app.pinned_stages;
    still.playhead = app.playhead;
    still.playhead.playing = false;
    still.time_range = app.time_range;
    still.physiology = app.physiology;
    still.crosshair_s.reset();
    still.physiology.hovered.reset();
    still.physiology.explained.reset();
    still.map_cancelled = app.map_cancelled;
    still.document_number = app.document_number;
    still.compute_large_of = app.compute_large_of;
    still.side = app.side;
    still.subset = still_subset(*app.subset);
    still.training = still_training(*app.training);
    still.map = app.map;
    still.map_look = app.map_look;
    still.camera = app.camera;
    still.dimensions = app.dimensions;
    still.matrix_quantity = app.matrix_quantity;
    still.bench = app.bench;
    still.model_panel = app.model_panel;
    still.rendering.on = app.rendering.on;
    still.rendering.by = app.rendering.by;
    still.rendering.shown = app.rendering.shown;
    still.selection.search = app.selection.search;
    still.session.dismissed_hints = app.session.dismissed_hints;
    bring_up_to_date(still);
    return view;
}

Picture view_picture(StillView& of, PictureView view, double at_s, const PictureSize& size) {
    App& still = of.app;
    still.dark = size.dark;
    still.as_picture = view != PictureView::window;
    still.playhead.at_s = at_s;
    const double duration_s = shown_duration_s(still);
    still.time_range = followed(fitted(still.time_range, duration_s), at_s, duration_s);
    PictureOptions options;
    options.dark = size.dark;
    options.scale = size.scale;
    options.extra_text = drawn_text(still.document.set);
    options.has_panes = view == PictureView::window;
    return drawn(size, options, [&still, view](const Theme& theme) {
        still.theme = theme;
        draw_view(still, view);
    });
}

}  // namespace tact
