// Metrics of one's own, beside those of this program: a matrix in a file, or a function in Python.
//
// "mine.csv" is a matrix by the names of the set. "mine.py:apart" is a function of two arrays of
// samples in g, padded to the longest of the set, and the rate in Hz, that returns a number of 0 or
// more; python3 calls it on every pair, the earlier pattern first. The arrays are NumPy's where
// that is installed, else Python's own.
#pragma once

#include <string>

#include "app/command_line/agreement/set_agreement.h"
#include "app/command_line/rated_sets.h"
#include "model/common/expected.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/set/pattern_set.h"

namespace tact {

// The name that it has in tables.
ForeignMetric foreign_metric(const std::string& from);

// An Error names the file, and of a function that failed the last word of Python.
Expected<Dissimilarity> foreign_matrix(const std::string& from, const PatternSet& set,
                                       const TableHints& written);

}  // namespace tact
