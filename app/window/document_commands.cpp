// The rows of File and Edit.

#include <array>

#include "app/ask/ask.h"
#include "app/document/editing.h"
#include "app/export/export.h"
#include "app/generate/generate.h"
#include "app/layers/layers.h"
#include "app/library/library.h"
#include "app/measured/measured.h"
#include "app/opening/opening.h"
#include "app/patterns/patterns.h"
#include "app/pictures/pictures.h"
#include "app/sounds/sounds.h"
#include "app/subset/subset.h"
#include "app/tables/tables.h"
#include "app/transform/transform.h"
#include "app/wave_strip/wave_strip.h"
#include "app/window/window.h"

namespace tact {

namespace {

bool is_current_locked(const App& app) {
    const Vibration* current = current_vibration(app.work);
    return current != nullptr && current->locked;
}

bool is_current_dropped(const App& app) {
    const Vibration* current = current_vibration(app.work);
    return current != nullptr && current->dropped;
}

template <GripKind kKind>
void add_at_playhead(App& app) {
    add_at(app.ui, app.work, app.pattern_panes.strip, kKind, app.timeline.playhead.at_s);
}

template <StripTool kTool>
void take_tool(App& app) {
    app.pattern_panes.strip.tool = kTool;
    app.pattern_panes.editor.tab = EditorTab::drawing;
}

template <StripTool kTool>
bool has_tool(const App& app) {
    return app.pattern_panes.strip.tool == kTool;
}

template <int kStep>
void choose_next_point(App& app) {
    choose_next(app.ui, app.work, app.pattern_panes.strip, kStep);
}

constexpr auto
    kDocumentCommands =
        std::to_array<Command>(
            {
                {"File", "New set", {}, always, [](App& app) { new_document(app.ui, app.work); }},
                {"File", "Open...", ctrl('o'), always,
                 open_dialog, nullptr,
                 "load import folder wav txt ahap haptic hjif haps he hla pulsar android vibrate web"},
                {"File",
                 "Add to set...",
                 {},
                 always,
                 [](App& app) { add_dialog(app.ui, app.work, app.opening); },
                 nullptr,
                 "import append effects ahap haptic folder"},
                {"File",
                 "Open library...",
                 {},
                 always,
                 [](App& app) { open_library_dialog(app.ui, app.work, app.layout, app.library); },
                 nullptr,
                 "folder effects search tags like shape replace add"},
                {"File",
                 "Files not read...",
                 {},
                 has_unread_files,
                 [](App& app) { tell_left_out(app.ui, app.opening); },
                 nullptr,
                 "left out reasons folder open refused"},
                {"File", "Save", ctrl('s'), always, [](App& app) { save(app.ui, app.work); }},
                {"File", "Save as...", ctrl('s', true), always,
                 [](App& app) { save_dialog(app.ui, app.work); }},
                {"File",
                 "Load ratings...",
                 {},
                 has_selection,
                 [](App& app) { load_ratings_dialog(app.ui, app.work, app.table); },
                 nullptr,
                 "people study participants compare csv"},
                {"File",
                 "Open table...",
                 {},
                 has_selection,
                 [](App& app) { open_table_dialog(app.ui, app.work, app.table); },
                 nullptr,
                 "csv columns ratings recording separator decimal comma jspsych psychopy"},
                {"File",
                 "Import recordings...",
                 {},
                 has_selection,
                 [](App& app) { import_recordings_dialog(app.ui, app.work, app.importing); },
                 nullptr,
                 "measured accelerometer csv wav acceleration"},
                {"File",
                 "From sound...",
                 {},
                 always,
                 [](App& app) { from_sound_dialog(app.ui, app.work, app.sounds); },
                 nullptr,
                 "audio music mp3 flac ogg wav envelope onsets import"},
                {"File",
                 "Actuator maps...",
                 {},
                 has_effects,
                 [](App& app) { app.ui.dialog = kEffectMapsDialog; },
                 nullptr,
                 "effects read by quest core haptics hz g import ahap haptic"},
                {"File", "Export view...", ctrl('e'), always,
                 [](App& app) { export_view_dialog(app.ui); }, nullptr,
                 "picture image png svg save"},
                {"File",
                 "Export subset...",
                 {},
                 has_exact_subset,
                 [](App& app) {
                     export_subset_dialog(app.ui, app.work, app.shown_map, app.picking);
                 },
                 nullptr,
                 "picked distinct set table map"},
                {"File",
                 "Export report...",
                 {},
                 has_pairs,
                 [](App& app) { export_report_dialog(app.ui, app.work, app.picking); },
                 nullptr,
                 "page html groups confuse distinct players client print"},
                {"File", "Paper...", {}, has_selection, [](App& app) { open_paper(app.ui); }, nullptr,
                 "table 2 figures publication lim park metrics people k rho methods"},
                {"File",
                 "Export vibrations...",
                 {},
                 has_selection,
                 open_effect_export,
                 nullptr,
                 "ahap haptic hjif android pulsar richtap he hla openxr wav csv phone kotlin "
                 "web browser vibrate loss"},
                {"File",
                 "Export stage as CSV...",
                 {},
                 has_selection,
                 [](App& app) {
                     export_stages_dialog(app.ui, app.work, app.rendered, app.physiology);
                 },
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

                {"Edit", "Undo", ctrl('z'), has_undo, [](App& app) { undo(app.ui, app.work); }},
                {"Edit", "Redo", ctrl('z', true), has_redo,
                 [](App& app) { redo(app.ui, app.work); }},
                {"Edit", "New pattern", ctrl('n'), always,
                 [](App& app) { add_pattern(app.ui, app.work); }, nullptr, "add vibration"},
                {"Edit", "Duplicate", ctrl('d'), has_selection, double_notes_or_selected, nullptr,
                 "double notes copy again"},
                {"Edit", "Generate candidates...", ctrl('g'),
                 always, [](App& app) { open_generate(app.ui, app.work, app.generating); }, nullptr,
                 "design space factorial sample sobol latin hypercube levels"},
                {"Edit",
                 "Steps between...",
                 {},
                 has_pairs,
                 [](App& app) { open_steps(app.ui, app.work, app.steps, {}, {}); },
                 nullptr,
                 "even morph between interpolate two path series"},
                {"Edit", "Transform...", ctrl('t'), has_selection,
                 [](App& app) { open_transform(app.ui, app.work, app.transform); }, nullptr,
                 "stretch reverse repeat join mix trim fade normalise quantise transpose thin"},
                {"Edit", "Vary", plain('v'), has_neighbours,
                 [](App& app) { vary(app.ui, app.work, app.proposals); }, nullptr,
                 "neighbours variants alternatives others like it ghosts"},
                {"Edit",
                 "Mix on a pad...",
                 {},
                 has_corners,
                 [](App& app) { open_pad(app.ui, app.work, app.pad); },
                 nullptr,
                 "morph blend corners two three four"},
                {"Edit",
                 "Fill the gap",
                 {},
                 has_selection,
                 [](App& app) { fill_the_gap(app.ui, app.work, app.shown_map, app.proposals); },
                 nullptr,
                 "farthest from all picked propose empty corner"},
                {"Edit",
                 "Add patterns until there are enough to pick",
                 {},
                 has_missing,
                 [](App& app) {
                     grow_to(app.ui, app.work, app.shown_map, app.proposals,
                             static_cast<std::size_t>(app.picking.count));
                 },
                 nullptr,
                 "add missing farthest fill k"},
                {"Edit",
                 "Add a layer",
                 {},
                 can_add_layer,
                 [](App& app) { add_layer(app.ui, app.work); },
                 nullptr,
                 "bed notes ticks track second voice at once"},
                {"Edit",
                 "Make layers of the selected patterns",
                 {},
                 can_layer_selected,
                 [](App& app) { layer_selected(app.ui, app.work); },
                 nullptr,
                 "mix sum tracks together at once stack"},
                {"Edit",
                 "Split layers into patterns",
                 {},
                 has_layers,
                 [](App& app) { split_layers(app.ui, app.work); },
                 nullptr,
                 "tracks apart separate single"},
                {"Edit", "Tap a rhythm...", plain('t'), has_editable_pattern,
                 [](App& app) { open_tapping(app.ui, app.pattern_panes.tapping); }, nullptr,
                 "beat notes hand"},
                {"Edit", "Draw notes", plain('b'), has_editable_pattern,
                 take_tool<StripTool::notes>, has_tool<StripTool::notes>,
                 "tool rhythm velocity strength pencil"},
                {"Edit", "Draw curves", plain('c'), has_editable_pattern,
                 take_tool<StripTool::curves>, has_tool<StripTool::curves>,
                 "tool envelope sweep points line"},
                {"Edit", "Put ticks", plain('k'), has_editable_pattern, take_tool<StripTool::ticks>,
                 has_tool<StripTool::ticks>, "tool transient burst click accent"},
                {"Edit", "Repeat the notes 4 times", plain('r'), has_chosen_notes,
                 [](App& app) {
                     (void)repeat_notes(app.ui, app.work, app.pattern_panes.strip, kRepeats);
                 },
                 nullptr, "bar copy loop double rhythm"},
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
                {"Edit", "Next point or note of the pattern", plain('n'), has_editable_pattern,
                 choose_next_point<1>, nullptr, "transient curve choose"},
                {"Edit",
                 "Previous point or note of the pattern",
                 {'n', key::kUnknown, false, true},
                 has_editable_pattern,
                 choose_next_point<-1>,
                 nullptr,
                 "transient curve choose previous"},
                {"Edit", "Rename", special(key::kF1 + 1), has_selection, start_rename},
                {"Edit", "Lock", ctrl('l'), has_selection,
                 [](App& app) { toggle_locked(app.ui, app.work); }, is_current_locked,
                 "unlock always pick subset keep"},
                {"Edit", "Exclude", ctrl('l', true), has_selection,
                 [](App& app) { toggle_dropped(app.ui, app.work); }, is_current_dropped,
                 "drop from subsets never pick include take back"},
                {"Edit", "Copy", ctrl('c'), has_selection, copy_notes_or_selected},
                {"Edit", "Copy picture", ctrl('c', true), always,
                 [](App& app) { app.exports.copy_asked = true; }, nullptr,
                 "clipboard image view slides png"},
                {"Edit",
                 "Copy table",
                 {},
                 has_exact_map,
                 copy_shown_table,
                 nullptr,
                 "clipboard csv numbers matrix candidates spreadsheet"},
                {"Edit", "Paste", ctrl('v'), always, paste_notes_or_patterns},
                {"Edit", "Select all", ctrl('a'), has_selection, choose_all},
                {"Edit", "Delete", special(key::kDelete), has_selection, remove_chosen_or_selected,
                 nullptr, "remove"},
            });

}  // namespace

std::span<const Command> document_commands() { return kDocumentCommands; }

}  // namespace tact
