#include "app/timeline/timeline.h"

#include <doctest/doctest.h>

#include <cmath>

namespace playhead_test {

using namespace tact;

namespace {

bool near(double a, double b) { return std::abs(a - b) < 1e-12; }

}  // namespace

TEST_CASE("playhead: a hundred times slower, a second takes a hundred seconds") {
    Playhead playhead{.speed = 0.01, .playing = true};
    for (int k = 0; k < 1000; ++k) playhead = advanced(playhead, 0.05, 1.0);
    CHECK(near(playhead.at_s, 0.5));
}

TEST_CASE("playhead: at the end it starts over, or stays there and stops") {
    Playhead playhead{.at_s = 0.9, .speed = 1.0, .playing = true, .loop = true};
    CHECK(near(advanced(playhead, 0.3, 1.0).at_s, 0.2));
    CHECK(advanced(playhead, 0.3, 1.0).playing);
    playhead.loop = false;
    CHECK(advanced(playhead, 0.3, 1.0).at_s == 1.0);
    CHECK_FALSE(advanced(playhead, 0.3, 1.0).playing);
}

TEST_CASE("playhead: without a pattern it has nowhere to go") {
    const Playhead playhead{.speed = 1.0, .playing = true};
    const Playhead after = advanced(playhead, 0.1, 0.0);
    CHECK(after.at_s == 0.0);
    CHECK_FALSE(after.playing);
}

TEST_CASE("playhead: 5 ms steps go from the start of one step of the model to the next") {
    Playhead playhead{.at_s = 0.0123, .playing = true};
    playhead = stepped(playhead, 1, 1.0);
    CHECK(near(playhead.at_s, 0.015));
    CHECK_FALSE(playhead.playing);
    // Two hundred of them make a second, rounding or not.
    playhead.at_s = 0.0;
    for (int k = 0; k < 150; ++k) playhead = stepped(playhead, 1, 1.0);
    CHECK(near(playhead.at_s, 0.75));
    for (int k = 0; k < 150; ++k) playhead = stepped(playhead, 1, 1.0);
    CHECK(near(playhead.at_s, 0.995));
    for (int k = 0; k < 300; ++k) playhead = stepped(playhead, -1, 1.0);
    CHECK(playhead.at_s == 0.0);
}

TEST_CASE("time range: zooming keeps what is under the mouse in its place") {
    const TimeRange range = zoomed({0.0, 1.0}, 0.5, 0.25, 1.0);
    CHECK(near(range.length_s(), 0.5));
    CHECK(near((0.25 - range.start_s) / range.length_s(), 0.25));
}

TEST_CASE("time range: neither zooming nor panning leaves the pattern") {
    CHECK(zoomed({0.2, 0.6}, 100.0, 0.3, 1.0) == TimeRange{0.0, 1.0});
    CHECK(near(zoomed({0.2, 0.6}, 1e-9, 0.3, 1.0).length_s(), kShortestRangeS));
    CHECK(near(panned({0.2, 0.6}, 5.0, 1.0).end_s, 1.0));
    CHECK(panned({0.2, 0.6}, -5.0, 1.0).start_s == 0.0);
    CHECK(near(panned({0.2, 0.6}, 5.0, 1.0).length_s(), 0.4));
}

TEST_CASE("time range: another pattern is shown whole where the range would not fit") {
    CHECK(fitted({0.0, 2.0}, 1.0) == TimeRange{0.0, 1.0});
    CHECK(fitted({}, 1.0) == TimeRange{0.0, 1.0});
    CHECK(fitted({0.1, 0.2}, 1.0) == TimeRange{0.1, 0.2});
}

TEST_CASE("time range: it turns the page when the playhead leaves it") {
    CHECK(followed({0.0, 0.2}, 0.1, 1.0) == TimeRange{0.0, 0.2});
    CHECK(followed({0.0, 0.2}, 0.25, 1.0).start_s == 0.25);
    CHECK(followed({0.7, 0.9}, 0.0, 1.0).start_s == 0.0);
    CHECK(near(followed({0.7, 0.9}, 0.95, 1.0).end_s, 1.0));
}

}  // namespace playhead_test
