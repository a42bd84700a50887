#include "devices/calibration/resonance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kStraightDb = 0.25;  // that a straight line may err
constexpr double kAgreedDb = 0.5;     // that two parabolas may differ
constexpr double kSpare = 0.25;       // of that difference, as they may both be wrong
constexpr double kMostToldDb = 12.0;  // that a strength may be wrong
constexpr double kBent = 0.04;        // off proportion, as a share
constexpr int kMostHalvings = 5;

double decibels(double ratio) { return 20.0 * std::log10(ratio); }

// Through three points; none where it has no square root.
std::optional<double> by_parabola(const ResponsePoint* three, double f_hz) {
    const double x = 1.0 / (f_hz * f_hz);
    double inverse_square = 0.0;
    for (int i = 0; i < 3; ++i) {
        double share = 1.0 / (three[i].g_per_full_scale * three[i].g_per_full_scale);
        const double at = 1.0 / (three[i].frequency_hz * three[i].frequency_hz);
        for (int k = 0; k < 3; ++k) {
            if (k == i) continue;
            const double other = 1.0 / (three[k].frequency_hz * three[k].frequency_hz);
            share *= (x - other) / (at - other);
        }
        inverse_square += share;
    }
    if (!(inverse_square > 0.0)) return std::nullopt;
    return 1.0 / std::sqrt(inverse_square);
}

double by_line(const ResponsePoint& a, const ResponsePoint& b, double f_hz) {
    const double share =
        std::log(f_hz / a.frequency_hz) / std::log(b.frequency_hz / a.frequency_hz);
    return a.g_per_full_scale * std::pow(b.g_per_full_scale / a.g_per_full_scale, share);
}

// What the parabolas of points[k] and points[k + 1] give at a frequency between.
struct Guess {
    double g = 0.0;
    double doubt_db = 0.0;  // how far they are apart
};

std::optional<Guess> guess_at(const std::vector<ResponsePoint>& points, std::size_t k,
                              double f_hz) {
    std::optional<double> with_lower;
    std::optional<double> with_upper;
    if (k > 0) with_lower = by_parabola(&points[k - 1], f_hz);
    if (k + 2 < points.size()) with_upper = by_parabola(&points[k], f_hz);
    if ((k > 0 && !with_lower) || (k + 2 < points.size() && !with_upper)) return std::nullopt;
    if (!with_lower && !with_upper) return std::nullopt;
    const double low = with_lower.value_or(with_upper.value_or(0.0));
    const double high = with_upper.value_or(low);
    return Guess{std::sqrt(low * high), std::abs(decibels(low / high))};
}

// Points between `from` and `to`, which lie within the interval k, until straight lines will do.
void add_between(const std::vector<ResponsePoint>& points, std::size_t k, const ResponsePoint& from,
                 const ResponsePoint& to, int halvings, std::vector<ResponsePoint>& added) {
    ResponsePoint middle = points[k];
    middle.frequency_hz = std::sqrt(from.frequency_hz * to.frequency_hz);
    const std::optional<Guess> guess = guess_at(points, k, middle.frequency_hz);
    if (!guess) return;
    middle.g_per_full_scale = guess->g;
    middle.between = true;
    const double off_db = decibels(guess->g / by_line(from, to, middle.frequency_hz));
    // The whole interval is known to bend, if perhaps not in its middle.
    if (halvings > 0 && std::abs(off_db) <= kStraightDb) return;
    if (halvings == kMostHalvings) return;
    add_between(points, k, from, middle, halvings + 1, added);
    added.push_back(middle);
    add_between(points, k, middle, to, halvings + 1, added);
}

const Resonance* known_between(const std::vector<Resonance>& known, double low_hz, double high_hz) {
    for (const Resonance& one : known) {
        if (low_hz >= one.low_hz && high_hz <= one.high_hz) return &one;
    }
    return nullptr;
}

// The resonance's own strengths between two points, bent so that they meet both.
void add_known(const Resonance& known, const ResponsePoint& from, const ResponsePoint& to,
               int halvings, std::vector<ResponsePoint>& added) {
    ResponsePoint middle = from;
    middle.frequency_hz = std::sqrt(from.frequency_hz * to.frequency_hz);
    middle.between = true;
    const double off_from = from.g_per_full_scale / strength_g(known, from.frequency_hz);
    const double off_to = to.g_per_full_scale / strength_g(known, to.frequency_hz);
    middle.g_per_full_scale = strength_g(known, middle.frequency_hz) * std::sqrt(off_from * off_to);
    if (halvings == kMostHalvings) return;
    std::vector<ResponsePoint> finer;
    add_known(known, from, middle, halvings + 1, finer);
    finer.push_back(middle);
    add_known(known, middle, to, halvings + 1, finer);
    const bool bends = std::ranges::any_of(finer, [&](const ResponsePoint& point) {
        const double line_g = by_line(from, to, point.frequency_hz);
        return std::abs(decibels(point.g_per_full_scale / line_g)) > kStraightDb;
    });
    if (bends) added.insert(added.end(), finer.begin(), finer.end());
}

