// Opening and saving the document, and what survives closing the program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/window/app.h"

namespace tact {

// "PM 2023, twelve patterns •": the set's name, marked while unsaved.
std::string document_title(const App& app);

void new_document(App& app);
void open_example(App& app);
void open_dialog(App& app);
void save_dialog(App& app);
void save(App& app);

// Physiology tables from a file, as a change of the document; an error changes nothing.
void load_tables_dialog(App& app);
void load_tables(App& app, const std::filesystem::path& path);

// Opens what the paths name, as one set; an error leaves the open document as it is. Undo brings
// the document before it back.
void open_paths(App& app, const std::vector<std::filesystem::path>& paths);
void save_as(App& app, const std::filesystem::path& path);

// Puts another document in the place of the open one, whose unsaved changes are kept aside.
void show_document(App& app, Document document, std::string text);

// Writes the autosave when it is due.
void autosave_if_due(App& app);

}  // namespace tact
