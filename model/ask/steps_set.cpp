#include "model/ask/steps_set.h"

#include <cmath>

namespace tact {

namespace {

bool ends_at(const PatternSet& set, std::size_t to, const EvenSteps& steps) {
    const auto* pattern = std::get_if<Pattern>(&set.vibrations[to].source);
    return pattern != nullptr && *pattern == steps.patterns.back();
}

}  // namespace

std::vector<Vibration> vibrations_between(const PatternSet& set, std::size_t from, std::size_t to,
                                          const EvenSteps& steps) {
    const std::string way = set.vibrations[from].name + " to " + set.vibrations[to].name;
    const std::size_t count = steps.patterns.size();
    const std::size_t end = ends_at(set, to, steps) ? count - 1 : count;
    PatternSet with = set;
    std::vector<Vibration> result;
    for (std::size_t k = 1; k < end; ++k) {
        Vibration step;
        step.name = unused_name(with, way + " " + std::to_string(k + 1));
        step.source = steps.patterns[k];
        step.note = "Step " + std::to_string(k + 1) + " of " + std::to_string(count) + " from " +
                    set.vibrations[from].name + " to " + set.vibrations[to].name + ", at " +
                    std::to_string(std::lround(100.0 * steps.shares[k])) + " % of the way";
        with.vibrations.push_back(step);
        result.push_back(std::move(step));
    }
    return result;
}

PatternSet set_of_steps(const PatternSet& set, std::size_t from, std::size_t to,
                        const EvenSteps& steps) {
    PatternSet result;
    result.name = set.vibrations[from].name + " to " + set.vibrations[to].name;
    result.duration_s = set.duration_s;
    result.model = set.model;
    result.model_origin = set.model_origin;
    result.study = set.study;
    result.felt_steps = set.felt_steps;
    result.vibrations.push_back(set.vibrations[from]);
    for (Vibration& step : vibrations_between(set, from, to, steps)) {
        result.vibrations.push_back(std::move(step));
    }
    if (ends_at(set, to, steps)) result.vibrations.push_back(set.vibrations[to]);
    return result;
}

}  // namespace tact
