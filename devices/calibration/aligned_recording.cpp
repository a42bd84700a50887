#include "devices/calibration/aligned_recording.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "devices/calibration/plan_alignment.h"
#include "devices/calibration/tone_fit.h"
#include "model/signal/resample.h"

namespace tact {

namespace {

constexpr double kLeastClockOff = 5e-4;
constexpr double kLeastSweepClockOff = 2e-3;

// Where around `start` the highest tone fits best: that of a sweep would be lost elsewhere. A
// steady one has another phase and the same amplitude anywhere, and stays where it is.
std::size_t refined_start(const CalibrationPlan& plan, std::span<const double> samples,
                          std::size_t start) {
    constexpr std::size_t kStep = 5;
    constexpr std::size_t kAround = 100;  // 10 ms
    constexpr double kClearlyDb = 1.0;    // by less a place is no better
    std::size_t best = start;
    double most_db = fit_of(plan, plan.tones.back(), samples, start).snr_db + kClearlyDb;
    const std::size_t first = start - std::min(start, kAround);
    for (std::size_t at = first; at <= start + kAround; at += kStep) {
        const double snr_db = fit_of(plan, plan.tones.back(), samples, at).snr_db;
        if (snr_db > most_db) best = at;
        most_db = std::max(most_db, snr_db);
    }
    return best;
}

// The phase of a part of a tone, less the plan's.
double phase_of(const CalibrationPlan& plan, std::span<const double> samples, std::size_t start,
                std::size_t begin, std::size_t end) {
    double re = 0.0;
    double im = 0.0;
    for (std::size_t n = begin; n < std::min(end, samples.size() - start); ++n) {
        re += samples[start + n] * std::cos(plan.phase_rad[n]);
        im += samples[start + n] * std::sin(plan.phase_rad[n]);
    }
    return std::atan2(re, im);
}

// What the clock is still off, by how the phase of steady tones runs on from the first to the
// second half of each: to a millionth or so.
double clock_left(const CalibrationPlan& plan, std::span<const double> samples, std::size_t start) {
    double both = 0.0;
    double squares = 0.0;
    for (const CalibrationTone& tone : plan.tones) {
        const ToneFit fit = fit_of(plan, tone, samples, start);
        if (fit.snr_db < 6.0) continue;
        const std::size_t middle = (tone.begin + tone.end) / 2;
        const double turned = std::remainder(phase_of(plan, samples, start, middle, tone.end) -
                                                 phase_of(plan, samples, start, tone.begin, middle),
                                             (2.0 * std::numbers::pi));
        // The halves' middles are half a tone apart.
        const double per_share = (2.0 * std::numbers::pi) * tone.frequency_hz *
                                 static_cast<double>(tone.end - tone.begin) / 2.0 /
                                 plan.drive.rate_hz;
        const double weight = std::pow(10.0, std::min(fit.snr_db, 40.0) / 10.0);
        both += weight * per_share * turned;
        squares += weight * per_share * per_share;
    }
    return squares > 0.0 ? both / squares : 0.0;
}

Waveform with_clock(const Waveform& recorded, double clock_off) {
    Waveform right =
        resampled({recorded.rate_hz / (1.0 + clock_off), recorded.samples_g}, recorded.rate_hz);
    return right;
}

// By how many samples later than it should a tone of a sweep lies in the recording: where it fits
// best, from `around` before to that after. None: nowhere well.
std::optional<double> lateness_of(const CalibrationPlan& plan, const CalibrationTone& tone,
                                  std::span<const double> samples, std::ptrdiff_t start,
                                  std::ptrdiff_t around) {
    constexpr double kClearDb = 10.0;
    std::ptrdiff_t best = 0;
    double most_db = -300.0;
    const auto look = [&](std::ptrdiff_t from, std::ptrdiff_t to, std::ptrdiff_t step) {
        for (std::ptrdiff_t shift = from; shift <= to; shift += step) {
            const std::ptrdiff_t at = start + shift;
            if (at < 0 || at + static_cast<std::ptrdiff_t>(tone.end) > std::ssize(samples))
                continue;
            const double snr_db = fit_of(plan, tone, samples, static_cast<std::size_t>(at)).snr_db;
            if (snr_db > most_db) best = shift;
            most_db = std::max(most_db, snr_db);
        }
    };
    look(-around, around, 200);
    look(best - 160, best + 160, 20);
    return most_db < kClearDb ? std::nullopt : std::optional(static_cast<double>(best));
}

// What the clock of a sweep's recording is still off: the median of how much later each tone lies
// than another, as a resonance delays a few of them. To a thousandth or so.
double sweep_clock_left(const CalibrationPlan& plan, std::span<const double> samples,
                        std::size_t start, std::ptrdiff_t around) {
    std::vector<std::pair<double, double>> late;
    for (std::size_t k = 0; k < plan.tones.size(); k += 3) {
        const CalibrationTone& tone = plan.tones[k];
        const auto by =
            lateness_of(plan, tone, samples, static_cast<std::ptrdiff_t>(start), around);
        if (by) late.emplace_back(static_cast<double>(tone.begin + tone.end) / 2.0, *by);
    }
    std::vector<double> slopes;
    for (std::size_t i = 0; i < late.size(); ++i) {
        for (std::size_t j = i + 1; j < late.size(); ++j) {
            slopes.push_back((late[j].second - late[i].second) / (late[j].first - late[i].first));
        }
    }
    if (slopes.empty()) return 0.0;
    std::ranges::nth_element(slopes, slopes.begin() + std::ssize(slopes) / 2);
    return -slopes[slopes.size() / 2];
}

// ... of any recording. Less than that does no harm.
double least_clock_off(const CalibrationPlan& plan) {
    return plan.is_sweep ? kLeastSweepClockOff : kLeastClockOff;
}

double left_of_clock(const CalibrationPlan& plan, const AlignedRecording& made, int round) {
    const auto& samples = made.recorded.samples_g;
    if (!plan.is_sweep) return clock_left(plan, samples, made.start);
    return sweep_clock_left(plan, samples, made.start, round == 0 ? 6000 : 1000);
}

}  // namespace

std::optional<AlignedRecording> aligned_recording(const CalibrationPlan& plan,
                                                  const Waveform& recorded) {
    constexpr int kRounds = 5;
    const double least = least_clock_off(plan);
    double off = plan.is_sweep ? 0.0 : clock_off_of(plan, recorded.samples_g);
    for (int round = 0;; ++round) {
        const bool is_right = std::abs(off) < least;
        AlignedRecording made{is_right ? recorded : with_clock(recorded, off), 0,
                              is_right ? 0.0 : off};
        const std::size_t length = plan.drive.samples.size();
        if (made.recorded.samples_g.size() < length) made.recorded.samples_g.resize(length, 0.0);
        const auto found = place_of_plan(plan, made.recorded.samples_g);
        if (!found) return std::nullopt;
        made.start = refined_start(plan, made.recorded.samples_g, *found);
        if (round == kRounds) return made;
        const double left = left_of_clock(plan, made, round);
        if (std::abs(left) < (made.clock_off == 0.0 ? least : least / 10.0)) return made;
        off = (1.0 + made.clock_off) * (1.0 + left) - 1.0;
        if (std::abs(off) > 2.0 * kMostClockOff) return std::nullopt;
    }
}

}  // namespace tact
