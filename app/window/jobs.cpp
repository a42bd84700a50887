#include "app/window/window.h"

#include <utility>

#include "app/compare/compare.h"
#include "app/course/course.h"
#include "app/lesson/lesson.h"
#include "app/library/library.h"
#include "app/manual/manual.h"
#include "app/map/map.h"
#include "app/physiology/physiology.h"
#include "app/play/play.h"
#include "app/study/study.h"

namespace tact {

namespace {

// Each of these functions returns the state for a document that was just opened. It lists the
// members that stay; a new member belongs to the document, and is reset with it.
ShownMap for_another_document(const ShownMap& was) {
    ShownMap fresh;
    fresh.look.show_pairs = was.look.show_pairs;
    fresh.look.show_spread = was.look.show_spread;
    fresh.clustered_matrix = was.clustered_matrix;
    fresh.camera.locked = was.camera.locked;
    fresh.dimensions = was.dimensions;
    fresh.quantity = was.quantity;
    return fresh;
}

Physiology for_another_document(const Physiology& was) {
    Physiology fresh;
    fresh.view.open = was.view.open;
    fresh.view.textbook = was.view.textbook;
    fresh.view.tilted = was.view.tilted;
    fresh.view.explained = was.view.explained;
    return fresh;
}

PatternPanes for_another_document(const PatternPanes& was) {
    PatternPanes fresh;
    fresh.strip.height = was.strip.height;
    fresh.strip.tool = was.strip.tool;
    fresh.editor.tab = was.editor.tab;
    return fresh;
}

// Findings of the paper are about its own sets.
Comparing for_another_document(const Comparing& was) {
    Comparing fresh;
    fresh.findings = was.findings;
    fresh.foreign = was.foreign;
    fresh.panel.view = was.panel.view;
    fresh.panel.metric = was.panel.metric;
    return fresh;
}

SubsetState for_another_document(const SubsetState& was) {
    SubsetState fresh;
    fresh.view = was.view;
    return fresh;
}

CandidatesState for_another_document(const CandidatesState& was) {
    CandidatesState fresh;
    fresh.by = was.by;
    fresh.descending = was.descending;
    return fresh;
}

RenderingState for_another_document(const RenderingState& was) {
    RenderingState fresh;
    fresh.on = was.on;
    fresh.by = was.by;
    fresh.at_bar_level = was.at_bar_level;
    return fresh;
}

PlanState for_another_document(const PlanState& was) {
    PlanState fresh;
    fresh.choice = was.choice;
    return fresh;
}

EffectExport for_another_document(const EffectExport& was) {
    EffectExport fresh;
    fresh.choice = was.choice;
    fresh.choice.which = ExportWhich::all;
    return fresh;
}

// Assigns from a copy, not by moving: jobs keep their thread, and forget their requests.
template <class State>
void begin_again(State& state, const State& fresh) {
    state = fresh;
}

void begin_again(App& app) {
    auto findings = std::move(app.comparing.findings_job);
    begin_again(app.comparing, for_another_document(app.comparing));
    app.comparing.findings_job = std::move(findings);
    begin_again(app.shown_map, for_another_document(app.shown_map));
    begin_again(app.physiology, for_another_document(app.physiology));
    begin_again(app.pattern_panes, for_another_document(app.pattern_panes));
    begin_again(app.picking, for_another_document(app.picking));
    begin_again(app.candidates, for_another_document(app.candidates));
    begin_again(app.steps, StepsState{});
    begin_again(app.transform, TransformState{});
    begin_again(app.pad, PadState{});
    begin_again(app.proposals, ProposalsState{});
    begin_again(app.generating, GenerateState{});
}

// The parts that are never set aside. Training stays: it takes hours, and its result names its
// sets.
void begin_others_again(App& app) {
    Ui& ui = app.ui;
    if (ui.dialog.is_of_document) ui.dialog = kNoDialog;
    ui.ages.clear();
    ui.progress.clear();
    begin_again(app.rendered, for_another_document(app.rendered));
    begin_again(app.exports.effects, for_another_document(app.exports.effects));
    begin_again(app.planning, for_another_document(app.planning));
    app.exports.from_s = app.exports.to_s = 0.0;
    app.importing.files.clear();
    app.importing.patterns.clear();
    app.importing.shown = 0;
    app.importing.answer.reset();
    app.importing.simulated.reset();
    begin_again(app.table, TableState{});
    begin_again(app.sounds, SoundsState{});
    forget_alike(app.library);  // like a pattern of another document
    app.play.hovered_in_map.reset();
    app.play.felt_on_hover.clear();
    if (is_study_running(app.studying)) return;
    if (app.play.sounding) silence(app.timeline, app.play);
    app.studying.answers.reset();
    app.studying.asked = {};
    app.studying.shown.reset();
    app.studying.leaving_out = {};
    app.studying.rounds_text.clear();
    app.studying.edited_text.clear();
    app.studying.job.forget();
}

void begin_time_again(Timeline& timeline) {
    timeline.range = {};
    timeline.crosshair_s.reset();
    timeline.crosshair_last_s.reset();
    timeline.playhead.at_s = 0.0;
    timeline.playhead.playing = false;
}

void swap_with_aside(App& app) {
    DocumentRooms& aside = app.aside;
    std::swap(app.shown_map, aside.shown_map);
    std::swap(app.physiology, aside.physiology);
    std::swap(app.comparing, aside.comparing);
    std::swap(app.pattern_panes, aside.pattern_panes);
    std::swap(app.picking, aside.picking);
    std::swap(app.candidates, aside.candidates);
    std::swap(app.steps, aside.steps);
    std::swap(app.transform, aside.transform);
    std::swap(app.pad, aside.pad);
    std::swap(app.proposals, aside.proposals);
    std::swap(app.generating, aside.generating);
    // The lesson has replaced these, or has restored them.
    app.shown_map.camera = aside.shown_map.camera;
    app.shown_map.dimensions = aside.shown_map.dimensions;
    app.physiology.view.open = aside.physiology.view.open;
    app.pattern_panes.strip.height = aside.pattern_panes.strip.height;
}

// True if the rooms again are those of the document set aside, unchanged.
bool come_and_go_with_lesson(App& app) {
    const bool is_lesson =
        app.lesson.aside && app.lesson.document_number == app.work.document_number;
    const bool comes_back = app.aside.document == app.work.document_number;
    if (is_lesson && app.aside.document == 0) {
        app.aside.document = app.of_document;
        swap_with_aside(app);
    } else if (comes_back) {
        app.aside.document = 0;
        swap_with_aside(app);
    } else if (!is_lesson) {
        app.aside.document = 0;
    }
    return comes_back;
}

}  // namespace

void follow_another_document(App& app) {
    follow_document(lesson_context(app), app.lesson);  // a lesson whose set was replaced ends first
    const std::uint64_t number = app.work.document_number;
    if (app.of_document == number) return;
    const bool is_first = app.of_document == 0;  // the session has restored its views
    const bool knows_it = !is_first && come_and_go_with_lesson(app);
    app.of_document = number;
    if (is_first) return;
    const bool is_lesson = app.lesson.aside.has_value();
    const SpaceCamera camera = app.shown_map.camera;
    if (!knows_it) begin_again(app);
    if (is_lesson) app.shown_map.camera = camera;
    if (!is_lesson && !knows_it) begin_time_again(app.timeline);
    begin_others_again(app);
}

void collect_results(App& app) {
    const auto map = app.shown_map.transition.shown;
    take_maps(app.ui, app.shown_map);
    // A frame that draws a new map leaves new stages to the next one.
    bool& put_off = app.physiology.put_off;
    put_off = app.shown_map.transition.shown != map && !put_off;
    if (!put_off) take_stages(app.physiology);
    follow_lesson(app.ui, app.lesson);
    follow_course(app.ui, app.work.session, app.lesson, app.course);
    take_manual(app.ui, app.manual);
    take_paper(app.ui, app.exports.paper);
    take_compare_answers(app.comparing);
    take_rendering(app.rendered);
}

}  // namespace tact
