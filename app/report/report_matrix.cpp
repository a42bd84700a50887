// The matrix of a report as a heat map of cells that say their value.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/report/report.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"

namespace tact {

namespace {

constexpr int kShades = 24;
constexpr std::size_t kMostWrittenRows = 16;  // values have room in the cells

// Groups first, the largest at the corner: what hangs together stands in blocks.
std::vector<std::size_t> by_groups(const Report& report) {
    std::vector<std::size_t> order;
    std::vector<bool> placed(report.dissimilarity.size, false);
    for (const CloseGroup& group : report.alike.closer.groups) {
        for (const std::size_t place : group.members) {
            order.push_back(place);
            placed[place] = true;
        }
    }
    for (std::size_t k = 0; k < placed.size(); ++k) {
        if (!placed[k]) order.push_back(k);
    }
    return order;
}

double largest(const Dissimilarity& dissimilarity) {
    double most = 0.0;
    for (const double value : dissimilarity.condensed) {
        if (std::isfinite(value)) most = std::max(most, value);
    }
    return most;
}

std::string cell_html(const Report& report, std::size_t i, std::size_t j, double most) {
    if (i == j) return "<td>";
    const double value = report.dissimilarity(i, j);
    const std::string pair = html_escaped(report.set.vibrations[i].name) + " \u2013 " +
                             html_escaped(report.set.vibrations[j].name);
    if (!std::isfinite(value)) return "<td title=\"" + pair + ": none\">";
    const double share = most > 0.0 ? value / most : 0.0;
    const int shade = std::clamp(static_cast<int>(share * kShades), 0, kShades - 1);
    const bool is_closer = value < report.closer_than.dissimilarity;
    const std::string text = plain_digits(value, 4);
    return "<td class=\"c" + std::to_string(shade) + (is_closer ? " x" : "") + "\" title=\"" +
           pair + ": " + text + "\">" +
           (report.dissimilarity.size <= kMostWrittenRows ? plain_digits(value, 3) : "");
}

std::string legend(double most) {
    std::string html = "<p class=\"legend\">0 <span class=\"bar\">";
    for (int k = 0; k < kShades; ++k) html += "<i class=\"c" + std::to_string(k) + "\"></i>";
    return html + "</span> " + plain_digits(most, 4) + "</p>\n";
}

}  // namespace

std::string shade_styles() {
    std::string css;
    for (int k = 0; k < kShades; ++k) {
        const ImU32 colour = closeness_colour((k + 0.5) / kShades);
        css += ".c" + std::to_string(k) + "{background-color:" + hex_text(colour) +
               ";color:" + hex_text(readable_on(colour)) + "}";
    }
    return css;
}

std::string matrix_section(const Report& report) {
    const std::size_t n = report.dissimilarity.size;
    const std::string heading = report.quantity + " of every pair";
    const double most = largest(report.dissimilarity);
    if (n > kMostMatrixRows) {
        return html_section("matrix", heading, legend(most) + matrix_picture(report, most));
    }
    const std::vector<std::size_t> order = by_groups(report);
    // Ends of cells and rows go without saying in HTML: a fifth of the page.
    std::string html =
        "<p>Groups first. A dot: closer than " + html_escaped(report.closer_than.words) +
        ". Each cell says its pair and value where the pointer rests.</p>\n" + legend(most) +
        "<div class=\"frame\"><table class=\"matrix\" style=\"--n:" + std::to_string(n) +
        "\">\n<thead><tr><th></th>";
    for (const std::size_t k : order) {
        html += "<th scope=\"col\"><div>" + name_html(report, k) + "</div>";
    }
    html += "</thead>\n<tbody>\n";
    for (const std::size_t i : order) {
        html += "<tr><th scope=\"row\"><div>" + name_html(report, i) + "</div>";
        for (const std::size_t j : order) html += cell_html(report, i, j, most);
        html += "\n";
    }
    return html_section("matrix", heading, html + "</tbody></table></div>\n");
}

}  // namespace tact
