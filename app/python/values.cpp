#include "app/python/values.h"

#include <pybind11/stl.h>
#include <cstdint>

#include <cmath>
#include <nlohmann/json.hpp>

#include "model/io/set/loaded.h"
#include "model/io/set/model_json.h"
#include "model/io/set/set_json.h"
#include "model/set/layers.h"
#include "model/signal/resample.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/unique_names.h"

namespace tact {

namespace py = pybind11;

namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

// A mask would be dropped in silence, and what it hides would count.
void refuse_masked(const py::object& object, const std::string& name) {
    if (!py::hasattr(object, "mask")) return;
    const py::module_ masked = py::module_::import("numpy.ma");
    const auto hidden = masked.attr("count_masked")(object).cast<std::size_t>();
    if (hidden == 0) return;
    throw py::value_error(name + ": expected numbers without a mask, got " +
                          grouped_digits(hidden) + " that are masked");
}

// Whatever NumPy would have cast in silence (complex numbers, texts) is no number here.
Numbers numbers_of(const py::object& object, const std::string& name) {
    refuse_masked(object, name);
    const auto array = py::array::ensure(object);
    if (!array || std::string("iuf").find(array.dtype().kind()) == std::string::npos) {
        throw py::type_error(name + ": expected real numbers, got " +
                             std::string(py::str(py::repr(py::type::of(object)))) +
                             (array ? " of " + std::string(py::str(array.dtype())) : ""));
    }
    return Numbers(array);  // throws where the numbers have no room, unlike ensure()
}

std::string shape_of(const py::array& array) { return std::string(py::str(array.attr("shape"))); }

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
        throw py::value_error(name + "[" + std::to_string(k) + "]: expected at most " +
                              grouped_digits(static_cast<std::size_t>(kMaxSampleG)) + " g, got " +
                              significant_digits(samples[k], 6));
    }
    return {rate_hz, {samples.begin(), samples.end()}};
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

py::object json_module() { return py::module_::import("json"); }

// The text of a dict, in which NumPy's numbers and arrays may stand for Python's.
std::string json_text_of(const py::object& document) {
    const py::cpp_function plain([](const py::object& value) {
        if (py::hasattr(value, "tolist")) return py::object(value.attr("tolist")());
        throw py::type_error("expected numbers, texts, lists and dicts, got " +
                             std::string(py::str(py::repr(value))));
    });
    return py::str(json_module().attr("dumps")(document, py::arg("default") = plain));
}

// Reads a whole document; a key that is not known is a mistake, not something to keep.
template <class Read>
auto read_document(const py::object& document, const std::string& name,
                   std::span<const char* const> passed_over, Read read) {
    const Json json = value_of(parse_json(json_text_of(document), name));
    JsonReading reading{name, {}, UnknownKeys::refused};
    JsonObject object = object_at(reading, json, "");
    for (const char* key : passed_over) (void)field(object, key);
    Json unknown = Json::object();
    auto value = read(object, unknown);
    unknown.update(unknown_fields(object));
    if (!reading.fault.empty()) throw py::value_error(reading.fault);
    return value;
}

// R makes one name a text, not a list of texts.
std::vector<std::string> names_in(const py::object& names) {
    std::vector<std::string> all;
    if (py::isinstance<py::str>(names)) {
        all = {names.cast<std::string>()};
    } else {
        all = names.cast<std::vector<std::string>>();
    }
    for (const std::string& name : all) {
        if (const std::string fault = name_fault(name); !fault.empty()) {
            throw py::value_error("ratings: " + fault);
        }
    }
    return all;
}

RatingStudy study_of_dict(const py::dict& ratings) {
    for (const char* key : {"names", "participants", "ratings"}) {
        if (!ratings.contains(key)) {
            throw py::value_error("ratings: expected what read_ratings() gives, or distances; " +
                                  std::string("there is no \"") + key + "\"");
        }
    }
    RatingStudy study;
    study.labels = names_in(ratings["names"]);
    if (ratings.contains("named")) study.is_named = ratings["named"].cast<bool>();
    const auto participants = names_in(ratings["participants"]);
    const Numbers values = numbers_of(ratings["ratings"], "ratings");
    const auto people = static_cast<py::ssize_t>(participants.size());
    const auto pairs = static_cast<py::ssize_t>(pair_count(study.labels.size()));
    if (values.ndim() != 2 || values.shape(0) != people || values.shape(1) != pairs) {
        throw py::value_error("ratings: expected a row a participant, a column a pair, (" +
                              std::to_string(people) + ", " + std::to_string(pairs) + "), got " +
                              shape_of(values));
    }
    for (py::ssize_t k = 0; k < people; ++k) {
        study.judgements.push_back({participants[static_cast<std::size_t>(k)],
                                    {values.data(k, 0), values.data(k, 0) + pairs}});
    }
    if (ratings.contains("synthetic")) {
        for (const std::string& name : names_in(ratings["synthetic"])) {
            study.standings.push_back({.participant = name, .synthetic = true});
        }
    }
    const auto count = [&ratings](const char* key) {
        return ratings.contains(key) ? ratings[key].cast<std::size_t>() : 0;
    };
    study.left_out = count("participants_left_out");
    study.rehearsals = count("rehearsals_left_out");
    return study;
}

}  // namespace

void throw_error(const std::string& message) {
    if (!message.ends_with(": there is no such file")) throw py::value_error(message);
    PyErr_SetString(PyExc_FileNotFoundError, message.c_str());
    throw py::error_already_set();
}

