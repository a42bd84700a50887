#include "app/compare/bench_follow.h"

#include <algorithm>

#include "app/compare/check_findings.h"
#include "app/document/editing.h"
#include "app/document/files.h"
#include "app/map/map_follow.h"
#include "app/measured/import_follow.h"
#include "app/ui/file_question.h"
#include "model/io/people/ratings_file.h"
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
    return app.document.set.vibrations.size() > kMostUnaskedComparison && !state.compute_large;
}

void ask_for_comparison(App& app) {
    app.compare.cancelled = false;
    app.compare.compute_large = true;
    app.compare.of.reset();
}

void cancel_comparison(App& app) {
    app.compare.cancelled = true;
    app.compare.cancelled_at = app.revision;
    app.compare.compute_large = false;
    if (app.comparison_job) app.comparison_job->cancel();
}

std::optional<ChosenPair> chosen_pair(const App& app) {
    const std::size_t count = app.document.set.vibrations.size();
    const std::size_t current = app.selection.current;
    if (count < 2 || current >= count) return std::nullopt;
    const auto partner = place_named(app.document.set, app.partner);
    if (partner && partner != current) return ChosenPair{current, *partner, PartnerKind::chosen};
    const auto pinned = place_named(app.document.set, app.pinned);
    if (pinned && pinned != current) return ChosenPair{current, *pinned, PartnerKind::pinned};
    ChosenPair pair{current, current == 0 ? 1U : 0U, PartnerKind::closest};
    if (!app.map.shown) return pair;
    const PatternSet& mapped = *app.map.shown->request.set;
    const Dissimilarity& pm = app.map.shown->prediction.pm;
    const auto row = place_named(mapped, app.document.set.vibrations[current].name);
    std::optional<std::size_t> closest;
    for (std::size_t k = 0; row && k < pm.size; ++k) {
        const bool closer = !closest || pm(*row, k) < pm(*row, *closest);
        if (k != *row && closer && place_named(app.document.set, mapped.vibrations[k].name)) {
            closest = k;
        }
    }
    if (closest) pair.partner = *place_named(app.document.set, mapped.vibrations[*closest].name);
    return pair;
}

std::optional<std::pair<std::size_t, std::size_t>> rows_in_map(const App& app,
                                                               const ChosenPair& pair) {
    const PatternSet& mapped = *app.map.shown->request.set;
    const auto& all = app.document.set.vibrations;
    const auto a = place_named(mapped, all[pair.current].name);
    const auto b = place_named(mapped, all[pair.partner].name);
    if (!a || !b) return std::nullopt;
    return std::pair{*a, *b};
}

void choose_pair(App& app, std::size_t current, std::size_t partner) {
    if (partner >= app.document.set.vibrations.size()) return;
    select_only(app, current);
    app.partner = app.document.set.vibrations[partner].name;
    app.set_panel.scroll_to_current = true;
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

void load_ratings_dialog(App& app) {
    ask_for_file(app,
                 {.purpose = ChooserPurpose::load_ratings,
                  .use = ChooserUse::open,
                  .title = "Load ratings: a table, or a folder with one for each participant",
                  .extensions = {".csv", ".txt"},
                  .folders_too = true},
                 app.document.path.parent_path());
}

void load_ratings(App& app, const std::vector<std::filesystem::path>& paths) {
    if (paths.empty()) return;
    const Expected<LoadedRatings> loaded = read_ratings(paths, RatingScale::guess);
    if (!loaded) return complain(app, loaded.error().message);
    const std::string file = paths.front().filename().string();
    Expected<RatingStudy> study = matched(loaded->study, names_of(app.document.set));
    if (!study) {  // people rate the intended patterns, not what measures them
        const PatternSet intended = one_side(app.document.set, Side::intended);
        auto of_intended = matched(loaded->study, names_of(intended));
        if (of_intended) study = std::move(of_intended);
    }
    if (!study) return complain(app, file + ": " + study.error().message);
    app.document.set.ratings = kept_ratings(*study, file);
    document_changed(app);
    commit_step(app, "Load ratings");
    app.bench = BenchTab::compare;
    std::string text = "Ratings loaded from " + file;
    for (const std::string& remark : loaded->remarks) text += "; " + remark;
    say(app, text + ".");
}

void drop_paths(App& app, const std::vector<std::filesystem::path>& paths) {
    const bool tables = !paths.empty() && std::ranges::all_of(paths, [](const auto& path) {
        return extension_of(path) == ".csv";
    });
    if (tables && !read_ratings(paths, RatingScale::guess) && are_accelerations(paths)) {
        return import_recordings(app, paths);
    }
    if (tables) return load_ratings(app, paths);
    open_paths(app, paths);
}

}  // namespace tact
