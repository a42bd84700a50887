#include <nlohmann/json.hpp>

#include "app/python/beside_python.h"
#include "app/python/documents.h"
#include "app/python/functions.h"
#include "app/python/set_dict.h"
#include "model/grouping/set_groups.h"
#include "model/tasks/set_pairs.h"

namespace tact {

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
