// Edits that move what is there in time.
#include <algorithm>
#include <cmath>
#include <limits>

#include "model/algebra/algebra_parts.h"
#include "model/algebra/drawn_notes.h"
#include "model/pattern/curves.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// The whole number that the quotient is but for rounding; none: it is not one.
std::optional<std::size_t> whole(double quotient) {
    const double nearest = std::round(quotient);
    if (std::abs(quotient - nearest) > 1e-9 * std::max(1.0, nearest)) return std::nullopt;
    return static_cast<std::size_t>(nearest);
}

// Steps of the rhythm that the pattern lasts; none: no whole number.
std::optional<std::size_t> steps_of(const Pattern& pattern) {
    return whole(pattern.duration_s / pattern.rhythm.unit_s);
}

std::string repeated_text(const std::string& text, std::size_t steps) {
    std::string whole_text;
    for (std::size_t step = 0; step < steps; ++step) whole_text += text[step % text.size()];
    return whole_text;
}

// Every note from its end to its beginning.
std::string reversed_text(std::string text) {
    std::ranges::reverse(text);  // ==x: the mark of the note is behind it now
    for (std::size_t step = 0; step < text.size(); ++step) {
        std::size_t last = step;
        while (last < text.size() && text[last] == '=') ++last;
        if (last > step) std::swap(text[step], text[last]);
        step = last;
    }
    return text;
}

template <class Point>
void reverse_curve(std::vector<Point>& curve, double end_s) {
    std::ranges::reverse(curve);
    for (Point& point : curve) point.time_s = std::clamp(end_s - point.time_s, 0.0, end_s);
}

void reverse_rhythm(Pattern& pattern) {
    const std::string& text = pattern.rhythm.text;
    const auto steps = text.empty() ? std::nullopt : steps_of(pattern);
    const bool whole_texts = steps && *steps % text.size() == 0;
    if (!text.empty() && !whole_texts && !(steps && *steps <= kMaxRhythmSteps)) {
        pattern = with_drawn_notes(std::move(pattern));
    } else if (!text.empty()) {
        pattern.rhythm.text = reversed_text(whole_texts ? text : repeated_text(text, *steps));
    }
    std::swap(pattern.attack_s, pattern.release_s);
}

FrequencyCurve frequencies_of(const AmplitudeCurve& heights) {
    FrequencyCurve curve;
    for (const AmplitudePoint& point : heights) curve.push_back({point.time_s, point.value});
    return curve;
}

// The curve's part until the end, and behind it the other curve's.
AmplitudeCurve appended(const AmplitudeCurve& first, double first_s, const AmplitudeCurve& second,
                        double second_s) {
    AmplitudeCurve both = part_of_curve(first, 0.0, first_s);
    for (const AmplitudePoint& point : part_of_curve(second, 0.0, second_s)) {
        append_point(both, first_s + point.time_s, point.value);
    }
    return both;
}

// Carriers that are the other ones at another frequency, by this factor; none: they are not.
std::optional<double> factor_between(const std::vector<Carrier>& of,
                                     const std::vector<Carrier>& other) {
    if (of.size() != other.size() || of.empty()) return std::nullopt;
    const double factor = other.front().frequency_hz / of.front().frequency_hz;
    for (std::size_t j = 0; j < of.size(); ++j) {
        const double expected_hz = of[j].frequency_hz * factor;
        if (std::abs(other[j].frequency_hz - expected_hz) > 1e-9 * expected_hz ||
            other[j].weight != of[j].weight || other[j].phase_rad != of[j].phase_rad) {
            return std::nullopt;
        }
    }
    return factor;
}

bool has_bed(const Pattern& pattern) { return pattern.amplitude_g > 0.0; }

// Ticks alone, ready to be joined to such carriers.
Pattern with_bed_of(const Pattern& ticks, const Pattern& bed) {
    Pattern pattern;
    pattern.amplitude_g = 0.0;
    pattern.carriers = bed.carriers;
    pattern.modulation = bed.modulation;
    pattern.duration_s = ticks.duration_s;
    pattern.transients = ticks.transients;
    return pattern;
}

