// A model's parameters in a file of their own, and where trained ones come from.
//
//     {"tactspace_model": 1,
//      "model": {"nc_weight": 0.7, ...},                     as in a set file, see model_json.h
//      "training": {"program": "tactspace 0.1.0", "date": "2026-11-21T16:00:00Z",
//                   "objective": "mean-rho", "step": 0.1, "value": 0.71, "value_before": 0.62,
//                   "equally_good": 12,
//                   "sets": [{"name": "...", "fingerprint": "0123456789abcdef", "patterns": 12,
//                             "rated_pairs": 66, "participants": 20, "rho_before": 0.62,
//                             "rho_after": 0.71}]}}         and "synthetic": true, of the training
//                                                           and of a set, where nobody was asked
//
// Output    errors as "FILE: PLACE: expected WHAT, got GOT"
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/set/pattern_set.h"
#include "model/training/training.h"

namespace tact {

struct TrainedOn {
    std::string name;
    std::string fingerprint;  // of the waveforms and ratings, 16 hexadecimal digits
    std::size_t patterns = 0;
    std::size_t rated_pairs = 0;
    std::size_t participants = 0;
    double rho_before = 0.0;
    double rho_after = 0.0;
    NumberMark mark{};  // of the ratings
    // Fingerprint of the patterns that were felt, as in participants' files and their CSV
    // (model/set/set_ratings.h); empty: unknown.
    std::string felt{};

    bool operator==(const TrainedOn&) const = default;
};

// Where trained parameters come from.
struct TrainingRecord {
    std::string program;  // with its version
    std::string date;     // UTC, as in ISO 8601
    TrainingObjective objective = TrainingObjective::mean_rho;
    double step = 0.1;
    double value = 0.0;  // of the objective
    double value_before = 0.0;
    std::uint64_t equally_good = 0;  // combinations of the grid
    std::vector<TrainedOn> sets;

    bool operator==(const TrainingRecord&) const = default;
};

struct ModelFile {
    PerceptualModelParams model;
    std::optional<TrainingRecord> training;

    bool operator==(const ModelFile&) const = default;
};

inline constexpr int kModelFormat = 1;

// As a command line names them: mean-rho, mean-abs-rho.
inline constexpr const char* kObjectiveNames[] = {"mean-rho", "mean-abs-rho"};

// Whether some of what it was fitted to was said by nobody; and a sentence that says so without a
// full stop, empty where people said it.
bool is_partly_synthetic(const TrainingRecord& record);
std::string remark_on_synthetic(const ModelOrigin& origin);
std::string remark_on_synthetic(const ModelFile& file);

// "Trained on four (4 patterns, 6 pairs, 20 people), 2026-11-21: mean rho 0.712, was 0.621."
ModelOrigin origin_of(const ModelFile& file);

// The same for equal waveforms and ratings in equal order.
std::string fingerprint_of(const TrainingSet& set);

// `program`: with its version. The date is now.
TrainingRecord record_of(const Training& training, std::span<const TrainingSet> sets,
                         const std::string& program);

Expected<ModelFile> parse_model(std::string_view text, const std::string& file);
std::string print_model(const ModelFile& file);

Expected<ModelFile> read_model_file(const std::filesystem::path& path);
Expected<Done> write_model_file(const std::filesystem::path& path, const ModelFile& file);

}  // namespace tact
