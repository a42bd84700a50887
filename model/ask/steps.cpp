#include "model/ask/steps.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/ask/even_path.h"
#include "model/morph/morph.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr int kNarrowings = 7;
constexpr int kScalings = 3;
constexpr double kAsMeant = 0.005;  // of unevenness: the scale was right
constexpr int kHalfWindow = 4;      // places to either side, in a window
constexpr double kAimedAt = 0.015;  // of the tolerance some is left for what is coarse

using Layers = std::vector<std::vector<double>>;
using Distances = std::vector<std::vector<double>>;  // of a layer's places to the next one's

// Asks for all pairs of neighbouring layers at once; empty when stopped.
Distances distances_of(PathDistances& path, const Layers& layers) {
    std::vector<double> all;
    PathDistances::Pairs pairs;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        all.insert(all.end(), layers[layer].begin(), layers[layer].end());
        if (layer + 1 == layers.size()) break;
        for (const double a : layers[layer]) {
            for (const double b : layers[layer + 1]) pairs.emplace_back(a, b);
        }
    }
    if (!path.prepare(all)) return {};
    const std::vector<double> flat = path.of(pairs, false);
    Distances distances;
    auto at = flat.begin();
    for (std::size_t layer = 0; layer + 1 < layers.size(); ++layer) {
        const auto size =
            static_cast<std::ptrdiff_t>(layers[layer].size() * layers[layer + 1].size());
        distances.emplace_back(at, at + size);
        at += size;
    }
    return distances;
}

std::vector<double> exact_neighbours(PathDistances& path, const std::vector<double>& shares) {
    return path.of(neighbours_of(shares), true);
}

// Even parts, where no distance is known by which they could be placed.
std::vector<double> evenly(std::size_t count) {
    std::vector<double> shares;
    for (std::size_t k = 0; k < count; ++k) {
        shares.push_back(static_cast<double>(k) / static_cast<double>(count - 1));
    }
    return shares;
}

std::vector<double> picked_of(const Layers& layers, const std::vector<std::size_t>& chosen) {
    std::vector<double> shares;
    for (std::size_t k = 0; k < chosen.size(); ++k) shares.push_back(layers[k][chosen[k]]);
    return shares;
}

std::vector<double> first_places(const PathOverview& overview, std::size_t count) {
    Layers layers(count, overview.shares);
    layers.front() = {0.0};
    layers.back() = {1.0};
    const std::size_t n = overview.shares.size();
    const auto row_of = [&](std::size_t layer, std::size_t i) {
        return layer == 0 ? 0 : layer + 1 == count ? n - 1 : i;
    };
    const EvenPath way = even_path(
        layers,
        [&](std::size_t layer, std::size_t i, std::size_t j) {
            return overview.coarse[row_of(layer, i) * n + row_of(layer + 1, j)];
        },
        kAimedAt);
    return way.chosen.empty() ? evenly(count) : picked_of(layers, way.chosen);
}

// How far it is from each to what was looked at beside it.
std::vector<double> grains_of(const PathOverview& overview, const std::vector<double>& shares) {
    std::vector<double> grains;
    for (const double share : shares) {
        const auto above = std::ranges::upper_bound(overview.shares, share);
        const auto below = std::ranges::lower_bound(overview.shares, share);
        const double high = above == overview.shares.end() ? 1.0 : *above;
        const double low = below == overview.shares.begin() ? 0.0 : *(below - 1);
        grains.push_back(std::max(high - share, share - low) / kHalfWindow);
    }
    return grains;
}

// Places around each, nearer to it each round.
Layers windows_around(const std::vector<double>& shares, const std::vector<double>& grains) {
    Layers layers;
    for (std::size_t k = 0; k < shares.size(); ++k) {
        layers.emplace_back();
        const bool is_end = k == 0 || k + 1 == shares.size();
        const int reach = is_end ? 0 : kHalfWindow;
        for (int step = -reach; step <= reach; ++step) {
            const double share = shares[k] + step * grains[k];
            if (is_end || (share > 0.0 && share < 1.0)) layers.back().push_back(share);
        }
    }
    return layers;
}

