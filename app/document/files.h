// Opening and saving the document, and what survives closing the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/document/example_sets.h"
#include "app/document/workspace.h"
#include "app/ui/ui.h"

namespace tact {

// "PM 2023, twelve patterns •": the set's name, marked while unsaved.
std::string document_title(const Workspace& work);
std::string document_name(const Workspace& work);  // the same without the mark

void new_document(Ui& ui, Workspace& work);
void open_example(Ui& ui, Workspace& work);  // the paper's twelve
void open_example_set(Ui& ui, Workspace& work, const ExampleSet& example);
void open_dialog(Ui& ui, const Workspace& work);
void add_dialog(Ui& ui, const Workspace& work);
void save_dialog(Ui& ui, const Workspace& work);
void save(Ui& ui, Workspace& work);

// Physiology tables from a file, as a change of the document; an error changes nothing.
void load_tables_dialog(Ui& ui, const Workspace& work);
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

}  // namespace tact
