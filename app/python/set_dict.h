// Sets as dicts: what read_set() gives, and what write_set() and others take.
//
// Output    errors are those of app/python/scalars.h
// Valid     to be called with the interpreter's lock held
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "model/io/set/loaded.h"
#include "model/set/pattern_set.h"

namespace tact {

// With the whole set file behind "document", without samples.
pybind11::dict dict_of(const Loaded& loaded);

// Names, patterns, waves of recordings, model, ratings, locked and dropped of the dict; all else of
// its "document", each pattern's by the name. Recordings have no file yet. Left out: layers that
// are recordings, which are refused.
PatternSet pattern_set_of(const pybind11::object& set);

// The pattern of this name, or at this place.
std::size_t place_in(const pybind11::object& pattern, const PatternSet& set,
                     const std::string& name);

}  // namespace tact
