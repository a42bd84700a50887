// The program behind the window: the state of all rooms, side by side. Only the window and its
// tests see all of it; a panel gets the parts it needs. draw_frame() in app/window/window.h draws
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "app/ask/ask.h"
#include "app/calibrate/calibrate.h"
#include "app/candidates/candidates.h"
#include "app/classroom/classroom.h"
#include "app/compare/compare.h"
#include "app/course/course.h"
#include "app/document/workspace.h"
#include "app/export/export.h"
#include "app/generate/generate.h"
#include "app/lesson/lesson.h"
#include "app/library/library.h"
#include "app/manual/manual.h"
#include "app/map/map.h"
#include "app/measured/measured.h"
#include "app/model_bench/model_bench.h"
#include "app/opening/opening.h"
#include "app/patterns/patterns.h"
#include "app/phones/phones.h"
#include "app/physiology/physiology.h"
#include "app/planning/planning.h"
#include "app/play/play.h"
#include "app/rendering/rendering.h"
#include "app/sounds/sounds.h"
#include "app/study/study.h"
#include "app/subset/subset.h"
#include "app/tables/tables.h"
#include "app/timeline/timeline.h"
#include "app/transform/transform.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
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
