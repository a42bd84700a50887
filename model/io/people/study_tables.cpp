#include "model/io/people/study_tables.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <ostream>

#include "model/io/tables/matrix_file.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string cell(double value) { return std::isnan(value) ? "NA" : shortest_digits(value); }

std::string cell(const std::string& text) { return text.empty() ? "NA" : csv_field(text); }

const char* yes_no(bool is_so) { return is_so ? "1" : "0"; }

// What every line says of the ratings that it rests on.
std::string marks_of(const NumberMark& mark) {
    return std::string(yes_no(mark.synthetic)) + ',' + std::to_string(mark.left_out) + ',' +
           std::to_string(mark.rehearsals);
}

std::string marks_of(const StudyTables& tables) { return marks_of(tables.results.mark); }

template <class... Cells>
void write_row(std::ostream& stream, const std::string& first, const Cells&... cells) {
    stream << first;
    ((stream << ',' << cells), ...);
    stream << '\n';
}

void write_cells(std::ostream& stream, std::initializer_list<double> values) {
    for (const double value : values) stream << ',' << cell(value);
}

// What participants were asked beside their code, in the order in which it came.
std::vector<std::string> own_fields(const StudyTables& tables) {
    std::vector<std::string> keys;
    for (const StudyRecord& record : tables.records) {
        for (const auto& [key, value] : record.header.participant.fields) {
            if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
        }
    }
    return keys;
}

std::string field_of(const StudyRecord& record, const std::string& key) {
    for (const auto& [name, value] : record.header.participant.fields) {
        if (name == key) return value;
    }
    return {};
}

std::string joined(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text += (text.empty() ? "" : " ") + shortest_digits(value);
    return text;
}

void write_participant(std::ostream& stream, const StudyRecord& record,
                       const ParticipantSummary& person, const std::vector<std::string>& keys) {
    const StudyDevice& device = device_of(record, answers_given(record));
    stream << csv_field(person.code) << ',' << yes_no(person.excluded.empty()) << ','
           << cell(person.excluded) << ',' << yes_no(person.synthetic) << ','
           << yes_no(person.rehearsal) << ',' << person.answers << ',' << person.wanted << ','
           << person.unfelt << ',' << cell(joined(person.attention)) << ',' << cell(person.minutes)
           << ',' << cell(person.conduct.median_response_s) << ',' << cell(person.conduct.replays)
           << ',' << cell(person.conduct.repeat_rho) << ',' << cell(person.rho_with_others) << ','
           << yes_no(person.is_outlier) << ',' << cell(record.header.begun) << ','
           << cell(device.name) << ',' << cell(device.calibration) << ',' << cell(device.masking)
           << ',' << record.devices.size() << ',' << cell(record.header.set_fingerprint);
    for (const std::string& key : keys) stream << ',' << cell(field_of(record, key));
    stream << '\n';
}

struct ReliabilityRow {
    const char* statistic;
    double value;
    Interval interval{kNone, kNone};
    double p = kNone;
    std::size_t people = 0;
    std::size_t n = 0;
    std::string how = "exact";
};

std::vector<ReliabilityRow> reliability_rows(const StudyTables& tables) {
    const Reliability& agreement = tables.results.agreement;
    const InterRater& raters = tables.raters;
    const std::size_t people = agreement.voices;
    const std::size_t pairs = tables.people.dissimilarity.condensed.size();
    const char* const halves = people <= 12 ? "all halves" : "1000 drawn halves";
    std::vector<ReliabilityRow> rows;
    const auto add = [&rows](ReliabilityRow row) { rows.push_back(std::move(row)); };
    add({"split_half", agreement.half_rho, {kNone, kNone}, kNone, people, pairs, halves});
    add({"reliability", agreement.spearman_brown, {kNone, kNone}, kNone, people, pairs, halves});
    add({"ceiling_of_mean",
         agreement.ceiling_of_mean,
         {kNone, kNone},
         kNone,
         people,
         pairs,
         halves});
    add({"one_with_others", agreement.one_with_others, {kNone, kNone}, kNone, people, pairs});
    if (raters.people > 1) {
        add({"icc_single", raters.single.value, raters.single.interval, kNone, raters.people,
             raters.pairs, "F as if pairs were independent"});
        add({"icc_mean", raters.mean.value, raters.mean.interval, kNone, raters.people,
             raters.pairs, "F as if pairs were independent"});
        add({"alpha", raters.alpha, {kNone, kNone}, kNone, raters.people, raters.alpha_pairs});
    }
    const auto add_shift = [&add](const char* name, const Shift& shift) {
        if (shift.comparisons == 0) return;
        add({name,
             shift.mean,
             {kNone, kNone},
             shift.p,
             shift.people,
             shift.comparisons,
             std::isnan(shift.p) ? signs_text(shift) : signs_text(shift) + ", two-sided"});
    };
    add_shift("felt_first", tables.effects.felt_first);
    add_shift("side", tables.effects.side);
    add_shift("practice", tables.effects.practice);
    return rows;
}

