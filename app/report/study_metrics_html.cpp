#include "app/report/report.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <sstream>
#include <utility>

#include "app/report/parts.h"
#include "model/evaluation/said_once.h"
#include "model/text/numbers.h"
#include "viz/charts/profile_view.h"

namespace tact {

namespace {

constexpr const char* kUnknown = "\u2013";

// How many kinds of resamples there are.
std::size_t kinds_of(const Uncertainty& all) { return all.people > 0 ? kResampledCount : 1; }

// "over patterns", for a heading.
std::string over(std::size_t resampled) {
    return std::string("over ") + kResampledNames[resampled];
}

std::string agreement_table(const StudyReport& report) {
    HtmlTable table{{{"metric"},
                     {"rho", true},
                     {"95 % interval", true},
                     {"p", true},
                     {"tau-b", true},
                     {"K", true},
                     {"K p", true},
                     {"stress-1", true}},
                    {},
                    {}};
    for (const MetricOfStudy& metric : report.tables.metrics) {
        const Evaluation& e = metric.evaluation;
        table.rows.push_back({html_escaped(metric.key), shown(e.rho), shown(e.rho_interval),
                              probability(e.rho_p), shown(e.tau_b), shown(e.k), probability(e.k_p),
                              shown(e.stress1)});
    }
    const AlienationChance& chance = report.tables.k_chance;
    std::vector<std::string> keys;
    std::vector<Evaluation> evaluations;
    for (const MetricOfStudy& metric : report.tables.metrics) {
        keys.push_back(metric.key);
        evaluations.push_back(metric.evaluation);
    }
    const std::vector<std::string> remarks = remarks_by_metric(keys, evaluations);
    return html_of(table) +
           "<p class=\"dim\">rho: Spearman, with the mean of those who count; interval: if other "
           "patterns had been taken; p: Mantel, one-sided. K: alienation of maps of three "
           "dimensions, 0 is the same shape; unrelated maps have " +
           shown(chance.mean) +
           " on average; p: permuted patterns, one-sided. Not corrected for how many metrics "
           "there are.</p>\n" +
           (remarks.empty() ? std::string() : items(remarks));
}

// Why numbers are missing.
std::string reasons_html(const SaidOnce& missing) {
    std::vector<std::string> sentences;
    for (const auto& [why, metrics] : missing.said) sentences.push_back(why + " (" + metrics + ")");
    return sentences.empty() ? std::string() : items(sentences);
}

void add_reasons(SaidOnce& missing, const std::string& quantity, const std::string& metric,
                 const Uncertain& value, std::size_t kinds) {
    for (std::size_t r = 0; r < kinds; ++r) {
        if (value.why[r] == NotKnown::known || value.why[r] == NotKnown::no_value) continue;
        missing.add(quantity + " " + over(r) + " not known: " + words(value.why[r]), metric);
    }
}

std::string intervals_table(const StudyReport& report) {
    const Uncertainty& all = report.tables.uncertainty;
    const std::size_t kinds = kinds_of(all);
    HtmlTable table{{{"95 % intervals"}}, {}, {}};
    for (const char* quantity : {"rho ", "K "}) {
        for (std::size_t r = 0; r < kinds; ++r) {
            table.columns.push_back({quantity + over(r), true});
        }
    }
    SaidOnce missing;
    for (std::size_t m = 0; m < report.tables.metrics.size(); ++m) {
        const std::string& key = report.tables.metrics[m].key;
        std::vector<std::string> row{html_escaped(key)};
        for (const Uncertain* one : {&all.rho[m], &all.k[m]}) {
            for (std::size_t r = 0; r < kinds; ++r) row.push_back(shown(one->interval[r]));
        }
        table.rows.push_back(row);
        add_reasons(missing, "rho", key, all.rho[m], kinds);
        add_reasons(missing, "K", key, all.k[m], kinds);
    }
    return "<h3>If other patterns or other people had been taken</h3>\n" + html_of(table) +
           reasons_html(missing);
}

std::string differences_table(const StudyReport& report) {
    const Uncertainty& all = report.tables.uncertainty;
    if (all.differences.empty()) return {};
    const std::size_t kinds = kinds_of(all);
    HtmlTable table{{{"rho of pm less"}, {"difference", true}}, {}, {}};
    for (std::size_t r = 0; r < kinds; ++r) {
        table.columns.push_back({over(r), true});
        table.columns.push_back({"p", true});
        table.columns.push_back({"Holm", true});
    }
    SaidOnce missing;
    for (const MetricDifference& one : all.differences) {
        const std::string& key = report.tables.metrics[one.metric].key;
        std::vector<std::string> row{html_escaped(key), shown(one.rho.value)};
        for (std::size_t r = 0; r < kinds; ++r) {
            row.push_back(shown(one.rho.interval[r]));
            row.push_back(probability(one.p[r]));
            row.push_back(probability(one.p_holm[r]));
        }
        table.rows.push_back(row);
        add_reasons(missing, "difference", key, one.rho, kinds);
    }
    return "<h3>Is PM better than the others</h3>\n" + html_of(table) + reasons_html(missing) +
           "<p class=\"dim\">Paired, over the same draws; p two-sided; Holm: corrected for " +
           counted(all.differences.size(), "difference", "differences") + ".</p>\n";
}

std::string given_table(const StudyReport& report) {
    if (report.tables.given.empty()) return {};
    HtmlTable table{{{"partial rho"}}, {}, {}};
    std::vector<std::string> alone{"(that alone)"};
    for (const Given& one : report.tables.given) {
        table.columns.push_back({"given " + one.name, true});
        table.columns.push_back({"95 % interval", true});
        alone.insert(alone.end(), {shown(one.rho_alone), ""});
    }
    for (std::size_t m = 0; m < report.tables.metrics.size(); ++m) {
        std::vector<std::string> row{html_escaped(report.tables.metrics[m].key)};
        for (const Given& one : report.tables.given) {
            row.push_back(shown(one.metrics[m].rho));
            row.push_back(shown(one.metrics[m].interval));
        }
        table.rows.push_back(row);
    }
    table.rows.push_back(alone);
    return "<h3>What is left beside something simple</h3>\n" + html_of(table) +
           "<p class=\"dim\">Partial rank correlation, given by how many dB one pattern is "
           "stronger "
           "than the other, or by how many seconds it is longer.</p>\n";
}

std::string persons_table(const StudyReport& report) {
    const Individuals& all = report.tables.individuals;
    if (all.people.empty()) return {};
    HtmlTable table{{{"with one person"},
                     {"median rho", true},
                     {"quartiles", true},
                     {"median K", true},
                     {"quartiles", true}},
                    {},
                    {}};
    for (std::size_t m = 0; m < report.tables.metrics.size(); ++m) {
        const Spread& rho = all.rho[m];
        const Spread& k = all.k[m];
        table.rows.push_back({html_escaped(report.tables.metrics[m].key), shown(rho.median),
                              shown(Interval{rho.low, rho.high}), shown(k.median),
                              shown(Interval{k.low, k.high})});
    }
    return "<h3>With each person alone</h3>\n" + html_of(table);
}

}  // namespace

std::string shown(double value, int decimals) {
    return std::isnan(value) ? kUnknown : with_decimals(value, decimals);
}

std::string shown(const Interval& interval) {
    if (std::isnan(interval.low)) return kUnknown;
    return shown(interval.low) + " to " + shown(interval.high);
}

std::string probability(double p) { return p < 0.0001 ? "&lt; 0.0001" : shown(p, 4); }

std::string items(const std::vector<std::string>& sentences) {
    std::string html = "<ul>\n";
    for (const std::string& one : sentences) html += "<li>" + html_escaped(one) + "</li>\n";
    return html + "</ul>\n";
}

std::string metrics_section(const StudyReport& report) {
    const Mapped& people = report.tables.people;
    const std::string no_k = people.maps.empty()
                                 ? "<p class=\"warning\">No metric has a K: the map of the "
                                   "ratings is " +
                                       html_escaped(remark_on(people.space)) + ".</p>\n"
                                 : std::string();
    return html_section("metrics", "Which metric agrees with them",
                        no_k + agreement_table(report) + intervals_table(report) +
                            differences_table(report) + given_table(report) +
                            persons_table(report));
}

std::string methods_html(const std::string& text) {
    std::string html;
    bool is_list = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line == "Methods") continue;
        if (line == "References") {
            html += "<h3>References</h3>\n<ul>\n";
            is_list = true;
        } else {
            html +=
                (is_list ? "<li>" : "<p>") + html_escaped(line) + (is_list ? "</li>\n" : "</p>\n");
        }
    }
    return html + (is_list ? "</ul>\n" : "");
}

