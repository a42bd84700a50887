#include "app/manual/parts.h"

#include <algorithm>
#include <span>
#include <utility>

#include "app/document/editing.h"
#include "app/report/report.h"
#include "assets/assets.h"
#include "model/evaluation/metric.h"
#include "model/io/formats/write_effect.h"
#include "model/io/set/set_file.h"
#include "model/map/isotonic.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/pattern_set.h"
#include "model/subset/set_subset.h"
#include "model/text/numbers.h"
#include "model/training/training_grid.h"

namespace tact {

Expected<std::string> filled(std::string_view text, std::string_view name, const PartOf& part_of) {
    std::string whole;
    std::size_t at = 0;
    for (;;) {
        const std::size_t open = text.find("{{", at);
        whole += text.substr(at, open - at);
        if (open == text.npos) return whole;
        const auto line = 1 + std::ranges::count(text.substr(0, open), '\n');
        const std::string place = std::string(name) + ":" + std::to_string(line) + ": ";
        const std::size_t close = text.find("}}", open);
        const std::string_view inner = text.substr(open + 2, close - open - 2);
        if (close == text.npos || inner.find('\n') != inner.npos) {
            return Error{place + "expected }} on the line of {{"};
        }
        const std::size_t blank = std::min(inner.find(' '), inner.size());
        const auto part =
            part_of(inner.substr(0, blank), inner.substr(std::min(blank + 1, inner.size())));
        if (!part) return Error{place + part.error().message};
        whole += *part;
        at = close + 2;
    }
}

namespace {

std::string text_html(std::string_view text) {
    while (text.ends_with('\n')) text.remove_suffix(1);
    return "<pre>" + html_escaped(text) + "</pre>";
}

std::string folded_html(const std::string& heading, std::string_view text) {
    return "<details><summary>" + heading + "</summary>\n" + text_html(text) + "</details>\n";
}

}  // namespace

Expected<std::string> example_html(std::string_view file) {
    const std::string path = "manual/examples/" + std::string(file);
    const auto all = assets();
    if (std::ranges::find(all, path, &Asset::path) == all.end()) {
        return Error{"expected the name of a file in assets/manual/examples, got \"" +
                     std::string(file) + "\""};
    }
    return "<p class=\"file\"><code>" + html_escaped(file) + "</code></p>\n" +
           text_html(asset(path)) + "\n";
}

Pattern manual_pattern() {
    Pattern pattern;
    pattern.amplitude_g = 0.8;
    pattern.duration_s = 0.3;
    pattern.carriers[0].frequency_hz = 150.0;
    pattern.amplitude_curve = {{0.0, 0.0}, {0.2, 1.0}, {0.3, 0.0}};
    pattern.transients = {{0.05, 0.7, 150.0, 0.02}};
    return pattern;
}

namespace {

std::string effect_html(const TargetTraits& target) {
    const WrittenEffect written =
        write_effect(target.format, manual_pattern(), {"swell", bundled_actuator(target.map)});
    const std::string heading =
        html_escaped(target.title) + ", <code>swell" + html_escaped(target.ending) + "</code>";
    std::string html = folded_html(heading, written.text);
    if (*target.beside != '\0') {
        html += folded_html("and beside it <code>swell" + html_escaped(target.beside) + "</code>",
                            written.beside);
    }
    return html;
}

}  // namespace

std::string effects_html() {
    std::string html;
    for (const TargetTraits& target : target_formats()) {
        if (is_sampled(target.format)) continue;
        html += (html.empty() ? "" : "\n") + effect_html(target);
    }
    return html;
}

namespace {

Expected<PatternSet> example_set(std::string_view name) {
    const std::string file = "/" + std::string(name) + ".tactspace.json";
    for (const ExampleSet& example : kExampleSets) {
        const std::string_view path = example.path;
        if (path.ends_with(file)) return parse_set(asset(path), std::string(path), {});
    }
    return Error{"expected the name of a set that comes with the program, got \"" +
                 std::string(name) + "\""};
}

std::shared_ptr<const PredictedExample> predicted(PatternSet set) {
    auto made = std::make_shared<PredictedExample>();
    made->pm = predict(own_waveforms(set), set.model)->pm;
    made->space = nonmetric_mds(made->pm, standard_mds_params(set.vibrations.size(), 3));
    made->set = std::move(set);
    return made;
}

std::string pm_text(double pm) { return significant_digits(pm, 4); }

std::string names_text(const PatternSet& set, std::span<const std::size_t> places) {
    std::string text;
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (k > 0) text += k + 1 == places.size() ? " and " : ", ";
        text += set.vibrations[places[k]].name;
    }
    return html_escaped(text);
}

// The pair that is nearest, or the one that is farthest.
std::string pair_text(const PredictedExample& of, bool nearest, bool as_pm) {
    std::pair<std::size_t, std::size_t> best{0, 1};
    for (std::size_t b = 1; b < of.pm.size; ++b) {
        for (std::size_t a = 0; a < b; ++a) {
            const double gain = of.pm(a, b) - of.pm(best.first, best.second);
            if (nearest ? gain < 0.0 : gain > 0.0) best = {a, b};
        }
    }
    if (as_pm) return pm_text(of.pm(best.first, best.second));
    const std::size_t places[] = {best.first, best.second};
    return names_text(of.set, places);
}

Expected<std::string> subset_text(const PredictedExample& of, std::string_view key,
                                  std::string_view count) {
    const auto number = finite_number_in(count);
    if (!number) return Error{"expected how many to pick, got \"" + std::string(count) + "\""};
    const auto answer = most_distinct_subset(
        of.pm, subset_problem(of.set, static_cast<std::size_t>(*number), SubsetObjective::max_min));
    if (!answer) return answer.error();
    if (key == "picked") return names_text(of.set, answer->best.members);
    return pm_text(answer->best.weakest_dissimilarity);
}

Expected<std::string> predicted_number(const PredictedExample& of, std::string_view key,
                                       std::string_view rest) {
    if (key == "stress1") return significant_digits(of.space.stress1, 2);
    if (key == "stress_label") return fit_label(of.space);
    if (key == "nearest" || key == "nearest_pm") return pair_text(of, true, key == "nearest_pm");
    if (key == "farthest" || key == "farthest_pm") {
        return pair_text(of, false, key == "farthest_pm");
    }
    if (key == "picked" || key == "weakest") return subset_text(of, key, rest);
    return Error{"expected a number of a set, got \"" + std::string(key) + "\""};
}

// The first word, and what is behind it.
std::pair<std::string_view, std::string_view> parted(std::string_view text) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    return {text.substr(0, blank), text.substr(std::min(blank + 1, text.size()))};
}

}  // namespace

Expected<std::string> number_text(KnownNumbers& known, std::string_view what) {
    if (what == "metrics") return std::to_string(kMetricCount);
    if (what == "combinations") {
        return grouped_digits(static_cast<std::size_t>(combination_count(10)));
    }
    if (what == "examples") return std::to_string(kExampleSets.size());
    const auto [name, behind] = parted(what);
    const auto [key, rest] = parted(behind);
    auto found = known.find(name);
    if (found == known.end()) {
        Expected<PatternSet> set = example_set(name);
        if (!set) return set.error();
        const std::size_t n = set->vibrations.size();
        if (key == "patterns") return grouped_digits(n);
        if (key == "pairs") return grouped_digits(n * (n - 1) / 2);
        found = known.emplace(std::string(name), predicted(*std::move(set))).first;
    }
    const std::size_t n = found->second->set.vibrations.size();
    if (key == "patterns") return grouped_digits(n);
    if (key == "pairs") return grouped_digits(n * (n - 1) / 2);
    return predicted_number(*found->second, key, rest);
}

}  // namespace tact
