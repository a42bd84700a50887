#include "model/pattern/tapped_rhythm.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "model/pattern/pattern.h"

namespace tact {

namespace {

constexpr double kNormalS = 0.125;
constexpr double kLeastS = 0.02;
constexpr int kMostParts = 8;
constexpr double kOnGrid = 0.125;   // rms, in steps
constexpr double kRestFrom = 0.25;  // of a step: less between two notes does not count

// Onsets against the steps nearest to them: t = phase + step k.
struct Grid {
    double step_s = 0.0;
    double phase_s = 0.0;
    double rms_s = 0.0;
};

double step_index(double since_first_s, double step_s) {
    return std::round(since_first_s / step_s);
}

Grid phased(std::span<const Tap> taps, double step_s) {
    const double first_s = taps.front().onset_s;
    double sum_s = 0.0;
    double squares = 0.0;
    for (const Tap& tap : taps) {
        const double since_s = tap.onset_s - first_s;
        const double off_s = since_s - step_s * step_index(since_s, step_s);
        sum_s += off_s;
        squares += off_s * off_s;
    }
    const auto n = static_cast<double>(taps.size());
    const double phase_s = sum_s / n;
    return {step_s, phase_s, std::sqrt(std::max(0.0, squares / n - phase_s * phase_s))};
}

// The slope of onsets over their steps, which are counted from tap to tap: where the first guess is
// a little off, steps far from the first tap would be miscounted.
Grid fitted(std::span<const Tap> taps, double step_s) {
    const double first_s = taps.front().onset_s;
    const auto n = static_cast<double>(taps.size());
    for (int pass = 0; pass < 4; ++pass) {
        double k = 0.0;
        double k_sum = 0.0;
        double t_sum = 0.0;
        double kk_sum = 0.0;
        double kt_sum = 0.0;
        for (std::size_t i = 0; i < taps.size(); ++i) {
            const double t_s = taps[i].onset_s - first_s;
            if (i > 0) k += step_index(taps[i].onset_s - taps[i - 1].onset_s, step_s);
            k_sum += k;
            t_sum += t_s;
            kk_sum += k * k;
            kt_sum += k * t_s;
        }
        const double spread = kk_sum - k_sum * k_sum / n;
        if (!(spread > 0.0)) break;
        step_s = std::max(kLeastS, (kt_sum - k_sum * t_sum / n) / spread);
    }
    return phased(taps, step_s);
}

// The mean of those that are the shortest but for the hand's unsteadiness.
double short_interval_s(std::span<const Tap> taps) {
    constexpr double kAsShort = 1.4;
    std::vector<double> intervals;
    for (std::size_t k = 1; k < taps.size(); ++k) {
        intervals.push_back(taps[k].onset_s - taps[k - 1].onset_s);
    }
    const double most_s = kAsShort * std::ranges::min(intervals);
    std::erase_if(intervals, [most_s](double interval_s) { return interval_s > most_s; });
    const double sum_s = std::accumulate(intervals.begin(), intervals.end(), 0.0);
    return std::max(kLeastS, sum_s / static_cast<double>(intervals.size()));
}

double median_length_s(std::span<const Tap> taps) {
    std::vector<double> lengths;
    for (const Tap& tap : taps) lengths.push_back(tap.length_s);
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::ranges::nth_element(lengths, middle);
    return *middle;
}

bool rested_before(std::span<const Tap> taps, std::size_t k, double step_s) {
    const double let_go_s = taps[k - 1].onset_s + taps[k - 1].length_s;
    return taps[k].onset_s - let_go_s >= kRestFrom * step_s;
}

// Whether every rest between two taps has a step to be.
bool rests_have_room(std::span<const Tap> taps, double step_s) {
    for (std::size_t k = 1; k < taps.size(); ++k) {
        const double steps = step_index(taps[k].onset_s - taps[k - 1].onset_s, step_s);
        if (steps < 2.0 && rested_before(taps, k, step_s)) return false;
    }
    return true;
}

}  // namespace

double estimated_step_s(std::span<const Tap> taps) {
    if (taps.size() < 2) return kNormalS;
    const double interval_s = short_interval_s(taps);
    const double longest_s = 2.0 * median_length_s(taps);
    Grid best{kNormalS, 0.0, std::numeric_limits<double>::infinity()};
    for (int parts = 1; parts <= kMostParts; ++parts) {
        const double first_s = interval_s / parts;
        if (first_s < kLeastS) break;
        const Grid grid = fitted(taps, first_s);
        const bool is_on_grid = grid.rms_s <= kOnGrid * grid.step_s;
        const bool says_lengths = grid.step_s <= longest_s && rests_have_room(taps, grid.step_s);
        if (is_on_grid && says_lengths) return grid.step_s;
        if (grid.rms_s < best.rms_s) best = grid;
    }
    return best.step_s;
}

TappedRhythm tapped_rhythm(std::span<const Tap> taps, double step_s, double least_s) {
    TappedRhythm result;
    result.rhythm.unit_s = step_s;
    if (taps.empty()) return result;
    const Grid grid = phased(taps, step_s);
    result.rms_error_s = grid.rms_s;
    std::string& text = result.rhythm.text;
    const double first_s = taps.front().onset_s + grid.phase_s;
    const auto index_of = [&](const Tap& tap) { return step_index(tap.onset_s - first_s, step_s); };
    for (std::size_t k = 0; k < taps.size(); ++k) {
        const double at = index_of(taps[k]);
        if (at < static_cast<double>(text.size()) || at >= static_cast<double>(kMaxRhythmSteps)) {
            ++result.left_out;
            continue;
        }
        double steps = std::max(1.0, step_index(taps[k].length_s, step_s));
        if (k + 1 < taps.size()) {
            const double rest = rested_before(taps, k + 1, step_s) ? 1.0 : 0.0;
            steps = std::min(steps, std::max(1.0, index_of(taps[k + 1]) - at - rest));
        }
        steps = std::min(steps, static_cast<double>(kMaxRhythmSteps) - at);
        text.resize(static_cast<std::size_t>(at), '-');
        text += 'x';
        text.append(static_cast<std::size_t>(steps) - 1, '=');
    }
    result.length_s = static_cast<double>(text.size()) * step_s;
    const double whole = std::ceil(least_s / step_s - 1e-9);
    if (whole > static_cast<double>(text.size()) && whole <= static_cast<double>(kMaxRhythmSteps)) {
        text.resize(static_cast<std::size_t>(whole), '-');
    }
    return result;
}

}  // namespace tact
