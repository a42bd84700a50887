// Pictures, stages, animations: what is asked before.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/foreign/foreign.h"
#include "app/jobs/jobs.h"
#include "app/map/map.h"
#include "app/physiology/physiology.h"
#include "app/pictures/pictures.h"
#include "app/rendering/rendering.h"
#include "app/ui/ui.h"
#include "model/export/export_loss.h"
#include "model/set/pattern_set.h"

namespace tact {

// File > Export vibrations: patterns as files of phones and other programs, and, computed in the
// background before anything is written, what that costs in perception.
//
// Input     the set as it is when the dialog opens: nothing changes it while that is open
// Output    whole files and the page export_report.html; the status line says where
// Left out  actuators from files, which "tactspace export --onto" takes.

enum class ExportWhich { all, selected, picked };

struct EffectChoice {
    TargetFormat format = TargetFormat::ahap;
    std::string actuator;  // a bundled one; empty: the format's own
    SampledAs sampled;     // of WAV and CSV
    ExportWhich which = ExportWhich::all;

    bool operator==(const EffectChoice&) const = default;
};

// The whole set is predicted even if only picked patterns are written: the others tell whether the
// picked ones are still the best.
struct LossRequest {
    std::uint64_t number = 0;                // each is another one
    std::shared_ptr<const PatternSet> part;  // what the format holds
    std::vector<std::size_t> written;        // of these, in order
    std::size_t recordings = 0;              // left out of the part
    ExportTarget target;
    std::size_t subset_count = 0;  // 0: the usual one
    SubsetObjective objective = SubsetObjective::max_min;
    std::shared_ptr<const LiveMap> known;  // whose prediction saves work; may be null
    std::string date;
};

struct LiveLoss {
    LossRequest request;
    ExportLoss loss;
};

std::optional<LiveLoss> compute_loss(const LossRequest& request, std::stop_token stop,
                                     std::atomic<float>& progress);

// The document when the dialog opened.
struct ExportGround {
    std::shared_ptr<const PatternSet> set;
    std::vector<std::size_t> selected;  // ascending
    std::vector<std::size_t> picked;
    std::size_t subset_count = 0;
    SubsetObjective objective = SubsetObjective::max_min;
    std::shared_ptr<const LiveMap> known;
};

struct EffectExport {
    EffectChoice choice;
    ExportGround ground;
    std::optional<EffectChoice> asked;  // what `request` is of
    LossRequest request;
    std::uint64_t opened = 0;  // of requests up to this another set was asked about
    bool large = false;        // it would take minutes: predicted when that is asked for
    bool without = false;      // nothing is predicted: large, or stopped by the person
    Query<LossRequest, LiveLoss> job;
    std::shared_ptr<const LiveLoss> answer;  // may be of an earlier request
    SpaceCamera camera;
    std::filesystem::path export_to;  // when the frame is done
};

// Where no actuator is chosen: as it was when the set's effects were read, or the format's own.
ExportTarget target_of(const EffectExport& effects);

// The menu's command; `picked` are names.
void export_effects_dialog(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                           const std::vector<std::string>& picked, std::size_t subset_count,
                           SubsetObjective objective, EffectExport& effects);

// Once a frame while the dialog is open: takes the answer, asks where the choice has changed.
void follow_effects(const Ui& ui, EffectExport& effects);
void predict_anyway(const Ui& ui, EffectExport& effects);
void stop_predicting(EffectExport& effects);
bool is_predicting_loss(const EffectExport& effects);

// The answer is that of what is chosen.
bool is_loss_current(const EffectExport& effects);

// Where to, and then the files.
void choose_effect_folder(Ui& ui, const Workspace& work, EffectExport& effects);

// Writes what is asked for: between two frames, as it draws a picture of the map.
void continue_effect_export(Ui& ui, EffectExport& effects);

inline constexpr Dialog kExportEffectsDialog{.title = "Export vibrations", .is_of_document = true};
void draw_effect_dialog(Ui& ui, const Workspace& work, EffectExport& effects);

// The page beside exported files: what the export costs in perception, for who gets them.
//
// Exact     same loss, same bytes.

struct ExportPage {
    const ExportLoss& loss;
    const PatternSet& set;                    // that was predicted
    const std::vector<std::size_t>& written;  // of its patterns ...
    const std::vector<std::string>& files;    // ... as these
};

std::string export_report(const ExportPage& page);

// File > Paper: tables and figures of the publication for the open set and others, each with the
// ratings that it keeps.
//
// The program's own command makes them, in a process of its own: pictures are drawn as the window
// is, which one thread alone may do. So the window and a terminal write the same bytes.
//
// Input     the set as it is when the folder is chosen; sets in files that keep ratings
// Output    a folder with paper.html; the status line says where
// Left out  ratings in files beside a set, which "tactspace paper" takes.

// A set beside the open one.
struct PaperSet {
    std::filesystem::path file;
    std::string name;
    std::string words;  // how many patterns, and whose ratings

