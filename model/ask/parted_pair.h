// What would separate two patterns that people may confuse: the smallest change of either, of one
// number, that parts the pair and what else counts (model/subset/separation.h).
//
// Input     a set of at least two patterns, and what is felt of it, pattern by pattern
// Output    changes of the smallest number of felt steps first
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/set/pattern_set.h"
#include "model/subset/separation.h"

namespace tact {

struct PairToPart {
    std::size_t a = 0;
    std::size_t b = 0;
    std::vector<std::size_t> changeable;  // of the two: changeable_of()
    std::vector<std::size_t> among{};     // others that count besides the two; empty: all
    double share = 0.05;                  // of the pairs that count are too close ...
    std::optional<double> threshold{};    // ... or those up to this PM
};

// The one of the two that has this name, or both that are not locked; of patterns made of
// parameters. Empty: none may be changed.
std::vector<std::size_t> changeable_of(const PatternSet& set, std::size_t a, std::size_t b,
                                       const std::string& name);

struct PartingChange {
    std::size_t place = 0;  // of the pattern that is changed
    Separation separation;
};

struct PartedPair {
    std::size_t a = 0;
    std::size_t b = 0;
    double dissimilarity = 0.0;  // PM
    double threshold = 0.0;      // to be exceeded, PM
    std::vector<PartingChange> changes;
    bool is_cut_off = false;  // at the time limit: smaller changes may exist
};

struct PartingOptions {
    int threads = 0;  // 0: all cores
    std::stop_token stop{};
    // What is told how far a part of the work is, 0..1, from any thread; may be empty.
    std::function<std::function<void(double)>(const std::string& what)> progress_of{};
    // s, of the search of changes, for each pattern that may be changed; pairs are compared before.
    double time_limit_s = std::numeric_limits<double>::infinity();
    std::function<Waveform(const Waveform&)> felt{};  // as in SeparationOptions
};

// Nothing when stopped. `felt`: the set as it is felt, of the patterns of `meant`.
std::optional<PartedPair> parted_pair(const PatternSet& meant, const PatternSet& felt,
                                      const PairToPart& pair, const PartingOptions& options);

// {"pair", "dissimilarity", "threshold", "changes": [{"pattern", "parameter", "from", "to",
// "felt_steps", "nearest"}], "cut_off" where it is so}: of the command separate and of Python.
nlohmann::json json_of(const PartedPair& parted, const std::vector<std::string>& names);

}  // namespace tact