std::string methods_section(const StudyReport& report) {
    if (report.methods.empty()) return {};
    return html_section("methods", "How it was computed, for a paper",
                        methods_html(report.methods));
}

namespace {

constexpr double kRadius = 38.0;  // of a weight of 1
constexpr double kHalf = 44.0;    // of the picture

std::string at(ImVec2 place) {
    return fixed_digits(kHalf + kRadius * place.x, 1) + "," +
           fixed_digits(kHalf + kRadius * place.y, 1);
}

std::string outline(std::span<const double> weights, const char* kind) {
    std::string points;
    for (const ImVec2 place : star_outline(weights))
        points += (points.empty() ? "" : " ") + at(place);
    return std::string("<polygon class=\"") + kind + "\" points=\"" + points + "\"/>";
}

std::string star(const PersonWeights& person, std::span<const double> mean) {
    std::string rays;
    std::string said = person.participant + ":";
    for (std::size_t r = 0; r < person.weights.size(); ++r) {
        const std::string middle = fixed_digits(kHalf, 1);
        rays += "<path class=\"ray\" d=\"M" + middle + "," + middle + "L" +
                at(star_ray(r, person.weights.size())) + "\"/>";
        said += " " + fixed_digits(person.weights[r], 2);
    }
    const std::string side = fixed_digits(2.0 * kHalf, 0);
    return "<figure class=\"star\"><svg role=\"img\" aria-label=\"" + html_escaped(said) +
           "\" viewBox=\"0 0 " + side + " " + side + "\">" + rays + outline(person.weights, "own") +
           outline(mean, "mean") + "</svg><figcaption>" + html_escaped(person.participant) +
           "</figcaption></figure>\n";
}

HtmlTable table_of(const IndividualWeights& weights) {
    HtmlTable table{{{"participant"}}, {}, {}};
    for (Eigen::Index r = 0; r < weights.group.cols(); ++r) {
        table.columns.push_back({"dimension " + std::to_string(r + 1), true});
    }
    table.columns.push_back({"explained", true});
    for (const PersonWeights& person : weights.people) {
        std::vector<std::string> row{html_escaped(person.participant)};
        for (const double weight : person.weights) row.push_back(fixed_digits(weight, 3));
        row.push_back(fixed_digits(person.explained, 3));
        table.rows.push_back(row);
    }
    return table;
}

}  // namespace

