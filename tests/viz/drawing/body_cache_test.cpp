#include "viz/drawing/body_cache.h"

#include <doctest/doctest.h>

#include <cstddef>
#include <span>
#include <vector>

#include "model/common/random.h"

namespace tact::body_cache_test {
namespace {

struct View {
    double first = 0.0;
    double last = 4000.0;
    std::size_t columns = 200;
    BodyScale scale{6.0, 0.0025};
};

std::vector<double> noise(std::size_t count) {
    RandomStream random{7};
    std::vector<double> samples(count);
    for (double& sample : samples) sample = next_even(random);
    return samples;
}

const std::vector<Extremes>& drawn(BodyCache& cache, std::span<const double> samples,
                                   const View& view, int frame = 1) {
    return kept_body(cache, frame, samples, view.first, view.last, view.columns, view.scale)
        ->columns;
}

std::vector<Extremes> afresh(std::span<const double> samples, const View& view) {
    return body_columns(samples, view.first, view.last, view.columns, view.scale);
}

TEST_CASE("body cache: any view of any wave is what body_columns gives") {
    const std::vector<double> samples = noise(4001);
    BodyCache cache;
    std::vector<View> views(1);
    views.push_back({0.5, 4000.0});
    views.push_back({0.0, 4000.5});
    views.push_back({0.0, 4000.0, 201});
    views.push_back({0.0, 4000.0, 200, {5.0, 0.0025}});
    views.push_back({0.0, 4000.0, 200, {6.0, 0.5}});
    views.push_back({-900.0, 9000.0});
    views.push_back({1200.0, 1300.0});
    for (int turn = 0; turn < 2; ++turn) {
        for (const View& view : views) CHECK(drawn(cache, samples, view) == afresh(samples, view));
    }
    CHECK(cache.kept.size() == views.size());
}

TEST_CASE("body cache: every sample that a column depends on is looked at" *
          doctest::test_suite("long")) {
    std::vector<double> samples = noise(4001);
    BodyCache cache;
    // Within the wave, and up to an end that no four samples fill.
    for (const View& view : {View{1000.0, 2000.0, 50}, View{3800.0, 4001.0, 50}}) {
        drawn(cache, samples, view);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double was = samples[i];
            samples[i] = 3.0;
            if (afresh(samples, view) != afresh(noise(4001), view)) {
                const bool same = drawn(cache, samples, view) == afresh(samples, view);
                CHECK_MESSAGE(same, "sample ", i);
            }
            samples[i] = was;
        }
    }
}

TEST_CASE("body cache: what is not drawn goes, what is drawn stays") {
    const std::vector<double> samples = noise(400);
    BodyCache cache;
    const View steady{0.0, 399.0, 20};
    // Held, so that no other takes its place in memory.
    const auto first =
        kept_body(cache, 1, samples, steady.first, steady.last, steady.columns, steady.scale);
    for (int frame = 1; frame <= 2000; ++frame) {
        CHECK(&drawn(cache, samples, steady, frame) == &first->columns);
        const std::size_t before = cache.kept.size();
        drawn(cache, samples, {0.0, 300.0 + 0.01 * frame, 20}, frame);
        CHECK(cache.kept.size() <= before + 1);
    }
    CHECK(cache.kept.size() <= 257);
    const std::size_t before = cache.kept.size();
    drawn(cache, samples, steady, 2001);
    CHECK(cache.kept.size() == before);
}

}  // namespace
}  // namespace tact::body_cache_test