// What a straight line errs by at most, and what the parabolas leave open: of an interval.
struct Bend {
    double most_db = 0.0;
    double doubt_db = 0.0;
};

Bend bend_of(const std::vector<ResponsePoint>& points, std::size_t k) {
    Bend bend;
    const double ratio = points[k + 1].frequency_hz / points[k].frequency_hz;
    for (const double share : {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875}) {
        const double f_hz = points[k].frequency_hz * std::pow(ratio, share);
        const std::optional<Guess> guess = guess_at(points, k, f_hz);
        if (!guess) return {0.0, 1e9};
        const double off_db = decibels(guess->g / by_line(points[k], points[k + 1], f_hz));
        bend.most_db = std::max(bend.most_db, std::abs(off_db));
        bend.doubt_db = std::max(bend.doubt_db, guess->doubt_db);
    }
    return bend;
}

std::string doubt_about(const ResponsePoint& a, const ResponsePoint& b, double told_db) {
    const std::string where = "between " + fixed_digits(a.frequency_hz, 0) + " and " +
                              fixed_digits(b.frequency_hz, 0) + " Hz ";
    if (told_db > kMostToldDb) {
        return where +
               "the response bends too much for the points there: strengths are not known, and "
               "nothing is sent there";
    }
    return where + "strengths may be wrong by " + fixed_digits(told_db, 1) +
           " dB, and are taken as high as they may be";
}

// A peak beside a point that gives out cannot be known.
bool is_bent(const ResponsePoint& point) { return point.nonlinearity > kBent; }

// Points of the interval k as strong as the actuator may be there, so that nothing is driven too
// strongly; one that is not known where that could be anything.
void add_highest(const std::vector<ResponsePoint>& points, std::size_t k, const Bend& bend,
                 FinerTable& finer) {
    const double spare_db = kSpare * bend.doubt_db;
    const ResponsePoint& from = points[k];
    const ResponsePoint& to = points[k + 1];
    std::vector<ResponsePoint> added;
    double told_db = spare_db + std::max(bend.doubt_db, bend.most_db);
    for (const double share : {0.25, 0.5, 0.75}) {
        ResponsePoint point = from;
        point.between = true;
        point.frequency_hz =
            from.frequency_hz * std::pow(to.frequency_hz / from.frequency_hz, share);
        const std::optional<Guess> guess = guess_at(points, k, point.frequency_hz);
        if (!guess) continue;
        const double line_g = by_line(from, to, point.frequency_hz);
        const double high_db = 0.5 * guess->doubt_db + spare_db;
        point.g_per_full_scale = std::max(line_g, guess->g * std::pow(10.0, high_db / 20.0));
        const double low_g =
            std::min(line_g, guess->g * std::pow(10.0, -0.5 * guess->doubt_db / 20.0));
        told_db = std::max(told_db, decibels(point.g_per_full_scale / low_g));
        added.push_back(point);
    }
    if (told_db > kMostToldDb || is_bent(from) || is_bent(to)) {
        told_db = std::numeric_limits<double>::infinity();
        added = {from};
        added[0].frequency_hz = std::sqrt(from.frequency_hz * to.frequency_hz);
        added[0].between = true;
        added[0].unknown = true;
    }
    finer.points.insert(finer.points.end(), added.begin(), added.end());
    finer.remarks.push_back(doubt_about(from, to, told_db));
}

}  // namespace

FinerTable finer_table(const std::vector<ResponsePoint>& points,
                       const std::vector<Resonance>& known) {
    FinerTable finer;
    for (std::size_t k = 0; k < points.size(); ++k) {
        finer.points.push_back(points[k]);
        if (k + 1 == points.size() || points.size() < 3) continue;
        if (const Resonance* one =
                known_between(known, points[k].frequency_hz, points[k + 1].frequency_hz)) {
            add_known(*one, points[k], points[k + 1], 0, finer.points);
            continue;
        }
        const Bend bend = bend_of(points, k);
        if (std::max(bend.most_db, bend.doubt_db) <= kStraightDb) continue;
        if (bend.doubt_db > kAgreedDb) {
            add_highest(points, k, bend, finer);
            continue;
        }
        add_between(points, k, points[k], points[k + 1], 0, finer.points);
    }
    return finer;
}

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
