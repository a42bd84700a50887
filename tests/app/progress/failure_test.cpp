// Work that fails in the background: each pane that waits for it says why, and asks again when
// something changes.
// GCC 12 takes a part of std::stop_source for one that is not set where a job is inlined whole.
#ifndef __clang__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include "app/progress/progress.h"

#include <stdexcept>

#include "app/calibrate/calibrate.h"
#include "app/generate/generate.h"
#include "app/study/study.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"
#ifndef __clang__
#pragma GCC diagnostic pop
#endif

namespace failure_test {

using namespace tact;

namespace {

constexpr const char* kSaid = "the work failed: the lights went out";

// In place of a job: one that fails whatever it is asked.
template <class Request, class Answer>
void fail(Query<Request, Answer>& job) {
    job = Query<Request, Answer>();
    job.ask(Request{},
            [](const Request&, std::stop_token, std::atomic<float>&) -> std::optional<Answer> {
                throw std::runtime_error("the lights went out");
            });
    while (job.busy()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

struct Failing : Program {
    Failing() : Program(short_patterns(4)) {}

    // What is asked again meanwhile fails again.
    bool says(const std::string& pane) {
        const auto until = end_of_patience();
        const std::string name = "failed:" + pane;
        do {
            frame();
            if (shows(name)) return at(name).value == kSaid;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        } while (std::chrono::steady_clock::now() < until);
        return false;
    }
};

}  // namespace

TEST_CASE("failure: without its map the space, the matrix and the Shepard diagram say why") {
    Failing program;
    App& app = program.app;
    begin_jobs(app);
    CHECK_FALSE(program.shows("failed:space"));
    fail(app.shown_map.full_job);
    CHECK(program.says("space"));
    app.layout.bench = BenchTab::matrix;
    CHECK(program.says("matrix"));
    app.layout.bench = BenchTab::shepard;
    CHECK(program.says("shepard"));
}

TEST_CASE("failure: it goes with the first answer") {
    Failing program;
    App& app = program.app;
    program.compute_map();
    fail(app.shown_map.full_job);
    CHECK(program.says("space"));
    app.shown_map.full_job = Query<LiveMapRequest, LiveMap>();
    std::get<Pattern>(app.work.document.edit().vibrations[0].source).amplitude_g *= 0.5;
    document_changed(app.work);
    program.wait_for_exact_map();
    program.settle();
    CHECK_FALSE(program.shows("failed:space"));
}

TEST_CASE("failure: a job that failed is asked again with the next change") {
    std::atomic<int> asked = 0;
    Failing program;
    App& app = program.app;
    begin_jobs(app);
    app.shown_map.full_job.begin([&asked](const LiveMapRequest&, std::stop_token,
                                          std::atomic<float>&) -> std::optional<LiveMap> {
        ++asked;
        throw std::runtime_error("the lights went out");
    });
    for (int k = 1; k <= 2; ++k) {
        document_changed(app.work);
        while (asked < k || app.shown_map.full_job.busy()) program.frame();
        CHECK(program.says("space"));
    }
}

TEST_CASE("failure: of stages, comparison, difference and findings each pane says it") {
    Failing program;
    App& app = program.app;
    program.compute_map();
    app.physiology.stages.reset();
    fail(app.physiology.stages_job);
    CHECK(program.says("physiology"));
    app.layout.bench = BenchTab::compare;
    fail(app.comparing.comparison_job);
    app.comparing.panel.of = app.shown_map.transition.shown;  // it was asked for
    CHECK(program.says("compare"));
    app.comparing.panel.view = CompareView::findings;
    fail(app.comparing.findings_job);
    CHECK(program.says("findings"));
    app.layout.bench = BenchTab::why;
    fail(app.comparing.difference_job);
    CHECK(program.says("why"));
    app.layout.bench = BenchTab::device;
    fail(app.rendered.job);
    CHECK(program.says("device"));
}

TEST_CASE("failure: of picking, its curve, separation, stability and training each pane says it") {
    Failing program;
    App& app = program.app;
    program.compute_map();
    app.layout.bench = BenchTab::subset;
    program.settle();
    fail(app.picking.pick_job);
    fail(app.picking.curve_job);
    CHECK(program.says("subset"));
    CHECK(program.says("curve"));
    app.picking.view = SubsetView::stability;
    fail(app.picking.stability_job);
    CHECK(program.says("stability"));
    app.picking.view = SubsetView::confusable;
    app.picking.opened = {"p1", "p2"};
    fail(app.picking.separation_job);
    CHECK(program.says("separation"));
    app.layout.bench = BenchTab::model;
    app.model_bench.panel.view = ModelView::training;
    fail(app.model_bench.training.job);
    CHECK(program.says("training"));
}

TEST_CASE("failure: dialogs and the study's panes say it, too") {
    Failing program;
    App& app = program.app;
    open_generate(app.ui, app.work, app.generating);
    program.settle();
    fail(app.generating.job);
    CHECK(program.says("generate"));
    app.ui.dialog = kCalibrateDialog;
    app.calibrating.recording = "heard.wav";
    fail(app.calibrating.job);
    CHECK(program.says("calibrate"));
    app.ui.dialog = kImportDialog;
    app.importing.files = {"p1.csv"};
    app.importing.patterns = {"p1"};
    fail(app.importing.import_job);
    CHECK(program.says("import"));
    app.ui.dialog = kSimulationDialog;
    fail(app.importing.simulation_job);
    CHECK(program.says("simulation"));
    app.ui.dialog = kNoDialog;
    open_study(app.layout, app.studying);
    program.settle();
    fail(app.studying.job);
    CHECK(program.says("study"));
    CHECK(program.says("study answers"));
}

}  // namespace failure_test
