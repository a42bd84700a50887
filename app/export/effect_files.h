// Patterns as files of another program in one folder, with the page on what that costs.
//
// Output    whole files; all that would be replaced is known before any is written
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/export/export_target.h"
#include "model/set/pattern_set.h"

namespace tact {

struct TextFile {
    std::string name;  // in its folder
    std::string text;

    bool operator==(const TextFile&) const = default;
};

inline constexpr const char* kExportReport = "export_report.html";

// Of the patterns of a set, in its order: names that file systems take, each once.
std::vector<std::string> effect_file_names(const PatternSet& set, TargetFormat format);

// Which of these names are taken in the folder.
std::vector<std::string> taken_names(const std::filesystem::path& folder,
                                     const std::vector<std::string>& names);

// Makes the folder; each file whole or not at all, in the place of what had its name.
Expected<Done> write_files(const std::filesystem::path& folder, const std::vector<TextFile>& files);

}  // namespace tact