// The rhythm as text where it is one note with ramps throughout, which has none.
void write_out_steady(Pattern& pattern) {
    if (is_steady(pattern) || !pattern.rhythm.text.empty()) return;
    const auto steps =
        static_cast<std::size_t>(std::ceil(pattern.duration_s / limits::kRhythmUnitS.high));
    pattern.rhythm.text = "x" + std::string(std::max<std::size_t>(steps, 1) - 1, '=');
    pattern.rhythm.unit_s = pattern.duration_s / static_cast<double>(pattern.rhythm.text.size());
}

// The notes of both behind each other as text, where they lie on one grid and have the same ramps.
bool join_rhythms(Pattern& first, const Pattern& second) {
    if (is_steady(first) && is_steady(second)) return true;
    if (first.rhythm.text.empty() || second.rhythm.text.empty()) return false;
    const double unit_s = first.rhythm.unit_s;
    if (std::abs(unit_s - second.rhythm.unit_s) > 1e-9 * unit_s) return false;
    if (first.attack_s != second.attack_s || first.release_s != second.release_s) return false;
    const auto steps = steps_of(first);
    if (!steps) return false;
    const std::string& text = first.rhythm.text;
    const bool same = text == second.rhythm.text && first.rhythm.kinds == second.rhythm.kinds;
    if (same && *steps % text.size() == 0) return true;
    const auto more = static_cast<std::size_t>(std::ceil(second.duration_s / unit_s - 1e-9));
    if (*steps + more > kMaxRhythmSteps) return false;
    const auto behind = text_with_kinds_of(first.rhythm, second.rhythm);
    if (!behind) return false;
    first.rhythm.text = repeated_text(text, *steps) + repeated_text(*behind, more);
    return true;
}

// One frequency curve for both, where either has one or their carriers differ.
void join_frequencies(Pattern& first, const Pattern& second) {
    const auto own = [](const Pattern& pattern) {
        return pattern.frequency_curve.empty()
                   ? AmplitudeCurve{{0.0, pattern.carriers.front().frequency_hz}}
                   : heights_of(pattern.frequency_curve);
    };
    const bool same = first.carriers.front().frequency_hz == second.carriers.front().frequency_hz;
    if (same && first.frequency_curve.empty() && second.frequency_curve.empty()) return;
    first.frequency_curve =
        frequencies_of(appended(own(first), first.duration_s, own(second), second.duration_s));
}

// Both curves on the scale of the stronger pattern.
void join_amplitudes(Pattern& first, const Pattern& second) {
    const double full_g = std::max(first.amplitude_g, second.amplitude_g);
    const auto scaled = [&](const Pattern& pattern) {
        AmplitudeCurve curve = pattern.amplitude_curve;
        if (curve.empty()) curve = {{0.0, 1.0}};
        const double share = full_g > 0.0 ? pattern.amplitude_g / full_g : 1.0;
        for (AmplitudePoint& point : curve) point.value *= share;
        return curve;
    };
    const bool flat = first.amplitude_curve.empty() && second.amplitude_curve.empty();
    if (!flat || first.amplitude_g != second.amplitude_g) {
        first.amplitude_curve =
            appended(scaled(first), first.duration_s, scaled(second), second.duration_s);
    }
    first.amplitude_g = full_g;
}

void erase_behind(std::vector<Transient>& transients, double end_s) {
    std::erase_if(transients, [&](const Transient& one) { return one.time_s >= end_s; });
}

// Beginning and end of what sounds.
struct Sounding {
    double from_s = std::numeric_limits<double>::infinity();
    double to_s = 0.0;
};

