#include "model/io/effects/sketch.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/io/effects/voices.h"
#include "model/pattern/curves.h"
#include "model/pattern/drawn_fault.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

template <class Point>
Sides sides(const std::vector<Point>& curve, double t_s) {
    assert(!curve.empty() && "a curve has points");
    const auto behind = std::ranges::upper_bound(curve, t_s, {}, &Point::time_s);
    const auto from = std::ranges::lower_bound(curve, t_s, {}, &Point::time_s);
    if (from != behind) return {height_of(*from), height_of(*(behind - 1))};
    if (from == curve.begin()) return {height_of(*from), height_of(*from)};
    if (from == curve.end()) return {height_of(curve.back()), height_of(curve.back())};
    const Point& left = *(from - 1);
    const double share = (t_s - left.time_s) / (from->time_s - left.time_s);
    const double value = height_of(left) + (height_of(*from) - height_of(left)) * share;
    return {value, value};
}

template <class Point>
std::vector<Point> part_between(const std::vector<Point>& curve, double start_s, double end_s) {
    std::vector<Point> part{{start_s, sides(curve, start_s).behind}};
    const auto from = std::ranges::upper_bound(curve, start_s, {}, &Point::time_s);
    const auto to = std::ranges::lower_bound(from, curve.end(), end_s, {}, &Point::time_s);
    part.insert(part.end(), from, to);
    part.push_back({end_s, sides(curve, end_s).before});
    return part;
}

// What ends where the next begins, but for rounding, ends there.
void close_gaps(std::vector<Voice>& voices) {
    constexpr double kRoundingS = 1e-7;
    for (std::size_t k = 1; k < voices.size(); ++k) {
        Voice& last = voices[k - 1];
        const double start_s = voices[k].start_s;
        if (start_s > last.start_s && std::abs(last.end_s - start_s) < kRoundingS) {
            last.end_s = start_s;
        }
    }
}

// Whether one voice is the other, louder and higher.
bool is_carrier_beside(const Voice& first, const Voice& other, const std::vector<double>& times) {
    if (first.start_s != other.start_s || first.end_s != other.end_s) return false;
    const double peak = peak_value(first.amplitude);
    const double other_peak = peak_value(other.amplitude);
    if (!(peak > 0.0) || !(other_peak > 0.0)) return false;
    const double hz = first.frequency.front().frequency_hz;
    const double other_hz = other.frequency.front().frequency_hz;
    return std::ranges::all_of(times, [&](double t_s) {
        const auto fit = [](double a, double b) { return std::abs(a - b) <= 1e-6; };
        const Sides a = sides(first.amplitude, t_s);
        const Sides b = sides(other.amplitude, t_s);
        const Sides f = sides(first.frequency, t_s);
        const Sides g = sides(other.frequency, t_s);
        return fit(a.before / peak, b.before / other_peak) &&
               fit(a.behind / peak, b.behind / other_peak) &&
               fit(f.before / hz, g.before / other_hz) && fit(f.behind / hz, g.behind / other_hz);
    });
}

double in_range_hz(double hz) {
    return std::clamp(hz, limits::kCarrierHz.low, limits::kCarrierHz.high);
}

void set_frequency(Pattern& pattern, FrequencyCurve curve, std::vector<std::string>& remarks) {
    bool moved = false;
    for (FrequencyPoint& point : curve) {
        const double hz = in_range_hz(point.frequency_hz);
        moved = moved || hz != point.frequency_hz;
        point.frequency_hz = hz;
    }
    if (moved) remarks.push_back("frequencies are moved into 0.1 to 1,000 Hz");
    pattern.carriers.front().frequency_hz = curve.front().frequency_hz;
    const bool constant = std::ranges::all_of(curve, [&](const FrequencyPoint& point) {
        return is_same(point.frequency_hz, curve.front().frequency_hz);
    });
    if (!constant) pattern.frequency_curve = std::move(curve);
}