// Better places near these, by coarse distances scaled to what is known exactly; empty when
// stopped.
std::vector<double> narrowed(PathDistances& path, const std::vector<double>& shares,
                             const std::vector<double>& exact, const std::vector<double>& grains) {
    const Layers layers = windows_around(shares, grains);
    const Distances coarse = distances_of(path, layers);
    if (coarse.empty()) return {};
    std::vector<double> correction;
    for (std::size_t k = 0; k + 1 < shares.size(); ++k) {
        const double here = path.of({{shares[k], shares[k + 1]}}, false).front();
        correction.push_back(here > 0.0 ? exact[k] / here : 1.0);
    }
    const EvenPath way = even_path(
        layers,
        [&](std::size_t layer, std::size_t i, std::size_t j) {
            return correction[layer] * coarse[layer][i * layers[layer + 1].size() + j];
        },
        kAimedAt);
    return way.chosen.empty() ? shares : picked_of(layers, way.chosen);
}

struct Placed {
    std::vector<double> shares;
    std::vector<double> exact;
    double uneven = std::numeric_limits<double>::infinity();
};

// The most even of all rounds; its shares are empty when stopped.
Placed placed(PathDistances& path, const StepsQuestion& question, const PathOverview& overview,
              const std::function<void(double)>& progress) {
    Placed best;
    std::vector<double> shares = first_places(overview, question.count);
    double finer = 1.0;
    for (int round = 0; round < kNarrowings; ++round, finer *= 0.4) {
        if (!path.prepare(shares)) return {};
        const std::vector<double> exact = exact_neighbours(path, shares);
        const double uneven = unevenness(exact);
        if (best.shares.empty() || uneven < best.uneven) best = {shares, exact, uneven};
        if (progress) progress(0.4 + 0.4 * (round + 1) / kNarrowings);
        if (uneven <= 2.0 * kAimedAt || question.count == 2) break;
        std::vector<double> grains = grains_of(overview, best.shares);
        for (double& grain : grains) grain *= finer;
        shares = narrowed(path, best.shares, best.exact, grains);
        if (shares.empty()) return {};
    }
    return best;
}

// NC, OC and PM of the set of these patterns alone; none when stopped.
std::optional<Prediction> predicted(const StepsQuestion& question, const StepsOptions& options,
                                    const std::vector<Pattern>& patterns) {
    std::vector<Waveform> waveforms;
    std::size_t longest = 0;
    for (const Pattern& pattern : patterns) {
        waveforms.push_back(render(pattern));
        longest = std::max(longest, waveforms.back().samples_g.size());
    }
    for (Waveform& waveform : waveforms) waveform = padded(std::move(waveform), longest);
    PredictOptions predicting;
    predicting.threads = options.threads;
    predicting.stop = options.stop;
    return predict(waveforms, question.model, predicting);
}

struct Told {
    EvenSteps steps;
    double largest_nc = 0.0;
    double largest_oc = 0.0;
};

// What is told of these places: the numbers of the set itself, by whose maxima the path is scaled
// from then on. None when stopped.
std::optional<Told> told(PathDistances& path, const StepsQuestion& question,
                         const StepsOptions& options, const std::vector<double>& shares) {
    Told all;
    EvenSteps& steps = all.steps;
    steps.shares = shares;
    for (const double share : shares) steps.patterns.push_back(path.at(share));
    const auto prediction = predicted(question, options, steps.patterns);
    if (!prediction) return std::nullopt;
    all.largest_nc = *std::ranges::max_element(prediction->nc.condensed);
    all.largest_oc = *std::ranges::max_element(prediction->oc.condensed);
    path.scale_to(all.largest_nc, all.largest_oc);
    const auto apart = [&](std::size_t i, std::size_t j) {
        return path.sum_of(prediction->nc(i, j), prediction->oc(i, j));
    };
    const std::size_t last = shares.size() - 1;
    for (std::size_t k = 0; k < last; ++k) {
        steps.apart.push_back(apart(k, k + 1));
        steps.pm.push_back(prediction->pm(k, k + 1));
    }
    steps.ends_apart = apart(0, last);
    steps.uneven = unevenness(steps.apart);
    steps.largest_pm = *std::ranges::max_element(prediction->pm.condensed);
    return all;
}

}  // namespace

