// Changes to the document. Each leaves the maps following it; each gesture is one undo step.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/window/app.h"

namespace tact {

// The vibration in the editor; null in an empty set.
const Vibration* current_vibration(const App& app);

// Current, and those others that the search shows, ascending; empty in an empty set. Nothing hidden
// is changed with what is seen.
std::vector<std::size_t> selected_indices(const App& app);

// What the list shows: those with the search's text in their names, ascending.
std::vector<std::size_t> listed_indices(const App& app);

void select_only(App& app, std::size_t index);
void toggle_selected(App& app, std::size_t index);
void select_through(App& app, std::size_t index);  // everything listed from current to index
void select_all(App& app);
// Makes the first pattern current and the second its partner.
void choose_pair(App& app, std::size_t current, std::size_t partner);

// The document was changed, perhaps in the middle of a drag: the maps follow.
void document_changed(App& app);
// All that is predicted is asked for anew, though the document stays what it is.
void predictions_changed(App& app);

// A gesture ended: what changed since the last step becomes one.
void commit_step(App& app, const std::string& label);

// Applies `change` to every selected parametric pattern that is not locked.
void edit_patterns(App& app, const std::function<void(Pattern&)>& change);

// "amplitude of L-4-full", "amplitude of 3 patterns": the end of a step's label.
std::string of_selection(const App& app, const std::string& what);

void undo(App& app);
void redo(App& app);

// One step each. New vibrations come after the current one and are selected.
void add_pattern(App& app);
void duplicate_selected(App& app);
void remove_selected(App& app);  // of those in the list: what a search hides is kept, and told
void copy_selected(App& app);
void paste(App& app);
void move_vibration(App& app, std::size_t from, std::size_t to);
void rename_vibration(App& app, std::size_t index, const std::string& name);
void toggle_locked(App& app);   // locked ones are in every subset ...
void toggle_dropped(App& app);  // ... dropped ones in none

// Duration of what the panes show, s: of any pattern, padded as in its set.
double shown_duration_s(const App& app);

// A line at the foot of the window.
void say(App& app, const std::string& text);
void complain(App& app, const std::string& text);

}  // namespace tact
