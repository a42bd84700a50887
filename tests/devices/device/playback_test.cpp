#include "devices/device/playback.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/playback_stream.h"

namespace playback_test {

using namespace tact;
using namespace tact::playback_stream;

TEST_CASE("playback: after 100 ms of silence a clip comes out whole, on its own channel only") {
    const Clip clip = sine(0.5, 9600, false, 1);
    Stream stream;
    stream.playback.wanted = &clip;
    stream.run(20'000);
    REQUIRE(loudest(stream.heard, 0, kPad) == 0.0);
    for (std::size_t n = 0; n < clip.samples.size(); ++n) {
        REQUIRE(stream.heard[kPad + n] == clip.samples[n]);
    }
    CHECK(loudest(stream.heard, kPad + clip.samples.size(), 20'000) == 0.0);
    CHECK(stream.elsewhere == 0.0F);
    CHECK(stream.playback.begun == 1);
    CHECK(stream.playback.ended == 1);
    CHECK(stream.playback.peak == doctest::Approx(0.5));
    CHECK_FALSE(notes_of(stream.playback, 1).clipped);
}

TEST_CASE("playback: how the sound is cut into blocks does not change a sample") {
    const Clip clip = sine(0.5, 7000, true, 1);
    Stream fine;
    Stream coarse;
    fine.playback.wanted = &clip;
    coarse.playback.wanted = &clip;
    fine.run(30'000, 7);
    coarse.run(30'000, 4096);
    CHECK(fine.heard == coarse.heard);
}

TEST_CASE("playback: a loop has no seam") {
    const Clip clip = sine(0.5, 3200, true, 1);  // ten periods
    Stream stream;
    stream.playback.wanted = &clip;
    stream.run(kPad + 20 * 3200);
    for (std::size_t n = 0; n < 20 * 3200; ++n) {
        REQUIRE(stream.heard[kPad + n] == clip.samples[n % 3200]);
    }
    CHECK(stream.playback.ended == 0);
}

TEST_CASE("playback: a stop fades within 5 ms, without a jump, and then nothing sounds") {
    const Clip clip = sine(0.5, 48'000, true, 1);
    Stream stream;
    stream.playback.wanted = &clip;
    stream.run(kPad + 4880);
    stream.playback.wanted = nullptr;
    stream.run(4800);
    CHECK(loudest(stream.heard, kPad + 4880 + 241, stream.heard.size()) == 0.0);
    // A sine of 150 Hz steps by 1 % of its amplitude from one frame to the next, a fade adds 0.5 %.
    for (std::size_t n = kPad + 4870; n < stream.heard.size(); ++n) {
        REQUIRE(std::abs(stream.heard[n] - stream.heard[n - 1]) < 0.5F * 0.026F);
    }
    CHECK(stream.playback.ended == 1);
    CHECK(stream.playback.quiet_frames >= 4800 - 480);
}

TEST_CASE("playback: a new clip lets the old one fade, and starts with its own first sample") {
    const Clip first = sine(0.5, 48'000, true, 1);
    Clip second;
    second.samples.assign(100, 0.25F);
    second.peak = 0.25F;
    second.serial = 2;
    Stream stream;
    stream.playback.wanted = &first;
    stream.run(kPad + 4880);
    stream.playback.wanted = &second;
    stream.run(4800);
    const auto start = std::find(stream.heard.begin() + kPad + 4880, stream.heard.end(), 0.25F);
    REQUIRE(start != stream.heard.end());
    CHECK(start - stream.heard.begin() <= static_cast<std::ptrdiff_t>(kPad + 4880 + 242));
    CHECK(std::count(start, stream.heard.end(), 0.25F) == 100);
    CHECK(stream.playback.ended == 2);
}

TEST_CASE("playback: the level scales every sample, and a new level is reached without a jump") {
    const Clip clip = sine(0.5, 48'000, true, 1);
    Stream stream;
    stream.playback.level = 0.1F;
    stream.playback.wanted = &clip;
    stream.run(kPad + 4800);
    for (std::size_t n = 0; n < 4800; ++n) {
        REQUIRE(stream.heard[kPad + n] == clip.samples[n] * 0.1F);
    }
    stream.playback.level = 1.0F;
    stream.run(14'400);
    // No more than 1 / kRiseS a second upwards: half-way after 0.1 s, there after 0.25.
    const std::size_t from = kPad + 4800;
    CHECK(loudest(stream.heard, from, from + 4800) <= 0.5 * (0.1 + 0.1 / kRiseS) + 1e-6);
    CHECK(loudest(stream.heard, from, from + 4800) >= 0.5 * 0.55);
    CHECK(std::abs(loudest(stream.heard, from + 12'000, from + 14'400) - 0.5) < 1e-4);
    stream.playback.level = 0.1F;
    stream.run(4800);
    // Downwards 1 % off after 10 ms, 1e-4 after 20.
    CHECK(loudest(stream.heard, from + 14'400 + 960, from + 19'200) < 0.05 + 1e-4);
}

TEST_CASE("playback: too loud a clip is turned down as a whole, and the clip light stays on") {
    const Clip clip = sine(2.0, 9600, false, 1);
    Stream stream;
    stream.playback.wanted = &clip;
    stream.run(20'000);
    CHECK(loudest(stream.heard, 0, 20'000) <= 0.8 + 1e-7);
    for (std::size_t n = 0; n < clip.samples.size(); ++n) {  // its shape is kept
        REQUIRE(std::abs(stream.heard[kPad + n] - 0.4F * clip.samples[n]) < 1e-6F);
    }
    CHECK(notes_of(stream.playback, 1).clipped);
    // A clip at a level that fits is unchanged.
    Stream quiet;
    quiet.playback.level = 0.4F;
    quiet.playback.wanted = &clip;
    quiet.run(20'000);
    CHECK_FALSE(notes_of(quiet.playback, 1).clipped);
}

TEST_CASE("playback: no sample is larger than the ceiling, whatever happens to the level") {
    const Clip clip = sine(3.0, 48'000, true, 1);
    Stream stream;
    stream.playback.wanted = &clip;
    for (const float level : {0.1F, 1.0F, 7.0F, 0.0F, -3.0F, 1.0F}) {
        stream.playback.level = level;
        stream.run(3000);
    }
    CHECK(loudest(stream.heard, 0, stream.heard.size()) <= 0.8 + 1e-7);
    CHECK(stream.playback.peak <= 0.8F);
}

TEST_CASE(
    "playback: the clip's start is told in the stream's own time, in a loop that of its round") {
    const Clip clip = sine(0.5, 9600, true, 1);
    Stream stream;
    stream.playback.wanted = &clip;
    stream.run(kPad + 2400);
    CHECK(std::abs(notes_of(stream.playback, 1).origin_s - 0.1) < 1e-9);
    CHECK(notes_of(stream.playback, 1).rounds == 0);
    stream.run(9600 + 240);  // the call that begins the next round tells it in the one after
    CHECK(std::abs(notes_of(stream.playback, 1).origin_s - 0.3) < 1e-9);
    CHECK(notes_of(stream.playback, 1).rounds == 1);
}

TEST_CASE("playback: an empty clip ends as it begins") {
    Clip nothing;
    nothing.serial = 5;
    Stream stream;
    stream.playback.wanted = &nothing;
    stream.run(kPad + 480);
    CHECK(stream.playback.ended == 5);
    CHECK(loudest(stream.heard, 0, stream.heard.size()) == 0.0);
}

TEST_CASE(
    "playback: what is for everywhere comes out of all channels alike, masking noise that is") {
    const Clip clip = sine(0.5, 2400, false, 1);
    Stream stream;
    stream.playback.layout.everywhere = true;
    stream.playback.wanted = &clip;
    std::vector<float> buffer(4 * (kPad + 2400));
    render(stream.playback, buffer.data(), kPad + 2400, 0.0);
    for (std::size_t n = 0; n < kPad + 2400; ++n) {
        const float wanted = n < kPad ? 0.0F : clip.samples[n - kPad];
        for (std::size_t channel = 0; channel < 4; ++channel) {
            REQUIRE(buffer[4 * n + channel] == wanted);
        }
    }
}

TEST_CASE(
    "playback: a stop cuts a stream that is far behind, and leaves a prompt or a silent one") {
    const Clip clip = sine(0.5, 48'000, false, 1);
    const auto stopped = [&](double latency_s, std::size_t sounded) {
        Stream stream;
        stream.playback.layout.latency_s = latency_s;
        if (sounded > 0) stream.playback.wanted = &clip;
        stream.run(kPad + sounded);
        stream.playback.wanted = nullptr;
        stream.playback.cut = Cut::asked;
        std::vector<float> buffer(4 * 240, 9.0F);
        const bool goes_on = render(stream.playback, buffer.data(), 240, 0.0);
        if (!goes_on) CHECK(loudest(buffer, 0, buffer.size()) == 0.0);
        CHECK((stream.playback.cut == Cut::done) == !goes_on);
        return !goes_on;
    };
    CHECK(stopped(0.1, 4800));
    CHECK(stopped(0.1, 48'000 + 2400));  // over, but still on its way
    CHECK_FALSE(stopped(0.1, 48'000 + 9600));
    CHECK_FALSE(stopped(0.1, 0));
    CHECK_FALSE(stopped(0.01, 4800));
}

TEST_CASE("playback: a stream that can take back what is on its way goes on in silence") {
    const Clip clip = sine(0.5, 48'000, true, 1);
    const Clip next = sine(0.5, 48'000, true, 2);
    Stream stream;
    stream.playback.layout.latency_s = 0.1;
    stream.playback.layout.takes_back = true;
    stream.playback.wanted = &clip;
    stream.run(kPad + 4800);
    stream.playback.wanted = nullptr;
    stream.playback.cut = Cut::asked;
    std::vector<float> buffer(4 * 240, 9.0F);
    CHECK_FALSE(render(stream.playback, buffer.data(), 240, 0.2));
    CHECK(stream.playback.cut == Cut::none);
    CHECK(stream.playback.ended == 1);
    const std::size_t at = stream.heard.size();
    stream.run(4800);
    CHECK(loudest(stream.heard, at, stream.heard.size()) == 0.0);
    stream.playback.wanted = &next;
    stream.run(4800);
    CHECK(loudest(stream.heard, at + 4800, stream.heard.size()) > 0.4);
}

TEST_CASE("playback: a level beyond what the actuator bears counts as the largest it does") {
    Clip clip = sine(0.5, 9600, false, 1);
    clip.largest_level = 0.25F;
    Stream stream;
    stream.playback.wanted = &clip;
    stream.run(20'000);
    for (std::size_t n = 0; n < clip.samples.size(); ++n) {
        REQUIRE(stream.heard[kPad + n] == 0.25F * clip.samples[n]);
    }
    CHECK(notes_of(stream.playback, 1).clipped);
    Stream quiet;
    quiet.playback.level = 0.2F;
    quiet.playback.wanted = &clip;
    quiet.run(20'000);
    CHECK_FALSE(notes_of(quiet.playback, 1).clipped);
    CHECK(loudest(quiet.heard, 0, 20'000) > 0.0999);
}

TEST_CASE("playback: a loop that may play for 100 ms fades then, and has ended") {
    Clip clip = sine(0.5, 3200, true, 1);
    clip.longest_frames = 4800;
    Stream stream;
    stream.playback.wanted = &clip;
    stream.run(kPad + 24'000);
    CHECK(loudest(stream.heard, kPad + 4500, kPad + 4800) > 0.49);
    CHECK(loudest(stream.heard, kPad + 4800 + 241, stream.heard.size()) == 0.0);
    CHECK(stream.playback.ended == 1);
}

}  // namespace playback_test
