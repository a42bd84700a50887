#include "app/command_line/agreement/agreement.h"

#include <iostream>
#include <sstream>

#include "app/command_line/agreement/parts.h"
#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/manual/manual.h"
#include "app/report/report.h"
#include "app/session/program_version.h"
#include "app/session/session.h"
#include "assets/assets.h"
#include "model/text/atomic_file.h"
#include "model/text/utc_time.h"

namespace tact {

// tactspace paper: the tables and figures of Lim & Park 2023 for one's own sets and ratings, in a
// folder with a page, and the scripts that compute its numbers again.

namespace {

namespace fs = std::filesystem;

std::string labels_html(const ComparedSet& one) {
    std::string html;
    std::istringstream lines(text_of(one.agreement.labels));
    for (std::string line; std::getline(lines, line);) {
        html += "<p class=\"warning\">" + html_escaped(one.agreement.name + ": " + line) + "</p>\n";
    }
    return html;
}

Expected<Done> write_tables(const fs::path& folder, const std::vector<ComparedSet>& sets) {
    using Writer = void (*)(std::ostream&, std::span<const Table2Set>);
    const std::vector<Table2Set> rated = table2_sets(sets);
    for (const auto& [file, write] :
         {std::pair<const char*, Writer>{"table2.csv", write_table2_csv},
          {"pairs.csv", write_table2_pairs_csv},
          {"maps.csv", write_table2_maps_csv}}) {
        const auto written =
            write_result(folder / file, [&](std::ostream& stream) { write(stream, rated); });
        if (!written) return written;
    }
    for (const char* script : {"table2.py", "table2.R"}) {
        const auto written =
            write_atomically(folder / script, asset(std::string("paper/") + script));
        if (!written) return written;
    }
    return Done{};
}

std::string page_of(const std::vector<ComparedSet>& sets, const std::string& figures) {
    std::vector<SetAgreement> agreements;
    std::string labels;
    for (const ComparedSet& one : sets) {
        agreements.push_back(one.agreement);
        labels += labels_html(one);
    }
    HtmlPage page;
    page.title = "How well metrics agree with people";
    page.lead =
        "Tables 1 and 2 and Figures 4 to 10 of Lim &amp; Park 2023, of these sets and ratings.";
    page.body =
        labels +
        html_section(
            "table2", "Table 2",
            table2_html(sets) +
                "<p class=\"dim\">rho: Spearman's. K and its average: by the "
                "publication's procedure, of whose bookkeeping the averages are: of |rho|, "
                "an undefined one as 0, a failed map as K = 1. The last two columns keep "
                "the sign, leave out what is undefined, and take the best maps. The "
                "publication's own numbers cannot be reproduced: its ratings are not "
                "public.</p>\n") +
        figures +
        html_section("table1", "Table 1: receptors of the model",
                     table_html("receptors") ? *table_html("receptors") : std::string()) +
        html_section("methods", "How it was computed", methods_html(methods_text(agreements))) +
        html_section("files", "The numbers, and how to get them again",
                     "<p><b>table2.csv</b>, <b>pairs.csv</b> and <b>maps.csv</b>; "
                     "<b>table2.py</b> and <b>table2.R</b> compute the first from the others, "
                     "and say where they differ. <b>figures</b>: all pictures as SVG and PNG, "
                     "every map in one of its own, too.</p>\n");
    page.foot = std::string("<p>Made by ") + kProgramVersion + ", " + utc_today() + ".</p>\n";
    page.style = report_style() +
                 "\n.picture{width:100%;background:#fff}\n.table2 td,.table2 "
                 "th{overflow-wrap:normal}\nul{margin:0 0 10px;padding-left:1.2em}\n";
    return html_of(page);
}

}  // namespace

Expected<Done> run(const PaperCommand& command) {
    std::error_code none;
    if (fs::exists(command.out, none) && !fs::is_empty(command.out, none)) {
        return Error{command.out.string() + ": expected a folder that is empty or not there"};
    }
    CompareCommand compare;
    compare.common = command.common;
    compare.ratings = command.ratings;
    compare.metrics_from = command.metrics_from;
    for (const Metric metric : table2_metrics()) compare.metrics.emplace_back(traits(metric).key);
    const Expected<std::vector<ComparedSet>> sets = compared_sets(compare);
    if (!sets) return sets.error();
    if (const auto made = make_folder(command.out / "figures"); !made) return made;
    if (const auto written = write_tables(command.out, *sets); !written) return written;
    const Expected<std::string> figures =
        write_paper_figures(command, *sets, command.out / "figures");
    if (!figures) return figures.error();
    const auto written = write_atomically(command.out / "paper.html", page_of(*sets, *figures));
    if (!written) return written;
    std::cerr << "tactspace: wrote " << (command.out / "paper.html").string() << "\n";
    return Done{};
}

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