std::optional<EvenSteps> even_steps(const StepsQuestion& question, const StepsOptions& options) {
    PathDistances path(question, options);
    PathOverview overview;
    if (!look_over(path, overview)) return std::nullopt;
    if (options.progress) options.progress(0.4);
    std::optional<Told> best;
    // Once more by the maxima of the set that was found, where they are not those of the way.
    for (int scaling = 0; scaling < kScalings; ++scaling) {
        if (scaling > 0) measure(path, overview);
        const Placed found = placed(path, question, overview, options.progress);
        if (found.shares.empty()) return std::nullopt;
        auto now = told(path, question, options, found.shares);
        if (!now) return std::nullopt;
        const bool is_as_meant = std::abs(now->steps.uneven - found.uneven) <= kAsMeant;
        if (!best || now->steps.uneven < best->steps.uneven) best = std::move(now);
        if (is_even(best->steps) || is_as_meant) break;
    }
    if (!is_even(best->steps)) {
        path.scale_to(best->largest_nc, best->largest_oc);
        best->steps.jump = largest_jump(path, overview);
    }
    if (options.stop.stop_requested()) return std::nullopt;
    if (options.progress) options.progress(1.0);
    return best->steps;
}

namespace {

std::string numbers_of(const Pattern& pattern) {
    std::string list;
    for (const PatternParameter parameter : kPatternParameters) {
        if (!value_of(pattern, parameter)) continue;
        list += std::string(list.empty() ? "" : ", ") + traits(parameter).key;
    }
    return list;
}

}  // namespace

nlohmann::json json_of(const EvenSteps& steps, const std::vector<std::string>& names) {
    nlohmann::json json{{"patterns", names},      {"shares", steps.shares},
                        {"apart", steps.apart},   {"ends_apart", steps.ends_apart},
                        {"pm", steps.pm},         {"largest_pm", steps.largest_pm},
                        {"uneven", steps.uneven}, {"even", is_even(steps)}};
    if (steps.jump) {
        json["jump"] = {{"share", steps.jump->share}, {"distance", steps.jump->distance}};
    }
    return json;
}

std::optional<StepMeasure> step_measure_named(std::string_view name) {
    for (const StepMeasure measure : {StepMeasure::pm, StepMeasure::nc, StepMeasure::oc}) {
        if (name == kStepMeasures[static_cast<std::size_t>(measure)]) return measure;
    }
    return std::nullopt;
}

Expected<Pattern> end_of_way(const Pattern& from, const Pattern& to, const std::string& parameter) {
    if (parameter.empty()) return to;
    for (const PatternParameter one : kPatternParameters) {
        if (traits(one).key != parameter) continue;
        if (const auto end = end_along(from, to, one)) return *end;
    }
    return Error{"expected a number that both patterns have (" + numbers_of(from) + "), got \"" +
                 parameter + "\""};
}

namespace {

bool ends_at(const PatternSet& set, std::size_t to, const EvenSteps& steps) {
    const auto* pattern = std::get_if<Pattern>(&set.vibrations[to].source);
    return pattern != nullptr && *pattern == steps.patterns.back();
}

}  // namespace

