#include "model/algebra/one_pattern.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/algebra/drawn_notes.h"
#include "model/pattern/traced.h"
#include "model/set/layers.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

bool has_bed(const Layer& layer) {
    if (layer.gain == 0.0) return false;
    const auto* pattern = std::get_if<Pattern>(&layer.source);
    if (pattern == nullptr) return peak_g(*std::get<Measurement>(layer.source).waveform) > 0.0;
    return pattern->amplitude_g > 0.0 &&
           std::ranges::any_of(pattern->carriers, [](const Carrier& c) { return c.weight != 0.0; });
}

// Phases at 0 s of the whole, so that they are at the offset what they were at 0 s.
void turn_back(Pattern& pattern, double offset_s) {
    const double first_hz = first_carrier_hz(pattern, 0.0);
    const double of_hz = pattern.carriers.front().frequency_hz;
    for (auto& [frequency_hz, weight, phase_rad] : pattern.carriers) {
        const double turns = frequency_hz / of_hz * first_hz * offset_s;
        phase_rad = std::remainder(phase_rad - kTurn * turns, kTurn);
    }
}

// Whether the modulation is at the offset what it is at 0 s.
bool fits(const Modulation& modulation, double offset_s) {
    const auto& [kind, frequency_hz, depth] = modulation;
    const double turns = frequency_hz * offset_s;
    return std::abs(turns - std::round(turns)) <= 1e-9 * std::max(1.0, turns);
}

// Without the rounding of a sum: 0.2 s and 0.1 s are 0.3 s, where a sample lies.
double later(double time_s, double offset_s) {
    constexpr double kPerS = 1e9;
    return std::round((time_s + offset_s) * kPerS) / kPerS;
}

// The amplitude curve, silent before the offset and behind its own end.
AmplitudeCurve moved(const AmplitudeCurve& curve, double own_s, double offset_s, double length_s) {
    AmplitudeCurve whole;
    if (offset_s > 0.0) {
        append_point(whole, 0.0, 0.0);
        append_point(whole, offset_s, 0.0);
    }
    const AmplitudeCurve own = curve.empty() ? AmplitudeCurve{{0.0, 1.0}} : curve;
    for (const AmplitudePoint& point : part_of_curve(own, 0.0, own_s)) {
        append_point(whole, std::min(later(point.time_s, offset_s), length_s), point.value);
    }
    const double end_s = later(own_s, offset_s);
    if (end_s < length_s) append_point(whole, end_s, 0.0);
    return whole;
}

void make_as_strong(Pattern& pattern, double gain, std::vector<std::string>& remarks) {
    pattern.amplitude_g *= gain;
    if (pattern.amplitude_g <= limits::kAmplitudeG.high) return;
    remarks.push_back("its amplitude of " + significant_digits(pattern.amplitude_g, 3) +
                      " g is cut to " + significant_digits(limits::kAmplitudeG.high, 3) + " g");
    pattern.amplitude_g = limits::kAmplitudeG.high;
}

Pattern placed(const Layer& layer, double length_s, std::vector<std::string>& remarks) {
    Pattern pattern = std::get<Pattern>(layer.source);
    pattern.transients.clear();
    make_as_strong(pattern, layer.gain, remarks);
    const double own_s = pattern.duration_s;
    const double offset_s = layer.offset_s;
    if (offset_s == 0.0 && own_s == length_s) return pattern;
    pattern = with_drawn_notes(std::move(pattern));
    pattern.amplitude_curve = moved(pattern.amplitude_curve, own_s, offset_s, length_s);
    turn_back(pattern, offset_s);
    for (FrequencyPoint& point : pattern.frequency_curve) {
        point.time_s = std::min(later(point.time_s, offset_s), length_s);
    }
    if (!fits(pattern.modulation, offset_s)) {
        remarks.push_back("its modulation begins at 0 s, not with its layer at " +
                          significant_digits(offset_s, 4) + " s");
    }
    pattern.duration_s = length_s;
    return pattern;
}

