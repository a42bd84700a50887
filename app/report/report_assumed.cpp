// What a report rests on: model, device, effects that were read, marks of what nobody felt; and the
// looks of the whole page.

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

#include "app/rendering/rendering.h"
#include "app/report/report.h"
#include "model/io/set/model_file.h"
#include "model/set/layers.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr const char* kLooks = R"css(
.tiles{display:grid;grid-template-columns:repeat(auto-fit,minmax(150px,1fr));gap:12px;
  margin:20px 0 16px}
.tiles div{background:var(--pane);border:1px solid var(--line);border-radius:8px;padding:12px 16px;
  color:var(--dim-text);font-size:13px;line-height:1.35}
.tiles b{display:block;color:var(--text);font-size:28px;font-weight:600;line-height:1.2}
.warning{color:var(--warning);font-weight:600}
.note{border-left:3px solid var(--warning);padding-left:12px}
.picked{font-weight:600}
.picked::before{content:"\25C9\00A0";color:var(--accent);font-weight:400}
.value{color:var(--dim-text);white-space:nowrap}
.names{display:flex;flex-wrap:wrap;gap:2px 12px}
.names .name{white-space:normal}
.numbers,.origin{color:var(--dim-text);font-size:12px;line-height:1.35}
.narrow{width:auto}
.narrow td{padding-right:24px}
.patterns td:nth-child(1){color:var(--dim-text)}
.patterns td:nth-child(3){width:184px}
.patterns td:nth-child(4){width:150px}
.patterns td:nth-child(5){width:92px;padding-right:0}
.groups td{vertical-align:top}
.groups td:nth-child(1){width:50%}
.alike td{vertical-align:top}
.alike td:nth-child(2){width:56%}
.pairs{display:block;width:min(100%,760px);image-rendering:pixelated}
.wave{display:block;width:172px;height:32px}
.wave path{fill:var(--accent)}
.wave .edge{fill:none;stroke:var(--accent);stroke-width:1.5;vector-effect:non-scaling-stroke}
audio{display:block;width:172px;height:28px;margin-top:4px}
.verdict{display:inline-block;border-radius:10px;padding:1px 9px;font-size:12px;white-space:nowrap;
  border:1px solid currentColor}
.verdict.same{color:var(--error);font-weight:600}
.verdict.hard{color:var(--warning)}
.verdict.clear{color:var(--dim-text);border-color:var(--line)}
.legend{display:flex;align-items:center;gap:8px;color:var(--dim-text);font-size:13px}
.bar{display:flex}
.bar i{width:8px;height:12px}
table.matrix{--cell:clamp(11px,calc(576px/var(--n)),40px);width:auto;border-collapse:separate;
  border-spacing:0;table-layout:fixed;font-size:min(12px,calc(var(--cell) - 1px));line-height:1}
.matrix td{width:var(--cell);min-width:var(--cell);height:var(--cell);padding:0;border:0;
  text-align:center}
.matrix td:hover{outline:2px solid var(--text);outline-offset:-1px}
.matrix th{padding:0;border:0;font-weight:400;color:var(--dim-text);height:var(--cell)}
.matrix th div{overflow:hidden;white-space:nowrap;text-overflow:ellipsis}
.matrix tbody th{position:sticky;left:0;background:var(--pane)}
.matrix tbody th div{max-width:116px;padding-right:6px;text-align:right;line-height:1.2}
.matrix thead th div{writing-mode:vertical-rl;transform:rotate(180deg);max-height:116px;
  width:var(--cell);line-height:var(--cell);padding-top:6px}
