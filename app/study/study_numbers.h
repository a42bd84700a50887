// The numbers of a study's design that are typed: their words, their bounds, and where they are
// kept.
#pragma once

#include <span>

#include "app/ui/widgets.h"
#include "model/study/study_design.h"

namespace tact {

// A number of the design.
struct StudyNumber {
    Field field;
    double (*get)(const StudyDesign&);
    void (*set)(StudyDesign&, double);
    bool of_pairs = true;  // sorting has none of it
};

std::span<const StudyNumber> study_numbers();

}  // namespace tact
