// Apple's haptic and audio patterns (AHAP).
//
// Source    Apple's "Representing haptic patterns in AHAP files": a continuous event lasts 30 s at
//           most; intensity controls multiply, sharpness controls add, on transients, too. Times of
//           control points count from their curve's. At most 16 points a curve, as the tests of
//           both known writers have it: the next curve begins with the last one's last point.
//           A pair: what is continuous in one file, transients in the other (ahap_pair.h).
// Output    where nothing continuous sounds, events pause and the control is 1, so that transients
//           pass; elsewhere transients are divided by the control, and lose what that leaves short

#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/written_text.h"
#include "model/io/formats/ahap/ahap.h"
#include "model/pattern/curves.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr double kLongestContinuousS = 30.0;
constexpr std::size_t kMostCurvePoints = 16;

struct Stretch {
    double start_s = 0.0;
    double end_s = 0.0;
};

// Stretches of a curve that stay at 0 from one point to another.
std::vector<Stretch> silent_stretches(const AmplitudeCurve& curve) {
    std::vector<Stretch> all;
    for (std::size_t k = 0; k + 1 < curve.size(); ++k) {
        const bool silent = curve[k].value == 0.0 && curve[k + 1].value == 0.0;
        if (!silent || !(curve[k].time_s < curve[k + 1].time_s)) continue;
        if (!all.empty() && all.back().end_s == curve[k].time_s) {
            all.back().end_s = curve[k + 1].time_s;
        } else {
            all.push_back({curve[k].time_s, curve[k + 1].time_s});
        }
    }
    return all;
}

std::vector<Stretch> with_taps(std::vector<Stretch> all, const std::vector<TapShares>& taps) {
    std::erase_if(all, [&](const Stretch& one) {
        const auto tap = std::ranges::lower_bound(taps, one.start_s, {}, &TapShares::time_s);
        return tap == taps.end() || tap->time_s >= one.end_s;
    });
    return all;
}

// The curve, 1 in each of the stretches.
AmplitudeCurve lifted(const AmplitudeCurve& curve, const std::vector<Stretch>& stretches) {
    AmplitudeCurve result;
    std::size_t next = 0;
    for (const Stretch& one : stretches) {
        while (next < curve.size() && curve[next].time_s < one.start_s) {
            result.push_back(curve[next++]);
        }
        if (one.start_s > 0.0) {
            result.push_back({one.start_s, sides_at(curve, one.start_s).before});
        }
        result.push_back({one.start_s, 1.0});
        result.push_back({one.end_s, 1.0});
        while (next < curve.size() && curve[next].time_s <= one.end_s) ++next;
        if (next < curve.size()) result.push_back({one.end_s, sides_at(curve, one.end_s).behind});
    }
    result.insert(result.end(), curve.begin() + static_cast<std::ptrdiff_t>(next), curve.end());
    return result;
}

Json parameter(const char* id, double value) {
    return {{"ParameterID", id}, {"ParameterValue", value}};
}

Json event_json(const char* type, double time_s, double intensity, double sharpness) {
    return {{"Time", time_s},
            {"EventType", type},
            {"EventParameters", Json::array({parameter("HapticIntensity", intensity),
                                             parameter("HapticSharpness", sharpness)})}};
}

void add_continuous(Json& entries, Stretch part, double intensity, double sharpness) {
    while (part.start_s < part.end_s) {
        const double end_s = std::min(part.end_s, part.start_s + kLongestContinuousS);
        Json event = event_json("HapticContinuous", part.start_s, intensity, sharpness);
        event["EventDuration"] = end_s - part.start_s;
        entries.push_back({{"Event", event}});
        part.start_s = end_s;
    }
}

void add_control(Json& entries, const char* id, const AmplitudeCurve& curve) {
    for (std::size_t first = 0; first + 1 < curve.size(); first += kMostCurvePoints - 1) {
        const std::size_t last = std::min(first + kMostCurvePoints, curve.size());
        const double from_s = curve[first].time_s;
        Json points = Json::array();
        for (std::size_t k = first; k < last; ++k) {
            points.push_back(
                {{"Time", curve[k].time_s - from_s}, {"ParameterValue", curve[k].value}});
        }
        entries.push_back(
            {{"ParameterCurve",
              {{"ParameterID", id}, {"Time", from_s}, {"ParameterCurveControlPoints", points}}}});
    }
}

bool is_constant(const AmplitudeCurve& curve) {
    return std::ranges::all_of(
        curve, [&](const AmplitudePoint& point) { return point.value == curve.front().value; });
}

