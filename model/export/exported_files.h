// A set as files of another program, before any is written: their names and texts, what each loses,
// and what the whole costs; for window, command line and Python.
//
// Exact     as model/export/export_loss.h
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/export/export_loss.h"
#include "model/export/export_target.h"
#include "model/set/pattern_set.h"

namespace tact {

// Patterns as files of another program in one folder, with the page on what that costs.
//
// Output    whole files; all that would be replaced is known before any is written

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

// The patterns of these names, in the set's order; of none all that the format holds. `asked_by`
// begins what an Error says of a name.
Expected<PatternSet> part_to_export(const PatternSet& set, const std::vector<std::string>& names,
                                    TargetFormat format, const std::string& asked_by);

// Rates of samples in files.
inline constexpr double kExportRatesHz[] = {10'000.0, 44'100.0, 48'000.0};

// The encoding of WAV by its bits: "16", "24", "float".
inline constexpr const char* kWaveBits[] = {"16", "24", "float"};
void take_wave_bits(SampledAs& sampled, const std::string& bits);

struct ExportedFiles {
    ExportTarget target;             // with its full scale
    std::vector<std::string> names;  // of the patterns' files
    std::vector<TextFile> files;     // those, with what belongs to each
    std::vector<std::vector<std::string>> remarks;
    std::optional<ExportLoss> loss;
};

struct ExportedFilesOptions {
    bool without_loss = false;          // nothing is predicted
    std::vector<std::size_t> written;   // places of the part that become files; empty: all
    const ExportLoss* known = nullptr;  // of this part, target and date, which saves predicting it
    std::size_t subset_count = 0;       // 0: usual_subset_count()
    int threads = 0;                    // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from any thread
};

// `part`: as part_to_export() has it; of samples the loudest of it sets the full scale. Nothing
// when stopped.
std::optional<ExportedFiles> exported_files(const PatternSet& part, const ExportTarget& target,
                                            const std::string& date,
                                            const ExportedFilesOptions& options);

// What the files are and mean, {"format", "files": [{"pattern", "file", "remarks"}], "loss"}.
nlohmann::json json_of(const ExportedFiles& exported, const PatternSet& part,
                       const std::filesystem::path& folder);

}  // namespace tact
