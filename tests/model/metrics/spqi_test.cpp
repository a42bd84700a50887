// Numbers from the design page's worked examples, met by tests/golden/make_metrics.py as well.
#include "model/metrics/spqi.h"

#include "tests/support/golden.h"
#include "tests/support/tones.h"

namespace spqi_test {

using namespace tact;

namespace {

double score(const Waveform& reference, const Waveform& other, const SpqiParams& params = {}) {
    return spqi(spqi_blocks(reference, params), spqi_blocks(other, params), params);
}

const Waveform kReference{8000.0, {.3, -.1, .4, .1, -.5, .9, -.2, .6}};
const Waveform kDistorted{8000.0, {.2, -.1, .5, 0, -.5, .7, -.2, .6}};

Waveform second_of(double f_hz, double amplitude_g = 1.0) {
    return tone(f_hz, 8000.0, 8000, amplitude_g);
}

}  // namespace

TEST_CASE("SPQI: two blocks of four samples, both ways") {
    SpqiParams tiny;
    tiny.spectrum.block_samples = 4;
    const auto errors_db =
        spqi_errors_db(spqi_blocks(kReference, tiny), spqi_blocks(kDistorted, tiny));
    REQUIRE(errors_db.size() == 2);
    CHECK(std::abs(errors_db[0] + 5.762527276223) <= 5e-13);
    CHECK(std::abs(errors_db[1] + 3.590219430796) <= 5e-13);
    CHECK(std::abs(score(kReference, kDistorted, tiny) - 0.251984373133486) <= 1e-14);
    CHECK(std::abs(score(kDistorted, kReference, tiny) - 0.120302686163423) <= 1e-14);
}

TEST_CASE("SPQI: tones of 1 s, strongly unlike in its two directions") {
    CHECK(std::abs(score(second_of(70.0), second_of(70.0, 0.5)) - 0.0373136811084) <= 5e-13);
    CHECK(std::abs(score(second_of(70.0, 0.5), second_of(70.0)) - 0.0010449637967) <= 5e-13);
    const Waveform modulated = product(second_of(4.0), second_of(70.0));
    CHECK(std::abs(score(second_of(70.0), modulated) - 0.0749271645587) <= 5e-13);
    CHECK(std::abs(score(second_of(70.0), second_of(210.0)) - 1.866e-8) <= 5e-12);
    CHECK(std::abs(score(second_of(210.0), second_of(70.0)) - 0.017904) <= 5e-7);
}

TEST_CASE("SPQI: the score falls with the error as the table says") {
    // A reference of one block of one line: another with power 1 + e times as large errs by e.
    SpqiParams params;
    params.spectrum.block_samples = 1;
    const std::vector<std::pair<double, double>> printed{
        {-40.0, 1.0000}, {-20.0, 0.99966}, {-10.0, 0.88080}, {-20.0 / 3.0, 0.5}, {-5.0, 0.26894},
        {0.0, 0.017986}, {3.0, 0.0030184}, {10.0, 4.54e-5},  {30.0, 2.8e-10}};
    for (const auto& [error_db, expected] : printed) {
        const double power = 1.0 + std::pow(10.0, error_db / 10.0);
        const double found = score({8000.0, {1.0}}, {8000.0, {std::sqrt(power)}}, params);
        CAPTURE(error_db);
        CHECK(std::abs(found - expected) <= 5e-3 * expected);  // two digits are printed of some
    }
}

TEST_CASE("SPQI: 1 with itself and turned around, and scaling both changes nothing") {
    const Waveform x = golden::noise(1, 2000, 1.0);
    const Waveform y = golden::noise(2, 2000, 1.0);
    CHECK(score(x, x) == 1.0);
    CHECK(score(x, mixed(-1.0, x, 0.0, x)) == 1.0);
    const double once = score(x, y);
    CHECK(once > 0.0);
    CHECK(std::abs(score(mixed(4.0, x, 0.0, x), mixed(4.0, y, 0.0, y)) / once - 1.0) <= 1e-9);
}

TEST_CASE("SPQI: silence passes for silence, errs by all of a sound, and has no sound in it") {
    const Waveform silence{8000.0, std::vector<double>(1024, 0.0)};
    const Waveform sound = tone(70.0, 8000.0, 1024);
    CHECK(score(silence, silence) == 1.0);
    CHECK(std::abs(score(sound, silence) - 0.017986) <= 5e-7);
    CHECK(score(silence, sound) >= 0.0);
    CHECK(score(silence, sound) <= 1e-60);
}

TEST_CASE("SPQI: as errors in dB, equal ones are 0 and the worst 120 apart") {
    SpqiParams in_db;
    in_db.distance = SpqiDistance::error_db;
    const Waveform silence{8000.0, std::vector<double>(1024, 0.0)};
    const Waveform sound = tone(70.0, 8000.0, 1024);
    const auto apart = [&](const Waveform& x, const Waveform& y) {
        return spqi_distance(spqi_blocks(x, in_db), spqi_blocks(y, in_db), in_db);
    };
    CHECK(apart(sound, sound) == 0.0);
    CHECK(apart(silence, sound) == 120.0);
    CHECK(std::abs(apart(sound, silence) - 60.0) <= 1e-9);
}

}  // namespace spqi_test
