// What is said of how alike people rate, wherever a command says it: one text, one set of keys.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/evaluation/individual_weights.h"
#include "model/study/agreement.h"

namespace tact {

// Lines under "people"; "" of fewer than two people.
std::string text_of(const InterRater& raters);

// A line on each that is known.
std::string text_of(const OrderEffects& effects);
nlohmann::json json_of(const OrderEffects& effects);

// A table of people, what the dimensions lead from and to, and who is not in it.
std::string text_of(const IndividualWeights& weights);
nlohmann::json json_of(const IndividualWeights& weights);

}  // namespace tact