void set_amplitude(Pattern& pattern, AmplitudeCurve curve, double unit_g,
                   std::vector<std::string>& remarks) {
    const double peak = peak_value(curve);
    const double full_g = peak <= unit_g || is_same(peak, unit_g) ? unit_g : peak;
    if (full_g > limits::kAmplitudeG.high) {
        remarks.push_back("amplitudes above 50 g are scaled down to it");
    }
    pattern.amplitude_g = std::min(full_g, limits::kAmplitudeG.high);
    for (AmplitudePoint& point : curve) {
        point.value = full_g > 0.0 ? std::clamp(point.value / full_g, 0.0, 1.0) : 0.0;
    }
    pattern.amplitude_curve = std::move(curve);
}

// Cut where a limit is reached: what was left out in between would make another rhythm of it.
void cut_short(Pattern& pattern, double at_s, const std::string& held,
               std::vector<std::string>& remarks) {
    const double held_s = std::max(at_s, limits::kDurationS.low);
    if (held_s >= pattern.duration_s) return;
    remarks.push_back("cut at " + significant_digits(held_s, 4) + " s of " +
                      significant_digits(pattern.duration_s, 4) + " s: " + held +
                      ", as many as a pattern can hold, end there");
    pattern = with_duration(std::move(pattern), held_s);
}

// Where the first point is that a pattern cannot hold.
template <class Point>
double held_s(const std::vector<Point>& curve, double end_s) {
    if (curve.size() <= limits::kMaxCurvePoints) return end_s;
    return std::min(end_s, curve[limits::kMaxCurvePoints - 1].time_s);
}

void cut_to_limit(Pattern& pattern, std::vector<std::string>& remarks) {
    const double end_s = pattern.duration_s;
    const double at_s =
        std::min(held_s(pattern.amplitude_curve, end_s), held_s(pattern.frequency_curve, end_s));
    if (at_s >= end_s) return;
    cut_short(pattern, at_s, grouped_digits(limits::kMaxCurvePoints) + " points of a curve",
              remarks);
    pattern.amplitude_curve.resize(
        std::min(pattern.amplitude_curve.size(), limits::kMaxCurvePoints));
    pattern.frequency_curve.resize(
        std::min(pattern.frequency_curve.size(), limits::kMaxCurvePoints));
}

void set_transients(Pattern& pattern, std::vector<Transient> all,
                    std::vector<std::string>& remarks) {
    std::erase_if(all, [](const Transient& one) { return !(one.amplitude_g > 0.0); });
    std::ranges::stable_sort(all, {}, &Transient::time_s);
    if (all.size() > limits::kMaxTransients) {
        const std::string written = grouped_digits(all.size());
        cut_short(pattern, all[limits::kMaxTransients].time_s,
                  grouped_digits(limits::kMaxTransients) + " of " + written + " transients",
                  remarks);
        all.resize(limits::kMaxTransients);
    }
    bool moved = false;
    for (Transient& one : all) {
        const Transient asked = one;
        one.frequency_hz = in_range_hz(one.frequency_hz);
        one.duration_s =
            std::clamp(one.duration_s, limits::kTransientS.low, limits::kTransientS.high);
        one.amplitude_g = std::min(one.amplitude_g, limits::kAmplitudeG.high);
        moved = moved || one != asked;
    }
    if (moved) remarks.push_back("transients are moved into 0.1 to 1,000 Hz, 1 ms to 1 s and 50 g");
    pattern.transients = std::move(all);
}

// A length in a file says where events begin to end, not where sound does.
double end_of(const Sketch& sketch) {
    double end_s = std::max(sketch.duration_s, limits::kDurationS.low);
    for (const Voice& voice : sketch.voices) end_s = std::max(end_s, voice.end_s);
    for (const Transient& one : sketch.transients) {
        const bool within = sketch.duration_s > 0.0 && one.time_s <= sketch.duration_s;
        const bool sounds = one.amplitude_g > 0.0;
        if (sounds || !within) end_s = std::max(end_s, one.time_s + one.duration_s);
    }
    return end_s;
}

