#include "model/sound/from_sound.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <thread>

#include "model/pattern/drawn_fault.h"
#include "model/signal/waveform.h"

namespace sound_pattern_test {

using namespace tact;

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

Waveform silence(double seconds) {
    return {kModelRateHz, std::vector<double>(sample_count(seconds, kModelRateHz), 0.0)};
}

Waveform noise(double seconds, unsigned seed) {
    Waveform sound = silence(seconds);
    std::mt19937 random(seed);
    for (double& x : sound.samples_g) x = static_cast<double>(random()) / 2147483648.0 - 1.0;
    return sound;
}

// Notes of one carrier, and accents between and over them.
Pattern random_pattern(std::mt19937& random) {
    const auto between = [&random](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / 4294967295.0;
    };
    Pattern pattern;
    pattern.duration_s = between(1.0, 3.0);
    pattern.amplitude_g = between(0.2, 1.0);
    pattern.carriers[0].frequency_hz = between(80.0, 280.0);
    pattern.carriers[0].phase_rad = between(0.0, 6.0);
    pattern.amplitude_curve = {{0.0, 0.0}};
    for (double t = 0.15; t + 0.5 < pattern.duration_s; t += 0.5) {
        const double level = between(0.3, 1.0);
        const double end = t + between(0.12, 0.3);
        for (const AmplitudePoint point :
             {AmplitudePoint{t, 0.0}, {t, level}, {end, level}, {end, 0.0}}) {
            pattern.amplitude_curve.push_back(point);
        }
        pattern.transients.push_back({t + 0.37, between(0.4, 1.0) * pattern.amplitude_g,
                                      between(90.0, 250.0), between(0.02, 0.04)});
    }
    return pattern;
}

// sqrt(2) rms within 20 ms about a time.
double level_g(const Waveform& wave, double t_s) {
    const Waveform part = part_of(wave, t_s - 0.01, t_s + 0.01);
    return std::sqrt(2.0) * rms_g(part);
}

// Frequencies come of logarithms, whose last bits follow the gain.
bool same_but_for_rounding(Pattern a, const Pattern& b) {
    const auto take = [](double& mine, double theirs) {
        if (std::abs(mine - theirs) <= 1e-9 * theirs) mine = theirs;
    };
    if (a.frequency_curve.size() != b.frequency_curve.size()) return false;
    if (a.transients.size() != b.transients.size()) return false;
    take(a.carriers[0].frequency_hz, b.carriers[0].frequency_hz);
    for (std::size_t k = 0; k < a.frequency_curve.size(); ++k) {
        take(a.frequency_curve[k].frequency_hz, b.frequency_curve[k].frequency_hz);
    }
    for (std::size_t k = 0; k < a.transients.size(); ++k) {
        take(a.transients[k].frequency_hz, b.transients[k].frequency_hz);
    }
    return a == b;
}

}  // namespace

TEST_CASE("sound: a pattern written as sound comes back, with its notes and its accents") {
    std::mt19937 random(44);
    for (int round = 0; round < 30; ++round) {
        CAPTURE(round);
        const Pattern meant = random_pattern(random);
        const Waveform sound = render(meant);
        const SoundPattern made = pattern_of_sound(sound);
        const Pattern& got = made.pattern;
        CHECK(!drawn_fault(got));
        CHECK(std::abs(got.duration_s - meant.duration_s) <= 1e-4);
        CHECK(got.transients.size() == meant.transients.size());
        for (std::size_t k = 0; k < std::min(got.transients.size(), meant.transients.size()); ++k) {
            CAPTURE(k);
            const Transient& want = meant.transients[k];
            const Transient& have = got.transients[k];
            const double middle_off_s =
                have.time_s + 0.5 * have.duration_s - want.time_s - 0.5 * want.duration_s;
            CHECK(std::abs(middle_off_s) <= 0.003);
            CHECK(std::abs(have.time_s - want.time_s) <= 0.006);
            CHECK(std::abs(have.amplitude_g / want.amplitude_g - 1.0) <= 0.2);
            CHECK(std::abs(have.frequency_hz / want.frequency_hz - 1.0) <= 0.08);
        }
        const auto& curve = meant.amplitude_curve;
        for (std::size_t k = 1; k + 3 < curve.size(); k += 4) {
            const double middle_s = 0.5 * (curve[k].time_s + curve[k + 2].time_s);
            const double level = envelope_g(meant, middle_s);
            CHECK(std::abs(envelope_g(got, middle_s) / level - 1.0) <= 0.05);
            CHECK(std::abs(first_carrier_hz(got, middle_s) - first_carrier_hz(meant, middle_s)) <=
                  0.03 * first_carrier_hz(meant, middle_s));
            // The note begins and ends where it did: half of its level, within half a window.
            const double begin_s = curve[k].time_s;
            const double end_s = curve[k + 2].time_s;
            CHECK(envelope_g(got, begin_s - 0.013) <= 0.5 * level);
            CHECK(envelope_g(got, begin_s + 0.013) >= 0.5 * level);
            CHECK(envelope_g(got, end_s - 0.013) >= 0.5 * level);
            CHECK(envelope_g(got, end_s + 0.013) <= 0.5 * level);
        }
    }
}

