#include "app/report/report.h"

#include <algorithm>
#include <cmath>

#include "app/report/parts.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

std::size_t counted_in(const StudyTables& tables) {
    return static_cast<std::size_t>(std::ranges::count_if(
        tables.results.people,
        [](const ParticipantSummary& person) { return person.excluded.empty(); }));
}

std::string tiles(const StudyReport& report) {
    const StudyTables& tables = report.tables;
    const auto& ratings = tables.people.dissimilarity.condensed;
    const auto rated =
        std::ranges::count_if(ratings, [](double one) { return std::isfinite(one); });
    return "<div class=\"tiles\">" +
           tile(grouped_digits(counted_in(tables)) + " of " +
                    grouped_digits(tables.results.people.size()),
                "participants count") +
           tile(grouped_digits(static_cast<std::size_t>(rated)),
                "pairs rated of " + grouped_digits(tables.labels.size()) + " patterns") +
           tile(shown(tables.results.agreement.spearman_brown),
                "reliability of their mean (split halves, Spearman-Brown)") +
           tile(shown(tables.results.agreement.ceiling_of_mean),
                "rho that a metric can reach with their mean") +
           "</div>\n";
}

std::string labels_html(const StudyReport& report) {
    std::string html;
    for (const std::string& label : report.labels) {
        html += "<p class=\"warning\">" + html_escaped(label) + "</p>\n";
    }
    return html;
}

std::string state_html(const ParticipantSummary& person) {
    std::string text = person.synthetic ? "synthetic" : "";
    const auto add = [&text](const std::string& more) {
        text += (text.empty() ? "" : ", ") + more;
    };
    if (!person.excluded.empty()) add(person.excluded);
    if (person.is_outlier) add("outlier, counts");
    if (text.empty()) return "counts";
    return person.excluded.empty() ? html_escaped(text)
                                   : "<span class=\"warning\">" + html_escaped(text) + "</span>";
}

std::string fields_html(const StudyRecord& record) {
    std::string text;
    for (const auto& [key, value] : record.header.participant.fields) {
        text += (text.empty() ? "" : ", ") + key + " " + value;
    }
    return html_escaped(text);
}

std::string people_section(const StudyReport& report) {
    const StudyTables& tables = report.tables;
    HtmlTable table{{{"code"},
                     {"who"},
                     {"device"},
                     {"answers", true},
                     {"min", true},
                     {"median s", true},
                     {"replays", true},
                     {"rho of repeats", true},
                     {"rho with others", true},
                     {""}},
                    {},
                    "people"};
    for (const StudyRecord& record : tables.records) {
        const auto person = std::ranges::find(tables.results.people, record.header.participant.code,
                                              &ParticipantSummary::code);
        if (person == tables.results.people.end()) continue;
        table.rows.push_back(
            {html_escaped(person->code), fields_html(record),
             html_escaped(device_of(record, answers_given(record)).name),
             grouped_digits(person->answers) + "/" + grouped_digits(person->wanted),
             shown(person->minutes, 1), shown(person->conduct.median_response_s, 1),
             shown(person->conduct.replays, 1), shown(person->conduct.repeat_rho, 2),
             shown(person->rho_with_others, 2), state_html(*person)});
    }
    std::string html = html_of(table);
    if (!report.remarks.empty())
        html += "<h3>Left out, and by which rules</h3>\n" + items(report.remarks);
    return html_section("people", "Who took part", html);
}

std::string agreement_section(const StudyReport& report) {
    const Reliability& agreement = report.tables.results.agreement;
    const InterRater& raters = report.tables.raters;
    HtmlTable table{
        {{"statistic"}, {"value", true}, {"95 % interval", true}, {"what it says"}}, {}, {}};
    const auto add = [&table](const std::string& name, double value, const std::string& interval,
                              const std::string& what) {
        table.rows.push_back({name, shown(value), interval, what});
    };
    add("one with the others", agreement.one_with_others, "",
        "mean Spearman's rho of one with the mean of the others");
    add("split halves", agreement.half_rho, "", "mean Spearman's rho between halves");
    add("reliability", agreement.spearman_brown, "", "of the mean of all, by Spearman-Brown");
    if (raters.people > 1) {
        add("ICC(2,1)", raters.single.value, shown(raters.single.interval),
            "absolute agreement of one person with another");
        add("ICC(3,k)", raters.mean.value, shown(raters.mean.interval),
            "consistency of the mean of " + grouped_digits(raters.people));
        add("Krippendorff's alpha", raters.alpha, "", "interval data; 0 is chance");
    }
    std::string html =
        html_of(table) + "<p class=\"dim\">Intervals by F (McGraw &amp; Wong 1996), of " +
        grouped_digits(raters.pairs) + " pairs that all rated, as if pairs were independent.</p>\n";
    HtmlTable shifts{
        {{"does it shift ratings"}, {"mean shift", true}, {"p", true}, {"of"}}, {}, {}};
    const auto add_shift = [&shifts](const std::string& what, const Shift& shift) {
        if (shift.comparisons == 0) return;
        shifts.rows.push_back({what, shown(shift.mean, 1), probability(shift.p),
                               grouped_digits(shift.comparisons) + " comparisons, " +
                                   counted(shift.people, "person", "people") + "; " +
                                   signs_text(shift)});
    };
    add_shift("order felt", report.tables.effects.felt_first);
    add_shift("side", report.tables.effects.side);
    add_shift("practice: last repetition less first", report.tables.effects.practice);
    if (!shifts.rows.empty()) {
        html += html_of(shifts) +
                "<p class=\"dim\">Points of similarity of 100, of the pattern that is earlier in "
                "the set: first less second, left less right. p two-sided, by signs: all of them "
                "where they are few, otherwise a random draw of them.</p>\n";
    }
    return html_section("agreement", "How alike they rate", html);
}

