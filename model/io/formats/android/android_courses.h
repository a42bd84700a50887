// Android's predefined effects and primitives, each as a course that stands for the device's own.
//
// The platform names them and says what each is to feel like; every device plays its own. So all of
// these are assumed, and a remark says so.
//
// Source    names and sensations: VibrationEffect and VibrationEffect.Composition (API 36); the
//           double click's 130 ms from press to press: what the platform plays where a device has
//           none, (0, 30, 100, 30) ms. Lengths, intensities and sharpness: ours.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include "model/io/effects/actuator_map.h"

namespace tact {

struct CoursePoint {
    double time_s;
    double intensity;      // 0 to 1
    double sharpness;      // 0 to 1
    double burst_s = 0.0;  // how long a burst lasts; 0: the point is one of a line
};

struct AssumedCourse {
    std::string_view name;
    std::span<const CoursePoint> points;
    bool bursts;  // each point is one; otherwise the points are joined by lines
};

namespace courses {
inline constexpr std::array<CoursePoint, 1> kClick{{{0.0, 1.0, 0.6, 0.02}}};
inline constexpr std::array<CoursePoint, 1> kTick{{{0.0, 0.5, 0.9, 0.012}}};
inline constexpr std::array<CoursePoint, 1> kLowTick{{{0.0, 0.5, 0.25, 0.02}}};
inline constexpr std::array<CoursePoint, 1> kHeavyClick{{{0.0, 1.0, 0.35, 0.03}}};
inline constexpr std::array<CoursePoint, 2> kDoubleClick{
    {{0.0, 1.0, 0.6, 0.02}, {0.13, 1.0, 0.6, 0.02}}};
// Falls, hits, and rings out.
inline constexpr std::array<CoursePoint, 4> kThud{
    {{0.0, 0.2, 0.3}, {0.05, 1.0, 0.2}, {0.12, 0.4, 0.1}, {0.3, 0.0, 0.0}}};
inline constexpr std::array<CoursePoint, 3> kSpin{
    {{0.0, 0.0, 0.3}, {0.075, 1.0, 0.5}, {0.15, 0.0, 0.3}}};
inline constexpr std::array<CoursePoint, 2> kQuickRise{{{0.0, 0.0, 0.2}, {0.15, 1.0, 0.6}}};
inline constexpr std::array<CoursePoint, 2> kSlowRise{{{0.0, 0.0, 0.2}, {0.5, 1.0, 0.6}}};
inline constexpr std::array<CoursePoint, 2> kQuickFall{{{0.0, 1.0, 0.6}, {0.1, 0.0, 0.2}}};

inline constexpr auto kPrimitives =
    std::to_array<AssumedCourse>({{"click", kClick, true},
                                  {"tick", kTick, true},
                                  {"low_tick", kLowTick, true},
                                  {"thud", kThud, false},
                                  {"spin", kSpin, false},
                                  {"quick_rise", kQuickRise, false},
                                  {"slow_rise", kSlowRise, false},
                                  {"quick_fall", kQuickFall, false}});

inline constexpr auto kPredefined =
    std::to_array<AssumedCourse>({{"click", kClick, true},
                                  {"tick", kTick, true},
                                  {"heavy_click", kHeavyClick, true},
                                  {"double_click", kDoubleClick, true}});
}  // namespace courses

// The course of a name; null: the platform has none of that name for everybody.
inline const AssumedCourse* course_named(std::span<const AssumedCourse> courses,
                                         std::string_view name) {
    const auto at = std::ranges::find(courses, name, &AssumedCourse::name);
    return at == courses.end() ? nullptr : &*at;
}

// A burst of a course on a device, at a scale from 0 to 1.
inline Transient burst_at(const ActuatorMap& map, const CoursePoint& point, double time_s,
                          double scale) {
    return held_burst(time_s, continuous_g(map, scale * point.intensity),
                      frequency_hz(map, point.sharpness), point.burst_s);
}

}  // namespace tact