TEST_CASE("sound: accents over a vibration are found, and the vibration below them stays") {
    Pattern meant;
    meant.amplitude_g = 0.5;
    meant.carriers[0].frequency_hz = 180.0;
    meant.duration_s = 2.0;
    meant.transients = {{0.4, 0.7, 120.0, 0.03}, {1.3, 0.6, 180.0, 0.025}};
    const SoundPattern made = pattern_of_sound(render(meant));
    REQUIRE(made.pattern.transients.size() == 2);
    for (std::size_t k = 0; k < 2; ++k) {
        CHECK(std::abs(made.pattern.transients[k].time_s - meant.transients[k].time_s) <= 0.008);
        CHECK(std::abs(made.pattern.transients[k].amplitude_g / meant.transients[k].amplitude_g -
                       1.0) <= 0.3);
    }
    for (double t = 0.05; t < 1.95; t += 0.01) {
        CHECK(std::abs(envelope_g(made.pattern, t) - 0.5) <= 0.075);  // 15 %, below accents
        CHECK(std::abs(first_carrier_hz(made.pattern, t) - 180.0) <= 4.0);
    }
}

TEST_CASE("sound: a sweep keeps its frequency within 3 %, over the joints of sections too") {
    for (const auto& [from_hz, to_hz] : {std::pair{80.0, 290.0}, {280.0, 90.0}}) {
        Pattern sweep;
        sweep.duration_s = 6.0;
        sweep.frequency_curve = {{0.0, from_hz}, {6.0, to_hz}};
        const SoundPattern made = pattern_of_sound(render(sweep));
        CHECK(made.pattern.transients.empty());
        for (double t = 0.05; t < 5.95; t += 0.01) {
            CAPTURE(t);
            const double meant_hz = first_carrier_hz(sweep, t);
            CHECK(std::abs(first_carrier_hz(made.pattern, t) - meant_hz) <= 0.03 * meant_hz);
            CHECK(std::abs(envelope_g(made.pattern, t) - 1.0) <= 0.08);
        }
    }
}

TEST_CASE("sound: clicks come back as accents whose middle is within 5 ms, and nothing else") {
    Waveform clicks = silence(4.0);
    const std::vector<double> at_s{0.2, 0.31, 1.0, 1.003 + 0.5, 2.9, 3.95};
    for (const double t : at_s) clicks.samples_g[sample_count(t, kModelRateHz)] = 1.0;
    const Pattern got = pattern_of_sound(clicks).pattern;
    REQUIRE(got.transients.size() == at_s.size());
    for (std::size_t k = 0; k < at_s.size(); ++k) {
        const Transient& accent = got.transients[k];
        CHECK(std::abs(accent.time_s + 0.5 * accent.duration_s - at_s[k]) <= 0.005);
        CHECK(accent.duration_s <= 0.02);
    }
    CHECK(got.amplitude_g == 0.0);
    CHECK(got.duration_s == 4.0);
}

TEST_CASE("sound: a gain of the sound is one of the pattern, and changes nothing else") {
    std::mt19937 random(7);
    for (int round = 0; round < 5; ++round) {
        const Waveform sound = render(random_pattern(random));
        const SoundPattern plain = pattern_of_sound(sound);
        for (const double gain : {0.25, 2.0, 8.0}) {  // powers of two: exact
            Pattern got = pattern_of_sound(with_gain(sound, gain)).pattern;
            got.amplitude_g /= gain;
            for (Transient& accent : got.transients) accent.amplitude_g /= gain;
            CHECK(same_but_for_rounding(got, plain.pattern));
            SoundOptions options;
            options.full_scale_g = gain;
            CHECK(pattern_of_sound(sound, options).pattern ==
                  pattern_of_sound(with_gain(sound, gain)).pattern);
        }
    }
}

TEST_CASE("sound: sections join without a jump, and silence stays silent") {
    Pattern drawn;
    drawn.duration_s = 5.0;
    drawn.carriers[0].frequency_hz = 150.0;
    drawn.amplitude_curve = {{0.0, 0.1}, {1.7, 1.0}, {2.4, 1.0}, {2.9, 0.0},
                             {3.6, 0.0}, {4.4, 0.8}, {5.0, 0.2}};
    const Pattern got = pattern_of_sound(render(drawn)).pattern;
    for (double t = 0.02; t < 4.98; t += 0.002) {
        CAPTURE(t);
        CHECK(std::abs(envelope_g(got, t + 0.002) - envelope_g(got, t)) <= 0.03);
        CHECK(std::abs(envelope_g(got, t) - envelope_g(drawn, t)) <= 0.05);
    }
    CHECK(level_g(render(got), 3.25) <= 0.005);
}

