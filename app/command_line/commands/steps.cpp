// tactspace steps: patterns between two, as far apart from each other as the model can make them
// even.

#include "model/ask/steps.h"

#include <iostream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "app/rendering/rendering.h"
#include "model/io/set/set_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

Expected<std::size_t> pattern_named(const PatternSet& set, const char* option,
                                    const std::string& name) {
    const Expected<std::size_t> place = pattern_place_of(set, name);
    return place ? place
                 : Expected<std::size_t>(Error{std::string(option) + ": " + place.error().message});
}

struct AnsweredSteps {
    StepsQuestion question;
    EvenSteps steps;
    PatternSet written;
};

Expected<AnsweredSteps> answered(const StepsCommand& command, const PatternSet& set,
                                 std::stop_token stop) {
    const auto from = pattern_named(set, "--from", command.from);
    if (!from) return from.error();
    const auto to = pattern_named(set, "--to", command.to);
    if (!to) return to.error();
    if (*from == *to) return Error{"--to: expected another pattern than --from"};
    const Pattern& first = std::get<Pattern>(set.vibrations[*from].source);
    const auto last =
        end_of_way(first, std::get<Pattern>(set.vibrations[*to].source), command.parameter);
    if (!last) return Error{"--parameter: " + last.error().message};
    const StepMeasure measure = step_measure_named(command.metric).value_or(StepMeasure::pm);
    const StepsQuestion question{first, *last, static_cast<std::size_t>(command.count), measure,
                                 set.model};
    const auto steps =
        even_steps(question, {command.common.threads, stop, progress_line("placing steps")});
    if (!steps) return Error{"stopped before the steps were placed"};
    return AnsweredSteps{question, *steps, set_of_steps(set, *from, *to, *steps)};
}

// How far apart they are is the model's word.
Labels labels_of(const AnsweredSteps& answer) { return {.mark = mark_of(answer.written)}; }

nlohmann::json json_of(const AnsweredSteps& answer) {
    nlohmann::json json = json_of(answer.steps, names_of(answer.written));
    add_labels(json, labels_of(answer));
    return json;
}

std::string text_of(const AnsweredSteps& answer) {
    const EvenSteps& steps = answer.steps;
    const std::vector<std::string> names = names_of(answer.written);
    std::vector<TextRow> rows{{"pattern", "of the way, %", "to the next", "PM to the next"}};
    for (std::size_t k = 0; k < names.size(); ++k) {
        const bool last = k + 1 == names.size();
        rows.push_back({names[k], significant_digits(100.0 * steps.shares[k], 6),
                        last ? "" : significant_digits(steps.apart[k], 6),
                        last ? "" : significant_digits(steps.pm[k], 6)});
    }
    return text_of(labels_of(answer)) + aligned(rows) + "\n" + sentence_on(answer.question, steps) +
           "\n" + pm_sentence_on(steps) + "\n";
}

}  // namespace

Expected<Done> run(const StepsCommand& command) {
    const Interrupt interrupt;
    if (const auto writable = writable_result(command.out); !writable) return writable;
    const Expected<PatternSet> set = load_as_meant(command.common);
    if (!set) return set.error();
    const Expected<AnsweredSteps> answer = answered(command, *set, interrupt.token());
    if (!answer) return answer.error();
    const Expected<Done> written = write_set_file(command.out, answer->written);
    if (!written) return written;
    return write_result({}, [&](std::ostream& stream) {
        stream << (command.common.json ? text_of_json(json_of(*answer)) + "\n" : text_of(*answer));
    });
}

}  // namespace tact
