#include "model/io/effects/voices.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kSame = 1e-9;  // relative

template <class Point>
void add_times(std::vector<double>& times, const Voice& voice, const std::vector<Point>& curve) {
    for (const Point& point : curve) {
        if (point.time_s > voice.start_s && point.time_s < voice.end_s) {
            times.push_back(point.time_s);
        }
    }
}

// What sounds on one side of a time, together.
struct Together {
    double squares = 0.0;
    double strongest_g = -1.0;
    double frequency_hz = 0.0;
    std::size_t voices = 0;

    void add(double amplitude_g, double hz) {
        squares += amplitude_g * amplitude_g;
        if (amplitude_g > strongest_g) {
            strongest_g = amplitude_g;
            frequency_hz = hz;
        }
        ++voices;
    }
    double amplitude_g() const { return voices == 1 ? strongest_g : std::sqrt(squares); }
};

struct Moment {
    double time_s = 0.0;
    Together before;
    Together behind;
};

// Voices come in the order of their starts.
Expected<std::vector<Moment>> moments(const std::vector<Voice>& voices,
                                      const std::vector<double>& times) {
    std::vector<Moment> result;
    std::vector<const Voice*> active;
    std::size_t next = 0;
    for (const double t_s : times) {
        while (next < voices.size() && voices[next].start_s <= t_s) {
            active.push_back(&voices[next++]);
        }
        if (active.size() > 2 * kMostAtOnce) {
            return Error{"expected at most " + grouped_digits(kMostAtOnce) +
                         " vibrations at one time, got more"};
        }
        Moment moment{t_s, {}, {}};
        for (const Voice* voice : active) {
            const Sides amplitude = sides_at(voice->amplitude, t_s);
            const Sides hz = sides_at(voice->frequency, t_s);
            if (voice->start_s < t_s) moment.before.add(amplitude.before, hz.before);
            if (voice->end_s > t_s) moment.behind.add(amplitude.behind, hz.behind);
        }
        std::erase_if(active, [&](const Voice* voice) { return voice->end_s <= t_s; });
        result.push_back(moment);
    }
    return result;
}

bool is_overlapping(const std::vector<Voice>& voices) {
    double end_s = 0.0;
    for (const Voice& voice : voices) {
        if (voice.start_s < end_s) return true;
        end_s = std::max(end_s, voice.end_s);
    }
    return false;
}

template <class Point>
void add_sides(std::vector<Point>& curve, double t_s, std::optional<double> before,
               std::optional<double> behind) {
    if (before) curve.push_back({t_s, *before});
    if (behind && !(before && is_same(*before, *behind))) curve.push_back({t_s, *behind});
}

AmplitudeCurve amplitude_of(const std::vector<Moment>& all, double end_s) {
    AmplitudeCurve curve;
    for (const Moment& moment : all) {
        const bool first = moment.time_s == 0.0;
        const bool last = moment.time_s == end_s;
        add_sides(curve, moment.time_s,
                  first ? std::nullopt : std::optional(moment.before.amplitude_g()),
                  last ? std::nullopt : std::optional(moment.behind.amplitude_g()));
    }
    return curve;
}

FrequencyCurve frequency_of(const std::vector<Moment>& all) {
    const auto hz = [](const Together& side) {
        return side.voices > 0 ? std::optional(side.frequency_hz) : std::nullopt;
    };
    FrequencyCurve curve;
    for (const Moment& moment : all) {
        add_sides(curve, moment.time_s, hz(moment.before), hz(moment.behind));
    }
    return curve;
}

}  // namespace

bool is_same(double a, double b) { return std::abs(a - b) <= kSame * std::max(std::abs(a), 1.0); }

std::vector<double> times_of(const std::vector<Voice>& voices, bool amplitudes, bool frequencies) {
    std::vector<double> times;
    for (const Voice& voice : voices) {
        times.push_back(voice.start_s);
        times.push_back(voice.end_s);
        if (amplitudes) add_times(times, voice, voice.amplitude);
        if (frequencies) add_times(times, voice, voice.frequency);
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

Expected<MergedVoices> merged(const std::vector<Voice>& voices, double end_s) {
    MergedVoices result;
    result.overlap = is_overlapping(voices);
    const auto amplitudes = moments(voices, times_of(voices, true, false));
    if (!amplitudes) return amplitudes.error();
    const auto frequencies = moments(voices, times_of(voices, result.overlap, true));
    if (!frequencies) return frequencies.error();
    result.amplitude = amplitude_of(*amplitudes, end_s);
    result.frequency = frequency_of(*frequencies);
    return result;
}

}  // namespace tact