void write_map(std::ostream& stream, const std::string& name, const StudyTables& tables,
               const PerceptualSpace& space) {
    const auto patterns = static_cast<Eigen::Index>(tables.labels.size());
    if (space.points.rows() != patterns) return;
    for (Eigen::Index k = 0; k < patterns; ++k) {
        stream << csv_field(name) << ',' << csv_field(tables.labels[static_cast<std::size_t>(k)]);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            stream << ',' << cell(axis < space.points.cols() ? space.points(k, axis) : kNone);
        }
        stream << ',' << marks_of(tables) << '\n';
    }
}

std::string dimension_heads(const IndividualWeights& weights) {
    std::string heads;
    for (Eigen::Index r = 0; r < weights.group.cols(); ++r) {
        heads += ",dimension_" + std::to_string(r + 1);
    }
    return heads;
}

}  // namespace

void write_participants_csv(std::ostream& stream, const StudyTables& tables) {
    const std::vector<std::string> keys = own_fields(tables);
    stream << "participant,counted,why,synthetic,rehearsal,answers,wanted,not_felt,identical,"
              "minutes,median_response_s,replays,repeat_rho,rho_with_others,outlier,begun,device,"
              "calibration,masking,device_changes,fingerprint";
    for (const std::string& key : keys) stream << ',' << csv_field("own_" + key);
    stream << '\n';
    for (const StudyRecord& record : tables.records) {
        const auto person = std::ranges::find(tables.results.people, record.header.participant.code,
                                              &ParticipantSummary::code);
        if (person != tables.results.people.end()) {
            write_participant(stream, record, *person, keys);
        }
    }
}

void write_reliability_csv(std::ostream& stream, const StudyTables& tables) {
    stream << "statistic,value,low,high,p,people,n,how,synthetic,left_out,rehearsals\n";
    for (const ReliabilityRow& row : reliability_rows(tables)) {
        write_row(stream, row.statistic, cell(row.value), cell(row.interval.low),
                  cell(row.interval.high), cell(row.p), row.people, row.n, csv_field(row.how),
                  marks_of(tables));
    }
}

void write_pairs_csv(std::ostream& stream, const StudyTables& tables) {
    stream << "a,b,people";
    for (const MetricOfStudy& metric : tables.metrics) stream << ',' << csv_field(metric.key);
    stream << ",synthetic,left_out,rehearsals\n";
    const std::vector<double>& people = tables.people.dissimilarity.condensed;
    for (std::size_t p = 0; p < people.size(); ++p) {
        const auto [i, j] = pair_at(tables.labels.size(), p);
        stream << csv_field(tables.labels[i]) << ',' << csv_field(tables.labels[j]) << ','
               << cell(people[p]);
        for (const MetricOfStudy& metric : tables.metrics) {
            stream << ',' << cell(metric.matrix.condensed[p]);
        }
        stream << ',' << marks_of(tables) << '\n';
    }
}

