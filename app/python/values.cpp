#include "app/python/parts.h"

#include <pybind11/stl.h>
#include <cstdint>

#include <cmath>

#include "model/io/set/load.h"
#include "model/pattern/pattern.h"
#include "model/signal/resample.h"
#include "model/text/numbers.h"

namespace tact {

namespace py = pybind11;

std::string shape_of(const py::array& array) { return std::string(py::str(array.attr("shape"))); }

namespace {

// A mask would be dropped in silence, and what it hides would count.
void refuse_masked(const py::object& object, const std::string& name) {
    if (!py::hasattr(object, "mask")) return;
    const py::module_ masked = py::module_::import("numpy.ma");
    const auto hidden = masked.attr("count_masked")(object).cast<std::size_t>();
    if (hidden == 0) return;
    throw py::value_error(name + ": expected numbers without a mask, got " +
                          grouped_digits(hidden) + " that are masked");
}

// The first element that is no number, where a list holds some.
void refuse_element(const py::array& array, const std::string& name) {
    if (array.dtype().kind() != 'O' || array.ndim() != 1) return;
    std::size_t k = 0;
    for (const py::handle one : array) {
        if (!py::isinstance<py::float_>(one) && !py::isinstance<py::int_>(one)) {
            throw py::type_error(name + "[" + std::to_string(k) +
                                 "]: expected a real number, got " + described(one));
        }
        ++k;
    }
}

Waveform wave_of(std::span<const double> samples, const std::string& name, double rate_hz) {
    if (samples.empty()) throw py::value_error(name + ": expected samples, got none");
    const double seconds = static_cast<double>(samples.size()) / rate_hz;
    if (seconds > limits::kDurationS.high) {
        throw py::value_error(name + ": expected at most " +
                              shortest_digits(limits::kDurationS.high) + " s, got " +
                              significant_digits(seconds, 6) + " s");
    }
    for (std::size_t k = 0; k < samples.size(); ++k) {
        if (std::abs(samples[k]) <= kMaxSampleG) continue;
        if (!std::isfinite(samples[k])) {
            throw py::value_error(name + "[" + std::to_string(k) +
                                  "]: expected a finite number of g, got " +
                                  shortest_digits(samples[k]));
        }
        throw py::value_error(name + "[" + std::to_string(k) + "]: expected at most " +
                              grouped_digits(static_cast<std::size_t>(kMaxSampleG)) + " g, got " +
                              significant_digits(samples[k], 6));
    }
    return {rate_hz, {samples.begin(), samples.end()}};
}

// "[3]", or "[1, 0]" of a table.
std::string place_in(const Numbers& values, py::ssize_t k) {
    if (values.ndim() != 2) return "[" + std::to_string(k) + "]";
    const py::ssize_t columns = values.shape(1);
    return "[" + std::to_string(k / columns) + ", " + std::to_string(k % columns) + "]";
}

// n of n (n - 1) / 2 pairs; 0 if no n fits.
std::size_t objects_of_pairs(std::size_t pairs) {
    const auto n = static_cast<std::size_t>(
        std::lround((1.0 + std::sqrt(1.0 + 8.0 * static_cast<double>(pairs))) / 2.0));
    return pair_count(n) == pairs ? n : 0;
}

// The square must be symmetric up to rounding, and 0 on the diagonal, as in files.
Dissimilarity of_square(const Numbers& square, const std::string& name) {
    const auto n = square.shape(0);
    const auto at = [&square](py::ssize_t i, py::ssize_t j) { return *square.data(i, j); };
    const auto fault = [&](py::ssize_t i, py::ssize_t j, const std::string& expected) {
        return py::value_error(name + "[" + std::to_string(i) + ", " + std::to_string(j) +
                               "]: expected " + expected + ", got " + shortest_digits(at(i, j)));
    };
    Dissimilarity result{static_cast<std::size_t>(n), {}};
    for (py::ssize_t i = 0; i < n; ++i) {
        if (std::abs(at(i, i)) > 0.0) throw fault(i, i, "0 on the diagonal");
        for (py::ssize_t j = i + 1; j < n; ++j) {
            const double a = at(i, j);
            const double b = at(j, i);
            const bool are_unknown = std::isnan(a) && std::isnan(b);
            constexpr double kRounding = 1e-9;
            if (!are_unknown &&
                !(std::abs(a - b) <= kRounding * std::max(std::abs(a), std::abs(b)))) {
                throw fault(j, i, "the same as the other way round, " + shortest_digits(a));
            }
            result.condensed.push_back(a);
        }
    }
    return result;
}

}  // namespace

Numbers numbers_of(const py::object& object, const std::string& name) {
    refuse_masked(object, name);
    const auto array = py::array::ensure(object);
    if (!array || std::string("iuf").find(array.dtype().kind()) == std::string::npos) {
        if (array) refuse_element(array, name);
        throw py::type_error(name + ": expected real numbers, got " +
                             (array ? "dtype " + std::string(py::str(array.dtype())) +
                                          " and shape " + shape_of(array)
                                    : described(object)));
    }
    return Numbers(array);  // throws where the numbers have no room, unlike ensure()
}

Waveform wave_of(const py::object& wave, const std::string& name, double rate_hz) {
    const Numbers samples = numbers_of(wave, name);
    if (samples.ndim() != 1) {
        throw py::value_error(name + ": expected samples along one axis, got shape " +
                              shape_of(samples));
    }
    return wave_of({samples.data(), static_cast<std::size_t>(samples.size())}, name, rate_hz);
}

std::vector<Waveform> waves_of(const py::object& waves, double rate_hz) {
    std::vector<Waveform> all;
    std::size_t samples = 0;
    const auto add = [&](Waveform wave) {
        samples += wave.samples_g.size();
        if (const std::string fault = samples_fault(samples); !fault.empty()) {
            throw py::value_error("waves: " + fault);
        }
        all.push_back(std::move(wave));
    };
    const auto name = [&all] { return "waves[" + std::to_string(all.size()) + "]"; };
    if (py::hasattr(waves, "__array__")) {
        const Numbers rows = numbers_of(waves, "waves");
        if (rows.ndim() != 2) {
            throw py::value_error("waves: expected an array (n, samples), got shape " +
                                  shape_of(rows));
        }
        const auto length = static_cast<std::size_t>(rows.shape(1));
        for (py::ssize_t k = 0; k < rows.shape(0); ++k) {
            add(wave_of({rows.data() + k * rows.shape(1), length}, name(), rate_hz));
        }
    } else if (py::isinstance<py::sequence>(waves)) {
        for (const py::handle wave : waves) {
            add(wave_of(py::reinterpret_borrow<py::object>(wave), name(), rate_hz));
        }
    } else {
        throw py::type_error("waves: expected an array (n, samples) or a list of arrays, got " +
                             described(waves));
    }
    return all;
}

std::vector<Waveform> at_model_rate(std::vector<Waveform> waves, const std::stop_token& stop) {
    for (Waveform& wave : waves) {
        if (stop.stop_requested()) break;
        wave = resampled(wave, kModelRateHz);
    }
    return waves;
}

Dissimilarity dissimilarities_of(const py::object& matrix, const std::string& name) {
    const Numbers values = numbers_of(matrix, name);
    for (py::ssize_t k = 0; k < values.size(); ++k) {
        if (std::isinf(values.data()[k])) {
            throw py::value_error(name + place_in(values, k) +
                                  ": expected a finite number, or NaN, got " +
                                  shortest_digits(values.data()[k]));
        }
    }
    const bool is_square = values.ndim() == 2 && values.shape(0) == values.shape(1);
    const auto count = static_cast<std::size_t>(values.size());
    const std::size_t n = is_square            ? static_cast<std::size_t>(values.shape(0))
                          : values.ndim() == 1 ? objects_of_pairs(count)
                                               : 0;
    if (n < 2 || n > limits::kMaxPatterns) {
        throw py::value_error(name + ": expected the distances of 2 to " +
                              grouped_digits(limits::kMaxPatterns) +
                              " objects, as a square (n, n) or as n (n - 1) / 2 pairs, got shape " +
                              shape_of(values));
    }
    if (is_square) return of_square(values, name);
    return {n, {values.data(), values.data() + count}};
}

py::array_t<double> array_of(std::span<const double> numbers) {
    return py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::array_t<int> array_of(std::span<const int> numbers) {
    return py::array_t<int>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::array_t<double> array_of(const Eigen::MatrixXd& matrix) {
    py::array_t<double> array({matrix.rows(), matrix.cols()});
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        for (Eigen::Index k = 0; k < matrix.cols(); ++k) array.mutable_at(i, k) = matrix(i, k);
    }
    return array;
}

py::array_t<double> square_array(const Dissimilarity& dissimilarity) {
    const auto n = static_cast<py::ssize_t>(dissimilarity.size);
    py::array_t<double> array({n, n});
    auto cells = array.mutable_unchecked<2>();
    std::size_t pair = 0;
    for (py::ssize_t i = 0; i < n; ++i) {
        cells(i, i) = 0.0;
        for (py::ssize_t j = i + 1; j < n; ++j, ++pair) {
            cells(i, j) = cells(j, i) = dissimilarity.condensed[pair];
        }
    }
    return array;
}

void warn(const std::string& sentence) {
    if (sentence.empty()) return;
    constexpr int kCallerOfPackage = 2;  // its __init__.py is between
    if (PyErr_WarnEx(PyExc_UserWarning, sentence.c_str(), kCallerOfPackage) != 0)
        throw py::error_already_set();
}

}  // namespace tact
