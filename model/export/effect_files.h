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

// Names for the patterns of a set that the format holds, in its order: valid in file systems, each
// once.
std::vector<std::string> effect_file_names(const PatternSet& set, TargetFormat format);

// The name of a file's second one; of formats that have one.
std::string name_beside(const std::string& name, TargetFormat format);

// The names, and those of the second files.
std::vector<std::string> with_second_files(const std::vector<std::string>& names,
                                           TargetFormat format);

// A file, and its second one where there is one.
void add_files(std::vector<TextFile>& files, const std::string& name, TargetFormat format,
               const std::string& text, const std::string& beside);

// Which of these names are taken in the folder.
std::vector<std::string> taken_names(const std::filesystem::path& folder,
                                     const std::vector<std::string>& names);

// Makes the folder; each file whole or not at all, in the place of what had its name.
Expected<Done> write_files(const std::filesystem::path& folder, const std::vector<TextFile>& files);

}  // namespace tact
