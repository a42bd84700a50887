// Even steps as a document, and what is asked of them by name: of the command steps and of Python.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/ask/steps.h"
#include "model/common/expected.h"

namespace tact {

// {"patterns", "shares", "apart", "ends_apart", "pm", "largest_pm", "uneven", "even", "jump"}; the
// last where there is one. `names`: of the patterns.
nlohmann::json json_of(const EvenSteps& steps, const std::vector<std::string>& names);

inline constexpr const char* kStepMeasures[] = {"pm", "nc", "oc"};
std::optional<StepMeasure> step_measure_named(std::string_view name);

// `to`, or where a parameter is named, `from` with this number alone changed to that of `to`.
Expected<Pattern> end_of_way(const Pattern& from, const Pattern& to, const std::string& parameter);

}  // namespace tact
