#include "model/dtw/dtw.h"

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <mutex>
#include <random>
#include <thread>

#include "model/dtw/dtw_batches.h"
#include "model/dtw/dtw_strips.h"
#include "tests/support/dtw_textbook.h"
#include "tests/support/golden.h"

namespace dtw_test {

using namespace tact;
using golden::Json;

namespace {

// A wandering signal of both signs, as raw waveforms have.
std::vector<double> wandering(std::size_t length, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> step;
    std::vector<double> signal(length);
    double value = 0.0;
    for (double& sample : signal) sample = value = 0.9 * value + step(random);
    return signal;
}

// Small whole numbers and halves, some of them zero, between silences of any length.
std::vector<double> with_zeros(std::mt19937_64& random) {
    std::uniform_int_distribution<int> silence(-2, 6);
    std::uniform_int_distribution<int> sounding(0, 12);
    std::uniform_int_distribution<int> value(-2, 3);
    std::vector<double> signal(static_cast<std::size_t>(std::max(silence(random), 0)), 0.0);
    for (int k = sounding(random); k > 0; --k) signal.push_back(0.3 * value(random));
    signal.resize(signal.size() + static_cast<std::size_t>(std::max(silence(random), 0)), 0.0);
    return signal;
}

std::vector<SignalPair> neighbours(const std::vector<std::vector<double>>& signals) {
    std::vector<SignalPair> pairs;
    for (std::size_t k = 0; k + 1 < signals.size(); ++k) {
        pairs.push_back({signals[k], signals[k + 1]});
    }
    return pairs;
}

std::vector<double> textbook(const std::vector<SignalPair>& pairs, double waiting_cost = 0.0) {
    std::vector<double> distances;
    for (const SignalPair& pair : pairs) {
        distances.push_back(dtw_textbook(pair.a, pair.b, waiting_cost));
    }
    return distances;
}

// Equal as 64 bits each: == would take -0 for 0.
bool same_bits(const std::vector<double>& got, const std::vector<double>& expected) {
    return std::ranges::equal(got, expected, {}, std::bit_cast<std::uint64_t, double>,
                              std::bit_cast<std::uint64_t, double>);
}

// With every way of computing: one by one and side by side happen for 1 and for many threads.
void check_all_ways(const std::vector<SignalPair>& pairs, double waiting_cost = 0.0) {
    const auto expected = textbook(pairs, waiting_cost);
    for (const DtwKernel& kernel : dtw_kernels()) {
        CAPTURE(kernel.name);
        for (const int threads : {1, 2, 4}) {
            CAPTURE(threads);
            const DtwOptions options{.threads = threads, .waiting_cost = waiting_cost};
            CHECK(same_bits(dtw(pairs, options, kernel), expected));
        }
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            CAPTURE(k);
            const DtwOptions options{.waiting_cost = waiting_cost};
            CHECK(same_bits(dtw(std::span(pairs).subspan(k, 1), options, kernel), {expected[k]}));
        }
    }
}

}  // namespace

TEST_CASE("dtw: distances equal the independent program's") {
    const Json dtw_json = golden::read("dtw.json");
    const Json& cases = dtw_json.at("cases");
    REQUIRE(cases.size() > 20);
    for (const Json& c : cases) {
        const std::vector<double> x = c.at("x");
        const std::vector<double> y = c.at("y");
        const double expected = c.at("distance");
        // The path sums at most 80 terms; each may round once in another order.
        CHECK(std::abs(dtw(x, y) - expected) <= 1e-12 * std::max(1.0, expected));
        CHECK(std::abs(dtw(y, x) - expected) <= 1e-12 * std::max(1.0, expected));
        CHECK(std::abs(dtw_textbook(x, y) - expected) <= 1e-12 * std::max(1.0, expected));
    }
}

TEST_CASE("dtw: constants are apart by their difference on every step of the longer one") {
    CHECK(dtw(std::vector<double>(3, 2.0), std::vector<double>(4, 5.0)) == 12.0);
}

TEST_CASE("dtw: waiting is free") {
    const std::vector<double> once{0, 1, 2, 1, 0};
    const std::vector<double> slow{0, 0, 1, 1, 1, 2, 1, 0, 0, 0};
    CHECK(dtw(once, slow) == 0.0);
    CHECK(dtw(once, once) == 0.0);
}

