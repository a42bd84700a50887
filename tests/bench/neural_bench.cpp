// Neural coding of 1 s patterns, and the NC matrix of a thousand of them.
#include <cmath>
#include <memory>

#include "model/pattern/pattern.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/physiology/nc_matrix.h"
#include "tests/bench/owed.h"

using namespace tact;
using namespace tact::bench;

namespace {

// The paper's eight: 1 g, 150 Hz, modulated slowly to fast.
std::vector<Waveform> modulated_patterns() {
    std::vector<Waveform> waveforms;
    for (const double modulation_hz : {0.0, 1.0, 2.0, 5.0, 10.0, 20.0, 40.0, 80.0}) {
        Pattern pattern;
        pattern.modulation.frequency_hz = modulation_hz;
        waveforms.push_back(render(pattern));
    }
    return waveforms;
}

void one_pattern(benchmark::State& state) {
    const auto waveforms = modulated_patterns();
    const NeuralCodingParams params;
    Best code;
    Best stages;
    for (auto _ : state) {
        stages.turn([&] {
            for (const Waveform& waveform : waveforms) {
                benchmark::DoNotOptimize(neural_coding_stages(waveform, params));
            }
        });
        code.turn([&] {
            for (const Waveform& waveform : waveforms) {
                benchmark::DoNotOptimize(neural_code(waveform, params));
            }
        });
    }
    const double each_ms = 1e3 * code.shortest_s / static_cast<double>(waveforms.size());
    state.counters["x_all_stages"] = stages.shortest_s / code.shortest_s;
    owe_at_most(state, each_ms, 2.0, "ms");
}

std::vector<std::shared_ptr<const PatternCode>> thousand_codes() {
    std::vector<std::shared_ptr<const PatternCode>> codes;
    for (int k = 0; k < 1000; ++k) {
        Pattern pattern;
        pattern.amplitude_g = 0.2 + 0.1 * (k % 7);
        pattern.carriers[0].frequency_hz = 40.0 + 7.0 * (k / 50);
        pattern.modulation.frequency_hz = k % 50;
        PatternCode code;
        code.neural = neural_code(render(pattern), {});
        codes.push_back(std::make_shared<const PatternCode>(std::move(code)));
    }
    return codes;
}

double textbook_rmse(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) sum += (a[n] - b[n]) * (a[n] - b[n]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

// On one core, packing included. The textbook loop takes brain waveforms made before.
void thousand_patterns(benchmark::State& state) {
    const auto codes = thousand_codes();
    const PerceptualModelParams params;
    PredictOptions options;
    options.threads = 1;
    constexpr std::size_t kTextbookPatterns = 50;
    std::vector<std::vector<double>> waveforms;
    for (std::size_t k = 0; k < kTextbookPatterns; ++k) {
        waveforms.push_back(predicted_brain_waveform(codes[k]->neural, params.channel_weight));
    }
    Dissimilarity matrix;
    Best counted;
    Best textbook;
    double worst = 0.0;
    for (auto _ : state) {
        counted.turn([&] { matrix = nc_matrix(codes, params, options); });
        textbook.turn([&] {
            for (std::size_t i = 0; i < kTextbookPatterns; ++i) {
                for (std::size_t j = i + 1; j < kTextbookPatterns; ++j) {
                    const double rmse = textbook_rmse(waveforms[i], waveforms[j]);
                    worst = std::max(worst, std::abs(rmse - matrix(i, j)));
                }
            }
        });
    }
    // 10,000 additions in another order.
    if (worst > 1e-12) state.SkipWithError("another RMSE than the textbook's");
    const double pairs = static_cast<double>(pair_count(codes.size()));
    state.counters["x_textbook"] = textbook.shortest_s /
                                   static_cast<double>(pair_count(kTextbookPatterns)) /
                                   (counted.shortest_s / pairs);
    owe_at_most(state, counted.shortest_s, 0.3, "s");
}

}  // namespace

BENCHMARK(one_pattern)->Name("neural_coding/1_s_pattern")->Iterations(20);
BENCHMARK(thousand_patterns)->Name("nc_matrix/1000_patterns/one_core")->Iterations(5);
