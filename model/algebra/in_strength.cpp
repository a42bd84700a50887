// Edits of strength, pitch and detail, which leave times where they are, and the grid of notes.
#include <algorithm>
#include <cmath>

#include "model/algebra/algebra_parts.h"
#include "model/algebra/drawn_notes.h"
#include "model/common/portable.h"
#include "model/design_space/spectral_lines.h"
#include "model/pattern/curves.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

void scale(Pattern& pattern, double factor) {
    pattern.amplitude_g *= factor;
    for (Transient& one : pattern.transients) one.amplitude_g *= factor;
}

double peak_of(const Pattern& pattern) {
    double peak_g = 0.0;
    for (const double sample_g : render(pattern).samples_g) {
        peak_g = std::max(peak_g, std::abs(sample_g));
    }
    return peak_g;
}

// The notes on a grid, as text; a note that begins where another one does already, takes its place.
std::string on_grid(const Pattern& pattern, double grid_s) {
    const auto steps =
        static_cast<std::size_t>(std::max(1.0, std::ceil(pattern.duration_s / grid_s - 1e-9)));
    std::string text(steps, '-');
    Rhythm rhythm = pattern.rhythm;
    const auto nearest = [&](double t_s) {
        return static_cast<std::size_t>(std::round(t_s / grid_s));
    };
    for (const Note& note : notes(pattern.rhythm, pattern.duration_s)) {
        const std::size_t first = std::min(nearest(note.onset_s), steps - 1);
        const std::size_t end = std::clamp(nearest(note.onset_s + note.length_s), first + 1, steps);
        text = with_note(std::move(text), first, end - 1);
        // It has a mark already, so that there is one.
        text[first] = mark_for(rhythm, {note.velocity, note.pitch}).value();
    }
    return text;
}

// The shortest beginning of a text that the rest repeats: all but the longest beginning that is its
// end, too (Knuth, Morris & Pratt 1977).
std::string shortest_period(const std::string& text) {
    std::vector<std::size_t> border(text.size(), 0);
    for (std::size_t step = 1; step < text.size(); ++step) {
        std::size_t length = border[step - 1];
        while (length > 0 && text[step] != text[length]) length = border[length - 1];
        border[step] = text[step] == text[length] ? length + 1 : 0;
    }
    return text.substr(0, text.size() - border.back());
}

}  // namespace

Expected<Pattern> faded(Pattern pattern, double in_s, double out_s) {
    const double end_s = pattern.duration_s;
    if (in_s > end_s || out_s > end_s) {
        return Error{"expected at most the pattern's " + shortest_digits(end_s) + " s, got " +
                     shortest_digits(std::max(in_s, out_s)) + " s"};
    }
    AmplitudeCurve fade;
    if (in_s > 0.0) append_point(fade, 0.0, 0.0);
    append_point(fade, in_s, 1.0);
    append_point(fade, end_s - out_s, 1.0);
    if (out_s > 0.0) append_point(fade, end_s, 0.0);
    pattern.amplitude_curve = product(fade, pattern.amplitude_curve, end_s);
    for (Transient& one : pattern.transients) {
        one.amplitude_g *= value_at(fade, one.time_s + 0.5 * one.duration_s);
    }
    return pattern;
}

Expected<Pattern> normalised(Pattern pattern, double peak_g) {
    const double now_g = peak_of(pattern);
    if (now_g == 0.0) return Error{"expected a pattern that is not silent"};
    scale(pattern, peak_g / now_g);
    return pattern;
}

Expected<Pattern> felt_at(Pattern pattern, double above_threshold_db,
                          const PhysiologyTables& tables) {
    if (!pattern.frequency_curve.empty() || has_pitches(pattern.rhythm)) {
        return Error{
            "expected carriers of one frequency each, without a frequency curve and pitches of "
            "notes"};
    }
    // Lines are those of what is not drawn: where the curve is highest.
    Pattern strongest = pattern;
    if (!pattern.amplitude_curve.empty()) {
        strongest.amplitude_g *= peak_value(pattern.amplitude_curve);
    }
    strongest.amplitude_curve.clear();
    strongest.transients.clear();
    const auto now_db = detectability_db(spectral_lines(strongest), tables);
    if (!now_db || !std::isfinite(*now_db)) {
        return Error{"expected a carrier that some receptor feels"};
    }
    scale(pattern, portable::pow(10.0, (above_threshold_db - *now_db) / 20.0));
    return pattern;
}

Expected<Pattern> quantised(Pattern pattern, double grid_s) {
    if (pattern.rhythm.text.empty() && pattern.transients.empty()) {
        return Error{"expected notes or ticks, got neither"};
    }
    if (!pattern.rhythm.text.empty()) {
        std::string text = shortest_period(on_grid(pattern, grid_s));
        if (text.size() > kMaxRhythmSteps) {
            return Error{
                "expected a grid of at least " +
                shortest_digits(pattern.duration_s / static_cast<double>(kMaxRhythmSteps)) +
                " s, as a rhythm has at most " + grouped_digits(kMaxRhythmSteps) + " steps"};
        }
        pattern.rhythm.text = std::move(text);
        pattern.rhythm.unit_s = grid_s;
    }
    for (Transient& one : pattern.transients) {
        const double last_s = std::floor(pattern.duration_s / grid_s) * grid_s;
        one.time_s = std::min(std::round(one.time_s / grid_s) * grid_s, last_s);
    }
    return pattern;
}

Expected<Pattern> transposed(Pattern pattern, double factor) {
    for (Carrier& carrier : pattern.carriers) carrier.frequency_hz *= factor;
    for (FrequencyPoint& point : pattern.frequency_curve) point.frequency_hz *= factor;
    for (Transient& one : pattern.transients) one.frequency_hz *= factor;
    return pattern;
}

Expected<Pattern> notes_found(const Pattern& pattern) {
    if (auto found = with_found_notes(pattern)) return *std::move(found);
    return Error{"expected curves that are flat between jumps, on one grid of 1 ms or more"};
}

Expected<Pattern> thinned_curves(Pattern pattern, double percent) {
    const double share = percent / 100.0;
    if (pattern.amplitude_curve.size() > 2) {
        thin(pattern.amplitude_curve, pattern.amplitude_curve.size(), share);
    }
    if (pattern.frequency_curve.size() > 2) {
        const double highest_hz =
            std::ranges::max_element(pattern.frequency_curve, {}, &FrequencyPoint::frequency_hz)
                ->frequency_hz;
        thin(pattern.frequency_curve, pattern.frequency_curve.size(), share * highest_hz);
    }
    return pattern;
}

}  // namespace tact
