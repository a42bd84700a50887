#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/python/parts.h"
#include "model/io/people/agreement_json.h"
#include "model/io/people/table2.h"
#include "model/tasks/set_agreement.h"

namespace tact {

namespace py = pybind11;
using namespace py::literals;  // NOLINT(google-build-using-namespace): of _a

namespace {

Dissimilarity of_patterns(const py::handle& matrix, const std::string& name,
                          const RatingStudy& study) {
    Dissimilarity read = dissimilarities_of(py::reinterpret_borrow<py::object>(matrix), name);
    if (read.size == study.labels.size()) return read;
    throw py::value_error("ratings: expected those of the " + std::to_string(read.size) +
                          " patterns of " + name + ", got " + std::to_string(study.labels.size()));
}

// SPQI's values are so close to 1 that they are compared by their ranks.
Dissimilarity to_compare(Metric metric, Dissimilarity matrix) {
    if (metric == Metric::spqi) {
        matrix.condensed = average_ranks(values_to_rank(metric, matrix));
    }
    return matrix;
}

// Matrices by their keys: those of metrics first, as the table has them, then others.
struct Keyed {
    std::vector<std::string> keys;
    std::vector<Metric> metrics;
    std::vector<Dissimilarity> matrices;
};

Keyed keyed(const py::dict& given, const RatingStudy& study) {
    Keyed result;
    std::vector<Dissimilarity> others;
    std::vector<std::string> names;
    for (const auto& [key, matrix] : given) {
        const std::string name = text_in(key, "D");
        Dissimilarity read = of_patterns(matrix, "D[\"" + name + "\"]", study);
        if (const Expected<Metric> metric = metric_named(name)) {
            result.keys.push_back(name);
            result.metrics.push_back(*metric);
            result.matrices.push_back(to_compare(*metric, std::move(read)));
        } else {
            names.push_back(name);
            others.push_back(std::move(read));
        }
    }
    result.keys.insert(result.keys.end(), names.begin(), names.end());
    std::ranges::move(others, std::back_inserter(result.matrices));
    if (result.keys.empty()) throw py::value_error("D: expected at least one matrix");
    return result;
}

Keyed keyed(const py::object& matrix, const std::string& metric, const RatingStudy& study) {
    if (py::isinstance<py::dict>(matrix)) return keyed(matrix.cast<py::dict>(), study);
    Dissimilarity read = of_patterns(matrix, "D", study);
    if (metric.empty()) return {{""}, {}, {std::move(read)}};
    const Metric by = value_of(metric_named(metric));
    return {{metric}, {by}, {to_compare(by, std::move(read))}};
}

std::vector<Nuisance> nuisances_of(const py::object& given, const RatingStudy& study) {
    std::vector<Nuisance> nuisances;
    if (given.is_none()) return nuisances;
    for (const auto& [key, matrix] : dict_in(given, "given")) {
        const std::string name = text_in(key, "given");
        nuisances.push_back({name, of_patterns(matrix, "given[\"" + name + "\"]", study)});
    }
    return nuisances;
}

py::dict dict_of(const PeopleAgreement& all, std::size_t metric) {
    const RatedPeople& people = all.people;
    py::dict dict =
        python_of(json_of(RatedTable{people, all.raters, all.table}, metric, Bookkeeping::plain));
    dict["K_paper"] = agreement_of(all.table.evaluations[metric], Bookkeeping::paper).k;
    dict["participants_left_out"] = people.mark.left_out;
    dict["rehearsals_left_out"] = people.mark.rehearsals;
    return dict;
}

}  // namespace

py::dict compare(const py::object& matrix, const py::object& ratings, const py::object& metric,
                 const py::object& threads, const py::object& given, const py::object& progress) {
    Progress told(progress);
    const RatingStudy study = study_of(ratings);
    const Keyed of_all = keyed(matrix, text_in(metric, "metric"), study);
    AgreementRequest request{of_all.metrics, of_all.matrices, nuisances_of(given, study)};
    request.params.threads = threads_of(threads);
    request.progress = told.for_work("comparing with people");
    const auto found = beside_python_or_alone(
        [study, request](const std::stop_token& stop) mutable {
            request.stop = stop;
            return people_agreement(study, std::move(request));
        },
        &told);
    if (!found->fault.empty()) throw_error(found->fault);
    const PeopleAgreement& all = *found;
    if (!py::isinstance<py::dict>(matrix)) return dict_of(all, 0);
    py::dict by_key;
    for (std::size_t m = 0; m < of_all.keys.size(); ++m) {
        by_key[py::str(of_all.keys[m])] = dict_of(all, m);
    }
    return by_key;
}

namespace {

struct PaperSet {
    PatternSet set;
    RatingStudy study;
};

// Waves as recordings: their samples are those that a pattern is rendered to.
PaperSet paper_set_of(const py::dict& given, std::size_t number) {
    const std::string place = "sets[" + std::to_string(number) + "]";
    for (const char* key : {"waves", "ratings"}) {
        if (given.contains(key) && !given[key].is_none()) continue;
        throw py::value_error(place + ": expected a dict with \"waves\" and \"ratings\"");
    }
    PaperSet result;
    result.study = study_of(py::object(given["ratings"]));
    result.set.name = given.contains("name") ? text_in(given["name"], place + "[\"name\"]") : "";
    if (result.set.name.empty()) result.set.name = "set " + std::to_string(number + 1);
    if (given.contains("model")) result.set.model = model_of(given["model"]);
    const std::vector<Waveform> waves = waves_of(given["waves"], kModelRateHz);
    if (waves.size() != result.study.labels.size()) {
        throw py::value_error(place + ": expected ratings of its " + std::to_string(waves.size()) +
                              " waves, got those of " + std::to_string(result.study.labels.size()) +
                              " patterns");
    }
    for (std::size_t k = 0; k < waves.size(); ++k) {
        Measurement wave;
        wave.waveform = std::make_shared<const Waveform>(waves[k]);
        Vibration& one = result.set.vibrations.emplace_back();
        one.name = result.study.labels[k];
        one.source = std::move(wave);
    }
    return result;
}

// A dict a row, of texts and numbers; NaN for "NA".
py::list rows_of_csv(const std::string& text) {
    constexpr const char* kTexts[] = {"set", "metric", "a", "b", "map", "pattern"};
    const py::object lines = py::module_::import("io").attr("StringIO")(text, "newline"_a = "");
    py::list rows;
    for (const py::handle row : py::module_::import("csv").attr("DictReader")(lines)) {
        py::dict values;
        for (const auto& [key, cell] : py::reinterpret_borrow<py::dict>(row)) {
            const auto name = key.cast<std::string>();
            const auto word = cell.cast<std::string>();
            if (std::ranges::find(kTexts, name) != std::end(kTexts)) {
                values[key] = cell;
            } else {
                values[key] = word == "NA" ? py::float_(std::nan(""))
                                           : py::float_(py::reinterpret_borrow<py::object>(cell));
            }
        }
        rows.append(values);
    }
    return rows;
}

struct PaperTables {
    std::ostringstream table2;
    std::ostringstream pairs;
    std::ostringstream maps;
};

Expected<std::array<std::string, 3>> paper_tables(const std::vector<PaperSet>& sets, int threads,
                                                  const std::function<void(double)>& progress,
                                                  const std::stop_token& stop) {
    const std::vector<Metric> metrics(table2_metrics().begin(), table2_metrics().end());
    std::vector<PeopleAgreement> all;
    for (const PaperSet& one : sets) {
        MetricOptions options;
        options.threads = threads;
        options.stop = stop;
        auto matrices = compared_matrices(one.set, metrics, nullptr, options);
        if (!matrices) return Error{"stopped"};
        AgreementRequest request{metrics, *std::move(matrices)};
        request.params.threads = threads;
        request.stop = stop;
        request.progress = [&, done = static_cast<double>(all.size())](double share) {
            if (progress) progress((done + share) / static_cast<double>(sets.size()));
        };
        auto answer = people_agreement(one.study, std::move(request));
        if (!answer) return Error{"stopped"};
        if (!answer->fault.empty()) return Error{one.set.name + ": " + answer->fault};
        all.push_back(*std::move(answer));
    }
    std::vector<Table2Set> rated;
    for (std::size_t k = 0; k < sets.size(); ++k) {
        rated.push_back(table2_set(sets[k].set, all[k].people, all[k].table));
    }
    PaperTables tables;
    write_table2_csv(tables.table2, rated);
    write_table2_pairs_csv(tables.pairs, rated);
    write_table2_maps_csv(tables.maps, rated);
    return std::array{tables.table2.str(), tables.pairs.str(), tables.maps.str()};
}

}  // namespace

py::dict paper(const py::object& given, const py::object& threads, const py::object& progress) {
    Progress told(progress);
    std::vector<PaperSet> sets;
    for (const py::dict& one : dicts_in(given, "sets")) {
        sets.push_back(paper_set_of(one, sets.size()));
    }
    if (sets.empty()) throw py::value_error("sets: expected at least one");
    const auto [table2, pairs, maps] = value_of(beside_python_or_alone(
        [sets, count = threads_of(threads), to_tell = told.for_work("comparing with people")](
            const std::stop_token& stop) { return paper_tables(sets, count, to_tell, stop); },
        &told));
    return py::dict("table2"_a = rows_of_csv(table2), "pairs"_a = rows_of_csv(pairs),
                    "maps"_a = rows_of_csv(maps));
}

}  // namespace tact
