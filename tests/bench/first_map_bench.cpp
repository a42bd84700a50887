// From a set of a thousand patterns of .05 to 3 s to its first map, and where the time goes.
#include <atomic>
#include <memory>

#include "app/map/live_map.h"
#include "model/common/parallel.h"
#include "model/perceptual_model/perceptual_model.h"
#include "tests/bench/owed.h"
#include "tests/support/mixed_set.h"

using namespace tact;
using namespace tact::bench;

namespace {

constexpr std::size_t kPatterns = 1000;

// By what all threads have computed, shared among the processors there are.
void first_map(benchmark::State& state) {
    const auto set = std::make_shared<const PatternSet>(mixed_set(kPatterns));
    LiveMapRequest request;
    request.set = set;
    request.preview = true;
    std::vector<double> waited_s;
    std::vector<double> computed_s;
    for (auto _ : state) {
        std::atomic<float> progress{0.0F};
        const double begin_s = clock_s();
        const double computed_before_s = process_s();
        const auto map = LiveMapWork()(request, {}, progress);
        if (!map) state.SkipWithError("no map");
        computed_s.push_back(process_s() - computed_before_s);
        waited_s.push_back(clock_s() - begin_s);
    }
    state.counters["computed_s"] = quantile(computed_s, 0.0);
    state.counters["waited_s"] = quantile(waited_s, 0.0);
    owe_at_most(state, quantile(computed_s, 0.0) / thread_count(0), 5.0, "s");
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

BENCHMARK(first_map)->Name("first_map/1000_patterns")->Iterations(1)->Unit(benchmark::kSecond);
BENCHMARK(coding)->Name("first_map/coding/one_core")->Iterations(3);
