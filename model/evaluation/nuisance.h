// What a metric says of people's ratings beyond something simple that may carry the agreement
// alone: how long patterns last, how strong they are, or any matrix of one's own.
//
// Source    partial rank correlation: Kendall 1942; interval by standard error over drawn patterns
// Input     dissimilarities of the patterns of the ratings; NaN pairs are left out
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/dissimilarity/correlation.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/set/pattern_set.h"

namespace tact {

// "duration": how much longer one sounds than the other, s; "level": by how many dB it is stronger.
// None of another name.
std::optional<Dissimilarity> nuisance_named(std::string_view name, const PatternSet& set);

struct PartialRho {
    double rho = 0.0;  // NaN: none, or nothing is left
    Interval interval;
};

struct Given {
    std::string name;
    double rho_alone = 0.0;  // of the nuisance itself with the ratings
    std::vector<PartialRho> metrics;
};

Given given(const std::string& name, const Dissimilarity& nuisance, const Dissimilarity& ratings,
            const std::vector<Dissimilarity>& metrics, const BootstrapParams& params = {});

}  // namespace tact