TEST_CASE("sound: silence and nothing give silence as long, one sample and a constant no fault") {
    for (const double seconds : {0.001, 0.5, 3.0}) {
        const SoundPattern made = pattern_of_sound(silence(seconds));
        CHECK(made.pattern.duration_s == doctest::Approx(seconds));
        CHECK(peak_g(render(made.pattern)) == 0.0);
        CHECK(made.outside_share == 0.0);
    }
    CHECK(!drawn_fault(pattern_of_sound({kModelRateHz, {}}).pattern));
    CHECK(!drawn_fault(pattern_of_sound({kModelRateHz, {0.5}}).pattern));
    CHECK(!drawn_fault(pattern_of_sound({kModelRateHz, std::vector<double>(7, 0.5)}).pattern));
    Waveform loud = silence(0.5);
    for (double& x : loud.samples_g) x = 0.5;
    CHECK(!drawn_fault(pattern_of_sound(loud).pattern));
}

TEST_CASE("sound: what lies outside of the band is not felt, and said") {
    Waveform both = silence(2.0);
    for (std::size_t n = 0; n < both.samples_g.size(); ++n) {
        const double t = static_cast<double>(n) / kModelRateHz;
        both.samples_g[n] = 0.5 * std::sin(kTurn * 150.0 * t) + 0.5 * std::sin(kTurn * 1000.0 * t);
    }
    const SoundPattern made = pattern_of_sound(both);
    CHECK(std::abs(made.outside_share - 0.5) <= 0.01);
    CHECK(std::abs(made.pattern.amplitude_g - 0.5) <= 0.05);
    CHECK(std::abs(made.pattern.carriers[0].frequency_hz - 150.0) <= 1.5);
    CHECK(words_of(made, {}).back() ==
          "50 % of the sound's energy lies outside of 65 to 300 Hz and is not felt");
}

TEST_CASE("sound: the frequencies are the actuator's, of a narrow one too") {
    const Waveform sound = noise(3.0, 5);
    for (const Range band : {Range{60.0, 60.0}, Range{55.0, 200.0}, Range{230.0, 240.0}}) {
        SoundOptions options;
        options.band_hz = band;
        const Pattern got = pattern_of_sound(sound, options).pattern;
        CHECK(!drawn_fault(got));
        CHECK(got.amplitude_g > 0.0);
        for (const FrequencyPoint& point : got.frequency_curve) {
            CHECK(band.contains(point.frequency_hz));
        }
        CHECK(band.contains(got.carriers[0].frequency_hz));
        for (const Transient& accent : got.transients) CHECK(band.contains(accent.frequency_hz));
    }
}

TEST_CASE("sound: a tremor is no row of accents, and accents may be left out") {
    Pattern tremor;
    tremor.modulation = {ModulationKind::am, 25.0, 1.0};
    tremor.duration_s = 2.0;
    CHECK(pattern_of_sound(render(tremor)).pattern.transients.empty());
    Waveform click = silence(1.0);
    click.samples_g[5000] = 1.0;
    SoundOptions none;
    none.accents = false;
    const Pattern got = pattern_of_sound(click, none).pattern;
    CHECK(got.transients.empty());
    CHECK(level_g(render(got), 0.5) > 0.0);
}

TEST_CASE("sound: noise keeps its level, and is told to be noise") {
    const SoundPattern made = pattern_of_sound(noise(4.0, 9));
    CHECK(made.other_share > 0.1);
    CHECK(made.outside_share > 0.9);
    const double ratio = rms_g(render(made.pattern)) / rms_g(made.felt);
    CHECK(ratio >= 0.85);
    CHECK(ratio <= 1.15);
}

TEST_CASE("sound: a minute has its points by sections, and any thread makes the same bits") {
    Waveform minute = noise(60.0, 3);
    for (std::size_t n = 0; n < minute.samples_g.size(); n += 7919) minute.samples_g[n] = 20.0;
    const Pattern alone = pattern_of_sound(minute).pattern;
    CHECK(!drawn_fault(alone));
    CHECK(alone.duration_s == 60.0);
    CHECK(alone.amplitude_curve.size() <= 60 * 60);
    CHECK(alone.amplitude_curve.size() > 1000);
    std::vector<Pattern> got(2);
    {
        std::vector<std::jthread> threads;
        for (Pattern& pattern : got) {
            threads.emplace_back([&] { pattern = pattern_of_sound(minute).pattern; });
        }
    }
    for (const Pattern& pattern : got) CHECK(pattern == alone);
}

}  // namespace sound_pattern_test
