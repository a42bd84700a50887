// The parts of a report that a library of many patterns needs: the tree of groups, the closest
// pairs, what nobody feels, and the matrix as a picture.

#include <algorithm>
#include <cmath>

#include "app/report/report.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/picture/picture.h"

namespace tact {

namespace {

constexpr std::size_t kMostPicturePx = 400;  // of a side: its cells are then blocks of pairs
constexpr std::size_t kSmallSet = 24;        // the groups name all pairs worth naming

std::string farthest_html(const Report& report, const PatternGroup& group) {
    if (group.members.size() < 2) return {};
    return name_html(report, group.far_a) + " \u2013 " + name_html(report, group.far_b) +
           " <span class=\"value\">" + value_text(report, group.farthest) + "</span>";
}

struct Mean {
    double sum = 0.0;
    double count = 0.0;
};

// The means of blocks of pairs, row by row; a block of no numbers has a count of 0.
std::vector<Mean> thinned(const Dissimilarity& dissimilarity, const std::vector<std::size_t>& order,
                          std::size_t side) {
    const std::size_t n = order.size();
    std::vector<Mean> blocks(side * side);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            const double value = i == j ? 0.0 : dissimilarity(order[i], order[j]);
            if (!std::isfinite(value)) continue;
            Mean& block = blocks[i * side / n * side + j * side / n];
            block.sum += value;
            block.count += 1.0;
        }
    }
    return blocks;
}

Image matrix_image(const std::vector<Mean>& blocks, std::size_t side, double most) {
    Image image{static_cast<int>(side), static_cast<int>(side), {}};
    image.rgba.reserve(4 * blocks.size());
    for (const Mean& block : blocks) {
        const double share = block.count > 0.0 && most > 0.0 ? block.sum / block.count / most : 1.0;
        const ImU32 colour = closeness_colour(share);
        for (const int shift : {IM_COL32_R_SHIFT, IM_COL32_G_SHIFT, IM_COL32_B_SHIFT}) {
            image.rgba.push_back(static_cast<std::uint8_t>(colour >> shift & 0xFFU));
        }
        image.rgba.push_back(255);
    }
    return image;
}

}  // namespace

std::string alike_section(const Report& report) {
    if (report.alike.groups.empty()) return {};
    std::vector<const PatternGroup*> groups;
    for (const PatternGroup& group : report.alike.groups) groups.push_back(&group);
    std::ranges::stable_sort(groups, std::ranges::greater{},
                             [](const PatternGroup* group) { return group->members.size(); });
    HtmlTable table{{{"stands for it"}, {"patterns"}, {"farthest pair"}}, {}, "alike"};
    const std::size_t listed = std::min(groups.size(), kMostGroups);
    for (std::size_t k = 0; k < listed; ++k) {
        table.rows.push_back(
            {name_html(report, groups[k]->central),
             grouped_digits(groups[k]->members.size()) + names_html(report, groups[k]->members),
             farthest_html(report, *groups[k])});
    }
    return html_section(
        "alike", counted(report.alike.groups.size(), "group", "groups") + " of alike patterns",
        "<p>The set as a tree (average linkage), cut into as many groups as are picked: the mean " +
            html_escaped(report.quantity) +
            " between two groups is larger than within them. The most central pattern stands for "
            "its group. This orders the set; it is no sign that people confuse the patterns of a "
            "group.</p>\n" +
            html_of(table) + and_more(groups.size() - listed, "groups"));
}

std::string closest_html(const Report& report) {
    if (report.set.vibrations.size() <= kSmallSet) return {};
    const std::vector<ConfusablePair> pairs =
        confusable_pairs(felt_pairs(report.dissimilarity, report.unfelt),
                         report.closer_than.dissimilarity, kMostClosest);
    HtmlTable table{{{"the closest pairs"}, {"verdict"}}, {}, "narrow"};
    for (const ConfusablePair& pair : pairs) {
        table.rows.push_back(
            {pair_html(report, pair), words_of(pair_verdict(report.set, pair.a, pair.b))});
    }
    const std::size_t all = std::max(report.alike.closer.pairs, pairs.size());
    return html_of(table) + and_more(all - pairs.size(), "pairs");
}

std::string unfelt_section(const Report& report) {
    if (report.unfelt.empty()) return {};
    return html_section("unfelt", "Not felt",
                        "<p>No receptor of the model answers to " +
                            counted(report.unfelt.size(), "pattern", "patterns") +
                            ": nobody could tell them from nothing. They are part of no group and "
                            "no pair above.</p>\n" +
                            names_html(report, report.unfelt) + "\n");
}

std::string matrix_picture(const Report& report, double most) {
    const std::size_t n = report.dissimilarity.size;
    const std::size_t side = std::min(n, kMostPicturePx);
    const std::vector<std::size_t> order = clustered_order(group_tree(report.dissimilarity));
    const Expected<std::string> png =
        png_bytes(matrix_image(thinned(report.dissimilarity, order, side), side, most));
    if (!png) return "<p>Left out: " + html_escaped(png.error().message) + ".</p>\n";
    const std::string blocks =
        side < n ? " Each point is the mean of about " +
                       significant_digits(
                           std::pow(static_cast<double>(n) / static_cast<double>(side), 2.0), 2) +
                       " pairs."
                 : "";
    return "<p>Rows and columns in the order of the tree of groups, so that alike patterns stand "
           "beside each other." +
           blocks + " The values are in the CSV of <code>tactspace predict</code>.</p>\n" +
           "<img class=\"pairs\" alt=\"Matrix of all pairs, alike ones bright\" "
           "src=\"data:image/png;base64," +
           base64(*png) + "\">\n";
}

}  // namespace tact
