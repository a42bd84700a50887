#include "devices/calibration/calibration_run.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <numbers>
#include <span>

#include "devices/calibration/aligned_recording.h"
#include "devices/calibration/plan_alignment.h"
#include "devices/calibration/resonance.h"
#include "devices/calibration/ringing.h"
#include "devices/calibration/tone_fit.h"

namespace tact {

namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr double kBurstHz = 150.0;
constexpr double kBurstS = 0.3;
constexpr double kPauseS = 0.3;  // after the burst, and at the end
constexpr double kRampS = 0.02;  // of every tone
constexpr double kMostThd = 0.1;
constexpr double kMostError = 0.03;          // standard error of an amplitude: 0.26 dB
constexpr double kMostOffProportion = 0.12;  // between levels: 1 dB
constexpr double kToldRingingDb = 0.25;

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

// Empty where all tones were taken.
std::string remark_on_left_out(const std::vector<MeasuredTone>& tones) {
    const auto taken = std::ranges::count_if(tones, &MeasuredTone::accepted);
    const auto all = std::ssize(tones);
    if (taken == all) return {};
    return std::to_string(all - taken) + " of " + std::to_string(all) +
           " tones were left out: " + words_on_left_out();
}

double strength(const MeasuredTone& one) { return one.amplitude_g / one.tone.level; }

// How far the strengths of tones of one frequency are off that of the last, as a share.
double off_proportion(std::span<const MeasuredTone* const> levels) {
    double most = 0.0;
    for (const MeasuredTone* one : levels) {
        most = std::max(most, std::abs(strength(*one) / strength(*levels.back()) - 1.0));
    }
    return most;
}

struct Points {
    std::vector<ResponsePoint> points;
    std::vector<CalibrationTone> tones;  // by which those were measured
    std::vector<double> left_out_hz;     // out of proportion already at the lowest levels
    std::size_t lowered = 0;  // measured at higher levels, too, which were not in proportion
};

// One point a frequency: at the highest accepted level up to which all are in proportion, as a
// table has one strength for all levels.
Points points_of(const std::vector<MeasuredTone>& tones) {
    std::map<double, std::vector<const MeasuredTone*>> accepted;
    for (const MeasuredTone& tone : tones) {
        if (tone.accepted) accepted[tone.tone.frequency_hz].push_back(&tone);
    }
    Points made;
    for (auto& [f_hz, levels] : accepted) {
        std::ranges::sort(levels, {}, [](const MeasuredTone* one) { return one->tone.level; });
        const std::size_t all = levels.size();
        while (levels.size() > 1 && off_proportion(levels) > kMostOffProportion) levels.pop_back();
        if (all > 1 && levels.size() == 1) {
            made.left_out_hz.push_back(f_hz);
            continue;
        }
        made.lowered += levels.size() < all ? 1 : 0;
        const MeasuredTone& highest = *levels.back();
        made.points.push_back(
            {f_hz, strength(highest), highest.tone.level, highest.thd, off_proportion(levels)});
        made.tones.push_back(highest.tone);
    }
    return made;
}

std::string short_digits(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

void tell_ringing(const std::vector<Resonance>& sharp, std::vector<std::string>& remarks) {
    for (const Resonance& one : sharp) {
        if (one.corrected_db < kToldRingingDb) continue;
        remarks.push_back("at " + short_digits(one.f0_hz) + " Hz it rings (Q " +
                          short_digits(one.q) +
                          ") for longer than the signal stays there: strengths around it are "
                          "those of that resonance, by up to " +
                          short_digits(one.corrected_db) + " dB other than was measured");
    }
}

void tell_proportion(const Points& made, std::vector<std::string>& remarks) {
    const std::string limit = std::to_string(std::lround(100.0 * kMostOffProportion)) + " %";
    if (!made.left_out_hz.empty()) {
        std::string where;
        for (const double f_hz : made.left_out_hz) {
            where += (where.empty() ? "" : ", ") + short_digits(f_hz);
        }
        remarks.push_back("left out " + where +
                          " Hz: what was measured there is out of proportion "
                          "to the drive by more than " +
                          limit + ", already at the lowest levels");
    }
    if (made.lowered > 0) {
        remarks.push_back("at " + std::to_string(made.lowered) +
                          " frequencies the actuator is in proportion to its drive, to " + limit +
                          ", at lower levels only: it is driven up to those");
    }
}

}  // namespace

CalibrationPlan calibration_plan(const CalibrationParams& params) {
    assert(!params.levels.empty() && params.low_hz > 0.0 && params.high_hz >= params.low_hz);
    CalibrationPlan plan;
    plan.is_sweep = params.is_sweep;
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
    // A clock that is slow has fewer samples for the same time.
    if (static_cast<double>(samples.size()) * (1.0 + kMostClockOff) < static_cast<double>(length)) {
        return Error{"expected a recording of the whole calibration signal, " +
                     std::to_string(length / 10'000) + " s or more"};
    }
    const std::optional<AlignedRecording> found = aligned_recording(plan, recorded);
    if (!found) return Error{"the calibration signal is not in this recording"};
    CalibrationResult result;
    result.clock_off = found->clock_off;
    result.begins_s = static_cast<double>(found->start) / recorded.rate_hz;
    for (const CalibrationTone& tone : plan.tones) {
        const ToneFit fit = fit_of(plan, tone, found->recorded.samples_g, found->start);
        result.tones.push_back({tone, fit.amplitude_g, fit.thd, fit.snr_db, fit.standard_error,
                                fit.thd < kMostThd && fit.standard_error < kMostError});
    }
    Points made = points_of(result.tones);
    if (made.points.empty() && !made.left_out_hz.empty()) {
        return Error{
            "nothing in this recording is in proportion to the drive: the sensor clips, or "
            "this is not the signal that was played"};
    }
    if (made.points.empty()) {
        return Error{"no tone of this recording is clean enough: all have " + words_on_left_out()};
    }
    const std::vector<Resonance> sharp = sharp_resonances(plan, made.tones, made.points);
    FinerTable finer = finer_table(made.points, sharp);
    result.points = std::move(finer.points);
    result.remarks = std::move(finer.remarks);
    if (const std::string left_out = remark_on_left_out(result.tones); !left_out.empty()) {
        result.remarks.insert(result.remarks.begin(), left_out);
    }
    tell_ringing(sharp, result.remarks);
    tell_proportion(made, result.remarks);
    if (result.clock_off != 0.0) {
        result.remarks.insert(result.remarks.begin(),
                              "the clock of this recording runs " +
                                  short_digits(100.0 * std::abs(result.clock_off)) + " % " +
                                  (result.clock_off > 0.0 ? "slow" : "fast") +
                                  ", by the signal itself: taken out");
    }
    return result;
}

}  // namespace tact