void write_metrics_csv(std::ostream& stream, const StudyTables& tables) {
    stream << "metric,rho,rho_low,rho_high,p,tau_b,K,K_low,K_high,K_p,K_corrected,K_procrustes,"
              "K_chance,stress1,K_published";
    for (const char* quantity : {"rho", "K"}) {
        for (const char* by : kResampledNames) {
            for (const char* part : {"_se", "_low", "_high"}) {
                stream << ',' << quantity << '_' << by << part;
            }
        }
    }
    for (const char* quantity : {"rho", "K"}) {
        for (const char* part : {"median", "q1", "q3"}) {
            stream << ',' << quantity << "_person_" << part;
        }
    }
    for (const Given& one : tables.given) {
        for (const char* part : {"", "_low", "_high"}) {
            stream << ",rho_given_" << one.name << part;
        }
    }
    stream << ",participants,synthetic,left_out,rehearsals\n";
    for (std::size_t m = 0; m < tables.metrics.size(); ++m) {
        const MetricOfStudy& metric = tables.metrics[m];
        const Evaluation& e = metric.evaluation;
        stream << csv_field(metric.key);
        write_cells(stream, {e.rho, e.rho_interval.low, e.rho_interval.high, e.rho_p, e.tau_b, e.k,
                             e.k_spread.low, e.k_spread.high, e.k_p, e.k_corrected, e.k_procrustes,
                             tables.k_chance.mean, e.stress1, e.k_published});
        for (const Uncertain* one : {&tables.uncertainty.rho[m], &tables.uncertainty.k[m]}) {
            for (std::size_t r = 0; r < kResampledCount; ++r) {
                write_cells(stream, {one->error[r], one->interval[r].low, one->interval[r].high});
            }
        }
        const bool has_people = !tables.individuals.rho.empty();
        const Spread none = spread_of({});
        for (const Spread& one : {has_people ? tables.individuals.rho[m] : none,
                                  has_people ? tables.individuals.k[m] : none}) {
            write_cells(stream, {one.median, one.low, one.high});
        }
        for (const Given& one : tables.given) {
            const PartialRho& partial = one.metrics[m];
            write_cells(stream, {partial.rho, partial.interval.low, partial.interval.high});
        }
        stream << ',' << participant_means(tables.results.study).size() << ',' << marks_of(tables)
               << '\n';
    }
}

void write_differences_csv(std::ostream& stream, const StudyTables& tables) {
    stream << "metric,against,resampled,rho_difference,se,low,high,p,p_holm,not_known,synthetic,"
              "left_out,rehearsals\n";
    const Uncertainty& all = tables.uncertainty;
    for (const MetricDifference& one : all.differences) {
        for (std::size_t r = 0; r < (all.people > 0 ? kResampledCount : 1); ++r) {
            write_row(stream, "pm", csv_field(tables.metrics[one.metric].key), kResampledNames[r],
                      cell(one.rho.value), cell(one.rho.error[r]), cell(one.rho.interval[r].low),
                      cell(one.rho.interval[r].high), cell(one.p[r]), cell(one.p_holm[r]),
                      cell(std::string(words(one.rho.why[r]))), marks_of(tables));
        }
    }
}

void write_maps_csv(std::ostream& stream, const StudyTables& tables) {
    stream << "map,pattern,x,y,z,synthetic,left_out,rehearsals\n";
    write_map(stream, "people", tables, tables.people.space);
    for (const MetricOfStudy& metric : tables.metrics) {
        if (!metric.evaluation.is_failed_map) write_map(stream, metric.key, tables, metric.space);
    }
}

void write_weights_csv(std::ostream& stream, const StudyTables& tables) {
    const auto& standings = tables.results.people;
    stream << "participant" << dimension_heads(tables.weights)
           << ",explained,synthetic,left_out,rehearsals\n";
    for (const PersonWeights& person : tables.weights.people) {
        stream << csv_field(person.participant);
        for (const double weight : person.weights) stream << ',' << cell(weight);
        const auto known =
            std::ranges::find(standings, person.participant, &ParticipantSummary::code);
        NumberMark mark = tables.results.mark;
        if (known != standings.end()) mark.synthetic = known->synthetic;
        stream << ',' << cell(person.explained) << ',' << marks_of(mark) << '\n';
    }
}

void write_dimensions_csv(std::ostream& stream, const StudyTables& tables) {
    const IndividualWeights& weights = tables.weights;
    stream << "pattern" << dimension_heads(weights) << ",synthetic,left_out,rehearsals\n";
    for (Eigen::Index k = 0; k < weights.group.rows(); ++k) {
        stream << csv_field(weights.labels[static_cast<std::size_t>(k)]);
        for (Eigen::Index r = 0; r < weights.group.cols(); ++r) {
            stream << ',' << cell(weights.group(k, r));
        }
        stream << ',' << marks_of(tables) << '\n';
    }
}

}  // namespace tact
