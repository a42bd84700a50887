#include "app/export/export.h"

#include <algorithm>

#include "app/rendering/rendering.h"
#include "app/report/report.h"
#include "model/export/loss_words.h"

namespace tact {

namespace {

std::string paragraph(const std::string& html, const char* kind = "") {
    const std::string attribute = *kind == '\0' ? "" : std::string(" class=\"") + kind + "\"";
    return "<p" + attribute + ">" + html + "</p>\n";
}

std::string sentence(const std::string& text) { return html_escaped(text) + "."; }

std::string remarks_html(const PatternLoss& loss) {
    if (loss.remarks.empty()) return "nothing lost";
    std::string html;
    for (const std::string& remark : loss.remarks) {
        html += (html.empty() ? "" : "<br>") + html_escaped(remark);
    }
    return html;
}

// The file of the pattern at a place; empty where none is written.
std::string file_of(const ExportPage& page, std::size_t place) {
    const auto found = std::ranges::find(page.written, place);
    if (found == page.written.end()) return {};
    return page.files[static_cast<std::size_t>(found - page.written.begin())];
}

std::string patterns_section(const ExportPage& page) {
    HtmlTable table{{{"Pattern", false},
                     {"What was lost", false},
                     {"RMS error, g", true},
                     {"PSNR, dB", true},
                     {"PM from what was meant", true}},
                    {}};
    for (const std::size_t k : written_first(page.loss, page.written)) {
        const PatternLoss& one = page.loss.patterns[k];
        const std::string file = file_of(page, k);
        table.rows.push_back({html_escaped(one.name) + "<br><span class=\"dim\">" +
                                  (file.empty() ? "not written" : html_escaped(file)) + "</span>",
                              remarks_html(one), loss_number(one.rms_error_g), psnr_text(one),
                              moved_text(one)});
    }
    return html_section("patterns", "Pattern by pattern", html_of(table));
}

std::string set_section(const ExportLoss& loss) {
    HtmlTable table{{{"PM", false}, {"as it was meant", false}, {"as it comes back", false}}, {}};
    for (const BeforeAfter& row : before_after_rows(loss)) {
        table.rows.push_back(
            {html_escaped(row.what), html_escaped(row.before), html_escaped(row.after)});
    }
    std::string html = paragraph(sentence(subset_verdict(loss)));
    if (!table.rows.empty()) html += html_of(table) + paragraph(sentence(kAfterScale), "dim");
    return html_section("subset", "The most distinct", html);
}

std::string map_section(const ExportPage& page) {
    if (!page.loss.map) return {};
    const MapChange& map = *page.loss.map;
    PerceptualSpace space;
    space.points = map.after;
    space.stress1 = map.stress_after;
    HtmlMap shown{page.set, page.loss.after, space};
    shown.marks.before = &map.before;
    const std::vector<std::size_t> best = best_for_target(page.loss);
    shown.marks.chosen = best;
    shown.id = "map";
    shown.alt = "Map of the patterns as they come back; arrows lead from where they were meant.";
    shown.caption =
        "Far apart is easily told apart. Arrows lead from where each pattern was meant to where it "
        "comes back; the map before and the map after are turned and scaled onto each other "
        "(correlation " +
        loss_number(map.correlation) + "). Ringed: the best for this target.";
    return html_section("maps", "The map, before and after", html_of(shown));
}

std::string pairs_section(const ExportLoss& loss) {
    if (loss.most_moved.empty()) return {};
    HtmlTable table{{{"Pair", false}, {"PM before", true}, {"PM after", true}}, {}};
    for (const PairChange& one : loss.most_moved) {
        table.rows.push_back({html_escaped(pair_text(loss, one.a, one.b)), loss_number(one.before),
                              loss_number(one.after)});
    }
    return html_section("pairs", "Pairs that moved most", html_of(table));
}

std::string assumed_section(const ExportLoss& loss) {
    std::string meaning = meaning_of(loss.target);
    meaning.front() = static_cast<char>(meaning.front() - 'a' + 'A');
    return html_section(
        "assumed", "What was assumed",
        paragraph(html_escaped(meaning) + (meaning.ends_with('.') ? "" : ".")) +
            paragraph("Each file was read back by the program's own reader and predicted by PM "
                      "(Lim and Park 2023): one fingertip, no differences between people. What the "
                      "device itself makes of the file is not in it. Phases count in RMS error and "
                      "PSNR, though nobody feels them."));
}

}  // namespace

std::string export_report(const ExportPage& page) {
    const ExportLoss& loss = page.loss;
    HtmlPage html;
    html.title = "What the export costs";
    html.lead = sentence(std::string("The patterns") +
                         (page.set.name.empty() ? "" : " of \"" + page.set.name + "\"") + " " +
                         words_on(loss.target) + ". " + summary_of(loss, page.written));
    for (const std::string& line : lines_of(Labels{.mark = mark_of(page.set)})) {
        html.body += paragraph(sentence(line), "label");
    }
    html.body += set_section(loss) + map_section(page) + pairs_section(loss) +
                 patterns_section(page) + assumed_section(loss);
    html.foot = "Made by tactspace";
    return html_of(html);
}

}  // namespace tact