Pattern traced_sum(LayeredPattern layered, std::vector<std::string>& remarks) {
    for (Layer& layer : layered.layers) {
        if (auto* pattern = std::get_if<Pattern>(&layer.source)) pattern->transients.clear();
    }
    constexpr TraceParams kFine{.most_points = 1000, .section_s = 10.0};
    const TracedPattern sum = traced(render(layered), kFine);
    std::string remark = "layers that sound at once are traced as one carrier";
    if (sum.other_share > 0.01) {
        remark += "; " + significant_digits(100.0 * sum.other_share, 2) +
                  " % of their energy is at other frequencies";
    }
    remarks.push_back(std::move(remark));
    return sum.pattern;
}

std::vector<Transient> transients_of(const LayeredPattern& layered, double length_s) {
    std::vector<Transient> all;
    for (std::size_t k = 0; k < layered.layers.size(); ++k) {
        const Layer& layer = layered.layers[k];
        const auto* pattern = std::get_if<Pattern>(&layer.source);
        if (pattern == nullptr || !sounds(layered, k) || layer.gain == 0.0) continue;
        for (Transient one : pattern->transients) {
            one.time_s = std::min(one.time_s + layer.offset_s, length_s);
            one.amplitude_g = std::min(layer.gain * one.amplitude_g, limits::kAmplitudeG.high);
            all.push_back(one);
        }
    }
    all.resize(std::min(all.size(), limits::kMaxTransients));
    return all;
}

std::vector<std::size_t> beds_of(const LayeredPattern& layered) {
    std::vector<std::size_t> beds;
    for (std::size_t k = 0; k < layered.layers.size(); ++k) {
        if (sounds(layered, k) && has_bed(layered.layers[k])) beds.push_back(k);
    }
    return beds;
}

double energy_g2(const Layer& layer) {
    const Waveform own = std::holds_alternative<Pattern>(layer.source)
                             ? render_carriers(std::get<Pattern>(layer.source))
                             : *std::get<Measurement>(layer.source).waveform;
    double sum = 0.0;
    for (const double g : own.samples_g) sum += g * g;
    return layer.gain * layer.gain * sum;
}

// How much of what is merged each layer was.
void say_shares(const LayeredPattern& layered, const std::vector<std::size_t>& beds,
                std::vector<std::string>& remarks) {
    double all = 0.0;
    for (const std::size_t k : beds) all += energy_g2(layered.layers[k]);
    if (!(all > 0.0)) return;
    for (const std::size_t k : beds) {
        const double percent = 100.0 * energy_g2(layered.layers[k]) / all;
        remarks.push_back(name_of(layered, k) + ": merged with the others, " +
                          significant_digits(percent, 2) + " % of their energy");
    }
}

}  // namespace

OnePattern as_one_pattern(const LayeredPattern& layered) {
    const double length_s = duration_s(layered);
    const std::vector<std::size_t> beds = beds_of(layered);
    OnePattern one;
    if (beds.empty()) {
        one.pattern.amplitude_g = 0.0;
    } else if (beds.size() == 1 &&
               std::holds_alternative<Pattern>(layered.layers[beds[0]].source)) {
        one.pattern = placed(layered.layers[beds[0]], length_s, one.remarks);
    } else {
        say_shares(layered, beds, one.remarks);
        one.pattern = traced_sum(layered, one.remarks);
    }
    one.pattern.duration_s = length_s;
    one.pattern.transients = transients_of(layered, length_s);
    return one;
}

std::vector<PlacedBed> as_placed_beds(const LayeredPattern& layered) {
    const std::vector<std::size_t> beds = beds_of(layered);
    if (beds.size() < 2) return {};
    const double length_s = duration_s(layered);
    std::vector<PlacedBed> all;
    for (const std::size_t k : beds) {
        const Layer& layer = layered.layers[k];
        if (!std::holds_alternative<Pattern>(layer.source)) return {};
        PlacedBed bed{name_of(layered, k), {}, {}};
        bed.pattern = placed(layer, length_s, bed.remarks);
        all.push_back(std::move(bed));
    }
    all.front().pattern.transients = transients_of(layered, length_s);
    return all;
}

}  // namespace tact
