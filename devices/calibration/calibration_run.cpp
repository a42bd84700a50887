#include "devices/calibration/calibration_run.h"

#include <Eigen/Core>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <span>

#include "devices/calibration/plan_alignment.h"
#include "devices/calibration/resonance.h"
#include "model/common/decompositions.h"

namespace tact {

namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr double kBurstHz = 150.0;
constexpr double kBurstS = 0.3;
constexpr double kPauseS = 0.3;  // after the burst, and at the end
constexpr double kRampS = 0.02;  // of every tone
constexpr int kHarmonics = 5;
constexpr double kMostThd = 0.1;
constexpr double kMostError = 0.03;  // standard error of an amplitude: 0.26 dB

std::vector<double> frequencies(const CalibrationParams& params) {
    std::vector<double> all;
    for (int k = 0;; ++k) {
        const double f_hz = params.low_hz * std::exp2(static_cast<double>(k) / params.per_octave);
        // The highest one is not missed for its last bit.
        if (f_hz > params.high_hz * (1.0 + 1e-9)) return all;
        all.push_back(f_hz);
    }
}

void add_silence(CalibrationPlan& plan, double seconds) {
    const std::size_t count = plan.drive.samples.size() + sample_count(seconds, plan.drive.rate_hz);
    plan.drive.samples.resize(count, 0.0);
    plan.phase_rad.resize(count, 0.0);
}

// A sine with ramps; `phase_at` from its own beginning.
template <class PhaseAt>
void add_sine(CalibrationPlan& plan, double level, double seconds, PhaseAt&& phase_at) {
    const double rate_hz = plan.drive.rate_hz;
    const std::size_t count = sample_count(seconds, rate_hz);
    for (std::size_t n = 0; n < count; ++n) {
        const double t_s = static_cast<double>(n) / rate_hz;
        const double ramp = std::min({1.0, t_s / kRampS, (seconds - t_s) / kRampS});
        const double phase = phase_at(t_s);
        plan.phase_rad.push_back(phase);
        plan.drive.samples.push_back(level * ramp * std::sin(phase));
    }
}

void add_steps(CalibrationPlan& plan, const CalibrationParams& params) {
    const double rate_hz = plan.drive.rate_hz;
    for (const double f_hz : frequencies(params)) {
        for (const double level : params.levels) {
            const std::size_t begin = plan.drive.samples.size();
            add_sine(plan, level, params.tone_s, [f_hz](double t_s) { return kTau * f_hz * t_s; });
            plan.tones.push_back({f_hz, level, begin + sample_count(params.settle_s, rate_hz),
                                  plan.drive.samples.size() - sample_count(kRampS, rate_hz)});
        }
    }
}

// f(t) = low 2^(t r), so p(t) = 2 pi low (2^(t r) - 1) / (r ln 2).
void add_sweep(CalibrationPlan& plan, const CalibrationParams& params) {
    const double margin = std::exp2(1.0 / 12.0);
    const double low_hz = params.low_hz / margin;
    const double high_hz = params.high_hz * margin;
    const double octaves_per_s = std::log2(high_hz / low_hz) / params.sweep_s;
    const double scale = kTau * low_hz / (octaves_per_s * std::numbers::ln2);
    const std::size_t begin = plan.drive.samples.size();
    add_sine(plan, params.levels.back(), params.sweep_s,
             [&](double t_s) { return scale * (std::exp2(t_s * octaves_per_s) - 1.0); });
    const auto place = [&](double f_hz) {
        const double t_s = std::log2(f_hz / low_hz) / octaves_per_s;
        const std::size_t at = sample_count(std::max(0.0, t_s), plan.drive.rate_hz);
        return std::min(begin + at, plan.drive.samples.size());
    };
    const double half = std::exp2(1.0 / 24.0);
    for (const double f_hz : frequencies(params)) {
        plan.tones.push_back({f_hz, params.levels.back(), place(f_hz / half), place(f_hz * half)});
    }
}

struct Fit {
    double amplitude_g = 0.0;
    double thd = 0.0;
    double snr_db = 0.0;
    double standard_error = 0.0;
};

// The model of the head comment. `samples` and `phase` of one length.
Fit fitted(std::span<const double> samples, std::span<const double> phase) {
    constexpr int kColumns = 2 * kHarmonics + 1;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(kColumns, kColumns);
    Eigen::Vector<double, kColumns> right = Eigen::Vector<double, kColumns>::Zero();
    Eigen::Vector<double, kColumns> row;
    const auto fill = [&row](double p) {
        row(0) = 1.0;
        for (int h = 1; h <= kHarmonics; ++h) {
            row(2 * h - 1) = std::cos(h * p);
            row(2 * h) = std::sin(h * p);
        }
    };
    for (std::size_t n = 0; n < samples.size(); ++n) {
        fill(phase[n]);
        normal.noalias() += row * row.transpose();
        right += samples[n] * row;
    }
    const Eigen::Vector<double, kColumns> solved = solved_symmetric(normal, right);
    double rest = 0.0;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        fill(phase[n]);
        const double left = samples[n] - row.dot(solved);
        rest += left * left / static_cast<double>(samples.size());
    }
    const double fundamental = solved.segment<2>(1).squaredNorm();
    const double harmonics = solved.tail<2 * kHarmonics - 2>().squaredNorm();
    if (!(fundamental > 0.0)) return {0.0, 0.0, -300.0, 1e15};
    const double snr = fundamental / 2.0 / std::max(rest, 1e-30);
    const double half = static_cast<double>(samples.size()) / 2.0;
    return {std::sqrt(fundamental), std::sqrt(harmonics / fundamental), 10.0 * std::log10(snr),
            1.0 / std::sqrt(snr * half)};
}

