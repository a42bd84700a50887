// The metrics against the ratings of 598 people, who heard 36 Morse signals: the one test of PM on
// ratings that are public, and PM is not the best there.
//
// Source    Rothkopf 1957, J. Exp. Psychol. 53, 94-101: heard, not felt; the carrier (150 Hz, 1 g)
//           and the unit (50 ms) are ours
// Output    how well each metric agrees, also beyond what the length of the signals explains;
//           nothing when stopped
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "model/evaluation/duration_control.h"
#include "model/evaluation/evaluation.h"
#include "model/evaluation/metric.h"

namespace tact {

inline constexpr const char* kMorseSet = "sets/morse_rothkopf_1957.tactspace.json";

struct MorseRow {
    Metric metric = Metric::pm;
    Evaluation agreement;
    DurationControl beyond_length;
    std::size_t distinct = 0;  // distinct values among its pairs
};

struct MorseCheck {
    std::size_t patterns = 0;
    std::size_t pairs = 0;
    std::vector<MorseRow> rows;  // one per metric, the best rho first
};

struct MorseOptions {
    int threads = 0;  // 0: all cores
    std::stop_token stop = {};
    std::function<void(double)> progress = {};  // share of the work, 0..1
};

std::optional<MorseCheck> check_morse(const MorseOptions& options);

}  // namespace tact
