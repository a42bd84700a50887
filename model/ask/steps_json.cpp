#include "model/ask/steps_json.h"

#include <nlohmann/json.hpp>

namespace tact {

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

}  // namespace tact