    bool operator==(const PaperSet&) const = default;
};

struct PaperRequest {
    std::filesystem::path program;
    std::vector<std::filesystem::path> sets;
    std::filesystem::path written;  // one of them, which goes when all is made; or empty
    std::string along;              // as PaperCommand has it, as are the next
    std::vector<std::string> metrics_from;
    std::filesystem::path out;
};

struct PaperMade {
    std::filesystem::path page;
    std::string fault;  // empty: it is there
};

struct PaperState {
    std::filesystem::path program;  // itself; empty: nothing is started, as in tests
    std::vector<PaperSet> more;
    std::string along;  // the key of a parameter; empty: the one that joins most
    Query<PaperRequest, PaperMade> job;
    std::shared_ptr<const PaperMade> shown;  // the last that was told of
    double begun_s = 0.0;
};

// "12 patterns, ratings of 6 people", who are called synthetic where nobody was asked.
std::string words_on_ratings(const PatternSet& set);

// The menu's command.
inline constexpr Dialog kPaperDialog{.title = "Tables and figures of a paper",
                                     .is_of_document = true};
void open_paper(Ui& ui);

// What the choosers answer. A set without ratings is refused with a reason.
void add_paper_set(Ui& ui, PaperState& paper, const std::filesystem::path& file);
void write_paper(Ui& ui, const Workspace& work, PaperState& paper,
                 const std::vector<std::string>& metrics_from, const std::filesystem::path& folder);

bool is_writing_paper(const PaperState& paper);

// Once a frame: tells what was made, or why it was not.
void take_paper(Ui& ui, PaperState& paper);

// `foreign`: metrics of one's own, which take part.
void draw_paper_dialog(Ui& ui, const Workspace& work, const std::vector<ForeignMetric>& foreign,
                       PaperState& paper);

// How long it has taken so far, and Cancel, where it is under way.
void draw_paper_progress(Ui& ui, PaperState& paper);

// What the dialogs for export were left at, and what is on its way to files.

// The part of the window that is drawn as a picture.
enum class PictureView { window, physiology, space, matrix, table, subset, compare, why };

inline constexpr std::array<PictureView, 8> kPictureViews{
    PictureView::window, PictureView::physiology, PictureView::space,   PictureView::matrix,
    PictureView::table,  PictureView::subset,     PictureView::compare, PictureView::why};

// "physiology": on the command line and in file names.
const char* name_of(PictureView view);

struct ViewSnapshot;  // app/window/window.h

struct RunningAnimation {
    std::shared_ptr<ViewSnapshot> still;  // what is drawn
    PictureView view = PictureView::physiology;
    PictureSize size;
    FrameSequence sequence;
    std::shared_ptr<Film> film;  // one file; null: a picture each
    std::string another_size;    // of the film than was asked, in words
    int done = 0;                // frames
    double begun_s = 0.0;
};

struct ExportState {
    PictureView view = PictureView::physiology;
    PictureView moving_view = PictureView::physiology;
    PictureSize picture_size;
    PictureSize frame_size;
    double from_s = 0.0;
    double to_s = 0.0;  // 0: the end of the pattern
    int frames = 150;
    std::optional<FilmFormat> film = FilmFormat::gif;  // none: pictures in a folder
    std::filesystem::path picture;       // to be drawn when the window's own frame is done
    std::filesystem::path animation_to;  // to be begun by the window
    std::shared_ptr<RunningAnimation> animation;
    bool cancel_asked = false;  // of the animation
    bool copy_asked = false;    // of the view, to the clipboard
    EffectExport effects;       // patterns for phones and other programs
    PaperState paper;           // tables and figures
};

// Exports from the window: a view as a picture, stages as CSV, the animation as numbered pictures.
//
// Output    whole files; the status line says where
// Left out  drawing pictures, which takes the whole program: app/window/window.h

// The menu's commands: each asks for what it needs.
inline constexpr Dialog kExportViewDialog{.title = "Export view", .is_of_document = true};
inline constexpr Dialog kExportAnimationDialog{.title = "Export animation", .is_of_document = true};
void export_view_dialog(Ui& ui);
void export_stages_dialog(Ui& ui, const Workspace& work, const RenderingState& rendered,
                          const Physiology& physiology);
void export_animation_dialog(Ui& ui, const Workspace& work, ExportState& exports);

// Where to: after the dialogs.
void choose_picture(Ui& ui, const Workspace& work, ExportState& exports);
void choose_frames(Ui& ui, const Workspace& work, ExportState& exports);

// What the chooser's answer starts. PNG or SVG by the name's ending; the stage that is open, or
// all of them, with the files of "tactspace stages".
void export_stages(Ui& ui, const Workspace& work, const RenderingState& rendered,
                   const Physiology& physiology, const std::filesystem::path& folder);

// The dialogs, and the progress of an animation.
void draw_exports(Ui& ui, const Workspace& work, ExportState& exports);

}  // namespace tact
