#include "app/command_line/agreement/agreement.h"

#include <ostream>
#include <string>

#include "app/command_line/output.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

std::string yes_no(bool value) { return value ? "1" : "0"; }

// Whose numbers these are; in front of every row.
const TextRow kLabelHead{"set",        "participants", "synthetic",          "left_out",
                         "rehearsals", "patterns",     "synthetic_patterns", "synthetic_model",
                         "played"};

// What the patterns went through before they were compared; empty: nothing.
std::string played_text(const Labels& labels) {
    std::string text;
    Labels played = labels;  // the rest has columns of its own
    played.mark = {.uncalibrated = labels.mark.uncalibrated, .stale = labels.mark.stale};
    for (const std::string& line : lines_of(played)) {
        text += (text.empty() ? "" : "; ") + line;
    }
    return text;
}

TextRow labels_of(const SetAgreement& set) {
    return {set.name,
            std::to_string(set.people.participants),
            yes_no(set.people.mark.synthetic),
            std::to_string(set.people.mark.left_out),
            std::to_string(set.people.mark.rehearsals),
            std::to_string(set.patterns),
            yes_no(set.labels.mark.synthetic_patterns),
            yes_no(set.labels.mark.synthetic_model),
            played_text(set.labels)};
}

void write_row(std::ostream& stream, TextRow labels, const TextRow& cells) {
    labels.insert(labels.end(), cells.begin(), cells.end());
    stream << csv_line(labels);
}

void add(TextRow& row, std::initializer_list<double> values) {
    for (const double value : values) row.push_back(csv_number(value));
}

void add(TextRow& row, const Spread& spread) {
    add(row, {spread.mean, spread.median, spread.low, spread.high});
}

TextRow metric_head(const SetAgreement& first) {
    TextRow head{"metric",     "rho",         "rho_low",      "rho_high",      "rho_p",
                 "tau_b",      "K",           "K_spread_low", "K_spread_high", "K_p",
                 "K_chance",   "K_corrected", "K_procrustes", "protest_p",     "stress1",
                 "failed_map", "failed_start"};
    for (const char* quantity : {"rho", "K"}) {
        for (const char* by : kResampledNames) {
            const std::string name = std::string(quantity) + "_" + by;
            head.insert(head.end(),
                        {name + "_se", name + "_low", name + "_high", name + "_not_known"});
        }
    }
    for (const char* quantity : {"rho", "K"}) {
        const std::string name = std::string(quantity) + "_person_";
        head.insert(head.end(), {name + "mean", name + "median", name + "q1", name + "q3"});
    }
    head.insert(head.end(), {"reliability", "ceiling_of_mean", "ceiling_person_lower",
                             "ceiling_person_lower_median", "ceiling_person_upper",
                             "ceiling_person_upper_median"});
    for (const Given& one : first.table.given) {
        const std::string name = "rho_given_" + one.name;
        head.insert(head.end(), {name, name + "_low", name + "_high", "rho_of_" + one.name});
    }
    return head;
}

TextRow metric_row(const SetAgreement& set, std::size_t m) {
    const Evaluation& e = set.table.evaluations[m];
    TextRow row{key_of(set, m)};
    add(row, {e.rho, e.rho_interval.low, e.rho_interval.high, e.rho_p, e.tau_b, e.k, e.k_spread.low,
              e.k_spread.high, e.k_p, rated_of(set).k_chance.mean, e.k_corrected, e.k_procrustes,
              e.protest_p, e.stress1});
    row.insert(row.end(), {yes_no(e.is_failed_map), yes_no(e.is_failed_start)});
    for (const Uncertain* one : {&set.table.uncertainty.rho[m], &set.table.uncertainty.k[m]}) {
        for (std::size_t r = 0; r < kResampledCount; ++r) {
            add(row, {one->error[r], one->interval[r].low, one->interval[r].high});
            row.push_back(words(one->why[r]));
        }
    }
    const Individuals& people = set.table.individuals;
    const Spread none = spread_of({});
    add(row, people.rho.empty() ? none : people.rho[m]);
    add(row, people.k.empty() ? none : people.k[m]);
    const Ceilings& bounds = set.people.ceilings;
    add(row, {bounds.reliability, bounds.of_mean, bounds.with_others.mean,
              bounds.with_others.median, bounds.with_all.mean, bounds.with_all.median});
    for (const Given& one : set.table.given) {
        const PartialRho& partial = one.metrics[m];
        add(row, {partial.rho, partial.interval.low, partial.interval.high, one.rho_alone});
    }
    return row;
}

}  // namespace

void write_metrics_csv(std::ostream& stream, std::span<const SetAgreement> sets) {
    write_row(stream, kLabelHead, metric_head(sets.front()));
    for (const SetAgreement& set : sets) {
        for (std::size_t m = 0; m < metric_count(set); ++m) {
            write_row(stream, labels_of(set), metric_row(set, m));
        }
    }
}

void write_people_csv(std::ostream& stream, std::span<const SetAgreement> sets) {
    write_row(stream, kLabelHead,
              {"participant", "metric", "rho", "K", "rho_with_others", "rho_with_all"});
    for (const SetAgreement& set : sets) {
        for (const PersonAgreement& person : set.table.individuals.people) {
            for (std::size_t m = 0; m < metric_count(set); ++m) {
                TextRow row{person.participant, key_of(set, m)};
                add(row, {person.rho[m], person.k[m], person.with_others, person.with_all});
                write_row(stream, labels_of(set), row);
            }
        }
    }
}

void write_differences_csv(std::ostream& stream, std::span<const SetAgreement> sets) {
    write_row(stream, kLabelHead,
              {"metric", "against", "resampled", "rho_difference", "se", "low", "high", "p",
               "p_holm", "not_known"});
    for (const SetAgreement& set : sets) {
        const Uncertainty& all = set.table.uncertainty;
        for (const MetricDifference& one : all.differences) {
            for (std::size_t r = 0; r < (all.people > 0 ? kResampledCount : 1); ++r) {
                TextRow row{"pm", key_of(set, one.metric), kResampledNames[r]};
                add(row, {one.rho.value, one.rho.error[r], one.rho.interval[r].low,
                          one.rho.interval[r].high, one.p[r], one.p_holm[r]});
                row.push_back(words(one.rho.why[r]));
                write_row(stream, labels_of(set), row);
            }
        }
    }
}

}  // namespace tact
