#include "model/perceptual_model/tiles.h"

#include <algorithm>
#include <atomic>
#include <mutex>

#include "tests/support/golden.h"

namespace tiles_test {

using namespace tact;

namespace {

using Codes = std::vector<std::shared_ptr<const PatternCode>>;

// Very short patterns: the laws hold for any.
Codes short_codes(std::size_t patterns) {
    std::vector<Waveform> waveforms;
    for (std::size_t k = 0; k < patterns; ++k) {
        Pattern pattern;
        pattern.duration_s = 0.03;
        pattern.amplitude_g = 0.5 + 0.3 * static_cast<double>(k % 4);
        pattern.carriers[0].frequency_hz = 60.0 + 35.0 * static_cast<double>(k % 7);
        pattern.modulation.frequency_hz = 20.0 * static_cast<double>(k % 5);
        waveforms.push_back(render(pattern));
    }
    return pattern_codes(waveforms, {}, {});
}

TileSource source_of(const Codes& codes) {
    TileSource source;
    source.channel_weight = PerceptualModelParams{}.channel_weight;
    for (const auto& code : codes) add_pattern(source, *code);
    return source;
}

// The whole matrix through a desk that hands out the tiles backwards.
Dissimilarity made_from_tiles(const TileSource& source, Part part, int threads) {
    const std::size_t patterns = pattern_count(source);
    Dissimilarity matrix{patterns, std::vector<double>(pair_count(patterns), -1.0)};
    std::mutex mutex;
    std::size_t left = tile_count(patterns);
    TileDesk desk;
    desk.next = [&](std::size_t) -> std::optional<std::size_t> {
        const std::scoped_lock lock(mutex);
        if (left == 0) return std::nullopt;
        return --left;
    };
    desk.done = [&](std::size_t tile, std::span<const double> values) {
        const std::scoped_lock lock(mutex);
        put_tile(matrix, tile_at(patterns, tile), values);
    };
    make_tiles(source, part, threads, desk);
    return matrix;
}

}  // namespace

TEST_CASE("tiles: after a stop none is brought, and the desk still hears that threads are there") {
    const TileSource source = source_of(short_codes(40));
    for (const Part part : {Part::nc, Part::oc}) {
        std::stop_source stop;
        std::size_t asked = 0;
        std::size_t brought = 0;
        TileDesk desk;
        // The third is under way when the stop comes.
        desk.next = [&](std::size_t) -> std::optional<std::size_t> {
            if (++asked == 3) stop.request_stop();
            return asked > 3 ? std::nullopt : std::optional<std::size_t>(asked);
        };
        desk.done = [&](std::size_t, std::span<const double>) { ++brought; };
        make_tiles(source, part, 1, desk, stop.get_token());
        CHECK(brought == 2);
        CHECK(asked == 4);
    }
}

TEST_CASE("tiles: every pair lies in exactly one") {
    for (const std::size_t patterns : {2UL, 3UL, 4UL, 5UL, 12UL, 255UL, 256UL, 257UL, 1000UL}) {
        CAPTURE(patterns);
        std::vector<int> visits(pair_count(patterns));
        for (std::size_t k = 0; k < tile_count(patterns); ++k) {
            const Tile tile = tile_at(patterns, k);
            std::size_t pairs = 0;
            for (std::size_t i = tile.row; i < tile.row_end; ++i) {
                for (std::size_t j = std::max(tile.column, i + 1); j < tile.column_end; ++j) {
                    ++visits[pair_index(patterns, i, j)];
                    ++pairs;
                }
            }
            CHECK(pair_count(tile) == pairs);
        }
        CHECK(std::ranges::all_of(visits, [](int count) { return count == 1; }));
    }
}

TEST_CASE("tiles: a stop loses less than a hundredth of a thousand patterns") {
    // Half a tile for each thread on average, and 32 threads.
    CHECK(tile_count(1000) > 16 * 100);
    CHECK(tile_count(10'000) > tile_count(1000));
}

TEST_CASE("tiles: they make the same matrices, bit for bit, on any number of threads") {
    const Codes codes = short_codes(14);
    const TileSource source = source_of(codes);
    REQUIRE(tile_count(codes.size()) == 10);
    const Dissimilarity nc = nc_matrix(codes, {}, {});
    const Dissimilarity oc = oc_matrix(codes, {}, {});
    for (const int threads : {1, 2, 4}) {
        CHECK(made_from_tiles(source, Part::nc, threads) == nc);
        CHECK(made_from_tiles(source, Part::oc, threads) == oc);
    }
    PerceptualModelParams at_cost;
    at_cost.envelope.waiting_cost = 0.1;
    TileSource costly = source;
    costly.waiting_cost = 0.1;
    const Dissimilarity oc_at_cost = oc_matrix(codes, at_cost, {});
    CHECK(oc_at_cost != oc);
    CHECK(made_from_tiles(costly, Part::oc, 2) == oc_at_cost);
}

TEST_CASE("tiles: a tile depends on the patterns of its two ranges and on no other") {
    const Codes codes = short_codes(12);
    const Tile tile = tile_at(codes.size(), 1);
    REQUIRE(tile == Tile{0, 4, 4, 8});
    Codes others = codes;
    std::swap(others[8], others[11]);
    Codes touched = codes;
    std::swap(touched[7], touched[11]);
    for (const Part part : {Part::nc, Part::oc}) {
        const auto values = tile_values(source_of(codes), part, tile);
        CHECK(tile_values(source_of(others), part, tile) == values);
        CHECK(tile_values(source_of(touched), part, tile) != values);
    }
}

TEST_CASE("tiles: what was put into a matrix comes back") {
    for (const std::size_t index : {0UL, 1UL, 5UL}) {
        const Tile tile = tile_at(9, index);
        std::vector<double> values(pair_count(tile));
        for (std::size_t k = 0; k < values.size(); ++k) values[k] = 1.0 + static_cast<double>(k);
        Dissimilarity matrix{9, std::vector<double>(pair_count(9))};
        put_tile(matrix, tile, values);
        CHECK(tile_of(matrix, tile) == values);
        // Nothing else was touched.
        const auto zeros = std::ranges::count(matrix.condensed, 0.0);
        CHECK(static_cast<std::size_t>(zeros) == pair_count(9) - values.size());
    }
}

TEST_CASE("tiles: the fingerprint changes with all that a value depends on") {
    const TileSource source = source_of(short_codes(5));
    const std::uint64_t number = fingerprint(source);
    CHECK(fingerprint(source_of(short_codes(5))) == number);

    TileSource other = source;
    other.envelopes[4].back() += 1e-12;
    CHECK(fingerprint(other) != number);
    other = source;
    other.spikes[2].bits[0] ^= 1U;
    CHECK(fingerprint(other) != number);
    other = source;
    other.channel_weight[3] += 0.1;
    CHECK(fingerprint(other) != number);
    other = source;
    other.waiting_cost = 0.1;
    CHECK(fingerprint(other) != number);
    other = source;
    std::swap(other.envelopes[0], other.envelopes[1]);
    std::swap(other.spikes[0], other.spikes[1]);
    CHECK(fingerprint(other) != number);
    CHECK(fingerprint(source_of(short_codes(4))) != number);
}

TEST_CASE("tiles: the longest come first, by the patterns' own lengths") {
    // Every other four envelopes sound for long; all end in silence.
    TileSource source;
    source.samples = 1000;
    constexpr std::size_t kPatterns = 24;
    for (std::size_t k = 0; k < kPatterns; ++k) {
        source.envelopes.emplace_back(k % 8 < 4 ? 10 + k : 500 + k, 0.5);
    }
    const std::vector<double> costs = tile_costs(source, Part::oc);
    REQUIRE(costs.size() == tile_count(kPatterns));
    const std::size_t side = tile_side(kPatterns);
    REQUIRE(side == 4);
    CHECK(costs[0] == 11.0 * 12 + 11.0 * 13 + 11.0 * 14 + 12.0 * 13 + 12.0 * 14 + 13.0 * 14);
    const std::vector<std::size_t> order = by_cost(costs);
    for (std::size_t k = 1; k < order.size(); ++k) {
        CHECK(costs[order[k - 1]] >= costs[order[k]]);
    }
    auto all = order;
    std::ranges::sort(all);
    for (std::size_t k = 0; k < all.size(); ++k) CHECK(all[k] == k);

    // Where one of a pair sounds to its end, or waiting costs, nothing is trimmed.
    source.envelopes[0].resize(source.samples, 0.1);
    CHECK(tile_costs(source, Part::oc)[0] == 3e6 + 12.0 * 13 + 12.0 * 14 + 13.0 * 14);
    source.waiting_cost = 0.5;
    CHECK(tile_costs(source, Part::oc)[0] == 6e6);
    CHECK(tile_costs(source, Part::nc)[0] == 6.0);
}

}  // namespace tiles_test
