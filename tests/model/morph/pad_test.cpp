#include "model/morph/morph.h"

#include <doctest/doctest.h>

#include "model/pattern/drawn_fault.h"

namespace pad_test {

using namespace tact;

namespace {

std::vector<Pattern> four_corners() {
    std::vector<Pattern> corners(4);
    corners[0].carriers[0].frequency_hz = 60.0;
    corners[1].carriers[0].frequency_hz = 240.0;
    corners[1].rhythm.text = "x=--x=--";
    corners[2].amplitude_g = 0.4;
    corners[2].modulation.frequency_hz = 12.0;
    corners[3].rhythm.text = "x-x-x-x-";
    return corners;
}

}  // namespace

TEST_CASE("pad: at each corner it is that pattern, bit for bit") {
    const auto corners = four_corners();
    CHECK(mixed_among(corners, 0.0, 0.0) == corners[0]);
    CHECK(mixed_among(corners, 1.0, 0.0) == corners[1]);
    CHECK(mixed_among(corners, 0.0, 1.0) == corners[2]);
    CHECK(mixed_among(corners, 1.0, 1.0) == corners[3]);
}

TEST_CASE("pad: along an edge it is the morph of the two at its ends") {
    const auto corners = four_corners();
    for (const double share : {0.2, 0.5, 0.9}) {
        CHECK(mixed_among(corners, share, 0.0) == morphed(corners[0], corners[1], share));
        CHECK(mixed_among(corners, share, 1.0) == morphed(corners[2], corners[3], share));
        CHECK(mixed_among(corners, 0.0, share) == morphed(corners[0], corners[2], share));
    }
}

TEST_CASE("pad: with two corners down makes no difference, with three the lower edge is one") {
    auto corners = four_corners();
    corners.resize(3);
    CHECK(mixed_among(corners, 1.0, 1.0) == corners[2]);
    corners.resize(2);
    CHECK(mixed_among(corners, 0.3, 0.8) == mixed_among(corners, 0.3, 0.0));
    corners.resize(1);
    CHECK(mixed_among(corners, 0.3, 0.8) == corners[0]);
}

TEST_CASE("pad: everywhere in it is a pattern that can be played") {
    const auto corners = four_corners();
    for (double right = 0.0; right <= 1.0; right += 0.125) {
        for (double down = 0.0; down <= 1.0; down += 0.125) {
            const Waveform waveform = render(mixed_among(corners, right, down));
            CAPTURE(right);
            CAPTURE(down);
            CHECK(peak_g(waveform) > 0.1);
            CHECK(peak_g(waveform) < 1.6);
        }
    }
}

}  // namespace pad_test
