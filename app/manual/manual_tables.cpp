#include "app/manual/manual.h"

#include <array>
#include <limits>

#include "app/document/editing.h"
#include "app/physiology/physiology.h"
#include "app/report/report.h"
#include "devices/rumble/actuator_kind.h"
#include "model/evaluation/metric.h"
#include "model/io/effects/actuator_map.h"
#include "model/io/formats/write_effect.h"
#include "model/pattern/pattern_numbers.h"
#include "model/perceptual_model/model_numbers.h"
#include "model/physiology/mechanoreceptor.h"
#include "model/study/study_numbers.h"
#include "model/text/numbers.h"
#include "model/textbook/textbook.h"

namespace tact {

namespace {

std::string code_html(std::string_view text) { return "<code>" + html_escaped(text) + "</code>"; }

std::string stages_table() {
    HtmlTable table{{{"stage"}, {"in the body"}, {"in the model"}}, {}, {}};
    for (const Stage stage : kStages) {
        const StageText& text = text_of(stage);
        table.rows.push_back({"<b>" + html_escaped(text.name) + "</b>", html_escaped(text.in_body),
                              html_escaped(text.in_model) + "<br><span class=\"dim\">" +
                                  html_escaped(text.equation) + "</span>"});
    }
    return html_of(table);
}

std::string stages_left_out_table() {
    HtmlTable table{{{"stage"}, {"left out"}, {"a choice of ours"}}, {}, {}};
    for (const Stage stage : kStages) {
        const StageText& text = text_of(stage);
        table.rows.push_back({"<b>" + html_escaped(text.name) + "</b>", html_escaped(text.left_out),
                              html_escaped(text.ours)});
    }
    return html_of(table);
}

std::string metrics_table() {
    HtmlTable table{{{"key"}, {"metric"}, {"what it is"}, {"source"}}, {}, {}};
    for (const Metric metric : kMetrics) {
        const MetricTraits& of = traits(metric);
        table.rows.push_back({code_html(of.key), html_escaped(of.name),
                              html_escaped(of.description), html_escaped(of.source)});
    }
    return html_of(table);
}

std::string devices_table() {
    HtmlTable table{
        {{"key"}, {"device"}, {"part of a vibration that it plays"}, {"told every"}}, {}, {}};
    for (const ActuatorKind kind : kActuatorKinds) {
        const ActuatorTraits& of = traits(kind);
        const std::string period =
            of.period_s > 0.0 ? significant_digits(1000.0 * of.period_s, 3) + " ms" : "sample";
        table.rows.push_back(
            {code_html(of.key), html_escaped(of.name), html_escaped(of.keeps), period});
    }
    return html_of(table);
}

std::string sets_table() {
    std::string html = "<ul>\n";
    for (const ExampleSet& set : kExampleSets) {
        html += "<li>" + html_escaped(set.name) + "</li>\n";
    }
    return html + "</ul>\n";
}

std::string targets_table() {
    HtmlTable table{{{"--format"}, {"is"}, {"files end in"}, {"actuator map"}}, {}, {}};
    for (const TargetTraits& of : target_formats()) {
        std::string endings = code_html(of.ending);
        if (*of.beside != '\0') endings += " " + code_html(of.beside);
        table.rows.push_back({code_html(of.key), html_escaped(of.title), endings,
                              *of.map == '\0' ? "none: samples in g" : code_html(of.map)});
    }
    return html_of(table);
}

std::string maps_table() {
    HtmlTable table{{{"map"}, {"from"}, {"Hz", true}}, {}, {}};
    for (const ActuatorMap& map : bundled_actuators()) {
        table.rows.push_back({code_html(map.name), html_escaped(map.source),
                              significant_digits(map.frequency_hz.low, 4) + "\u2013" +
                                  significant_digits(map.frequency_hz.high, 4)});
    }
    return html_of(table);
}

std::string textbook_table() {
    HtmlTable table{{{"fact"}, {"of"}, {"source, and what was read"}, {"id in lessons"}}, {}, {}};
    for (const TextbookFact& fact : textbook()) {
        std::string says = fact.says;
        constexpr std::string_view kValue = "{value}";
        says.replace(says.find(kValue), kValue.size(), value_text(fact));
        const char* const sure = fact.sure == Sure::secondary ? "As cited: " : "";
        table.rows.push_back({html_escaped(says), html_escaped(fact.species + ", " + fact.site),
                              html_escaped(sure + fact.source) + "<br><span class=\"dim\">Read: " +
                                  html_escaped(fact.read) + "</span>",
                              code_html(fact.id)});
    }
    return html_of(table);
}

// The paper's Table 1.
std::string receptors_table() {
    HtmlTable table{{{"type"},
                     {"afferent"},
                     {"channel"},
                     {"band, Hz"},
                     {"units/mm\u00b2", true},
                     {"apart, mm", true},
                     {"weight in NC", true}},
                    {},
                    {}};
    const PerceptualModelParams params;
    for (const Receptor receptor : kReceptors) {
        const ReceptorTraits& of = traits(receptor);
        const std::string high = significant_digits(of.high_hz, 3);
        table.rows.push_back(
            {html_escaped(of.name), of.afferent, of.channel,
             of.low_hz > 0.0 ? significant_digits(of.low_hz, 3) + "\u2013" + high : "below " + high,
             significant_digits(of.density_per_mm2, 3),
             significant_digits(grid_interval_mm(receptor), 4),
             significant_digits(params.channel_weight[index_of(receptor)], 3)});
    }
    return html_of(table);
}

// The numbers of a struct as files hold them: all that takes them goes by the same description.
template <class Struct>
std::string numbers_table() {
    HtmlTable table{
        {{"key"}, {"from", true}, {"to", true}, {"default", true}, {"what it is"}}, {}, {}};
    each_number(Struct{}, "", [&](std::string place, const Number& number, double usual) {
        for (const std::string_view of_first : {"/0/", "/A/"}) {
            const std::size_t at = place.find(of_first);
            if (at != place.npos) place.replace(at, of_first.size(), "/");
        }
        const bool is_bounded = number.range.high < std::numeric_limits<double>::max();
        const auto digits = [](double value) { return significant_digits(value, 6); };
        table.rows.push_back({code_html(place), is_bounded ? digits(number.range.low) : "",
                              is_bounded ? digits(number.range.high) : "",
                              number.kept == Kept::needed ? "needed" : digits(usual),
                              html_escaped(number.help)});
    });
    return html_of(table);
}

struct NamedTable {
    std::string_view name;
    std::string (*html)();
};

constexpr auto kTables = std::to_array<NamedTable>({{"stages", stages_table},
                                                    {"stages_left_out", stages_left_out_table},
                                                    {"metrics", metrics_table},
                                                    {"devices", devices_table},
                                                    {"sets", sets_table},
                                                    {"targets", targets_table},
                                                    {"maps", maps_table},
                                                    {"receptors", receptors_table},
                                                    {"pattern", numbers_table<Pattern>},
                                                    {"model", numbers_table<PerceptualModelParams>},
                                                    {"study", numbers_table<StudyDesign>},
                                                    {"textbook", textbook_table}});

std::string key_html(const std::string& keys) {
    return keys.empty() ? std::string() : "<kbd>" + html_escaped(keys) + "</kbd>";
}

}  // namespace

Expected<std::string> table_html(std::string_view name) {
    std::string names;
    for (const NamedTable& table : kTables) {
        if (table.name == name) return table.html();
        names += (names.empty() ? "" : ", ") + std::string(table.name);
    }
    return Error{"expected one of the tables " + names + ", got \"" + std::string(name) + "\""};
}

std::string keys_html(const ManualSource& source) {
    HtmlTable table{{{"keys and mouse"}, {"do"}}, {}, {}};
    for (const ManualKeyRow& row : source.keys) {
        table.rows.push_back({html_escaped(row.keys), html_escaped(row.what)});
    }
    return html_of(table);
}

std::string menus_html(const ManualSource& source) {
    std::string html = "<div class=\"menus\">\n";
    std::string menu;
    HtmlTable table;
    const auto add = [&] {
        if (!table.rows.empty()) html += "<h4>" + html_escaped(menu) + "</h4>\n" + html_of(table);
    };
    for (const ManualCommandRow& row : source.commands) {
        if (row.menu != menu) {
            add();
            menu = row.menu;
            table = HtmlTable{{{"command"}, {"key", true}}, {}, "narrow"};
        }
        table.rows.push_back({html_escaped(row.name), key_html(row.keys)});
    }
    add();
    return html + "</div>\n";
}

std::string commands_html(const ManualSource& source) {
    std::string html;
    for (const ManualCommandHelp& command : source.command_line) {
        html += "<details id=\"command-" + html_escaped(command.name) + "\"><summary>" +
                code_html("tactspace " + command.name) + " \u2013 " +
                html_escaped(command.summary) + "</summary>\n<pre class=\"help\">" +
                html_escaped(command.text) + "</pre></details>\n";
    }
    return html;
}

}  // namespace tact