// The lowest base of sharpness with which as many transients as can be get their own.
double base_sharpness(const Shares& shares) {
    if (is_constant(shares.frequency)) return shares.frequency.front().value;
    double base = 0.0;
    for (const TapShares& tap : shares.taps) {
        base = std::max(base, sides_at(shares.frequency, tap.time_s).behind - tap.frequency);
    }
    return std::min(base, 1.0);
}

// What the controls leave of the transients.
struct TapLosses {
    Changes intensity;
    Changes sharpness;
};

void add_taps(Json& entries, const Shares& shares, const AmplitudeCurve& control, double base,
              TapLosses& losses) {
    for (const TapShares& tap : shares.taps) {
        const double intensity = sides_at(control, tap.time_s).behind;
        const double sharpness = sides_at(shares.frequency, tap.time_s).behind - base;
        const double own =
            intensity > 0.0 ? std::min(tap.amplitude / intensity, 1.0) : tap.amplitude;
        const double sharp = std::clamp(tap.frequency - sharpness, 0.0, 1.0);
        losses.intensity.note(tap.amplitude, own * intensity, 1e-6);
        losses.sharpness.note(tap.frequency, sharp + sharpness, 1e-6);
        entries.push_back({{"Event", event_json("HapticTransient", tap.time_s, own, sharp)}});
    }
}

// The stretches between those.
std::vector<Stretch> sounding(const std::vector<Stretch>& pauses, double duration_s) {
    std::vector<Stretch> all;
    double from_s = 0.0;
    for (const Stretch& pause : pauses) {
        if (pause.start_s > from_s) all.push_back({from_s, pause.start_s});
        from_s = pause.end_s;
    }
    if (from_s < duration_s) all.push_back({from_s, duration_s});
    return all;
}

void add_parts(Json& entries, const Shares& shares, TapLosses& losses) {
    const bool continuous = peak_value(shares.amplitude) > 0.0 || shares.taps.empty();
    AmplitudeCurve control{{0.0, 1.0}};
    Shares sharp = shares;
    double base = 0.0;
    if (continuous) {
        const bool flat = is_constant(shares.amplitude) && shares.amplitude.front().value > 0.0;
        const auto pauses = with_taps(silent_stretches(shares.amplitude), shares.taps);
        base = base_sharpness(shares);
        const double level = flat ? shares.amplitude.front().value : 1.0;
        for (const Stretch& part : sounding(pauses, shares.duration_s)) {
            add_continuous(entries, part, level, base);
        }
        if (!flat) {
            control = lifted(shares.amplitude, pauses);
            add_control(entries, "HapticIntensityControl", control);
        }
        if (!is_constant(shares.frequency)) {
            AmplitudeCurve offsets = shares.frequency;
            for (AmplitudePoint& point : offsets) point.value -= base;
            if (offsets.front().time_s > 0.0) {
                offsets.insert(offsets.begin(), {0.0, offsets.front().value});
            }
            add_control(entries, "HapticSharpnessControl", offsets);
        }
    } else {
        sharp.frequency = {{0.0, 0.0}};
    }
    add_taps(entries, sharp, control, base, losses);
}

// One file, with what its controls leave of the transients.
std::string ahap_text(const Shares& shares, const EffectTarget& target,
                      std::vector<std::string>& remarks) {
    Json entries = Json::array();
    TapLosses losses;
    add_parts(entries, shares, losses);
    losses.intensity.remark("weaker beneath the intensity control", "", remarks);
    losses.sharpness.remark("moved by the sharpness control", "", remarks);
    return printed({{"Version", 1.0},
                    {"Metadata", {{"Project", valid_utf8(target.name)}, {"Created", target.date}}},
                    {"Pattern", entries}});
}

}  // namespace

WrittenEffect write_ahap(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    const Shares shares = as_shares(as_curves(pattern, written), target.map, written);
    written.text = ahap_text(shares, target, written.remarks);
    return written;
}

WrittenEffect write_ahap_pair(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    // Scaled together, so that both files have their strengths beside each other.
    const Shares shares = as_shares(as_curves(pattern, written), target.map, written);
    Shares continuous = shares;
    continuous.taps.clear();
    Shares transients = shares;
    transients.amplitude = {{0.0, 0.0}, {shares.duration_s, 0.0}};
    written.text = ahap_text(continuous, target, written.remarks);
    written.beside = ahap_text(transients, target, written.remarks);
    return written;
}

}  // namespace tact
