// MPEG's haptic interchange format (HJIF, ISO/IEC 23090-31), Main profile.
//
// Source    the standard's reference software and files that it wrote: all of its top-level keys,
//           avatar 0 for none, positions in whole ticks, Hz whole. A vectorial wave a carrier, each
//           with the envelope of its pattern as keyframes and its own phase; the transients in a
//           band.
// Output    amplitudes beside the loudest, which the channel's gain has; level 2 from 8 bands on

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/written_text.h"
#include "model/io/formats/hjif/hjif.h"
#include "model/pattern/curves.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// Whole for the samples of the model, 10 kHz, and for the beats of music.
constexpr double kTicksPerS = 40'000.0;
constexpr std::size_t kMostBandsOfLevel1 = 7;

std::int64_t ticks(double t_s) { return std::llround(t_s * kTicksPerS); }

std::int64_t whole_hz(double hz) { return std::max<std::int64_t>(std::llround(hz), 1); }

// Keyframes of amplitude and of frequency, apart from each other, in the order of their positions.
Json keyframes_json(const AmplitudeCurve& amplitude, const FrequencyCurve& frequency) {
    std::vector<std::pair<std::int64_t, Json>> frames;
    for (const AmplitudePoint& point : amplitude) {
        const std::int64_t at = ticks(point.time_s);
        frames.push_back({at, {{"relative_position", at}, {"amplitude_modulation", point.value}}});
    }
    for (const FrequencyPoint& point : frequency) {
        const std::int64_t at = ticks(point.time_s);
        frames.push_back(
            {at,
             {{"relative_position", at}, {"frequency_modulation", whole_hz(point.frequency_hz)}}});
    }
    std::ranges::stable_sort(frames, {}, [](const auto& frame) { return frame.first; });
    Json result = Json::array();
    for (auto& frame : frames) result.push_back(std::move(frame.second));
    return result;
}

Json band_json(const char* type, double low_hz, double high_hz, Json effects) {
    const double low = std::max(std::floor(low_hz), 0.0);
    return {
        {"band_type", type},
        {"lower_frequency_limit", static_cast<std::int64_t>(low)},
        {"upper_frequency_limit", static_cast<std::int64_t>(std::max(std::ceil(high_hz), low + 1))},
        {"effects", std::move(effects)}};
}

Json wave_band(const AmplitudeCurve& amplitude, const FrequencyCurve& frequency, double phase_rad) {
    const auto [low, high] = std::ranges::minmax(frequency, {}, &FrequencyPoint::frequency_hz);
    Json effect{{"effect_type", "Basis"},
                {"position", 0},
                {"phase", phase_rad},
                {"base_signal", "Sine"},
                {"keyframes", keyframes_json(amplitude, frequency)}};
    return band_json("VectorialWave", low.frequency_hz, high.frequency_hz,
                     Json::array({std::move(effect)}));
}

// What the reader makes of an amplitude of 1.
Transient unit_burst(const Transient& one, const ActuatorMap& map) {
    return held_burst(one.time_s, 1.0, std::max(std::round(one.frequency_hz), 1.0),
                      burst_duration_s(map, 0.5));
}

double burst_g(const Transient& one, const ActuatorMap& map) {
    const double energy = energy_g2_s(unit_burst(one, map));
    return energy > 0.0 ? std::sqrt(energy_g2_s(one) / energy) : 0.0;
}

Json transient_band(const std::vector<Transient>& all, const ActuatorMap& map, double unit_g) {
    Json effects = Json::array();
    for (const Transient& one : all) {
        const Json frame{{"relative_position", 0},
                         {"amplitude_modulation", burst_g(one, map) / unit_g},
                         {"frequency_modulation", whole_hz(one.frequency_hz)}};
        effects.push_back({{"effect_type", "Basis"},
                           {"position", ticks(one.time_s)},
                           {"phase", 0.0},
                           {"base_signal", "Sine"},
                           {"keyframes", Json::array({frame})}});
    }
    const auto [low, high] = std::ranges::minmax(all, {}, &Transient::frequency_hz);
    return band_json("Transient", low.frequency_hz, high.frequency_hz, std::move(effects));
}

