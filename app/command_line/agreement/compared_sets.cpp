#include "app/command_line/agreement/compared_sets.h"

#include <algorithm>
#include <iostream>
#include <iterator>
#include <span>
#include <utility>

#include "app/command_line/output.h"
#include "app/command_line/rated_sets.h"
#include "app/foreign/foreign_metric.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

void tell_remark(const std::string& remark) {
    std::cerr << "tactspace: " << shown_text(remark) << "\n";
}

// Those asked for, or all.
Expected<std::vector<Metric>> metrics_of(const CompareCommand& command) {
    if (command.metrics.empty()) return std::vector<Metric>(kMetrics.begin(), kMetrics.end());
    std::vector<Metric> metrics;
    for (const std::string& key : command.metrics) {
        const Expected<Metric> metric = metric_named(key);
        if (!metric) return metric.error();
        metrics.push_back(*metric);
    }
    return metrics;
}

// "duration", "level", or a matrix in a file by the names of the set.
Expected<std::vector<Nuisance>> nuisances_of(const CompareCommand& command, const PatternSet& set) {
    std::vector<Nuisance> nuisances;
    for (const std::string& given : command.given) {
        if (auto named = nuisance_named(given, set)) {
            nuisances.push_back({given, *std::move(named)});
            continue;
        }
        Expected<Dissimilarity> read =
            dissimilarities_in(given, names_of(set), command.ratings.written);
        if (!read) return read.error();
        nuisances.push_back({std::filesystem::path(given).stem().string(), *std::move(read)});
    }
    return nuisances;
}

Expected<SetAgreement> agreement_of(const CompareCommand& command, std::span<const Metric> metrics,
                                    const RatedPatterns& patterns) {
    const Expected<std::vector<Nuisance>> nuisances = nuisances_of(command, patterns.set);
    if (!nuisances) return nuisances.error();
    // Before all that takes long: what is wrong with them is told at once.
    std::vector<ForeignMetric> foreign;
    std::vector<Dissimilarity> theirs;
    for (const std::string& from : command.metrics_from) {
        Expected<Dissimilarity> matrix = foreign_matrix(
            from, patterns.set, {.written = command.ratings.written, .remark = tell_remark});
        if (!matrix) return matrix.error();
        theirs.push_back(*std::move(matrix));
        foreign.push_back(foreign_metric(from));
    }
    EvaluationParams params;
    params.threads = command.common.threads;
    params.dimensions = command.dimensions;
    Expected<RatedPeople> people = rated_people(patterns.study, params);
    if (!people) return Error{patterns.name + ": " + people.error().message};
    MetricOptions options;
    options.threads = command.common.threads;
    options.progress = progress_line("comparing metrics");
    auto matrices = *compared_matrices(patterns.set, metrics, nullptr, options);
    std::ranges::move(theirs, std::back_inserter(matrices));
    MetricTable table = metric_table(patterns.study, *people, metrics, std::move(matrices),
                                     *nuisances, params, progress_line("resampling"));
    const std::size_t rated = patterns.set.vibrations.size() - people->unrated.size();
    return SetAgreement{patterns.name,
                        rated,
                        *std::move(people),
                        patterns.left_out,
                        patterns.labels,
                        std::move(table),
                        inter_rater(patterns.study),
                        std::move(foreign)};
}

}  // namespace

Expected<std::vector<ComparedSet>> compared_sets(const CompareCommand& command) {
    const Expected<std::vector<Metric>> metrics = metrics_of(command);
    if (!metrics) return metrics.error();
    Expected<std::vector<RatedPatterns>> all = load_rated(command.common, command.ratings);
    if (!all) return all.error();
    std::vector<ComparedSet> sets;
    for (RatedPatterns& patterns : *all) {
        Expected<SetAgreement> agreement = agreement_of(command, *metrics, patterns);
        if (!agreement) return agreement.error();
        sets.push_back({std::move(patterns.set), *std::move(agreement)});
    }
    return sets;
}

}  // namespace tact