Sounding sounding(const Pattern& pattern) {
    Sounding found;
    const auto include = [&](double from_s, double to_s) {
        found.from_s = std::min(found.from_s, from_s);
        found.to_s = std::max(found.to_s, std::min(to_s, pattern.duration_s));
    };
    const bool mute = !has_bed(pattern) || std::ranges::all_of(pattern.carriers, [](const auto& c) {
        return c.weight == 0.0;
    });
    AmplitudeCurve line = with_drawn_notes(pattern).amplitude_curve;
    if (line.empty()) line = {{0.0, 1.0}};
    line = part_of_curve(line, 0.0, pattern.duration_s);
    for (std::size_t k = 1; k < line.size() && !mute; ++k) {
        const bool sounds = line[k - 1].value > 0.0 || line[k].value > 0.0;
        if (sounds && line[k].time_s > line[k - 1].time_s) {
            include(line[k - 1].time_s, line[k].time_s);
        }
    }
    for (const Transient& one : pattern.transients) {
        if (one.amplitude_g > 0.0 && one.time_s < pattern.duration_s) {
            include(one.time_s, one.time_s + one.duration_s);
        }
    }
    return found;
}

// Whether notes begin and end at these times as the text has them, so that it can be turned.
bool cuts_between_notes(const Pattern& pattern, std::size_t from, double to_s) {
    const std::string& text = pattern.rhythm.text;
    if (text[from % text.size()] == '=') return false;
    if (pattern.attack_s == 0.0 && pattern.release_s == 0.0) return true;
    if (to_s == pattern.duration_s) return true;  // where its last note is cut now
    const auto to = whole(to_s / pattern.rhythm.unit_s);
    return to && text[*to % text.size()] != '=';
}

Pattern part_of(Pattern pattern, double from_s, double to_s) {
    const auto from = whole(from_s / pattern.rhythm.unit_s);
    const bool on_grid =
        !pattern.rhythm.text.empty() && from && cuts_between_notes(pattern, *from, to_s);
    if (on_grid) {
        std::string& text = pattern.rhythm.text;
        std::ranges::rotate(text, text.begin() + static_cast<std::ptrdiff_t>(*from % text.size()));
    } else {
        pattern = with_drawn_notes(std::move(pattern));
    }
    pattern.amplitude_curve = part_of_curve(pattern.amplitude_curve, from_s, to_s);
    pattern.frequency_curve =
        frequencies_of(part_of_curve(heights_of(pattern.frequency_curve), from_s, to_s));
    for (Transient& one : pattern.transients) one.time_s -= from_s;
    pattern.duration_s = to_s - from_s;
    std::erase_if(pattern.transients, [](const Transient& one) { return one.time_s < 0.0; });
    erase_behind(pattern.transients, pattern.duration_s);
    return pattern;
}

}  // namespace

Expected<Pattern> stretched(Pattern pattern, double factor, StretchOf what) {
    if (what != StretchOf::curves) {
        const bool has_text = !pattern.rhythm.text.empty();
        const bool fits =
            (!has_text || limits::kRhythmUnitS.contains(pattern.rhythm.unit_s * factor)) &&
            limits::kRampS.contains(pattern.attack_s * factor) &&
            limits::kRampS.contains(pattern.release_s * factor);
        if (what == StretchOf::all && !fits) pattern = with_drawn_notes(std::move(pattern));
        if (!pattern.rhythm.text.empty()) pattern.rhythm.unit_s *= factor;
        pattern.attack_s *= factor;
        pattern.release_s *= factor;
    }
    if (what == StretchOf::notes) return pattern;
    const double end_s = what == StretchOf::all ? pattern.duration_s * factor : pattern.duration_s;
    // Held points behind the end are cut before the pattern's rules can mind them.
    for (AmplitudePoint& point : pattern.amplitude_curve) point.time_s *= factor;
    for (FrequencyPoint& point : pattern.frequency_curve) point.time_s *= factor;
    for (Transient& one : pattern.transients) one.time_s *= factor;
    return with_duration(std::move(pattern), end_s);
}

