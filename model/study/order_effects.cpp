// Whether order, sides or practice shift ratings.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "model/common/mean.h"
#include "model/common/random.h"
#include "model/study/agreement.h"
#include "model/study/study_results.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// What one person's ratings of one pair differ by.
struct Difference {
    std::size_t pair = 0;
    double points = 0.0;
};

struct Sum {
    double sum = 0.0;
    std::size_t count = 0;
};

// Differences within pairs of a person; `is_first` tells the way round of an answer, or that it is
// not known.
std::vector<Difference> differences_of(
    const StudyRecord& record,
    const std::function<std::optional<bool>(const PairAnswer&)>& is_first) {
    std::map<std::size_t, std::array<Sum, 2>> ways;
    for (std::size_t k = 0; k < record.answers.size(); ++k) {
        const PairAnswer& answer = record.answers[k];
        if (answer.trial.is_attention() || felt_of(record, k) != Felt::whole) continue;
        const std::optional<bool> first = is_first(answer);
        if (!first) continue;
        const auto [low, high] = std::minmax(answer.trial.left, answer.trial.right);
        Sum& sum = ways[pair_index(record.header.patterns.size(), low, high)][*first ? 0 : 1];
        sum.sum += answer.similarity;
        ++sum.count;
    }
    std::vector<Difference> differences;
    for (const auto& [pair, both] : ways) {
        if (both[0].count == 0 || both[1].count == 0) continue;
        differences.push_back({pair, both[0].sum / static_cast<double>(both[0].count) -
                                         both[1].sum / static_cast<double>(both[1].count)});
    }
    return differences;
}

// Spread of all people's differences by pair: the sum of the squared mean shifts.
double spread_of_pairs(const std::vector<Difference>& differences, std::vector<Sum>& of_pair,
                       const std::function<bool(std::size_t)>& is_turned) {
    std::ranges::fill(of_pair, Sum{});
    for (std::size_t k = 0; k < differences.size(); ++k) {
        Sum& sum = of_pair[differences[k].pair];
        sum.sum += is_turned(k) ? -differences[k].points : differences[k].points;
        ++sum.count;
    }
    double spread = 0.0;
    for (const Sum& sum : of_pair) {
        if (sum.count > 0) spread += sum.sum * sum.sum / static_cast<double>(sum.count);
    }
    return spread;
}

// Signs of one draw, 64 at a time, or those of the bits of a number.
struct Signs {
    std::uint64_t stream = 0;
    std::uint64_t bits = 0;

    bool is_number = false;

    bool operator()(std::size_t k) {
        if (k % 64 == 0 && !is_number) bits = random_bits(stream, k / 64);
        return ((bits >> (k % 64)) & 1U) != 0;
    }
};

// Equal sums may differ by rounding.
bool is_as_large(double value, double observed) { return value >= observed * (1.0 - 1e-12); }

// How often `statistic` of drawn signs of `count` numbers is as large as without: over all signs if
// they are few. For drawn ones (as large + 1) / (draws + 1), as what was observed is one of them
// (Phipson & Smyth 2010).
void test_signs(std::size_t count, std::uint64_t seed,
                const std::function<double(const std::function<bool(std::size_t)>&)>& statistic,
                Shift& shift) {
    shift.is_exact = count < 64 && (std::uint64_t{1} << count) <= kOrderDraws;
    shift.signs = shift.is_exact ? std::size_t{1} << count : kOrderDraws;
    const double observed = statistic([](std::size_t) { return false; });
    std::size_t as_large = 0;
    bool moves = false;
    for (std::size_t draw = 0; draw < shift.signs; ++draw) {
        Signs signs{shift.is_exact ? 0 : random_bits(seed, draw), draw, shift.is_exact};
        const double value = statistic(std::ref(signs));
        if (is_as_large(value, observed)) ++as_large;
        moves = moves || !is_as_large(value, observed) || !is_as_large(observed, value);
    }
    if (!moves) {
        shift.p = kNoRating;
        return;
    }
    const std::size_t itself = shift.is_exact ? 0 : 1;
    shift.p = static_cast<double>(as_large + itself) / static_cast<double>(shift.signs + itself);
}

Shift shift_between(std::span<const StudyRecord> records,
                    const std::function<std::optional<bool>(const PairAnswer&)>& is_first,
                    std::uint64_t seed) {
    Shift shift{0, 0, kNoRating, kNoRating};
    std::vector<Difference> all;
    std::size_t pairs = 0;
    for (const StudyRecord& record : records) {
        const std::vector<Difference> own = differences_of(record, is_first);
        if (!own.empty()) ++shift.people;
        all.insert(all.end(), own.begin(), own.end());
        pairs = std::max(pairs, pair_count(record.header.patterns.size()));
    }
    shift.comparisons = all.size();
    if (all.empty()) return shift;
    std::vector<double> points;
    for (const Difference& one : all) points.push_back(one.points);
    shift.mean = mean_known(points);
    std::vector<Sum> of_pair(pairs);
    test_signs(
        all.size(), seed,
        [&](const auto& is_turned) { return spread_of_pairs(all, of_pair, is_turned); }, shift);
    return shift;
}

// Last pass less first, of each person who has two.
Shift practice_of(std::span<const StudyRecord> records) {
    std::vector<double> of_people;
    Shift shift{0, 0, kNoRating, kNoRating};
    for (const StudyRecord& record : records) {
        const std::vector<Judgement> passes = judgements_of(record, RatingScaling::none);
        if (passes.size() < 2) continue;
        std::vector<double> more;
        for (std::size_t p = 0; p < passes.front().condensed.size(); ++p) {
            // Dissimilarities: what has fallen has become more similar.
            const double change = passes.front().condensed[p] - passes.back().condensed[p];
            if (std::isfinite(change)) more.push_back(change);
        }
        shift.comparisons += more.size();
        if (!more.empty()) of_people.push_back(mean_known(more));
    }
    shift.people = of_people.size();
    if (of_people.empty()) return shift;
    shift.mean = mean_known(of_people);
    test_signs(
        of_people.size(), 9,
        [&](const auto& is_turned) {
            double sum = 0.0;
            for (std::size_t k = 0; k < of_people.size(); ++k) {
                sum += is_turned(k) ? -of_people[k] : of_people[k];
            }
            return std::abs(sum / static_cast<double>(of_people.size()));
        },
        shift);
    return shift;
}

}  // namespace

std::string signs_text(const Shift& shift) {
    if (std::isnan(shift.p)) return "no test: no signs would change the number";
    return (shift.is_exact ? "all " : "") + grouped_digits(shift.signs) +
           (shift.is_exact ? " signs" : " drawn signs");
}

OrderEffects order_effects(std::span<const StudyRecord> records) {
    OrderEffects effects;
    effects.side = shift_between(
        records,
        [](const PairAnswer& answer) -> std::optional<bool> {
            return answer.trial.left < answer.trial.right;
        },
        7);
    effects.felt_first = shift_between(
        records,
        [](const PairAnswer& answer) -> std::optional<bool> {
            if (answer.first == FeltFirst::unknown) return std::nullopt;
            return (answer.first == FeltFirst::left) == (answer.trial.left < answer.trial.right);
        },
        8);
    effects.practice = practice_of(records);
    return effects;
}

}  // namespace tact
