// The answer of a file chooser to the text in its name field: a path, another folder, or an error.
//
// Output    the chosen path; nullopt: the chooser asks, goes to a folder, or states in its remark
//           what is missing
// Errors    errors of the file system are remarks, too
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/ui/file_chooser.h"

namespace tact {

// Goes to another folder, with the name that the caller offers.
void go_to_folder(FileChooser& chooser, const std::filesystem::path& folder);

// Enter with the present name.
std::optional<std::filesystem::path> accept_name(FileChooser& chooser);

// Chooses the folder itself, if that is allowed.
std::optional<std::filesystem::path> accept_folder(FileChooser& chooser);

// Makes the named folder here and goes into it.
void make_folder(FileChooser& chooser);

// The reason why nothing can be opened or saved yet; empty: it can.
const char* lack_of_name(const FileChooser& chooser);

// "No .wav, .csv here."; empty if there is such a file.
std::string lack_of_files(const FileChooser& chooser);

}  // namespace tact
