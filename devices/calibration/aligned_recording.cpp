#include "devices/calibration/aligned_recording.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "devices/calibration/plan_alignment.h"
#include "devices/calibration/ringing.h"
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

// The middle of each third tone of a sweep, and its lateness.
std::vector<std::pair<double, double>> latenesses(const CalibrationPlan& plan,
                                                  std::span<const double> samples,
                                                  std::size_t start, std::ptrdiff_t around) {
    std::vector<std::pair<double, double>> late;
    for (std::size_t k = 0; k < plan.tones.size(); k += 3) {
        const CalibrationTone& tone = plan.tones[k];
        const auto by =
            lateness_of(plan, tone, samples, static_cast<std::ptrdiff_t>(start), around);
        if (by) late.emplace_back(static_cast<double>(tone.begin + tone.end) / 2.0, *by);
    }
    return late;
}

// What the clock of a sweep's recording is still off: the median of how much later each tone lies
// than another, as a resonance delays a few of them. To a thousandth or so.
double clock_left_of(const std::vector<std::pair<double, double>>& late) {
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

double sweep_clock_left(const CalibrationPlan& plan, std::span<const double> samples,
                        std::size_t start, std::ptrdiff_t around) {
    return clock_left_of(latenesses(plan, samples, start, around));
}

std::size_t moved_by_median(std::size_t start, std::vector<std::pair<double, double>> late) {
    if (late.empty()) return start;
    const auto middle = late.begin() + std::ssize(late) / 2;
    std::ranges::nth_element(late, middle, {}, &std::pair<double, double>::second);
    const double moved = static_cast<double>(start) + middle->second;
    return static_cast<std::size_t>(std::max(0.0, moved));
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

Waveform of_clock(const Waveform& recorded, double clock_off, std::size_t least_count) {
    Waveform made = clock_off == 0.0 ? recorded : with_clock(recorded, clock_off);
    made.samples_g.resize(std::max(made.samples_g.size(), least_count), 0.0);
    return made;
}

std::optional<AlignedRecording> aligned(const CalibrationPlan& plan, const Waveform& recorded,
                                        bool latest = false) {
    constexpr int kRounds = 5;
    const double least = least_clock_off(plan);
    double off = plan.is_sweep ? 0.0 : clock_off_of(plan, recorded.samples_g);
    for (int round = 0;; ++round) {
        const double taken = std::abs(off) < least ? 0.0 : off;
        AlignedRecording made{of_clock(recorded, taken, plan.drive.samples.size()), 0, taken};
        const auto found = place_of_plan(plan, made.recorded.samples_g, latest);
        if (!found) return std::nullopt;
        made.start = refined_start(plan, made.recorded.samples_g, *found);
        if (round == kRounds) return made;
        const double left = left_of_clock(plan, made, round);
        if (std::abs(left) < (made.clock_off == 0.0 ? least : least / 10.0)) return made;
        off = (1.0 + made.clock_off) * (1.0 + left) - 1.0;
        if (std::abs(off) > 2.0 * kMostClockOff) return std::nullopt;
    }
}

// The last of several sweeps, which is the strongest, as a plan of its own from sample `begin` on.
CalibrationPlan last_sweep_of(const CalibrationPlan& plan, std::size_t begin) {
    const auto from = static_cast<std::ptrdiff_t>(begin);
    CalibrationPlan last{
        {plan.drive.rate_hz, {plan.drive.samples.begin() + from, plan.drive.samples.end()}},
        {plan.phase_rad.begin() + from, plan.phase_rad.end()},
        {},
        true};
    for (CalibrationTone tone : plan.tones) {
        if (tone.begin < begin) continue;
        tone.begin -= begin;
        tone.end -= begin;
        last.tones.push_back(tone);
    }
    return last;
}

// By the last sweep first: it is above the noise where the others may not be. Over all of them the
// clock shows better, and needs to.
std::optional<AlignedRecording> aligned_sweeps(const CalibrationPlan& plan, std::size_t last_begin,
                                               const Waveform& recorded) {
    constexpr int kRounds = 3;
    constexpr double kLeast = 5e-5;  // 2 ms at the first sweep
    const CalibrationPlan last = last_sweep_of(plan, last_begin);
    std::optional<AlignedRecording> found = aligned(last, recorded, true);
    for (int round = 0; found; ++round) {
        if (found->start < last_begin) return std::nullopt;
        found->start -= last_begin;
        const auto late = latenesses(plan, found->recorded.samples_g, found->start, 1000);
        const double left = clock_left_of(late);
        if (round == kRounds || std::abs(left) < kLeast) {
            found->start = moved_by_median(found->start, late);
            return found;
        }
        const double off = (1.0 + found->clock_off) * (1.0 + left) - 1.0;
        const auto was = static_cast<double>(found->start + last_begin);
        AlignedRecording made{of_clock(recorded, off, plan.drive.samples.size()), 0, off};
        made.start = refined_start(last, made.recorded.samples_g,
                                   static_cast<std::size_t>(std::max(0.0, was * (1.0 + left))));
        found = std::move(made);
    }
    return found;
}

}  // namespace

std::optional<AlignedRecording> aligned_recording(const CalibrationPlan& plan,
                                                  const Waveform& recorded) {
    if (!plan.is_sweep || plan.tones.empty()) return aligned(plan, recorded);
    const double strongest = plan.tones.back().level;
    const auto last = std::ranges::find(plan.tones, strongest, &CalibrationTone::level);
    if (last == plan.tones.begin()) return aligned(plan, recorded);
    return aligned_sweeps(plan, (last - 1)->end, recorded);
}

}  // namespace tact
