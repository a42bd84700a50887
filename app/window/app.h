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
#include <vector>

#include "app/compare/live_comparison.h"
#include "app/compare/live_difference.h"
#include "app/document/document.h"
#include "app/document/history.h"
#include "app/document/session.h"
#include "app/document/vibration_cache.h"
#include "app/generate/generate_state.h"
#include "app/jobs/latest_job.h"
#include "app/map/live_map.h"
#include "app/patterns/rhythm_choice.h"
#include "app/physiology/live_stages.h"
#include "app/physiology/stage_signals.h"
#include "app/physiology/stages.h"
#include "app/pictures/pictures.h"
#include "app/play/play_state.h"
#include "app/rendering/rendering_state.h"
#include "app/timeline/playhead.h"
#include "app/ui/file_chooser.h"
#include "app/ui/widget_rects.h"
#include "model/evaluation/findings.h"
#include "viz/drawing/theme.h"
#include "viz/space/space_view.h"

namespace tact {

// What of the document the person is looking at. Indices into document.set.vibrations.
struct Selection {
    std::size_t current = 0;                  // shown in the editor and the middle column
    std::set<std::size_t> others;             // edited together with it
    std::optional<std::size_t> hovered;       // in this frame, by any panel drawn so far
    std::optional<std::size_t> hovered_last;  // in the last frame, by any panel
};

enum class Pane {
    patterns,
    editor,
    physiology,
    space,
    matrix,
    study_design,  // these three in the view of studies
    study_people,
    study_answers
};

struct Layout {
    float left = 0.21F;  // share of the window's width
    float right = 0.34F;
    float left_split = 0.45F;  // share of the column's height above the splitter
    float right_split = 0.58F;
    std::optional<Pane> maximised;
};

// A line at the foot of the window; errors stay until replaced, the rest fades.
struct StatusLine {
    std::string text;
    bool is_error = false;
    double since_s = 0.0;
};

// The map on screen eases from where its points were to where they are. What it is aligned to is
// the last exact map: chained alignments of previews would slowly turn it.
struct MapTransition {
    std::shared_ptr<const LiveMap> shown;
    std::shared_ptr<const LiveMap> anchor;  // the last exact one ...
    Eigen::MatrixXd anchor_points;          // ... as it was shown
    Eigen::MatrixXd from;                   // aligned positions, one row a pattern of `shown`
    Eigen::MatrixXd to;
    Eigen::MatrixXd ghost;  // of the anchor, row by row; NaN for new patterns
    double since_s = -10.0;
};

// A click in the list takes effect at the end of its frame: what it ends in the editor, such as a
// number being typed, still belongs to the pattern selected before.
struct RowClick {
    std::size_t index = 0;
    bool shift = false;
    bool ctrl = false;
};

struct SetPanelState {
    std::optional<RowClick> clicked;
    std::string search;
    std::string rename_text;
    std::optional<std::size_t> renaming;
    bool scroll_to_current = false;
};

struct EditorState {
    std::string active_field;   // arrows nudge it
    double typed_number = 0.0;  // in the entry of active_field; taken when the entry is left
    bool typing_number = false;
    std::string rhythm_text;  // while being typed
    bool rhythm_typing = false;
    RhythmChoice rhythms;
    std::optional<NoteDrag> note_drag;
};

struct PaletteState {
    bool open = false;
    std::string text;
    int choice = 0;
};

// One receptor of one type: its place in the grid of the shown pattern.
struct ReceptorPlace {
    Receptor type = Receptor::pacinian;
    std::size_t index = 0;

