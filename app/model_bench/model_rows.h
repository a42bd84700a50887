// Every parameter of PM that the model bench shows: a field and where it is kept.
#pragma once

#include <array>
#include <span>

#include "app/ui/described_field.h"
#include "model/perceptual_model/perceptual_model_params.h"

namespace tact {

using ModelNumber = DescribedField<PerceptualModelParams>;

// One of a few ways to do something.
struct ModelChoice {
    const char* id;
    const char* label;
    const char* help;
    std::array<const char*, 2> options;
    int (*get)(const PerceptualModelParams&);
    void (*set)(PerceptualModelParams&, int);
};

std::span<const ModelNumber> trained_rows();  // those that the paper gives
std::span<const ModelChoice> choice_rows();   // where it leaves one open
std::span<const ModelNumber> number_rows();   // the others

}  // namespace tact
