#include "model/io/effects_out/shares.h"

#include <algorithm>
#include <cmath>

#include "model/common/portable.h"
#include "model/design_space/spectral_lines.h"
#include "model/io/effects/effect.h"
#include "model/pattern/curves.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

AmplitudeCurve band_shares(const ActuatorMap& map, const FrequencyCurve& curve) {
    constexpr double kToleranceHz = 0.1;
    const double width_hz = map.frequency_hz.high - map.frequency_hz.low;
    if (!(width_hz > 0.0)) return {{0.0, 0.5}};
    return mapped(
        heights_of(curve), [&](double value) { return frequency_01(map, value); },
        kToleranceHz / width_hz);
}

// A transient as the map plays it at full intensity.
struct FullBurst {
    double frequency_01 = 0.5;
    double frequency_hz = 0.0;
    double duration_s = 0.0;
    double energy_g2_s = 0.0;
    TransientShape shape = TransientShape::sine;
};

FullBurst full_burst(const ActuatorMap& map, double hz) {
    const double low = map.burst_at_0.frequency_hz;
    const double high = map.burst_at_1.frequency_hz;
    FullBurst burst;
    if (low != high) burst.frequency_01 = std::clamp((hz - low) / (high - low), 0.0, 1.0);
    for (const Transient& piece : transients_on(map, 0.0, 1.0, burst.frequency_01)) {
        burst.frequency_hz = piece.frequency_hz;
        burst.shape = piece.shape;
        burst.duration_s = piece.time_s + piece.duration_s;
        burst.energy_g2_s += energy_g2_s(piece);
    }
    return burst;
}

struct TapChanges {
    Changes frequency;
    Changes length;
    std::size_t shapes = 0;
};

void note_changes(TapChanges& changes, const Transient& asked, const FullBurst& got) {
    changes.frequency.note(asked.frequency_hz, got.frequency_hz, 0.05);
    changes.length.note(1e3 * asked.duration_s, 1e3 * got.duration_s, 1e-3);
    if (asked.shape != got.shape) ++changes.shapes;
}

void remark_changes(const TapChanges& changes, WrittenEffect& written) {
    changes.frequency.remark("another frequency", " Hz", written.coarse);
    changes.length.remark("another length", " ms", written.coarse);
    if (changes.shapes > 0) {
        written.remarks.push_back(transients_text(changes.shapes) + ": sine and square exchanged");
    }
}

}  // namespace

void remark_left_out_hz(const FrequencyCurve& curve, std::vector<std::string>& remarks) {
    const auto [low, high] = std::ranges::minmax(curve, {}, &FrequencyPoint::frequency_hz);
    std::string hz = significant_digits(low.frequency_hz, 4);
    if (high.frequency_hz != low.frequency_hz) {
        hz += " to " + significant_digits(high.frequency_hz, 4);
    }
    remarks.push_back(hz + " Hz left out: the device has its own frequency");
}

std::string transients_text(std::size_t count) {
    return grouped_digits(count) + (count == 1 ? " transient" : " transients");
}

void Changes::note(double asked, double got, double tolerance) {
    if (std::abs(asked - got) <= tolerance) return;
    if (count++ > 0) return;
    from = asked;
    to = got;
}

void Changes::remark(const std::string& what, const std::string& unit,
                     std::vector<std::string>& remarks) const {
    if (count == 0) return;
    remarks.push_back(transients_text(count) + ": " + what + ", the first " +
                      significant_digits(to, 4) + unit + " in place of " +
                      significant_digits(from, 4));
}

double intensity_01(const ActuatorMap& map, double share_of_full_scale) {
    const double share = std::clamp(share_of_full_scale, 0.0, 1.0);
    return map.intensity_law == IntensityLaw::linear ? share : std::sqrt(share);
}

double frequency_01(const ActuatorMap& map, double hz) {
    const auto [low, high] = map.frequency_hz;
    if (!(low < high)) return 0.5;
    const double within = std::clamp(hz, low, high);
    if (map.frequency_law == FrequencyLaw::linear) return (within - low) / (high - low);
    const double share = portable::log(within / low) / portable::log(high / low);
    return std::clamp(share, 0.0, 1.0);
}

double scale_to_full(double loudest, std::vector<std::string>& remarks) {
    constexpr double kRoundingShare = 1e-9;
    if (!(loudest > 1.0 + kRoundingShare)) return 1.0;
    remarks.push_back("louder than full scale: scaled by " + significant_digits(1.0 / loudest, 3));
    return 1.0 / loudest;
}

FrequencyCurve in_band(FrequencyCurve curve, Range band_hz, std::vector<std::string>& remarks) {
    constexpr double kRoundingHz = 1e-6;
    const auto [low, high] = std::ranges::minmax(curve, {}, &FrequencyPoint::frequency_hz);
    const double low_hz = low.frequency_hz;
    const double high_hz = high.frequency_hz;
    if (low_hz >= band_hz.low - kRoundingHz && high_hz <= band_hz.high + kRoundingHz) return curve;
    const auto inside = [&](double hz) { return std::clamp(hz, band_hz.low, band_hz.high); };
    remarks.push_back(
        low_hz == high_hz
            ? significant_digits(low_hz, 4) + " Hz is out of the band, written as " +
                  significant_digits(inside(low_hz), 4) + " Hz"
            : significant_digits(low_hz, 4) + " to " + significant_digits(high_hz, 4) +
                  " Hz is out of the band, moved into " + significant_digits(band_hz.low, 4) +
                  " to " + significant_digits(band_hz.high, 4) + " Hz");
    const AmplitudeCurve hz = heights_of(curve);
    curve.clear();
    for (const AmplitudePoint& point : mapped(hz, inside, 0.1)) {
        curve.push_back({point.time_s, point.value});
    }
    return curve;
}

