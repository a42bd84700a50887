// A set as files of another program, before any is written: their names and texts, what each loses,
// and what the whole costs; of the command export and of Python.
//
// Exact     as model/export/export_loss.h
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/export/effect_files.h"
#include "model/export/export_loss.h"

namespace tact {

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
    bool without_loss = false;     // nothing is predicted
    std::size_t subset_count = 0;  // 0: usual_subset_count()
    int threads = 0;               // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from any thread
};

// `part`: as part_to_export() has it. Nothing when stopped.
std::optional<ExportedFiles> exported_files(const PatternSet& part, const ExportTarget& target,
                                            const std::string& date,
                                            const ExportedFilesOptions& options);

// What the files are and mean, {"format", "files": [{"pattern", "file", "remarks"}], "loss"}.
nlohmann::json json_of(const ExportedFiles& exported, const PatternSet& part,
                       const std::filesystem::path& folder);

}  // namespace tact
