// Changes to the document. Each leaves the maps following it; each gesture is one undo step.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

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

}  // namespace tact
