#include "app/window/window.h"

#include <algorithm>
#include <atomic>
#include <tuple>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/rendering/rendering.h"
#include "app/stages/stages.h"
#include "app/ui/widgets.h"
#include "app/window/app.h"
#include "app/workspaces/workspaces.h"
#include "devices/device/memory_device.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

std::shared_ptr<const LiveStages> stages_of(const LiveStagesRequest& request) {
    std::atomic<float> progress = 0.0F;
    return std::make_shared<const LiveStages>(*compute_live_stages(request, {}, progress));
}

// Edits may be ahead of the jobs; computing the stages takes negligible time.
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
    const LiveMapRequest request{app.work.revision,
                                 app.work.document_number,
                                 std::make_shared<const PatternSet>(set),
                                 app.shown_map.dimensions,
                                 false,
                                 rendered_by(app.rendered)};
    std::atomic<float> progress = 0.0F;
    LiveMapWork work(threads);
    if (auto map = work(request, {}, progress)) {
        map->seconds = 0.0;  // differs from run to run
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

// The actuator that plays the patterns, and the mark of the model.
void add_origin(const App& app, PaneTitle& title) {
    for (const std::string& origin :
         {rendered_words(app.rendered), phrase_of(mark_of(app.work.document.set))}) {
        if (!origin.empty()) title.detail += "   " + origin;
    }
}

PaneTitle physiology_title(const App& app) {
    PaneTitle title{"Physiology", "", {}};
    if (const Vibration* current = current_vibration(app.work)) title.detail = current->name;
    if (!app.work.selection.pinned.empty())
        title.detail += "   compared with   " + app.work.selection.pinned;
    if (!app.work.document.set.name.empty()) title.detail += "   " + app.work.document.set.name;
    add_origin(app, title);
    title.right = {"at " + with_decimals(app.timeline.playhead.at_s, 3) + " s of " +
                   with_decimals(shown_duration_s(app.work), 3) + " s"};
    return title;
}

PaneTitle matrix_title(const App& app) {
    PaneTitle title{"Matrix", app.work.document.set.name, {}};
    if (!title.detail.empty()) title.detail += "   ";
    title.detail += quantity_name(app.shown_map.quantity);
    add_origin(app, title);
    return title;
}

PaneTitle space_title(const App& app) {
    PaneTitle title{"Perceptual space", app.work.document.set.name, {}};
    add_origin(app, title);
    if (shown_side(app.work) != Side::both) title.detail += "   " + shown_patterns_text(app.work);
    if (map_state(app.work, app.shown_map) == MapState::stale)
        title.detail += "   before the last change";
    if (map_state(app.work, app.shown_map) == MapState::preview) title.detail += "   preview";
    if (!app.shown_map.transition.shown ||
        app.shown_map.transition.shown->space.verdict == MdsVerdict::constant)
        return title;
    const PerceptualSpace& space = app.shown_map.transition.shown->space;
    title.right = {"predicted by PM, stress-1 " + with_decimals(space.stress1, 3) + ", " +
                   fit_label(space)};
    return title;
}

void draw_bench_picture(App& app, BenchTab tab, const Rect& area) {
    app.layout.bench = tab;
    draw_pane_of(app, Pane::matrix, area);
}

void draw_view(App& app, PictureView view) {
    const Rect area = rect_at({0.0F, 0.0F}, ImGui::GetIO().DisplaySize);
    switch (view) {
        case PictureView::window:
            return draw_still_window(app);
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
            return draw_pane(app.ui, app.layout, Pane::matrix, area, matrix_title(app),
                             [&app] { draw_matrix_panel(app.ui, app.work, app.shown_map); });
        case PictureView::table:
            return draw_bench_picture(app, BenchTab::candidates, area);
        case PictureView::subset:
            return draw_bench_picture(app, BenchTab::subset, area);
        case PictureView::compare:
            return draw_bench_picture(app, BenchTab::compare, area);
        case PictureView::why:
            return draw_bench_picture(app, BenchTab::why, area);
    }
}

}  // namespace

std::shared_ptr<ViewSnapshot> opened_view(const PatternSet& set, const ViewChoice& choice) {
    auto view = std::make_shared<ViewSnapshot>(make_app());
    App& app = view->app;
    app.ui.rects = {};
    app.ui.motion = false;
    app.work.document.open({set, {}, set});
    app.work.unsaved_revision = app.work.revision;  // nothing to save
    app.rendered.on = choice.rendered_by.has_value();
    app.rendered.by = choice.rendered_by.value_or(RenderedBy{});
    if (const auto& calibration = app.rendered.by.calibration) {
        app.play.calibration = std::make_shared<const Calibration>(*calibration);
    }
    app.shown_map.dimensions = choice.dimensions;
    // The default layout, with the stages open only on request.
    if (choice.view == PictureView::window && !choice.stage && !choice.pinned) {
        app.layout = first_layout(Arrangement::design);
    }
    if (choice.stage || choice.pinned) app.in_use.pane = Pane::physiology;  // of a narrow window
    if (choice.view != PictureView::physiology) compute_map(app, set, choice.threads);
    if (choice.pattern >= set.vibrations.size()) return view;
    app.work.selection.current = choice.pattern;
    app.physiology.stages = stages_of(stages_request(set, choice.pattern, choice.rendered_by));
    app.physiology.view.open = choice.stage;
    app.physiology.view.tilted = choice.tilted;
    app.physiology.view.textbook = choice.textbook;
    if (!choice.pinned) return view;
    app.work.selection.pinned = set.vibrations[*choice.pinned].name;
    app.physiology.pinned_stages =
        stages_of(stages_request(set, *choice.pinned, choice.rendered_by));
    return view;
}

