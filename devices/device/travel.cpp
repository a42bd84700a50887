#include "devices/device/travel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/common/units.h"

namespace tact {

namespace {

constexpr std::size_t kSamplesAStep = 2;
constexpr double kSpare = 1.02;
constexpr double kSettledPeriods = 1.5;  // of f0, until 0.1 % is left
constexpr int kLooksAPeriod = 200;       // of f0
constexpr double kLongestLookS = 0.001;

// The solution without a drive after one fixed time, as a matrix.
struct Decay {
    double xx, xv, vx, vv;

    Decay(double f0_hz, double time_s) {
        const double w = 2.0 * std::numbers::pi * f0_hz;
        const double a = w / std::numbers::sqrt2;  // both the decay and the frequency
        const double fall = std::exp(-a * time_s);
        const double c = fall * std::cos(a * time_s);
        const double s = fall * std::sin(a * time_s);
        xx = c + s;
        xv = s / a;
        vx = -w * w * s / a;
        vv = c - s;
    }
    Motion of(Motion m) const { return {xx * m.x_mm + xv * m.v_mm_s, vx * m.x_mm + vv * m.v_mm_s}; }
};

Motion plus(Motion a, Motion b, double times) {
    return {a.x_mm + times * b.x_mm, a.v_mm_s + times * b.v_mm_s};
}

double length_s(const Travel& travel) {
    return travel.step_s * static_cast<double>(travel.motions.size() - 1);
}

Motion between(const Travel& travel, double time_s) {
    const double steps = time_s / travel.step_s;
    const auto whole = std::min(static_cast<std::size_t>(steps), travel.motions.size() - 2);
    const Motion& before = travel.motions[whole];
    const double share = std::min(1.0, steps - static_cast<double>(whole));
    return plus(before, plus(travel.motions[whole + 1], before, -1.0), share);
}

// At level 1, also before the drive's start and after its end.
Motion motion_at(const Travel& travel, double time_s) {
    const double end_s = length_s(travel);
    if (travel.loop) {
        const double rest_s = std::fmod(time_s, end_s);
        return between(travel, rest_s < 0.0 ? rest_s + end_s : rest_s);
    }
    if (time_s <= 0.0) return {};
    if (time_s <= end_s) return between(travel, time_s);
    return at_rest_after(travel.motions.back(), travel.f0_hz, time_s - end_s);
}

// What its own repetition starts with: what one pass from rest leaves, summed up over all of them.
Motion repeated_start(Motion once, const Decay& pass) {
    const double a = 1.0 - pass.xx;
    const double d = 1.0 - pass.vv;
    const double determinant = a * d - pass.xv * pass.vx;
    return {(d * once.x_mm + pass.xv * once.v_mm_s) / determinant,
            (a * once.v_mm_s + pass.vx * once.x_mm) / determinant};
}

// Without a drive: where it is, or where it turns first.
double farthest_without_drive_mm(Motion m, double f0_hz) {
    const double w = 2.0 * std::numbers::pi * f0_hz;
    const double a = w / std::numbers::sqrt2;
    const double turn = std::atan2(m.v_mm_s * a, w * w * m.x_mm + a * m.v_mm_s);
    const double turn_s = (turn < 0.0 ? turn + std::numbers::pi : turn) / a;
    return std::max(std::abs(m.x_mm), std::abs(at_rest_after(m, f0_hz, turn_s).x_mm));
}

double look_s(const Travel& travel) {
    return std::min(kLongestLookS, 1.0 / (travel.f0_hz * kLooksAPeriod));
}

bool is_known(const Travel& travel) {
    return travel.limit_mm > 0.0 && travel.f0_hz > 0.0 && travel.motions.size() > 1;
}

}  // namespace

Travel travel_of(std::span<const double> acceleration_g, double rate_hz, double f0_hz,
                 double limit_mm, bool loop) {
    Travel travel{limit_mm, f0_hz, static_cast<double>(kSamplesAStep) / rate_hz, loop, {}};
    if (acceleration_g.empty()) return travel;
    const Decay sample(f0_hz, 1.0 / rate_hz);
    const double w = 2.0 * std::numbers::pi * f0_hz;
    // Each sample holds until the next one: around the place that it would move the mass to.
    const auto pass_from = [&](Motion now) {
        travel.motions = {now};
        std::size_t n = 0;
        for (const double g : acceleration_g) {
            const double place_mm = 1e3 * kStandardGravityMPerS2 * g / (w * w);
            now = sample.of({now.x_mm - place_mm, now.v_mm_s});
            now.x_mm += place_mm;
            if (++n % kSamplesAStep == 0) travel.motions.push_back(now);
        }
        // An odd last sample is left to the next step.
        return now;
    };
    const Motion once = pass_from({});
    if (travel.motions.size() < 2) travel.motions.push_back(once);
    if (!loop) return travel;
    const double pass_s = static_cast<double>(acceleration_g.size()) / rate_hz;
    pass_from(repeated_start(once, Decay(f0_hz, pass_s)));
    if (travel.motions.size() < 2) travel.motions.push_back(travel.motions.front());
    return travel;
}

double most_travel_mm(const Travel& travel) {
    if (travel.motions.size() < 2 || !(travel.f0_hz > 0.0)) return 0.0;
    double most = 0.0;
    for (const Motion& motion : travel.motions) {
        most = std::max(most, farthest_without_drive_mm(motion, travel.f0_hz));
    }
    if (!travel.loop) return most;
    const Decay step(travel.f0_hz, travel.step_s);
    const double until_s = kSettledPeriods / travel.f0_hz;
    Motion missing = travel.motions.front();  // of the repetition, as it starts from rest
    for (double time_s = 0.0; time_s < until_s; time_s += travel.step_s) {
        const Motion now = plus(motion_at(travel, time_s), missing, -1.0);
        most = std::max(most, farthest_without_drive_mm(now, travel.f0_hz));
        missing = step.of(missing);
    }
    return most;
}

Motion at_rest_after(Motion now, double f0_hz, double time_s) {
    if (!(f0_hz > 0.0) || !(time_s > 0.0)) return now;
    return Decay(f0_hz, time_s).of(now);
}

Motion driven_by(const Travel& travel, double from_s, double to_s, double level) {
    if (!is_known(travel)) return {};
    const Motion left = at_rest_after(motion_at(travel, from_s), travel.f0_hz, to_s - from_s);
    return plus({}, plus(motion_at(travel, to_s), left, -1.0), level);
}

Motion driven_on(Motion now, const Travel& travel, double from_s, double to_s, double level) {
    return plus(at_rest_after(now, travel.f0_hz, to_s - from_s),
                driven_by(travel, from_s, to_s, level), 1.0);
}

double level_within_travel(Motion now, const Travel& travel, double from_s) {
    if (!is_known(travel)) return 1.0;
    const double limit_mm = kSpare * travel.limit_mm;
    const Decay step(travel.f0_hz, look_s(travel));
    Motion missing = motion_at(travel, from_s);  // of the drive's motion, had it always played
    double level = 1.0;
    const double until_s = kSettledPeriods / travel.f0_hz;
    for (double time_s = 0.0; time_s < until_s; time_s += look_s(travel)) {
        const double own_mm = motion_at(travel, from_s + time_s).x_mm - missing.x_mm;
        const double there_mm = own_mm < 0.0 ? -now.x_mm : now.x_mm;
        const double room_mm = std::max(0.0, limit_mm - there_mm);
        if (std::abs(own_mm) * level > room_mm) level = room_mm / std::abs(own_mm);
        now = step.of(now);
        missing = step.of(missing);
    }
    return level;
}

}  // namespace tact