std::string weights_section(const IndividualWeights& weights) {
    if (weights.people.empty()) return {};
    std::string html = "<div class=\"stars\">\n";
    for (const PersonWeights& person : weights.people) html += star(person, weights.mean);
    html +=
        "</div>\n<p>A ray a dimension of one common map, the first upwards, the others "
        "clockwise; as long as the weight, the whole ray is 1. Dashed: the mean of "
        "all.</p>\n<ul>\n";
    for (std::size_t r = 0; r < weights.mean.size(); ++r) {
        const DimensionEnds ends = ends_of(weights, r);
        html += "<li>Dimension " + std::to_string(r + 1) + " leads from <b>" +
                html_escaped(ends.low) + "</b> to <b>" + html_escaped(ends.high) + "</b>.</li>\n";
    }
    html += "</ul>\n" + html_of(table_of(weights));
    if (!weights.left_out.empty()) {
        html +=
            "<p class=\"dim\">Without weights, as they did not rate every pair, or all alike: " +
            grouped_digits(weights.left_out.size()) + ".</p>\n";
    }
    return html_section(
        "weights", "What each goes by",
        html +
            "<p class=\"dim\">INDSCAL (Carroll &amp; Chang 1970): least squares on scalar "
            "products, "
            "each person's brought to one size, weights not below 0. Explained: the share of that. "
            "Its dimensions may not be turned. Descriptions: nothing is tested.</p>\n");
}

std::string weights_style() {
    return "\n.stars{display:flex;flex-wrap:wrap;gap:10px;margin-bottom:8px}\n.star{width:92px;"
           "margin:0;text-align:"
           "center}\n.star svg{width:88px;height:88px}\n.star .ray{stroke:var(--line);fill:none}"
           "\n.star .own{fill:var(--accent);fill-opacity:0.3;stroke:var(--accent);stroke-width:1.5}"
           "\n.star .mean{fill:none;stroke:var(--dim-text);stroke-dasharray:3 3}";
}

}  // namespace tact
