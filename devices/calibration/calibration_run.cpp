#include "devices/calibration/calibration_run.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <numbers>

#include "devices/calibration/aligned_recording.h"
#include "devices/calibration/plan_alignment.h"
#include "devices/calibration/proportion.h"
#include "devices/calibration/resonance.h"
#include "devices/calibration/ringing.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kTau = 2.0 * std::numbers::pi;
constexpr double kBurstHz = 150.0;
constexpr double kBurstS = 0.3;
constexpr double kPauseS = 0.3;  // after the burst, and at the end
constexpr double kRampS = 0.02;  // of every tone
constexpr double kMostThd = 0.1;
constexpr double kToldRingingDb = 0.25;
constexpr double kToldOffProportion = 0.04;  // less is noise, or nothing

// From the lowest to the highest by equal steps, as many to an octave or a few more: both ends are
// measured.
std::vector<double> frequencies(const CalibrationParams& params) {
    constexpr double kLastBit = 1e-9;
    const double octaves = std::log2(params.high_hz / params.low_hz);
    const int steps = static_cast<int>(std::ceil(octaves * params.per_octave - kLastBit));
    std::vector<double> all{params.low_hz};
    for (int k = 1; k < steps; ++k) all.push_back(params.low_hz * std::exp2(octaves * k / steps));
    if (steps > 0) all.push_back(params.high_hz);
    return all;
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
void add_sweep(CalibrationPlan& plan, const CalibrationParams& params, double level) {
    const double margin = std::exp2(1.0 / 12.0);
    const double low_hz = params.low_hz / margin;
    const double high_hz = params.high_hz * margin;
    const double octaves_per_s = std::log2(high_hz / low_hz) / params.sweep_s;
    const double scale = kTau * low_hz / (octaves_per_s * std::numbers::ln2);
    const std::size_t begin = plan.drive.samples.size();
    add_sine(plan, level, params.sweep_s,
             [&](double t_s) { return scale * (std::exp2(t_s * octaves_per_s) - 1.0); });
    const auto place = [&](double f_hz) {
        const double t_s = std::log2(f_hz / low_hz) / octaves_per_s;
        const std::size_t at = sample_count(std::max(0.0, t_s), plan.drive.rate_hz);
        return std::min(begin + at, plan.drive.samples.size());
    };
    const double half = std::exp2(1.0 / 24.0);
    for (const double f_hz : frequencies(params)) {
        plan.tones.push_back({f_hz, level, place(f_hz / half), place(f_hz * half)});
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

void tell_ringing(const std::vector<Resonance>& sharp, std::vector<std::string>& remarks) {
    for (const Resonance& one : sharp) {
        if (one.corrected_db < kToldRingingDb) continue;
        remarks.push_back("at " + significant_digits(one.f0_hz, 3) + " Hz it rings (Q " +
                          significant_digits(one.q, 3) +
                          ") for longer than the signal stays there: strengths around it are "
                          "those of that resonance, by up to " +
                          significant_digits(one.corrected_db, 3) + " dB other than was measured");
    }
}

// What follows a little less than in proportion does so at lower levels, too: by half of what the
// softest limit makes of it.
void raise_a_little(MeasuredPoint& one) {
    if (one.followed.size() < 2 || one.point.nonlinearity < kToldOffProportion) return;
    const auto raised = raised_by(one.followed[0], one.followed[1]);
    const double noise =
        3.0 * std::hypot(one.followed[0].standard_error, one.followed[1].standard_error);
    if (raised && noise < 0.5 * one.point.nonlinearity) {
        one.point.g_per_full_scale *= std::sqrt(*raised);
    }
}

// The table made finer, each run of known points by itself.
FinerTable finer_runs(const std::vector<MeasuredPoint>& measured,
                      const std::vector<Resonance>& sharp) {
    FinerTable all;
    std::vector<ResponsePoint> run;
    const auto end_run = [&] {
        const FinerTable finer = finer_table(run, sharp);
        all.points.insert(all.points.end(), finer.points.begin(), finer.points.end());
        all.remarks.insert(all.remarks.end(), finer.remarks.begin(), finer.remarks.end());
        run.clear();
    };
    for (const MeasuredPoint& one : measured) {
        if (!one.point.unknown) {
            run.push_back(one.point);
            continue;
        }
        end_run();
        all.points.push_back(one.point);
    }
    end_run();
    return all;
}

}  // namespace

CalibrationPlan calibration_plan(const CalibrationParams& params) {
    assert(!params.levels.empty() && params.low_hz > 0.0 && params.high_hz >= params.low_hz);
    CalibrationPlan plan;
    plan.is_sweep = params.is_sweep;
    add_sine(plan, params.levels.back(), kBurstS, [](double t_s) { return kTau * kBurstHz * t_s; });
    add_silence(plan, kPauseS);
    if (params.is_sweep) {
        for (const double level : params.sweep_levels) add_sweep(plan, params, level);
    } else {
        add_steps(plan, params);
    }
    add_silence(plan, kPauseS);
    return plan;
}

std::string words_on_left_out() {
    return percent(kMostThd) +
           " of harmonic distortion or more, or so much noise that the standard error of the "
           "amplitude is " +
           percent(kMostToneError) + " or more";
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
                                fit.thd < kMostThd && fit.standard_error < kMostToneError});
    }
    std::vector<MeasuredPoint> measured = in_proportion(result.tones);
    if (measured.empty()) {
        return Error{"no tone of this recording is clean enough: all have " + words_on_left_out()};
    }
    if (std::ranges::all_of(measured, [](const auto& one) { return one.point.unknown; })) {
        return Error{
            "nothing in this recording is in proportion to the drive: the sensor clips, or "
            "this is not the signal that was played"};
    }
    const std::vector<Resonance> sharp = proven_resonances(plan, measured);
    for (MeasuredPoint& one : measured) {
        const double f_hz = one.point.frequency_hz;
        const auto covers = [f_hz](const Resonance& known) {
            return f_hz >= known.low_hz && f_hz <= known.high_hz;
        };
        if (std::ranges::none_of(sharp, covers)) raise_a_little(one);
    }
    FinerTable finer = finer_runs(measured, sharp);
    result.points = std::move(finer.points);
    result.remarks = std::move(finer.remarks);
    if (const std::string left_out = remark_on_left_out(result.tones); !left_out.empty()) {
        result.remarks.insert(result.remarks.begin(), left_out);
    }
    tell_ringing(sharp, result.remarks);
    for (std::string& remark : words_on_proportion(measured)) {
        result.remarks.push_back(std::move(remark));
    }
    if (result.clock_off != 0.0) {
        result.remarks.insert(result.remarks.begin(),
                              "the clock of this recording runs " +
                                  significant_digits(100.0 * std::abs(result.clock_off), 3) +
                                  " % " + (result.clock_off > 0.0 ? "slow" : "fast") +
                                  ", by the signal itself: taken out");
    }
    return result;
}

Expected<CalibrationResult> calibration_from(const CalibrationParams& params,
                                             const Waveform& recorded) {
    Expected<CalibrationResult> found = calibration_from(calibration_plan(params), recorded);
    if (found || !params.is_sweep) return found;
    CalibrationParams earlier = params;
    earlier.sweep_levels = {params.levels.back()};
    earlier.sweep_s = 20.0;
    Expected<CalibrationResult> old = calibration_from(calibration_plan(earlier), recorded);
    return old ? old : found;
}

}  // namespace tact