// A tone of the plan in the recording that begins it at `start`.
Fit fit_of(const CalibrationPlan& plan, const CalibrationTone& tone,
           std::span<const double> samples, std::size_t start) {
    const std::size_t end = std::min(start + tone.end, samples.size());
    const std::size_t begin = std::min(start + tone.begin, end);
    return fitted(samples.subspan(begin, end - begin),
                  std::span(plan.phase_rad).subspan(tone.begin, end - begin));
}

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

// Empty where all tones were taken.
std::string remark_on_left_out(const std::vector<MeasuredTone>& tones) {
    const auto taken = std::ranges::count_if(tones, &MeasuredTone::accepted);
    const auto all = std::ssize(tones);
    if (taken == all) return {};
    return std::to_string(all - taken) + " of " + std::to_string(all) +
           " tones were left out: " + words_on_left_out();
}

// One point a frequency: at its highest accepted level, with how far the others are off.
std::vector<ResponsePoint> points_of(const std::vector<MeasuredTone>& tones) {
    std::map<double, std::vector<const MeasuredTone*>> accepted;
    for (const MeasuredTone& tone : tones) {
        if (tone.accepted) accepted[tone.tone.frequency_hz].push_back(&tone);
    }
    const auto strength = [](const MeasuredTone& one) { return one.amplitude_g / one.tone.level; };
    std::vector<ResponsePoint> points;
    for (const auto& [f_hz, levels] : accepted) {
        const MeasuredTone& highest = **std::ranges::max_element(
            levels, {}, [](const MeasuredTone* one) { return one->tone.level; });
        ResponsePoint point{f_hz, strength(highest), highest.tone.level, highest.thd, 0.0};
        for (const MeasuredTone* one : levels) {
            point.nonlinearity = std::max(point.nonlinearity,
                                          std::abs(strength(*one) / point.g_per_full_scale - 1.0));
        }
        points.push_back(point);
    }
    return points;
}

}  // namespace

CalibrationPlan calibration_plan(const CalibrationParams& params) {
    assert(!params.levels.empty() && params.low_hz > 0.0 && params.high_hz >= params.low_hz);
    CalibrationPlan plan;
    add_sine(plan, params.levels.back(), kBurstS, [](double t_s) { return kTau * kBurstHz * t_s; });
    add_silence(plan, kPauseS);
    if (params.is_sweep) {
        add_sweep(plan, params);
    } else {
        add_steps(plan, params);
    }
    add_silence(plan, kPauseS);
    return plan;
}

std::string words_on_left_out() {
    const auto percent = [](double share) {
        return std::to_string(std::lround(100.0 * share)) + " %";
    };
    return percent(kMostThd) +
           " of harmonic distortion or more, or so much noise that the standard error of the "
           "amplitude is " +
           percent(kMostError) + " or more";
}

Expected<CalibrationResult> calibration_from(const CalibrationPlan& plan,
                                             const Waveform& recorded) {
    const auto& samples = recorded.samples_g;
    if (recorded.rate_hz != plan.drive.rate_hz) {
        return Error{"expected a recording of 10,000 Hz"};
    }
    const std::size_t length = plan.drive.samples.size();
    if (samples.size() < length) {
        return Error{"expected a recording of the whole calibration signal, " +
                     std::to_string(length / 10'000) + " s or more"};
    }
    const std::optional<std::size_t> found = place_of_plan(plan, samples);
    if (!found) return Error{"the calibration signal is not in this recording"};
    const std::size_t start = refined_start(plan, samples, *found);
    CalibrationResult result;
    result.begins_s = static_cast<double>(start) / recorded.rate_hz;
    for (const CalibrationTone& tone : plan.tones) {
        const Fit fit = fit_of(plan, tone, samples, start);
        result.tones.push_back({tone, fit.amplitude_g, fit.thd, fit.snr_db, fit.standard_error,
                                fit.thd < kMostThd && fit.standard_error < kMostError});
    }
    result.points = points_of(result.tones);
    if (result.points.empty()) {
        return Error{"no tone of this recording is clean enough: all have " + words_on_left_out()};
    }
    FinerTable finer = finer_table(result.points);
    result.points = std::move(finer.points);
    result.remarks = std::move(finer.remarks);
    if (const std::string left_out = remark_on_left_out(result.tones); !left_out.empty()) {
        result.remarks.insert(result.remarks.begin(), left_out);
    }
    return result;
}

}  // namespace tact
