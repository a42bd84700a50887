#include "app/command_line/agreement/paper_tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>

#include "app/command_line/agreement/agreement_text.h"
#include "app/report/html.h"
#include "app/report/study_metrics_html.h"
#include "model/io/tables/matrix_file.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::array kTable2{Metric::pm,  Metric::rmse,   Metric::dtw, Metric::msm,
                             Metric::mtm, Metric::st_sim, Metric::spqi};
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string paper_cell(double value) { return std::isnan(value) ? "NA" : shortest_digits(value); }

std::vector<SetAgreement> agreements_of(std::span<const ComparedSet> sets) {
    std::vector<SetAgreement> all;
    for (const ComparedSet& one : sets) all.push_back(one.agreement);
    return all;
}

// The names of the patterns that were rated, in the order of maps and matrices among them.
std::vector<std::string> rated_names(const ComparedSet& one) {
    const std::vector<std::string> all = names_of(one.set);
    const RatedSet& rated = one.agreement.people.rated;
    if (!rated.part) return all;
    std::vector<std::string> names;
    for (const std::size_t place : rated.rated) names.push_back(all[place]);
    return names;
}

void write_map(std::ostream& stream, const ComparedSet& one, const std::string& map,
               const Eigen::MatrixXd& points) {
    const std::vector<std::string> names = rated_names(one);
    if (points.rows() != static_cast<Eigen::Index>(names.size())) return;
    for (Eigen::Index k = 0; k < points.rows(); ++k) {
        stream << csv_field(one.agreement.name) << ',' << map << ','
               << csv_field(names[static_cast<std::size_t>(k)]);
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            stream << ',' << paper_cell(axis < points.cols() ? points(k, axis) : kNone);
        }
        stream << '\n';
    }
}

std::string marks_of(const SetAgreement& set) {
    return std::to_string(set.people.participants) + ',' +
           (set.people.mark.synthetic ? "1," : "0,") + std::to_string(set.people.mark.left_out);
}

}  // namespace

std::span<const Metric> table2_metrics() { return kTable2; }

void write_table2_csv(std::ostream& stream, std::span<const ComparedSet> sets) {
    stream << "set,metric,rho,K,signed_rho,best_K,participants,synthetic,left_out\n";
    bool is_synthetic = false;
    for (const ComparedSet& one : sets) {
        is_synthetic = is_synthetic || one.agreement.people.mark.synthetic;
        for (std::size_t m = 0; m < metric_count(one.agreement); ++m) {
            const Evaluation& e = one.agreement.table.evaluations[m];
            stream << csv_field(one.agreement.name) << ',' << key_of(one.agreement, m) << ','
                   << paper_cell(e.rho) << ',' << paper_cell(e.k_published) << ','
                   << paper_cell(e.rho) << ',' << paper_cell(e.k) << ',' << marks_of(one.agreement)
                   << '\n';
        }
    }
    const std::vector<SetAgreement> all = agreements_of(sets);
    for (std::size_t m = 0; m < metric_count(all.front()); ++m) {
        const MeanAgreement paper = mean_of(all, m, Bookkeeping::paper);
        const MeanAgreement plain = mean_of(all, m, Bookkeeping::plain);
        stream << "average," << key_of(all.front(), m) << ',' << paper_cell(paper.absolute_rho)
               << ',' << paper_cell(paper.k) << ',' << paper_cell(plain.signed_rho) << ','
               << paper_cell(plain.k) << ",NA," << (is_synthetic ? "1" : "0") << ",NA\n";
    }
}

void write_table2_pairs_csv(std::ostream& stream, std::span<const ComparedSet> sets) {
    stream << "set,a,b,people";
    for (std::size_t m = 0; m < metric_count(sets.front().agreement); ++m) {
        stream << ',' << key_of(sets.front().agreement, m);
    }
    stream << ",synthetic\n";
    for (const ComparedSet& one : sets) {
        const std::vector<std::string> names = rated_names(one);
        const std::vector<double>& said = rated_of(one.agreement).people.dissimilarity.condensed;
        std::vector<Dissimilarity> metrics;
        for (const Dissimilarity& matrix : one.agreement.table.matrices) {
            metrics.push_back(among_rated(matrix, one.agreement.people.rated));
        }
        for (std::size_t p = 0; p < said.size(); ++p) {
            const auto [i, j] = pair_at(names.size(), p);
            stream << csv_field(one.agreement.name) << ',' << csv_field(names[i]) << ','
                   << csv_field(names[j]) << ',' << paper_cell(said[p]);
            for (const Dissimilarity& metric : metrics) {
                stream << ',' << paper_cell(metric.condensed[p]);
            }
            stream << (one.agreement.people.mark.synthetic ? ",1\n" : ",0\n");
        }
    }
}

void write_table2_maps_csv(std::ostream& stream, std::span<const ComparedSet> sets) {
    stream << "set,map,pattern,x,y,z\n";
    for (const ComparedSet& one : sets) {
        write_map(stream, one, "people", rated_of(one.agreement).people.published_map);
        for (std::size_t m = 0; m < metric_count(one.agreement); ++m) {
            write_map(stream, one, key_of(one.agreement, m),
                      one.agreement.table.evaluations[m].published_map);
        }
    }
}

std::string table2_html(std::span<const ComparedSet> sets) {
    HtmlTable table{{{"metric"}}, {}, "table2"};
    std::vector<std::string> names;
    for (const ComparedSet& one : sets) {
        names.push_back("Set " + std::to_string(names.size() + 1) + ": " + one.agreement.name);
        const std::string number = std::to_string(names.size());
        table.columns.push_back({"rho, set " + number, true});
        table.columns.push_back({"K, set " + number, true});
    }
    for (const char* head :
         {"average |rho|", "average K", "mean rho, signed", "mean K, best maps"}) {
        table.columns.push_back({head, true});
    }
    const std::vector<SetAgreement> all = agreements_of(sets);
    for (std::size_t m = 0; m < metric_count(all.front()); ++m) {
        std::vector<std::string> row{html_escaped(key_of(all.front(), m))};
        for (const SetAgreement& set : all) {
            const Evaluation& e = set.table.evaluations[m];
            row.push_back(shown(e.rho, 2));
            row.push_back(shown(e.k_published, 2));
        }
        const MeanAgreement paper = mean_of(all, m, Bookkeeping::paper);
        const MeanAgreement plain = mean_of(all, m, Bookkeeping::plain);
        for (const double value : {paper.absolute_rho, paper.k, plain.signed_rho, plain.k}) {
            row.push_back(shown(value, 2));
        }
        table.rows.push_back(row);
    }
    return html_of(table) + items(names);
}

}  // namespace tact
