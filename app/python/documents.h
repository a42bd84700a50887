// Documents of the model as dicts, and dicts as documents: what a set file has for a pattern or a
// model, and what the command line prints behind --json.
//
// Input     dicts with texts for keys, lists, tuples, arrays, texts, numbers of Python and NumPy
// Output    NaN stays NaN, a number without a point an int. Errors name the place:
//           "model: /nc_weight: expected .., got ..", as TypeError where the type is wrong
// Valid     to be called with the interpreter's lock held
#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/text/json_fields.h"

namespace tact {

pybind11::object python_of(const Json& document);
pybind11::object python_of(const nlohmann::json& document);

Json json_of(const pybind11::handle& document, const std::string& name);

}  // namespace tact
