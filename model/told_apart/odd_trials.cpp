#include "model/told_apart/odd_trials.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>

#include "model/common/portable.h"
#include "model/common/random.h"
#include "model/told_apart/threshold_posterior.h"

namespace tact {

namespace {

// Streams of one seed.
constexpr std::uint64_t kOfPairs = 1;
constexpr std::uint64_t kOfPlaces = 2;

bool is_of(const OddAnswer& answer, const TrialPair& pair) {
    return answer.trial.a == pair.a && answer.trial.b == pair.b;
}

// How often a pair may be asked in a row.
std::size_t share_in_a_row(const TrialDesign& design, std::size_t pairs) {
    const auto trials = static_cast<std::size_t>(std::max(design.trials, 1));
    return std::clamp<std::size_t>(trials / pairs, 1, 3);
}

// Whether the last answers were of this pair, as many as its share.
bool had_its_share(const TrialPair& pair, std::span<const OddAnswer> answers, std::size_t share) {
    return answers.size() >= share &&
           std::ranges::all_of(answers.last(share),
                               [&](const auto& one) { return is_of(one, pair); });
}

// Those that may be asked now, by their places in the design.
std::vector<std::size_t> pairs_now(const TrialDesign& design, std::span<const OddAnswer> answers) {
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < design.pairs.size(); ++k) {
        if (can_be_asked(design.pairs[k].pm)) all.push_back(k);
    }
    if (all.size() < 2) return all;
    const std::size_t share = share_in_a_row(design, all.size());
    std::vector<std::size_t> now = all;
    std::erase_if(now,
                  [&](std::size_t k) { return had_its_share(design.pairs[k], answers, share); });
    return now.empty() ? all : now;
}

ThresholdPosterior posterior_so_far(const TrialDesign& design, std::span<const OddAnswer> answers) {
    std::vector<double> pm;
    for (const TrialPair& pair : design.pairs) pm.push_back(pair.pm);
    std::vector<AskedPm> asked;
    for (const OddAnswer& answer : answers) asked.push_back({answer.trial.pm, answer.is_right()});
    return threshold_posterior(range_of_pm(pm), asked);
}

// The pairs whose answers are expected to say most.
std::vector<std::size_t> most_telling(const TrialDesign& design,
                                      const std::vector<std::size_t>& pairs,
                                      const ThresholdPosterior& posterior) {
    std::map<double, double> information;  // by PM: pairs of one PM say the same
    double most = 0.0;
    for (const std::size_t k : pairs) {
        const double pm = design.pairs[k].pm;
        const auto known = information.find(pm);
        if (known != information.end()) continue;
        const double own = expected_information(posterior, pm);
        information[pm] = own;
        most = std::max(most, own);
    }
    constexpr double kRounding = 1e-9;
    std::vector<std::size_t> best;
    for (const std::size_t k : pairs) {
        if (information[design.pairs[k].pm] >= most * (1.0 - kRounding)) best.push_back(k);
    }
    return best;
}

// The place of the odd one and which of the two it is: 0 to 5, each once in a block of six.
std::size_t arrangement(std::uint64_t seed, std::size_t trial) {
    constexpr std::size_t kBlock = 6;
    std::array<std::size_t, kBlock> order{};
    RandomStream random{random_bits(random_bits(seed, kOfPlaces), trial / kBlock)};
    next_permutation_of(random, order);
    return order[trial % kBlock];
}

// `most` of the places, which are in the order of their values and are more than that.
std::vector<std::size_t> evenly_spread(const std::vector<std::size_t>& order,
                                       const std::vector<double>& value, std::size_t most) {
    std::vector<std::size_t> chosen;
    if (most == 0) return chosen;
    const double low = portable::log(value[order.front()]);
    const double high = portable::log(value[order.back()]);
    const auto of = [&](std::ptrdiff_t p) { return value[order[static_cast<std::size_t>(p)]]; };
    std::ptrdiff_t next = 0;  // the first that may still be chosen
    for (std::size_t k = 0; k < most; ++k) {
        const double share =
            most < 2 ? 0.0 : static_cast<double>(k) / static_cast<double>(most - 1);
        const double wanted = portable::exp(low + share * (high - low));
        // One is left for each that is still to come.
        const auto end = static_cast<std::ptrdiff_t>(order.size() - (most - 1 - k));
        const auto found = std::ranges::lower_bound(order.begin() + next, order.begin() + end,
                                                    wanted, {}, [&](auto p) { return value[p]; });
        std::ptrdiff_t p = std::min(found - order.begin(), end - 1);
        if (p > next && wanted / of(p - 1) < of(p) / wanted) --p;
        chosen.push_back(order[static_cast<std::size_t>(p)]);
        next = p + 1;
    }
    return chosen;
}

}  // namespace

std::optional<OddOneOut> next_trial(const TrialDesign& design, std::span<const OddAnswer> answers) {
    const std::size_t trial = answers.size();
    if (trial >= static_cast<std::size_t>(std::max(design.trials, 0))) return std::nullopt;
    const std::vector<std::size_t> pairs = pairs_now(design, answers);
    if (pairs.empty()) return std::nullopt;
    const auto best = most_telling(design, pairs, posterior_so_far(design, answers));
    RandomStream random{random_bits(random_bits(design.seed, kOfPairs), trial)};
    const TrialPair& pair = design.pairs[best[next_index(random, best.size())]];
    const std::size_t order = arrangement(design.seed, trial);
    return OddOneOut{pair.a, pair.b, pair.pm, static_cast<int>(order % 3), order >= 3};
}

std::vector<TrialPair> pairs_to_ask(const std::vector<std::string>& names, const Dissimilarity& pm,
                                    std::size_t most) {
    assert(names.size() == pm.size && "a name for each pattern");
    const std::vector<double>& value = pm.condensed;
    std::vector<std::size_t> order;  // places of pairs, by their PM
    for (std::size_t k = 0; k < value.size(); ++k) {
        if (can_be_asked(value[k])) order.push_back(k);
    }
    std::ranges::stable_sort(order, {}, [&value](std::size_t k) { return value[k]; });
    if (order.size() > most) order = evenly_spread(order, value, most);
    std::vector<TrialPair> pairs;
    for (const std::size_t k : order) {
        const auto [i, j] = pair_at(pm.size, k);
        pairs.push_back({names[i], names[j], value[k]});
    }
    return pairs;
}

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
