// tactspace separate: what would separate two patterns that people may confuse.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/command_line/commands.h"
#include "app/command_line/interrupt.h"
#include "app/command_line/output.h"
#include "app/command_line/text_table.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/set_waveforms.h"
#include "model/subset/separation.h"
#include "model/text/json_fields.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

struct Change {
    std::size_t place = 0;  // of the pattern that is changed
    Separation separation;
};

struct SeparateResult {
    NamedPair pair;
    double dissimilarity = 0.0;
    double threshold = 0.0;
    std::vector<Change> changes;  // the smallest first
    Labels labels;
};

// Which of the two may be changed: the one asked for, or those that are not locked.
Expected<std::vector<std::size_t>> changeable(const SeparateCommand& command, const PatternSet& set,
                                              NamedPair pair) {
    std::vector<std::size_t> places;
    for (const std::size_t place : {pair.a, pair.b}) {
        const Vibration& vibration = set.vibrations[place];
        const bool wanted =
            command.change.empty() ? !vibration.locked : vibration.name == command.change;
        if (wanted && std::holds_alternative<Pattern>(vibration.source)) places.push_back(place);
    }
    if (!places.empty()) return places;
    if (!command.change.empty()) {
        return Error{
            "--change: expected the one of the pair that is to be changed, a pattern made "
            "of parameters, got \"" +
            command.change + "\""};
    }
    return Error{
        "--pair: both are locked or measured; --change names a locked one to change all "
        "the same"};
}

Expected<std::vector<std::size_t>> others_of(const SeparateCommand& command, const PatternSet& set,
                                             NamedPair pair) {
    std::vector<std::size_t> others;
    for (const std::string& name : command.among) {
        const Expected<std::size_t> place = place_of(set, name);
        if (!place) return Error{"--among: " + place.error().message};
        others.push_back(*place);
    }
    if (others.empty()) return others;
    others.insert(others.end(), {pair.a, pair.b});
    std::ranges::sort(others);
    const auto [first, last] = std::ranges::unique(others);
    others.erase(first, last);
    return others;
}

double threshold_of(const SeparateCommand& command, const Dissimilarity& pm,
                    const std::vector<std::size_t>& others, NamedPair pair) {
    if (command.threshold) return *command.threshold;
    const double share =
        threshold_at(others.empty() ? pm : among(pm, others), command.percent / 100.0);
    return std::max(share, pm(pair.a, pair.b));
}

// Changes are of patterns as they are meant, distances of what is felt of them.
Expected<SeparateResult> separated(const SeparateCommand& command, const FeltSet& sets,
                                   std::stop_token stop) {
    const PatternSet& set = sets.meant;
    const Error stopped{"stopped before the search had come to its end"};
    const Expected<NamedPair> pair = pair_of(set, "--pair", command.pair);
    if (!pair) return pair.error();
    const auto places = changeable(command, set, *pair);
    if (!places) return places.error();
    const auto others = others_of(command, set, *pair);
    if (!others) return others.error();
    PredictOptions predicting;
    predicting.threads = command.common.threads;
    predicting.stop = stop;
    predicting.progress = progress_line("comparing pairs");
    const auto prediction =
        predict(model_waveforms(sets.felt, predicting.threads), set.model, predicting);
    if (!prediction) return stopped;
    SeparateResult result{*pair,
                          prediction->pm(pair->a, pair->b),
                          threshold_of(command, prediction->pm, *others, *pair),
                          {},
                          sets.labels};
    SeparationOptions options;
    options.from = *others;
    if (!command.threshold) options.share = command.percent / 100.0;
    options.threads = command.common.threads;
    options.stop = stop;
    if (sets.labels.by) {
        options.felt = [&by = *sets.labels.by](const Waveform& meant) {
            return rendering(by, meant).waveform;
        };
    }
    for (const std::size_t place : *places) {
        options.progress = progress_line("changing " + set.vibrations[place].name);
        const auto found = separations(set, *prediction, place, result.threshold, options);
        if (!found) return stopped;
        for (const Separation& one : *found) result.changes.push_back({place, one});
    }
    std::ranges::stable_sort(result.changes, {},
                             [](const Change& change) { return change.separation.steps; });
    return result;
}

nlohmann::json json_of(const SeparateResult& result, const std::vector<std::string>& names) {
    nlohmann::json json{{"pair", {names[result.pair.a], names[result.pair.b]}},
                        {"dissimilarity", result.dissimilarity},
                        {"threshold", result.threshold},
                        {"changes", nlohmann::json::array()}};
    add_labels(json, result.labels);
    for (const auto& [place, one] : result.changes) {
        json["changes"].push_back(
            {{"pattern", names[place]},
             {"parameter", traits(one.parameter).key},
             {"from", one.from},
             {"to", one.to},
             {"felt_steps", one.steps},
             {"nearest", {{"pattern", names[one.nearest_to]}, {"dissimilarity", one.nearest}}}});
    }
    return json;
}

std::string text_of(const SeparateResult& result, const std::vector<std::string>& names) {
    std::string text = text_of(result.labels) + "PM of " + names[result.pair.a] + " and " +
                       names[result.pair.b] + "  " + six_digits(result.dissimilarity) +
                       "\nto be exceeded  " + six_digits(result.threshold) + "\n\n";
    if (result.changes.empty()) {
        return text +
               "no change of a single number is enough: change the rhythm, or add a carrier\n";
    }
    std::vector<TextRow> rows{
        {"pattern", "parameter", "from", "to", "felt steps", "then", "closest"}};
    for (const auto& [place, one] : result.changes) {
        const ParameterTraits& about = traits(one.parameter);
        const std::string unit = *about.unit == '\0' ? "" : std::string(", ") + about.unit;
        rows.push_back({names[place], about.name + unit, six_digits(one.from), six_digits(one.to),
                        fixed_digits(one.steps, 1), six_digits(one.nearest),
                        names[one.nearest_to]});
    }
    return text + aligned(rows) +
           "\na felt step is the least change that people are taken to feel: 1.5 dB, 20 % of a "
           "frequency; felt_steps in the set file changes that\n";
}

}  // namespace

Expected<Done> run(const SeparateCommand& command) {
    const Interrupt interrupt;
    if (const auto writable = writable_result(command.out); !writable) return writable;
    const Expected<FeltSet> sets = load_felt(command.common);
    if (!sets) return sets.error();
    if (const auto pair = need_a_pair(sets->meant, command.common); !pair) return pair.error();
    const Expected<SeparateResult> result = separated(command, *sets, interrupt.token());
    if (!result) return result.error();
    const std::vector<std::string> names = names_of(sets->meant);
    return write_result(command.out, [&](std::ostream& stream) {
        stream << (command.common.json ? text_of_json(json_of(*result, names)) + "\n"
                                       : text_of(*result, shown_texts(names)));
    });
}

}  // namespace tact