namespace {

// Looks, and the status line; no button, text or popup over the panes.
void copy_looks(const Ui& ui, Ui& still) {
    still.dark = ui.dark;
    still.status = ui.status;
    still.dismissed_hints = ui.dismissed_hints;
    still.ages = ui.ages;
    still.time_s = ui.time_s;
    still.motion = false;
    still.rects = {};
}

// The session's folder is left out: a picture must not save or lock anything.
void copy_work(const Workspace& work, Workspace& still) {
    still.document = work.document;
    still.revision = work.revision;
    still.document_number = work.document_number;
    still.documents = work.documents;
    still.effects = work.effects;
    still.selection = work.selection;
    still.selection.hovered.reset();
    still.selection.hovered_pair.reset();
    still.side = work.side;
    still.own_heights = work.own_heights;
    // The scale comes from rendered waveforms; without it, it would be estimated from the patterns'
    // numbers.
    still.cache.reach_g = work.cache.reach_g;
    still.cache.axis_s = work.cache.axis_s;
    still.cache.reach_of = work.cache.reach_of;
    still.clipboard = work.clipboard;
    still.unsaved = work.unsaved;
    still.unsaved_revision = work.revision;
}

// Copies the bar's and the Device tab's words on the chosen device. A device belongs to the program
// alone, so a silent one replaces it.
void copy_play(const PlayState& play, PlayState& still) {
    still = play;
    still.audio = nullptr;
    still.device = play.device ? std::make_shared<MemoryDevice>(false) : nullptr;
    still.sounding.reset();
}

// The participants' files as they were read. A participant at work has a separate page.
void copy_study(const StudyState& studying, StudyState& still) {
    still.is_open = studying.is_open;
    still.kind = studying.kind;
    still.folder = studying.folder;
    still.answers = studying.answers;
    still.asked = studying.asked;
    still.folder_revision = studying.folder_revision;
    still.shown = studying.shown;
    still.show = studying.show;
    still.rule = studying.rule;
}

void stand_still(App& still) {
    still.timeline.playhead.playing = false;
    still.timeline.crosshair_s.reset();
    still.timeline.crosshair_last_s.reset();
    still.physiology.view.hovered.reset();
    still.physiology.view.explained.reset();
    still.model_bench.training.kept_were_read = true;
}

}  // namespace

// Whole states are copied, so that everything but a room's jobs is in the picture. Every member of
// App is named here: a new one does not compile until it is.
std::shared_ptr<ViewSnapshot> snapshot_of(const App& app) {
    auto view = std::make_shared<ViewSnapshot>(make_app(), scrolled_windows());
    App& still = view->app;
    const auto& [ui, work, opening, layout, in_use, workspaces, timeline, shown_map, rendered,
                 physiology, comparing, pattern_panes, model_bench, play, picking, candidates,
                 steps, transform, pad, proposals, exports, generating, importing, table, sounds,
                 library, studying, planning, phones, calibrating, lesson, course, palette, manual,
                 of_document, aside] = app;
    copy_looks(ui, still.ui);
    copy_work(work, still.work);
    copy_play(play, still.play);
    copy_study(studying, still.studying);
    still.layout = layout;
    still.in_use = in_use;
    still.workspaces = workspaces;
    still.timeline = timeline;
    still.shown_map = shown_map;
    still.rendered = rendered;
    still.physiology = physiology;
    still.comparing = comparing;
    still.pattern_panes = pattern_panes;
    still.model_bench = model_bench;
    still.picking = picking;
    still.candidates = candidates;
    still.library = library;
    still.of_document = of_document;
    // Left out  of pictures: dialogs, which lie over the panes; proposals in the map, which depend
    //           on the mouse; lessons; documents set aside; files being read.
    (void)std::tie(opening, steps, transform, pad, proposals, exports, generating, importing, table,
                   sounds, planning, phones, calibrating, lesson, course, palette, manual, aside);
    stand_still(still);
    bring_up_to_date(still);
    return view;
}

Picture view_picture(ViewSnapshot& of, PictureView view, double at_s, const PictureSize& size) {
    App& still = of.app;
    still.ui.dark = size.dark;
    still.ui.as_picture = view != PictureView::window;
    still.timeline.playhead.at_s = at_s;
    follow_reach(still.work.cache, still.work.document.set, still.work.revision);
    const double duration_s = shown_duration_s(still.work);
    still.timeline.range = followed(shown_range(still.timeline, duration_s), at_s, duration_s);
    PictureOptions options;
    options.dark = size.dark;
    options.scale = size.scale;
    options.svg_ids = size.svg_ids;
    options.extra_text = drawn_text(still.work.document.set);
    options.has_panes = view == PictureView::window;
    options.scrolled = of.scrolled;
    return drawn(size, options, [&still, view](const Theme& theme) {
        still.ui.theme = theme;
        draw_view(still, view);
    });
}

}  // namespace tact
