#include "app/compare/bench_follow.h"

#include <algorithm>

#include "app/compare/check_findings.h"
#include "app/document/editing.h"
#include "app/map/map_follow.h"
#include "model/map/procrustes.h"
#include "model/set/set_ratings.h"

namespace tact {

namespace {

bool has_exact_map(const App& app) {
    return map_state(app) == MapState::exact && app.map.shown->prediction.pm.size >= 2;
}

bool wants_comparison(const App& app) {
    return app.bench == BenchTab::compare || app.bench == BenchTab::shepard || app.show_people;
}

std::optional<std::vector<Finding>> find(std::stop_token stop, std::atomic<float>& progress) {
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

void follow_comparison(App& app) {
    const bool again = !comparison_waits(app) && app.compare.of != app.map.shown;
    if (!wants_comparison(app) || !has_exact_map(app) || !again) return;
    app.compare.of = app.map.shown;
    app.comparison_job->submit({app.map.shown});
}

void follow_difference(App& app) {
    const std::optional<ChosenPair> pair = chosen_pair(app);
    if (app.bench != BenchTab::why || !pair || !has_exact_map(app)) return;
    const auto rows = rows_in_map(app, *pair);
    if (!rows) return;
    const DifferenceRequest request{app.map.shown, rows->first, rows->second};
    if (request == app.difference_asked) return;
    app.difference_asked = request;
    app.difference_job->submit(request);
}

}  // namespace

void make_bench_jobs(App& app) {
    app.comparison_job = std::make_unique<LatestJob<ComparisonRequest, Comparison>>(
        JobPolicy::supersede, ComparisonWork{}, app.wake);
    app.difference_job = std::make_unique<LatestJob<DifferenceRequest, LiveDifference>>(
        JobPolicy::finish, compute_live_difference, app.wake);
    app.rendering.job = std::make_unique<LatestJob<RenderingRequest, LiveRendering>>(
        JobPolicy::finish, compute_live_rendering, app.wake);
    app.findings_job = std::make_unique<LatestJob<int, std::vector<Finding>>>(
        JobPolicy::finish,
        [](int, std::stop_token stop, std::atomic<float>& progress) {
            return find(stop, progress);
        },
        app.wake);
}

void take_bench_answers(App& app) {
    if (!app.comparison_job) return;
    if (auto answer = app.comparison_job->latest()) app.comparison = std::move(answer);
    if (auto answer = app.difference_job->latest()) app.difference = std::move(answer);
    if (auto answer = app.findings_job->latest()) app.findings = std::move(answer);
    if (auto answer = app.rendering.job->latest()) app.rendering.shown = std::move(answer);
}

void follow_bench(App& app) {
    if (!app.comparison_job) return;
    follow_comparison(app);
    follow_difference(app);
    if (app.bench == BenchTab::device) follow_rendering(app.rendering, current_vibration(app));
}

ShownComparison shown_comparison(const App& app) {
    ShownComparison shown{app.comparison, false, false};
    shown.is_computing = app.comparison_job && app.comparison_job->busy();
    shown.is_stale = !app.comparison || app.comparison->request.map != app.map.shown ||
                     map_state(app) != MapState::exact;
    return shown;
}

bool comparison_waits(const App& app) {
    const ComparePanelState& state = app.compare;
    if (state.cancelled && state.cancelled_at == app.revision) return true;
    return app.document.set.vibrations.size() > kMostUnaskedComparison &&
           state.compute_large_of != app.document_number;
}

void ask_for_comparison(App& app) {
    app.compare.cancelled = false;
    app.compare.compute_large_of = app.document_number;
    app.compare.of.reset();
}

void cancel_comparison(App& app) {
    app.compare.cancelled = true;
    app.compare.cancelled_at = app.revision;
    app.compare.compute_large_of = 0;
    if (app.comparison_job) app.comparison_job->cancel();
}

std::optional<Eigen::MatrixXd> people_over_map(const App& app) {
    if (!app.comparison || app.comparison->request.map != app.map.shown) return std::nullopt;
    if (!app.comparison->people) return std::nullopt;
    const Eigen::MatrixXd& people = app.comparison->people->shown.points;
    if (people.rows() != app.map.to.rows() || people.cols() != app.map.to.cols()) {
        return std::nullopt;
    }
    return procrustes(people, app.map.to).aligned;
}

}  // namespace tact