.matrix thead th{vertical-align:bottom}
.matrix tr:hover th{color:var(--text)}
.matrix .picked::before{content:""}
.matrix .x{background-image:radial-gradient(circle,#fff 0 18%,transparent 22%)}
pre{white-space:pre-wrap;font-size:12px;line-height:1.4;margin:8px 0 0}
dl{display:grid;grid-template-columns:max-content 1fr;gap:6px 20px;margin:0;font-size:13px}
dt{color:var(--dim-text)}
dd{margin:0}
@media (max-width:640px){dl{grid-template-columns:1fr}}
@media print{
.tiles div,.verdict.clear{border-color:var(--line)}
.tiles{grid-template-columns:repeat(4,1fr)}
table.matrix{--cell:min(8mm,calc(150mm/var(--n)))}
.matrix tbody th{position:static}
.matrix tbody th div{max-width:26mm}
#matrix{break-before:page}
}
)css";

std::string item(const std::string& what, const std::string& html) {
    return "<dt>" + html_escaped(what) + "</dt><dd>" + html + "</dd>\n";
}

std::string scale_words(const Report& report) {
    const std::string pairs = grouped_digits(report.dissimilarity.condensed.size());
    if (report.quantity != "PM") {
        return "Distances are by " + html_escaped(report.quantity) + " of " + pairs + " pairs.";
    }
    return "PM joins ranks of the " + pairs +
           " pairs of this set, 1 the most alike: it compares pairs within this set, and changes "
           "when a pattern is added. It is no probability of a confusion.";
}

std::string thresholds_words(const Report& report) {
    return "Verdicts are of felt steps alone: what is within a step was measured in parts "
           "(amplitude, "
           "frequency, rhythm), what is clear is a choice of this program, " +
           significant_digits(kClearSteps, 2) + " steps. Closer than " +
           html_escaped(report.closer_than.words) + ": below " +
           plain_digits(report.closer_than.dissimilarity, 4) + ", " +
           html_escaped(report.closer_than.source) + ". Nobody has measured at which " +
           html_escaped(report.quantity) + " two are confused.";
}

std::string model_words(const Report& report) {
    const ModelOrigin& origin = report.set.model_origin;
    std::string html = "Lim &amp; Park 2023: receptors of the fingertip, relay neurons, rhythm. ";
    if (origin.trained_on.empty()) {
        html += "Weights as published; what the publication leaves open is chosen by this program.";
    } else {
        html += html_escaped(origin.trained_on);
    }
    if (origin.changed_by_hand) html += " Changed by hand since.";
    return html + "<details><summary>What differs from the standard parameters</summary><pre>" +
           html_escaped(print_model({report.set.model, {}})) + "</pre></details>";
}

std::string device_words(const Report& report) {
    if (!report.by) {
        return "None: patterns are taken as they are meant, as an actuator without faults would "
               "play them.";
    }
    return "The patterns " + html_escaped(words_on(*report.by)) + ": " +
           html_escaped(strength_words(*report.by)) + ".";
}

// A note, and of how many patterns it is said.
struct SharedNote {
    std::string text;
    std::size_t patterns = 0;
};

// What notes say behind their first sentence, such as the actuator map of an effect.
std::vector<SharedNote> said_in_notes(const PatternSet& set) {
    std::vector<SharedNote> all;
    for (const Vibration& vibration : set.vibrations) {
        const std::string first = first_sentence(vibration.note);
        if (first.size() + 1 >= vibration.note.size()) continue;
        const std::string rest = vibration.note.substr(first.size() + 1);
        const auto known = std::ranges::find(all, rest, &SharedNote::text);
        if (known == all.end()) {
            all.push_back({rest, 1});
        } else {
            ++known->patterns;
        }
    }
    return all;
}

std::string kinds_words(const PatternSet& set) {
    std::size_t recorded = 0;
    std::size_t synthetic = 0;
    for (const Vibration& vibration : set.vibrations) {
        if (recordings_in(vibration).empty()) continue;
        ++(is_synthetic(vibration) ? synthetic : recorded);
    }
    std::string text =
        counted(set.vibrations.size() - recorded - synthetic, "pattern", "patterns") +
        " made of parameters";
    if (recorded > 0) text += ", " + grouped_digits(recorded) + " recorded";
    if (synthetic > 0) {
        text += ", " + grouped_digits(synthetic) + " SYNTHETIC: measured by nobody, computed";
    }
    return text + ".";
}

// Nothing where no pattern comes of another program's file.
std::string actuators_item(const PatternSet& set) {
    std::string text;
    for (const auto& [actuator, count] : actuators_of(set)) {
        text += (text.empty() ? "0 to 1 of effect files became g and Hz by " : ", ") +
                html_escaped(actuator) + " (" + counted(count, "pattern", "patterns") + ")";
    }
    return text.empty() ? "" : item("Actuator maps", text + ".");
}

}  // namespace

std::string report_style() { return kLooks + shade_styles(); }

std::string assumed_section(const Report& report) {
    std::string html =
        "<dl>\n" + item("Patterns", kinds_words(report.set)) + item("Scale", scale_words(report)) +
        item("Thresholds", thresholds_words(report)) + item("Model", model_words(report)) +
        item("Device", device_words(report)) + actuators_item(report.set);
    for (const SharedNote& said : said_in_notes(report.set)) {
        html += item(counted(said.patterns, "pattern", "patterns"), html_escaped(said.text));
    }
    return html_section("assumed", "What was assumed", html + "</dl>\n");
}

}  // namespace tact