Expected<Done> draw_voices(Pattern& pattern, std::vector<Voice> voices, double unit_g,
                           std::vector<std::string>& remarks) {
    std::ranges::stable_sort(voices, {}, &Voice::start_s);
    close_gaps(voices);
    const bool carriers = are_carriers(voices);
    if (carriers) {
        const auto strongest = std::ranges::max_element(
            voices, {}, [](const Voice& voice) { return peak_value(voice.amplitude); });
        const double peak = peak_value(strongest->amplitude);
        pattern.carriers.clear();
        for (const Voice& voice : voices) {
            pattern.carriers.push_back({in_range_hz(voice.frequency.front().frequency_hz),
                                        peak_value(voice.amplitude) / peak, voice.phase_rad});
        }
        Voice envelope = voices.front();
        envelope.amplitude = strongest->amplitude;
        voices = {envelope};
    }
    const auto lines = merged(voices, pattern.duration_s);
    if (!lines) return lines.error();
    if (lines->overlap) {
        remarks.push_back(
            "vibrations at one time are merged: the root of the sum of their squares, at the "
            "frequency of the strongest");
    }
    set_amplitude(pattern, lines->amplitude, unit_g, remarks);
    set_frequency(pattern, lines->frequency, remarks);
    if (voices.size() == 1 && !carriers) {
        pattern.carriers.front().phase_rad = voices.front().phase_rad;
    }
    return Done{};
}

Expected<Done> check_size(const Sketch& sketch) {
    std::size_t points = sketch.transients.size();
    for (const Voice& voice : sketch.voices) {
        points += voice.amplitude.size() + voice.frequency.size();
    }
    if (std::string fault = size_fault(sketch, points); !fault.empty()) return Error{fault};
    return Done{};
}

}  // namespace

bool are_carriers(const std::vector<Voice>& voices) {
    if (voices.size() < 2 || voices.size() > limits::kMaxCarriers) return false;
    const std::vector<double> times = times_of(voices, true, true);
    return std::ranges::all_of(voices, [&](const Voice& voice) {
        return is_carrier_beside(voices.front(), voice, times);
    });
}

Sides sides_at(const AmplitudeCurve& curve, double t_s) { return sides(curve, t_s); }
Sides sides_at(const FrequencyCurve& curve, double t_s) { return sides(curve, t_s); }

std::string size_fault(const Sketch& sketch, std::size_t points) {
    if (sketch.voices.size() <= kMostVoices && points <= kMostVoicePoints) return {};
    return "expected at most " + grouped_digits(kMostVoices) + " vibrations and " +
           grouped_digits(kMostVoicePoints) + " points in an effect, got more";
}

Voice cut_out(Voice voice) {
    voice.amplitude = part_between(voice.amplitude, voice.start_s, voice.end_s);
    voice.frequency = part_between(voice.frequency, voice.start_s, voice.end_s);
    return voice;
}

Expected<Pattern> pattern_of(const Sketch& sketch, std::vector<std::string>& remarks) {
    if (const auto size = check_size(sketch); !size) return size.error();
    Pattern pattern;
    pattern.duration_s = end_of(sketch);
    pattern.amplitude_g = sketch.unit_g;
    pattern.amplitude_curve = {{0.0, 0.0}, {pattern.duration_s, 0.0}};
    std::vector<Voice> voices = sketch.voices;
    std::erase_if(voices, [](const Voice& voice) { return !(voice.start_s < voice.end_s); });
    if (!voices.empty()) {
        const auto drawn = draw_voices(pattern, std::move(voices), sketch.unit_g, remarks);
        if (!drawn) return drawn.error();
    }
    set_transients(pattern, sketch.transients, remarks);
    if (pattern.duration_s > limits::kDurationS.high) {
        remarks.push_back("cut at " + shortest_digits(limits::kDurationS.high) + " s of " +
                          significant_digits(pattern.duration_s, 4) +
                          " s, as long as a pattern can be");
        pattern = with_duration(std::move(pattern), limits::kDurationS.high);
    }
    cut_to_limit(pattern, remarks);
    if (const auto fault = drawn_fault(pattern)) return Error{sentence(*fault)};
    return pattern;
}

}  // namespace tact
