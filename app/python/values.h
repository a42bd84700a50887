// Arrays that Python hands over as values of the model, and values of the model as arrays.
//
// Input     arrays: anything that NumPy makes an array of real numbers, of any type, order and
//           stride. Distances of all pairs: a square, or condensed as SciPy's squareform has it,
//           (0,1),(0,2)..(0,n-1),(1,2)..
// Output    errors are those of app/python/scalars.h
// Valid     to be called with the interpreter's lock held
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <cstdint>

#include <Eigen/Core>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "app/python/scalars.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/signal/waveform.h"

namespace tact {

using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

// Whatever NumPy would have cast in silence (complex numbers, texts) is a TypeError.
Numbers numbers_of(const pybind11::object& object, const std::string& name);
std::string shape_of(const pybind11::array& array);

// Samples in g at this rate: of one, and of the rows of an array or the elements of a list.
Waveform wave_of(const pybind11::object& wave, const std::string& name, double rate_hz);
std::vector<Waveform> waves_of(const pybind11::object& waves, double rate_hz);
// Those that a stop came before keep their rate.
std::vector<Waveform> at_model_rate(std::vector<Waveform> waves, const std::stop_token& stop);

// NaN: not known. At least two objects.
Dissimilarity dissimilarities_of(const pybind11::object& matrix, const std::string& name);

pybind11::array_t<double> array_of(std::span<const double> numbers);
pybind11::array_t<int> array_of(std::span<const int> numbers);
pybind11::array_t<double> array_of(const Eigen::MatrixXd& matrix);
pybind11::array_t<double> square_array(const Dissimilarity& dissimilarity);

// A UserWarning, unless there is nothing to say.
void warn(const std::string& sentence);

}  // namespace tact
