#include "devices/calibration/proportion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kMostOffProportion = 0.12;  // between levels: 1 dB
constexpr double kAgreed = 0.02;             // levels may differ by it, and by noise
constexpr double kSpareDb = 0.5;             // of noise, in what is told
constexpr double kMostRaised = 1.6;          // of the lowest level's strength, worked out: 4 dB

using Levels = std::span<const MeasuredTone>;

// How far the strengths of tones of one frequency are off that of the lowest level, as a share.
double off_proportion(Levels levels) {
    double most = 0.0;
    for (const MeasuredTone& one : levels) {
        most = std::max(most, std::abs(strength(one) / strength(levels.front()) - 1.0));
    }
    return most;
}

const MeasuredTone& strongest_of(Levels levels) {
    const MeasuredTone* best = &levels.back();
    for (const MeasuredTone& one : levels) {
        const double by_noise = 3.0 * std::hypot(one.standard_error, best->standard_error);
        if (strength(one) > strength(*best) * (1.0 + kAgreed + by_noise)) best = &one;
    }
    return *best;
}

std::string from_to(double low, double high) {
    return significant_digits(low, 3) == significant_digits(high, 3)
               ? significant_digits(low, 3)
               : significant_digits(low, 3) + " to " + significant_digits(high, 3);
}

struct Extent {
    std::size_t count = 0;
    double low = std::numeric_limits<double>::infinity();
    double high = 0.0;

    void add(double value) {
        ++count;
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

std::string at_frequencies(const Extent& hz) {
    if (hz.count == 1) return "at " + significant_digits(hz.low, 3) + " Hz ";
    return "at " + std::to_string(hz.count) + " frequencies from " + significant_digits(hz.low, 3) +
           " to " + significant_digits(hz.high, 3) + " Hz ";
}

MeasuredPoint measured_point(std::vector<MeasuredTone> clear) {
    std::ranges::sort(clear, {}, [](const MeasuredTone& one) { return one.tone.level; });
    MeasuredPoint made;
    made.followed = clear;
    auto& followed = made.followed;
    while (followed.size() > 1 &&
           (off_proportion(followed) > kMostOffProportion || !followed.back().accepted)) {
        followed.pop_back();
    }
    const MeasuredTone& highest = followed.back();
    const MeasuredTone& best = strongest_of(followed);
    made.tone = best.tone;
    made.point = {highest.tone.frequency_hz, strength(best), highest.tone.level, highest.thd,
                  off_proportion(followed)};
    if (clear.size() > 1 && followed.size() == 1) {
        const auto raised = raised_by(clear[0], clear[1]);
        made.point.nonlinearity = off_proportion(std::span(clear).first(2));
        made.point.unknown = !raised;
        made.raised = raised.value_or(1.0);
        made.point.g_per_full_scale *= made.raised;
    }
    made.clear = std::move(clear);
    return made;
}

std::string words_on_out(const std::vector<double>& all_hz, const std::string& limit) {
    std::string where;
    for (const double f_hz : all_hz)
        where += (where.empty() ? "" : ", ") + significant_digits(f_hz, 3);
    return "left out " + where +
           " Hz: what was measured there is out of proportion to the drive by more than " + limit +
           ", already at the lowest levels; nothing is sent around there: turn the amplifier down "
           "and record again";
}

}  // namespace

double strength(const MeasuredTone& one) { return one.amplitude_g / one.tone.level; }

std::optional<double> raised_by(const MeasuredTone& lowest, const MeasuredTone& next) {
    const double by_noise = 3.0 * std::hypot(lowest.standard_error, next.standard_error);
    const double fall = strength(lowest) / strength(next) * (1.0 + by_noise);
    const double ratio = next.tone.level / lowest.tone.level;
    if (fall < 1.0 || fall >= ratio) return std::nullopt;
    const double raised = 1.0 + (fall - 1.0) / (ratio - fall);
    return raised <= kMostRaised ? std::optional(raised) : std::nullopt;
}

std::vector<MeasuredPoint> in_proportion(const std::vector<MeasuredTone>& tones) {
    std::map<double, std::vector<MeasuredTone>> clear;
    for (const MeasuredTone& tone : tones) {
        if (tone.standard_error < kMostToneError) clear[tone.tone.frequency_hz].push_back(tone);
    }
    std::vector<MeasuredPoint> all;
    for (auto& [f_hz, levels] : clear) {
        MeasuredPoint made = measured_point(std::move(levels));
        if (made.followed.back().accepted) all.push_back(std::move(made));
    }
    return all;
}

std::vector<std::string> words_on_proportion(const std::vector<MeasuredPoint>& measured) {
    const std::string limit = percent(kMostOffProportion);
    Extent lowered_hz;
    Extent followed_g;
    Extent raised_hz;
    Extent single_hz;
    double most_raised = 1.0;
    std::vector<double> left_out_hz;
    for (const MeasuredPoint& one : measured) {
        const double f_hz = one.point.frequency_hz;
        if (one.point.unknown) {
            left_out_hz.push_back(f_hz);
            continue;
        }
        if (one.raised > 1.0) raised_hz.add(f_hz);
        most_raised = std::max(most_raised, one.raised);
        if (one.clear.size() == 1) single_hz.add(f_hz);
        if (one.followed.size() == one.clear.size()) continue;
        lowered_hz.add(f_hz);
        followed_g.add(one.followed.back().amplitude_g);
    }
    std::vector<std::string> remarks;
    if (!left_out_hz.empty()) remarks.push_back(words_on_out(left_out_hz, limit));
    if (raised_hz.count > 0) {
        remarks.push_back(at_frequencies(raised_hz) +
                          "even the weakest drive is out of proportion: strengths were worked "
                          "out, and may be too high by " +
                          significant_digits(kSpareDb + 20.0 * std::log10(most_raised), 3) +
                          " dB, so that patterns are too weak there");
    }
    if (lowered_hz.count > 0) {
        remarks.push_back(at_frequencies(lowered_hz) +
                          "the actuator is in proportion to its drive, to " + limit + ", up to " +
                          from_to(followed_g.low, followed_g.high) +
                          " g only: no more is sent there");
    }
    if (single_hz.count > 0) {
        remarks.push_back(at_frequencies(single_hz) +
                          "one level alone is clear: whether the actuator is in proportion to "
                          "its drive is not known");
    }
    return remarks;
}

}  // namespace tact