std::string map_html(const StudyReport& report, const Dissimilarity& matrix,
                     const PerceptualSpace& space, const std::string& of, const std::string& id) {
    if (space.points.rows() == 0) return "<p>No map of " + html_escaped(of) + ".</p>\n";
    return html_of(HtmlMap{.set = report.set,
                           .dissimilarity = matrix,
                           .space = space,
                           .marks = {.quantity = of},
                           .id = id,
                           .alt = "Map of " + of + ": near patterns feel alike",
                           .caption = html_escaped(of) + ", stress-1 " + shown(space.stress1) +
                                      ", " + fit_label(space) + "."});
}

std::string maps_section(const StudyReport& report) {
    const StudyTables& tables = report.tables;
    const std::string people =
        tables.results.mark.synthetic ? "synthetic ratings" : "people's ratings";
    std::string html = map_html(report, tables.people.dissimilarity, tables.people.space,
                                "Mean of " + people, "map-people");
    const auto pm = std::ranges::find(tables.metrics, "pm", &MetricOfStudy::key);
    if (pm != tables.metrics.end()) {
        html += map_html(report, pm->matrix, pm->space, "PM, the model's prediction", "map-pm");
    }
    return html_section("maps", "Maps", html);
}

std::string files_section() {
    HtmlTable table{{{"file"}, {"a line each"}}, {}, {}};
    for (const auto& [file, what] :
         {std::pair{"participants.csv",
                    "participant: what they were asked, device, minutes, whether "
                    "they count, and why not"},
          {"answers.csv",
           "answer, of everyone, those that do not count marked: order felt, sides, "
           "replays, times"},
          {"reliability.csv", "statistic of how alike people rate"},
          {"pairs.csv", "pair: mean rating, and every metric"},
          {"table.csv", "metric: how well it agrees"},
          {"differences.csv", "metric and kind of resample: how much better PM is"},
          {"maps.csv", "pattern and map: its place"},
          {"weights.csv", "participant: the weight of each dimension of the common map"},
          {"dimensions.csv", "pattern: its place in that map"}}) {
        table.rows.push_back({std::string("<a href=\"") + file + "\">" + file + "</a>", what});
    }
    return html_section(
        "files", "The numbers, and how to get them again",
        html_of(table) +
            "<p>Beside them, <b>reproduce.py</b> (Python with NumPy) and <b>reproduce.R</b> "
            "compute "
            "the numbers of this page from these files alone, and say where they differ. "
            "<b>mixed.R</b> fits a mixed model of single answers (lme4, or brms).</p>\n");
}

}  // namespace

std::string study_report_page(const StudyReport& report) {
    HtmlPage page;
    page.title = report.name.empty() ? "A rating study" : report.name;
    page.lead = report.tables.results.kind == StudyKind::pairwise
                    ? "How alike people said these vibrations feel, pair by pair."
                    : "How alike people said these vibrations feel, by sorting them.";
    page.body = labels_html(report) + tiles(report) +
                planned_section(report.planned_on, report.planned) + people_section(report) +
                agreement_section(report) + weights_section(report.tables.weights) +
                metrics_section(report) + maps_section(report) + methods_section(report) +
                files_section();
    page.foot = "<p>Made by " + html_escaped(report.program) +
                (report.date.empty() ? "" : ", " + html_escaped(report.date)) + ".</p>\n";
    page.style = report_style() +
                 "th{overflow-wrap:normal}\n.people td{padding-right:8px}\n.people "
                 "td:last-child{min-width:9em}" +
                 weights_style() + "\nul{margin:0 0 10px;padding-left:1.2em}\n";
    return html_of(page);
}

}  // namespace tact
