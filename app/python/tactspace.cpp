// What the Python package tactspace (__init__.py) is made of: the same numbers as the program's,
// for notebooks, and for R through reticulate.
//
// Input     arrays and dicts (app/python/parts.h)
// Output    help.h says what of each function; __init__.pyi has the types
// Left out  what a screen or a device is needed for; studies and candidates, which the command line
//           has.
// Exact     same bits as the command line.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

#include "app/python/help.h"
#include "app/python/parts.h"
#include "model/map/mds.h"
#include "model/perceptual_model/rhythm_envelope.h"
#include "model/physiology/neural_coding.h"
#include "model/signal/resample.h"
#include "model/subset/subset.h"
#include "model/tasks/set_pairs.h"

namespace tact {

namespace {

namespace py = pybind11;
using namespace py::literals;  // NOLINT(google-build-using-namespace): of _a

py::array predict_matrix(const py::object& waves, const py::object& metric,
                         const py::object& rate_hz, const py::object& threads,
                         const py::object& model, const py::object& progress) {
    Progress told(progress);
    const Metric by = value_of(metric_named(text_in(metric, "metric")));
    const PerceptualModelParams params = model_of(model);
    PairsRequest request{by, false};
    request.options.threads = threads_of(threads);
    request.options.progress = told.for_work("comparing pairs");
    std::vector<Waveform> given = waves_of(waves, rate_of(rate_hz));
    if (given.size() < 2) {
        throw py::value_error("waves: expected at least two to compare, got " +
                              std::to_string(given.size()));
    }
    return square_array(*beside_python(
        [&](std::stop_token stop) {
            request.options.stop = stop;
            auto pairs = set_pairs(at_model_rate(std::move(given), stop), params, request);
            return pairs ? std::optional(std::move(pairs->apart)) : std::nullopt;
        },
        &told));
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

py::array unfelt_places(const py::object& waves, const py::object& rate_hz,
                        const py::object& threads, const py::object& model) {
    const PerceptualModelParams params = model_of(model);
    const int cores = threads_of(threads);
    std::vector<Waveform> given = waves_of(waves, rate_of(rate_hz));
    const auto places = *beside_python([&](std::stop_token stop) {
        return unfelt_in(at_model_rate(std::move(given), stop), params, cores, stop);
    });
    return array_of(std::vector<int>(places.begin(), places.end()));
}

py::dict stages(const py::object& wave, const py::object& rate_hz, const py::object& model) {
    const PerceptualModelParams params = model_of(model);
    Waveform input = wave_of(wave, "wave", rate_of(rate_hz));
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

py::tuple space(const py::object& matrix, const py::object& dimensions, const py::object& threads,
                const py::object& progress) {
    Progress told(progress);
    Dissimilarity dissimilarity = dissimilarities_of(matrix, "D");
    MdsParams params =
        standard_mds_params(dissimilarity.size, whole_within(dimensions, "dimensions", {1, 10}));
    params.threads = threads_of(threads);
    const PerceptualSpace made = beside_python_or_alone(
        [apart = std::move(dissimilarity), params,
         to_tell = told.for_work("mapping")](std::stop_token stop) {
            return nonmetric_mds(apart, params, stop, [&](std::size_t starts) {
                if (to_tell) to_tell(static_cast<double>(starts) / (params.random_starts + 1));
            });
        },
        &told);
    warn(remark_on(made));
    return py::make_tuple(array_of(made.points), made.stress1);
}

// NOLINTNEXTLINE(readability-function-size): it has the arguments of Python's
py::dict subset(const py::object& matrix, const py::object& k, const py::object& keep,
                const py::object& drop, const py::object& objective, const py::object& threads,
                const py::object& time_limit_s, const py::object& progress) {
    Progress told(progress);
    Dissimilarity dissimilarity = dissimilarities_of(matrix, "D");
    constexpr const char* kObjectives[] = {"max-min", "max-sum"};
    const bool by_sum = choice_of(objective, "objective", kObjectives) == 1;
    // The rest is said as everywhere (check_subset).
    const SubsetProblem problem{static_cast<std::size_t>(whole_within(k, "k", {0, 1e9})),
                                by_sum ? SubsetObjective::max_sum : SubsetObjective::max_min,
                                places_of(keep, "keep", dissimilarity.size),
                                places_of(drop, "drop", dissimilarity.size)};
    SubsetOptions options;
    options.threads = threads_of(threads);
    options.time_limit_s =
        within(time_limit_s, "time_limit_s", {0.0, std::numeric_limits<double>::infinity()});
    options.progress = told.for_work("searching");
    const SubsetAnswer answer = value_of(beside_python_or_alone(
        [apart = std::move(dissimilarity), problem, options](std::stop_token stop) mutable {
            options.stop = stop;
            return most_distinct_subset(apart, problem, options);
        },
        &told));
    const Subset& best = answer.best;
    const std::vector<int> members(best.members.begin(), best.members.end());
    return py::dict("members"_a = array_of(members), "weakest"_a = best.weakest,
                    "weakest_dissimilarity"_a = best.weakest_dissimilarity, "sum"_a = best.sum,
                    "optimal"_a = answer.proof == SubsetProof::optimal, "bound"_a = answer.bound);
}

// Help of predict(), with the keys of the metrics that its words do not name.
std::string help_of_predict() {
    constexpr std::string_view kMark = "{, others}";
    constexpr std::size_t kColumns = 100;
    const std::string indent(9, ' ');
    const std::string words = help::kPredict;
    const std::size_t at = words.find(kMark);
    std::string text = words.substr(0, at);
    for (const Metric metric : kMetrics) {
        if (metric == Metric::pm || metric == Metric::nc || metric == Metric::oc) continue;
        const std::string key = " \"" + std::string(traits(metric).key) + '"';
        text += ',';
        const std::size_t column = text.size() - text.rfind('\n') - 1;
        const bool fits = column + key.size() + 1 <= kColumns;  // with the comma behind it
        text += fits ? key : '\n' + indent + key.substr(1);
    }
    return text + words.substr(at + kMark.size());
}

// Arguments are taken as objects: what is wrong with one is said with its name.
void define_predictions(py::module_& module) {
    const auto none = py::none();
    const py::tuple nobody;
    module.def("predict", predict_matrix, help_of_predict().c_str(), "waves"_a, "metric"_a = "pm",
               "rate_hz"_a = kModelRateHz, "threads"_a = 0, "model"_a = none, py::kw_only(),
               "progress"_a = none);
    module.def("stages", stages, help::kStages, "wave"_a, "rate_hz"_a = kModelRateHz,
               "model"_a = none);
    module.def("unfelt", unfelt_places, help::kUnfelt, "waves"_a, "rate_hz"_a = kModelRateHz,
               "threads"_a = 0, "model"_a = none);
    module.def("space", space, help::kSpace, "D"_a, "dimensions"_a = 3, "threads"_a = 0,
               py::kw_only(), "progress"_a = none);
    module.def("subset", subset, help::kSubset, "D"_a, "k"_a, "keep"_a = nobody, "drop"_a = nobody,
               "objective"_a = "max-min", "threads"_a = 0, "time_limit_s"_a = 60.0, py::kw_only(),
               "progress"_a = none);
}

void define_people(py::module_& module) {
    const auto none = py::none();
    module.def("compare", compare, help::kCompare, "D"_a, "ratings"_a, "metric"_a = "",
               "threads"_a = 0, py::kw_only(), "given"_a = none, "progress"_a = none);
    module.def("paper", paper, help::kPaper, "sets"_a, "threads"_a = 0, py::kw_only(),
               "progress"_a = none);
    module.def("plan", plan_study, help::kPlan, "D"_a, "rival"_a, "people"_a, "rho"_a = none,
               "reliability"_a = none, "pilot"_a = none, "pairs"_a = 0, "studies"_a = 200,
               "seed"_a = 12, "threads"_a = 0, py::kw_only(), "progress"_a = none);
    module.def("train", train_sets, help::kTrain, "sets"_a, "objective"_a = "mean-rho",
               "step"_a = 0.1, "leave_out"_a = "", "rate_hz"_a = kModelRateHz, "threads"_a = 0,
               "model"_a = none, py::kw_only(), "progress"_a = none);
}

void define_sets(py::module_& module) {
    const auto none = py::none();
    module.def("render", render_pattern, help::kRender, "pattern"_a, "rate_hz"_a = kModelRateHz);
    module.def("edit", edit_pattern, help::kEdit, "pattern"_a, "edits"_a, "model"_a = none);
    module.def("separate", separate, help::kSeparate, "set"_a, "pair"_a, "change"_a = none,
               "among"_a = py::tuple(), "closest"_a = 5.0, "threshold"_a = none, "threads"_a = 0,
               py::kw_only(), "progress"_a = none);
    module.def("report", report, help::kReport, "set"_a, "count"_a = none, "closer_than"_a = none,
               "include_unfelt"_a = false, "threads"_a = 0, "time_limit_s"_a = 60.0, py::kw_only(),
               "progress"_a = none);
    module.def("steps", steps, help::kSteps, "set"_a, "start"_a, "end"_a, "count"_a = 5,
               "parameter"_a = "", "metric"_a = "pm", "threads"_a = 0, py::kw_only(),
               "progress"_a = none);
    module.def("groups", groups, help::kGroups, "set"_a, "count"_a = none, "cut"_a = none,
               "threads"_a = 0, py::kw_only(), "progress"_a = none);
    module.def("export", export_set, help::kExport, "set"_a, "folder"_a, "format"_a,
               "patterns"_a = py::tuple(), "onto"_a = "", "rate_hz"_a = none, "bits"_a = none,
               "count"_a = 0, "loss"_a = true, "overwrite"_a = false, "threads"_a = 0,
               py::kw_only(), "progress"_a = none);
    module.def("read_set", read_set, help::kReadSet, "path"_a, py::kw_only(), "actuator"_a = "",
               "progress"_a = none);
    module.def("write_set", write_set, help::kWriteSet, "path"_a, "set"_a);
    module.def("read_ratings", read_ratings_file, help::kReadRatings, "path"_a, "names"_a = none,
               "scale"_a = "guess");
}

PYBIND11_MODULE(_tactspace, module) {
    py::options plain;
    plain.disable_function_signatures();  // help.h has them, as inspect.signature() reads them
    module.doc() = help::kModule;
    module.attr("__version__") = TACT_VERSION;
    // NumPy is found here: in the first call of a daemon thread, the interpreter's end would end
    // that thread within pybind11's search for it, and so the process.
    const py::array_t<double> numpy_is_here(0);
    py::module_::import("atexit").attr("register")(py::cpp_function(end_beside_python));
    py::list metrics;
    for (const Metric metric : kMetrics) metrics.append(traits(metric).key);
    module.attr("metrics") = py::tuple(metrics);
    define_predictions(module);
    define_people(module);
    define_sets(module);
}

}  // namespace

}  // namespace tact