double energy_g2_s(const Transient& transient) {
    const double of_shape = transient.shape == TransientShape::sine ? 0.5 : 1.0;
    return of_shape * transient.amplitude_g * transient.amplitude_g * transient.duration_s;
}

Shares as_shares(const PlainCurves& curves, const ActuatorMap& map, WrittenEffect& written) {
    std::vector<std::string>& remarks = written.remarks;
    const double full_g = map.full_scale_g * map.continuous_gain;
    double loudest = full_g > 0.0 ? peak_value(curves.amplitude) / full_g : 0.0;
    if (!(full_g > 0.0) && peak_value(curves.amplitude) > 0.0) {
        remarks.push_back("the actuator plays nothing continuous: silent");
    }
    Shares shares;
    shares.duration_s = curves.duration_s;
    TapChanges changes;
    std::vector<double> tap_shares;
    for (const Transient& one : curves.transients) {
        const FullBurst burst = full_burst(map, one.frequency_hz);
        note_changes(changes, one, burst);
        const double energy = burst.energy_g2_s;
        tap_shares.push_back(energy > 0.0 ? std::sqrt(energy_g2_s(one) / energy) : 0.0);
        loudest = std::max(loudest, tap_shares.back());
        shares.taps.push_back({one.time_s, 0.0, burst.frequency_01});
    }
    const double scale = scale_to_full(loudest, remarks);
    for (std::size_t k = 0; k < tap_shares.size(); ++k) {
        shares.taps[k].amplitude = intensity_01(map, scale * tap_shares[k]);
    }
    const auto to_share = [&](double g) {
        return full_g > 0.0 ? intensity_01(map, scale * g / full_g) : 0.0;
    };
    shares.amplitude = mapped(curves.amplitude, to_share, 1e-3);
    shares.frequency = band_shares(map, in_band(curves.frequency, map.frequency_hz, remarks));
    remark_changes(changes, written);
    return shares;
}

void keep_strongest(std::vector<TapShares>& taps, std::size_t most,
                    std::vector<std::string>& remarks) {
    if (taps.size() <= most) return;
    remarks.push_back("of " + grouped_digits(taps.size()) + " transients the strongest " +
                      grouped_digits(most) + " are kept");
    std::ranges::stable_sort(taps, std::ranges::greater{}, &TapShares::amplitude);
    taps.resize(most);
    std::ranges::stable_sort(taps, {}, &TapShares::time_s);
}

void thin_shares(Shares& shares, std::size_t most, const ActuatorMap& map,
                 std::vector<std::string>& coarse) {
    const std::size_t points[] = {shares.amplitude.size(), shares.frequency.size()};
    for (AmplitudeCurve* curve : {&shares.amplitude, &shares.frequency}) {
        if (curve->size() > kMostWeighed) thin(*curve, std::max(most, kMostWeighed), 0.0);
    }
    const Shares all = shares;
    const auto tone = [&](double intensity, double share) {
        return FeltTone{continuous_g(map, intensity), frequency_hz(map, share)};
    };
    const auto thin_one = [&](AmplitudeCurve& curve, std::size_t before, const std::string& what,
                              const ThinningWeight& weight) {
        if (curve.size() <= most) return;
        thin_by(curve, most, 0.0, weight);
        coarse.push_back(grouped_digits(before) + " points of " + what + " thinned to " +
                         grouped_digits(curve.size()));
    };
    thin_one(shares.amplitude, points[0], "amplitude", [&](std::size_t k, double line) {
        const double share = sides_at(all.frequency, all.amplitude[k].time_s).behind;
        return felt_error_db(tone(all.amplitude[k].value, share), tone(line, share));
    });
    thin_one(shares.frequency, points[1], "frequency", [&](std::size_t k, double line) {
        const Sides sides = sides_at(all.amplitude, all.frequency[k].time_s);
        const double intensity = std::max(sides.before, sides.behind);
        return felt_error_db(tone(intensity, all.frequency[k].value), tone(intensity, line));
    });
}

namespace {

constexpr double kRoundingDb = 1e-6;

}  // namespace

double felt_level_db(const FeltTone& tone) {
    if (!(tone.amplitude_g > 0.0)) return 0.0;
    const auto above_db =
        detectability_db({{tone.frequency_hz, tone.amplitude_g}}, default_tables());
    return std::max(above_db.value_or(0.0), 0.0);
}

double felt_error_db(const FeltTone& asked, const FeltTone& got) {
    const double asked_db = felt_level_db(asked);
    const double got_db = felt_level_db(got);
    double error_db = std::abs(asked_db - got_db);
    if (asked_db > 0.0 && got_db > 0.0) {
        const double ratio = got.frequency_hz / asked.frequency_hz;
        error_db = std::max(error_db, std::abs(20.0 * portable::log10(ratio)));
    }
    return error_db < kRoundingDb ? 0.0 : error_db;
}

}  // namespace tact
