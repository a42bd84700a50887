#include "app/report/weights_html.h"

#include <span>

#include "app/report/html.h"
#include "model/text/numbers.h"
#include "viz/charts/star_view.h"

namespace tact {

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