    bool operator==(const ReceptorPlace&) const = default;
};

// The layers on screen, kept while neither the pattern nor the step changes.
struct ShownLayers {
    std::shared_ptr<const LiveStages> of;
    std::size_t step = 0;
    PerReceptor<std::vector<RelayLayer>> layers;
};

// Where two patterns part, kept while both stay what they are.
struct ShownDifference {
    std::shared_ptr<const LiveStages> a;
    std::shared_ptr<const LiveStages> b;
    StageDifferences stages;
    std::array<std::vector<std::vector<double>>, kStages.size()> signals;  // a - b
};

struct PhysiologyState {
    std::optional<Stage> open;              // fills the pane; none: all of them, small
    std::optional<Stage> explained;         // its text is open beside it
    Receptor network = Receptor::pacinian;  // whose layers the overview shows
    bool network_chosen = false;            // by the person; else the strongest one
    bool tilted = false;
    double tilt_since_s = -10.0;
    std::optional<double> crosshair_s;       // where any time axis is pointed at in this frame
    std::optional<double> crosshair_last_s;  // and was in the last
    std::optional<ReceptorPlace> hovered;    // in this frame, in any view
    std::optional<ReceptorPlace> hovered_last;
    std::optional<ReceptorPlace> selected;
    ShownLayers layers;
    ShownLayers pinned_layers;
    ShownDifference difference;
};

enum class MatrixQuantity { pm, nc, oc };

// What the lower right pane shows.
enum class BenchTab { matrix, subset, compare, shepard, why, model, device };

enum class CompareView { table, scatter, findings };

// The points of the Shepard diagram, kept while its map stays what it is.
struct ShepardFit {
    std::shared_ptr<const void> owner;
    const PerceptualSpace* of = nullptr;  // in the owner
    std::vector<double> distances;        // in the map, of all pairs
    std::vector<double> disparities;
};

struct ComparePanelState {
    CompareView view = CompareView::table;
    Metric metric = Metric::pm;         // whose scatter is shown, and whose Shepard diagram
    bool shepard_of_people = false;     // instead
    bool cancelled = false;             // by the person, until the next edit ...
    std::uint64_t cancelled_at = 0;     // ... of this revision
    bool compute_large = false;         // the person asked for many patterns
    std::shared_ptr<const LiveMap> of;  // what was asked for last
    ShepardFit fit;
};

enum class ModelView { parameters, training };

// Which view of the model bench is shown, and whose knots it lists.
struct ModelPanelState {
    ModelView view = ModelView::parameters;
    Receptor type = Receptor::pacinian;
    bool threshold = true;  // or slope
};

// What a chosen path is for.
enum class ChooserPurpose {
    open_document,
    save_document,
    load_tables,
    load_ratings,
    load_calibration,
    load_model,
    save_model,
    add_training_set,
    save_calibration_signal,
    open_calibration_recording,
    import_recordings,
    study_folder,
    export_study,
    export_view,
    export_subset,
    export_stages,
    export_animation
};

// What the tour turns to its own ends, as it was.
struct ViewBeforeTour {
    Layout layout;
    std::size_t current = 0;
    std::string pinned;
    Playhead playhead;
    TimeRange time_range;
    std::optional<Stage> open;
};

struct TourState {
    std::optional<std::size_t> step;  // under way
    std::size_t left_at = 0;          // where to take it up again
    ViewBeforeTour before;
};

enum class Dialog {
    none,
    about,
    keys,
    devices,
    calibrate,
    export_view,
    export_animation,
    generate,
    import_recordings,
    simulate_measurement
};

// What of the window is drawn as a picture.
enum class PictureView { window, physiology, space, matrix };

struct RunningAnimation;  // app/export/exports.h
struct StudyState;        // app/study/study_state.h
struct ImportState;       // app/measured/import_state.h
struct CalibrateState;    // app/calibrate/calibrate_state.h
struct SubsetState;       // app/subset/subset_state.h
struct TrainingState;     // app/model_bench/training_state.h

// What the dialogs for export were left at, and what is on its way to files.
struct ExportState {
    PictureView view = PictureView::physiology;
    PictureView moving_view = PictureView::physiology;
    PictureSize picture_size;
    PictureSize frame_size;
    double from_s = 0.0;
    double to_s = 0.0;  // 0: the end of the pattern
    int frames = 150;
    std::filesystem::path picture;  // to be drawn when the window's own frame is done
    std::shared_ptr<RunningAnimation> animation;
};

// How far the exact map is, and since when: what the time left is told from.
struct MapProgress {
    float share = 0.0F;
    double since_s = 0.0;
};

struct App {
    Document document;
    History<PatternSet> history;
    std::shared_ptr<const PatternSet> committed;  // the document as of the last undo step
    std::uint64_t revision = 1;                   // of document.set, every change during a drag too

    Selection selection;
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
    TimeRange time_range;  // of every time axis; of no length: the whole pattern
    PhysiologyState physiology;
    std::optional<MapProgress> map_progress;  // while it is being computed
    bool map_cancelled = false;               // by the person, until the next edit
    bool compute_large = false;               // the person asked for a live map of a very large set
    MapTransition map;
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
    ExportState exports;
    GenerateState generate;
    TourState tour;
    std::shared_ptr<StudyState> study;  // never null after make_app()
    std::shared_ptr<ImportState> import;
    std::shared_ptr<CalibrateState> calibrate;  // null until its dialog is opened
    Session session;
    StatusLine status;
    std::vector<Vibration> clipboard;
    // Shortcuts pressed in the middle of a drag or an entry, until that has ended: in the same
    // frame, for the pattern it began on.
    std::vector<void (*)(App&)> waiting;

    double time_s = 0.0;                 // of the current frame
    double frame_s = 0.0;                // since the last one; short after a rest
    double hover_since_s = 0.0;          // when the mouse came to rest
    bool unsaved = false;                // the document differs from its file ...
    std::uint64_t unsaved_revision = 0;  // ... as of this revision
    bool autosave_pending = false;
    double autosave_due_s = 0.0;
    bool quit = false;
    WidgetRects rects;
    std::function<void()> wake;  // draws a frame soon; from any thread
};

}  // namespace tact
