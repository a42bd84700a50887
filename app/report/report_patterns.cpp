// The table of a report: each pattern by itself.

#include <algorithm>

#include "app/report/report.h"
#include "model/pattern/pattern_parameter.h"
#include "model/set/layers.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::size_t kMostPlayedBytes = 2'000'000;  // more, and pages are slow to open
constexpr std::size_t kMostEagerPlayers = 50;        // browsers refuse many that are ready to play

struct ShownPattern {
    std::size_t place = 0;
    Waveform wave;
    WaveThumbnail thumbnail;
    bool has_player = false;
};

struct ShownWaves {
    std::vector<ShownPattern> all;  // ascending
    std::size_t players = 0;
    double reach_g = 0.0;  // of the strongest
    double end_s = 0.0;    // of the longest
};

// Places in the order in which they are given room: the picked ones first.
std::vector<std::size_t> by_weight(const Report& report) {
    std::vector<std::size_t> places(report.felt.vibrations.size());
    for (std::size_t k = 0; k < places.size(); ++k) places[k] = k;
    std::ranges::stable_sort(places, std::ranges::greater{},
                             [&](std::size_t k) { return is_picked(report, k); });
    return places;
}

ShownWaves waves_of(const Report& report) {
    ShownWaves shown;
    std::size_t bytes = 0;
    for (const std::size_t place : by_weight(report)) {
        if (shown.all.size() == kMostListedPatterns) break;
        ShownPattern one{place, waveform_of(report.felt.vibrations[place]), {}, false};
        shown.reach_g = std::max(shown.reach_g, peak_g(one.wave));
        shown.end_s = std::max(shown.end_s, duration_s(one.wave));
        bytes += player_bytes(one.wave);
        one.has_player = bytes <= kMostPlayedBytes;
        if (one.has_player) ++shown.players;
        shown.all.push_back(std::move(one));
    }
    std::ranges::sort(shown.all, {}, &ShownPattern::place);
    for (ShownPattern& one : shown.all) {
        one.thumbnail = thumbnail_html(one.wave, shown.reach_g, shown.end_s);
    }
    return shown;
}

std::string drawn_words(const Pattern& pattern) {
    std::string words;
    const auto add = [&](std::size_t count, const char* what) {
        if (count == 0) return;
        words += (words.empty() ? "" : ", ") + std::to_string(count) + " " + what;
    };
    add(pattern.amplitude_curve.size(), "points of amplitude");
    add(pattern.frequency_curve.size(), "points of frequency");
    add(pattern.transients.size(), pattern.transients.size() == 1 ? "transient" : "transients");
    return words;
}

// Numbers in use: those that are 0 (a ramp, a modulation) are left out, and so is a rhythm's unit
// without a rhythm.
std::string recording_html(const Measurement& measured) {
    return measured.synthetic ? "<b>synthetic</b>: computed, not recorded" : "recorded";
}

std::string parameters_html(const Pattern& pattern) {
    std::string html;
    const auto add = [&](const std::string& words) {
        html += (html.empty() ? "" : " \u00B7 ") + html_escaped(words);
    };
    for (const PatternParameter parameter : kPatternParameters) {
        const auto value = value_of(pattern, parameter);
        const bool is_idle =
            parameter == PatternParameter::rhythm_unit && pattern.rhythm.text.empty();
        if (!value || *value == 0.0 || is_idle) continue;
        const ParameterTraits& about = traits(parameter);
        const std::string unit = about.unit;
        add(std::string(about.name) + " " + significant_digits(*value, 4) +
            (unit.empty() ? "" : " " + unit));
    }
    if (!pattern.rhythm.text.empty()) add("rhythm " + pattern.rhythm.text);
    for (const auto& [letter, kind] : pattern.rhythm.kinds) {
        if (pattern.rhythm.text.find(letter) == std::string::npos) continue;
        add(std::string(1, letter) + " " + significant_digits(100.0 * kind.velocity, 3) + " % at " +
            significant_digits(kind.pitch, 4) + " x");
    }
    if (is_drawn(pattern)) add(drawn_words(pattern));
    add(significant_digits(pattern.duration_s, 3) + " s");
    return html;
}

std::string parameters_html(const std::variant<Pattern, Measurement>& source) {
    const auto* pattern = std::get_if<Pattern>(&source);
    return pattern != nullptr ? parameters_html(*pattern)
                              : recording_html(std::get<Measurement>(source));
}

