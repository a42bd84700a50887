// What an actuator gets over time: laws over plays in turn, their pauses, changes and heat, each
// computed here again from what has left the stream.
#include "devices/device/ledger.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "devices/device/playback.h"
#include "model/signal/waveform.h"
#include "tests/support/one_channel.h"

namespace ledger_test {

using namespace tact;

namespace {

constexpr double kRateHz = 8000.0;
constexpr double kLimit = 0.1;

// A tone that an actuator with an rms limit may play over and over: as loud as that lets it.
Drive limited_tone(double f_hz, double duration_s) {
    Drive drive;
    drive.rms_limit = kLimit;
    for (std::size_t n = 0; n < sample_count(duration_s, drive.rate_hz); ++n) {
        const double t_s = static_cast<double>(n) / drive.rate_hz;
        drive.samples.push_back(0.75 * std::sin(2.0 * std::numbers::pi * f_hz * t_s));
    }
    drive.largest_level = kLimit * std::numbers::sqrt2 / 0.75;
    return drive;
}

// Silence, and a burst at its end that holds all that a second may: what follows finds no room.
Drive late_burst() {
    Drive drive = limited_tone(150.0, 1.0);
    std::fill_n(drive.samples.begin(), 7000, 0.0);
    drive.largest_level /= std::sqrt(0.3);
    return drive;
}

// Blocks of 5 ms.
struct Out : one_channel::Out {
    Out() : one_channel::Out(kRateHz, 40) {}
};

double rms(const std::vector<float>& samples, std::size_t from, std::size_t to) {
    double sum = 0.0;
    for (std::size_t n = from; n < std::min(to, samples.size()); ++n) {
        sum += static_cast<double>(samples[n]) * static_cast<double>(samples[n]);
    }
    return std::sqrt(sum / static_cast<double>(to - from));
}

double loudest_second(const std::vector<float>& samples) {
    const auto window = static_cast<std::size_t>(kRateHz);
    double most = 0.0;
    double sum = 0.0;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        sum += static_cast<double>(samples[n]) * static_cast<double>(samples[n]);
        if (n >= window) {
            const auto old = static_cast<double>(samples[n - window]);
            sum -= old * old;
        }
        most = std::max(most, sum);
    }
    return std::sqrt(most / kRateHz);
}

}  // namespace

TEST_CASE("ledger: plays in turn never have more in any second than a loop of them may") {
    for (const double length_s : {0.05, 0.3, 0.7, 1.3}) {
        for (const double pause_s : {0.0, 0.1, 0.5, 2.0}) {
            CAPTURE(length_s);
            CAPTURE(pause_s);
            Out out;
            for (int k = 0; k < 5; ++k) {
                out.play(limited_tone(150.0, length_s));
                const std::size_t at = out.left.size();
                out.run_to_its_end();
                // None is held back for the ones before it: all are as strong.
                CHECK(notes_of(out.playback, out.serial).kept >= 0.98F);
                const double strongest = std::ranges::max(std::vector<float>(
                    out.left.begin() + static_cast<std::ptrdiff_t>(at), out.left.end()));
                CHECK(strongest >= 0.98 * kLimit * std::numbers::sqrt2);
                out.run(pause_s);
            }
            CHECK(loudest_second(out.left) <= kLimit * 1.005);
        }
    }
}

TEST_CASE("ledger: unlike drives in turn keep to the limit, at whatever levels") {
    Out out;
    int k = 0;
    float kept = 1.0F;
    for (const double length_s : {0.4, 0.0, 0.1, 1.2, 0.0, 0.02, 0.6, 0.0, 0.0, 0.3, 0.9}) {
        out.playback.level = ++k % 3 == 0 ? 0.05F : 1.0F;
        out.play(length_s > 0.0 ? limited_tone(60.0 + 40.0 * k, length_s) : late_burst());
        out.run_to_its_end();
        kept = std::min(kept, notes_of(out.playback, out.serial).kept.load());
        out.run(0.013 * k);
        if (k % 2 == 0) out.run(0.4);
    }
    CHECK(kept < 0.5F);
    CHECK(loudest_second(out.left) <= kLimit * 1.005);
    CHECK(loudest_second(out.left) >= kLimit * 0.98);
}

TEST_CASE("ledger: two short plays in a row are no louder than one long one") {
    const auto heard_of = [](const std::vector<double>& lengths_s) {
        Out out;
        for (const double length_s : lengths_s) {
            out.play(limited_tone(150.0, length_s));
            out.run_to_its_end();
        }
        return loudest_second(out.left);
    };
    CHECK(heard_of({0.3, 0.3}) <= heard_of({0.6}) * 1.005);
    CHECK(heard_of({0.1, 0.1}) <= heard_of({0.2}) * 1.005);
    CHECK(heard_of({0.8, 0.8}) <= heard_of({1.6}) * 1.005);
}

