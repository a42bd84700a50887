#include "model/study/agreement.h"

#include <algorithm>
#include <cmath>

#include "model/common/distributions.h"
#include "model/common/mean.h"

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

}  // namespace tact
