// Metrics of one's own, beside those of this program: a matrix in a file, or a function in Python.
//
// "mine.csv" is a matrix by the names of the set. "mine.py:apart" is a function of two arrays of
// samples in g, padded to the longest of the set, and the rate in Hz, that returns a number of 0 or
// more; python3 calls it on every pair, the earlier pattern first. The arrays are NumPy's where
// that is installed, else Python's own.
#pragma once

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/set/pattern_set.h"
#include "model/table/table.h"

namespace tact {

// A metric that is not of this program.
struct ForeignMetric {
    std::string key;   // "mine (foreign)": marked wherever it is named
    std::string from;  // file, or file and function

    bool operator==(const ForeignMetric&) const = default;
};

ForeignMetric foreign_metric(const std::string& from);

struct ForeignOptions {
    TableHints written{};  // of a matrix
    std::stop_token stop{};
    // What could be misread of a matrix, a sentence each.
    std::function<void(const std::string&)> remark{};
};

// An Error names the file, and of a function that failed the last word of Python; or it was
// stopped.
Expected<Dissimilarity> foreign_matrix(const std::string& from, const PatternSet& set,
                                       const ForeignOptions& options = {});

// Functions of a Python file that could be metrics: of its outermost level, and not private.
std::vector<std::string> functions_in(const std::filesystem::path& file);

}  // namespace tact
