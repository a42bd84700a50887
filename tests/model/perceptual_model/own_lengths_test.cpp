// Envelopes of bundled sets are padded to the longest of their set, and compared at their own
// lengths: no bit may differ from a comparison of the padded ones.

#include <bit>
#include <cmath>
#include <filesystem>

#include "model/dtw/dtw.h"
#include "model/dtw/dtw_strips.h"
#include "model/io/set/load.h"
#include "model/perceptual_model/rhythm_envelope.h"
#include "model/set/pattern_set.h"
#include "tests/support/places.h"

namespace own_lengths_test {

using namespace tact;

namespace {

constexpr double kMostCells = 8e8;  // of one set, padded: a sample of pairs where it has more

std::vector<std::vector<double>> envelopes_of(const PatternSet& set) {
    std::vector<std::vector<double>> envelopes;
    for (const Waveform& waveform : model_waveforms(set)) {
        envelopes.push_back(rhythm_envelope(waveform.samples_g, set.model.envelope));
    }
    return envelopes;
}

// Evenly among all pairs, as many as are soon compared.
std::vector<SignalPair> some_pairs(const std::vector<std::vector<double>>& envelopes) {
    std::vector<SignalPair> all;
    for (std::size_t i = 0; i < envelopes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) all.push_back({envelopes[i], envelopes[j]});
    }
    const double cells = std::pow(static_cast<double>(envelopes[0].size()), 2.0);
    const auto most = std::max<std::size_t>(static_cast<std::size_t>(kMostCells / cells), 2);
    const std::size_t stride = (all.size() + most - 1) / most;
    std::vector<SignalPair> some;
    for (std::size_t k = 0; k < all.size(); k += stride) some.push_back(all[k]);
    return some;
}

}  // namespace

TEST_CASE("own lengths: bundled sets keep every bit of the padded comparison" *
          doctest::test_suite("long")) {
    const auto folder = std::filesystem::path(kAssetsDir) / "sets";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        CAPTURE(entry.path().string());
        const auto loaded = load_set(entry.path());
        REQUIRE(loaded);
        const auto envelopes = envelopes_of(loaded->set);
        const auto pairs = some_pairs(envelopes);
        const auto own = dtw(pairs);
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            double padded = 0.0;
            dtw_strips(dtw_kernel().one_pair, {&pairs[k], 1}, 0.0, {&padded, 1}, {});
            CHECK(std::bit_cast<std::uint64_t>(own[k]) == std::bit_cast<std::uint64_t>(padded));
        }
    }
}

}  // namespace own_lengths_test