TEST_CASE("ledger: what finds no room is turned down, told, and back when a second has passed") {
    Out out;
    out.play(late_burst());
    out.run_to_its_end();
    const std::size_t at = out.left.size();
    out.play(limited_tone(150.0, 2.0));
    out.run_to_its_end();
    CHECK(notes_of(out.playback, 2).kept < 0.1F);
    CHECK(notes_of(out.playback, 2).clipped);
    CHECK(rms(out.left, at, at + 4000) < 0.2 * kLimit);
    CHECK(std::abs(rms(out.left, at + 10'000, at + 14'000) / kLimit - 1.0) < 0.01);
    CHECK(loudest_second(out.left) <= kLimit * 1.005);
    // No step on the way: a fifth of a second from nothing to all, and the tone's own.
    for (std::size_t n = at; n < out.left.size(); ++n) {
        REQUIRE(std::abs(out.left[n] - out.left[n - 1]) < 0.15F * 0.12F + 0.01F);
    }
}

TEST_CASE("ledger: a changed loop keeps to the new drive's limits at once, and comes back") {
    Drive free = limited_tone(150.0, 0.5);
    free.rms_limit = 0.0;
    free.largest_level = 1.0;
    Out out;
    out.play(free, true);
    out.run(2.0);
    CHECK(rms(out.left, out.left.size() - 4000, out.left.size()) > 0.5);
    const Drive limited = limited_tone(150.0, 0.5);
    out.change(limited);
    const std::size_t at = out.left.size();
    out.run(3.0);
    // From the end of the cross-fade on.
    const auto crossed = at + static_cast<std::size_t>(kCrossS * kRateHz) + 1;
    float peak = 0.0F;
    for (std::size_t n = crossed; n < out.left.size(); ++n) {
        peak = std::max(peak, std::abs(out.left[n]));
    }
    CHECK(peak <= 0.75 * limited.largest_level * 1.001);
    CHECK(rms(out.left, crossed, crossed + 4000) <= kLimit);
    CHECK(std::abs(rms(out.left, out.left.size() - 8000, out.left.size()) / kLimit - 1.0) < 0.01);
}

TEST_CASE("ledger: an edit of a loop at its limit is not held back for what that was before") {
    Out out;
    out.play(limited_tone(150.0, 0.5), true);
    out.run(3.0);
    out.change(limited_tone(150.0, 0.5));
    out.run(0.5);
    CHECK(notes_of(out.playback, 1).kept >= 0.98F);
}

TEST_CASE("ledger: what plays on and off gets as warm as a loop does, and rests as long") {
    Drive drive = limited_tone(150.0, 0.2);
    drive.rms_limit = 0.0;
    drive.rest_after_s = 1.0;
    Out out;
    double driven_s = 0.0;
    int plays = 0;
    for (; plays < 20; ++plays) {
        out.play(drive);
        out.run_to_its_end();
        driven_s += 0.22;  // with the margins of a clip
        if (notes_of(out.playback, out.serial).is_warm) break;
        out.run(0.05);
        driven_s -= 0.05;
    }
    CHECK(plays == 5);  // 0.17 s more with each
    CHECK(std::abs(driven_s - 1.0) <= 0.23);
    out.run(0.1);
    out.play(drive);
    out.run_to_its_end();
    CHECK(notes_of(out.playback, out.serial).is_warm);  // not yet
    out.run(1.0);
    out.play(drive);
    out.run_to_its_end();
    CHECK_FALSE(notes_of(out.playback, out.serial).is_warm);
    CHECK(words_on_held(1.0, true).find("needs a rest") != std::string::npos);
    CHECK(words_on_held(0.5, false).find("held back to 50 % of its level") != std::string::npos);
    CHECK(words_on_held(1.0, false).empty());
}

TEST_CASE("ledger: a rest that nobody counted sample by sample forgets a second, and no more") {
    Ledger ledger;
    for (int n = 0; n < 8000; ++n) note(ledger, 0.1, 1.0 / 8000.0, true);
    const Clip clip = clip_of(limited_tone(150.0, 0.5), kRateHz, false);
    CHECK(allowed_level(ledger, clip.load, 0.0, false, kLimit) < 0.3);
    Ledger rested = ledger;
    note_rest(rested, 0.5);
    const double half = allowed_level(rested, clip.load, 0.0, false, kLimit);
    CHECK(half > 0.15);
    CHECK(half < 1.0);
    CHECK(std::abs(left_s(rested, 2.0) - 1.5) < 0.01);
    note_rest(rested, 0.6);
    CHECK(allowed_level(rested, clip.load, 0.0, false, kLimit) >= half);
    note_rest(rested, 10.0);
    CHECK(allowed_level(rested, clip.load, 0.0, false, kLimit) == 1.0);
    CHECK(left_s(rested, 2.0) == 2.0);
    CHECK(allowed_level(ledger, clip.load, 0.0, false, 0.0) == 1.0);
}

}  // namespace ledger_test
