// Opening and saving the document, and what survives closing the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/window/app.h"

namespace tact {

// "PM 2023, twelve patterns •": the set's name, marked while unsaved.
std::string document_title(const App& app);
std::string document_name(const App& app);  // the same without the mark

void new_document(App& app);
void open_example(App& app);
void open_dialog(App& app);
void save_dialog(App& app);
void save(App& app);

// Physiology tables from a file, as a change of the document; an error changes nothing.
void load_tables_dialog(App& app);
void load_tables(App& app, const std::filesystem::path& path);

// Opens what the paths name, as one set; an error leaves the open document as it is. Unsaved
// changes of that one are kept in a file of their own; where they cannot be, it stays.
void open_paths(App& app, const std::vector<std::filesystem::path>& paths);
// Asks first where another program has changed the document's file.
void save_as(App& app, const std::filesystem::path& path);

// Puts another document in the place of the open one, whose unsaved changes are kept aside.
bool show_document(App& app, Document document, std::string text);  // false: the open one stays

// Writes the autosave when it is due.
void autosave_if_due(App& app);

}  // namespace tact
