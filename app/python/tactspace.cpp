// The Python module tactspace: the same numbers as the program's, for notebooks, and for R through
// reticulate.
//
// Input     arrays and dicts (app/python/values.h)
// Output    help.h says what of each function; tactspace.pyi has the types
// Left out  what a screen or a device is needed for; export, studies and candidates, which the
//           command line has.
// Exact     same bits as the command line.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <cstdint>

#include <algorithm>

#include "app/python/beside_python.h"
#include "app/python/functions.h"
#include "app/python/help.h"
#include "app/python/values.h"
#include "model/algebra/source_edits.h"
#include "model/evaluation/metric_matrix.h"
#include "model/io/set/set_json.h"
#include "model/map/mds.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/perceptual_model/rhythm_envelope.h"
#include "model/physiology/neural_coding.h"
#include "model/signal/resample.h"
#include "model/subset/subset.h"

namespace tact {

namespace {

namespace py = pybind11;
using namespace py::literals;

py::array predict_matrix(const py::object& waves, const std::string& metric, double rate_hz,
                         int threads, const py::object& model) {
    const Metric by = value_of(metric_named(metric));
    const PerceptualModelParams params = model_of(model);
    MetricOptions options;
    options.threads = threads_of(threads);
    std::vector<Waveform> given = waves_of(waves, rate_hz);
    if (given.size() < 2) {
        throw py::value_error("waves: expected at least two to compare, got " +
                              std::to_string(given.size()));
    }
    return square_array(*beside_python([&](std::stop_token stop) {
        options.stop = stop;
        auto matrix = metric_matrix(by, at_model_rate(std::move(given)), params, options);
        return matrix ? std::optional(as_ranked(by, *std::move(matrix))) : std::nullopt;
    }));
}

py::dict dict_of(const ChannelStages& channel, const Activation& activation,
                 const std::vector<int>& central) {
    const ReceptorGrid& grid = channel.grid;
    const auto of_each = [&grid](auto value) {
        std::vector<double> values;
        for (const GridReceptor& one : grid.receptors) values.push_back(value(one));
        return array_of(values);
    };
    const auto receptors = static_cast<py::ssize_t>(grid.receptors.size());
    const auto steps = static_cast<py::ssize_t>(central.size());
    py::array_t<int> spikes({receptors, steps});
    for (py::ssize_t k = 0; k < receptors; ++k) {
        const std::vector<int>& counts = channel.spike_count[static_cast<std::size_t>(k)];
        std::ranges::copy(counts, spikes.mutable_data(k, 0));
    }
    return py::dict(
        "rate_imp_per_s"_a = activation.rate_hz, "slope_sum_imp_per_s"_a = activation.slope_sum,
        "radius_mm"_a = activation.radius_mm, "receptors"_a = grid.activated,
        "silent"_a = channel.silent, "filtered_g"_a = array_of(channel.filtered_g),
        "perceived"_a = array_of(channel.perceived),
        "x_mm"_a = of_each([&](const GridReceptor& one) { return grid.x_mm(one); }),
        "y_mm"_a = of_each([&](const GridReceptor& one) { return grid.y_mm(one); }),
        "receptor_rate_imp_per_s"_a = of_each([](const GridReceptor& one) { return one.rate_hz; }),
        "spikes"_a = spikes, "central"_a = array_of(central));
}

py::dict dict_of(const std::vector<Component>& components) {
    const auto of_each = [&components](double Component::*field) {
        std::vector<double> values;
        for (const Component& one : components) values.push_back(one.*field);
        return array_of(values);
    };
    return py::dict("frequency_hz"_a = of_each(&Component::frequency_hz),
                    "acceleration_g"_a = of_each(&Component::amplitude_g),
                    "skin_um"_a = of_each(&Component::skin_um));
}

// Padded to the longest, as predict() does.
py::array unfelt_places(const py::object& waves, double rate_hz, int threads,
                        const py::object& model) {
    const PerceptualModelParams params = model_of(model);
    PredictOptions options;
    options.threads = threads_of(threads);
    std::vector<Waveform> given = waves_of(waves, rate_hz);
    const std::vector<std::size_t> places = beside_python([&](std::stop_token stop) {
        options.stop = stop;
        given = at_model_rate(std::move(given));
        std::size_t longest = 0;
        for (const Waveform& one : given) longest = std::max(longest, one.samples_g.size());
        for (Waveform& one : given) one = padded(std::move(one), longest);
        return unfelt(pattern_codes(given, params, options));
    });
    return array_of(std::vector<int>(places.begin(), places.end()));
}

py::dict stages(const py::object& wave, double rate_hz, const py::object& model) {
    const PerceptualModelParams params = model_of(model);
    within(rate_hz, "rate_hz", {kLowestRateHz, kHighestRateHz});
    Waveform input = wave_of(wave, "wave", rate_hz);
    const NeuralCodingStages made = beside_python([&](std::stop_token stop) {
        input = resampled(input, kModelRateHz);
        return neural_coding_stages(input, params.coding, KeepLayers::none, {.stop = stop});
    });
    py::dict channels;
    for (const Receptor receptor : kReceptors) {
        const std::size_t c = index_of(receptor);
        channels[traits(receptor).afferent] =
            dict_of(made.channel[c], made.code.activation[c], made.code.central_count[c]);
    }
    return py::dict(
        "wave"_a = array_of(input.samples_g), "components"_a = dict_of(made.components),
        "channels"_a = channels,
        "brain"_a = array_of(predicted_brain_waveform(made.code, params.channel_weight)),
        "envelope"_a = array_of(rhythm_envelope(input.samples_g, params.envelope)));
}

py::tuple space(const py::object& matrix, int dimensions, int threads) {
    const Dissimilarity dissimilarity = dissimilarities_of(matrix, "D");
    MdsParams params =
        standard_mds_params(dissimilarity.size, whole_within(dimensions, "dimensions", {1, 10}));
    params.threads = threads_of(threads);
    const PerceptualSpace made = beside_python(
        [&](std::stop_token stop) { return nonmetric_mds(dissimilarity, params, stop); });
    warn(remark_on(made));
    return py::make_tuple(array_of(made.points), made.stress1);
}

py::dict subset(const py::object& matrix, int k, const std::vector<std::int64_t>& keep,
                const std::vector<std::int64_t>& drop, const std::string& objective, int threads,
                double time_limit_s) {
    const Dissimilarity dissimilarity = dissimilarities_of(matrix, "D");
    constexpr const char* kObjectives[] = {"max-min", "max-sum"};
    const bool by_sum = choice_of(objective, "objective", kObjectives) == 1;
    whole_within(k, "k", {0, 1e9});  // the rest is said as everywhere (check_subset)
    const SubsetProblem problem{
        static_cast<std::size_t>(k), by_sum ? SubsetObjective::max_sum : SubsetObjective::max_min,
        places_of(keep, "keep", dissimilarity.size), places_of(drop, "drop", dissimilarity.size)};
    SubsetOptions options;
    options.threads = threads_of(threads);
    options.time_limit_s =
        within(time_limit_s, "time_limit_s", {0.0, std::numeric_limits<double>::infinity()});
    const SubsetAnswer answer = value_of(beside_python([&](std::stop_token stop) {
        options.stop = stop;
        return most_distinct_subset(dissimilarity, problem, options);
    }));
    const Subset& best = answer.best;
    const std::vector<int> members(best.members.begin(), best.members.end());
    return py::dict("members"_a = array_of(members), "weakest"_a = best.weakest,
                    "weakest_dissimilarity"_a = best.weakest_dissimilarity, "sum"_a = best.sum,
                    "optimal"_a = answer.proof == SubsetProof::optimal, "bound"_a = answer.bound);
}

py::array render_pattern(const py::dict& pattern, double rate_hz) {
    Vibration drawn;
    drawn.source = pattern_of(pattern);
    within(rate_hz, "rate_hz", {kLowestRateHz, kHighestRateHz});
    return array_of(beside_python([&](const std::stop_token&) {
                        return waveform_of(drawn, rate_hz);
                    }).samples_g);
}

// "reverse", or with what it needs: ("stretch", 1.2), ("join", {...}).
Edit edit_of(const py::handle& given) {
    const bool is_key = py::isinstance<py::str>(given);
    const py::tuple words =
        is_key ? py::make_tuple(given) : py::tuple(py::reinterpret_borrow<py::object>(given));
    const auto kind = words.empty() ? std::nullopt : edit_kind(words[0].cast<std::string>());
    if (!kind) {
        std::string keys;
        for (std::size_t k = 0; k < kEditKindCount; ++k) {
            keys += std::string(k == 0 ? "" : ", ") + traits(static_cast<EditKind>(k)).key;
        }
        throw py::value_error("edits: expected one of " + keys + ", got " +
                              py::repr(given).cast<std::string>());
    }
    const EditTraits& about = traits(*kind);
    const auto refuse = [&](const char* expected) {
        throw py::value_error(std::string(about.key) + ": expected " + expected + ", got " +
                              py::repr(given).cast<std::string>());
    };
    const bool is_pair = words.size() == 2;
    if (about.needs == EditNeeds::nothing) {
        if (words.size() != 1) refuse("nothing with it");
    } else if (about.needs == EditNeeds::pattern) {
        if (!is_pair || !py::isinstance<py::dict>(words[1])) refuse("a pattern with it");
    } else if (!is_pair || PyNumber_Check(words[1].ptr()) == 0) {
        refuse("a number with it");
    }
    Edit edit{*kind};
    if (about.needs == EditNeeds::pattern) {
        edit.other = pattern_of(words[1].cast<py::dict>());
    } else if (is_pair) {
        edit.number = words[1].cast<double>();
    }
    return edit;
}

py::object edit_pattern(const py::dict& pattern, const py::sequence& edits,
                        const py::object& model) {
    const PerceptualModelParams params = model_of(model);
    Vibration before;
    before.source = pattern_of(pattern);
    std::vector<Edit> all;
    for (const py::handle given : edits) all.push_back(edit_of(given));
    const VibrationSource after = value_of(beside_python(
        [&](const std::stop_token&) { return edited_source(before, all, params.coding.tables); }));
    const double usual_s = Pattern().duration_s;
    if (const auto* layered = std::get_if<LayeredPattern>(&after)) {
        return python_of(json_of(*layered, usual_s, {}));
    }
    const auto* made = std::get_if<Pattern>(&after);
    if (made == nullptr) {
        throw py::value_error(
            "edits: expected what stays a pattern, a join with layers is samples");
    }
    return python_of(json_of(*made, usual_s));
}

PYBIND11_MODULE(tactspace, module) {
    py::options plain;
    plain.disable_function_signatures();  // help.h has them, as inspect.signature() reads them
    const auto none = py::none();
    const py::tuple nobody;
    module.doc() = help::kModule;
    module.attr("__version__") = TACT_VERSION;
    // NumPy is found here: in the first call of a daemon thread, the interpreter's end would end
    // that thread within pybind11's search for it, and so the process.
    const py::array_t<double> numpy_is_here(0);
    py::module_::import("atexit").attr("register")(py::cpp_function(end_beside_python));
    py::list metrics;
    for (const Metric metric : kMetrics) metrics.append(traits(metric).key);
    module.attr("metrics") = py::tuple(metrics);
    module.def("predict", predict_matrix, help::kPredict, "waves"_a, "metric"_a = "pm",
               "rate_hz"_a = kModelRateHz, "threads"_a = 0, "model"_a = none);
    module.def("stages", stages, help::kStages, "wave"_a, "rate_hz"_a = kModelRateHz,
               "model"_a = none);
    module.def("unfelt", unfelt_places, help::kUnfelt, "waves"_a, "rate_hz"_a = kModelRateHz,
               "threads"_a = 0, "model"_a = none);
    module.def("space", space, help::kSpace, "D"_a, "dimensions"_a = 3, "threads"_a = 0);
    module.def("subset", subset, help::kSubset, "D"_a, "k"_a, "keep"_a = nobody, "drop"_a = nobody,
               "objective"_a = "max-min", "threads"_a = 0, "time_limit_s"_a = 60.0);
    module.def("compare", compare, help::kCompare, "D"_a, "ratings"_a, "metric"_a = "",
               "threads"_a = 0);
    module.def("plan", plan_study, help::kPlan, "D"_a, "rival"_a, "people"_a, "rho"_a = none,
               "reliability"_a = none, "pilot"_a = none, "pairs"_a = 0, "studies"_a = 200,
               "seed"_a = 12, "threads"_a = 0);
    module.def("train", train_sets, help::kTrain, "sets"_a, "objective"_a = "mean-rho",
               "step"_a = 0.1, "leave_out"_a = "", "rate_hz"_a = kModelRateHz, "threads"_a = 0,
               "model"_a = none);
    module.def("render", render_pattern, help::kRender, "pattern"_a, "rate_hz"_a = kModelRateHz);
    module.def("edit", edit_pattern, help::kEdit, "pattern"_a, "edits"_a, "model"_a = none);
    module.def("read_set", read_set, help::kReadSet, "path"_a);
    module.def("read_ratings", read_ratings_file, help::kReadRatings, "path"_a, "names"_a = none,
               "scale"_a = "guess");
}

}  // namespace

}  // namespace tact
