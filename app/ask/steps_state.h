// State of the dialog "Steps between", and the answer of its job.
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
    int count = 5;  // including both ends
    StepMeasure measure = StepMeasure::pm;
    std::optional<PatternParameter> along;  // nullopt: all numbers in which the two differ

    Query<StepsRequest, FoundSteps> job;
    bool cancelled = false;  // cancelled by the person, until another question
};

}  // namespace tact
