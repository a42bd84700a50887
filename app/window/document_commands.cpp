// The rows of File, Edit and View. Declared in app/window/commands.h.

#include <array>

#include "app/ask/maybes_follow.h"
#include "app/ask/steps_follow.h"
#include "app/document/editing.h"
#include "app/document/files.h"
#include "app/document/rating_files.h"
#include "app/document/shown_side.h"
#include "app/export/exports.h"
#include "app/generate/generating.h"
#include "app/lesson/presenting.h"
#include "app/measured/import_follow.h"
#include "app/patterns/tapping.h"
#include "app/subset/subset_export.h"
#include "app/wave_strip/wave_strip.h"
#include "app/window/command_actions.h"
#include "app/window/commands.h"
#include "app/window/session_layout.h"

namespace tact {

namespace {

template <GripKind kKind>
void add_at_playhead(App& app) {
    add_at(app.ui, app.work, app.pattern_panes.strip, kKind, app.timeline.playhead.at_s);
}

template <int kStep>
void choose_next_point(App& app) {
    choose_next(app.ui, app.work, app.pattern_panes.strip, kStep);
}

template <Side kSide>
void show_the_side(App& app) {
    show_side(app.work, kSide);
}

template <Side kSide>
bool shows_side(const App& app) {
    return shown_side(app.work) == kSide;
}

template <BenchTab kTab>
void show_bench(App& app) {
    show_tab(app, kTab);
}

template <Arrangement kArrangement>
void show_the_workspace(App& app) {
    show_workspace(app, kArrangement);
}

template <Arrangement kArrangement>
bool shows_workspace(const App& app) {
    return is_workspace(app, kArrangement);
}

template <Fold kFold>
void fold_to(App& app) {
    fold_physiology(app, kFold);
}

template <Fold kFold>
bool is_folded_to(const App& app) {
    return app.layout.physiology == kFold;
}

constexpr auto kDocumentCommands = std::to_array<Command>({
    {"File", "New set", {}, always, [](App& app) { new_document(app.ui, app.work); }},
    {"File", "Open...", ctrl('o'), always, [](App& app) { open_dialog(app.ui, app.work); }, nullptr,
     "load import folder wav txt ahap haptic hjif haps he hla"},
    {"File",
     "Add to set...",
     {},
     always,
     [](App& app) { add_dialog(app.ui, app.work); },
     nullptr,
     "import append effects ahap haptic folder"},
    {"File", "Save", ctrl('s'), always, [](App& app) { save(app.ui, app.work); }},
    {"File", "Save as...", ctrl('s', true), always,
     [](App& app) { save_dialog(app.ui, app.work); }},
    {"File",
     "Load ratings...",
     {},
     has_selection,
     [](App& app) { load_ratings_dialog(app.ui, app.work); },
     nullptr,
     "people study participants compare csv"},
    {"File",
     "Import recordings...",
     {},
     has_selection,
     [](App& app) { import_recordings_dialog(app.ui, app.work); },
     nullptr,
     "measured accelerometer csv wav acceleration"},
    {"File",
     "Actuator maps...",
     {},
     has_effects,
     [](App& app) { app.ui.dialog = Dialog::effect_maps; },
     nullptr,
     "effects read by quest core haptics hz g import ahap haptic"},
    {"File", "Export view...", ctrl('e'), always, [](App& app) { export_view_dialog(app.ui); },
     nullptr, "picture image png svg save"},
    {"File",
     "Export subset...",
     {},
     has_subset,
     [](App& app) { export_subset_dialog(app.ui, app.work, app.shown_map, app.picking); },
     nullptr,
     "picked distinct set table map"},
    {"File",
     "Export report...",
     {},
     has_pairs,
     [](App& app) { export_report_dialog(app.ui, app.work); },
     nullptr,
     "page html groups confuse distinct players client print"},
    {"File",
     "Export vibrations...",
     {},
     has_selection,
     open_effect_export,
     nullptr,
     "ahap haptic hjif android pulsar richtap he hla openxr wav csv phone kotlin loss"},
    {"File",
     "Export stage as CSV...",
     {},
     has_selection,
     [](App& app) { export_stages_dialog(app.ui, app.work, app.rendered, app.physiology); },
     nullptr,
     "stages table numbers save"},
    {"File",
     "Export animation...",
     {},
     has_selection,
     [](App& app) { export_animation_dialog(app.ui, app.work, app.exports); },
     nullptr,
     "film video frames png save"},
    {"File", "Quit", ctrl('q'), always, quit},

    {"Edit", "Undo", ctrl('z'),
     [](const App& app) { return app.work.history.undo_label() != nullptr; },
     [](App& app) { undo(app.ui, app.work); }},
    {"Edit", "Redo", ctrl('z', true),
     [](const App& app) { return app.work.history.redo_label() != nullptr; },
     [](App& app) { redo(app.ui, app.work); }},
    {"Edit", "New pattern", ctrl('n'), always, [](App& app) { add_pattern(app.ui, app.work); },
     nullptr, "add vibration"},
    {"Edit", "Duplicate", ctrl('d'), has_selection,
     [](App& app) { duplicate_selected(app.ui, app.work); }},
    {"Edit", "Generate candidates...", ctrl('g'), always,
     [](App& app) { open_generate(app.ui, app.work, app.generating); }, nullptr,
     "design space factorial sample sobol latin hypercube levels"},
    {"Edit",
     "Steps between...",
     {},
     has_pairs,
     [](App& app) { open_steps(app.ui, app.work, app.steps, {}, {}); },
     nullptr,
     "even morph between interpolate two path series"},
    {"Edit", "Vary", plain('v'), has_editable_pattern,
     [](App& app) { vary(app.ui, app.work, app.maybes); }, nullptr,
     "neighbours variants alternatives others like it ghosts"},
    {"Edit", "Tap a rhythm...", plain('t'), has_editable_pattern,
     [](App& app) { open_tapping(app.ui, app.pattern_panes.tapping); }, nullptr, "beat notes hand"},
    {"Edit",
     "Add a point of amplitude at the playhead",
     {},
     has_editable_pattern,
     add_at_playhead<GripKind::level>,
     nullptr,
     "curve envelope draw"},
    {"Edit",
     "Add a point of frequency at the playhead",
     {},
     has_editable_pattern,
     add_at_playhead<GripKind::frequency>,
     nullptr,
     "curve sweep draw"},
    {"Edit",
     "Add a transient at the playhead",
     {},
     has_editable_pattern,
     add_at_playhead<GripKind::transient>,
     nullptr,
     "burst click tick"},
    {"Edit", "Next point of the pattern", plain('n'), has_editable_pattern, choose_next_point<1>,
     nullptr, "transient curve choose"},
    {"Edit",
     "Point before",
     {'n', key::kUnknown, false, true},
     has_editable_pattern,
     choose_next_point<-1>,
     nullptr,
     "transient curve choose previous"},
    {"Edit", "Rename", special(key::kF1 + 1), has_selection, start_rename},
    {"Edit", "Lock or unlock", ctrl('l'), has_selection,
     [](App& app) { toggle_locked(app.ui, app.work); }},
    {"Edit", "Drop from subsets or not", ctrl('l', true), has_selection,
     [](App& app) { toggle_dropped(app.ui, app.work); }, nullptr, "exclude must not pick"},
    {"Edit", "Copy", ctrl('c'), has_selection, [](App& app) { copy_selected(app.ui, app.work); }},
    {"Edit", "Copy picture", ctrl('c', true), always,
     [](App& app) { app.exports.copy_asked = true; }, nullptr, "clipboard image view slides png"},
    {"Edit", "Paste", ctrl('v'), always, [](App& app) { paste(app.ui, app.work); }},
    {"Edit", "Select all", ctrl('a'), has_selection, [](App& app) { select_all(app.work); }},
    {"Edit", "Delete", special(key::kDelete), has_selection, remove_chosen_or_selected, nullptr,
     "remove"},

    {"View", "Design", ctrl('1'), always, show_the_workspace<Arrangement::design>,
     shows_workspace<Arrangement::design>, "workspace layout columns map"},
    {"View", "Select", ctrl('2'), always, show_the_workspace<Arrangement::select>,
     shows_workspace<Arrangement::select>, "workspace layout candidates subset map"},
    {"View", "Physiology", ctrl('3'), always, show_the_workspace<Arrangement::physiology>,
     shows_workspace<Arrangement::physiology>, "workspace layout stages"},
    {"View", "Study", ctrl('4'), always, [](App& app) { open_study(app.layout, app.studying); },
     [](const App& app) { return app.studying.is_open; },
     "workspace ratings people experiment design participants"},
    {"View", "Present", special(key::kF1 + 4), always, present,
     [](const App& app) { return is_presenting(app.lesson); },
     "lecture projector full screen slides clicker tour lesson"},
    {"View",
     "Save workspace as...",
     {},
     always,
     [](App& app) { open_workspace_dialog(app.ui, app.workspaces); },
     nullptr,
     "layout panes name keep"},
    {"View", "Reset the workspace", {}, always, reset_workspace, nullptr, "layout columns"},
    {"View",
     "Stages in the middle",
     {},
     always,
     fold_to<Fold::open>,
     is_folded_to<Fold::open>,
     "physiology unfold"},
    {"View",
     "Stages in one row",
     {},
     always,
     fold_to<Fold::row>,
     is_folded_to<Fold::row>,
     "physiology fold"},
    {"View",
     "No stages",
     {},
     always,
     fold_to<Fold::closed>,
     is_folded_to<Fold::closed>,
     "physiology close hide"},
    {"View",
     "Reset view of the space",
     {},
     always,
     [](App& app) { app.shown_map.camera = SpaceCamera{}; },
     nullptr,
     "camera"},
    {"View", "Frame the selection in the space", plain('f'), has_selection,
     [](App& app) { app.shown_map.frame_asked = true; }, nullptr, "zoom camera map focus"},
    {"View",
     "Lock the view of the space",
     {},
     always,
     [](App& app) { app.shown_map.camera.locked = !app.shown_map.camera.locked; },
     [](const App& app) { return app.shown_map.camera.locked; },
     "camera map turn"},
    {"View",
     "Dark",
     {},
     always,
     [](App& app) { set_theme(app.ui, true); },
     [](const App& app) { return app.ui.dark; },
     "theme"},
    {"View",
     "Light",
     {},
     always,
     [](App& app) { set_theme(app.ui, false); },
     [](const App& app) { return !app.ui.dark; },
     "theme"},
    {"View", "Matrix", {}, always, show_bench<BenchTab::matrix>, nullptr, "dissimilarity heat map"},
    {"View",
     "Subset",
     {},
     always,
     show_bench<BenchTab::subset>,
     nullptr,
     "pick most distinct confusable separate stable"},
    {"View",
     "Compare with people",
     {},
     always,
     show_bench<BenchTab::compare>,
     nullptr,
     "ratings metrics rho table"},
    {"View",
     "Shepard diagram",
     {},
     always,
     show_bench<BenchTab::shepard>,
     nullptr,
     "stress fit map"},
    {"View",
     "Why are these two different?",
     {},
     always,
     show_bench<BenchTab::why>,
     nullptr,
     "pair channels explain"},
    {"View",
     "Model bench",
     {},
     always,
     show_bench<BenchTab::model>,
     nullptr,
     "parameters weights layers thresholds"},
    {"View",
     "Train on ratings",
     {},
     always,
     show_training,
     nullptr,
     "fit parameters people optimum search model"},
    {"View",
     "What a device makes of it",
     {},
     always,
     show_bench<BenchTab::device>,
     nullptr,
     "rendering actuator controller joy-con energy lost"},
    {"View",
     "Intended and measured",
     {},
     always,
     show_the_side<Side::both>,
     shows_side<Side::both>,
     "both recordings twins"},
    {"View",
     "Intended only",
     {},
     always,
     show_the_side<Side::intended>,
     shows_side<Side::intended>,
     "IPS map patterns"},
    {"View",
     "Measured only",
     {},
     always,
     show_the_side<Side::measured>,
     shows_side<Side::measured>,
     "MPS map recordings twins"},
    {"View", "Larger text", ctrl('+'), always, [](App& app) { step_text_scale(app.ui, 1.1F); },
     nullptr, "zoom scale"},
    {"View", "Smaller text", ctrl('-'), always,
     [](App& app) { step_text_scale(app.ui, 1.0F / 1.1F); }, nullptr, "zoom scale"},
    {"View", "Text as large as the screen says", ctrl('0'), always,
     [](App& app) { set_text_scale(app.ui, 1.0F); }},
    {"View",
     "Motion",
     {},
     always,
     [](App& app) { app.ui.motion = !app.ui.motion; },
     [](const App& app) { return app.ui.motion; },
     "animation"},
    {"View", "Bring hints back", {}, always, [](App& app) { app.ui.dismissed_hints.clear(); }},
});

}  // namespace

std::span<const Command> document_commands() { return kDocumentCommands; }

}  // namespace tact
