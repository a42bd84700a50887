#include "model/perceptual_model/refinement.h"

#include <algorithm>
#include <numeric>

#include "model/perceptual_model/tiles.h"
#include "tests/support/golden.h"

namespace refinement_test {

using namespace tact;

namespace {

// Short patterns of three lengths, which end in silence but for the longest.
std::vector<Waveform> short_waveforms(std::size_t patterns, double amplitude_g = 1.0) {
    std::vector<Waveform> waveforms;
    for (std::size_t k = 0; k < patterns; ++k) {
        Pattern pattern;
        pattern.duration_s = 0.02 + 0.02 * static_cast<double>(k % 3);
        pattern.amplitude_g = amplitude_g * (0.5 + 0.3 * static_cast<double>(k % 4));
        pattern.carriers[0].frequency_hz = 60.0 + 35.0 * static_cast<double>(k % 7);
        pattern.modulation.frequency_hz = 20.0 * static_cast<double>(k % 5);
        waveforms.push_back(padded(render(pattern), 600));
    }
    return waveforms;
}

Refinement begun(const std::vector<Waveform>& waveforms, const PredictOptions& options = {}) {
    return begin_refinement(pattern_codes(waveforms, {}, options), {}, options);
}

std::vector<std::size_t> all_tiles(const Refinement& refinement) {
    std::vector<std::size_t> tiles(refinement.is_made.size());
    std::iota(tiles.begin(), tiles.end(), std::size_t{0});
    return tiles;
}

bool holds(const Tile& tile, std::size_t pattern) {
    return (tile.row <= pattern && pattern < tile.row_end) ||
           (tile.column <= pattern && pattern < tile.column_end);
}

}  // namespace

TEST_CASE("refinement: in the end it has the bits of the whole, in whatever order tiles are made") {
    const auto waveforms = short_waveforms(15);
    const Prediction whole = *predict(waveforms, {});
    const std::vector<std::vector<std::size_t>> orders{{}, {14, 3, 7}, {9, 9, 99}};
    for (const auto& wanted : orders) {
        Refinement refinement = begun(waveforms);
        double share = exact_share(refinement);
        CHECK(share == 0.0);
        for (auto lot = next_tiles(refinement, wanted, 1.0); !lot.empty();
             lot = next_tiles(refinement, wanted, 1.0)) {
            CHECK(lot.size() == 1);
            REQUIRE(make_tiles(refinement, lot, {}));
            CHECK(exact_share(refinement) > share);
            share = exact_share(refinement);
        }
        CHECK(share == 1.0);
        CHECK(open_cells(refinement) == 0.0);
        const Prediction end = prediction_of(refinement);
        CHECK(end.pm == whole.pm);
        CHECK(end.oc == whole.oc);
        CHECK(end.envelope_decimation == 1);
    }
}

TEST_CASE("refinement: the pairs of the pattern wanted first become exact first, with all others") {
    Refinement refinement = begun(short_waveforms(23));
    const std::vector<std::size_t> wanted{17};
    while (!next_tiles(refinement, wanted, 1.0).empty()) {
        const auto lot = next_tiles(refinement, wanted, 1.0);
        bool is_row_open = false;
        for (std::size_t other = 0; other < 23; ++other) {
            if (other == 17) continue;
            const std::size_t pair =
                pair_index(23, std::min<std::size_t>(17, other), std::max<std::size_t>(17, other));
            is_row_open = is_row_open || refinement.is_exact[pair] == 0;
        }
        CHECK(holds(tile_at(23, lot[0]), 17) == is_row_open);
        REQUIRE(make_tiles(refinement, lot, {}));
    }
}

TEST_CASE("refinement: a lot has as many cells as it may, and all of them together are the whole") {
    const Refinement refinement = begun(short_waveforms(15));
    const double whole = open_cells(refinement);
    // The 5 longest of .06 s sound to the end of the set; the others have 100 samples of envelope
    // and a zero more. Cells of two by two of the others are fewer than 600 x 600.
    CHECK(whole < 105.0 * 600.0 * 600.0);
    CHECK(whole > 45.0 * 301.0 * 301.0);
    double sum = 0.0;
    for (const std::size_t tile : all_tiles(refinement)) sum += open_cells(refinement, tile);
    CHECK(sum == doctest::Approx(whole));
    double of_half = 0.0;
    for (const std::size_t tile : next_tiles(refinement, {}, 0.5 * whole)) {
        of_half += open_cells(refinement, tile);
    }
    CHECK(of_half <= 0.5 * whole);
    CHECK(of_half > 0.2 * whole);
    CHECK(next_tiles(refinement, {}, whole).size() == refinement.is_made.size());
}

TEST_CASE("refinement: meanwhile coarse values stand, as large as the exact ones, and it says so") {
    const auto waveforms = short_waveforms(12);
    PredictOptions options;
    options.envelope_decimation = 10;
    const Prediction coarse = *predict(waveforms, {}, options);
    const Prediction exact = *predict(waveforms, {});
    Refinement refinement = begun(waveforms);
    refinement.coarse = {coarse.oc, 10};
    CHECK(prediction_of(refinement).pm == coarse.pm);
    const auto lot = next_tiles(refinement, std::vector<std::size_t>{0}, 1.0);
    REQUIRE(make_tiles(refinement, lot, {}));
    const Prediction mixed = prediction_of(refinement);
    CHECK(mixed.envelope_decimation == 10);
    double in_exact = 0.0;
    double in_coarse = 0.0;
    for (std::size_t pair = 0; pair < mixed.oc.condensed.size(); ++pair) {
        if (refinement.is_exact[pair] == 0) continue;
        CHECK(mixed.oc.condensed[pair] == exact.oc.condensed[pair]);
        in_exact += exact.oc.condensed[pair];
        in_coarse += coarse.oc.condensed[pair];
    }
    for (std::size_t pair = 0; pair < mixed.oc.condensed.size(); ++pair) {
        if (refinement.is_exact[pair] != 0) continue;
        CHECK(mixed.oc.condensed[pair] ==
              doctest::Approx(coarse.oc.condensed[pair] * in_exact / in_coarse));
    }
}

TEST_CASE("refinement: of an earlier prediction only the row of the pattern that changed is open") {
    auto waveforms = short_waveforms(12);
    const Prediction before = *predict(waveforms, {});
    waveforms[5] = short_waveforms(12, 2.0)[5];
    PredictOptions options;
    options.previous = &before;
    Refinement refinement = begun(waveforms, options);
    CHECK(std::ranges::count(refinement.is_exact, std::uint8_t{0}) == 11);
    REQUIRE(make_tiles(refinement, all_tiles(refinement), {}));
    CHECK(prediction_of(refinement).pm == predict(waveforms, {})->pm);
}

TEST_CASE("refinement: a stopped lot changes nothing") {
    Refinement refinement = begun(short_waveforms(9));
    std::stop_source stop;
    stop.request_stop();
    PredictOptions options;
    options.stop = stop.get_token();
    CHECK_FALSE(make_tiles(refinement, all_tiles(refinement), options));
    CHECK(exact_share(refinement) == 0.0);
}

TEST_CASE("refinement: tiles made elsewhere are taken, and of them the codes tell") {
    const auto waveforms = short_waveforms(10);
    Refinement refinement = begun(waveforms);
    TileSource source;
    source.channel_weight = refinement.params.channel_weight;
    for (const auto& code : refinement.codes) add_pattern(source, *code);
    CHECK(fingerprint(source) == fingerprint(refinement.codes, refinement.params));
    for (const std::size_t tile : all_tiles(refinement)) {
        take_tile(refinement, tile, tile_values(source, Part::oc, tile_at(10, tile)));
    }
    CHECK(exact_share(refinement) == 1.0);
    CHECK(prediction_of(refinement).pm == predict(waveforms, {})->pm);
}

TEST_CASE("refinement: one pattern or none has nothing to make") {
    for (const std::size_t patterns : {0UL, 1UL}) {
        const Refinement refinement = begun(short_waveforms(patterns));
        CHECK(exact_share(refinement) == 1.0);
        CHECK(next_tiles(refinement, {}, 1.0).empty());
        CHECK(prediction_of(refinement).pm.condensed.empty());
    }
}

}  // namespace refinement_test
