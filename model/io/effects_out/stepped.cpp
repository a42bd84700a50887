#include "model/io/effects_out/stepped.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tact {

namespace {

constexpr double kSameStepS = 1e-9;

// Positions of the points of a stretch.
struct Run {
    std::size_t first = 0;
    std::size_t last = 0;
    bool flat = false;
};

// Stretches without a jump, each flat or without a flat piece.
std::vector<Run> runs_of(const AmplitudeCurve& curve) {
    std::vector<Run> runs;
    for (std::size_t k = 1; k < curve.size(); ++k) {
        if (curve[k].time_s == curve[k - 1].time_s) continue;
        const bool flat = curve[k].value == curve[k - 1].value;
        if (!runs.empty() && runs.back().last == k - 1 && runs.back().flat == flat) {
            runs.back().last = k;
        } else {
            runs.push_back({k - 1, k, flat});
        }
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

void add_step(SteppedAmplitudes& steps, int length_ms, int amplitude) {
    if (length_ms <= 0) return;
    if (!steps.amplitudes.empty() && steps.amplitudes.back() == amplitude) {
        steps.timings_ms.back() += length_ms;
        return;
    }
    steps.timings_ms.push_back(length_ms);
    steps.amplitudes.push_back(amplitude);
}

int ms_at(double t_s) { return static_cast<int>(std::lround(1e3 * t_s)); }

// Silence alone is 0.
int flat_amplitude(double value) {
    if (!(value > 0.0)) return 0;
    return std::clamp(static_cast<int>(std::lround(255.0 * value)), 1, 255);
}

}  // namespace

bool is_staircase(const AmplitudeCurve& curve) {
    return std::ranges::all_of(runs_of(curve), &Run::flat);
}

SteppedAmplitudes stepped(const AmplitudeCurve& intensity, double duration_s, double step_s) {
    SteppedAmplitudes result;
    for (const Run& run : runs_of(intensity)) {
        const double start_s = intensity[run.first].time_s;
        const double end_s = intensity[run.last].time_s;
        const int end_ms = ms_at(end_s);
        int at_ms = ms_at(start_s);
        if (run.flat) {
            add_step(result, end_ms - at_ms, flat_amplitude(intensity[run.first].value));
            continue;
        }
        for (int k = 0; at_ms < end_ms; ++k) {
            const double from_s = start_s + k * step_s;
            const int to_ms = std::min(ms_at(from_s + step_s), end_ms);
            add_step(result, to_ms - at_ms, step_amplitude(intensity, run, from_s, step_s));
            at_ms = std::max(at_ms, to_ms);
        }
    }
    const int total_ms = std::accumulate(result.timings_ms.begin(), result.timings_ms.end(), 0);
    // Less than half a ms is a whole one: players refuse an effect without length.
    if (total_ms == 0) add_step(result, std::max(ms_at(duration_s), 1), 0);
    return result;
}

}  // namespace tact
