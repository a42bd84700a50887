// MPEG's haptic interchange format (HJIF, ISO/IEC 23090-31), Main profile.
//
// Source    the standard's reference software and files that it wrote: all of its top-level keys,
//           avatar 0 for none, positions in whole ticks, Hz whole. A vectorial wave a carrier, each
//           with the envelope of all as keyframes and its own phase; the transients in a band.
// Output    amplitudes beside the loudest, which the channel's gain has; level 2 from 8 bands on

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "model/io/effects/effect.h"
#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/writers.h"
#include "model/pattern/drawn_curve.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// Whole for the samples of the model, 10 kHz, and for the beats of music.
constexpr double kTicksPerS = 40'000.0;
constexpr std::size_t kMostBandsOfLevel1 = 7;

long long ticks(double t_s) { return std::llround(t_s * kTicksPerS); }

struct HjifLosses {
    double tick_s = 0.0;
    double hz = 0.0;
};

long long whole_hz(double hz, HjifLosses& losses) {
    losses.hz = std::max(losses.hz, std::abs(hz - std::round(hz)));
    return std::max(std::llround(hz), 1LL);
}

long long whole_tick(double t_s, HjifLosses& losses) {
    losses.tick_s =
        std::max(losses.tick_s, std::abs(t_s - static_cast<double>(ticks(t_s)) / kTicksPerS));
    return ticks(t_s);
}

// Of amplitude and frequency apart from each other, in the order of their positions.
Json keyframes_json(const AmplitudeCurve& amplitude, const FrequencyCurve& frequency,
                    HjifLosses& losses) {
    std::vector<std::pair<long long, Json>> frames;
    for (const AmplitudePoint& point : amplitude) {
        const long long at = whole_tick(point.time_s, losses);
        frames.push_back({at, {{"relative_position", at}, {"amplitude_modulation", point.value}}});
    }
    for (const FrequencyPoint& point : frequency) {
        const long long at = whole_tick(point.time_s, losses);
        frames.push_back({at,
                          {{"relative_position", at},
                           {"frequency_modulation", whole_hz(point.frequency_hz, losses)}}});
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
        {"lower_frequency_limit", static_cast<long long>(low)},
        {"upper_frequency_limit", static_cast<long long>(std::max(std::ceil(high_hz), low + 1))},
        {"effects", std::move(effects)}};
}

Json wave_band(const AmplitudeCurve& amplitude, const FrequencyCurve& frequency, double phase_rad,
               HjifLosses& losses) {
    const auto [low, high] = std::ranges::minmax(frequency, {}, &FrequencyPoint::frequency_hz);
    Json effect{{"effect_type", "Basis"},
                {"position", 0},
                {"phase", phase_rad},
                {"base_signal", "Sine"},
                {"keyframes", keyframes_json(amplitude, frequency, losses)}};
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

Json transient_band(const std::vector<Transient>& all, const ActuatorMap& map, double unit_g,
                    HjifLosses& losses) {
    Json effects = Json::array();
    for (const Transient& one : all) {
        const Json frame{{"relative_position", 0},
                         {"amplitude_modulation", burst_g(one, map) / unit_g},
                         {"frequency_modulation", whole_hz(one.frequency_hz, losses)}};
        effects.push_back({{"effect_type", "Basis"},
                           {"position", whole_tick(one.time_s, losses)},
                           {"phase", 0.0},
                           {"base_signal", "Sine"},
                           {"keyframes", Json::array({frame})}});
    }
    const auto [low, high] = std::ranges::minmax(all, {}, &Transient::frequency_hz);
    return band_json("Transient", low.frequency_hz, high.frequency_hz, std::move(effects));
}

void remark_transients(const std::vector<Transient>& all, const ActuatorMap& map,
                       std::vector<std::string>& remarks) {
    Changes length;
    std::size_t square = 0;
    for (const Transient& one : all) {
        length.note(1e3 * one.duration_s, 1e3 * burst_duration_s(map, 0.5), 1e-3);
        if (one.shape == TransientShape::square) ++square;
    }
    length.remark("another length", " ms", remarks);
    if (square > 0)
        remarks.push_back(transients_text(square) + ": a sine in place of a square wave");
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
PlainCurves shared_envelope(const Pattern& pattern, std::vector<std::string>& remarks) {
    Pattern alone = pattern;
    alone.carriers = {{150.0, 1.0, 0.0}};
    alone.frequency_curve.clear();
    return as_curves(alone, remarks);
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
            {"timescale", static_cast<long long>(kTicksPerS)},
            {"perceptions", Json::array({perception})},
            {"avatars", Json::array()},
            {"syncs", Json::array()}};
}

void remark_whole_numbers(const HjifLosses& losses, std::vector<std::string>& remarks) {
    if (losses.hz > 1e-9) {
        remarks.push_back("frequencies are whole Hz: at most " + significant_digits(losses.hz, 2) +
                          " Hz off");
    }
    if (losses.tick_s > 1e-9) {
        remarks.push_back("times are whole ticks of 25 us: at most " +
                          significant_digits(1e6 * losses.tick_s, 2) + " us off");
    }
}

}  // namespace

WrittenEffect write_hjif(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    const PlainCurves envelope = shared_envelope(pattern, written.remarks);
    const std::vector<Carrier> carriers = sounding_carriers(pattern);
    double together = 0.0;
    for (const Carrier& carrier : carriers) together += std::abs(carrier.weight);
    const double full_g = target.map.full_scale_g;
    double peak_g = peak_value(envelope.amplitude) * together;
    for (const Transient& one : envelope.transients) {
        peak_g = std::max(peak_g, burst_g(one, target.map));
    }
    const double unit_g = peak_g > 0.0 ? peak_g : full_g;
    const double scale = scale_to_full(unit_g / full_g, written.remarks);
    HjifLosses losses;
    Json bands = Json::array();
    for (const Carrier& carrier : carriers) {
        AmplitudeCurve amplitude = envelope.amplitude;
        for (AmplitudePoint& point : amplitude) {
            point.value *= std::abs(carrier.weight) / unit_g;
        }
        const double phase_rad =
            carrier.phase_rad + (carrier.weight < 0.0 ? std::numbers::pi : 0.0);
        bands.push_back(
            wave_band(amplitude, curve_of_carrier(pattern, carrier), phase_rad, losses));
    }
    if (!envelope.transients.empty()) {
        bands.push_back(transient_band(envelope.transients, target.map, unit_g, losses));
        remark_transients(envelope.transients, target.map, written.remarks);
        const double length_s = burst_duration_s(target.map, 0.5);
        const double end_s = envelope.transients.back().time_s + length_s;
        remark_end(std::max(end_s, pattern.duration_s), pattern.duration_s, written.remarks);
    }
    remark_whole_numbers(losses, written.remarks);
    written.text = printed(document_of_bands(std::move(bands), scale * unit_g / full_g, target));
    return written;
}

}  // namespace tact
