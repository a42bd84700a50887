// What Python hands over as values of the model, and values of the model as Python has them.
//
// Input     arrays: anything that NumPy makes an array of real numbers, of any type, order and
//           stride. Distances of all pairs: a square, or condensed as SciPy's squareform has it,
//           (0,1),(0,2)..(0,n-1),(1,2)..
//           documents: dicts with the keys of a set file
// Output    errors are thrown as ValueError: "NAME: expected .., got .."; as TypeError where
//           what is given is no number, as FileNotFoundError where a file is not there
// Valid     to be called with the interpreter's lock held
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <cstdint>

#include <Eigen/Core>
#include <span>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/common/range.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/pattern/pattern.h"
#include "model/perceptual_model/perceptual_model_params.h"
#include "model/set/pattern_set.h"
#include "model/signal/waveform.h"
#include "model/study/ratings.h"
#include "model/text/json_fields.h"

namespace tact {

// A FileNotFoundError where a file is not there, else a ValueError.
[[noreturn]] void throw_error(const std::string& message);

template <class Value>
Value value_of(Expected<Value> expected) {
    if (!expected) throw_error(expected.error().message);
    return *std::move(expected);
}

// The number itself, if it may have this value.
double within(double number, const std::string& name, Range range);
int whole_within(int number, const std::string& name, Range range);

int threads_of(int threads);

// Position among the choices.
std::size_t choice_of(const std::string& text, const std::string& name,
                      std::span<const char* const> choices);

// Samples in g at this rate: of one, and of the rows of an array or the elements of a list.
Waveform wave_of(const pybind11::object& wave, const std::string& name, double rate_hz);
std::vector<Waveform> waves_of(const pybind11::object& waves, double rate_hz);
std::vector<Waveform> at_model_rate(std::vector<Waveform> waves);

// NaN: not known. At least two objects.
Dissimilarity dissimilarities_of(const pybind11::object& matrix, const std::string& name);

// Places of objects, below `count`.
std::vector<std::size_t> places_of(const std::vector<std::int64_t>& places, const std::string& name,
                                   std::size_t count);

// None: the defaults.
PerceptualModelParams model_of(const pybind11::object& model);
VibrationSource pattern_of(const pybind11::dict& pattern);

// What read_ratings() gives; or dissimilarities, as of one voice.
RatingStudy study_of(const pybind11::object& ratings);
pybind11::dict python_of(const RatingStudy& study);

pybind11::object python_of(const Json& document);
pybind11::array_t<double> array_of(std::span<const double> numbers);
pybind11::array_t<int> array_of(std::span<const int> numbers);
pybind11::array_t<double> array_of(const Eigen::MatrixXd& matrix);
pybind11::array_t<double> square_array(const Dissimilarity& dissimilarity);

// A UserWarning, unless there is nothing to say.
void warn(const std::string& sentence);

}  // namespace tact
