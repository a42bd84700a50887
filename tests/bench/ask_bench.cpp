// Asking the map, headless: frames while it is searched, and how soon an answer is there.
#define DOCTEST_CONFIG_DISABLE
#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "app/ask/ask.h"
#include "model/io/set/set_file.h"
#include "tests/bench/owed.h"
#include "tests/support/program.h"

using namespace tact;
using namespace tact::bench;

namespace {

// The twelve of the paper, and two that lie between some of them.
PatternSet fourteen() {
    const auto loaded = read_set_file(TACT_ASSETS_DIR "/sets/pm_2023_twelve.tactspace.json");
    PatternSet set = loaded ? loaded->set : PatternSet{};
    for (const double hz : {90.0, 130.0}) {
        Vibration vibration = set.vibrations.front();
        vibration.name = "between " + std::to_string(static_cast<int>(hz));
        if (auto* pattern = std::get_if<Pattern>(&vibration.source)) {
            pattern->carriers[0].frequency_hz = hz;
        }
        set.vibrations.push_back(vibration);
    }
    return set;
}

struct MappedFourteen : Program {
    MappedFourteen() : Program(fourteen()) {
        app.ui.motion = false;
        compute_map();
        settle();
    }
};

// What the frame itself computes, by the clock of its thread, and what a person waits.
struct FrameTimes {
    std::vector<double> computed_s;
    std::vector<double> waited_s;

    void add(Program& program) {
        const double begin_s = clock_s();
        const double computed_before_s = thread_s();
        program.frame();
        computed_s.push_back(thread_s() - computed_before_s);
        waited_s.push_back(clock_s() - begin_s);
    }
};

// A point is put to the other end of the map again and again; frames of rest are drawn in between,
// in the same run.
void frame_while_putting(benchmark::State& state) {
    MappedFourteen program;
    FrameTimes rest;
    for (int k = 0; k < 200; ++k) rest.add(program);
    const Eigen::MatrixXd& points = program.app.shown_map.transition.to;
    FrameTimes searching;
    for (auto _ : state) {
        if (!program.app.proposals.put.job.asked()) {
            const PointMove move{0, points.row(points.rows() / 2), true};
            move_point(program.app.ui, program.app.work, program.app.shown_map,
                       program.app.proposals, move);
        }
        searching.add(program);
        std::this_thread::sleep_for(std::chrono::milliseconds(8));
    }
    state.counters["rest_ms"] = 1e3 * quantile(rest.computed_s, 0.5);
    state.counters["p99_waited_ms"] = 1e3 * quantile(searching.waited_s, 0.99);
    owe_at_most(state, quantile(searching.computed_s, 0.5) / quantile(rest.computed_s, 0.5), 2.0,
                "x a frame of rest (median)");
}

// From the frame in which the mouse rests on a slider to the one that shows its track; frames
// meanwhile are held against those of rest.
void track_appears(benchmark::State& state) {
    MappedFourteen program;
    FrameTimes rest;
    for (int k = 0; k < 100; ++k) rest.add(program);
    FrameTimes sampling;
    std::vector<double> appears_s;
    const ImVec2 modulation = program.at("slider:modulation_hz").middle();
    const ImVec2 amplitude = program.at("slider:amplitude_g").middle();
    bool on_modulation = false;
    for (auto _ : state) {
        on_modulation = !on_modulation;
        program.window.move({2.0F, 2.0F});
        program.app.proposals.rested.reset();
        program.settle();
        program.window.move(on_modulation ? modulation : amplitude);
        const double begin_s = clock_s();
        while (shown_proposals(program.app.shown_map, program.app.proposals).track.rows() == 0) {
            sampling.add(program);
            std::this_thread::sleep_for(std::chrono::milliseconds(4));
            if (clock_s() - begin_s > 20.0) return state.SkipWithError("no track");
        }
        appears_s.push_back(clock_s() - begin_s);
    }
    state.counters["frame_of_rest"] =
        quantile(sampling.computed_s, 0.5) / quantile(rest.computed_s, 0.5);
    state.counters["slowest_ms"] = 1e3 * quantile(appears_s, 1.0);
    owe_at_most(state, 1e3 * quantile(appears_s, 0.5), 300.0, "ms (median)");
}

}  // namespace

BENCHMARK(frame_while_putting)->Name("interface/frame_while_putting")->Iterations(300);
BENCHMARK(track_appears)->Name("interface/track_appears")->Iterations(12);