// A line a layer.
std::string layers_html(const LayeredPattern& layered) {
    std::string html;
    for (std::size_t k = 0; k < layered.layers.size(); ++k) {
        const Layer& layer = layered.layers[k];
        html += (html.empty() ? "<b>" : "<br><b>") + html_escaped(name_of(layered, k)) + "</b>";
        if (!sounds(layered, k)) html += " (does not sound)";
        if (layer.gain != 1.0) html += " times " + significant_digits(layer.gain, 3);
        if (layer.offset_s != 0.0) {
            html += " from " + significant_digits(layer.offset_s, 4) + " s";
        }
        html += ": " + parameters_html(layer.source);
    }
    return html;
}

std::string parameters_html(const Vibration& vibration) {
    if (const auto* layered = std::get_if<LayeredPattern>(&vibration.source)) {
        return layers_html(*layered);
    }
    if (const auto* pattern = std::get_if<Pattern>(&vibration.source)) {
        return parameters_html(*pattern);
    }
    return recording_html(std::get<Measurement>(vibration.source));
}

std::string verdict_html(PairVerdict verdict) {
    // Classes of the page's styles.
    constexpr const char* kClasses[] = {"same", "hard", "clear", "shape"};
    return std::string("<span class=\"verdict ") + kClasses[static_cast<std::size_t>(verdict)] +
           "\">" + words_of(verdict) + "</span>";
}

std::string nearest_html(const Report& report, std::size_t place) {
    const NearestNeighbour& nearest = report.alike.closer.nearest[place];
    if (!nearest.exists_for(place)) return "";
    return name_html(report, nearest.place) + " <span class=\"value\">" +
           value_text(report, nearest.dissimilarity) + "</span>";
}

std::string nearest_verdict(const Report& report, std::size_t place) {
    if (std::ranges::find(report.unfelt, place) != report.unfelt.end()) {
        return "<span class=\"verdict hard\">not felt</span>";
    }
    const std::size_t nearest = report.alike.closer.nearest[place].place;
    return nearest == place ? "" : verdict_html(pair_verdict(report.set, place, nearest));
}

// Where it is from; how it was read is said once for all (report_assumed.cpp).
std::string note_html(const Vibration& vibration) {
    const std::string first = first_sentence(vibration.note);
    return first.empty() ? "" : "<div class=\"origin\">" + html_escaped(first) + "</div>";
}

std::string about_the_table(const ShownWaves& shown) {
    const bool has_light = std::ranges::any_of(
        shown.all, [](const ShownPattern& one) { return one.thumbnail.is_light; });
    std::string html = "<p>The verdict is on a pattern and its nearest neighbour.";
    for (const PairVerdict verdict : kPairVerdicts) {
        html += " " + verdict_html(verdict) + ": " + html_escaped(sentence_of(verdict));
    }
    html += "</p>\n<p class=\"dim\">Waveforms: up to " + significant_digits(shown.reach_g, 3) +
            " g and " + significant_digits(shown.end_s, 3) + " s." +
            (has_light ? " Lighter with an outline: modulated faster than can be drawn." : "") +
            "<span class=\"screen\"> ";
    if (shown.players == 0) {
        return html + "Players are left out: they would make the page too large.</span></p>\n";
    }
    if (shown.players < shown.all.size()) {
        html += "Players of " + grouped_digits(shown.players) +
                " patterns, the picked ones first: more would make the page too large. ";
    }
    return html + "Players: at " + significant_digits(kPlayerRateHz, 4) +
           " Hz and 16 bits, the strongest pattern at full scale; for an actuator, not for "
           "ears.</span></p>\n";
}

}  // namespace

std::string first_sentence(const std::string& note) {
    const std::size_t end = note.find(". ");
    return end == std::string::npos ? note : note.substr(0, end + 1);
}

std::string patterns_section(const Report& report) {
    const ShownWaves shown = waves_of(report);
    HtmlTable table{
        {{"#", true}, {"pattern"}, {"waveform"}, {"nearest"}, {"verdict"}}, {}, "patterns"};
    for (const ShownPattern& one : shown.all) {
        const std::size_t k = one.place;
        const Vibration& vibration = report.set.vibrations[k];
        std::string wave = one.thumbnail.html;
        if (one.has_player) {
            wave += "<div class=\"screen\">" +
                    player_html(one.wave, shown.reach_g, vibration.name,
                                shown.players <= kMostEagerPlayers) +
                    "</div>";
        }
        table.rows.push_back({std::to_string(k + 1),
                              name_html(report, k) + "<div class=\"numbers\">" +
                                  parameters_html(vibration) + "</div>" + note_html(vibration),
                              wave, nearest_html(report, k), nearest_verdict(report, k)});
    }
    return html_section("patterns", "Patterns",
                        about_the_table(shown) + html_of(table) +
                            and_more(report.set.vibrations.size() - shown.all.size(), "patterns"));
}

}  // namespace tact