double within(double number, const std::string& name, Range range) {
    if (range.contains(number)) return number;
    throw py::value_error(name + ": expected " + shortest_digits(range.low) + " to " +
                          shortest_digits(range.high) + ", got " + shortest_digits(number));
}

int whole_within(int number, const std::string& name, Range range) {
    return static_cast<int>(within(number, name, range));
}

int threads_of(int threads) { return whole_within(threads, "threads", {0, 1024}); }

std::size_t choice_of(const std::string& text, const std::string& name,
                      std::span<const char* const> choices) {
    std::string expected;
    for (std::size_t k = 0; k < choices.size(); ++k) {
        if (text == choices[k]) return k;
        expected += (k == 0 ? "\"" : ", \"") + std::string(choices[k]) + "\"";
    }
    throw py::value_error(name + ": expected one of " + expected + ", got \"" + text + "\"");
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
    within(rate_hz, "rate_hz", {kLowestRateHz, kHighestRateHz});
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
        throw py::value_error("waves: expected an array (n, samples) or a list of arrays");
    }
    return all;
}

std::vector<Waveform> at_model_rate(std::vector<Waveform> waves) {
    for (Waveform& wave : waves) wave = resampled(wave, kModelRateHz);
    return waves;
}

Dissimilarity dissimilarities_of(const py::object& matrix, const std::string& name) {
    const Numbers values = numbers_of(matrix, name);
    for (py::ssize_t k = 0; k < values.size(); ++k) {
        if (std::isinf(values.data()[k])) {
            throw py::value_error(name + ": expected finite numbers, or NaN, got infinity");
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

std::vector<std::size_t> places_of(const std::vector<std::int64_t>& places, const std::string& name,
                                   std::size_t count) {
    std::vector<std::size_t> result;
    for (const std::int64_t place : places) {
        if (place < 0 || static_cast<std::size_t>(place) >= count) {
            throw py::value_error(name + ": expected places 0 to " + std::to_string(count - 1) +
                                  ", got " + std::to_string(place));
        }
        result.push_back(static_cast<std::size_t>(place));
    }
    return result;
}

PerceptualModelParams model_of(const py::object& model) {
    // An empty dict that has been through R may be an empty list.
    const bool is_empty = py::isinstance<py::list>(model) && py::len(model) == 0;
    if (model.is_none() || is_empty) return {};
    constexpr const char* kOrigin[] = {"trained_on", "synthetic", "changed_by_hand"};
    return read_document(model, "model", kOrigin, [](JsonObject& object, Json& unknown) {
        return model_of(object, unknown);
    });
}

VibrationSource pattern_of(const py::dict& pattern) {
    constexpr const char* kOfItsSet[] = {"name", "locked",    "dropped", "colour",
                                         "mark", "generated", "note",    "effect"};
    const double usual_s = Pattern().duration_s;
    if (!pattern.contains("layers")) {
        return read_document(pattern, "pattern", kOfItsSet, [&](JsonObject& object, Json& unknown) {
            return pattern_of(object, usual_s, unknown);
        });
    }
    Vibration layered;
    layered.source = read_document(
        pattern, "pattern", kOfItsSet,
        [&](JsonObject& object, Json& unknown) { return layered_of(object, usual_s, unknown); });
    if (!recordings_in(layered).empty()) {
        throw py::value_error("pattern: expected layers made of parameters, got a recording");
    }
    const std::string fault = fault_of(std::get<LayeredPattern>(layered.source));
    if (!fault.empty()) throw py::value_error("pattern: " + fault);
    return layered.source;
}

RatingStudy study_of(const py::object& ratings) {
    if (py::isinstance<py::dict>(ratings)) return study_of_dict(ratings);
    const Dissimilarity matrix = dissimilarities_of(ratings, "ratings");
    RatingStudy study;
    for (std::size_t k = 0; k < matrix.size; ++k) study.labels.push_back(std::to_string(k));
    study.is_named = false;
    study.judgements.push_back({"ratings", matrix.condensed});
    return study;
}

py::dict python_of(const RatingStudy& study) {
    const auto people = static_cast<py::ssize_t>(study.judgements.size());
    const auto pairs = static_cast<py::ssize_t>(pair_count(study.labels.size()));
    py::array_t<double> values({people, pairs});
    std::vector<std::string> participants;
    for (py::ssize_t k = 0; k < people; ++k) {
        const Judgement& one = study.judgements[static_cast<std::size_t>(k)];
        participants.push_back(one.participant);
        std::copy(one.condensed.begin(), one.condensed.end(), values.mutable_data(k, 0));
    }
    std::vector<std::string> synthetic;
    for (const Standing& one : study.standings) {
        if (one.synthetic) synthetic.push_back(one.participant);
    }
    py::dict result;
    result["names"] = study.labels;
    result["named"] = study.is_named;
    result["participants"] = participants;
    result["ratings"] = values;
    result["mean"] = square_array(mean_ratings(study));
    result["synthetic"] = synthetic;
    result["participants_left_out"] = study.left_out;
    result["rehearsals_left_out"] = study.rehearsals;
    return result;
}

py::object python_of(const Json& document) {
    return json_module().attr("loads")(text_of_json(document));
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
    if (PyErr_WarnEx(PyExc_UserWarning, sentence.c_str(), 1) != 0) throw py::error_already_set();
}

}  // namespace tact
