// tactspace compare: metrics against what people said, as in the paper's Table 2.

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>

#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/command_line/people/people_words.h"
#include "app/command_line/rated_sets.h"
#include "app/command_line/text_table.h"
#include "model/evaluation/evaluation.h"
#include "model/evaluation/metric_comparison.h"
#include "model/study/agreement.h"
#include "model/study/ratings.h"

namespace tact {

namespace {

struct MetricAgreement {
    Metric metric = Metric::pm;
    Evaluation evaluation;
};

struct SetResult {
    std::string name;
    std::size_t patterns = 0;
    RatedPeople people;
    std::vector<LeftOutParticipant> left_out;
    Labels labels;
    std::vector<MetricAgreement> rows;
    InterRater raters{};
};

const RatedSet& rated_of(const SetResult& result) { return rated_part(result.people.rated); }

const char* key_of(const MetricAgreement& row) { return traits(row.metric).key; }

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

Expected<SetResult> compared(const CompareCommand& command, std::span<const Metric> metrics,
                             const RatedPatterns& patterns) {
    EvaluationParams params;
    params.threads = command.common.threads;
    Expected<RatedPeople> people = rated_people(patterns.study, params);
    if (!people) return Error{patterns.name + ": " + people.error().message};
    SetResult result{patterns.name,      patterns.set.vibrations.size() - people->unrated.size(),
                     *std::move(people), patterns.left_out,
                     patterns.labels,    {}};
    result.raters = inter_rater(patterns.study);
    MetricOptions options;
    options.threads = command.common.threads;
    options.progress = progress_line("comparing metrics");
    const auto matrices = *compared_matrices(patterns.set, metrics, nullptr, options);
    for (std::size_t k = 0; k < metrics.size(); ++k) {
        result.rows.push_back({metrics[k], evaluate(matrices[k], result.people.rated, params)});
    }
    return result;
}

// What is the same for all metrics of the set.
std::string head_of(const SetResult& result) {
    const Reliability& people = result.people.reliability;
    const PerceptualSpace& space = rated_of(result).people.space;
    const AlienationChance& chance = rated_of(result).k_chance;
    std::string text = result.name + ": " + std::to_string(result.patterns) + " patterns, " +
                       std::to_string(result.people.rated_pairs) + " of " +
                       std::to_string(pair_count(result.patterns)) + " pairs rated";
    if (people.voices > 1) {
        text += people.is_of_one_person ? ", one participant, " : ", ";
        text += std::to_string(people.voices);
        text += people.is_of_one_person ? " repetitions" : " participants";
        text += "\npeople        reliability of their mean " +
                fixed_digits(people.spearman_brown, 3) +
                " (split halves, Spearman-Brown)\n              a metric can reach rho " +
                fixed_digits(people.ceiling_of_mean, 3) + " with their mean; one of them reaches " +
                fixed_digits(people.one_with_others, 3) + " with the mean of the others";
    } else {
        text += "\npeople        no repetitions: how far a metric can agree is not known";
    }
    text += "\n" + text_of(result.raters);
    text += "their map     stress-1 " + fixed_digits(space.stress1, 3) + ", " +
            stress_label(space.stress1) + "; of random ratings " +
            fixed_digits(rated_of(result).random_stress.mean, 3);
    text += "\nchance        unrelated maps have K " + fixed_digits(chance.mean, 3) +
            ", nine in ten " + range_text(chance.middle.low, chance.middle.high, 3) + "\n";
    const std::string unrated =
        remark_on_unrated(result.people.unrated, result.patterns + result.people.unrated.size());
    if (!unrated.empty()) text += unrated + "\n";
    return text + text_of(result.labels) + text_on_people(result.people.synthetic, result.left_out);
}

std::vector<TextRow> table_of(const SetResult& result) {
    std::vector<TextRow> rows{{"metric", "rho", "95 % interval", "p", "tau-b", "K", "K spread",
                               "K p", "1-K/chance", "K Procrustes", "stress-1"}};
    for (const MetricAgreement& row : result.rows) {
        const Evaluation& e = row.evaluation;
        rows.push_back({key_of(row), fixed_digits(e.rho, 3),
                        range_text(e.rho_interval.low, e.rho_interval.high, 2),
                        fixed_digits(e.rho_p, 4), fixed_digits(e.tau_b, 3), fixed_digits(e.k, 3),
                        range_text(e.k_spread.low, e.k_spread.high, 2), fixed_digits(e.k_p, 4),
                        fixed_digits(e.k_corrected, 2), fixed_digits(e.k_procrustes, 3),
                        fixed_digits(e.stress1, 3)});
    }
    return rows;
}

// As printed in Table 2: two digits, "-" for what is undefined.
std::vector<TextRow> paper_table_of(const SetResult& result) {
    std::vector<TextRow> rows{{"metric", "rho", "K"}};
    for (const MetricAgreement& row : result.rows) {
        const Agreement agreement = agreement_of(row.evaluation, Bookkeeping::paper);
        rows.push_back({key_of(row), fixed_digits(agreement.rho, 2), fixed_digits(agreement.k, 2)});
    }
    return rows;
}

// Says so where PM is not better than something without physiology.
std::string verdict_on_pm(const SetResult& result) {
    std::vector<MetricRho> agreements;
    for (const MetricAgreement& row : result.rows) {
        agreements.push_back({row.metric, row.evaluation.rho});
    }
    const std::optional<Metric> best = unbeaten_by_pm(agreements);
    if (!best) return {};
    return std::string("pm does not beat ") + traits(*best).key +
           " on this set, which takes no model of the nerves\n";
}

std::string text_of(const SetResult& result, bool is_paper) {
    std::string text = head_of(result) + "\n";
    text += aligned(is_paper ? paper_table_of(result) : table_of(result));
    for (const MetricAgreement& row : result.rows) {
        for (const std::string& remark : row.evaluation.remarks) {
            text += std::string(key_of(row)) + ": " + remark + "\n";
        }
    }
    if (result.patterns <= 7) {
        text += "K and stress of so few patterns say little: any ratings fit in three dimensions\n";
    }
    return text + verdict_on_pm(result);
}

MeanAgreement mean_of(const std::vector<SetResult>& results, std::size_t row, Bookkeeping books) {
    std::vector<Agreement> agreements;
    for (const SetResult& result : results) {
        agreements.push_back(agreement_of(result.rows[row].evaluation, books));
    }
    return mean_agreement(agreements, books);
}

std::string means_text(const std::vector<SetResult>& results, Bookkeeping books) {
    const bool is_paper = books == Bookkeeping::paper;
    std::string text = "\nmeans over " + std::to_string(results.size()) + " sets";
    text += is_paper ? ", as in Table 2: of |rho|, undefined ones as 0, failed maps as K = 1\n"
                     : "; undefined ones are left out\n";
    std::vector<TextRow> rows;
    rows.push_back({"metric", is_paper ? "|rho|" : "rho", is_paper ? "signed rho" : "|rho|", "K",
                    "undefined rho", "failed maps"});
    for (std::size_t k = 0; k < results.front().rows.size(); ++k) {
        const MeanAgreement mean = mean_of(results, k, books);
        const std::string with_sign = fixed_digits(mean.signed_rho, 3);
        const std::string absolute = fixed_digits(mean.absolute_rho, 3);
        rows.push_back({key_of(results.front().rows[k]), is_paper ? absolute : with_sign,
                        is_paper ? with_sign : absolute, fixed_digits(mean.k, 3),
                        std::to_string(mean.undefined_rho), std::to_string(mean.failed_maps)});
    }
    return text + aligned(rows);
}

nlohmann::json json_of(const SetResult& result, const MetricAgreement& row, Bookkeeping books) {
    const Evaluation& e = row.evaluation;
    const Reliability& people = result.people.reliability;
    // NaN becomes null.
    nlohmann::json json{{"set", result.name},
                        {"metric", key_of(row)},
                        {"rho", e.rho},
                        {"rho_low", e.rho_interval.low},
                        {"rho_high", e.rho_interval.high},
                        {"p", e.rho_p},
                        {"tau_b", e.tau_b},
                        {"K", agreement_of(e, books).k},
                        {"K_low", e.k_spread.low},
                        {"K_high", e.k_spread.high},
                        {"K_chance", rated_of(result).k_chance.mean},
                        {"K_p", e.k_p},
                        {"K_corrected", e.k_corrected},
                        {"K_procrustes", e.k_procrustes},
                        {"stress1", e.stress1},
                        {"reliability", people.spearman_brown},
                        {"one_with_others", people.one_with_others},
                        {"ceiling_of_mean", people.ceiling_of_mean},
                        {"participants", result.people.participants},
                        {"synthetic", result.people.synthetic},
                        {"left_out", json_of(result.left_out)},
                        {"unrated_patterns", result.people.unrated},
                        {"remarks", e.remarks}};
    add_to(json, result.raters);
    add_labels(json, result.labels);
    return json;
}

nlohmann::json json_of(const MeanAgreement& mean, const std::string& key, Bookkeeping books) {
    return {{"mean_of_sets", mean.sets},
            {"metric", key},
            {"rho", books == Bookkeeping::paper ? mean.absolute_rho : mean.signed_rho},
            {"rho_signed", mean.signed_rho},
            {"rho_absolute", mean.absolute_rho},
            {"K", mean.k},
            {"undefined_rho", mean.undefined_rho},
            {"failed_maps", mean.failed_maps}};
}

std::string json_text(const std::vector<SetResult>& results, Bookkeeping books) {
    nlohmann::json all = nlohmann::json::array();
    for (const SetResult& result : results) {
        for (const MetricAgreement& row : result.rows) all.push_back(json_of(result, row, books));
    }
    for (std::size_t k = 0; results.size() > 1 && k < results.front().rows.size(); ++k) {
        all.push_back(json_of(mean_of(results, k, books), key_of(results.front().rows[k]), books));
    }
    return all.dump() + "\n";
}

}  // namespace

Expected<Done> run(const CompareCommand& command) {
    if (const auto writable = writable_result(command.out); !writable) return writable;
    const Expected<std::vector<Metric>> metrics = metrics_of(command);
    if (!metrics) return metrics.error();
    const Expected<std::vector<RatedPatterns>> all = load_rated(command.common, command.ratings);
    if (!all) return all.error();
    std::vector<SetResult> results;
    for (const RatedPatterns& patterns : *all) {
        Expected<SetResult> result = compared(command, *metrics, patterns);
        if (!result) return result.error();
        results.push_back(*std::move(result));
    }
    const Bookkeeping books = command.paper_mode ? Bookkeeping::paper : Bookkeeping::plain;
    std::string text;
    if (command.common.json) {
        text = json_text(results, books);
    } else {
        for (const SetResult& result : results) {
            text += (text.empty() ? "" : "\n") + text_of(result, command.paper_mode);
        }
        if (results.size() > 1) text += means_text(results, books);
    }
    return write_result(command.out, [&text](std::ostream& stream) { stream << text; });
}

}  // namespace tact
