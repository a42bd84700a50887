#include "app/report/report.h"

#include <algorithm>
#include <limits>

#include "app/map/map.h"
#include "app/rendering/rendering.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

std::size_t grouped_patterns(const CloseGroups& close) {
    std::size_t count = 0;
    for (const CloseGroup& group : close.groups) count += group.members.size();
    return count;
}

}  // namespace

std::string pair_html(const Report& report, const ConfusablePair& pair) {
    return name_html(report, pair.a) + " \u2013 " + name_html(report, pair.b) +
           " <span class=\"value\">" + value_text(report, pair.dissimilarity) + "</span>";
}

namespace {

// One group of nearly everything says little: who reads it is to know why, and what to do.
std::string chain_remark(const Report& report) {
    const auto& groups = report.alike.closer.groups;
    const std::size_t all = report.set.vibrations.size();
    if (groups.empty() || 2 * groups.front().members.size() <= all || all < 8) return {};
    return "<p class=\"note\">One group holds more than half of the patterns: neighbours hang "
           "together in a chain whose ends are far apart. A lower threshold, or a pair whose "
           "likeness you know, parts it.</p>\n";
}

std::string step_words(const Report& report) {
    const auto step = [&](PatternParameter parameter) {
        return percent(step_of(report.set.felt_steps, parameter) - 1.0);
    };
    return "no number of theirs differs by as much as people are taken to feel (an amplitude by " +
           step(PatternParameter::amplitude) + ", a carrier by " + step(PatternParameter::carrier) +
           "), and nothing but numbers differs";
}

std::string threshold_sentence(const Report& report) {
    return grouped_digits(report.alike.closer.pairs) + " of " +
           counted(report.dissimilarity.condensed.size(), "pair has", "pairs have") + " a " +
           html_escaped(report.quantity) + " below <b>" +
           plain_digits(report.closer_than.dissimilarity, 4) + "</b>, " +
           html_escaped(report.closer_than.source) +
           ". That orders the pairs of this set; it is no sign that people confuse them.";
}

// How the groups fall apart below the threshold: it is nobody's measurement.
std::string ladder_sentence(const Report& report) {
    const Dissimilarity felt = felt_pairs(report.dissimilarity, report.unfelt);
    const double at = report.closer_than.dissimilarity;
    const auto left_at = [&](double threshold) {
        return grouped_digits(distinct_count(groups_below(felt, threshold)));
    };
    return "Were each group one, " + left_at(at) + " would be left of " +
           counted(report.set.vibrations.size(), "pattern", "patterns") +
           "; at half the threshold (" + value_text(report, at / 2.0) + ") " + left_at(at / 2.0) +
           ", at a quarter (" + value_text(report, at / 4.0) + ") " + left_at(at / 4.0) + ".";
}

std::string tiles(const Report& report) {
    const CloseGroups& confused = report.alike.confused;
    const Subset& best = report.answer.best;
    return "<div class=\"tiles\">" +
           tile(grouped_digits(report.set.vibrations.size()), "patterns") +
           tile(grouped_digits(grouped_patterns(confused)),
                "of them in " + counted(confused.groups.size(), "group", "groups") +
                    " that feel the same") +
           tile(grouped_digits(report.alike.closer.pairs),
                "of " + counted(report.dissimilarity.condensed.size(), "pair", "pairs") +
                    " closer than " + html_escaped(report.closer_than.words)) +
           tile(grouped_digits(best.members.size()),
                std::string("most distinct, ") +
                    (report.answer.proof == SubsetProof::open || report.best_worth
                         ? "the best that was found"
                         : "proven")) +
           "</div>\n";
}

std::string labels_html(const Report& report) {
    std::string html;
    for (const std::string& label : report.labels) {
        html += "<p class=\"warning\">" + html_escaped(label) + "</p>\n";
    }
    return html;
}

std::string sure_html(const Report& report) {
    if (report.stability == nullptr) return {};
    const Stability& sure = *report.stability;
    std::string html =
        "<h3>How sure</h3>\n<p>In " + counted(sure.draws, "draw", "draws") +
        " of what is uncertain in the model (thresholds of the skin by 6 dB either way, choices "
        "that the publication leaves open) this very subset stays the best in <b>" +
        html_escaped(percent(sure.share_same)) + "</b>, its weakest pair the weakest in " +
        html_escaped(percent(sure.share_weakest)) + ".</p>\n";
    HtmlTable table{{{"pattern"}, {"picked in", true}}, {}, "narrow"};
    for (const std::size_t place : ever_picked(sure)) {
        table.rows.push_back(
            {name_html(report, place), html_escaped(percent(sure.share_picked[place]))});
    }
    return html + html_of(table);
}

}  // namespace

