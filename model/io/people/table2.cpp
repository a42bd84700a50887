#include "model/io/people/table2.h"

#include <array>
#include <cmath>
#include <limits>
#include <ostream>

#include "model/io/tables/matrix_file.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::array kTable2{Metric::pm,  Metric::rmse,   Metric::dtw, Metric::msm,
                             Metric::mtm, Metric::st_sim, Metric::spqi};
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

std::string paper_cell(double value) { return std::isnan(value) ? "NA" : shortest_digits(value); }

void write_paper_map(std::ostream& stream, const Table2Set& one, const std::string& map,
                     const Eigen::MatrixXd& points) {
    if (points.rows() != static_cast<Eigen::Index>(one.patterns.size())) return;
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        stream << csv_field(one.name) << ',' << map << ','
               << csv_field(one.patterns[static_cast<std::size_t>(k)]);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            stream << ',' << paper_cell(axis < points.cols() ? points(k, axis) : kNoNumber);
        }
        stream << '\n';
    }
}

std::string paper_marks(const RatedPeople& people) {
    return std::to_string(people.participants) + ',' + (people.mark.synthetic ? "1," : "0,") +
           std::to_string(people.mark.left_out);
}

MeanAgreement mean_over(std::span<const Table2Set> sets, std::size_t metric, Bookkeeping books) {
    std::vector<Agreement> all;
    for (const Table2Set& one : sets) {
        all.push_back(agreement_of(one.table.evaluations[metric], books));
    }
    return mean_agreement(all, books);
}

}  // namespace

std::span<const Metric> table2_metrics() { return kTable2; }

Table2Set table2_set(const PatternSet& set, const RatedPeople& people, const MetricTable& table,
                     const std::vector<std::string>& foreign) {
    std::vector<std::string> names = names_of(set);
    if (people.rated.part) {
        std::vector<std::string> rated;
        for (const std::size_t place : people.rated.rated) rated.push_back(names[place]);
        names = std::move(rated);
    }
    std::vector<std::string> keys;
    for (const Metric metric : table.metrics) keys.emplace_back(traits(metric).key);
    keys.insert(keys.end(), foreign.begin(), foreign.end());
    return {set.name, std::move(names), std::move(keys), people, table};
}

void write_table2_csv(std::ostream& stream, std::span<const Table2Set> sets) {
    stream << "set,metric,rho,K,signed_rho,best_K,participants,synthetic,left_out\n";
    bool is_synthetic = false;
    for (const Table2Set& one : sets) {
        is_synthetic = is_synthetic || one.people.mark.synthetic;
        for (std::size_t m = 0; m < one.keys.size(); ++m) {
            const Evaluation& e = one.table.evaluations[m];
            stream << csv_field(one.name) << ',' << one.keys[m] << ',' << paper_cell(e.rho) << ','
                   << paper_cell(e.k_published) << ',' << paper_cell(e.rho) << ','
                   << paper_cell(e.k) << ',' << paper_marks(one.people) << '\n';
        }
    }
    for (std::size_t m = 0; m < sets.front().keys.size(); ++m) {
        const MeanAgreement paper = mean_over(sets, m, Bookkeeping::paper);
        const MeanAgreement plain = mean_over(sets, m, Bookkeeping::plain);
        stream << "average," << sets.front().keys[m] << ',' << paper_cell(paper.absolute_rho) << ','
               << paper_cell(paper.k) << ',' << paper_cell(plain.signed_rho) << ','
               << paper_cell(plain.k) << ",NA," << (is_synthetic ? "1" : "0") << ",NA\n";
    }
}

void write_table2_pairs_csv(std::ostream& stream, std::span<const Table2Set> sets) {
    stream << "set,a,b,people";
    for (const std::string& key : sets.front().keys) stream << ',' << key;
    stream << ",synthetic\n";
    for (const Table2Set& one : sets) {
        const auto& said = rated_part(one.people.rated).people.dissimilarity.condensed;
        std::vector<Dissimilarity> metrics;
        for (const Dissimilarity& matrix : one.table.matrices) {
            metrics.push_back(among_rated(matrix, one.people.rated));
        }
        for (std::size_t p = 0; p < said.size(); ++p) {
            const auto [i, j] = pair_at(one.patterns.size(), p);
            stream << csv_field(one.name) << ',' << csv_field(one.patterns[i]) << ','
                   << csv_field(one.patterns[j]) << ',' << paper_cell(said[p]);
            for (const Dissimilarity& metric : metrics) {
                stream << ',' << paper_cell(metric.condensed[p]);
            }
            stream << (one.people.mark.synthetic ? ",1\n" : ",0\n");
        }
    }
}

void write_table2_maps_csv(std::ostream& stream, std::span<const Table2Set> sets) {
    stream << "set,map,pattern,x,y,z\n";
    for (const Table2Set& one : sets) {
        write_paper_map(stream, one, "people", rated_part(one.people.rated).people.published_map);
        for (std::size_t m = 0; m < one.keys.size(); ++m) {
            write_paper_map(stream, one, one.keys[m], one.table.evaluations[m].published_map);
        }
    }
}

}  // namespace tact
