#include "app/command_line/agreement/parts.h"

#include <functional>
#include <optional>
#include <utility>

#include "app/command_line/output.h"
#include "app/document/workspace.h"
#include "app/pictures/pictures.h"
#include "app/report/report.h"
#include "model/map/procrustes.h"
#include "model/physiology/neural_coding.h"
#include "model/set/parameter_paths.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"
#include "model/text/numbers.h"

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

// What a picture is of, for who does not see it, and what has to be said of it.
struct PaperFigure {
    std::string stem;
    std::string alt;      // text
    std::string caption;  // html
};

// Both files of a picture; the figure on the page, from the SVG.
Expected<std::string> figure_html(const PaperFigure& figure, const fs::path& folder,
                                  const std::function<Expected<Done>(const fs::path&)>& draw) {
    for (const char* ending : {".png", ".svg"}) {
        const auto drawn = draw(folder / (figure.stem + ending));
        if (!drawn) return drawn.error();
    }
    const Expected<std::string> svg = read_text_file(folder / (figure.stem + ".svg"));
    if (!svg) return svg.error();
    return "<figure id=\"" + figure.stem + "\"><img class=\"picture\" alt=\"" +
           html_escaped(figure.alt) + "\" src=\"data:image/svg+xml;base64," + base64(*svg) +
           "\"><figcaption>" + figure.caption + "</figcaption></figure>\n";
}

PictureSize size_of(const fs::path& file, int width, int height) {
    PictureSize size;
    size.width = width;
    size.height = height;
    size.dark = false;
    size.format = file.extension() == ".svg" ? PictureFormat::svg : PictureFormat::png;
    return size;
}

// All maps of a set in one picture, then each in files of its own.
Expected<std::string> maps_html(const ComparedSet& one, const std::string& along,
                                const fs::path& folder, std::size_t number) {
    const PatternSet set = rated_alone(one);
    const Joined joined = joined_along(set, along);
    const std::vector<PaperMap> maps = maps_of(one);
    std::vector<MapPanel> panels;
    for (const PaperMap& map : maps) {
        MapPanel panel{&map.apart, &map.space, {}};
        panel.marks.quantity = title_of(map, one);
        panel.marks.source = title_of(map, one);
        panel.marks.mark = corner_of(one.agreement.labels);
        panel.marks.paths = joined.paths;
        panels.push_back(panel);
        const std::string stem = file_stem(std::to_string(number) + "-" + map.key);
        for (const char* ending : {".svg", ".png"}) {
            const fs::path file = folder / (stem + ending);
            const auto written = write_picture(
                file,
                space_picture(set, map.apart, map.space, size_of(file, 700, 560), panel.marks));
            if (!written) return written.error();
        }
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
    std::string html;
    if (!panels.empty()) {
        const auto columns = static_cast<int>(panel_columns(panels.size()));
        const auto rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
        const auto figure = figure_html(
            {"maps-" + std::to_string(number), "Maps of people and metrics: " + one.agreement.name,
             "Each is the best map, turned onto that of the ratings by Procrustes rotation." +
                 html_escaped(said)},
            folder, [&](const fs::path& file) {
                return write_picture(
                    file, space_panels_picture(set, panels, one.agreement.name,
                                               corner_of(one.agreement.labels),
                                               size_of(file, 340 * columns, 320 * rows + 160)));
            });
        if (!figure) return figure.error();
        html = *figure;
    }
    return html_section("maps-" + std::to_string(number) + "-of", "Maps: " + one.agreement.name,
                        html + (remarks.empty() ? std::string() : items(remarks)));
}

// When most channels' centres fire most: what the networks are shown of.
double liveliest_s(const Vibration& vibration, const NeuralCodingParams& params) {
    const NeuralCode code = neural_code(waveform_of(vibration), params);
    std::size_t best = 0;
    int most = 0;
    for (std::size_t step = 0; step < code.central_count[0].size(); ++step) {
        int sum = 0;
        for (const std::vector<int>& counts : code.central_count) sum += counts[step];
        if (sum <= most) continue;
        most = sum;
        best = step;
    }
    return static_cast<double>(best) * kStepS;
}

struct PhysiologyView {
    PaperFigure figure;
    const char* view;
    const char* stage;
    bool tilted;
    int width;
    int height;
};

std::vector<PhysiologyView> physiology_views(const std::string& name, double at_s) {
    const std::string of = " of " + name;
    const std::string when = html_escaped(of) + " at " + significant(at_s) + " s.";
    return {{{"figure-4", "How one receptor fires" + of,
              "Figure 4. How one receptor fires" + html_escaped(of) +
                  ": windows of 10 ms, the energy since its last spike, its spikes."},
             "firing",
             "",
             false,
             1000,
             560},
            {{"figure-5", "Slopes and thresholds of four receptor types",
              "Figure 5. Slopes and thresholds that the model reads; dashed beyond a type's band."},
             "tables",
             "",
             false,
             1000,
             460},
            {{"figure-6a", "Receptors on the skin" + of, "Figure 6a. Rates of receptors" + when},
             "physiology",
             "receptors",
             false,
             1200,
             760},
            {{"figure-6b", "Receptors on the skin, tilted" + of,
              "Figure 6b. The same, tilted: height is the rate."},
             "physiology",
             "receptors",
             true,
             1200,
             760},
            {{"figure-7", "Relay networks" + of, "Figure 7. Relay networks" + when},
             "physiology",
             "networks",
             false,
             1200,
             760}};
}

// Figures 4 to 7, of the first pattern of the first set.
Expected<std::string> physiology_html(const PaperCommand& command, const ComparedSet& first,
                                      const fs::path& folder) {
    const Vibration& vibration = first.set.vibrations.front();
    SnapshotCommand snapshot;
    snapshot.common = command.common;
    snapshot.common.sets.resize(1);
    snapshot.theme = "light";
    const double at_s = liveliest_s(vibration, first.set.model.coding);
    std::string html;
    for (const PhysiologyView& view : physiology_views(vibration.name, at_s)) {
        snapshot.view = view.view;
        snapshot.stage = view.stage;
        snapshot.tilted = view.tilted;
        snapshot.pattern = snapshot.view == "tables" ? "" : vibration.name;
        snapshot.at_s = snapshot.view == "physiology" ? std::optional(at_s) : std::nullopt;
        snapshot.width = view.width;
        snapshot.height = view.height;
        const auto figure = figure_html(view.figure, folder, [&](const fs::path& file) {
            snapshot.out = file;
            return run(snapshot);
        });
        if (!figure) return figure.error();
        html += *figure;
    }
    return html_section("physiology", "What the model makes of a pattern", html);
}

}  // namespace

Expected<std::string> write_paper_figures(const PaperCommand& command,
                                          const std::vector<ComparedSet>& sets,
                                          const fs::path& folder) {
    std::string html;
    for (std::size_t k = 0; k < sets.size(); ++k) {
        const auto maps = maps_html(sets[k], command.along, folder, k + 1);
        if (!maps) return maps.error();
        html += *maps;
    }
    const auto physiology = physiology_html(command, sets.front(), folder);
    if (!physiology) return physiology.error();
    return html + *physiology;
}

}  // namespace tact
