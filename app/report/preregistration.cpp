#include "app/report/report.h"

#include <cmath>
#include <system_error>

#include "app/report/parts.h"
#include "app/session/session.h"
#include "model/io/studies_out/preregistration_file.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

HtmlTable facts_of(const Preregistration& plan) {
    HtmlTable table{{{"what"}, {"as planned"}}, {}, {}};
    const auto add = [&table](const char* what, const std::string& planned) {
        table.rows.push_back({what, html_escaped(planned)});
    };
    std::string names;
    for (const std::string& name : plan.patterns) names += (names.empty() ? "" : ", ") + name;
    add("set", plan.set_name);
    add("patterns", grouped_digits(plan.patterns.size()) + ": " + names);
    add("fingerprint of what is felt", plan.set_fingerprint);
    add("fingerprint of the model", plan.model_fingerprint);
    add("people who count", grouped_digits(plan.people));
    add("pairs that each rates",
        plan.pairs == 0 ? "every pair"
                        : grouped_digits(plan.pairs) + ", dealt so that all are rated as often");
    add("repetitions of each pair", std::to_string(plan.repetitions));
    return table;
}

HtmlTable expected_of(const Preregistration& plan) {
    HtmlTable table{
        {{""}, {"over patterns", true}, {"over people", true}, {"over both", true}}, {}, {}};
    std::vector<std::string> width{"half of the 95 % interval of rho"};
    std::vector<std::string> power{"studies that tell " + html_escaped(plan.metric) + " from " +
                                   html_escaped(plan.rival)};
    for (std::size_t r = 0; r < kResampledCount; ++r) {
        width.push_back(shown(plan.expected.half_width[r], 2));
        const double share = plan.expected.power[r];
        power.push_back(html_escaped(percent(share)));
    }
    table.rows = {width, power};
    return table;
}

}  // namespace

std::string preregistration_page(const Preregistration& plan) {
    HtmlPage page;
    page.title = "Preregistration: " + plan.set_name;
    page.lead = "Written on " + html_escaped(plan.date) + ", before anybody was asked.";
    page.body =
        html_section("hypotheses", "What the study is to show", items(hypotheses_of(plan))) +
        html_section("tests", "By which tests", items(tests_of(plan))) +
        html_section("rules", "Who counts", items(exclusion_rules_of(plan))) +
        html_section("design", "Patterns and people", html_of(facts_of(plan))) +
        html_section(
            "expected", "What it can be expected to find",
            "<p class=\"warning\">Simulated: nobody was asked.</p>\n<p>Assumed of people: rho of " +
                html_escaped(plan.metric) + " " + shown(plan.assumed.rho, 2) +
                " with what they feel on average, reliability " +
                shown(plan.assumed.reliability, 2) + " of one person (" +
                html_escaped(plan.assumed.source) + "). Then rho is " +
                shown(plan.expected.rho, 2) + " on average, that of " + html_escaped(plan.rival) +
                " " + shown(plan.expected.rho_rival, 2) + ".</p>\n" + html_of(expected_of(plan)));
    page.foot = "<p>Made by " + html_escaped(plan.program) + ".</p>\n";
    page.style = report_style() + "\nul{margin:0 0 10px;padding-left:1.2em}\n";
    return html_of(page);
}

std::string planned_section(const std::string& planned_on,
                            const std::vector<PlannedAndDone>& lines) {
    if (lines.empty()) return {};
    HtmlTable table{{{"what"}, {"planned"}, {"done"}, {""}}, {}, {}};
    std::size_t departed = 0;
    for (const PlannedAndDone& line : lines) {
        if (!line.is_kept) ++departed;
        table.rows.push_back(
            {html_escaped(line.what), html_escaped(line.planned), html_escaped(line.done),
             line.is_kept ? "as planned" : "<span class=\"warning\">departs</span>"});
    }
    const std::string verdict =
        departed == 0
            ? "<p>Everything was done as it was planned on " + html_escaped(planned_on) + ".</p>\n"
            : "<p class=\"warning\">" + counted(departed, "thing departs", "things depart") +
                  " from what was planned on " + html_escaped(planned_on) + ".</p>\n";
    return html_section("planned", "Against the preregistration", verdict + html_of(table));
}

Expected<Done> write_preregistration(const std::filesystem::path& folder,
                                     const Preregistration& plan) {
    const std::filesystem::path file = folder / "preregistration.json";
    std::error_code none;
    if (std::filesystem::exists(file, none)) {
        return Error{file.string() +
                     ": expected a folder without a preregistration, which is written once"};
    }
    if (const auto made = make_folder(folder); !made) return made;
    if (const auto written = write_atomically(file, print_preregistration(plan)); !written) {
        return written;
    }
    return write_atomically(folder / "preregistration.html", preregistration_page(plan));
}

}  // namespace tact
