// Android's timings and amplitudes as JSON, and Hapticlabs' .hla, which has the same two.
//
// Source    VibrationEffect.createWaveform, and Meta's converter and its tests: steps of 10 ms, the
//           last one shorter, amplitudes truncated to 1 to 255. Hapticlabs' documentation of .hla.
// Output    no frequency: the device has its own; each transient as a pulse

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "model/io/effects/effect.h"
#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/writers.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr double kAndroidStepS = 0.010;
constexpr double kSameStepS = 1e-9;

// Positions of the points of a stretch without a jump.
struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
};

std::vector<Run> runs_of(const AmplitudeCurve& curve) {
    std::vector<Run> runs{{0, 0}};
    for (std::size_t k = 1; k < curve.size(); ++k) {
        if (curve[k].time_s == curve[k - 1].time_s) runs.push_back({k, k});
        runs.back().last = k;
    }
    return runs;
}

// From the first value of a run to its last; single precision, backwards from the end, as there.
int step_amplitude(const AmplitudeCurve& curve, const Run& run, double t_s, double step_s) {
    const double start_s = curve[run.first].time_s;
    const double length_s = curve[run.last].time_s - start_s;
    double at_s = std::clamp(t_s, start_s, start_s + length_s);
    if (length_s > step_s + kSameStepS) {
        at_s = start_s + std::min((at_s - start_s) * length_s / (length_s - step_s), length_s);
    }
    std::size_t k = run.first;
    while (k < run.last && curve[k + 1].time_s < at_s) ++k;
    const AmplitudePoint& from = curve[k];
    const AmplitudePoint& to = curve[std::min(k + 1, run.last)];
    const double span_s = to.time_s - from.time_s;
    const auto left = static_cast<float>(span_s > 0.0 ? (to.time_s - at_s) / span_s : 0.0);
    const auto from_f = static_cast<float>(from.value);
    const auto to_f = static_cast<float>(to.value);
    const float value = to_f - (to_f - from_f) * left;
    return std::clamp(static_cast<int>(value * 255.0F), 1, 255);
}

bool is_silent_between(const AmplitudeCurve& curve, double from_s, double to_s) {
    if (sides_at(curve, from_s).behind > 0.0 || sides_at(curve, to_s).before > 0.0) return false;
    return std::ranges::none_of(curve, [&](const AmplitudePoint& point) {
        return point.time_s > from_s + kSameStepS && point.time_s < to_s - kSameStepS &&
               point.value > 0.0;
    });
}

SteppedAmplitudes merged_steps(const SteppedAmplitudes& steps) {
    SteppedAmplitudes merged;
    for (std::size_t k = 0; k < steps.amplitudes.size(); ++k) {
        if (!merged.amplitudes.empty() && merged.amplitudes.back() == steps.amplitudes[k]) {
            merged.timings_ms.back() += steps.timings_ms[k];
        } else {
            merged.amplitudes.push_back(steps.amplitudes[k]);
            merged.timings_ms.push_back(steps.timings_ms[k]);
        }
    }
    return merged;
}

void remark_left_out_hz(const FrequencyCurve& curve, std::vector<std::string>& remarks) {
    const auto [low, high] = std::ranges::minmax(curve, {}, &FrequencyPoint::frequency_hz);
    std::string hz = significant_digits(low.frequency_hz, 4);
    if (high.frequency_hz != low.frequency_hz) {
        hz += " to " + significant_digits(high.frequency_hz, 4);
    }
    remarks.push_back(hz + " Hz left out: the device has its own frequency");
}

SteppedAmplitudes android_steps(const Pattern& pattern, const ActuatorMap& map,
                                std::vector<std::string>& remarks) {
    const PlainCurves curves = with_pulses(as_curves(pattern, remarks), remarks);
    const double duration_s = curves.duration_s;
    const Shares shares = as_shares(curves, map, remarks);
    remark_left_out_hz(curves.frequency, remarks);
    remarks.push_back("amplitude is in steps of 10 ms and of 1/255");
    const SteppedAmplitudes steps = stepped(shares.amplitude, duration_s, kAndroidStepS);
    const int total_ms = std::accumulate(steps.timings_ms.begin(), steps.timings_ms.end(), 0);
    remark_end(1e-3 * total_ms, duration_s, remarks);
    return steps;
}

}  // namespace

SteppedAmplitudes stepped(const AmplitudeCurve& intensity, double duration_s, double step_s) {
    SteppedAmplitudes result;
    const std::vector<Run> runs = runs_of(intensity);
    std::size_t run = 0;
    for (int k = 0; k * step_s < duration_s - kSameStepS; ++k) {
        const double from_s = k * step_s;
        const double to_s = std::min(from_s + step_s, duration_s);
        while (run + 1 < runs.size() &&
               intensity[runs[run + 1].first].time_s <= from_s + kSameStepS) {
            ++run;
        }
        result.timings_ms.push_back(
            static_cast<int>(std::max(std::lround(1e3 * (to_s - from_s)), 1L)));
        result.amplitudes.push_back(is_silent_between(intensity, from_s, to_s)
                                        ? 0
                                        : step_amplitude(intensity, runs[run], from_s, step_s));
    }
    return result;
}

WrittenEffect write_android_timings(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    const SteppedAmplitudes steps = android_steps(pattern, target.map, written.remarks);
    written.text =
        Json{{"timings", steps.timings_ms}, {"amplitudes", steps.amplitudes}, {"repeat", -1}}
            .dump() +
        "\n";
    return written;
}

WrittenEffect write_hla(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    const SteppedAmplitudes steps =
        merged_steps(android_steps(pattern, target.map, written.remarks));
    const int total_ms = std::accumulate(steps.timings_ms.begin(), steps.timings_ms.end(), 0);
    written.text = Json{{"ProjectName", "tactspace"},
                        {"TrackName", valid_utf8(target.name)},
                        {"Duration", total_ms},
                        {"Timings", steps.timings_ms},
                        {"Amplitudes", steps.amplitudes},
                        {"Repeat", -1},
                        {"RequiredAudioFiles", Json::array()},
                        {"Audios", Json::array()}}
                       .dump() +
                   "\n";
    return written;
}

}  // namespace tact
