#include "model/study/agreement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>

#include "model/common/distributions.h"
#include "model/common/random.h"
#include "model/study/study_results.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// Mean squares of a two-way table without repetitions.
struct MeanSquares {
    double n = 0.0;  // rows: pairs
    double k = 0.0;  // columns: people
    double rows = 0.0;
    double columns = 0.0;
    double rest = 0.0;
};

MeanSquares mean_squares(std::span<const double> table, std::size_t people) {
    const std::size_t pairs = table.size() / people;
    std::vector<double> of_row(pairs, 0.0);
    std::vector<double> of_column(people, 0.0);
    double whole = 0.0;
    for (std::size_t i = 0; i < table.size(); ++i) {
        of_row[i / people] += table[i] / static_cast<double>(people);
        of_column[i % people] += table[i] / static_cast<double>(pairs);
        whole += table[i] / static_cast<double>(table.size());
    }
    MeanSquares ms{static_cast<double>(pairs), static_cast<double>(people)};
    for (const double mean : of_row) ms.rows += (mean - whole) * (mean - whole);
    for (const double mean : of_column) ms.columns += (mean - whole) * (mean - whole);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const double rest = table[i] - of_row[i / people] - of_column[i % people] + whole;
        ms.rest += rest * rest;
    }
    ms.rows *= ms.k / (ms.n - 1.0);
    ms.columns *= ms.n / (ms.k - 1.0);
    ms.rest /= (ms.n - 1.0) * (ms.k - 1.0);
    return ms;
}

constexpr double kUpper = 0.975;
constexpr Icc kUnknownIcc{kNoRating, {kNoRating, kNoRating}};

bool is_defined(std::span<const double> table, std::size_t people) {
    return people > 1 && table.size() >= 2 * people &&
           std::ranges::any_of(table, [&table](double value) { return value != table.front(); });
}

// The pairs that all have rated, row after row.
std::vector<double> complete_rows(const std::vector<Judgement>& people) {
    std::vector<double> table;
    for (std::size_t p = 0; !people.empty() && p < people.front().condensed.size(); ++p) {
        const bool is_known = std::ranges::all_of(
            people, [p](const Judgement& one) { return std::isfinite(one.condensed[p]); });
        for (std::size_t k = 0; is_known && k < people.size(); ++k) {
            table.push_back(people[k].condensed[p]);
        }
    }
    return table;
}

// 1 - observed / expected disagreement; the sum over two values of (a - b)^2 of m values is
// 2 (m sum a^2 - (sum a)^2).
void find_alpha(InterRater& result, const std::vector<Judgement>& people) {
    result.alpha = kNoRating;
    const std::vector<double> known = [&] {
        std::vector<double> values;
        for (const Judgement& one : people) {
            values.insert(values.end(), one.condensed.begin(), one.condensed.end());
        }
        return values;
    }();
    const double centre = mean_known(known);  // keeps the digits of the squares
    double observed = 0.0;
    double all = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t p = 0; !people.empty() && p < people.front().condensed.size(); ++p) {
        double m = 0.0;
        double own = 0.0;
        double own_squares = 0.0;
        for (const Judgement& one : people) {
            if (!std::isfinite(one.condensed[p])) continue;
            const double value = one.condensed[p] - centre;
            m += 1.0;
            own += value;
            own_squares += value * value;
        }
        if (m < 2.0) continue;
        ++result.alpha_pairs;
        observed += 2.0 * (m * own_squares - own * own) / (m - 1.0);
        all += m;
        sum += own;
        squares += own_squares;
    }
    const double expected = 2.0 * (all * squares - sum * sum) / (all - 1.0);
    if (all > 2.0 && expected > 0.0) result.alpha = 1.0 - observed / expected;
}

}  // namespace

Icc icc_single(std::span<const double> table, std::size_t people) {
    if (!is_defined(table, people)) return kUnknownIcc;
    const MeanSquares ms = mean_squares(table, people);
    const double n = ms.n;
    const double k = ms.k;
    Icc icc;
    icc.value =
        (ms.rows - ms.rest) / (ms.rows + (k - 1.0) * ms.rest + k * (ms.columns - ms.rest) / n);
    const double a = k * icc.value / (n * (1.0 - icc.value));
    const double b = 1.0 + (n - 1.0) * a;
    const double columns = a * ms.columns;
    const double rest = b * ms.rest;
    const double df = (columns + rest) * (columns + rest) /
                      (columns * columns / (k - 1.0) + rest * rest / ((n - 1.0) * (k - 1.0)));
    // Not of people who agree to the last digit, or less than by chance.
    if (!(df > 0.0) || !std::isfinite(df)) return {icc.value, kUnknownIcc.interval};
    const double low = f_quantile(kUpper, n - 1.0, df);
    const double high = f_quantile(kUpper, df, n - 1.0);
    const double others = k * ms.columns + (k * n - k - n) * ms.rest;
    icc.interval = {n * (ms.rows - low * ms.rest) / (low * others + n * ms.rows),
                    n * (high * ms.rows - ms.rest) / (others + n * high * ms.rows)};
    return icc;
}

Icc icc_mean(std::span<const double> table, std::size_t people) {
    if (!is_defined(table, people)) return kUnknownIcc;
    const MeanSquares ms = mean_squares(table, people);
    if (!(ms.rows > 0.0)) return kUnknownIcc;
    const double rest = (ms.n - 1.0) * (ms.k - 1.0);
    const double noise = ms.rest / ms.rows;
    return {1.0 - noise,
            {1.0 - noise * f_quantile(kUpper, ms.n - 1.0, rest),
             1.0 - noise / f_quantile(kUpper, rest, ms.n - 1.0)}};
}

InterRater inter_rater(const RatingStudy& study) {
    const std::vector<Judgement> people = participant_means(study);
    const std::vector<double> table = complete_rows(people);
    InterRater result;
    result.people = people.size();
    result.pairs = people.empty() ? 0 : table.size() / people.size();
    result.single = icc_single(table, people.size());
    result.mean = icc_mean(table, people.size());
    find_alpha(result, people);
    return result;
}

// Whether order, sides or practice shift ratings.
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
