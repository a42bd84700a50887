// A loop that is changed while it sounds: heard at once, never as a click.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "devices/device/playback.h"
#include "tests/support/playback_stream.h"

namespace playback_change_test {

using namespace tact;
using namespace tact::playback_stream;

namespace {

constexpr auto kCross = static_cast<std::size_t>(kCrossS * kRateHz);

float largest_step(const std::vector<float>& heard, std::size_t from) {
    float largest = 0.0F;
    for (std::size_t n = std::max<std::size_t>(1, from); n < heard.size(); ++n) {
        largest = std::max(largest, std::abs(heard[n] - heard[n - 1]));
    }
    return largest;
}

}  // namespace

TEST_CASE("playback: a changed loop is heard in the next frame, and is the new one 20 ms later") {
    const Clip before = sine(0.2, 9600, true, 1);
    const Clip after = sine(0.6, 9600, true, 1);
    Stream stream;
    stream.playback.wanted = &before;
    const std::size_t at = kPad + 4873;
    stream.run(at, 1);
    stream.playback.wanted = &after;
    stream.run(9600, 1);
    for (std::size_t n = kPad; n < stream.heard.size(); ++n) {
        const std::size_t k = (n - kPad) % 9600;
        if (n < at) REQUIRE(stream.heard[n] == before.samples[k]);
        if (n >= at + kCross + 1) REQUIRE(stream.heard[n] == after.samples[k]);
    }
    // At once: within a millisecond it is no longer what it was.
    CHECK(std::abs(stream.heard[at + 48] - before.samples[4873 + 48]) > 1e-4F);
    CHECK(stream.playback.begun == 1);
    CHECK(stream.playback.ended == 0);
}

TEST_CASE(
    "playback: wherever a loop is changed, no step is larger than those of what it is made of") {
    const Clip before = sine(0.5, 9600, true, 1);
    Clip after = sine(-0.5, 9600, true, 1);  // the opposite: the largest difference there is
    // A tone of 150 Hz steps by 2 pi 150 / 48000 of its amplitude; the two are 1 apart at most, and
    // a smooth fade of 20 ms steps by 1.5 / 960 at its steepest.
    const float allowed = 0.5F * 0.01964F + 1.5F / static_cast<float>(kCross);
    for (std::size_t shift = 0; shift < 320; shift += 13) {
        Stream stream;
        stream.playback.wanted = &before;
        stream.run(kPad + 4800 + shift, 1);
        stream.playback.wanted = &after;
        stream.run(2400);
        REQUIRE(largest_step(stream.heard, 0) <= allowed);
        REQUIRE(loudest(stream.heard, 0, stream.heard.size()) <= 0.5);
    }
}

TEST_CASE("playback: changes that come faster than they fade end in the newest, without a step") {
    const Clip first = sine(0.1, 9600, true, 1);
    const Clip second = sine(0.4, 9600, true, 1);
    const Clip third = sine(0.6, 9600, true, 1);
    Stream stream;
    stream.playback.wanted = &first;
    stream.run(kPad + 4800);
    stream.playback.wanted = &second;
    stream.run(480);
    CHECK(stream.playback.held_under == &first);
    stream.playback.wanted = &third;
    stream.run(240);
    CHECK(stream.playback.held == &second);  // until the first is through
    stream.run(4800);
    CHECK(stream.playback.held == &third);
    CHECK(stream.playback.held_under == nullptr);
    CHECK(largest_step(stream.heard, 0) <= 0.6F * 0.01964F + 0.6F * 1.5F / kCross);
    for (std::size_t n = stream.heard.size() - 960; n < stream.heard.size(); ++n) {
        REQUIRE(stream.heard[n] == third.samples[(n - kPad) % 9600]);
    }
}

TEST_CASE("playback: a loop that becomes shorter goes on within what it becomes") {
    const Clip before = sine(0.3, 9600, true, 1);
    const Clip after = sine(0.3, 3200, true, 1);  // the same tone, ten periods of it
    Stream stream;
    stream.playback.wanted = &before;
    stream.run(kPad + 8000);
    stream.playback.wanted = &after;
    stream.run(9600);
    // The tone does not notice.
    for (std::size_t n = 0; n < 17'600; ++n) {
        REQUIRE(std::abs(stream.heard[kPad + n] - before.samples[n % 320]) < 1e-4F);
    }
    CHECK(notes_of(stream.playback, 1).rounds >= 3);
}

TEST_CASE("playback: what is too loud for the ceiling is held back from its first frame") {
    const Clip before = sine(0.2, 9600, true, 1);
    const Clip after = sine(1.6, 9600, true, 1);
    Stream stream;
    stream.playback.wanted = &before;
    stream.run(kPad + 4800);
    stream.playback.wanted = &after;
    stream.run(9600);
    CHECK(notes_of(stream.playback, 1).clipped);
    CHECK(loudest(stream.heard, 0, stream.heard.size()) <= kCeiling + 1e-7);  // a float
    for (std::size_t n = stream.heard.size() - 960; n < stream.heard.size(); ++n) {
        REQUIRE(std::abs(stream.heard[n] - 0.5F * after.samples[(n - kPad) % 9600]) < 1e-6F);
    }
}

TEST_CASE("playback: a stop in the middle of a change is as soft and as soon as any") {
    const Clip before = sine(0.5, 9600, true, 1);
    const Clip after = sine(-0.5, 9600, true, 1);
    Stream stream;
    stream.playback.wanted = &before;
    stream.run(kPad + 4800);
    stream.playback.wanted = &after;
    stream.run(300);
    stream.playback.wanted = nullptr;
    const std::size_t at = stream.heard.size();
    stream.run(2400);
    CHECK(loudest(stream.heard, at + 242, stream.heard.size()) == 0.0);
    CHECK(stream.playback.ended == 1);
    CHECK(stream.playback.held_under == nullptr);
    CHECK(largest_step(stream.heard, 0) <= 0.5F * 0.01964F + 1.5F / kCross + 0.5F / 240.0F);
}

TEST_CASE("playback: what has ended is not brought back by a change") {
    Clip before = sine(0.5, 9600, true, 1);
    before.longest_frames = 4800;
    const Clip after = sine(0.6, 9600, true, 1);
    Stream stream;
    stream.playback.wanted = &before;
    stream.run(kPad + 9600);
    REQUIRE(stream.playback.ended == 1);
    stream.playback.wanted = &after;
    const std::size_t at = stream.heard.size();
    stream.run(9600);
    CHECK(loudest(stream.heard, at, stream.heard.size()) == 0.0);
}

TEST_CASE("playback: how long a loop may last counts on through its changes") {
    Clip before = sine(0.5, 9600, true, 1);
    Clip after = sine(0.4, 9600, true, 1);
    before.longest_frames = after.longest_frames = 9600;
    Stream stream;
    stream.playback.wanted = &before;
    stream.run(kPad + 4800);
    stream.playback.wanted = &after;
    stream.run(9600);
    CHECK(stream.playback.ended == 1);
    CHECK(loudest(stream.heard, kPad + 9600 + 241, stream.heard.size()) == 0.0);
}

TEST_CASE("playback: a change while the level still rises goes on from there, and does not jump") {
    const Clip before = sine(0.5, 9600, true, 1);
    const Clip after = sine(0.6, 9600, true, 1);
    Stream stream;
    stream.playback.level = 0.1F;
    stream.playback.wanted = &before;
    stream.run(kPad + 9600);
    stream.playback.level = 1.0F;
    stream.run(960);  // 20 ms of 180
    stream.playback.wanted = &after;
    const std::size_t at = stream.heard.size();
    stream.run(14'400);
    // No more than 1 / kRiseS a second, all the way.
    for (std::size_t n = at; n < stream.heard.size(); n += 480) {
        const double most = 0.1 + static_cast<double>(n + 480 - at + 960) / kRateHz / kRiseS;
        REQUIRE(loudest(stream.heard, n, n + 480) <= 0.6 * most);
    }
    CHECK(std::abs(loudest(stream.heard, stream.heard.size() - 960, stream.heard.size()) - 0.6) <
          1e-3);
}

TEST_CASE("playback: a change to a drive that bears less is held to that from its first frame") {
    const Clip before = sine(0.5, 9600, true, 1);
    Clip after = sine(0.5, 9600, true, 1);
    after.largest_level = 0.2F;
    Stream stream;
    stream.playback.wanted = &before;
    stream.run(kPad + 4800);
    stream.playback.wanted = &after;
    const std::size_t at = stream.heard.size();
    stream.run(9600);
    CHECK(loudest(stream.heard, at + kCross + 1, stream.heard.size()) <= 0.1 + 1e-6);
    CHECK(notes_of(stream.playback, 1).clipped);
}

}  // namespace playback_change_test
