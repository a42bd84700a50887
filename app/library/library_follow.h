// Opening a library, asking what in it is like a pattern, and adding what it holds to the set: all
// of it in the background.
//
// Input     folders (model/library), the pattern that is asked for
// Output    the library and answers in the state; vibrations in the set, as one step of undo
// Left out  drawing: app/library/library_panel.h
#pragma once

#include <filesystem>
#include <vector>

#include "app/document/workspace.h"
#include "app/library/library_state.h"
#include "app/ui/ui.h"

namespace tact {

void open_library_dialog(Ui& ui, const Workspace& work);
void show_library(Ui& ui, LibraryState& state, const std::filesystem::path& folder);
void read_library_again(Ui& ui, LibraryState& state);

// By the model of the set. The answer is of all entries, whatever the words narrow the list to.
void find_alike(const Ui& ui, const Workspace& work, LibraryState& state, const Vibration& wanted);
void find_alike_entry(const Ui& ui, const Workspace& work, LibraryState& state, std::size_t entry);
// The same question with the target that is chosen now.
void ask_alike_again(const Ui& ui, const Workspace& work, LibraryState& state);
// What is found goes, and what is under way is stopped.
void forget_alike(LibraryState& state);

// Its row is pressed: it is read, and felt once it is there.
void hold_entry(const Ui& ui, Workspace& work, LibraryState& state, std::size_t entry);

void add_entries(Ui& ui, const Workspace& work, LibraryState& state,
                 const std::vector<std::size_t>& entries);

// Once a frame: takes what has come.
void follow_library(Ui& ui, Workspace& work, LibraryState& state);

// Something is read or compared.
bool is_library_busy(const LibraryState& state);

// The rows as they are asked for now, kept while nothing that they depend on changes.
const std::vector<LibraryRow>& library_rows(LibraryState& state);

// The same column again turns the order round.
void sort_library(LibraryState& state, LibraryColumn column);

}  // namespace tact