std::string tile(const std::string& number, const std::string& words) {
    return "<div><b>" + number + "</b>" + words + "</div>";
}

std::string and_more(std::size_t count, const std::string& what) {
    if (count == 0) return {};
    return "<p class=\"dim\">And " + grouped_digits(count) + " more " + what + ".</p>\n";
}

std::string names_html(const Report& report, const std::vector<std::size_t>& places) {
    const std::size_t named = std::min(places.size(), kMostNamed);
    std::string html = "<div class=\"names\">";
    for (std::size_t k = 0; k < named; ++k) {
        html += (k == 0 ? "" : " ") + name_html(report, places[k]);
    }
    if (named < places.size()) html += " and " + grouped_digits(places.size() - named) + " more";
    return html + "</div>";
}

bool is_picked(const Report& report, std::size_t place) {
    return std::ranges::binary_search(report.answer.best.members, place);
}

std::string name_html(const Report& report, std::size_t place) {
    return std::string("<span class=\"") + (is_picked(report, place) ? "name picked" : "name") +
           "\">" + html_escaped(report.set.vibrations[place].name) + "</span>";
}

std::string value_text(const Report& report, double dissimilarity) {
    return html_escaped(report.quantity) + " " + plain_digits(dissimilarity, 4);
}

CloserThan closer_than_picked(const SubsetAnswer& answer) {
    const bool is_proven = answer.proof != SubsetProof::open;
    const std::string count = std::to_string(answer.best.members.size());
    return {answer.best.weakest_dissimilarity, "your " + count,
            "as far apart as the weakest pair of the " + count +
                (is_proven ? " most distinct, proven" : " most distinct that were found")};
}

std::string proof_sentence(const Report& report) {
    const bool by_sum = report.objective == SubsetObjective::max_sum;
    if (report.best_worth) {
        return std::string("It was taken instead of the best one, whose ") +
               (by_sum ? "sum is " : "weakest pair has ") +
               plain_digits(*report.best_worth, by_sum ? 6 : 4) + ".";
    }
    switch (report.answer.proof) {
        case SubsetProof::optimal:
            return by_sum ? "Proven optimal: no other subset of this size has a larger sum."
                          : "Proven optimal: in no other subset of this size is the weakest pair "
                            "farther apart.";
        case SubsetProof::ties_open:
            return "No weakest pair can be farther apart; time ran out before the sum was settled.";
        case SubsetProof::open:
            break;
    }
    return "Time ran out: the best that was found. No " +
           std::string(by_sum ? "sum" : "weakest pair") + " is above " +
           plain_digits(report.answer.bound, 6) + ".";
}

std::string map_section(const Report& report) {
    if (report.space.points.rows() == 0) {
        const std::string why = verdict_text(report.space, report.set.vibrations.size());
        return html_section("map", "Map", "<p>" + html_escaped(why) + "</p>\n");
    }
    std::vector<SpaceLink> links;
    for (const ConfusablePair& pair : report.alike.confused.links)
        links.push_back({pair.a, pair.b});
    std::string caption = "Near is alike, far is told apart. Ringed: the " +
                          counted(report.answer.best.members.size(), "pattern", "patterns") +
                          " picked.";
    if (!links.empty()) caption += " Lines hold groups together that feel the same.";
    caption += " From " + html_escaped(report.space_of) + " of all pairs, stress-1 " +
               significant_digits(report.space.stress1, 3) + ", " + fit_label(report.space) + ". " +
               html_escaped(verdict_text(report.space, report.set.vibrations.size()));
    const HtmlMap map{.set = report.set,
                      .dissimilarity = report.dissimilarity,
                      .space = report.space,
                      .marks = {.chosen = report.answer.best.members,
                                .links = links,
                                .before = nullptr,
                                .quantity = report.space_of},
                      .id = "space",
                      .alt = "Map of the patterns: near ones feel alike",
                      .caption = caption};
    return html_section("map", "Map", html_of(map));
}

