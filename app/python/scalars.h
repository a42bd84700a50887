// Numbers, texts and paths that Python hands over.
//
// Output    TypeError where the type is wrong, else ValueError: "NAME: expected .., got .."
// Valid     to be called with the interpreter's lock held
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/common/range.h"

namespace tact {

// "2.5 of type float": what was got, for a TypeError.
std::string described(const pybind11::handle& value);

// The number, if it may have this value. Whole ones are Python's and NumPy's integers.
double within(const pybind11::object& value, const std::string& name, Range range);
int whole_within(const pybind11::object& value, const std::string& name, Range range);
std::vector<int> wholes_within(const pybind11::object& values, const std::string& name,
                               Range range);
std::optional<double> optional_within(const pybind11::object& value, const std::string& name,
                                      Range range);

int threads_of(const pybind11::object& threads);
double rate_of(const pybind11::object& rate_hz);

// Whole numbers of a list, a range or an array, each below `count`: places of objects.
std::vector<std::size_t> places_of(const pybind11::object& places, const std::string& name,
                                   std::size_t count);

std::string text_in(const pybind11::handle& value, const std::string& name);
// A list of texts, or a single one.
std::vector<std::string> texts_in(const pybind11::object& value, const std::string& name);

// Position of the text among the choices.
std::size_t choice_of(const pybind11::object& text, const std::string& name,
                      std::span<const char* const> choices);

std::filesystem::path path_in(const pybind11::handle& value, const std::string& name);

// Throws an OSError of its kind (FileNotFoundError, PermissionError ..) if the system refused a
// file, with errno and the file's name; a ValueError otherwise.
[[noreturn]] void throw_error(const std::string& message);

template <class Value>
Value value_of(Expected<Value> expected) {
    if (!expected) throw_error(expected.error().message);
    return *std::move(expected);
}

}  // namespace tact
