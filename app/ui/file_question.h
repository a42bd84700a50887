// Asking for a file or a folder, with the purpose of the answer.
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
    std::vector<std::string> extensions{};  // ".wav"; empty: all files
    bool folders_too = false;
    std::vector<std::string> file_names{};  // files that go into the folder of save_folder
};

// Opens the dialog in a folder (if missing: the home folder), with a name offered.
void ask_for_file(Ui& ui, const FileQuestion& question, const std::filesystem::path& folder,
                  const std::string& name = {});

}  // namespace tact
