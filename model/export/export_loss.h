// What an export costs in perception: a set as it was meant, and as it comes back from the files of
// another program, by PM.
//
// PM of what comes back is said on the scale of what was meant: the ranks that its NC and OC would
// have among the set's own pairs (model/export/ranks_among.h). So it falls where patterns become
// alike, and a pattern's distance from what came back of it can be held against the distances of
// patterns from each other. Which subset is the best for the target is asked of the exported set by
// itself, as "subset --exported-as" has it.
//
// NC or OC that changed by less than a ten-thousandth of the set's largest is taken as unchanged:
// by the steps of 24 bits alone pairs that were equal would get other ranks.
//
// Source    ours; PM: Lim & Park 2023; RMS error and peak signal-to-noise ratio of the waveforms,
//           which have phases in them that nobody feels
// Input     a set of any size; recordings are in both, unchanged
// Output    pairs and subsets of two patterns and more, maps of three and more
// Left out  what a device makes of the files; how sure the model is (model/subset).
// Exact     same input, same bits, on any number of threads, but for what a time limit cut off,
//           which is not called proven.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <limits>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/export/exported_set.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/subset/separation.h"
#include "model/subset/subset.h"

namespace tact {

struct PatternLoss {
    std::string name;
    bool recording = false;            // not exported
    std::vector<std::string> remarks;  // sentences without their stop
    double rms_error_g = 0.0;
    // 20 log10 of the meant peak to the RMS error; none where nothing is lost, or nothing meant.
    std::optional<double> psnr_db;
    // PM between what was meant and what came back, 0 where they are the same; none of a set of
    // one, which has no pairs to hold that against.
    std::optional<double> moved;
    bool silenced = false;                 // it was felt as it was meant, and nothing of it is now
    std::optional<EnvelopeError> error{};  // of what is not samples

    bool operator==(const PatternLoss&) const = default;
};

struct PairChange {
    std::size_t a = 0;
    std::size_t b = 0;  // > a
    double before = 0.0;
    double after = 0.0;

    bool operator==(const PairChange&) const = default;
};

// The most distinct patterns, before and after.
struct SubsetChange {
    SubsetProblem problem;
    SubsetAnswer meant;         // of the set as it was meant
    ConfusablePair weakest;     // of these members, after
    SubsetAnswer best;          // of the exported set by itself ...
    Subset kept;                // ... and there the members that were meant
    bool is_still_best = true;  // all are felt there, and none is better
    // What is felt as it was meant and not on the target: left out of what is best there, but for
    // what is locked.
    std::vector<std::size_t> silenced{};

    bool operator==(const SubsetChange&) const = default;
};

struct MapChange {
    Eigen::MatrixXd before;  // n x k
    Eigen::MatrixXd after;   // turned, mirrored, moved and scaled onto it
    double stress_before = 0.0;
    double stress_after = 0.0;
    double correlation = 0.0;  // of the two
};

struct ExportLoss {
    ExportTarget target;
    std::vector<PatternLoss> patterns;
    std::vector<std::string> files;   // a text of each; empty of a recording that is not written
    std::vector<std::string> beside;  // of their second files, where the format has them
    Dissimilarity before;             // PM
    Dissimilarity after;              // PM on the scale of `before`
    std::optional<ConfusablePair> closest_before;
    std::optional<ConfusablePair> closest_after;
    std::vector<PairChange> most_moved;  // those that changed, the most first
    std::optional<SubsetChange> subset;
    std::string no_subset;  // why it is missing
    std::optional<MapChange> map;
};

struct ExportLossOptions {
    std::size_t subset_count = 0;  // 0: usual_subset_count()
    SubsetObjective objective = SubsetObjective::max_min;
    double time_limit_s = std::numeric_limits<double>::infinity();  // of each search
    int dimensions = 2;                                             // of the maps
    std::size_t most_pairs = 10;                                    // that moved
    const Prediction* known = nullptr;  // of the set as it was meant, or one like it
    std::string date = "2026-01-01";    // of the files
    int threads = 0;                    // 0: all cores
    std::stop_token stop{};
    std::function<void(double)> progress{};  // 0..1, from any thread
};

// Whether the members that were meant are the best there: all are felt or locked, no weakest pair
// is farther apart, and of equals no sum is larger.
bool is_best_there(const SubsetChange& change);

// The best subset for the target; ties: the intended one. Empty if there is no subset.
std::vector<std::size_t> best_for_target(const ExportLoss& loss);

// Eight, or half of a smaller set; 0 of fewer than three, where there is nothing to choose.
std::size_t usual_subset_count(std::size_t patterns);

// Nothing when stopped.
std::optional<ExportLoss> export_loss(const PatternSet& set, const ExportTarget& target,
                                      const ExportLossOptions& options = {});

}  // namespace tact