void remark_transients(const std::vector<Transient>& all, const ActuatorMap& map,
                       WrittenEffect& written) {
    Changes length;
    std::size_t square = 0;
    for (const Transient& one : all) {
        length.note(1e3 * one.duration_s, 1e3 * burst_duration_s(map, 0.5), 1e-3);
        if (one.shape == TransientShape::square) ++square;
    }
    length.remark("another length", " ms", written.coarse);
    if (square == 0) return;
    written.remarks.push_back(transients_text(square) + ": a sine in place of a square wave");
}

// The carriers that sound, in the pattern's order; one of no strength where none does.
std::vector<Carrier> sounding_carriers(const Pattern& pattern) {
    std::vector<Carrier> all;
    for (const Carrier& carrier : pattern.carriers) {
        if (carrier.weight != 0.0) all.push_back(carrier);
    }
    if (all.empty()) all.push_back({150.0, 0.0, 0.0});
    return all;
}

FrequencyCurve curve_of_carrier(const Pattern& pattern, const Carrier& carrier) {
    if (pattern.frequency_curve.empty()) return {{0.0, carrier.frequency_hz}};
    FrequencyCurve curve = pattern.frequency_curve;
    const double ratio = carrier.frequency_hz / pattern.carriers.front().frequency_hz;
    for (FrequencyPoint& point : curve) point.frequency_hz *= ratio;
    return curve;
}

// The envelope that all carriers share, in g for a weight of 1.
PlainCurves shared_envelope(const Pattern& pattern, WrittenEffect& written) {
    Pattern alone = pattern;
    alone.carriers = {{150.0, 1.0, 0.0}};
    alone.frequency_curve.clear();
    return as_curves(alone, written);
}

Json document_of_bands(Json bands, double gain, const EffectTarget& target) {
    const int level = bands.size() > kMostBandsOfLevel1 ? 2 : 1;
    const Json channel{{"id", 0},
                       {"description", valid_utf8(target.name)},
                       {"gain", gain},
                       {"mixing_coefficient", 1.0},
                       {"body_part_mask", 0},
                       {"bands", std::move(bands)}};
    const Json perception{{"id", 0},
                          {"avatar_id", 0},
                          {"description", valid_utf8(target.name)},
                          {"perception_modality", "Vibrotactile"},
                          {"reference_devices", Json::array()},
                          {"effect_library", Json::array()},
                          {"channels", Json::array({channel})}};
    return {{"version", "2023"},
            {"profile", "Main"},
            {"level", level},
            {"date", target.date},
            {"description", "written by tactspace"},
            {"timescale", static_cast<std::int64_t>(kTicksPerS)},
            {"perceptions", Json::array({perception})},
            {"avatars", Json::array()},
            {"syncs", Json::array()}};
}

// A carrier that its ratio to the first one takes above what readers have is silent there.
AmplitudeCurve silent_above(const AmplitudeCurve& amplitude, const FrequencyCurve& frequency) {
    const double most_hz = limits::kCarrierHz.high;
    std::vector<double> crossings_s;
    for (std::size_t k = 1; k < frequency.size(); ++k) {
        const FrequencyPoint& a = frequency[k - 1];
        const FrequencyPoint& b = frequency[k];
        if ((a.frequency_hz > most_hz) == (b.frequency_hz > most_hz)) continue;
        const double share = (most_hz - a.frequency_hz) / (b.frequency_hz - a.frequency_hz);
        crossings_s.push_back(a.time_s + share * (b.time_s - a.time_s));
    }
    std::vector<double> times_s = crossings_s;
    for (const AmplitudePoint& point : amplitude) times_s.push_back(point.time_s);
    std::ranges::sort(times_s);
    times_s.erase(std::unique(times_s.begin(), times_s.end()), times_s.end());
    AmplitudeCurve result;
    const double last_s = times_s.back();
    for (std::size_t k = 0; k + 1 < times_s.size(); ++k) {
        const double from_s = times_s[k];
        const double to_s = times_s[k + 1];
        const double middle_hz = sides_at(frequency, 0.5 * (from_s + to_s)).behind;
        const double gain = middle_hz > most_hz ? 0.0 : 1.0;
        result.push_back({from_s, gain * sides_at(amplitude, from_s).behind});
        result.push_back({to_s, gain * sides_at(amplitude, to_s).before});
    }
    if (result.empty()) result.push_back({last_s, 0.0});
    // A value that does not change needs one point.
    const auto same = std::unique(result.begin(), result.end());
    result.erase(same, result.end());
    return result;
}

