// tactspace findings: what the publication found, checked on what this program predicts; and what
// people said who heard Morse signals.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/command_line/agreement/agreement.h"
#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/compare/compare.h"
#include "model/evaluation/metric_comparison.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

std::size_t count_of(const std::vector<Finding>& all, FindingStatus status) {
    return static_cast<std::size_t>(std::ranges::count(all, status, &Finding::status));
}

std::string text_of(const std::vector<Finding>& all) {
    std::string text;
    for (const Finding& finding : all) {
        text += finding.id + " " + word_of(finding.status) + " (" + finding.set + ", " +
                finding.source + ")\n    " + finding.claim + "\n    " + finding.evidence + "\n";
    }
    return text + "\n" + std::to_string(count_of(all, FindingStatus::holds)) + " hold, " +
           std::to_string(count_of(all, FindingStatus::fails)) + " fail; " +
           std::to_string(count_of(all, FindingStatus::needs_ratings)) + " need ratings and " +
           std::to_string(count_of(all, FindingStatus::needs_stimuli)) +
           " need exact stimuli that are not public\neach is a comparison of predictions: nothing "
           "is drawn, and there is no test\n";
}

nlohmann::json json_of(const std::vector<Finding>& all) {
    nlohmann::json list = nlohmann::json::array();
    for (const Finding& finding : all) {
        list.push_back({{"id", finding.id},
                        {"set", finding.set},
                        {"claim", finding.claim},
                        {"source", finding.source},
                        {"status", word_of(finding.status)},
                        {"evidence", finding.evidence}});
    }
    return list;
}

// What the ratings are, wherever a number of theirs stands.
constexpr const char* kByEar =
    "rated by 598 people who heard them, nobody felt them (Rothkopf 1957, J. Exp. Psychol. 53, "
    "94-101); carrier (150 Hz, 1 g) and unit (50 ms) are ours";

const MorseRow& row_of(const MorseCheck& check, Metric metric) {
    return *std::ranges::find(check.rows, metric, &MorseRow::metric);
}

// Whether a model of nerves pays here, and why not.
std::string verdict_of(const MorseCheck& check) {
    std::vector<MetricRho> agreements;
    for (const MorseRow& row : check.rows) agreements.push_back({row.metric, row.agreement.rho});
    const MorseRow& oc = row_of(check, Metric::oc);
    std::string text;
    if (const auto better = unbeaten_by_pm(agreements)) {
        text = std::string("PM loses here: ") + traits(*better).key +
               ", which takes no model of the nerves, has rho " +
               fixed_digits(row_of(check, *better).agreement.rho, 3) + ", PM " +
               fixed_digits(row_of(check, Metric::pm).agreement.rho, 3) + ".\n";
    }
    return text + "oc has " + std::to_string(oc.distinct) + " different values in " +
           std::to_string(check.pairs) +
           " pairs: warping stretches a dot to a dash at no cost, so that it hardly sees how long "
           "a note is, and patterns that differ in the length of their notes are predicted too "
           "close.\n";
}

std::string text_of(const MorseCheck& check) {
    const std::size_t equal = check.rows.front().beyond_length.equal_pairs;
    std::string text = "Morse: " + std::to_string(check.patterns) + " signals, " +
                       std::to_string(check.pairs) + " pairs, " + kByEar + "\n\n";
    std::vector<TextRow> rows{{"metric", "rho", "95 % interval", "K",
                               "rho of " + std::to_string(equal) + " pairs of equal length",
                               "rho given length", "values"}};
    for (const MorseRow& row : check.rows) {
        const Evaluation& e = row.agreement;
        rows.push_back({traits(row.metric).key, fixed_digits(e.rho, 3),
                        range_text(e.rho_interval.low, e.rho_interval.high, 2),
                        fixed_digits(e.k, 3), fixed_digits(row.beyond_length.rho_of_equal, 3),
                        fixed_digits(row.beyond_length.partial_rho, 3),
                        std::to_string(row.distinct)});
    }
    return text + aligned(rows) + "\nThe difference of lengths alone has rho " +
           fixed_digits(check.rows.front().beyond_length.rho_of_length, 3) + ".\n" +
           verdict_of(check) +
           "rho: Spearman's, interval by bootstrap over patterns (2,000 draws, seed 2); given "
           "length: partial rank correlation; K: alienation of the distances of two maps of three "
           "dimensions (Borg & Leutner 1985); nobody rated twice, so no ceiling is known.\n";
}

void write_csv(std::ostream& stream, const std::vector<Finding>& all) {
    stream << csv_line({"id", "set", "claim", "source", "status", "evidence"});
    for (const Finding& one : all) {
        stream << csv_line(
            {one.id, one.set, one.claim, one.source, word_of(one.status), one.evidence});
    }
}

void write_csv(std::ostream& stream, const MorseCheck& check) {
    stream << csv_line({"metric", "rho", "rho_low", "rho_high", "rho_p", "K", "K_p",
                        "rho_of_equal_length", "rho_given_length", "distinct_values", "ratings"});
    for (const MorseRow& row : check.rows) {
        const Evaluation& e = row.agreement;
        stream << csv_line(
            {traits(row.metric).key, csv_number(e.rho), csv_number(e.rho_interval.low),
             csv_number(e.rho_interval.high), csv_number(e.rho_p), csv_number(e.k),
             csv_number(e.k_p), csv_number(row.beyond_length.rho_of_equal),
             csv_number(row.beyond_length.partial_rho), std::to_string(row.distinct), kByEar});
    }
}

