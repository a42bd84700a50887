// The window of a library: 1,000 and 2,000 patterns of .05 to 3 s with their map, in every view.
//
// The map is the preview of the set: as dear to draw as an exact one. Headless, by the time that
// the frame's thread computes; on a display by all threads of the program, as llvmpipe draws with
// several.
#define DOCTEST_CONFIG_DISABLE
#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "app/document/editing.h"
#include "app/map/map.h"
#include "app/screen/screen.h"
#include "app/workspaces/workspaces.h"
#include "tests/bench/owed.h"
#include "tests/support/mixed_set.h"
#include "tests/support/program.h"

using namespace tact;
using namespace tact::bench;

namespace {

constexpr double kMostMs = 33.0;
constexpr double kMostMiB = 1024.0;

// The last one that was asked for; as memory is measured here, no other is kept.
std::shared_ptr<const LiveMap> map_of(const PatternSet& set) {
    static std::shared_ptr<const LiveMap> last;
    if (last && *last->request.set == set) return last;
    last.reset();
    LiveMapRequest request;
    request.set = std::make_shared<const PatternSet>(set);
    request.preview = true;
    std::atomic<float> progress{0.0F};
    last = std::make_shared<const LiveMap>(*LiveMapWork()(request, {}, progress));
    return last;
}

// As the exact map of the document, so that nothing else is computed.
void show_as_exact(App& app) {
    LiveMap map = *map_of(app.work.document.set);
    map.request.revision = app.work.revision;
    map.request.document = app.work.document_number;
    map.request.preview = false;
    app.shown_map.maps_asked = app.work.revision;
    app.shown_map.of_document = app.work.document_number;
    app.shown_map.compute_large_of = app.work.document_number;
    show_map(app.ui, app.shown_map, std::make_shared<const LiveMap>(std::move(map)));
}

// What is on screen, and what happens in each frame.
struct View {
    const char* name;
    Arrangement arrangement = Arrangement::design;
    BenchTab bench = BenchTab::matrix;
    std::optional<Pane> maximised{};
    std::function<void(App&)> begin{};
    std::function<void(App&)> step{};
};

void move_points(App& app) { app.shown_map.transition.since_s = app.ui.time_s; }

void show_view(App& app, const View& view) {
    app.layout = first_layout(view.arrangement);
    app.layout.bench = view.bench;
    if (view.maximised) app.layout.maximised = view.maximised;
    app.shown_map.look = {};
    app.picking.view = SubsetView::pick;
    app.work.selection.search.clear();
    select_only(app.work, 0);
    if (view.begin) view.begin(app);
}

std::vector<View> make_views() {
    constexpr Arrangement kSelect = Arrangement::select;
    std::vector<View> all{
        {.name = "design"},
        {.name = "design, points move", .step = move_points},
        {.name = "design, another pattern",
         .step = [](App& app) { select_only(app.work, (app.work.selection.current + 7) % 1000); }},
        {.name = "design, all selected", .begin = [](App& app) { select_all(app.work); }},
        {.name = "design, search", .begin = [](App& app) { app.work.selection.search = "1"; }},
        {.name = "map", .maximised = Pane::space},
        {.name = "map, groups",
         .maximised = Pane::space,
         .begin = [](App& app) { app.shown_map.look.clusters = 8; }},
        {.name = "map, lines",
         .maximised = Pane::space,
         .begin = [](App& app) { app.shown_map.look.path = PatternParameter::carrier; }},
        {.name = "matrix", .maximised = Pane::matrix},
        {.name = "patterns", .maximised = Pane::patterns},
        {.name = "editor", .maximised = Pane::editor},
        {.name = "too close",
         .arrangement = kSelect,
         .bench = BenchTab::subset,
         .begin =
             [](App& app) {
                 app.picking.view = SubsetView::confusable;
                 app.picking.too_close = TooClose::share;
             }},
        {.name = "physiology",
         .arrangement = Arrangement::physiology,
         .maximised = Pane::physiology}};
    for (const BenchRow& row : kBenchTabs) {
        // The matrix is maximised above.
        if (row.tab == BenchTab::matrix) continue;
        all.push_back({.name = row.key, .arrangement = kSelect, .bench = row.tab});
    }
    return all;
}

const std::vector<View>& views() {
    static const std::vector<View> all = make_views();
    return all;
}

// One window at a time: a view is shown after the other in it.
std::unique_ptr<Program>& open_window() {
    static std::unique_ptr<Program> one;
    return one;
}

void close_window() { open_window().reset(); }

Program& window_of(std::size_t patterns) {
    auto& one = open_window();
    if (one && one->app.work.document.set.vibrations.size() == patterns) return *one;
    close_window();
    one = std::make_unique<Program>(mixed_set(patterns));
    one->app.ui.rects.file.clear();  // a frame is what a person's is
    begin_jobs(one->app);
    show_as_exact(one->app);
    return *one;
}

bool is_busy(const App& app) { return next_wake_s(app) < 0.2; }

// The mouse moves over the panes.
void frame(benchmark::State& state, std::size_t patterns, const View& view) {
    Program& program = window_of(patterns);
    App& app = program.app;
    show_view(app, view);
    for (int k = 0; k < 20; ++k) program.frame();
    std::vector<double> frames_s;
    int turn = 0;
    for (auto _ : state) {
        ++turn;
        if (view.step) view.step(app);
        program.window.move({500.0F + 7.0F * static_cast<float>(turn % 100),
                             300.0F + 3.0F * static_cast<float>(turn % 50)});
        const double begin_s = thread_s();
        program.frame();
        frames_s.push_back(thread_s() - begin_s);
    }
    state.counters["vertices"] = ImGui::GetDrawData()->TotalVtxCount;
    state.counters["p99_ms"] = 1e3 * quantile(frames_s, 0.99);
    owe_at_most(state, 1e3 * quantile(frames_s, 0.5), kMostMs, "ms (median)");
}

// The frame that takes a new map, with its places turned onto those of the last one.
void frame_with_new_map(benchmark::State& state, std::size_t patterns, const View& view) {
    Program& program = window_of(patterns);
    App& app = program.app;
    show_view(app, view);
    for (int k = 0; k < 20; ++k) program.frame();
    std::vector<double> frames_s;
    for (auto _ : state) {
        auto next = std::make_shared<const LiveMap>(*app.shown_map.transition.shown);
        const double begin_s = thread_s();
        show_map(app.ui, app.shown_map, std::move(next));
        program.frame();
        frames_s.push_back(thread_s() - begin_s);
        for (int k = 0; k < 3; ++k) program.frame();
    }
    owe_at_most(state, 1e3 * quantile(frames_s, 0.5), kMostMs, "ms (median)");
}

// One pattern is edited again as soon as the map of the last edit is there. Counted is what the
// frame's thread computes (interface_bench.cpp).
void frame_while_computing(benchmark::State& state, std::size_t patterns, const View& view) {
    Program& program = window_of(patterns);
    App& app = program.app;
    show_view(app, view);
    app.shown_map.compute_large_of = 0;  // previews, as of any library
    for (int k = 0; k < 20; ++k) program.frame();
    std::vector<double> frames_s;
    int turn = 0;
    long waits = 0;
    for (auto _ : state) {
        if (!app.shown_map.preview_job.busy()) {
            Vibration& first = app.work.document.edit().vibrations.front();
            std::get<Pattern>(first.source).amplitude_g = 0.5 + 0.01 * (++turn % 50);
            ++app.work.revision;
        }
        const double begin_s = thread_s();
        const long slept_before = slept();
        program.frame();
        waits += slept() - slept_before;
        frames_s.push_back(thread_s() - begin_s);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    state.counters["median_ms"] = 1e3 * quantile(frames_s, 0.5);
    state.counters["most_ms"] = 1e3 * quantile(frames_s, 1.0);
    state.counters["waits"] = static_cast<double>(waits);
    state.counters["runs"] = turn;
    owe_at_most(state, quantile(frames_s, 0.99) / quantile(frames_s, 0.5), 2.0,
                "x median (p99, computed)");
}

double resident_mib() {
    malloc_trim(0);
    std::ifstream pages("/proc/self/statm");
    double whole = 0.0;
    double resident = 0.0;
    pages >> whole >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

// A real window, until the bench has its frames and nothing is computed any more.
void on_display(benchmark::State& state, std::size_t patterns, const View& view,
                const std::function<void(const std::vector<double>&)>& tell) {
    if (!display_available()) {
        for (auto _ : state) continue;
        state.SetLabel("not measured: no display");
        return;
    }
    close_window();  // the headless one, whose context would be gone afterwards
    App app = make_app();
    PatternSet set = mixed_set(patterns);
    give_looks(set);
    app.work.document.open({set, {}, set});
    begin_jobs(app);
    show_as_exact(app);
    show_view(app, view);
    std::vector<double> computed_s;
    double before_s = 0.0;
    int frames = 0;
    WindowClient client;
    client.frame = [&](const FrameContext& context) {
        before_s = process_s();
        app.ui.content_scale = context.content_scale;
        if (view.step) view.step(app);
        draw_frame(app, context.pressed, context.time_s);
        FrameRequest request;
        request.animate = true;
        request.background = app.ui.theme.background;
        const bool measures = ++frames > 20 && !is_busy(app);
        request.close = measures && !state.KeepRunning();
        return request;
    };
    client.build_fonts = [&](float content_scale) {
        app.ui.content_scale = content_scale;
        make_theme(app);
    };
    client.after_frame = [&] {
        if (frames > 20 && !is_busy(app)) computed_s.push_back(process_s() - before_s);
        if (frames > 20) tell(computed_s);
    };
    if (!run_window({}, client)) state.SkipWithError("no window");
}

void frame_on_display(benchmark::State& state, std::size_t patterns, const View& view) {
    std::vector<double> frames_s;
    on_display(state, patterns, view, [&](const auto& computed_s) { frames_s = computed_s; });
    if (frames_s.empty()) return;
    state.counters["p99_ms"] = 1e3 * quantile(frames_s, 0.99);
    owe_at_most(state, 1e3 * quantile(frames_s, 0.5), kMostMs, "ms of all threads (median)");
}

// With what a benchmark has besides, such as the map it shows.
void memory_of_window(benchmark::State& state, std::size_t patterns) {
    double most_mib = 0.0;
    on_display(state, patterns, views().front(), [&](const auto& computed_s) {
        if (computed_s.size() % 10 == 1) most_mib = std::max(most_mib, resident_mib());
    });
    if (most_mib > 0.0) owe_at_most(state, most_mib, kMostMiB, "MiB resident");
}

template <class Measure>
void add(const std::string& what, Measure measure, int frames) {
    benchmark::RegisterBenchmark(what.c_str(), measure)->Iterations(frames);
}

[[maybe_unused]] const bool kAdded = [] {
    for (const std::size_t patterns : {1000U, 2000U}) {
        const std::string begin = "library/" + std::to_string(patterns) + "/";
        for (const View& view : views()) {
            add(
                begin + "frame/" + view.name,
                [=](benchmark::State& state) { frame(state, patterns, view); }, 60);
        }
        for (const View& view : views()) {
            if (view.step || view.begin) continue;
            add(
                begin + "new map/" + view.name,
                [=](benchmark::State& state) { frame_with_new_map(state, patterns, view); }, 10);
        }
        for (const View& view : views()) {
            if (view.step && std::string_view(view.name) != "design, points move") continue;
            add(
                begin + "display/" + view.name,
                [=](benchmark::State& state) { frame_on_display(state, patterns, view); }, 40);
        }
        add(
            begin + "while computing",
            [=](benchmark::State& state) {
                frame_while_computing(state, patterns, views().front());
            },
            1000);
        add(
            begin + "memory", [=](benchmark::State& state) { memory_of_window(state, patterns); },
            40);
    }
    return true;
}();

}  // namespace
