// The program behind the window: the document, its undo steps, the jobs that follow it, and the
// view state of every panel. frame() in app/window/frame.h draws it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "app/compare/compare_state.h"
#include "app/compare/live_comparison.h"
#include "app/compare/live_difference.h"
#include "app/document/changes.h"
#include "app/document/history.h"
#include "app/document/selection.h"
#include "app/document/vibration_cache.h"
#include "app/export/export_state.h"
#include "app/generate/generate_state.h"
#include "app/jobs/latest_job.h"
#include "app/map/live_map.h"
#include "app/map/map_state.h"
#include "app/model_bench/model_state.h"
#include "app/patterns/patterns_state.h"
#include "app/patterns/rhythm_choice.h"
#include "app/physiology/live_stages.h"
#include "app/physiology/physiology_state.h"
#include "app/physiology/stage_signals.h"
#include "app/physiology/stages.h"
#include "app/pictures/pictures.h"
#include "app/play/play_state.h"
#include "app/rendering/rendering_state.h"
#include "app/session/document.h"
#include "app/session/session.h"
#include "app/timeline/playhead.h"
#include "app/tour/tour_state.h"
#include "app/ui/file_chooser.h"
#include "app/ui/layout.h"
#include "app/ui/open_dialog.h"
#include "app/ui/question.h"
#include "app/ui/status_line.h"
#include "app/ui/widget_rects.h"
#include "app/window/palette.h"
#include "model/evaluation/findings.h"
#include "model/set/measured_twin.h"
#include "viz/drawing/theme.h"
#include "viz/space/space_view.h"

namespace tact {

struct StudyState;      // app/study/study_state.h
struct ImportState;     // app/measured/import_state.h
struct CalibrateState;  // app/calibrate/calibrate_state.h
struct SubsetState;     // app/subset/subset_state.h
struct TrainingState;   // app/model_bench/training_state.h

struct App {
    Document document;
    History<PatternSet> history;
    std::shared_ptr<const PatternSet> committed;  // the document as of the last undo step
    std::uint64_t revision = 1;                   // of document.set, every change during a drag too
    std::uint64_t document_number = 1;            // raised when another one takes its place

    DocumentChanges changes;
    Selection selection;
    Side side = Side::both;  // of the set: in the map, the matrix and what follows them
    Layout layout;
    Theme theme;
    bool dark = true;
    float text_scale = 1.0F;     // the person's, on top of the screen's
    float content_scale = 1.0F;  // the screen's
    bool fonts_outdated = false;
    bool motion = true;
    bool as_picture = false;     // panes without what is there to be pressed
    bool keyboard_mode = false;  // Tab moves between widgets, until the mouse is used again

    std::unique_ptr<LatestJob<LiveMapRequest, LiveMap>> preview_job;
    std::unique_ptr<LatestJob<LiveMapRequest, LiveMap>> full_job;
    std::unique_ptr<LatestJob<LiveStagesRequest, LiveStages>> stages_job;
    std::shared_ptr<const LiveStages> stages;  // of the current vibration, or of one before it
    LiveStagesRequest stages_asked;
    std::string pinned;  // name of the pattern shown for comparison; empty: none
    std::unique_ptr<LatestJob<LiveStagesRequest, LiveStages>> pinned_job;
    std::shared_ptr<const LiveStages> pinned_stages;
    LiveStagesRequest pinned_asked;
    std::unique_ptr<LatestJob<ComparisonRequest, Comparison>> comparison_job;
    std::shared_ptr<const Comparison> comparison;  // of the map on screen, or of one before it
    std::unique_ptr<LatestJob<DifferenceRequest, LiveDifference>> difference_job;
    std::shared_ptr<const LiveDifference> difference;
    DifferenceRequest difference_asked;
    std::unique_ptr<LatestJob<int, std::vector<Finding>>> findings_job;  // asked for by number
    std::shared_ptr<const std::vector<Finding>> findings;
    std::string partner;       // name of the pattern that makes a pair with the current one
    bool show_people = false;  // their map over the predicted one
    ComparePanelState compare;
    Playhead playhead;
    PlayState play;
    std::optional<double> crosshair_s;       // where any time axis is pointed at in this frame
    std::optional<double> crosshair_last_s;  // and was in the last
    TimeRange time_range;                    // of every time axis; of no length: the whole pattern
    PhysiologyState physiology;
    std::optional<MapProgress> map_progress;  // while it is being computed
    bool map_cancelled = false;               // by the person, until the next edit
    std::uint64_t compute_large_of = 0;       // the document whose very large map was asked for
    std::uint64_t maps_asked = 0;             // revision that maps were asked for last
    MapTransition map;
    MapLook map_look;
    ShownClusters clusters;
    ShownPaths paths;
    std::size_t map_menu_of = 0;  // the pattern whose menu is open in the map
    SpaceCamera camera;
    int dimensions = 3;
    MatrixQuantity matrix_quantity = MatrixQuantity::pm;
    BenchTab bench = BenchTab::matrix;
    ModelPanelState model_panel;
    RenderingState rendering;
    std::shared_ptr<SubsetState> subset;      // never null
    std::shared_ptr<TrainingState> training;  // never null

    VibrationCache cache;
    SetPanelState set_panel;
    EditorState editor;
    PaletteState palette;
    FileChooser chooser;
    ChooserPurpose chooser_purpose = ChooserPurpose::open_document;
    Dialog dialog = Dialog::none;
    bool escape_taken = false;  // Esc has silenced something in this frame: it closes nothing
    std::optional<Question> question;  // over everything else
    ExportState exports;
    GenerateState generate;
    TourState tour;
    std::shared_ptr<StudyState> study;  // never null after make_app()
    std::shared_ptr<ImportState> import;
    std::shared_ptr<CalibrateState> calibrate;  // never null after make_app()
    Session session;
    StatusLine status;
    std::vector<Vibration> clipboard;
    // What may not be done in the middle of what is being drawn: a shortcut while something is
    // dragged or typed, an action of a row while rows are drawn. It is done in the same frame,
    // after the panels, or after the dialogs.
    std::vector<std::function<void()>> waiting;

    double time_s = 0.0;                 // of the current frame
    double frame_s = 0.0;                // since the last one; short after a rest
    double hover_since_s = 0.0;          // when the mouse came to rest
    bool unsaved = false;                // the document differs from its file ...
    std::uint64_t unsaved_revision = 0;  // ... as of this revision
    bool autosave_pending = false;
    double autosave_due_s = 0.0;
    std::string told_unkept;  // why unsaved changes are in memory alone
    bool quit = false;
    WidgetRects rects;
    std::function<void()> wake;  // draws a frame soon; from any thread
};

}  // namespace tact
