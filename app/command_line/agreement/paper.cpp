// tactspace paper: the tables and figures of Lim & Park 2023 for one's own sets and ratings, in a
// folder with a page, and the scripts that compute its numbers again.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <sstream>

#include "app/command_line/agreement/compared_sets.h"
#include "app/command_line/agreement/methods.h"
#include "app/command_line/agreement/paper_tables.h"
#include "app/command_line/commands.h"
#include "app/command_line/output.h"
#include "app/document/pattern_looks.h"
#include "app/manual/manual_tables.h"
#include "app/pictures/pictures.h"
#include "app/report/html.h"
#include "app/report/html_map.h"
#include "app/report/report_parts.h"
#include "app/report/study_metrics_html.h"
#include "app/session/folders.h"
#include "app/session/program_version.h"
#include "assets/assets.h"
#include "model/map/procrustes.h"
#include "model/set/parameter_paths.h"
#include "model/text/atomic_file.h"
#include "model/text/file_stem.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

// The rated patterns, with the colours that they have everywhere.
PatternSet rated_alone(const ComparedSet& one) {
    PatternSet set = one.set;
    const RatedSet& rated = one.agreement.people.rated;
    if (rated.part) {
        set.vibrations.clear();
        for (const std::size_t place : rated.rated) {
            set.vibrations.push_back(one.set.vibrations[place]);
        }
    }
    give_looks(set);
    return set;
}

struct PaperMap {
    std::string key;  // people, or a metric's
    Dissimilarity apart;
    PerceptualSpace space;  // turned onto the people's
};

// The map of people, then those of the metrics; who has none is left out.
std::vector<PaperMap> maps_of(const ComparedSet& one) {
    std::vector<PaperMap> maps;
    const Mapped& people = rated_of(one.agreement).people;
    if (!people.maps.empty()) maps.push_back({"people", people.dissimilarity, people.space});
    for (std::size_t m = 0; m < metric_count(one.agreement); ++m) {
        const Evaluation& e = one.agreement.table.evaluations[m];
        if (e.map.size() == 0) continue;
        PaperMap map{key_of(one.agreement, m),
                     among_rated(one.agreement.table.matrices[m], one.agreement.people.rated),
                     {}};
        map.space.points =
            people.maps.empty() ? e.map : procrustes(e.map, people.maps.front()).aligned;
        map.space.stress1 = e.stress1;
        map.space.is_degenerate = e.is_degenerate;
        maps.push_back(std::move(map));
    }
    return maps;
}

std::string title_of(const PaperMap& map, const ComparedSet& one) {
    if (map.key != "people") return map.key;
    return one.agreement.people.mark.synthetic ? "synthetic ratings" : "people's ratings";
}

struct Joined {
    std::vector<std::vector<std::size_t>> paths;
    std::string along;  // a parameter's name; empty: nothing is joined
};

Joined joined_along(const PatternSet& set, const std::string& asked) {
    std::optional<PatternParameter> parameter;
    if (asked.empty()) parameter = most_joining(set.vibrations);
    for (const PatternParameter one : kPatternParameters) {
        if (asked == traits(one).key) parameter = one;
    }
    if (!parameter) return {};
    return {paths_along(set.vibrations, *parameter), traits(*parameter).name};
}

// A picture of each map in the folder, as SVG and PNG, and all on the page.
Expected<std::string> figures_of(const ComparedSet& one, const std::string& along,
                                 const fs::path& folder, std::size_t number) {
    const PatternSet set = rated_alone(one);
    const Joined joined = joined_along(set, along);
    std::string html;
    for (const PaperMap& map : maps_of(one)) {
        SpaceMarks marks;
        marks.quantity = title_of(map, one);
        marks.source = title_of(map, one);
        marks.mark = corner_of(one.agreement.labels);
        marks.paths = joined.paths;
        const std::string stem = file_stem(std::to_string(number) + "-" + map.key);
        for (const PictureFormat format : {PictureFormat::svg, PictureFormat::png}) {
            PictureSize size;
            size.width = 700;
            size.height = 560;
            size.dark = false;
            size.format = format;
            const fs::path file =
                folder / (stem + (format == PictureFormat::svg ? ".svg" : ".png"));
            const auto written =
                write_picture(file, space_picture(set, map.apart, map.space, size, marks));
            if (!written) return written.error();
        }
        html += html_of(HtmlMap{.set = set,
                                .dissimilarity = map.apart,
                                .space = map.space,
                                .marks = marks,
                                .id = "map-" + std::to_string(number) + "-" + map.key,
                                .alt = "Map of " + title_of(map, one),
                                .caption = html_escaped(title_of(map, one)) + ", stress-1 " +
                                           shown(map.space.stress1) + ", " + fit_label(map.space) +
                                           "."});
    }
    std::vector<std::string> keys;
    for (std::size_t m = 0; m < metric_count(one.agreement); ++m) {
        keys.emplace_back(key_of(one.agreement, m));
    }
    std::vector<std::string> remarks = remarks_by_metric(keys, one.agreement.table.evaluations);
    const std::string on_people = remark_on_people_map(rated_of(one.agreement));
    if (!on_people.empty()) remarks.insert(remarks.begin(), on_people);
    const std::string said =
        joined.along.empty() ? ""
                             : " Lines join patterns that differ in " + joined.along + " alone.";
    return html_section("maps-" + std::to_string(number), "Maps: " + one.agreement.name,
                        "<p class=\"dim\">Each is the best map, turned onto that of the ratings "
                        "by Procrustes rotation." +
                            html_escaped(said) + "</p>\n<div class=\"maps\">" + html + "</div>\n" +
                            (remarks.empty() ? std::string() : items(remarks)));
}

