#include "model/io/formats/android/android_primitives.h"

#include <algorithm>
#include <cmath>

#include "model/io/effects/effect.h"

namespace tact {

namespace {

constexpr double kSameStartS = 1e-6;
constexpr double kSameShare = 2e-3;  // of full scale: curves are within half of it of the law's
constexpr double kSameHz = 0.3;
constexpr int kPlaces = 32;  // at which a course is compared

// The intensity that a share of what the device can do stands for.
double intensity_of(const ActuatorMap& map, double share) {
    return map.intensity_law == IntensityLaw::squared ? std::sqrt(share) : share;
}

bool is_near(double a, double b) { return std::abs(a - b) <= 1e-6 * std::max(1.0, std::abs(b)); }

std::optional<PlayedPrimitive> burst_of(const Transient& transient, const ActuatorMap& map) {
    for (const AssumedCourse& course : courses::kPrimitives) {
        if (!course.bursts) continue;
        const CoursePoint& point = course.points.front();
        const Transient full = burst_at(map, point, 0.0, 1.0);
        if (!(full.amplitude_g > 0.0)) continue;
        const bool alike = is_near(transient.frequency_hz, full.frequency_hz) &&
                           is_near(transient.duration_s, full.duration_s) &&
                           transient.shape == full.shape;
        const double scale = intensity_of(map, transient.amplitude_g / full.amplitude_g);
        if (!alike || !(scale > 0.0) || scale > 1.0 + 1e-6) continue;
        return PlayedPrimitive{&course, std::min(scale, 1.0), transient.time_s,
                               transient.time_s + point.burst_s};
    }
    return std::nullopt;
}

bool is_plain(const Pattern& pattern) {
    return pattern.rhythm.text.empty() && pattern.attack_s == 0.0 && pattern.release_s == 0.0 &&
           pattern.modulation.frequency_hz == 0.0 && pattern.carriers.size() == 1 &&
           pattern.carriers.front().weight == 1.0;
}

bool is_silent(const Pattern& pattern, double from_s, double to_s) {
    for (int k = 1; k < kPlaces && to_s > from_s; ++k) {
        if (envelope_g(pattern, from_s + (to_s - from_s) * k / kPlaces) > 1e-9) return false;
    }
    return true;
}

// The course as it begins at that time, if the pattern has it there at any scale.
std::optional<PlayedPrimitive> line_from(const Pattern& pattern, double start_s,
                                         const AssumedCourse& course, const ActuatorMap& map) {
    const double length_s = course.points.back().time_s;
    const double full_g = continuous_g(map, 1.0);
    if (start_s + length_s > pattern.duration_s + kSameStartS || !(full_g > 0.0))
        return std::nullopt;
    AmplitudeCurve intensities;
    AmplitudeCurve sharpnesses;
    double strongest_s = 0.0;
    for (const CoursePoint& point : course.points) {
        intensities.push_back({point.time_s, point.intensity});
        sharpnesses.push_back({point.time_s, point.sharpness});
        if (point.intensity == 1.0) strongest_s = point.time_s;
    }
    // Just within the course, where a jump at its end has not happened yet.
    const double within_s = std::clamp(strongest_s, 1e-5 * length_s, (1.0 - 1e-5) * length_s);
    const double share = envelope_g(pattern, start_s + within_s) / full_g;
    const double scale = std::min(1.0, intensity_of(map, share) / value_at(intensities, within_s));
    if (!(scale > 0.0)) return std::nullopt;
    const FrequencyCurve hz = frequency_curve(map, sharpnesses);
    for (int k = 0; k < kPlaces; ++k) {
        const double t_s = length_s * (k + 0.5) / kPlaces;
        const double expected_g = continuous_g(map, scale * value_at(intensities, t_s));
        if (std::abs(envelope_g(pattern, start_s + t_s) - expected_g) > kSameShare * full_g) {
            return std::nullopt;
        }
        if (std::abs(first_carrier_hz(pattern, start_s + t_s) - *frequency_at(hz, t_s)) > kSameHz) {
            return std::nullopt;
        }
    }
    return PlayedPrimitive{&course, scale, start_s, start_s + length_s};
}

// All that sounds of the carrier as courses that follow each other; none: it is something else.
std::optional<std::vector<PlayedPrimitive>> lines_of(const Pattern& pattern,
                                                     const ActuatorMap& map) {
    std::vector<PlayedPrimitive> found;
    double done_s = 0.0;
    for (const AmplitudePoint& point : pattern.amplitude_curve) {
        if (point.time_s < done_s - kSameStartS) continue;
        if (!is_silent(pattern, done_s, point.time_s)) return std::nullopt;
        for (const AssumedCourse& course : courses::kPrimitives) {
            if (course.bursts) continue;
            const auto line = line_from(pattern, point.time_s, course, map);
            if (!line) continue;
            done_s = line->end_s;
            found.push_back(*line);
            break;
        }
    }
    if (!is_silent(pattern, done_s, pattern.duration_s)) return std::nullopt;
    return found;
}

}  // namespace

std::optional<std::vector<PlayedPrimitive>> as_primitives(const Pattern& pattern,
                                                          const ActuatorMap& map) {
    std::vector<PlayedPrimitive> all;
    if (pattern.amplitude_g > 0.0 && !is_silent(pattern, 0.0, pattern.duration_s)) {
        if (!is_plain(pattern) || pattern.amplitude_curve.empty()) return std::nullopt;
        const auto lines = lines_of(pattern, map);
        if (!lines) return std::nullopt;
        all = *lines;
    }
    for (const Transient& transient : pattern.transients) {
        const auto burst = burst_of(transient, map);
        if (!burst) return std::nullopt;
        all.push_back(*burst);
    }
    if (all.empty()) return std::nullopt;
    std::ranges::stable_sort(all, {}, &PlayedPrimitive::start_s);
    // The platform leaves out what overlaps, and a composition holds no silence at its end.
    constexpr double kLeastS = 5e-4;
    double end_s = 0.0;
    for (const PlayedPrimitive& one : all) {
        if (one.start_s < end_s - kLeastS) return std::nullopt;
        end_s = one.end_s;
    }
    if (std::abs(end_s - pattern.duration_s) > kLeastS) return std::nullopt;
    return all;
}

}  // namespace tact
