// The window of the twelve patterns of Lim & Park 2023, in its default layout.
//
// Headless, a frame is what the interface computes; on a display it is rasterised as well.
//
// Left out  idle: that no frame is drawn then is a test of the window's.
#define DOCTEST_CONFIG_DISABLE
#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

#include "app/map/map.h"
#include "app/screen/screen.h"
#include "app/subset/subset.h"
#include "app/workspaces/workspaces.h"
#include "model/common/random.h"
#include "model/io/set/set_file.h"
#include "tests/bench/owed.h"
#include "tests/support/program.h"

using namespace tact;
using namespace tact::bench;

namespace {

constexpr double kFrameS = 1.0 / 60.0;
constexpr double kLeastFrameS = 1.0 / 125.0;

PatternSet twelve() {
    const auto loaded = read_set_file(TACT_ASSETS_DIR "/sets/pm_2023_twelve.tactspace.json");
    return loaded ? loaded->set : PatternSet{};
}

void start_jobs(App& app) {
    begin_jobs(app);
    request_maps(app.ui, app.work, app.shown_map, app.rendered);
}

// The points set out again, and keep moving.
void move_points(App& app) { app.shown_map.transition.since_s = app.ui.time_s; }

void change_every_pattern(App& app, int turn) {
    for (Vibration& vibration : app.work.document.edit().vibrations) {
        if (auto* pattern = std::get_if<Pattern>(&vibration.source)) {
            pattern->modulation.frequency_hz = 1.0 + turn % 50;
        }
    }
    ++app.work.revision;
    request_maps(app.ui, app.work, app.shown_map, app.rendered);
}

// From now on a frame is what a person's is: where things are is noted for tests alone.
void note_no_places(Program& program) { program.app.ui.rects.file.clear(); }

double frame_s(Program& program) {
    const double begin_s = clock_s();
    program.frame();
    return clock_s() - begin_s;
}

double p99_of_median(const std::vector<double>& values) {
    return quantile(values, 0.99) / quantile(values, 0.5);
}

void frame(benchmark::State& state) {
    Program program(twelve());
    start_jobs(program.app);
    program.wait_for_exact_map();
    note_no_places(program);
    std::vector<double> frames_s;
    for (auto _ : state) {
        move_points(program.app);
        frames_s.push_back(frame_s(program));
    }
    state.counters["vertices"] = ImGui::GetDrawData()->TotalVtxCount;
    state.counters["p99_ms"] = 1e3 * quantile(frames_s, 0.99);
    owe_at_most(state, 1e3 * quantile(frames_s, 0.5), 3.0, "ms (median)");
}

void sleep_until_next(double begin_s) {
    const double left_s = kFrameS - (clock_s() - begin_s);
    if (left_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(left_s));
}

// Sixty frames a second, while the map of twelve changed patterns is made again and again. Counted
// is what the frame's thread computes: other programs take from the time on the clock, and what it
// would wait for a lock is told by how often it sleeps. The clock's is told beside that of frames
// without any computing.
void frame_while_computing(benchmark::State& state) {
    Program program(twelve());
    start_jobs(program.app);
    program.wait_for_exact_map();
    note_no_places(program);
    std::vector<double> idle_s;
    for (int k = 0; k < 200; ++k) {
        const double begin_s = clock_s();
        move_points(program.app);
        idle_s.push_back(frame_s(program));
        sleep_until_next(begin_s);
    }
    std::vector<double> frames_s;
    std::vector<double> computed_s;
    int turn = 0;
    long waits = 0;
    for (auto _ : state) {
        if (!is_computing(program.app)) change_every_pattern(program.app, ++turn);
        const double begin_s = clock_s();
        const double computed_before_s = thread_s();
        const long slept_before = slept();
        frames_s.push_back(frame_s(program));
        waits += slept() - slept_before;
        computed_s.push_back(thread_s() - computed_before_s);
        sleep_until_next(begin_s);
    }
    state.counters["median_ms"] = 1e3 * quantile(frames_s, 0.5);
    state.counters["p99_ms"] = 1e3 * quantile(frames_s, 0.99);
    state.counters["idle_p99_ms"] = 1e3 * quantile(idle_s, 0.99);
    state.counters["waits"] = static_cast<double>(waits);
    state.counters["runs"] = turn;
    owe_at_most(state, p99_of_median(computed_s), 2.0, "x median (p99, computed)");
}

// From the frame in which the button is let go to that which shows the new, exact map.
void slider_to_space(benchmark::State& state) {
    Program program(twelve());
    start_jobs(program.app);
    program.wait_for_exact_map();
    std::vector<double> preview_s;
    std::vector<double> exact_s;
    std::vector<double> computed_s;
    float x = 0.2F;
    for (auto _ : state) {
        const Place bar = program.at("slider:amplitude_g");
        x = x > 0.7F ? 0.2F : x + 0.1F;
        const ImVec2 to{bar.min.x + x * (bar.max.x - bar.min.x), bar.middle().y};
        program.drag({bar.min.x + 20.0F, to.y}, to, 6);
        const double begin_s = clock_s();
        const double computed_before_s = process_s();
        bool previewed = false;
        while (map_state(program.app.work, program.app.shown_map) != MapState::exact) {
            const double frame_begin_s = clock_s();
            program.frame();
            if (!previewed &&
                map_state(program.app.work, program.app.shown_map) != MapState::stale) {
                preview_s.push_back(clock_s() - begin_s);
                previewed = true;
            }
            // The window draws no more than 125 frames a second.
            const double left_s = kLeastFrameS - (clock_s() - frame_begin_s);
            if (left_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(left_s));
        }
        exact_s.push_back(clock_s() - begin_s);
        computed_s.push_back(process_s() - computed_before_s);
    }
    state.counters["all_threads_ms"] = 1e3 * quantile(computed_s, 0.5);
    state.counters["preview_ms"] = 1e3 * quantile(preview_s, 0.5);
    owe_at_most(state, 1e3 * quantile(exact_s, 0.5), 250.0, "ms (median)");
}

// One pattern of 60 s with all the points and transients that one may have.
PatternSet drawn_full() {
    PatternSet set;
    set.duration_s = 60.0;
    Pattern pattern;
    pattern.duration_s = 60.0;
    for (std::size_t k = 0; k < limits::kMaxCurvePoints; ++k) {
        const double t_s = 0.12 * static_cast<double>(k);
        pattern.amplitude_curve.push_back({t_s, k % 2 == 0 ? 1.0 : 0.5});
        pattern.frequency_curve.push_back({t_s, 80.0 + 20.0 * static_cast<double>(k % 7)});
        pattern.transients.push_back({t_s + 0.05, 1.0});
    }
    set.vibrations.push_back({});
    set.vibrations[0].name = "drawn";
    set.vibrations[0].source = pattern;
    return set;
}

// Drags the amplitude of a full strip. What is computed of it runs in the background.
void drag_in_full_strip(benchmark::State& state) {
    Program program(drawn_full());
    begin_jobs(program.app);
    Program small(short_patterns(1));
    program.window.move(program.at("grip:amplitude curve:250").middle());
    program.window.button(true);
    program.settle();
    const Place lane = program.at("strip:amplitude");
    note_no_places(program);
    note_no_places(small);
    std::vector<double> frames_s;
    std::vector<double> small_s;
    for (auto _ : state) {
        const float way = static_cast<float>(frames_s.size() % 40) - 20.0F;
        program.window.move(lane.middle() + ImVec2{0.0F, way});
        frames_s.push_back(frame_s(program));
        small_s.push_back(frame_s(small));
    }
    state.counters["p99_ms"] = 1e3 * quantile(frames_s, 0.99);
    state.counters["of_small"] = quantile(frames_s, 0.5) / quantile(small_s, 0.5);
    owe_at_most(state, 1e3 * quantile(frames_s, 0.5), 3.0, "ms (median)");
}

// One pattern of 60 s with 10,000 notes, in the arrangement for design.
PatternSet full_of_notes() {
    PatternSet set;
    set.duration_s = 60.0;
    Pattern pattern;
    pattern.duration_s = 60.0;
    for (std::size_t k = 0; k < 10'000; ++k) pattern.rhythm.text += k % 3 == 0 ? "5-" : "x-";
    pattern.rhythm.unit_s = 60.0 / static_cast<double>(pattern.rhythm.text.size());
    set.vibrations.push_back({});
    set.vibrations[0].name = "notes";
    set.vibrations[0].source = pattern;
    return set;
}

// While the strength of one of them is dragged by its top.
void drag_in_full_notes(benchmark::State& state) {
    Program program(full_of_notes());
    begin_jobs(program.app);
    program.resize({1600.0F, 1000.0F}, 1.0F);
    program.app.layout = first_layout(Arrangement::design);
    program.app.pattern_panes.strip.tool = StripTool::notes;
    program.settle();
    const Place note = program.at("note:5000");
    program.window.move({note.middle().x, note.min.y + 0.1F});
    program.window.button(true);
    program.settle();
    note_no_places(program);
    std::vector<double> frames_s;
    for (auto _ : state) {
        const float way = static_cast<float>(frames_s.size() % 40);
        program.window.move({note.middle().x, note.min.y + way});
        frames_s.push_back(frame_s(program));
    }
    state.counters["p99_ms"] = 1e3 * quantile(frames_s, 0.99);
    owe_at_most(state, 1e3 * quantile(frames_s, 0.5), 6.0, "ms (median)");
}

// One strong pattern of 2.5 s that drives at least 641 receptors.
PatternSet strong() {
    PatternSet set;
    set.name = "strong";
    set.duration_s = 2.5;
    Pattern pattern;
    pattern.duration_s = 2.5;
    pattern.amplitude_g = 4.0;
    pattern.carriers = {{30.0, 0.5, 0.0}, {210.0, 0.5, 0.0}};
    pattern.modulation.frequency_hz = 4.0;
    Vibration vibration;
    vibration.name = "strong";
    vibration.source = pattern;
    set.vibrations.push_back(vibration);
    return set;
}

constexpr std::size_t kManyPoints = 1000;

PatternSet thousand() {
    PatternSet set;
    set.name = "thousand";
    set.duration_s = 0.1;
    for (std::size_t k = 0; k < kManyPoints; ++k) {
        Pattern pattern;
        pattern.duration_s = 0.1;
        pattern.carriers[0].frequency_hz = 40.0 + 0.3 * static_cast<double>(k);
        pattern.modulation.frequency_hz = static_cast<double>(k % 50);
        Vibration vibration;
        vibration.name = "pattern " + std::to_string(k);
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    }
    return set;
}

// A map at random: what matters is that it is drawn, coloured, with a subset and links.
void show_made_up_map(App& app) {
    begin_jobs(app);
    RandomStream random{5};
    LiveMap map;
    map.request = {app.work.revision, app.work.document_number,
                   std::make_shared<const PatternSet>(app.work.document.set), 3, false};
    for (Dissimilarity* one : {&map.prediction.pm, &map.prediction.nc, &map.prediction.oc}) {
        one->size = kManyPoints;
        one->condensed.resize(pair_count(kManyPoints));
        for (double& value : one->condensed) value = 2.0 + next_even(random);
    }
    map.space.points.resize(kManyPoints, 3);
    for (double& value : map.space.points.reshaped()) value = next_normal(random);
    note_facts(map);
    show_map(app.ui, app.shown_map, std::make_shared<const LiveMap>(std::move(map)));
    app.layout.bench = BenchTab::subset;
    app.picking.view = SubsetView::confusable;
    app.picking.share = 0.0005;
    app.shown_map.look.colour = PatternParameter::carrier;
    app.shown_map.look.path = PatternParameter::modulation;
}

// In a real window, from the start of a frame until it is on the screen, while the playhead runs a
// hundred times slower than life and the points move.
void frame_on_display(benchmark::State& state, const PatternSet& set) {
    if (!display_available()) {
        for (auto _ : state) continue;
        state.SetLabel("not measured: no display");
        return;
    }
    App app = make_app();
    app.work.document.open({set, {}, set});
    app.timeline.playhead = {.at_s = 0.0, .speed = 0.01, .playing = true, .loop = true};
    if (set.vibrations.size() == kManyPoints) {
        show_made_up_map(app);
    } else {
        start_jobs(app);
    }
    std::vector<double> frames_s;
    std::vector<double> computed_s;
    std::size_t receptors = 0;
    double begin_s = 0.0;
    double computed_before_s = 0.0;
    WindowClient client;
    client.frame = [&](const FrameContext& context) {
        begin_s = clock_s();
        computed_before_s = process_s();
        app.ui.content_scale = context.content_scale;
        if (map_state(app.work, app.shown_map) == MapState::exact) move_points(app);
        draw_frame(app, context.pressed, context.time_s);
        FrameRequest request;
        request.animate = true;
        request.background = app.ui.theme.background;
        request.close = !state.KeepRunning();
        return request;
    };
    client.build_fonts = [&](float content_scale) {
        app.ui.content_scale = content_scale;
        make_theme(app);
    };
    client.after_frame = [&] {
        const bool ready =
            app.physiology.stages && app.physiology.stages == app.physiology.stages_job.current();
        if (!ready ||
            (set.vibrations.size() > 1 && map_state(app.work, app.shown_map) != MapState::exact))
            return;
        receptors = 0;
        for (const auto& channel : app.physiology.stages->neural.channel) {
            receptors += channel.grid.receptors.size();
        }
        frames_s.push_back(clock_s() - begin_s);
        computed_s.push_back(process_s() - computed_before_s);
    };
    const auto opened = run_window({}, client);
    if (!opened) state.SkipWithError("no window");
    state.counters["receptors"] = static_cast<double>(receptors);
    state.counters["p99_of_median"] = p99_of_median(frames_s);
    state.counters["frames"] = static_cast<double>(frames_s.size());
    state.counters["all_threads_ms"] = 1e3 * quantile(computed_s, 0.5);
    state.counters["p99_ms"] = 1e3 * quantile(frames_s, 0.99);
    owe_at_most(state, 1e3 * quantile(frames_s, 0.5), 33.0, "ms (median)");
}

}  // namespace

BENCHMARK(frame)->Name("interface/frame")->Iterations(300);
BENCHMARK(frame_while_computing)->Name("interface/frame_while_computing")->Iterations(600);
BENCHMARK(slider_to_space)->Name("interface/slider_to_space")->Iterations(7);
BENCHMARK(drag_in_full_strip)->Name("interface/drag_in_full_strip")->Iterations(200);
BENCHMARK(drag_in_full_notes)->Name("interface/drag_in_full_notes")->Iterations(200);
BENCHMARK_CAPTURE(frame_on_display, twelve, twelve())
    ->Name("interface/frame_on_display/twelve")
    ->Iterations(400);
BENCHMARK_CAPTURE(frame_on_display, strong, strong())
    ->Name("interface/frame_on_display/strong")
    ->Iterations(400);
BENCHMARK_CAPTURE(frame_on_display, thousand, thousand())
    ->Name("interface/frame_on_display/thousand")
    ->Iterations(200);
