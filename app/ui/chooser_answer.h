// What a file chooser makes of the name that stands in it: a path, another folder, or what is wrong
// with it.
//
// Output    the path chosen; none: it asks, goes to a folder, or says in its remark what is missing
// Errors    what the file system refuses is a remark, too
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/ui/file_chooser.h"

namespace tact {

// To another folder, with the name that the caller offers.
void go_to_folder(FileChooser& chooser, const std::filesystem::path& folder);

// What Enter does with the name as it stands.
std::optional<std::filesystem::path> accept_name(FileChooser& chooser);

// The folder itself, where that may be an answer.
std::optional<std::filesystem::path> accept_folder(FileChooser& chooser);

// The folder that was named, made here and gone to.
void make_folder(FileChooser& chooser);

// Why there is nothing to open or to save as yet; empty: there may be.
const char* lack_of_name(const FileChooser& chooser);

// "No .wav, .csv here."; empty: a file of them is.
std::string lack_of_files(const FileChooser& chooser);

}  // namespace tact
