// What the publication found, checked on the sets that come with the program.
//
// Output    one outcome for each finding of model/evaluation/findings.h; nothing when stopped
#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/evaluation/findings.h"
#include "model/perceptual_model/perceptual_model_params.h"

namespace tact {

struct CheckOptions {
    int threads = 0;                                  // 0: all cores
    std::optional<PerceptualModelParams> model = {};  // replaces each set's own
    std::stop_token stop = {};
    // Called with a set's name; returns the callback for the share of the work done on it.
    std::function<std::function<void(double)>(const std::string&)> progress_of = {};
};

std::optional<std::vector<Finding>> check_findings(const CheckOptions& options);

// "holds", "fails", "needs ratings", "needs stimuli".
const char* word_of(FindingStatus status);

}  // namespace tact
