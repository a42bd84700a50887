// What "Steps between" is left at, and what its job has found.
#pragma once

#include <optional>
#include <string>

#include "app/jobs/query.h"
#include "model/ask/steps.h"

namespace tact {

struct StepsRequest {
    StepsQuestion question;

    bool operator==(const StepsRequest&) const = default;
};

struct FoundSteps {
    StepsRequest request;
    EvenSteps steps;
};

struct StepsState {
    std::string from;  // names
    std::string to;
    int count = 5;  // with both ends
    StepMeasure measure = StepMeasure::pm;
    std::optional<PatternParameter> along;  // none: all that the two differ in

    Query<StepsRequest, FoundSteps> job;
    bool cancelled = false;  // by the person, until something else is asked for
};

}  // namespace tact