TEST_CASE("dtw: distances at a cost of waiting equal those of shortest ways through a graph") {
    const Json waiting = golden::read("waiting.json");
    const Json& cases = waiting.at("cases");
    REQUIRE(cases.size() == 36);
    for (const Json& c : cases) {
        const std::vector<double> x = c.at("x");
        const std::vector<double> y = c.at("y");
        const double expected = c.at("distance");
        const DtwOptions options{.waiting_cost = c.at("waiting_cost")};
        const auto got = dtw(std::vector<SignalPair>{{x, y}, {y, x}}, options);
        // Their ways are sums of up to 160 terms.
        CHECK(std::abs(got[0] - expected) <= 1e-12 * std::max(1.0, expected) * 160.0);
        CHECK(std::abs(got[1] - expected) <= 1e-12 * std::max(1.0, expected) * 160.0);
    }
}

TEST_CASE("dtw: each sample more of the longer one waits, and costs what waiting does") {
    const std::vector<double> once{0, 1, 2, 1, 0};
    const std::vector<double> slow{0, 0, 1, 1, 1, 2, 1, 0, 0, 0};
    CHECK(dtw(std::vector<SignalPair>{{once, slow}}, {.waiting_cost = 0.25})[0] == 5 * 0.25);
    CHECK(dtw(std::vector<SignalPair>{{once, once}}, {.waiting_cost = 0.25})[0] == 0.0);
}

TEST_CASE("dtw: where waiting costs more than anything else, signals are held sample by sample") {
    const auto a = wandering(300, 5);
    const auto b = wandering(300, 6);
    double expected = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) expected += std::abs(a[k] - b[k]);
    const double stiff = dtw(std::vector<SignalPair>{{a, b}}, {.waiting_cost = 1e6})[0];
    CHECK(stiff == doctest::Approx(expected).epsilon(1e-12));
    CHECK(dtw(a, b) < stiff);
}

TEST_CASE("dtw: nothing is as far from something as can be, and at nothing from nothing") {
    const std::vector<double> nothing;
    const std::vector<double> something{1.0};
    CHECK(dtw(nothing, nothing) == 0.0);
    CHECK(std::isinf(dtw(something, {})));
    CHECK(std::isinf(dtw({}, something)));
    check_all_ways({{nothing, nothing}, {something, nothing}, {nothing, something}});
    CHECK(dtw(std::vector<SignalPair>{}).empty());
}

TEST_CASE("dtw: every length gives the textbook's bits, whatever strips it fills") {
    // Strips have 5 to 64 rows: lengths around them, and each as rows and as columns.
    for (std::size_t length = 1; length <= 70; ++length) {
        CAPTURE(length);
        const auto a = wandering(length, 1);
        for (const std::size_t other : {std::size_t{1}, std::size_t{7}, length, std::size_t{65}}) {
            const auto b = wandering(other, 2);
            check_all_ways({{a, b}, {b, a}});
            check_all_ways({{a, b}, {b, a}}, 0.3);
        }
    }
}

TEST_CASE("dtw: any number of pairs gives the textbook's bits, whatever registers it fills") {
    std::vector<std::vector<double>> signals;
    for (unsigned k = 0; k < 37; ++k) {
        signals.push_back(wandering(33, k));
        check_all_ways(neighbours(signals));
    }
}

TEST_CASE("dtw: pairs of different shapes keep their places") {
    std::vector<std::vector<double>> signals;
    for (unsigned k = 0; k < 60; ++k) signals.push_back(wandering(20 + (7 * k) % 5, k));
    check_all_ways(neighbours(signals));
}

TEST_CASE("dtw: zeros before, within and behind the signals give the textbook's bits") {
    std::mt19937_64 random(11);
    std::vector<std::vector<double>> signals;
    for (int k = 0; k < 700; ++k) signals.push_back(with_zeros(random));
    check_all_ways(neighbours(signals));
    check_all_ways(neighbours({signals.begin(), signals.begin() + 100}), 0.3);
}

TEST_CASE("dtw: a pair costs the product of its own lengths where both signals end in silence") {
    const std::vector<double> short_one{0, 0, 3, 1, 0, 0, 0, 0};
    const std::vector<double> long_one{0, 1, 2, 1, 0, 2, 0, 0};
    const TrimmedPair own = trimmed({short_one, long_one}, 0.0);
    CHECK(own.may_be_padded);
    CHECK(own.signals.a.size() == 7);  // one zero at either end
    CHECK(own.signals.b.size() == 4);
    // One of the two sounds to its end: nothing behind may go, and nothing may be added.
    const std::vector<double> sounding{0, 0, 3, 1, 2};
    const TrimmedPair kept = trimmed({short_one, sounding}, 0.0);
    CHECK_FALSE(kept.may_be_padded);
    CHECK(kept.signals.a.size() == 7);  // the beginning alone
    CHECK(kept.signals.b.size() == 4);
    // Where waiting costs, every zero counts.
    CHECK(trimmed({short_one, long_one}, 0.3).signals.a.size() == 8);
    CHECK_FALSE(trimmed({short_one, long_one}, 0.3).may_be_padded);
}

