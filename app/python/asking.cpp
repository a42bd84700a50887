#include "app/python/parts.h"

#include <nlohmann/json.hpp>

#include <limits>
#include <tuple>

#include "model/ask/parted_pair.h"
#include "model/ask/steps.h"
#include "model/grouping/set_groups.h"
#include "model/tasks/set_pairs.h"
#include "model/tasks/set_report.h"

namespace tact {

namespace py = pybind11;

namespace {

// `name`: of the argument.
std::pair<std::size_t, std::size_t> two_in(const py::object& pair, const PatternSet& set,
                                           const std::string& name) {
    const bool is_pair =
        (py::isinstance<py::tuple>(pair) || py::isinstance<py::list>(pair)) && py::len(pair) == 2;
    if (!is_pair) {
        throw py::type_error(name + ": expected two patterns, got " + described(pair));
    }
    const std::size_t a = place_in(pair[py::int_(0)], set, name + "[0]");
    const std::size_t b = place_in(pair[py::int_(1)], set, name + "[1]");
    if (a == b) throw py::value_error(name + ": expected two different patterns");
    return {a, b};
}

PairToPart pair_in(const py::object& pair, const py::object& change, const py::object& among,
                   const PatternSet& set) {
    PairToPart result;
    std::tie(result.a, result.b) = two_in(pair, set, "pair");
    const std::string name =
        change.is_none() ? "" : set.vibrations[place_in(change, set, "change")].name;
    result.changeable = changeable_of(set, result.a, result.b, name);
    if (result.changeable.empty()) {
        throw py::value_error(name.empty() ? "pair: both are locked or measured; change names a "
                                             "locked one to change all the same"
                                           : "change: expected the one of the pair that is to be "
                                             "changed, a pattern made of parameters, got \"" +
                                                 name + "\"");
    }
    if (py::isinstance<py::str>(among)) {
        throw py::type_error("among: expected a list of patterns, got " + described(among));
    }
    for (const py::handle one : among) {
        result.among.push_back(place_in(py::reinterpret_borrow<py::object>(one), set,
                                        "among[" + std::to_string(result.among.size()) + "]"));
    }
    return result;
}

}  // namespace

py::dict separate(const py::object& given, const py::object& pair, const py::object& change,
                  const py::object& among, const py::object& closest, const py::object& threshold,
                  const py::object& threads, const py::object& progress) {
    Progress told(progress);
    const PatternSet set = pattern_set_of(given);
    PairToPart to_part = pair_in(pair, change, among, set);
    to_part.share = within(closest, "closest", {0.0, 100.0}) / 100.0;
    to_part.threshold = optional_within(threshold, "threshold", {0.0, 1e9});
    PartingOptions options;
    options.threads = threads_of(threads);
    options.progress_of = [&told](const std::string& what) {
        return told.for_work(what.starts_with("changing") ? "changing" : "comparing pairs");
    };
    const auto parted = beside_python(
        [&](std::stop_token stop) {
            options.stop = stop;
            return parted_pair(set, set, to_part, options);
        },
        &told);
    return python_of(json_of(*parted, names_of(set)));
}

py::dict report(const py::object& given, const py::object& count, const py::object& closer_than,
                const py::object& include_unfelt, const py::object& threads,
                const py::object& time_limit_s, const py::object& progress) {
    Progress told(progress);
    const PatternSet set = pattern_set_of(given);
    if (set.vibrations.size() < 2) {
        throw py::value_error("set: expected at least two patterns to compare, got " +
                              std::to_string(set.vibrations.size()));
    }
    SetReportRequest request;
    if (!count.is_none()) {
        request.count = static_cast<std::size_t>(whole_within(count, "count", {2.0, 1e9}));
    }
    if (py::isinstance<py::tuple>(closer_than) || py::isinstance<py::list>(closer_than)) {
        request.closer_than_pair = two_in(closer_than, set, "closer_than");
    } else {
        request.closer_than = optional_within(closer_than, "closer_than", {0.0, 1e9});
    }
    request.picks_unfelt = py::bool_(include_unfelt);
    request.threads = threads_of(threads);
    request.comparing = told.for_work("comparing pairs");
    request.picking.progress = told.for_work("searching");
    request.picking.time_limit_s =
        within(time_limit_s, "time_limit_s", {0.0, std::numeric_limits<double>::infinity()});
    const auto made = beside_python(
        [&](std::stop_token stop) {
            request.stop = stop;
            return set_report(set, set, request);
        },
        &told);
    if (!made->fault.empty()) throw py::value_error(made->fault);
    return python_of(json_of(*made, set));
}

py::dict steps(const py::object& given, const py::object& start, const py::object& end,
               const py::object& count, const py::object& parameter, const py::object& metric,
               const py::object& threads, const py::object& progress) {
    Progress told(progress);
    const PatternSet set = pattern_set_of(given);
    const std::size_t from = place_in(start, set, "start");
    const std::size_t to = place_in(end, set, "end");
    if (from == to) throw py::value_error("end: expected another pattern than start");
    const auto pattern_at = [&set](std::size_t place, const char* name) {
        const auto* pattern = std::get_if<Pattern>(&set.vibrations[place].source);
        if (pattern != nullptr) return *pattern;
        throw py::value_error(std::string(name) +
                              ": expected a pattern made of parameters, got \"" +
                              set.vibrations[place].name + "\"");
    };
    const Pattern first = pattern_at(from, "start");
    const auto last = end_of_way(first, pattern_at(to, "end"), text_in(parameter, "parameter"));
    if (!last) throw py::value_error("parameter: " + last.error().message);
    const auto most = static_cast<double>(kMostSteps);
    const StepsQuestion question{
        first, *last, static_cast<std::size_t>(whole_within(count, "count", {2.0, most})),
        static_cast<StepMeasure>(choice_of(metric, "metric", kStepMeasures)), set.model};
    StepsOptions options{threads_of(threads), {}, told.for_work("placing steps")};
    const auto made = beside_python(
        [&](std::stop_token stop) {
            options.stop = stop;
            return even_steps(question, options);
        },
        &told);
    Loaded written;
    written.set = set_of_steps(set, from, to, *made);
    py::dict answer = python_of(json_of(*made, names_of(written.set)));
    answer["set"] = dict_of(written);
    return answer;
}

namespace py = pybind11;

namespace {

AskedGroups asked_in(const py::object& count, const py::object& cut) {
    if (!count.is_none() && !cut.is_none()) {
        throw py::value_error("cut: expected without count, or count without it");
    }
    AskedGroups asked{.cut = optional_within(cut, "cut", {0.0, 1e9})};
    if (!count.is_none()) {
        asked.count = static_cast<std::size_t>(whole_within(count, "count", {1.0, 1e9}));
    }
    return asked;
}

}  // namespace

py::dict groups(const py::object& given, const py::object& count, const py::object& cut,
                const py::object& threads, const py::object& progress) {
    Progress told(progress);
    const PatternSet set = pattern_set_of(given);
    if (set.vibrations.size() < 2) throw py::value_error("set: expected at least 2 patterns");
    const AskedGroups asked = asked_in(count, cut);
    PairsRequest request;
    request.options.threads = threads_of(threads);
    request.options.progress = told.for_work("comparing patterns");
    const auto pairs = beside_python(
        [&](std::stop_token stop) {
            request.options.stop = stop;
            return set_pairs(set, request);
        },
        &told);
    const SetGroups tree = groups_of_set(set, pairs->apart, pairs->unfelt);
    const auto number = asked_group_count(tree, asked);
    if (!number) throw py::value_error("count: " + number.error().message);
    return python_of(json_of(tree, groups_at(tree, pairs->apart, *number), names_of(set)));
}

}  // namespace tact