std::string labels_html(const ComparedSet& one) {
    std::string html;
    std::istringstream lines(text_of(one.agreement.labels));
    for (std::string line; std::getline(lines, line);) {
        html += "<p class=\"warning\">" + html_escaped(one.agreement.name + ": " + line) + "</p>\n";
    }
    return html;
}

Expected<Done> write_tables(const fs::path& folder, const std::vector<ComparedSet>& sets) {
    using Writer = void (*)(std::ostream&, std::span<const ComparedSet>);
    for (const auto& [file, write] :
         {std::pair<const char*, Writer>{"table2.csv", write_table2_csv},
          {"pairs.csv", write_table2_pairs_csv},
          {"maps.csv", write_table2_maps_csv}}) {
        const auto written =
            write_result(folder / file, [&](std::ostream& stream) { write(stream, sets); });
        if (!written) return written;
    }
    for (const char* script : {"table2.py", "table2.R"}) {
        const auto written =
            write_atomically(folder / script, asset(std::string("paper/") + script));
        if (!written) return written;
    }
    return Done{};
}

// Figures 6 and 7 and the stages between, of the first pattern of the first set.
Expected<Done> write_stages(const PaperCommand& command, const ComparedSet& first) {
    SnapshotCommand stages;
    stages.common = command.common;
    stages.common.sets.resize(1);
    stages.view = "physiology";
    stages.pattern = first.set.vibrations.front().name;
    stages.theme = "light";
    stages.figures = true;
    stages.out = command.out / "stages";
    return run(stages);
}

std::string page_of(const std::vector<ComparedSet>& sets, const std::string& figures) {
    std::vector<SetAgreement> agreements;
    std::string labels;
    for (const ComparedSet& one : sets) {
        agreements.push_back(one.agreement);
        labels += labels_html(one);
    }
    HtmlPage page;
    page.title = "How well metrics agree with people";
    page.lead = "Table 2 and Figures 8 to 10 of Lim &amp; Park 2023, of these sets and ratings.";
    page.body =
        labels +
        html_section(
            "table2", "Table 2",
            table2_html(sets) +
                "<p class=\"dim\">rho: Spearman's. K and its average: by the "
                "publication's procedure, of whose bookkeeping the averages are: of |rho|, "
                "an undefined one as 0, a failed map as K = 1. The last two columns keep "
                "the sign, leave out what is undefined, and take the best maps. The "
                "publication's own numbers cannot be reproduced: its ratings are not "
                "public.</p>\n") +
        figures +
        html_section("table1", "Table 1: receptors of the model",
                     table_html("receptors") ? *table_html("receptors") : std::string()) +
        html_section("methods", "How it was computed", methods_html(methods_text(agreements))) +
        html_section("files", "The numbers, and how to get them again",
                     "<p><b>table2.csv</b>, <b>pairs.csv</b> and <b>maps.csv</b>; "
                     "<b>table2.py</b> and <b>table2.R</b> compute the first from the others, "
                     "and say where they differ. <b>figures</b>: every map as SVG and PNG. "
                     "<b>stages</b>: perceived waves, receptors, spikes and relay networks of a "
                     "pattern (Figures 4, 6 and 7).</p>\n");
    page.foot = std::string("<p>Made by ") + kProgramVersion + ", " + utc_today() + ".</p>\n";
    page.style = report_style() +
                 "\n.maps{display:grid;grid-template-columns:repeat(auto-fill,minmax(20em,1fr));"
                 "gap:10px}\n.table2 td,.table2 th{overflow-wrap:normal}\n"
                 "ul{margin:0 0 10px;padding-left:1.2em}\n";
    return html_of(page);
}

}  // namespace

Expected<Done> run(const PaperCommand& command) {
    std::error_code none;
    if (fs::exists(command.out, none) && !fs::is_empty(command.out, none)) {
        return Error{command.out.string() + ": expected a folder that is empty or not there"};
    }
    CompareCommand compare;
    compare.common = command.common;
    compare.ratings = command.ratings;
    compare.metrics_from = command.metrics_from;
    for (const Metric metric : table2_metrics()) compare.metrics.emplace_back(traits(metric).key);
    const Expected<std::vector<ComparedSet>> sets = compared_sets(compare);
    if (!sets) return sets.error();
    if (const auto made = make_folder(command.out / "figures"); !made) return made;
    if (const auto written = write_tables(command.out, *sets); !written) return written;
    std::string figures;
    for (std::size_t k = 0; k < sets->size(); ++k) {
        const auto html = figures_of((*sets)[k], command.along, command.out / "figures", k + 1);
        if (!html) return html.error();
        figures += *html;
    }
    if (const auto written = write_stages(command, sets->front()); !written) return written;
    const auto written = write_atomically(command.out / "paper.html", page_of(*sets, figures));
    if (!written) return written;
    std::cerr << "tactspace: wrote " << (command.out / "paper.html").string() << "\n";
    return Done{};
}

}  // namespace tact