std::vector<Vibration> vibrations_between(const PatternSet& set, std::size_t from, std::size_t to,
                                          const EvenSteps& steps) {
    const std::string way = set.vibrations[from].name + " to " + set.vibrations[to].name;
    const std::size_t count = steps.patterns.size();
    const std::size_t end = ends_at(set, to, steps) ? count - 1 : count;
    PatternSet with = set;
    std::vector<Vibration> result;
    for (std::size_t k = 1; k < end; ++k) {
        Vibration step;
        step.name = unused_name(with, way + " " + std::to_string(k + 1));
        step.source = steps.patterns[k];
        step.note = "Step " + std::to_string(k + 1) + " of " + std::to_string(count) + " from " +
                    set.vibrations[from].name + " to " + set.vibrations[to].name + ", at " +
                    std::to_string(std::lround(100.0 * steps.shares[k])) + " % of the way";
        with.vibrations.push_back(step);
        result.push_back(std::move(step));
    }
    return result;
}

PatternSet set_of_steps(const PatternSet& set, std::size_t from, std::size_t to,
                        const EvenSteps& steps) {
    PatternSet result;
    result.name = set.vibrations[from].name + " to " + set.vibrations[to].name;
    result.duration_s = set.duration_s;
    result.model = set.model;
    result.model_origin = set.model_origin;
    result.study = set.study;
    result.felt_steps = set.felt_steps;
    result.vibrations.push_back(set.vibrations[from]);
    for (Vibration& step : vibrations_between(set, from, to, steps)) {
        result.vibrations.push_back(std::move(step));
    }
    if (ends_at(set, to, steps)) result.vibrations.push_back(set.vibrations[to]);
    return result;
}

namespace {}  // namespace

double unevenness(const std::vector<double>& values) {
    if (values.empty()) return 0.0;
    const auto [least, most] = std::ranges::minmax_element(values);
    if (*least > 0.0) return *most / *least - 1.0;
    return *most > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

bool is_even(const EvenSteps& steps) { return steps.uneven <= kEvenWithin; }

std::string sentence_on(const StepsQuestion& question, const EvenSteps& steps) {
    const char* measure = question.measure == StepMeasure::nc   ? "NC"
                          : question.measure == StepMeasure::oc ? "OC"
                                                                : "continuous PM";
    const std::string in = std::string(" in ") + measure;
    if (!(steps.ends_apart > 0.0)) {
        return "The two do not differ" + in + ": every step between them is the same.";
    }
    if (is_even(steps)) {
        return "Neighbours are equally far" + in + ", within " + percent(steps.uneven) + ".";
    }
    std::string text =
        "There are no " + std::to_string(steps.patterns.size()) + " even steps" + in +
        ": neighbours differ by " +
        (std::isfinite(steps.uneven) ? percent(steps.uneven) : std::string("any factor")) +
        " at best.";
    if (!steps.jump) return text;
    const std::string far = percent(steps.jump->distance / steps.ends_apart);
    const double smallest = *std::ranges::min_element(steps.apart);
    if (steps.jump->distance >= 0.5 * smallest) {
        text += " At " + percent(steps.jump->share) + " of the way the path jumps by " + far +
                " of the distance of the two.";
    } else {
        text += " The path nowhere jumps by more than " + far + " of the distance of the two, at " +
                percent(steps.jump->share) +
                " of the way: it turns, so that neighbours lie no more evenly.";
    }
    for (const std::string& what : morph_jumps(question.from, question.to)) {
        text += " At half of the way " + what + " changes at once.";
    }
    return text;
}

std::string pm_sentence_on(const EvenSteps& steps) {
    const auto [least, most] = std::ranges::minmax_element(steps.pm);
    return "PM of neighbours, in the set of these patterns: " + significant_digits(*least, 3) +
           " to " + significant_digits(*most, 3) + ", of at most " +
           significant_digits(steps.largest_pm, 3) +
           ". PM counts ranks, so neighbours cannot be equal in it.";
}

std::optional<Pattern> end_along(const Pattern& from, const Pattern& to,
                                 PatternParameter parameter) {
    const auto value = value_of(to, parameter);
    if (!value || !value_of(from, parameter)) return std::nullopt;
    return with_value(from, parameter, *value);
}

}  // namespace tact
