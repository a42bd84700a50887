// Trained parameters and where they come from, in words: for the terminal and for the window.
#pragma once

#include <string>
#include <vector>

#include "model/perceptual_model/perceptual_model_params.h"
#include "model/training/training.h"

namespace tact {

// A weight of a grid whose steps are so long, with as many digits as that takes, at most three.
std::string weight_text(double weight, double step);

// In the order of kTrainedNames.
std::vector<std::string> parameter_texts(const PerceptualModelParams& model, double step);

// Texts of a class of equally good combinations: the smallest of its proportion, "any" for what
// does not matter as OC alone decides.
std::vector<std::string> parameter_texts(const TrainingGrid& grid, const GridPoint& point);

}  // namespace tact
