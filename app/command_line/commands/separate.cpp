// tactspace separate: what would separate two patterns that people may confuse.

#include <nlohmann/json.hpp>
#include <ostream>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "model/ask/parted_pair.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

// Which of the two may be changed: the one asked for, or those that are not locked.
Expected<std::vector<std::size_t>> changeable(const SeparateCommand& command, const PatternSet& set,
                                              NamedPair pair) {
    std::vector<std::size_t> places = changeable_of(set, pair.a, pair.b, command.change);
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

Expected<std::vector<std::size_t>> others_of(const SeparateCommand& command,
                                             const PatternSet& set) {
    std::vector<std::size_t> others;
    for (const std::string& name : command.among) {
        const Expected<std::size_t> place = place_of(set, name);
        if (!place) return Error{"--among: " + place.error().message};
        others.push_back(*place);
    }
    return others;
}

// Changes are of patterns as they are meant, distances of what is felt of them.
Expected<PartedPair> parted(const SeparateCommand& command, const FeltSet& sets,
                            std::stop_token stop) {
    const PatternSet& set = sets.meant;
    const Expected<NamedPair> pair = pair_of(set, "--pair", command.pair);
    if (!pair) return pair.error();
    const auto places = changeable(command, set, *pair);
    if (!places) return places.error();
    const auto others = others_of(command, set);
    if (!others) return others.error();
    PartingOptions options;
    options.threads = command.common.threads;
    options.stop = stop;
    options.progress_of = progress_line;
    options.time_limit_s = command.time_limit_s;
    if (sets.labels.by) {
        options.felt = [&by = *sets.labels.by](const Waveform& meant) {
            return rendering(by, meant).waveform;
        };
    }
    const PairToPart to_part{pair->a,          pair->b, *places, *others, command.percent / 100.0,
                             command.threshold};
    auto result = parted_pair(set, sets.felt, to_part, options);
    if (!result) return Error{"stopped before the search had come to its end"};
    return *std::move(result);
}

std::string text_of(const PartedPair& result, const Labels& labels,
                    const std::vector<std::string>& names) {
    std::string text = text_of(labels) + "PM of " + names[result.a] + " and " + names[result.b] +
                       "  " + significant_digits(result.dissimilarity, 6) + "\nto be exceeded  " +
                       significant_digits(result.threshold, 6) + "\n\n";
    const std::string cut_off =
        result.is_cut_off ? "time ran out: smaller changes may exist (--time-limit)\n" : "";
    if (result.changes.empty() && result.is_cut_off) {
        return text + "time ran out before a change was found (--time-limit)\n";
    }
    if (result.changes.empty()) {
        return text +
               "no change of a single number is enough: change the rhythm, or add a carrier\n";
    }
    std::vector<TextRow> rows{
        {"pattern", "parameter", "from", "to", "felt steps", "then", "closest"}};
    for (const auto& [place, one] : result.changes) {
        const ParameterTraits& about = traits(one.parameter);
        const std::string unit = *about.unit == '\0' ? "" : std::string(", ") + about.unit;
        rows.push_back({names[place], about.name + unit, significant_digits(one.from, 6),
                        significant_digits(one.to, 6), fixed_digits(one.steps, 1),
                        significant_digits(one.nearest, 6), names[one.nearest_to]});
    }
    return text + aligned(rows) + cut_off +
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
    const Expected<PartedPair> result = parted(command, *sets, interrupt.token());
    if (!result) return result.error();
    const std::vector<std::string> names = names_of(sets->meant);
    nlohmann::json json = json_of(*result, names);
    add_labels(json, sets->labels);
    return write_result(command.out, [&](std::ostream& stream) {
        stream << (command.common.json ? text_of_json(json) + "\n"
                                       : text_of(*result, sets->labels, shown_texts(names)));
    });
}

}  // namespace tact