namespace {

std::string groups_table(const Report& report, const CloseGroups& close) {
    HtmlTable table{{{"patterns"}, {"closest pair"}, {"farthest pair"}}, {}, "groups"};
    const std::size_t listed = std::min(close.groups.size(), kMostGroups);
    for (std::size_t k = 0; k < listed; ++k) {
        const CloseGroup& group = close.groups[k];
        table.rows.push_back({names_html(report, group.members), pair_html(report, group.closest),
                              group.members.size() > 2 ? pair_html(report, group.farthest) : ""});
    }
    return html_of(table) + and_more(close.groups.size() - listed, "smaller groups");
}

}  // namespace

std::string groups_section(const Report& report) {
    constexpr const char* kTitle = "Groups that feel the same";
    std::string html = "<p>Two patterns count as the same where " + step_words(report) + ".";
    if (report.alike.confused.groups.empty()) {
        return html_section("groups", kTitle, html + " There are no two such patterns.</p>\n");
    }
    html += "</p>\n" + groups_table(report, report.alike.confused) +
            "<p class=\"dim\">Each member is within a felt step of some other, not of all. Ringed "
            "names are picked.</p>\n";
    return html_section("groups", kTitle, html);
}

std::string closer_section(const Report& report) {
    const std::string title = "Closer than " + html_escaped(report.closer_than.words);
    std::string html = "<p>" + threshold_sentence(report) + "</p>\n";
    if (report.alike.closer.groups.empty()) return html_section("closer", title, html);
    html += "<p>" + ladder_sentence(report) + "</p>\n" + chain_remark(report) +
            closest_html(report) + groups_table(report, report.alike.closer) +
            "<p class=\"dim\">Single linkage: each member is below the threshold from some other, "
            "not from all. Ringed names are picked.</p>\n";
    return html_section("closer", title, html);
}

std::string subset_section(const Report& report) {
    const Subset& best = report.answer.best;
    std::string html =
        "<p>The weakest pair is " + name_html(report, best.weakest.first) + " and " +
        name_html(report, best.weakest.second) + ", <b>" +
        value_text(report, best.weakest_dissimilarity) + "</b>; all pairs together " +
        plain_digits(best.sum, 6) + ". " + html_escaped(proof_sentence(report)) +
        (report.left_out.empty() ? "" : " " + html_escaped(report.left_out) + ".") + "</p>\n";
    std::string kept;
    HtmlTable table{
        {{"pattern"}, {"nearest of the others picked"}, {report.quantity, true}}, {}, {}};
    for (const std::size_t place : best.members) {
        std::size_t nearest = place;
        double least = std::numeric_limits<double>::infinity();
        for (const std::size_t other : best.members) {
            const double apart = report.dissimilarity(place, other);
            if (other != place && apart < least) {
                nearest = other;
                least = apart;
            }
        }
        if (report.set.vibrations[place].locked) {
            kept += (kept.empty() ? "" : ", ") + name_html(report, place);
        }
        const bool has_nearest = nearest != place;
        table.rows.push_back({name_html(report, place),
                              has_nearest ? name_html(report, nearest) : "",
                              has_nearest ? plain_digits(least, 4) : ""});
    }
    if (!kept.empty()) html += "<p>Kept beforehand: " + kept + ".</p>\n";
    return html_section("subset", "The " + std::to_string(best.members.size()) + " most distinct",
                        html + html_of(table) + sure_html(report));
}

std::string report_page(const Report& report) {
    const std::string name = report.set.name.empty() ? "A set of vibrations" : report.set.name;
    const bool is_predicted = report.quantity == "PM";
    HtmlPage page;
    page.title = name;
    page.lead = "How these vibrations differ, and which to take: " +
                (is_predicted ? std::string("predicted from the physiology of touch")
                              : "by " + html_escaped(report.quantity)) +
                (report.by ? ", " + html_escaped(words_on(*report.by)) : "") + ".";
    page.body = labels_html(report) + tiles(report) + map_section(report) + groups_section(report) +
                alike_section(report) + closer_section(report) + unfelt_section(report) +
                subset_section(report) + patterns_section(report) + matrix_section(report) +
                assumed_section(report);
    page.foot =
        "<p>Made by " + html_escaped(report.program) +
        (report.date.empty() ? "" : ", " + html_escaped(report.date)) +
        (is_predicted ? ". A prediction: nobody was asked about these patterns for it." : ".") +
        "</p>\n";
    page.style = report_style();
    return html_of(page);
}

}  // namespace tact
