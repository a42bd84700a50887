// How well a map keeps the order of the dissimilarities: the Shepard diagram.

#include <cmath>
#include <cstdio>

#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/progress/progress.h"
#include "app/ui/widgets.h"
#include "model/map/smacof.h"
#include "model/text/numbers.h"
#include "viz/charts/scatter_view.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

// A matrix and the map made from it.
struct ShownFit {
    const Dissimilarity* matrix = nullptr;
    const PerceptualSpace* space = nullptr;
    std::string name;
    bool stale = false;
    std::shared_ptr<const void> owner;  // of both
};

// PM belongs to the map on screen, other metrics to the comparison.
std::optional<ShownFit> shown_fit(const Workspace& work, const ShownMap& shown_map,
                                  const Comparing& comparing,
                                  const std::shared_ptr<const Comparison>& comparison) {
    const bool is_pm = comparing.panel.metric == "pm" && !comparing.panel.shepard_of_people;
    if (is_pm) {
        return ShownFit{&shown_map.transition.shown->prediction.pm,
                        &shown_map.transition.shown->space, "PM",
                        map_state(work, shown_map) == MapState::stale, shown_map.transition.shown};
    }
    if (comparison == nullptr) return std::nullopt;
    const bool stale = shown_comparison(work, shown_map, comparing).is_stale;
    if (!comparing.panel.shepard_of_people) {
        const ComparedMetric& row = metric_of_key(*comparison, comparing.panel.metric);
        return ShownFit{&row.matrix, &row.space, row.name, stale, comparison};
    }
    if (!comparison->people) return std::nullopt;
    const RatedPeople& said = comparison->people->said;
    const Mapped& people = said.rated.people;
    return ShownFit{&people.dissimilarity, &people.space, of_people("ratings", said.mark), stale,
                    comparison};
}

std::string corner_text(const ShownFit& fit) {
    return "stress-1 " + with_decimals(fit.space->stress1, 3) + ", " + fit_label(*fit.space) +
           ", " + std::to_string(fit.space->points.cols()) + "-D";
}

// Sorting the pairs of a large set takes longer than a frame: a job does it, and until it is done
// this is null.
std::shared_ptr<const ShepardFit> followed_fit(const Ui& ui, Comparing& comparing,
                                               const ShownFit& fit) {
    constexpr std::size_t kMostInFrame = 20'000;
    ComparePanelState& panel = comparing.panel;
    const FitRequest request{fit.owner, fit.matrix, fit.space};
    if (panel.fit && panel.fit->request == request) return panel.fit;
    if (!has_jobs(ui) || fit.matrix->condensed.size() <= kMostInFrame) {
        return panel.fit = std::make_shared<const ShepardFit>(shepard_fit(request));
    }
    comparing.fit_job.want(
        request,
        [](const FitRequest& asked, std::stop_token, std::atomic<float>&) {
            return std::optional(shepard_fit(asked));
        },
        ui.wake);
    panel.fit = comparing.fit_job.latest();
    return panel.fit && panel.fit->request == request ? panel.fit : nullptr;
}

void draw_no_fit(Ui& ui, const Comparing& comparing, const Rect& area) {
    if (draw_failure(ui, "shepard", comparing.fit_job.failure())) return;
    draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, "Fitting the distances",
               "All pairs are brought into the order of their dissimilarity.");
    note_rect(ui.rects, "shepard:waits", area.min, area.max);
}

void draw_fit(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing,
              const ShownFit& fit, const std::vector<Vibration>& vibrations, const Rect& area) {
    const std::shared_ptr<const ShepardFit> kept = followed_fit(ui, comparing, fit);
    if (!kept) return draw_no_fit(ui, comparing, area);
    const std::vector<double>& apart = kept->distances;
    const std::vector<double>& fitted = kept->disparities;
    const std::string corner = corner_text(fit);
    const std::string x_title = "dissimilarity by " + fit.name;
    ScatterScene scene;
    scene.x = fit.matrix->condensed;
    scene.y = apart;
    scene.fitted = fitted;
    scene.summary = &kept->summary;
    scene.x_title = x_title;
    scene.y_title = "distance in the map";
    scene.corner = corner;
    scene.stale = looks_stale(ui, "shepard", fit.owner, fit.stale);
    scene.selected = scatter_selection(work, shown_map, vibrations);
    scene.readout = [&](std::size_t k) {
        const auto [i, j] = pair_at(vibrations.size(), k);
        return std::vector<std::string>{
            vibrations[i].name + " \u2013 " + vibrations[j].name,
            fit.name + " " + significant(scene.x[k]) + ", distance " + significant(apart[k]),
            "where the order wants it " + significant(fitted[k])};
    };
    const ScatterAction action = draw_scatter("shepard", ui.theme, area, scene);
    note_rect(ui.rects, "view:Shepard", area.min, area.max, corner + ", " + x_title);
    choose_clicked(work, vibrations, action.clicked);
}

// Whether both have the same number of patterns: their pairs then have the same indices.
bool is_open_set(const Workspace& work, const std::vector<Vibration>& vibrations) {
    return vibrations.size() == work.document.set.vibrations.size();
}

}  // namespace

