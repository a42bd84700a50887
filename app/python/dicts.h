// Dicts that Python hands over as parts of a set: models, patterns, ratings; and ratings as a dict.
//
// Input     the keys of a set file, or those that read_ratings() gives
// Output    errors are those of app/python/scalars.h
// Valid     to be called with the interpreter's lock held
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "model/perceptual_model/perceptual_model_params.h"
#include "model/set/pattern_set.h"
#include "model/study/ratings.h"

namespace tact {

pybind11::dict dict_in(const pybind11::handle& value, const std::string& name);
// A list of them, "NAME[0]" and so on.
std::vector<pybind11::dict> dicts_in(const pybind11::object& value, const std::string& name);

// None: the defaults.
PerceptualModelParams model_of(const pybind11::object& model);
// With the keys of a set file for its origin, which model_of() passes over.
pybind11::dict python_of(const PerceptualModelParams& model, const ModelOrigin& origin);
ModelOrigin origin_in(const pybind11::object& model);
VibrationSource pattern_of(const pybind11::handle& pattern, const std::string& name = "pattern");

// What read_ratings() gives; or dissimilarities, as of one voice.
RatingStudy study_of(const pybind11::object& ratings);
pybind11::dict python_of(const RatingStudy& study);

}  // namespace tact
