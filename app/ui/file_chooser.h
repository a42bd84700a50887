// A dialog to open or save a file, or to save into a folder, which may be new.
//
// Typing always goes into the name field, so that the keyboard is enough: up and down walk through
// the folder, Enter opens, Backspace in the empty field goes to the parent, Esc leaves; a typed
// path may be absolute, relative or start with ~. Ctrl+Enter takes the folder itself. Tab goes to
// the buttons.
//
// Input     a folder to start in and the kinds of file wanted
// Output    the chosen path, once
// Left out  hidden files, sizes, several files at once, making folders of folders.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/folder_listing.h"

namespace tact {

struct Ui;

enum class ChooserUse { open, save, save_folder };

struct FileChooser {
    // The caller's wishes; to be set before show().
    ChooserUse use = ChooserUse::open;
    std::string title = "Open";
    std::vector<std::string> extensions;        // the first is added to a name saved without an
                                                // extension
    bool folders_too = false;                   // a folder may be the answer
    std::vector<std::string> file_names;        // files that go into the folder of save_folder
    std::vector<std::filesystem::path> recent;  // recently used folders

    // The present state of the dialog.
    bool is_open = false;
    bool appears = false;  // opened since the last frame
    FolderListing listing;
    std::string name;                   // as typed
    std::string offered;                // offered by the caller: returns after each change of
                                        // folder
    std::optional<std::size_t> cursor;  // row of the listing
    bool scroll_to_cursor = false;
    bool focus_name = false;
    std::string remark;               // error of the last attempt
    bool makes_folder = false;        // the name is that of a folder to be made here
    std::filesystem::path replacing;  // exists; waits for confirmation
};

// Opens the dialog in the next frame. A missing folder is replaced by the home folder.
void show(FileChooser& chooser, const std::filesystem::path& folder, const std::string& name = "");

// Draws the dialog if it is open. Returns the path in the frame in which it is chosen.
std::optional<std::filesystem::path> draw_file_chooser(Ui& ui);

}  // namespace tact
