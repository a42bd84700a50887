#include "model/pattern/drawn_fault.h"

#include "model/pattern/pattern_numbers.h"

namespace tact {

namespace {

// Keeps the first fault, so that the checks below read as the rules do.
struct DrawnCheck {
    double duration_s;
    std::optional<DrawnFault> fault;

    void refuse_number(const std::string& place, const std::string& expected, double got) {
        if (!fault) fault = DrawnFault{place, expected, got};
    }

    void number(const std::string& place, const Number& number, double value) {
        if (number.range.contains(value)) return;
        refuse_number(place + "/" + number.key, range_words(number.range), value);
    }

    void time(const std::string& place, double time_s) {
        if (Range{0.0, duration_s}.contains(time_s)) return;
        refuse_number(
            place, "a time within the pattern, 0 to " + shortest_digits(duration_s) + " s", time_s);
    }

    void count(const std::string& place, std::size_t most, const std::string& things,
               std::size_t number) {
        if (number <= most || fault) return;
        fault = DrawnFault{place, "at most " + grouped_digits(most) + " " + things,
                           static_cast<double>(number)};
    }

    template <class Point>
    void curve(const std::string& place, const std::vector<Point>& points, const Number& height) {
        times(place, points);
        for (std::size_t k = 0; k < points.size() && !fault; ++k) {
            if (height.range.contains(height_of(points[k]))) continue;
            number(place + "/" + std::to_string(k), height, height_of(points[k]));
        }
    }

    template <class Point>
    void times(const std::string& place, const std::vector<Point>& curve) {
        count(place, limits::kMaxCurvePoints, "points", curve.size());
        for (std::size_t k = 0; k < curve.size() && !fault; ++k) {
            const double time_s = curve[k].time_s;
            const bool within = Range{0.0, duration_s}.contains(time_s);
            const bool behind = k == 0 || time_s >= curve[k - 1].time_s;
            const bool third = k > 1 && time_s == curve[k - 2].time_s;
            if (within && behind && !third) continue;
            const std::string here = place + "/" + std::to_string(k) + "/time_s";
            time(here, time_s);
            if (!behind) {
                refuse_number(here,
                              "a time not before the last point's " +
                                  shortest_digits(curve[k - 1].time_s) + " s",
                              time_s);
            }
            if (third) refuse_number(here, "at most two points at one time, a jump", time_s);
        }
    }
};

void check_transient(DrawnCheck& check, const Transient& transient, const std::string& place) {
    check.time(place + "/time_s", transient.time_s);
    check.number(place, numbers::kTransientPeak, transient.amplitude_g);
    check.number(place, numbers::kTransientFrequency, transient.frequency_hz);
    check.number(place, numbers::kTransientDuration, transient.duration_s);
}

}  // namespace

std::optional<DrawnFault> drawn_fault(const Pattern& pattern) {
    DrawnCheck checks{pattern.duration_s, std::nullopt};
    checks.curve("amplitude_curve", pattern.amplitude_curve, numbers::kCurveValue);
    checks.curve("frequency_curve", pattern.frequency_curve, numbers::kPointFrequency);
    checks.count("transients", limits::kMaxTransients, "transients", pattern.transients.size());
    for (std::size_t k = 0; k < pattern.transients.size() && !checks.fault; ++k) {
        check_transient(checks, pattern.transients[k], "transients/" + std::to_string(k));
    }
    return checks.fault;
}

std::string sentence(const DrawnFault& fault) {
    return fault.place + ": expected " + fault.expected + ", got " + shortest_digits(fault.got);
}

}  // namespace tact
