// What lies between the signals of a stream: rests that were asked for, and gaps that were not.
#include "devices/device/playback.h"

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "devices/device/protection.h"
#include "tests/support/playback_stream.h"

namespace playback_gaps_test {

using namespace tact;
using namespace tact::playback_stream;

TEST_CASE("playback: gaps are counted while a clip sounds, and not in silence") {
    const Clip clip = sine(0.5, 48'000, true, 1);
    Stream stream;
    std::vector<float> buffer(4 * 240);
    render(stream.playback, buffer.data(), 240, 0.0, true);
    CHECK(notes_of(stream.playback, 1).dropouts == 0);
    stream.playback.wanted = &clip;
    stream.run(2 * kPad);
    render(stream.playback, buffer.data(), 240, 0.0, true);
    CHECK(notes_of(stream.playback, 1).dropouts == 1);
}

TEST_CASE("playback: gaps belong to the play they are in, and the next one starts without any") {
    const Clip first = sine(0.5, 4800, false, 1);
    const Clip second = sine(0.5, 4800, false, 2);
    Stream stream;
    std::vector<float> buffer(4 * 240);
    stream.playback.wanted = &first;
    stream.run(kPad + 2400);
    render(stream.playback, buffer.data(), 240, 1.0, true);
    render(stream.playback, buffer.data(), 240, 1.005, true);
    CHECK(notes_of(stream.playback, 1).dropouts == 2);
    stream.playback.wanted = &second;
    for (int call = 2; call < 50; ++call)
        render(stream.playback, buffer.data(), 240, 1.0 + 0.005 * call);
    CHECK(stream.playback.ended == 2);
    CHECK(notes_of(stream.playback, 2).dropouts == 0);
    CHECK(notes_of(stream.playback, 1).dropouts == 2);
}

TEST_CASE(
    "playback: one that waits begins to the frame where it was told to, and cuts nothing off") {
    const Clip first = sine(0.5, 4800, false, 1);
    for (const std::int64_t rest : {0, 1, 960, 24'000}) {
        CAPTURE(rest);
        Clip second = sine(0.25, 2400, false, 2);
        second.samples.front() = 0.125F;
        second.waits = true;
        second.rest_frames = rest;
        Stream stream;
        stream.playback.wanted = &first;
        stream.run(kPad + 480);
        stream.playback.wanted = &second;
        stream.run(48'000);
        for (std::size_t n = 0; n < first.samples.size(); ++n) {
            REQUIRE(stream.heard[kPad + n] == first.samples[n]);
        }
        const std::size_t begin = kPad + 4800 + static_cast<std::size_t>(rest);
        CHECK(loudest(stream.heard, kPad + 4800, begin) == 0.0);
        CHECK(stream.heard[begin] == 0.125F);
        CHECK(stream.playback.ended == 2);
    }
}

TEST_CASE("playback: between two signals lies the rest that was asked for, however short") {
    const Drive pulse{kModelRateHz, std::vector<double>(1000, 0.4)};
    Clip first = clip_of(pulse, kRateHz, false);
    first.serial = 1;
    for (const double rest_s : {0.0, 0.004, 0.02, 0.5}) {
        CAPTURE(rest_s);
        Clip second = clip_after(pulse, kRateHz, rest_s, first);
        second.serial = 2;
        Stream stream;
        stream.playback.wanted = &first;
        stream.run(kPad + 480);
        stream.playback.wanted = &second;
        stream.run(48'000);
        const double apart_s = notes_of(stream.playback, 2).origin_s + second.lead_s -
                               notes_of(stream.playback, 1).origin_s - first.lead_s;
        CHECK(std::abs(apart_s - 0.1 - rest_s) < 1.5 / kRateHz);
    }
}

TEST_CASE("playback: a drive that was widened begins its signal as late as any in a sequence") {
    const Drive pulse{kModelRateHz, std::vector<double>(1000, 0.4)};
    const Drive longer{kModelRateHz, std::vector<double>(3000, 0.4)};
    const Drive wide = protected_drive(pulse, false, true).drive;
    REQUIRE(wide.lead_s > 0.05);
    REQUIRE(wide.tail_s == wide.lead_s);
    for (const bool is_wide_first : {false, true}) {
        for (const double rest_s : {0.0, 0.05, 0.15, 0.5}) {
            CAPTURE(is_wide_first);
            CAPTURE(rest_s);
            Clip first = clip_of(is_wide_first ? wide : longer, kRateHz, false);
            first.serial = 1;
            Clip second = clip_after(wide, kRateHz, rest_s, first);
            second.serial = 2;
            Stream stream;
            stream.playback.wanted = &first;
            stream.run(kPad + 240);
            stream.playback.wanted = &second;
            stream.run(72'000);
            const double apart_s = notes_of(stream.playback, 2).origin_s + second.lead_s -
                                   notes_of(stream.playback, 1).origin_s - first.lead_s;
            const double signal_s = is_wide_first ? 0.1 : 0.3;
            CHECK(std::abs(apart_s - signal_s - rest_s) < 1e-4);
            // Nothing of either is lost: the two sound at once where they have to.
            double sum = 0.0;
            double expected = 0.0;
            for (const float sample : stream.heard) sum += static_cast<double>(sample);
            for (const float sample : first.samples) expected += static_cast<double>(sample);
            for (const float sample : clip_of(wide, kRateHz, false).samples) {
                expected += static_cast<double>(sample);
            }
            CHECK(std::abs(sum - expected) < 0.5);
        }
    }
}

TEST_CASE("playback: when the end is heard is told, of a loop that is over its time too") {
    Clip clip = sine(0.5, 3200, true, 1);
    clip.longest_frames = 4800;
    Stream stream;
    stream.playback.wanted = &clip;
    stream.run(kPad + 24'000);
    CHECK(stream.playback.ended == 1);
    // 0.1 s of silence, 0.1 s of the loop, and the fade.
    CHECK(std::abs(notes_of(stream.playback, 1).end_s - 0.2 - kRampS) < 1e-3);
}

}  // namespace playback_gaps_test