ShepardFit shepard_fit(const FitRequest& request) {
    ShepardFit made{request, distances(request.space->points), {}, {}};
    const std::vector<double>& given = request.matrix->condensed;
    made.disparities = disparities(given, made.distances);
    made.summary = summary_of(given, made.distances, made.disparities);
    return made;
}

std::optional<std::size_t> scatter_selection(const Workspace& work, const ShownMap& shown_map,
                                             const std::vector<Vibration>& vibrations) {
    const auto pair = chosen_pair(work, shown_map);
    if (!pair || !is_open_set(work, vibrations)) return std::nullopt;
    return pair_index(vibrations.size(), std::min(pair->current, pair->partner),
                      std::max(pair->current, pair->partner));
}

void choose_clicked(Workspace& work, const std::vector<Vibration>& vibrations,
                    std::optional<std::size_t> clicked) {
    if (!clicked || !is_open_set(work, vibrations)) return;
    const auto [i, j] = pair_at(vibrations.size(), *clicked);
    choose_pair(work, i, j);
}

std::vector<NamedMetric> named_metrics(const Comparing& comparing) {
    std::vector<NamedMetric> all;
    for (const Metric metric : kMetrics) {
        all.push_back({traits(metric).key, traits(metric).name, metric_help(metric)});
    }
    for (const ForeignMetric& one : comparing.foreign) {
        all.push_back({one.key, one.key, "A metric of your own, from " + one.from + "."});
    }
    return all;
}

std::string metric_help(Metric metric) {
    const MetricTraits& about = traits(metric);
    return std::string(about.name) + ": " + about.description + ". " + about.source + ".";
}

void draw_metric_choice(Ui& ui, const Workspace& work, Comparing& comparing, bool with_people) {
    const bool people = with_people && comparing.panel.shepard_of_people;
    const std::vector<NamedMetric> all = named_metrics(comparing);
    const auto chosen = std::ranges::find(all, comparing.panel.metric, &NamedMetric::key);
    const NamedMetric& shown = chosen == all.end() ? all.front() : *chosen;
    const Item words{.id = "combo:metric",
                     .label = people ? "Ratings" : shown.name,
                     .tip = people ? "The map of what people said." : shown.help};
    drop_down(ui, words, 170.0F * ui.theme.scale, [&] {
        for (const NamedMetric& metric : all) {
            const Item item{.id = "choose:" + metric.key, .label = metric.name, .tip = metric.help};
            if (!option(ui, item, !people && metric.key == shown.key)) continue;
            comparing.panel.metric = metric.key;
            comparing.panel.shepard_of_people = false;
        }
        if (with_people && !work.document.set.ratings.empty() &&
            option(ui, {.id = "choose:ratings", .label = "Ratings"}, people)) {
            comparing.panel.shepard_of_people = true;
        }
    });
}

void draw_shepard_diagram(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing,
                          const Rect& area) {
    if (area.width() < 40.0F || area.height() < 40.0F) return;
    // Both are kept alive while they are drawn.
    const std::shared_ptr<const Comparison> comparison = comparing.comparison;
    const std::shared_ptr<const LiveMap> map = shown_map.transition.shown;
    const auto fit = map ? shown_fit(work, shown_map, comparing, comparison) : std::nullopt;
    if (!fit) return;
    if (fit->space->points.rows() != static_cast<Eigen::Index>(fit->matrix->size)) {
        return draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, "No map of this metric",
                          "All pairs are equally alike by it: any map fits, so none is made.");
    }
    const bool is_pm = fit->matrix == &map->prediction.pm;
    const LiveMap& of = is_pm ? *map : *comparison->request.map;
    draw_fit(ui, work, shown_map, comparing, *fit, of.request.set->vibrations, area);
}

void draw_shepard_panel(Ui& ui, Workspace& work, const ShownMap& shown_map, Comparing& comparing) {
    draw_metric_choice(ui, work, comparing, true);
    const bool has_map = shown_map.transition.shown && shown_map.transition.to.rows() >= 2 &&
                         work.document.set.vibrations.size() >= 2;
    if (!has_map && draw_failure(ui, "shepard", shown_map.full_job.failure())) return;
    if (!has_map) {
        const Rect area = rest_of_pane();
        if (area.empty()) return;
        draw_empty(*ImGui::GetWindowDrawList(), ui.theme, area, "No map yet",
                   "Each pair will be a point here: how far apart it is predicted to feel, and "
                   "how far apart the map puts it.");
        return;
    }
    const bool is_there = shown_fit(work, shown_map, comparing, comparing.comparison).has_value();
    if (!is_there) {
        (void)draw_comparison_state(ui, work, shown_map, comparing);
        return;
    }
    const ImFont* font = ui.theme.fonts.small;
    const std::string whole = "points on the line are in perfect order";
    const std::string brief = "line: perfect order";
    const bool beside = flow_on(text_size(font, brief).x, ui.theme.gap_px);
    ImGui::PushFont(ui.theme.fonts.small);
    if (beside) ImGui::AlignTextToFramePadding();
    const float room = ImGui::GetContentRegionAvail().x;
    dim_text(ui, text_size(font, whole).x <= room ? whole : shortened(font, brief, room));
    ImGui::PopFont();
    draw_shepard_diagram(ui, work, shown_map, comparing, rest_of_pane());
}

}  // namespace tact
