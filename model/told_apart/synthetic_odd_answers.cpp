#include "model/told_apart/synthetic_odd_answers.h"

#include <algorithm>

#include "model/common/random.h"
#include "model/told_apart/threshold_posterior.h"

namespace tact {

int synthetic_place(const SyntheticAnswerer& person, const OddOneOut& trial, std::uint64_t serial) {
    RandomStream random{random_bits(person.seed, serial)};
    const double right = share_right(trial.pm, person.threshold_pm, person.slope);
    if (0.5 * (next_even(random) + 1.0) < right) return trial.odd_place;
    return (trial.odd_place + 1 + static_cast<int>(next_index(random, 2))) % 3;
}

ToldApart synthetic_trials(const SyntheticAnswerer& person, const TrialDesign& design) {
    ToldApart told;
    told.device = "no device";
    told.person = "simulated";
    told.seed = design.seed;
    told.synthetic = true;
    while (const auto trial = next_trial(design, told.answers)) {
        told.answers.push_back({*trial, synthetic_place(person, *trial, told.answers.size()), 0.0});
        for (const std::string& name : {trial->a, trial->b}) {
            if (std::ranges::find(told.patterns, name) != told.patterns.end()) continue;
            told.patterns.push_back(name);
        }
    }
    told.versions.resize(told.patterns.size());
    return told;
}

}  // namespace tact