// What is not defined, NaN, is written as null.
nlohmann::json json_of(const MorseCheck& check) {
    nlohmann::json metrics = nlohmann::json::object();
    for (const MorseRow& row : check.rows) {
        const Evaluation& e = row.agreement;
        metrics[traits(row.metric).key] = {
            {"rho", e.rho},
            {"rho_interval", {e.rho_interval.low, e.rho_interval.high}},
            {"k", e.k},
            {"rho_of_equal_length", row.beyond_length.rho_of_equal},
            {"rho_given_length", row.beyond_length.partial_rho},
            {"distinct_values", row.distinct}};
    }
    return {{"ratings", kByEar},
            {"patterns", check.patterns},
            {"pairs", check.pairs},
            {"pairs_of_equal_length", check.rows.front().beyond_length.equal_pairs},
            {"rho_of_length_alone", check.rows.front().beyond_length.rho_of_length},
            {"metrics", metrics}};
}

std::string text_of(const std::vector<VariantOutcome>& all) {
    std::string text =
        std::string("Morse: ") + kByEar +
        "\nFindings: of Lim & Park 2023, as far as their stimuli are public; twelve: "
        "their patterns, against the model as published\n\n";
    std::vector<TextRow> rows{{"model", "Morse: pm", "95 % interval", "oc", "values of oc",
                               "findings hold", "fail", "twelve: rho", "K"}};
    for (const VariantOutcome& one : all) {
        rows.push_back({one.name, fixed_digits(one.morse_pm, 3),
                        range_text(one.morse_interval.low, one.morse_interval.high, 2),
                        fixed_digits(one.morse_oc, 3), std::to_string(one.oc_values),
                        std::to_string(one.hold), std::to_string(one.failing.size()),
                        fixed_digits(one.twelve_rho, 3), fixed_digits(one.twelve_k, 3)});
    }
    text += aligned(rows) + "\n";
    for (const VariantOutcome& one : all) {
        if (one.failing.empty()) continue;
        text += one.name + " fails";
        for (const std::string& id : one.failing) text += " " + id;
        text += "\n";
    }
    const VariantOutcome& by_ear = chosen_by_morse(all);
    const VariantOutcome& by_findings = chosen_by_findings(all);
    return text + "Chosen by Morse alone: " + by_ear.name + "; of the findings " +
           std::to_string(by_ear.hold) + " hold then, as published " +
           std::to_string(all.front().hold) +
           ".\nChosen by the findings alone: " + by_findings.name + "; Morse then has rho " +
           fixed_digits(by_findings.morse_pm, 3) + ", as published " +
           fixed_digits(all.front().morse_pm, 3) +
           ".\nThe model stays as published until people have felt such patterns: these were "
           "heard. "
           "Among equals the one nearest to the published values comes first.\n"
           "rho: Spearman's, interval by bootstrap over patterns (2,000 draws, seed 2); K: "
           "alienation of maps of three dimensions.\n";
}

nlohmann::json json_of(const std::vector<VariantOutcome>& all) {
    nlohmann::json list = nlohmann::json::array();
    for (const VariantOutcome& one : all) {
        list.push_back(
            {{"model", one.name},
             {"waiting_cost", one.model.envelope.waiting_cost},
             {"morse_rho_pm", one.morse_pm},
             {"morse_rho_pm_interval", {one.morse_interval.low, one.morse_interval.high}},
             {"morse_rho_oc", one.morse_oc},
             {"morse_values_of_oc", one.oc_values},
             {"findings_hold", one.hold},
             {"findings_fail", one.failing},
             {"twelve_rho", one.twelve_rho},
             {"twelve_k", one.twelve_k}});
    }
    return {{"ratings", kByEar},
            {"chosen_by_morse", chosen_by_morse(all).name},
            {"chosen_by_findings", chosen_by_findings(all).name},
            {"models", list}};
}

void write_csv(std::ostream& stream, const std::vector<VariantOutcome>& all) {
    stream << csv_line({"model", "morse_rho_pm", "morse_rho_pm_low", "morse_rho_pm_high",
                        "morse_rho_oc", "morse_values_of_oc", "findings_hold", "findings_fail",
                        "twelve_rho", "twelve_K", "ratings"});
    for (const VariantOutcome& one : all) {
        stream << csv_line({one.name, csv_number(one.morse_pm), csv_number(one.morse_interval.low),
                            csv_number(one.morse_interval.high), csv_number(one.morse_oc),
                            std::to_string(one.oc_values), std::to_string(one.hold),
                            std::to_string(one.failing.size()), csv_number(one.twelve_rho),
                            csv_number(one.twelve_k), kByEar});
    }
}

// The table for other programs, where asked for, then the answer.
template <class Found>
Expected<Done> write_all(const FindingsCommand& command, const Found& found) {
    if (!command.csv.empty()) {
        const auto written =
            write_result(command.csv, [&found](std::ostream& stream) { write_csv(stream, found); });
        if (!written) return written;
    }
    return write_result({}, [&](std::ostream& stream) {
        stream << (command.json ? text_of_json(json_of(found)) + "\n" : text_of(found));
    });
}

Expected<Done> run_morse(const FindingsCommand& command) {
    MorseOptions options;
    options.threads = command.threads;
    options.progress = progress_line("comparing metrics on Morse");
    return write_all(command, *check_morse(options));
}

Expected<Done> run_variants(const FindingsCommand& command) {
    VariantOptions options;
    options.threads = command.threads;
    options.progress = progress_line("comparing models");
    return write_all(command, *check_variants(options));
}

}  // namespace

Expected<Done> run(const FindingsCommand& command) {
    if (const auto writable = writable_result(command.csv); !writable) return writable;
    if (command.morse) return run_morse(command);
    if (command.variants) return run_variants(command);
    CheckOptions options;
    options.threads = command.threads;
    options.progress_of = [](const std::string& set) {
        return progress_line("comparing pairs of " + set);
    };
    return write_all(command, *check_findings(options));
}

}  // namespace tact
