// From the signal to the file, with a sensor that hears 0.5 g per full scale at any frequency.

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "devices/calibration/calibration_file.h"
#include "model/common/random.h"
#include "model/io/recordings/wave_file.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace calibrate_command_test {

using namespace tact;

TEST_CASE("calibrate: the recording of its own signal gives the response, in a file of its own" *
          doctest::test_suite("long")) {
    const TemporaryFolder folder;
    const auto signal = folder.path / "signal.wav";
    const auto heard = folder.path / "heard.wav";
    const auto table = folder.path / "coil.json";
    for (const bool sweep : {false, true}) {
        std::vector<std::string> write{"calibrate", "--signal", signal.string()};
        std::vector<std::string> read{
            "calibrate", "--recording", heard.string(), "--out", table.string(),
            "--device",  "a card",      "--channel",    "3",     "--actuator",
            "coil",      "--rms-limit", "0.4"};
        if (sweep) write.push_back("--sweep");
        if (sweep) read.push_back("--sweep");
        REQUIRE(run_program(write).exit_code == 0);
        auto played = read_wave_file(signal);
        REQUIRE(played);
        Waveform& waveform = played->waveform;
        waveform.samples_g.insert(waveform.samples_g.begin(), 3210, 0.0);
        waveform.samples_g.insert(waveform.samples_g.end(), 2000, 0.0);
        for (double& sample : waveform.samples_g) sample *= 0.5;
        REQUIRE(write_wave_file(heard, waveform));
        const Ran ran = run_program(read);
        REQUIRE(ran.exit_code == 0);
        CHECK(ran.out.find("g per full scale") != std::string::npos);
        const auto calibration = read_calibration(table);
        REQUIRE(calibration);
        CHECK(calibration->device == "a card");
        CHECK(calibration->channel == 3);
        CHECK(calibration->rms_limit == 0.4);
        REQUIRE(calibration->points.size() == 29);
        for (const ResponsePoint& point : calibration->points) {
            CHECK(std::abs(point.g_per_full_scale / 0.5 - 1.0) < 1e-3);
        }
    }
}

TEST_CASE("calibrate: tones that noise hides are left out, and said to be, on screen and in JSON" *
          doctest::test_suite("long")) {
    const TemporaryFolder folder;
    const auto signal = folder.path / "signal.wav";
    const auto heard = folder.path / "heard.wav";
    REQUIRE(run_program({"calibrate", "--signal", signal.string()}).exit_code == 0);
    auto played = read_wave_file(signal);
    REQUIRE(played);
    Waveform& waveform = played->waveform;
    waveform.samples_g.insert(waveform.samples_g.end(), 5000, 0.0);
    RandomStream random{7};
    // 0.1 g rms: 0.05 g of the weakest tones, 0.2 s long, are then known to 7 % or so.
    for (double& sample : waveform.samples_g) sample = 0.5 * sample + 0.1 * next_normal(random);
    REQUIRE(write_wave_file(heard, waveform));
    const Ran ran = run_program({"calibrate", "--recording", heard.string(), "--json"});
    REQUIRE(ran.exit_code == 0);
    const auto json = nlohmann::json::parse(ran.out);
    int refused = 0;
    for (const auto& tone : json.at("tones")) {
        const bool is_good = tone.at("thd") < 0.1 && tone.at("standard_error") < 0.03;
        CHECK(tone.at("accepted") == is_good);
        refused += is_good ? 0 : 1;
    }
    CHECK(refused >= 20);
    const std::string words =
        std::to_string(refused) +
        " of 87 tones were left out: 10 % of harmonic distortion or more, or so much noise that "
        "the standard error of the amplitude is 3 % or more";
    CHECK(contains(ran.err, "tactspace: " + words + "\n"));
    CHECK(json.at("remarks").at(0) == words);
    for (const auto& remark : json.at("remarks")) {
        CHECK(contains(ran.err, "tactspace: " + remark.get<std::string>() + "\n"));
    }
    CHECK(json.at("points").size() >= 28);
}

TEST_CASE("calibrate: what cannot be is refused in a sentence") {
    const TemporaryFolder folder;
    CHECK(run_program({"calibrate"}).exit_code == 2);
    CHECK(run_program({"calibrate", "--signal", "a.wav", "--recording", "b.wav"}).exit_code == 2);
    CHECK(run_program({"calibrate", "--signal", "a.wav", "--out", "b.json"}).exit_code == 2);
    const auto signal = folder.path / "signal.wav";
    CHECK(contains(
        refusal_of({"calibrate", "--signal", signal.string(), "--low", "400", "--high", "300"}),
        "--high"));
    std::vector<double> other(5000, 0.1);
    other.back() = 0.0;  // all alike would be silence
    REQUIRE(write_wave_file(signal, {kModelRateHz, other}));
    CHECK(contains(refusal_of({"calibrate", "--recording", signal.string(), "--scale", "1"}),
                   "whole calibration signal"));
}

}  // namespace calibrate_command_test