TEST_CASE("dtw: pairs of unequal lengths fill registers with little waste") {
    std::mt19937_64 random(12);
    std::uniform_int_distribution<std::size_t> length(200, 30'000);
    std::vector<std::vector<double>> signals;
    for (int k = 0; k < 60; ++k) {
        signals.emplace_back(length(random), 1.0);
        signals.back().back() = 0.0;
    }
    std::vector<TrimmedPair> pairs;
    double cells = 0.0;
    for (std::size_t i = 0; i < signals.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            pairs.push_back(trimmed({signals[i], signals[j]}, 0.0));
            cells +=
                static_cast<double>(signals[i].size()) * static_cast<double>(signals[j].size());
        }
    }
    for (const DtwKernel& kernel : dtw_kernels()) {
        CAPTURE(kernel.name);
        double cost = 0.0;
        std::size_t count = 0;
        for (const DtwBatch& batch : dtw_batches(pairs, kernel, 2).all) {
            cost += batch.cost;
            count += batch.count;
        }
        CHECK(count == pairs.size());
        CHECK(cost <= 1.2 * cells);
    }
}

TEST_CASE("dtw: eleven pairs of one shape keep two threads about equally busy") {
    const std::vector<double> signal(10'000, 1.0);
    const std::vector<TrimmedPair> pairs(11, trimmed({signal, signal}, 0.0));
    // Each takes the next batch as soon as it is free: 4 and two alone against 4 and one alone, in
    // place of two registers against one that is not full.
    const DtwKernel four_lanes{"", {4, 6, nullptr, nullptr}, {1, 24, nullptr, nullptr}};
    std::array<double, 2> busy{};
    for (const DtwBatch& batch : dtw_batches(pairs, four_lanes, 2).all) {
        *std::ranges::min_element(busy) += batch.cost;
    }
    CHECK(std::ranges::max(busy) <= 7.0 * 1e8);
}

TEST_CASE("dtw: a second at 10 kHz, and a sample around it, gives the textbook's bits" *
          doctest::test_suite("long")) {
    std::vector<std::vector<double>> signals;
    for (const std::size_t length : {9'999, 10'000, 10'001}) {
        signals.push_back(wandering(length, static_cast<unsigned>(length)));
    }
    const std::vector<SignalPair> pairs{{signals[0], signals[1]}, {signals[1], signals[2]}};
    const auto expected = textbook(pairs);
    for (const DtwKernel& kernel : dtw_kernels()) {
        CAPTURE(kernel.name);
        CHECK(same_bits(dtw(pairs, {}, kernel), expected));
        // As many equal pairs as lie side by side, so that none is taken alone.
        const std::vector<SignalPair> full(kernel.many_pairs.pairs, pairs[0]);
        const std::vector<double> same(full.size(), expected[0]);
        CHECK(same_bits(dtw(full, {.threads = 1}, kernel), same));
    }
}

TEST_CASE("dtw: several threads at one pair give the textbook's bits, whatever its shape") {
    const std::vector<std::pair<std::size_t, std::size_t>> shapes{
        {1, 1}, {1, 9000}, {9000, 1}, {70, 20'000}, {20'000, 70}, {3000, 5000}, {8192, 24}};
    for (const auto& [rows, columns] : shapes) {
        CAPTURE(rows);
        CAPTURE(columns);
        const auto a = wandering(rows, 1);
        const auto b = wandering(columns, 2);
        for (const double waiting_cost : {0.0, 0.3}) {
            const double expected = dtw_textbook(a, b, waiting_cost);
            for (const DtwKernel& kernel : dtw_kernels()) {
                for (const DtwSweep& sweep : {kernel.one_pair, kernel.many_pairs}) {
                    for (const int threads : {2, 3, 8}) {
                        const SignalPair pair{a, b};
                        double got = 0.0;
                        dtw_strips(sweep, {&pair, 1}, waiting_cost, {&got, 1}, {}, threads);
                        CHECK(same_bits({got}, {expected}));
                    }
                }
            }
        }
    }
}

TEST_CASE("dtw: zeros that nobody keeps count as those that are written down") {
    std::mt19937_64 random(11);
    std::uniform_int_distribution<std::size_t> more(0, 9);
    std::vector<std::vector<double>> own;
    std::vector<std::vector<double>> whole;
    for (int k = 0; k < 120; ++k) {
        own.push_back(with_zeros(random));
        whole.push_back(own.back());
        whole.back().resize(own.back().size() + more(random), 0.0);
    }
    // A set has one length, and its longest signal no zero at its end.
    for (int k = 0; k < 20; ++k) {
        own.push_back(wandering(1 + more(random), 50 + static_cast<unsigned>(k)));
        whole.push_back(own.back());
        whole.back().resize(10, 0.0);
    }
    const auto pairs = neighbours(whole);
    auto short_pairs = neighbours(own);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        short_pairs[k].a_samples = whole[k].size();
        short_pairs[k].b_samples = whole[k + 1].size();
    }
    for (const double waiting_cost : {0.0, 0.2}) {
        const auto expected = textbook(pairs, waiting_cost);
        for (const DtwKernel& kernel : dtw_kernels()) {
            CAPTURE(kernel.name);
            DtwOptions options;
            options.waiting_cost = waiting_cost;
            CHECK(same_bits(dtw(short_pairs, options, kernel), expected));
        }
    }
}

TEST_CASE("dtw: a pair that takes longer than all others together is computed by all threads" *
          doctest::test_suite("long")) {
    const auto longest = wandering(40'000, 1);
    const auto other = wandering(39'000, 2);
    const auto small = wandering(500, 3);
    const std::vector<SignalPair> pairs{{small, other}, {longest, other}, {small, small}};
    const auto alone = dtw(pairs, {.threads = 1});
    CHECK(same_bits(dtw(pairs, {.threads = 3}), alone));
    // Stopped in the middle, it is soon back.
    std::stop_source stop;
    std::jthread soon([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        stop.request_stop();
    });
    const std::vector<double> endless(400'000, 1.0);  // 1.6e11 cells
    const std::vector<SignalPair> one{{endless, endless}};
    CHECK(std::isinf(dtw(one, {.threads = 2, .stop = stop.get_token()})[0]));
}

TEST_CASE("dtw: tiny, huge and equal numbers give the textbook's bits") {
    auto tiny = wandering(50, 1);
    auto huge = wandering(50, 2);
    for (double& value : tiny) value *= 1e-308;  // many of these are subnormal
    for (double& value : huge) value *= 1e305;   // and sums of these stay finite
    const std::vector<double> zeros(50, 0.0);
    const std::vector<double> negative_zeros(50, -0.0);
    check_all_ways({{tiny, tiny}, {tiny, huge}, {huge, zeros}, {zeros, negative_zeros}});
    CHECK(dtw(zeros, negative_zeros) == 0.0);
    CHECK_FALSE(std::signbit(dtw(zeros, negative_zeros)));
}

TEST_CASE("dtw: progress climbs to one, by the work that is done") {
    std::vector<std::vector<double>> signals;
    for (unsigned k = 0; k < 30; ++k) signals.push_back(wandering(50, k));
    const auto pairs = neighbours(signals);
    std::mutex mutex;
    std::vector<double> shares;
    dtw(pairs, {.threads = 2, .progress = [&](double share) {
                    const std::scoped_lock lock(mutex);
                    shares.push_back(share);
                }});
    REQUIRE_FALSE(shares.empty());
    std::ranges::sort(shares);  // threads may report out of turn
    CHECK(shares.front() > 0.0);
    CHECK(shares.back() == 1.0);
    CHECK(std::ranges::adjacent_find(shares) == shares.end());
}

TEST_CASE("dtw: a stop ends a long comparison at once") {
    std::stop_source stop;
    stop.request_stop();
    const std::vector<double> large(100'000, 1.0);  // 1e10 cells: minutes, if not stopped
    CHECK(std::isinf(dtw(large, large, stop.get_token())));
    const std::vector<SignalPair> pairs(9, {large, large});
    for (const double distance : dtw(pairs, {.threads = 2, .stop = stop.get_token()})) {
        CHECK(std::isinf(distance));
    }
}

TEST_CASE("dtw: a stop in the middle of long comparisons ends them") {
    const std::vector<double> large(100'000, 1.0);
    const std::vector<SignalPair> pairs(32, {large, large});  // half a minute, if not stopped
    for (const DtwKernel& kernel : dtw_kernels()) {
        CAPTURE(kernel.name);
        std::stop_source stop;
        std::jthread soon([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            stop.request_stop();
        });
        const auto begin = std::chrono::steady_clock::now();
        const auto distances = dtw(pairs, {.threads = 2, .stop = stop.get_token()}, kernel);
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
        CHECK(std::ranges::all_of(distances, [](double d) { return std::isinf(d); }));
        // A strip is about 1 ms at this length; the rest is for a machine with other things to do.
        CHECK(taken.count() < 2.0);
    }
}

}  // namespace dtw_test
