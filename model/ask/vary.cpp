#include "model/ask/vary.h"

#include <algorithm>
#include <cmath>

#include "model/dissimilarity/dissimilarity.h"
#include "model/pattern/same_vibration.h"

namespace tact {

namespace {

constexpr std::size_t kDrawnForEach = 6;

std::vector<Pattern> drawn(const VaryQuestion& question) {
    const auto free = free_numbers(question.pattern, question.free);
    std::vector<Pattern> patterns{question.pattern};
    SeenVibrations seen;
    seen.add(question.pattern);
    RandomStream random{question.seed};
    // A few draws end at the edge of a range, and are the same pattern then.
    for (std::size_t k = 0; k < kDrawnForEach * question.count && !free.empty(); ++k) {
        Pattern one =
            stepped_at_random(question.pattern, free, question.steps, question.how_far, random);
        if (seen.add(one)) patterns.push_back(std::move(one));
    }
    return patterns;
}

// NC and OC before ranks, each as a share of its largest here.
std::optional<Dissimilarity> apart(const std::vector<Pattern>& patterns,
                                   const VaryQuestion& question, int threads,
                                   std::stop_token stop) {
    std::vector<Waveform> waveforms;
    for (const Pattern& pattern : patterns) waveforms.push_back(render(pattern));
    PredictOptions options;
    options.envelope_decimation = 10;
    options.threads = threads;
    options.stop = std::move(stop);
    const auto prediction = predict(waveforms, question.model, options);
    if (!prediction) return std::nullopt;
    Dissimilarity sum{patterns.size(), std::vector<double>(prediction->nc.condensed.size(), 0.0)};
    for (const auto& [part, weight] : {std::pair{&prediction->nc, question.model.nc_weight},
                                       std::pair{&prediction->oc, question.model.oc_weight}}) {
        if (part->condensed.empty()) continue;
        const double most = *std::ranges::max_element(part->condensed);
        if (!(most > 0.0)) continue;
        for (std::size_t k = 0; k < sum.condensed.size(); ++k) {
            sum.condensed[k] += weight / most * part->condensed[k];
        }
    }
    return sum;
}

// The next is always the farthest from the pattern itself and from all that were taken.
std::vector<std::size_t> farthest_next(const Dissimilarity& apart, std::size_t count) {
    std::vector<double> nearest(apart.size);
    for (std::size_t k = 0; k < apart.size; ++k) nearest[k] = k == 0 ? -1.0 : apart(0, k);
    std::vector<std::size_t> taken;
    while (taken.size() < count) {
        const auto best = std::ranges::max_element(nearest);
        if (best == nearest.end() || *best < 0.0) break;
        const auto next = static_cast<std::size_t>(best - nearest.begin());
        taken.push_back(next);
        for (std::size_t k = 0; k < apart.size; ++k) {
            if (nearest[k] >= 0.0 && k != next) nearest[k] = std::min(nearest[k], apart(next, k));
        }
        nearest[next] = -1.0;
    }
    return taken;
}

}  // namespace

std::vector<PatternParameter> free_numbers(const Pattern& pattern,
                                           const std::vector<PatternParameter>& free) {
    std::vector<PatternParameter> numbers;
    for (const PatternParameter parameter : kPatternParameters) {
        const bool wanted = free.empty() || std::ranges::find(free, parameter) != free.end();
        if (wanted && value_of(pattern, parameter)) numbers.push_back(parameter);
    }
    return numbers;
}

Pattern stepped_at_random(const Pattern& pattern, const std::vector<PatternParameter>& free,
                          const FeltSteps& steps, double how_far, RandomStream& random) {
    std::vector<double> direction;
    double squares = 0.0;
    for (std::size_t k = 0; k < free.size(); ++k) {
        direction.push_back(next_normal(random));
        squares += direction.back() * direction.back();
    }
    Pattern result = pattern;
    for (std::size_t k = 0; k < free.size(); ++k) {
        const double count = how_far * direction[k] / std::sqrt(std::max(squares, 1e-12));
        const double value = *value_of(pattern, free[k]);
        result = with_value(result, free[k], stepped(steps, free[k], value, count));
    }
    return result;
}

std::optional<std::vector<Pattern>> varied(const VaryQuestion& question, int threads,
                                           std::stop_token stop) {
    const std::vector<Pattern> patterns = drawn(question);
    std::vector<Pattern> chosen;
    if (patterns.size() < 2) return chosen;
    const auto distances = apart(patterns, question, threads, std::move(stop));
    if (!distances) return std::nullopt;
    for (const std::size_t k : farthest_next(*distances, question.count)) {
        chosen.push_back(patterns[k]);
    }
    return chosen;
}

}  // namespace tact