Expected<Pattern> reversed(Pattern pattern) {
    const double end_s = pattern.duration_s;
    reverse_rhythm(pattern);
    reverse_curve(pattern.amplitude_curve, end_s);
    reverse_curve(pattern.frequency_curve, end_s);
    std::ranges::reverse(pattern.transients);
    for (Transient& one : pattern.transients) {
        one.time_s = std::clamp(end_s - one.time_s - one.duration_s, 0.0, end_s);
    }
    return pattern;
}

Expected<Pattern> joined(Pattern first, Pattern second) {
    const double begin_s = first.duration_s;
    if (!has_bed(first)) first = with_bed_of(first, second);
    if (!has_bed(second)) second = with_bed_of(second, first);
    if (first.modulation != second.modulation) {
        return Error{"expected the same modulation of both, as a pattern has one"};
    }
    if (!factor_between(first.carriers, second.carriers)) {
        return Error{"expected the same carriers of both, up to one factor of frequency"};
    }
    if (!is_steady(first) || !is_steady(second)) {
        write_out_steady(first);
        write_out_steady(second);
    }
    if (!join_rhythms(first, second)) {
        first = with_drawn_notes(std::move(first));
        second = with_drawn_notes(std::move(second));
    }
    join_frequencies(first, second);
    join_amplitudes(first, second);
    erase_behind(first.transients, begin_s);
    for (Transient one : second.transients) {
        one.time_s += begin_s;
        first.transients.push_back(one);
    }
    first.duration_s += second.duration_s;
    return first;
}

Expected<Pattern> repeated(const Pattern& pattern, int times) {
    const double end_s = pattern.duration_s * times;
    if (end_s > limits::kDurationS.high) {
        return Error{"expected a duration of at most " + shortest_digits(limits::kDurationS.high) +
                     " s, got " + shortest_digits(end_s) + " s"};
    }
    Pattern all = pattern;
    for (int k = 1; k < times; ++k) {
        Expected<Pattern> more = joined(std::move(all), pattern);
        if (!more) return more.error();
        all = *std::move(more);
    }
    if (times > 1) all.duration_s = end_s;  // a product, not a sum
    return all;
}

Expected<Pattern> mixed(Pattern first, Pattern second) {
    if (!has_bed(first) && has_bed(second)) std::swap(first, second);
    if (has_bed(second)) {
        Pattern as_first = second;
        as_first.amplitude_g = first.amplitude_g;
        as_first.carriers = first.carriers;
        as_first.transients = first.transients;
        if (as_first != first) {
            return Error{
                "expected two patterns that differ in carriers and ticks alone, or one that has "
                "ticks alone (amplitude 0 g)"};
        }
        const double share = second.amplitude_g / first.amplitude_g;
        if (!first.frequency_curve.empty() &&
            first.carriers.front().frequency_hz != second.carriers.front().frequency_hz) {
            return Error{"expected the same first carrier where a frequency curve drives it"};
        }
        for (Carrier carrier : second.carriers) {
            carrier.weight *= share;
            first.carriers.push_back(carrier);
        }
        if (first.carriers.size() > limits::kMaxCarriers) {
            return Error{"expected at most " + std::to_string(limits::kMaxCarriers) +
                         " carriers together"};
        }
    } else if (second.duration_s > first.duration_s) {
        const double end_s = first.duration_s;
        first = with_drawn_notes(std::move(first));
        if (first.amplitude_curve.empty()) first.amplitude_curve = {{0.0, 1.0}};
        first.amplitude_curve = part_of_curve(first.amplitude_curve, 0.0, end_s);
        append_point(first.amplitude_curve, end_s, 0.0);
        first.duration_s = second.duration_s;
    }
    first.transients.insert(first.transients.end(), second.transients.begin(),
                            second.transients.end());
    return first;
}

Expected<Pattern> trimmed(Pattern pattern) {
    const Sounding found = sounding(pattern);
    if (!(found.from_s < found.to_s)) return Error{"expected a pattern that is not silent"};
    if (found.from_s == 0.0 && found.to_s == pattern.duration_s) return pattern;
    return part_of(std::move(pattern), found.from_s, found.to_s);
}

}  // namespace tact
