#include "model/io/effects/effect.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/pattern/curves.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr int kDeepest = 6;  // halvings between two points

struct Bending {
    const std::function<double(double)>& f;
    double tolerance;
};

// Points between two, where `f` is not straight there.
void add_between(AmplitudeCurve& result, const Bending& bending, AmplitudePoint a, AmplitudePoint b,
                 int depth) {
    const double at_a = bending.f(a.value);
    const double at_b = bending.f(b.value);
    bool straight = depth == 0;
    for (const double share : {0.25, 0.5, 0.75}) {
        const double there = bending.f(a.value + share * (b.value - a.value));
        const double line = at_a + share * (at_b - at_a);
        if (std::abs(there - line) > bending.tolerance) break;
        straight = straight || share == 0.75;
    }
    if (straight) return;
    const AmplitudePoint middle{0.5 * (a.time_s + b.time_s), 0.5 * (a.value + b.value)};
    add_between(result, bending, a, middle, depth - 1);
    result.push_back({middle.time_s, bending.f(middle.value)});
    add_between(result, bending, middle, b, depth - 1);
}

}  // namespace

double needed_number_of(JsonObject& object, std::string_view key, Range range) {
    if (field(object, key) == nullptr) {
        refuse_plainly(*object.reading, place_of(object, key), "expected a number, it is missing");
    }
    return number_field(object, key, range.low, range);
}

void refuse_plainly(JsonReading& reading, const std::string& place, const std::string& sentence) {
    if (reading.fault.empty()) reading.fault = reading.file + ": " + place + ": " + sentence;
}

JsonReading reading_of(const EffectFile& file) {
    return {file.path, {}, UnknownKeys::passed_over, &file.budget};
}

std::string pay_points(const EffectFile& file, std::size_t count) {
    if (pay(file.budget.points, count)) return halted(file.budget);
    return "expected fewer points: references, or controls of many events, make too many of those "
           "that are written";
}

void remark_once(std::vector<std::string>& remarks, const std::string& remark) {
    constexpr std::size_t kMostRemarks = 100;
    if (remarks.size() >= kMostRemarks) return;
    if (std::ranges::find(remarks, remark) == remarks.end()) remarks.push_back(remark);
}

Expected<Effect> finished(const EffectFile& file, const std::string& name, const Sketch& sketch,
                          std::vector<std::string> remarks) {
    auto pattern = pattern_of(sketch, remarks);
    if (!pattern) return Error{file.path + ": " + pattern.error().message};
    const bool silent = pattern->transients.empty() &&
                        !(pattern->amplitude_g * peak_value(pattern->amplitude_curve) > 0.0);
    if (silent) remark_once(remarks, "it is silent: there is nothing to feel in it");
    return Effect{name, *std::move(pattern), std::move(remarks)};
}

Expected<Done> times_make_sense(const EffectFile& file, double latest_ms) {
    if (!(latest_ms > 0.0) || latest_ms >= 1.0) return Done{};
    return Error{file.path + ": expected times in ms, the greatest of all is " +
                 significant_digits(latest_ms, 4) + " ms: these may be seconds"};
}

AmplitudeCurve mapped(const AmplitudeCurve& curve, const std::function<double(double)>& f,
                      double tolerance) {
    AmplitudeCurve result;
    for (std::size_t k = 0; k < curve.size(); ++k) {
        if (k > 0 && curve[k - 1].time_s < curve[k].time_s) {
            add_between(result, {f, tolerance}, curve[k - 1], curve[k], kDeepest);
        }
        result.push_back({curve[k].time_s, f(curve[k].value)});
    }
    return result;
}

AmplitudeCurve acceleration_curve(const ActuatorMap& map, const AmplitudeCurve& intensities_01) {
    const double tolerance_g = 1e-3 * continuous_g(map, 1.0);
    return mapped(
        intensities_01, [&](double intensity) { return continuous_g(map, intensity); },
        tolerance_g);
}

FrequencyCurve frequency_curve(const ActuatorMap& map, const AmplitudeCurve& frequencies_01) {
    constexpr double kToleranceHz = 0.1;
    FrequencyCurve result;
    for (const AmplitudePoint& point : mapped(
             frequencies_01, [&](double share) { return frequency_hz(map, share); },
             kToleranceHz)) {
        result.push_back({point.time_s, point.value});
    }
    return result;
}

void add_bursts(std::vector<Transient>& all, const std::vector<Transient>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

AmplitudeCurve stairs(const std::vector<double>& ends_s, const std::vector<double>& values) {
    AmplitudeCurve curve;
    double start_s = 0.0;
    for (std::size_t k = 0; k < ends_s.size(); ++k) {
        if (!(ends_s[k] > start_s)) continue;
        const bool same = !curve.empty() && curve.back().value == values[k];
        if (same) {
            curve.back().time_s = ends_s[k];
        } else {
            curve.push_back({start_s, values[k]});
            curve.push_back({ends_s[k], values[k]});
        }
        start_s = ends_s[k];
    }
    return curve;
}

Expected<Effects> effect_of_steps(const EffectFile& file, const std::vector<double>& lengths_ms,
                                  const std::vector<double>& shares, double hz,
                                  std::vector<std::string> remarks) {
    double total_ms = 0.0;
    std::vector<double> ends_s;
    for (const double length_ms : lengths_ms) ends_s.push_back((total_ms += length_ms) / 1e3);
    Sketch sketch;
    sketch.unit_g = continuous_g(file.map, 1.0);
    sketch.duration_s = ends_s.back();
    const AmplitudeCurve steps = stairs(ends_s, shares);
    sketch.voices.push_back({0.0, sketch.duration_s, acceleration_curve(file.map, steps),
                             FrequencyCurve{{0.0, hz}}, 0.0});
    auto effect = finished(file, file.stem, sketch, std::move(remarks));
    if (!effect) return effect.error();
    return Effects{*std::move(effect)};
}

}  // namespace tact
