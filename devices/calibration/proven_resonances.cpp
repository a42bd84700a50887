#include "devices/calibration/proven_resonances.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tact {

namespace {

constexpr double kExplained = 0.05;  // 0.4 dB: a resonance is within 0.3 dB of its points

bool is_out(const MeasuredPoint& one) { return one.point.unknown || one.raised > 1.0; }

bool explains(const CalibrationPlan& plan, const Resonance& resonance,
              const std::vector<MeasuredTone>& heard) {
    std::vector<CalibrationTone> tones;
    for (const MeasuredTone& one : heard) tones.push_back(one.tone);
    const std::vector<double> rung = rung_g(plan, tones, resonance);
    for (std::size_t k = 0; k < heard.size(); ++k) {
        const double off = std::abs(std::log(strength(heard[k]) / rung[k]));
        if (off > kExplained + 3.0 * heard[k].standard_error) return false;
    }
    return true;
}

bool is_within(const Resonance& resonance, const MeasuredPoint& one) {
    return one.point.frequency_hz >= resonance.low_hz &&
           one.point.frequency_hz <= resonance.high_hz;
}

bool is_proven(const CalibrationPlan& plan, const Resonance& resonance,
               const std::vector<MeasuredPoint>& measured) {
    std::vector<MeasuredTone> heard;
    for (const MeasuredPoint& one : measured) {
        if (!is_within(resonance, one)) continue;
        const auto& levels = is_out(one) ? one.clear : one.followed;
        heard.insert(heard.end(), levels.begin(), levels.end());
    }
    return explains(plan, resonance, heard);
}

void take_as(const Resonance& resonance, MeasuredPoint& one) {
    one.followed = one.clear;
    one.raised = 1.0;
    one.point.unknown = false;
    one.point.g_per_full_scale = strength_g(resonance, one.point.frequency_hz);
    one.point.largest_drive = one.clear.back().tone.level;
}

}  // namespace

std::vector<Resonance> proven_resonances(const CalibrationPlan& plan,
                                         std::vector<MeasuredPoint>& measured) {
    std::vector<ResponsePoint> points;
    std::vector<CalibrationTone> tones;
    for (const MeasuredPoint& one : measured) {
        if (is_out(one)) continue;
        points.push_back(one.point);
        tones.push_back(one.tone);
    }
    std::vector<Resonance> sharp = sharp_resonances(plan, tones, points);
    std::erase_if(sharp, [&](const Resonance& one) { return !is_proven(plan, one, measured); });
    auto corrected = points.begin();
    for (MeasuredPoint& one : measured) {
        const bool was_out = is_out(one);
        for (const Resonance& resonance : sharp) {
            if (!is_within(resonance, one)) continue;
            if (!was_out) one.point = *corrected;
            if (was_out) take_as(resonance, one);
        }
        if (!was_out) ++corrected;
    }
    return sharp;
}

}  // namespace tact
