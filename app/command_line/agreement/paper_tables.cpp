#include "app/command_line/agreement/paper_tables.h"

#include "app/command_line/agreement/agreement_text.h"
#include "app/report/html.h"
#include "app/report/study_metrics_html.h"

namespace tact {

namespace {

std::vector<SetAgreement> agreements_of(std::span<const ComparedSet> sets) {
    std::vector<SetAgreement> all;
    for (const ComparedSet& one : sets) all.push_back(one.agreement);
    return all;
}

}  // namespace

std::vector<Table2Set> table2_sets(std::span<const ComparedSet> sets) {
    std::vector<Table2Set> all;
    for (const ComparedSet& one : sets) {
        std::vector<std::string> foreign;
        for (const ForeignMetric& metric : one.agreement.foreign) foreign.push_back(metric.key);
        all.push_back(table2_set(one.set, one.agreement.people, one.agreement.table, foreign));
        all.back().name = one.agreement.name;
    }
    return all;
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
