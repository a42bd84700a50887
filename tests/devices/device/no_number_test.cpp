// What is no number, at every door of what plays: it must come out as silence.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "devices/audio/audio_stream.h"
#include "devices/device/drive.h"
#include "devices/device/playback.h"

namespace no_number_test {

using namespace tact;

namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kTiny = std::numeric_limits<float>::denorm_min();

Clip constant(float value, float peak) {
    Clip clip;
    clip.samples.assign(4800, value);
    clip.peak = peak;
    clip.serial = 1;
    return clip;
}

// The loudest of a quarter of a second of it; NaN if any frame is NaN.
float loudest(const Clip& clip, float level, float later_level) {
    Playback playback;
    playback.level = level;
    playback.wanted = &clip;
    std::vector<float> buffer(240);
    float most = 0.0F;
    for (int call = 0; call < 50; ++call) {
        if (call == 25) playback.level = later_level;
        render(playback, buffer.data(), 240, 0.005 * call);
        for (const float sample : buffer) {
            if (!std::isfinite(sample)) return kNan;
            most = std::max(most, std::abs(sample));
        }
    }
    const float told = playback.peak;
    return std::isfinite(told) ? most : kNan;
}

}  // namespace

TEST_CASE("no number: as a level it is silence, from the start and in the middle of a play") {
    const Clip clip = constant(0.5F, 0.5F);
    for (const float level : {kNan, -kNan, -kInf, -1.0F, -0.0F}) {
        CAPTURE(level);
        CHECK(loudest(clip, level, level) == 0.0F);
        CHECK(loudest(clip, 0.2F, level) <= 0.1F);  // nothing louder than before
    }
    CHECK(loudest(clip, kInf, kInf) == 0.5F);  // as any level above 1
    CHECK(loudest(clip, kTiny, kTiny) == 0.0F);
}

TEST_CASE("no number: a silent clip, and one that claims an impossible peak, stay finite") {
    for (const float level : {0.0F, 1.0F, kNan, kInf}) {
        for (const float peak : {0.0F, kNan, kInf, -kInf, kTiny}) {
            CAPTURE(level);
            CAPTURE(peak);
            CHECK(loudest(constant(0.0F, peak), level, level) == 0.0F);
            CHECK(loudest(constant(0.5F, peak), level, level) <= 0.5F);
        }
    }
}

TEST_CASE("no number: samples of it are silence, and none that lies about its peak passes 0.8") {
    for (const float sample : {kNan, kInf, -kInf}) {
        CHECK(loudest(constant(sample, 0.5F), 1.0F, 1.0F) == 0.0F);
    }
    CHECK(loudest(constant(3.0F, 0.5F), 1.0F, 1.0F) == 0.8F);
    CHECK(loudest(constant(-3e38F, 0.0F), 1.0F, 1.0F) == 0.8F);
    CHECK(loudest(constant(kTiny, kTiny), 1.0F, 1.0F) == 0.0F);
}

TEST_CASE("no number: a largest level or a longest time of it is no limit, and no danger") {
    Clip clip = constant(0.5F, 0.5F);
    clip.largest_level = kNan;
    CHECK(loudest(clip, 1.0F, 1.0F) == 0.5F);
    clip.largest_level = -kInf;
    CHECK(loudest(clip, 1.0F, 1.0F) == 0.0F);
    Drive drive{kModelRateHz, std::vector<double>(1000, 0.5)};
    drive.longest_s = std::numeric_limits<double>::quiet_NaN();
    CHECK(clip_of(drive, 48e3, false).longest_frames == std::numeric_limits<std::uint64_t>::max());
}

TEST_CASE("no number: a drive of it, or of numbers beyond sense, is a clip of numbers") {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e308, -1e308, 5e-324}) {
        for (const bool loop : {false, true}) {
            Drive drive{kModelRateHz, std::vector<double>(1000, 0.1)};
            drive.samples[500] = bad;
            drive.samples[501] = -bad;
            const Clip clip = clip_of(drive, 48e3, loop);
            CHECK(std::isfinite(clip.peak));
            for (const float sample : clip.samples) REQUIRE(std::isfinite(sample));
            CHECK(loudest(clip, 1.0F, 1.0F) <= 0.8F);
        }
    }
    const Drive silent{kModelRateHz, std::vector<double>(1000, -0.0)};
    CHECK(clip_of(silent, 48e3, false).peak == 0.0F);
}

TEST_CASE("no number: an output's level of it is 0") {
    CHECK(kept_level(std::numeric_limits<double>::quiet_NaN()) == 0.0);
    CHECK(kept_level(-std::numeric_limits<double>::infinity()) == 0.0);
    CHECK(kept_level(std::numeric_limits<double>::infinity()) == 1.0);
    CHECK(kept_level(-0.0) == 0.0);
    CHECK(kept_level(0.3) == 0.3);
}

}  // namespace no_number_test
