// Optional changes of the model, and their effect on its agreement with people and with the
// publication: a cost of waiting in the OC part, and other thresholds.
//
// Source    ratings: Rothkopf 1957, heard, not felt (check_morse.h); the publication's findings
//           (check_findings.h)
// Output    one outcome per model, the published one first; nothing when stopped
// Valid     two judges without a common pattern: the choice of one is tested by the other. Neither
//           is a rating of vibrations by touch.
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "model/common/quantile.h"
#include "model/perceptual_model/perceptual_model_params.h"

namespace tact {

struct ModelVariant {
    std::string name;
    PerceptualModelParams model;
};

// As published, with costs of waiting from 0.02 to 1, and with the thresholds of the Android Open
// Source Project without and with one.
std::vector<ModelVariant> model_variants();

struct VariantOutcome {
    std::string name;
    PerceptualModelParams model;
    double morse_pm = 0.0;  // Spearman's rho with the ratings
    Interval morse_interval;
    double morse_oc = 0.0;
    std::size_t oc_values = 0;  // distinct values
    std::size_t hold = 0;       // findings that hold
    std::vector<std::string> failing;
    double twelve_rho = 0.0;  // PM of the twelve patterns against the published model's; NaN: no
                              // order
    double twelve_k = 0.0;    // alienation of both maps; NaN: no map
};

struct VariantOptions {
    int threads = 0;  // 0: all cores
    std::stop_token stop = {};
    std::function<void(double)> progress = {};  // share of the work, 0..1
};

std::optional<std::vector<VariantOutcome>> check_variants(const VariantOptions& options);

// The choice of each judge alone; ties: the first.
const VariantOutcome& chosen_by_morse(std::span<const VariantOutcome> all);
const VariantOutcome& chosen_by_findings(std::span<const VariantOutcome> all);

}  // namespace tact
