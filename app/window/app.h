// The program behind the window: the state of all rooms, side by side. Only the window and its
// tests see all of it; a panel gets the parts it needs. draw_frame() in app/window/frame.h draws
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "app/ask/pad_state.h"
#include "app/ask/proposals_state.h"
#include "app/ask/steps_state.h"
#include "app/calibrate/calibrate_state.h"
#include "app/candidates/candidates_state.h"
#include "app/classroom/classroom.h"
#include "app/compare/compare_state.h"
#include "app/course/course_state.h"
#include "app/document/workspace.h"
#include "app/export/export_state.h"
#include "app/generate/generate_state.h"
#include "app/lesson/lesson.h"
#include "app/library/library_state.h"
#include "app/manual/manual_state.h"
#include "app/map/map_state.h"
#include "app/measured/import_state.h"
#include "app/model_bench/model_state.h"
#include "app/opening/opening_state.h"
#include "app/patterns/patterns_state.h"
#include "app/phones/phones_state.h"
#include "app/physiology/physiology_state.h"
#include "app/planning/plan_state.h"
#include "app/play/play_state.h"
#include "app/rendering/rendering_state.h"
#include "app/sounds/sounds_state.h"
#include "app/study/study_state.h"
#include "app/subset/subset_state.h"
#include "app/tables/table_state.h"
#include "app/timeline/timeline.h"
#include "app/transform/transform_state.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"
#include "app/workspaces/workspaces.h"

namespace tact {

// State of the command palette.
struct PaletteState {
    bool open = false;
    std::string text;
    int choice = 0;
};

// The pane with the keyboard, and the number of steps by which it grows.
struct PaneInUse {
    Pane pane = Pane::space;
    int wider = 0;
    int higher = 0;
    // What a narrow window showed last.
    std::optional<std::size_t> step{};  // of the lesson
    BenchTab bench = BenchTab::matrix;
};

// State that belongs to one document. While a lesson shows its own set, that of the person's
// document is set aside with its running work, and comes back with it.
struct DocumentRooms {
    std::uint64_t document = 0;  // document number; 0: nothing is set aside
    ShownMap shown_map;
    Physiology physiology;
    Comparing comparing;
    PatternPanes pattern_panes;
    SubsetState picking;
    CandidatesState candidates;
    StepsState steps;
    TransformState transform;
    PadState pad;
    ProposalsState proposals;
    GenerateState generating;
};

struct App {
    Ui ui;
    Workspace work;
    Opening opening;
    Layout layout;
    PaneInUse in_use;
    Workspaces workspaces;
    Timeline timeline;
    ShownMap shown_map;
    RenderingState rendered;
    Physiology physiology;
    Comparing comparing;
    PatternPanes pattern_panes;
    ModelBench model_bench;
    PlayState play;
    SubsetState picking;
    CandidatesState candidates;
    StepsState steps;
    TransformState transform;
    PadState pad;
    ProposalsState proposals;
    ExportState exports;
    GenerateState generating;
    ImportState importing;
    TableState table;
    SoundsState sounds;
    LibraryState library;
    StudyState studying;
    PlanState planning;
    PhonesState phones;
    CalibrateState calibrating;
    LessonState lesson;
    CourseState course;
    PaletteState palette;
    ManualState manual;
    std::uint64_t of_document = 0;  // number of the document that the rooms belong to; 0: none yet
    DocumentRooms aside;
};

// The parts of the program used by a class with phones.
inline Classroom classroom_of(App& app) {
    return {app.ui,   app.work,     app.layout, app.shown_map,
            app.play, app.studying, app.lesson, app.phones};
}

// The parts of the program driven by a lesson.
inline LessonContext lesson_context(App& app) {
    return {app.ui, app.work, app.layout, app.timeline, app.shown_map, app.physiology};
}

}  // namespace tact
