// What is done to the open document: edits, files, names.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/io/people/ratings_file.h"

namespace tact {

// Changes to the document. Each leaves the maps following it; each gesture is one undo step.

// The vibration in the editor; null in an empty set.
const Vibration* current_vibration(const Workspace& work);

// Current, and those others that the search shows, ascending; empty in an empty set. Nothing hidden
// is changed with what is seen.
std::vector<std::size_t> selected_indices(const Workspace& work);

// What the list shows: those that the search finds, or of them the picked ones alone; ascending.
std::vector<std::size_t> listed_indices(const Workspace& work);

void select_only(Workspace& work, std::size_t index);
void toggle_selected(Workspace& work, std::size_t index);
void select_through(Workspace& work, std::size_t index);  // everything listed from current to index
void select_all(Workspace& work);
// `step` further down the list, or up, through the order of a table that is shown; at its ends as
// far as there is.
void select_next(Workspace& work, int step);
// Makes the first pattern current and the second its partner.
void choose_pair(Workspace& work, std::size_t current, std::size_t partner);

// The editor has one layer open, and does with its pattern what it does with any. Where several
// vibrations are selected, a layered one takes part with its layer of the same place.

// Null: what is in the editor has no layers.
const LayeredPattern* current_layers(const Workspace& work);

std::size_t open_layer(const Workspace& work);
void choose_layer(Workspace& work, std::size_t k);

// The pattern made of parameters that the editor shows; null: a recording, or an empty set.
const Pattern* shown_pattern(const Workspace& work);

// "alarm"; of a layer "alarm, bed".
std::string shown_name(const Workspace& work);

// The open layer as a vibration of that name; what has no layers as it is. Asserts that there is
// one.
Vibration shown_vibration(const Workspace& work);

// A layer of the current vibration by itself, under a name that no other has.
Vibration layer_alone(const Workspace& work, const LayeredPattern& layered, std::size_t k);

// The pattern that the editor would show of any vibration; null where it is locked.
const Pattern* editable_layer(const Workspace& work, std::size_t index);
const Pattern* editable_layer(const Workspace& work);

// The pattern of the vibration, or of its layer, in its place; null: it has none.
Pattern* layer_pattern(Vibration& vibration, std::size_t layer);

// The document was changed, perhaps in the middle of a drag: the maps follow.
void document_changed(Workspace& work);
// The same of the model's parameters, by hand: they are no longer as they were trained.
void model_changed(Workspace& work);
// Asks for all predictions again, though the document has not changed.
void predictions_changed(Workspace& work);

// Once a frame: what was edited since it was rated or measured, as of the last undo step.
void follow_stale(Workspace& work);

// A gesture ended: what changed since the last step becomes one.
void commit_step(Ui& ui, Workspace& work, const std::string& label);

// Null where the vibration is a recording, has layers, or is locked.
const Pattern* editable_pattern(const Vibration& vibration);

// Applies `change` to every selected pattern that may be edited, of layers to the open one.
void edit_patterns(Workspace& work, const std::function<void(Pattern&)>& change);

// Puts `pattern`, clamped, in the place of the one that the editor shows, if that may be edited.
void edit_current_pattern(Workspace& work, const Pattern& pattern);

// Puts what each of these vibrations is from now on in its place, of those that are not locked.
void put_sources(Workspace& work, const std::vector<std::size_t>& places,
                 const std::vector<VibrationSource>& sources);

// Puts a recording in the place of the one in the editor, with what its note then says, if that is
// one and not locked.
void edit_current_recording(Workspace& work, const Measurement& recording, const std::string& note);

// "amplitude of L-4-full", "amplitude of 3 patterns": the end of a step's label.
std::string of_selection(const Workspace& work, const std::string& what);

void undo(Ui& ui, Workspace& work);
void redo(Ui& ui, Workspace& work);

// Behind the current one under names that are free, and selected; the step is yet to be committed.
void insert_after_current(Workspace& work, std::vector<Vibration> fresh);

// One step each. New vibrations come after the current one and are selected.
void add_pattern(Ui& ui, Workspace& work);
void add_vibrations(Ui& ui, Workspace& work, std::vector<Vibration> fresh,
                    const std::string& label);
void duplicate_selected(Ui& ui, Workspace& work);
void remove_selected(
    Ui& ui, Workspace& work);  // of those in the list: what a search hides is kept, and told
void move_vibration(Ui& ui, Workspace& work, std::size_t from, std::size_t to);
void rename_vibration(Ui& ui, Workspace& work, std::size_t index, const std::string& name);
void toggle_locked(Ui& ui, Workspace& work);   // locked ones are in every subset ...
void toggle_dropped(Ui& ui, Workspace& work);  // ... dropped ones in none

// Those that PM finds not felt, but for locked and excluded ones; and excludes them, in one step.
std::vector<std::size_t> unfelt_indices(const Workspace& work);
void exclude_unfelt(Ui& ui, Workspace& work);

// Duration of what the panes show, s: of any pattern, padded as in its set.
double shown_duration_s(const Workspace& work);

// The time after which a press on a pattern, in any pane, counts as a hold: it then plays until
// the button is released (app/play). A click or the start of a drag takes less.
inline constexpr double kHoldS = 0.25;
inline constexpr const char* kHoldHelp = "Hold for 0.25 s: it plays until you let go";

// Notes that this frame's press is on the pattern. A drag is no press: it moves what it began on.
void note_pressed(Workspace& work, const Vibration& vibration);

// The sets that come with the program, as its menu lists them.

struct ExampleSet {
    const char* path;  // below assets/
    const char* name;  // that the set has itself
};

inline constexpr std::array<ExampleSet, 13> kExampleSets{{
    {"sets/pm_2023_twelve.tactspace.json", "PM 2023, twelve patterns"},
    {"library/library.tactspace.json", "Library, forty patterns (our own, not from a study)"},
    {"library/notes_accents_layers.tactspace.json",
     "Notes, accents and layers (our own, not from a study)"},
    {"sets/rhythms_tactspace.tactspace.json", "tactspace rhythms (our own, not from a study)"},
    {"sets/park_choi_2011_am_4hz.tactspace.json",
     "Park & Choi 2011, eight AM patterns (4 Hz: paper\u2019s caption)"},
    {"sets/park_choi_2011_am_5hz.tactspace.json",
     "Park & Choi 2011, eight AM patterns (5 Hz: authors\u2019 files)"},
    {"sets/morse_rothkopf_1957.tactspace.json",
     "Morse, 36 signals (Rothkopf 1957: rated by ear, not by touch)"},
    {"sets/template_abou_chahine_2022.tactspace.json",
     "Abou Chahine 2022, 14 rhythms (template, unconfirmed)"},
    {"sets/template_hwang_2017_exp1_low_high.tactspace.json",
     "Hwang 2017, Exp. I low-high, 7 vibrations (template, unconfirmed)"},
    {"sets/template_hwang_2017_exp1_low_mid.tactspace.json",
     "Hwang 2017, Exp. I low-mid, 7 vibrations (template, unconfirmed)"},
    {"sets/template_hwang_2017_exp1_mid_high.tactspace.json",
     "Hwang 2017, Exp. I mid-high, 7 vibrations (template, unconfirmed)"},
    {"sets/template_hwang_2017_exp2.tactspace.json",
     "Hwang 2017, Exp. II, 15 vibrations (template, unconfirmed)"},
    {"sets/template_hwang_choi_2010.tactspace.json",
     "Hwang & Choi 2010, 14 vibrations (template, unconfirmed)"},
}};

// Opening and saving the document, and what survives closing the program.

// "PM 2023, twelve patterns •": the set's name, marked while unsaved.
std::string document_title(const Workspace& work);
std::string document_name(const Workspace& work);  // the same without the mark

void new_document(Ui& ui, Workspace& work);
void open_example(Ui& ui, Workspace& work);  // the paper's twelve
void open_example_set(Ui& ui, Workspace& work, const ExampleSet& example);
void save_dialog(Ui& ui, Workspace& work);
void save(Ui& ui, Workspace& work);

// Physiology tables from a file, as a change of the document; an error changes nothing.
void load_tables_dialog(Ui& ui, Workspace& work);
void load_tables(Ui& ui, Workspace& work, const std::filesystem::path& path);

// Asks first where another program has changed the document's file.
void save_as(Ui& ui, Workspace& work, const std::filesystem::path& path);

// Puts another document in the place of the open one, whose unsaved changes are kept aside.
bool show_document(Ui& ui, Workspace& work, Document document,
                   std::string text);  // false: the open one stays

// Writes the autosave when it is due.
// Printing and writing a large set takes longer than a frame may: it runs in the background, on the
// set of this moment, one after the other.
void autosave_if_due(Ui& ui, Workspace& work);
bool is_autosaving(const Workspace& work);

// Actuator maps by which the open document's effects were read, and reading them by others.
//
// Input     files as they were opened or added; read again, they have to be what they were
// Output    a step that undo takes back; what was edited since, or is locked, stays and is counted
// Left out  maps from files, which the command line's --actuator takes; effects of a set that was
//           saved: its files are not known any more.

// Effects of one format in the document.
struct MapInUse {
    std::string format;     // a key of model/io/formats/read_effects.h
    std::string actuators;  // "quest"; "core-haptics, quest" where there are several
    std::size_t patterns = 0;
    bool has_files = false;  // that can be read again
};

// Where any effect is, by format.
std::vector<MapInUse> maps_in_use(const Workspace& work);

// What was just read of these files, which are no set file, before anything of it is given another
// name or look.
void note_effect_files(Workspace& work, const std::vector<std::filesystem::path>& paths,
                       const std::vector<Vibration>& read);

// All effects of a format by a bundled map.
void read_by_map(Ui& ui, Workspace& work, const std::string& format, const std::string& actuator);

// What people said of the set, from files.

// The study of those patterns of the set that the loaded ratings are of.
Expected<RatingStudy> study_for(const PatternSet& set, const LoadedRatings& loaded);

// What was read of a file into the document, as one step; an error changes nothing.
void take_ratings(Ui& ui, Workspace& work, Layout& layout, const std::filesystem::path& path,
                  const LoadedRatings& loaded);

// Names are keys: who holds a pattern by its name has to hear of a new one.

// In the set: its twins, its ratings, its trials, and the choice of those that take part in
// studies.
void rename_in(PatternSet& set, std::size_t index, const std::string& name);

// In what is selected and copied; other rooms find it among the changes.
void follow_rename(Workspace& work, const Renaming& renaming);

// The same for whatever has another name in `after` than in `before`, as by an undo.
void follow_renames(Workspace& work, const PatternSet& before, const PatternSet& after);

// No document is replaced, no file written over and no window closed while the only copy of what
// somebody made is in memory, or in the file about to be written.

// Unsaved changes of the open document go to a file of their own, which heads the recent ones.
// Empty: no changes. An Error: they could not be kept, and the document has to stay.
Expected<std::filesystem::path> keep_unsaved(Workspace& work);

// The sentence that says so.
void refuse_to_replace(Ui& ui, const std::string& reason);

// A sentence, though what it comes from may lack its stop.
std::string with_stop(std::string text);

// The file as it is now holds what was never seen here.
bool is_changed_outside(const Document& document, const std::filesystem::path& file);

// Until the autosave under way is on the disk: what is written or moved next comes after it.
void wait_for_autosave(const Workspace& work);

}  // namespace tact
