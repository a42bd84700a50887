// How long a person waits for a map: the first of a file of one or two thousand patterns of .05 to
// 3 s and where its time goes, the exact one after an edit, that of a library of short and long
// patterns.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/map/map.h"
#include "model/common/parallel.h"
#include "model/dtw/dtw_kernel.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "tests/bench/owed.h"
#include "tests/support/mixed_set.h"

using namespace tact;
using namespace tact::bench;

namespace {

constexpr std::size_t kPatterns = 1000;
constexpr std::size_t kMostPatterns = 2000;  // that have a preview

// A library with a recording among its effects: all are compared over the length of the longest.
PatternSet with_a_clip_of_a_minute(PatternSet set) {
    Vibration& clip = set.vibrations.back();
    clip.source = with_duration(std::get<Pattern>(clip.source), 60.0);
    return set;
}

// From the file on. By what all threads have computed, shared among the processors there are, or by
// what the first has, which computes some of it alone: that long it takes where nothing else runs.
void first_map(benchmark::State& state, const PatternSet& set) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("tactspace_first_map_" + std::to_string(getpid()) + ".tactspace.json");
    if (!write_set_file(file, set)) return state.SkipWithError("no file");
    std::vector<double> waited_s;
    std::vector<double> computed_s;
    std::vector<double> first_s;
    for (auto _ : state) {
        std::atomic<float> progress{0.0F};
        const double begin_s = clock_s();
        const double computed_before_s = process_s();
        const double first_before_s = thread_s();
        LiveMapRequest request;
        request.set = std::make_shared<const PatternSet>(read_set_file(file)->set);
        request.preview = true;
        state.counters["opened_s"] = process_s() - computed_before_s;
        const auto map = LiveMapWork()(request, {}, progress);
        if (!map) state.SkipWithError("no map");
        computed_s.push_back(process_s() - computed_before_s);
        first_s.push_back(thread_s() - first_before_s);
        waited_s.push_back(clock_s() - begin_s);
    }
    std::filesystem::remove(file);
    const double all_s = quantile(computed_s, 0.0);
    state.counters["computed_s"] = all_s;
    state.counters["waited_s"] = quantile(waited_s, 0.0);
    owe_at_most(state, std::max(quantile(first_s, 0.0), all_s / thread_count(0)), 5.0, "s");
}

LiveMapRequest twelve(double amplitude_g) {
    PatternSet set = read_set_file(TACT_ASSETS_DIR "/sets/pm_2023_twelve.tactspace.json")->set;
    std::get<Pattern>(set.vibrations[3].source).amplitude_g = amplitude_g;
    LiveMapRequest request;
    request.set = std::make_shared<const PatternSet>(std::move(set));
    return request;
}

// From a slider's move to the exact map of the twelve, the window's frames left out: at its best,
// by the clock and by what all threads have computed.
void slider_to_exact(benchmark::State& state) {
    LiveMapWork work;
    std::atomic<float> progress{0.0F};
    work(twelve(1.0), {}, progress);
    double amplitude_g = 1.0;
    std::vector<double> waited_s;
    std::vector<double> to_pm_s;
    std::vector<double> computed_s;
    for (auto _ : state) {
        const LiveMapRequest request = twelve(amplitude_g += 0.01);
        const double begin_s = clock_s();
        const double computed_before_s = process_s();
        work.in_parts(request, {}, progress,
                      [&](const LiveMap&) { to_pm_s.push_back(clock_s() - begin_s); });
        computed_s.push_back(process_s() - computed_before_s);
        waited_s.push_back(clock_s() - begin_s);
    }
    state.counters["waited_ms"] = 1e3 * quantile(waited_s, 0.0);
    state.counters["to_exact_pm_ms"] = 1e3 * quantile(to_pm_s, 0.0);
    state.counters["all_threads_ms"] = 1e3 * quantile(computed_s, 0.0);
    const bool is_wide = std::string_view(dtw_kernel().name) == "avx512";
    const double two_cores_s = 0.5 * quantile(computed_s, 0.0);
    owe_at_most(state, 1e3 * two_cores_s, is_wide ? 75.0 : 110.0, "ms of two cores");
}

// Lengths of .02 to 3.2 s, as 151 published presets have them.
std::vector<Waveform> preset_waveforms() {
    constexpr std::size_t kPresets = 151;
    PatternSet set = mixed_set(kPresets);
    for (std::size_t k = 0; k < kPresets; ++k) {
        const double share = static_cast<double>(k) / (kPresets - 1);
        Pattern& pattern = std::get<Pattern>(set.vibrations[k].source);
        pattern = with_duration(pattern, std::round(1e3 * 0.02 * std::pow(160.0, share)) / 1e3);
    }
    return model_waveforms(set);
}

std::vector<Waveform> waveforms_of_1_s(std::size_t patterns) {
    PatternSet set = mixed_set(patterns);
    for (Vibration& one : set.vibrations) {
        one.source = with_duration(std::get<Pattern>(one.source), 1.0);
    }
    return model_waveforms(set);
}

// Both by what all threads have computed.
void presets(benchmark::State& state) {
    const auto library = preset_waveforms();
    const auto few = waveforms_of_1_s(24);
    for (auto _ : state) {
        const double begin_s = process_s();
        benchmark::DoNotOptimize(predict(few, {}));
        const double few_s = process_s() - begin_s;
        benchmark::DoNotOptimize(predict(library, {}));
        const double library_s = process_s() - begin_s - few_s;
        state.counters["presets_s"] = library_s;
        owe_at_most(state, library_s / few_s, 25.0, "x 24 patterns of 1 s");
    }
}

// One thread; a tenth of the patterns.
void coding(benchmark::State& state) {
    const PatternSet set = mixed_set(kPatterns / 10);
    PredictOptions options;
    options.threads = 1;
    Best rendering;
    Best codes;
    std::vector<Waveform> waveforms;
    for (auto _ : state) {
        rendering.turn([&] { waveforms = model_waveforms(set); });
        codes.turn([&] { benchmark::DoNotOptimize(pattern_codes(waveforms, set.model, options)); });
    }
    const auto each = static_cast<double>(set.vibrations.size());
    state.counters["rendering_ms"] = 1e3 * rendering.shortest_s / each;
    double own_s = 0.0;
    for (const Vibration& vibration : set.vibrations) own_s += own_duration_s(vibration);
    state.counters["per_own_s"] = 1e3 * codes.shortest_s / own_s;
    owe_at_most(state, 1e3 * codes.shortest_s / each, 2.0, "ms a pattern");
}

}  // namespace

BENCHMARK_CAPTURE(first_map, thousand, mixed_set(kPatterns))
    ->Name("first_map/1000_patterns")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(first_map, with_a_clip, with_a_clip_of_a_minute(mixed_set(kPatterns)))
    ->Name("first_map/1000_patterns_with_a_clip_of_a_minute")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(first_map, two_thousand, mixed_set(kMostPatterns))
    ->Name("first_map/2000_patterns")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK_CAPTURE(first_map, two_thousand_with_a_clip,
                  with_a_clip_of_a_minute(mixed_set(kMostPatterns)))
    ->Name("first_map/2000_patterns_with_a_clip_of_a_minute")
    ->Iterations(1)
    ->Unit(benchmark::kSecond);
BENCHMARK(slider_to_exact)->Name("first_map/slider_to_exact")->Iterations(15);
BENCHMARK(presets)->Name("first_map/151_presets")->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(coding)->Name("first_map/coding/one_core")->Iterations(3);
