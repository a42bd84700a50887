// Asking for a file or a folder, with what the answer is for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/ui/ui.h"

namespace tact {

struct FileQuestion {
    ChooserPurpose purpose{};
    ChooserUse use = ChooserUse::open;
    std::string title{};
    std::vector<std::string> extensions{};  // ".wav"; none: all files
    bool folders_too = false;
    std::vector<std::string> file_names{};  // that go into the folder of save_folder
};

// Opens the dialog in a folder (one that is not there: the home folder), with a name offered.
void ask_for_file(Ui& ui, const FileQuestion& question, const std::filesystem::path& folder,
                  const std::string& name = {});

}  // namespace tact