// One for each carrier that can be written; of one that cannot, what is left.
struct CarrierWave {
    AmplitudeCurve amplitude;
    FrequencyCurve frequency;
    double phase_rad = 0.0;
};

std::optional<CarrierWave> wave_of(const Pattern& pattern, const Carrier& carrier,
                                   const AmplitudeCurve& envelope,
                                   std::vector<std::string>& remarks) {
    CarrierWave wave{envelope, curve_of_carrier(pattern, carrier),
                     carrier.phase_rad + (carrier.weight < 0.0 ? std::numbers::pi : 0.0)};
    const double most_hz = limits::kCarrierHz.high;
    const auto [low, high] = std::ranges::minmax(wave.frequency, {}, &FrequencyPoint::frequency_hz);
    const double low_hz = low.frequency_hz;
    const double high_hz = high.frequency_hz;
    if (!(high_hz > most_hz * (1.0 + 1e-9))) return wave;
    const std::string hz = significant_digits(high_hz, 4);
    if (low_hz > most_hz) {
        remarks.push_back("a carrier of " + hz + " Hz is left out: readers take 1,000 Hz at most");
        return std::nullopt;
    }
    remarks.push_back("a carrier that rises to " + hz +
                      " Hz is silent above 1,000 Hz: readers take no more");
    wave.amplitude = silent_above(wave.amplitude, wave.frequency);
    wave.frequency.clear();
    const AmplitudeCurve all_hz = heights_of(curve_of_carrier(pattern, carrier));
    const auto within = [&](double value) { return std::min(value, most_hz); };
    for (const AmplitudePoint& point : mapped(all_hz, within, 0.5)) {
        wave.frequency.push_back({point.time_s, point.value});
    }
    return wave;
}

// Its carriers as waves, each with the envelope that all share; what they reach together, in g.
double add_waves(std::vector<CarrierWave>& waves, const Pattern& pattern,
                 const AmplitudeCurve& envelope, std::vector<std::string>& remarks) {
    double together = 0.0;
    for (const Carrier& carrier : sounding_carriers(pattern)) {
        AmplitudeCurve own = envelope;
        for (AmplitudePoint& point : own) point.value *= std::abs(carrier.weight);
        auto wave = wave_of(pattern, carrier, own, remarks);
        if (!wave) continue;
        together += std::abs(carrier.weight);
        waves.push_back(*std::move(wave));
    }
    return peak_value(envelope) * together;
}

}  // namespace

WrittenEffect write_hjif_bands(std::span<const Pattern> patterns, const EffectTarget& target) {
    assert(!patterns.empty());
    WrittenEffect written;
    std::vector<CarrierWave> waves;
    std::vector<Transient> transients;
    double peak_g = 0.0;
    for (const Pattern& own : patterns) {
        const Pattern pattern = with_drawn_pitches(own);
        const PlainCurves envelope = shared_envelope(pattern, written);
        peak_g += add_waves(waves, pattern, envelope.amplitude, written.remarks);
        transients.insert(transients.end(), envelope.transients.begin(), envelope.transients.end());
    }
    std::ranges::stable_sort(transients, {}, &Transient::time_s);
    for (const Transient& one : transients) peak_g = std::max(peak_g, burst_g(one, target.map));
    const double full_g = target.map.full_scale_g;
    const double unit_g = peak_g > 0.0 ? peak_g : full_g;
    const double scale = scale_to_full(unit_g / full_g, written.remarks);
    Json bands = Json::array();
    if (waves.empty()) {
        const double end_s = std::ranges::max(patterns, {}, &Pattern::duration_s).duration_s;
        waves.push_back({{{0.0, 0.0}, {end_s, 0.0}}, {{0.0, 150.0}}, 0.0});
    }
    for (CarrierWave& wave : waves) {
        for (AmplitudePoint& point : wave.amplitude) point.value /= unit_g;
        bands.push_back(wave_band(wave.amplitude, wave.frequency, wave.phase_rad));
    }
    if (!transients.empty()) {
        bands.push_back(transient_band(transients, target.map, unit_g));
        remark_transients(transients, target.map, written);
    }
    written.coarse.emplace_back("frequencies are whole Hz, times whole ticks of 25 us");
    written.text = printed(document_of_bands(std::move(bands), scale * unit_g / full_g, target));
    return written;
}

WrittenEffect write_hjif(const Pattern& pattern, const EffectTarget& target) {
    return write_hjif_bands({&pattern, 1}, target);
}

}  // namespace tact
