#include "app/compare/compare.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/ui/ui.h"
#include "model/map/procrustes.h"
#include "model/set/set_ratings.h"

namespace tact {

namespace {

bool has_exact_map(const Workspace& work, const ShownMap& shown_map) {
    return map_state(work, shown_map) == MapState::exact &&
           shown_map.transition.shown->prediction.pm.size >= 2;
}

bool wants_comparison(const Layout& layout, const ShownMap& shown_map) {
    return layout.bench == BenchTab::compare || layout.bench == BenchTab::shepard ||
           shown_map.show_people;
}

// The map on screen, with its rows in the order of the people's own map.
std::vector<Eigen::Index> rated_rows(const RatedPeople& said, Eigen::Index patterns) {
    if (said.rated.part) return {said.rated.rated.begin(), said.rated.rated.end()};
    std::vector<Eigen::Index> rows(static_cast<std::size_t>(patterns));
    std::iota(rows.begin(), rows.end(), Eigen::Index{0});
    return rows;
}

std::optional<std::vector<Finding>> find(int /*number*/, std::stop_token stop,
                                         std::atomic<float>& progress) {
    CheckOptions options;
    options.stop = stop;
    int set = 0;
    options.progress_of = [&progress, &set](const std::string&) {
        const float before = static_cast<float>(set++) / 3.0F;
        return [&progress, before](double share) {
            progress = before + static_cast<float>(share) / 3.0F;
        };
    };
    return check_findings(options);
}

void follow_comparison(const Ui& ui, const Workspace& work, const Layout& layout,
                       const ShownMap& shown_map, Comparing& comparing) {
    const bool again =
        !comparison_waits(work, comparing) && (comparing.panel.of != shown_map.transition.shown ||
                                               comparing.panel.of_foreign != comparing.foreign);
    if (!wants_comparison(layout, shown_map) || !has_exact_map(work, shown_map) || !again) return;
    comparing.panel.of = shown_map.transition.shown;
    comparing.panel.of_foreign = comparing.foreign;
    comparing.comparison_job.ask({shown_map.transition.shown, comparing.foreign}, ComparisonWork{},
                                 ui.wake);
}

void follow_difference(const Ui& ui, const Workspace& work, const Layout& layout,
                       const ShownMap& shown_map, Comparing& comparing) {
    const std::optional<ChosenPair> pair = chosen_pair(work, shown_map);
    if (layout.bench != BenchTab::why || !pair || !has_exact_map(work, shown_map)) return;
    const auto rows = rows_in_map(work, shown_map, *pair);
    if (!rows) return;
    comparing.difference_job.want(
        DifferenceRequest{shown_map.transition.shown, rows->first, rows->second},
        compute_live_difference, ui.wake, JobPolicy::finish);
}

}  // namespace

void take_compare_answers(Comparing& comparing) {
    if (auto answer = comparing.comparison_job.latest()) comparing.comparison = std::move(answer);
    if (auto answer = comparing.difference_job.latest()) comparing.difference = std::move(answer);
    if (auto answer = comparing.findings_job.latest()) comparing.findings = std::move(answer);
}

void follow_comparing(const Ui& ui, const Workspace& work, const Layout& layout,
                      const ShownMap& shown_map, Comparing& comparing) {
    if (!has_jobs(ui)) return;
    follow_comparison(ui, work, layout, shown_map, comparing);
    follow_difference(ui, work, layout, shown_map, comparing);
}

void ask_for_findings(const Ui& ui, Comparing& comparing) {
    comparing.findings_job.ask(0, find, ui.wake, JobPolicy::finish);
}

ShownComparison shown_comparison(const Workspace& work, const ShownMap& shown_map,
                                 const Comparing& comparing) {
    ShownComparison shown{comparing.comparison, false, false};
    shown.is_computing = comparing.comparison_job.busy();
    shown.is_stale = !comparing.comparison ||
                     comparing.comparison->request.map != shown_map.transition.shown ||
                     comparing.comparison->request.foreign != comparing.foreign ||
                     map_state(work, shown_map) != MapState::exact;
    return shown;
}

bool comparison_waits(const Workspace& work, const Comparing& comparing) {
    const ComparePanelState& state = comparing.panel;
    if (state.cancelled && state.cancelled_at == work.revision) return true;
    return work.document.set.vibrations.size() > kMostUnaskedComparison &&
           state.compute_large_of != work.document_number;
}

void ask_for_comparison(const Workspace& work, Comparing& comparing) {
    comparing.panel.cancelled = false;
    comparing.panel.compute_large_of = work.document_number;
    comparing.panel.of.reset();
}

void cancel_comparison(const Workspace& work, Comparing& comparing) {
    comparing.panel.cancelled = true;
    comparing.panel.cancelled_at = work.revision;
    comparing.panel.compute_large_of = 0;
    comparing.comparison_job.cancel();
}

void add_metric_dialog(Ui& ui, const Workspace& work, Comparing& comparing) {
    ask_for_file(
        ui,
        {.title = "Add a metric of your own: a matrix, or a function in Python",
         .extensions = {".csv", ".txt", ".tsv", ".py"},
         .take = [&](const std::filesystem::path& file) { add_metric(ui, comparing, file); }},
        work.document.path.parent_path());
}

namespace {

void take_metric(Ui& ui, Comparing& comparing, const std::string& from) {
    const ForeignMetric added = foreign_metric(from);
    std::erase_if(comparing.foreign,
                  [&](const ForeignMetric& known) { return known.key == added.key; });
    comparing.foreign.push_back(added);
    comparing.panel.metric = added.key;
    comparing.panel.shepard_of_people = false;
    say(ui, "Added " + added.key + " to the comparison.");
}

}  // namespace

void add_metric(Ui& ui, Comparing& comparing, const std::filesystem::path& file) {
    if (file.extension() != ".py") return take_metric(ui, comparing, file.string());
    constexpr std::size_t kMostAsked = 6;
    std::vector<std::string> names = functions_in(file);
    const std::string of = file.filename().string();
    if (names.empty()) {
        return complain(ui, of + ": expected a function of two arrays and a rate, such as "
                                 "def apart(a, b, rate_hz)");
    }
    const auto from = [path = file.string()](const std::string& name) { return path + ":" + name; };
    if (names.size() == 1) return take_metric(ui, comparing, from(names.front()));
    names.resize(std::min(names.size(), kMostAsked));
    Question question{"Add a metric", "Which function of " + of + " is the metric?", {}};
    for (const std::string& name : names) {
        question.answers.push_back(
            {name, [&ui, &comparing, from, name] { take_metric(ui, comparing, from(name)); }});
    }
    question.answers.push_back({"None"});
    ask(ui, std::move(question));
}

void remove_metric(Comparing& comparing, const std::string& key) {
    std::erase_if(comparing.foreign, [&](const ForeignMetric& one) { return one.key == key; });
    if (comparing.panel.metric == key) comparing.panel.metric = "pm";
}

std::optional<Eigen::MatrixXd> people_over_map(const ShownMap& shown_map,
                                               const Comparing& comparing) {
    if (!comparing.comparison || comparing.comparison->request.map != shown_map.transition.shown)
        return std::nullopt;
    if (!comparing.comparison->people) return std::nullopt;
    const ComparedPeople& said = *comparing.comparison->people;
    const Eigen::MatrixXd& people = said.shown.points;
    const Eigen::MatrixXd& map = shown_map.transition.to;
    const std::vector<Eigen::Index> rows = rated_rows(said.said, map.rows());
    const bool is_of_these = !rows.empty() && rows.back() < map.rows();
    if (!is_of_these || people.rows() != static_cast<Eigen::Index>(rows.size()) ||
        people.cols() != map.cols()) {
        return std::nullopt;
    }
    Eigen::MatrixXd over =
        Eigen::MatrixXd::Constant(map.rows(), map.cols(), std::numeric_limits<double>::quiet_NaN());
    over(rows, Eigen::all) = procrustes(people, map(rows, Eigen::all)).aligned;
    return over;
}

std::string people_over_map_text(const Comparing& comparing) {
    if (!comparing.comparison || !comparing.comparison->people) return {};
    const RatedPeople& said = comparing.comparison->people->said;
    return "rings: " + people_text(*comparing.comparison->request.map->request.set, said);
}

}  // namespace tact
