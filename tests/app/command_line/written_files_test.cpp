// The files that `render` and `stages` write: what is in them, and that it is the model's.
#include "app/command_line/command_line.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/support/bundled_sets.h"
#include "tests/support/five_patterns.h"

namespace written_files_test {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using tact::ShortSet;

namespace {

// Sums of a column, by the text of another.
std::map<std::string, double> sums(const std::vector<std::vector<std::string>>& rows,
                                   std::size_t by, std::size_t column) {
    std::map<std::string, double> sums;
    for (const auto& row : rows) sums[row.at(by)] += std::stod(row.at(column));
    return sums;
}

}  // namespace

TEST_CASE("render: text files give the bitwise same predictions as the set they are of") {
    const ShortSet set;
    const Rendered text(set.path, "txt");
    for (const std::string metric : {"pm", "nc", "oc"}) {
        CHECK(output_of({"predict", text.path, "--metric", metric}) ==
              output_of({"predict", set.path, "--metric", metric}));
    }
}

TEST_CASE("render: WAV files give the set's matrix, with their scale beside them") {
    const ShortSet set;
    const Rendered wave(set.path, "wav");
    const Ran ran = run_program({"predict", wave.path});
    CHECK(ran.out == output_of({"predict", set.path}));
    CHECK(ran.err == "");  // no guess at the scale: the sidecars say it
}

TEST_CASE("render: CSV rows are the time and the sample of the text file") {
    const Rendered csv(kAmSet, "csv");
    const Rendered text(kAmSet, "txt");
    CHECK(bytes_of(csv.folder.path / "AM-5.csv").starts_with("time_s,acceleration_g\n0,"));
    const auto rows = rows_of(csv.folder.path / "AM-5.csv");
    const auto samples = cells_of(bytes_of(text.folder.path / "AM-5.txt"));
    REQUIRE(rows.size() == 10'000);
    REQUIRE(samples.size() == 10'000);
    CHECK(std::stod(rows[1234][0]) == 0.1234);
    for (std::size_t n = 0; n < rows.size(); n += 97) {
        CHECK(std::stod(rows[n][1]) == std::stod(samples[n][0]));
    }
}

TEST_CASE("stages: the files agree with each other and with the model's sums") {
    const TemporaryFolder folder;
    const fs::path out = folder.path / "made" / "with its parents";
    output_of({"stages", kTwelve, "--pattern", "LH-4-full", "--out", out.string()});
    CHECK(file_count(out) == 11);

    const auto receptors = rows_of(out / "receptors.csv");
    const auto spikes = rows_of(out / "spikes.csv");
    std::map<std::string, double> trains;  // of every receptor
    for (const auto& row : spikes) trains[row[0] + " " + row[1]] += std::stod(row[4]);
    for (const auto& row : receptors) {
        const auto train = trains.find(row[0] + " " + row[1]);
        CHECK((train == trains.end() ? 0.0 : train->second) == std::stod(row[7]));
    }

    // fires = receptors * rate * duration in all, shared among the receptors.
    const auto fires = sums(receptors, 0, 6);
    for (const auto& row : rows_of(out / "activation.csv")) {
        const double rows_of_type = static_cast<double>(
            std::ranges::count_if(receptors, [&](const auto& r) { return r[0] == row[0]; }));
        CHECK(rows_of_type == std::stod(row[5]));
        const double expected = std::stod(row[5]) * std::stod(row[1]) * 1.0;
        // A sum of up to hundreds of shares: rounding of some 1e-16 each.
        CHECK(std::abs(fires.at(row[0]) - expected) <= 1e-12 * (1.0 + expected));
    }

    // The centre of the last layer is the central count of the step; layer 4 is the last of 3 + 1.
    std::map<std::string, double> centres;
    for (const auto& row : rows_of(out / "layers.csv")) {
        if (row[2] == "4" && row[3] == "0" && row[4] == "0") {
            centres[row[0] + " " + row[1]] = std::stod(row[5]);
        }
    }
    double weighted_spikes = 0.0;
    constexpr std::array<const char*, 4> kTypes{"FA1", "FA2", "SA1", "SA2"};
    constexpr std::array<double, 4> kWeights{0.2, 0.7, 0.0, 0.5};
    const auto central = rows_of(out / "central.csv");
    CHECK(central.size() == 200);
    for (const auto& row : central) {
        for (std::size_t c = 0; c < kTypes.size(); ++c) {
            const auto centre = centres.find(std::string(kTypes[c]) + " " + row[0]);
            CHECK(std::stod(row[c + 2]) == (centre == centres.end() ? 0.0 : centre->second));
            weighted_spikes += kWeights[c] * std::stod(row[c + 2]);
        }
    }
    CHECK(weighted_spikes > 0.0);
    double sum = 0.0;
    for (const auto& row : rows_of(out / "brain_waveform.csv")) sum += std::stod(row[1]);
    CHECK(std::abs(sum - weighted_spikes) <= 1e-9 * weighted_spikes);  // 10,000 roundings
}

TEST_CASE("stages: input.csv is what render writes, and --json lists the files") {
    const TemporaryFolder folder;
    const std::string out = (folder.path / "stages").string();
    const std::string text = (folder.path / "text").string();
    const Json json =
        Json::parse(output_of({"stages", kAmSet, "--pattern", "AM-20", "--out", out, "--json"}));
    output_of({"render", kAmSet, "--format", "csv", "--out", text});
    CHECK(bytes_of(folder.path / "stages" / "input.csv").size() > 10'000);
    const auto input = rows_of(folder.path / "stages" / "input.csv");
    const auto rendered = rows_of(folder.path / "text" / "AM-20.csv");
    REQUIRE(input.size() == rendered.size());
    for (std::size_t n = 0; n < input.size(); n += 89) {
        CHECK(std::stod(input[n][1]) == std::stod(rendered[n][1]));
    }
    CHECK(json.at("pattern") == "AM-20");
    for (const std::string file : json.at("files")) CHECK(fs::exists(file));
}

TEST_CASE("render --rendered-by: what the device plays, with what is lost by band and packet") {
    const ShortSet set;
    const TemporaryFolder out;
    const Json report =
        Json::parse(output_of({"render", set.path, "--rendered-by", "switch-pro", "--format", "txt",
                               "--out", out.path.string(), "--json"}));
    CHECK(report.at("rendered_by") == "switch-pro");
    CHECK(report.at("level") == 1.0);
    CHECK(report.at("files").size() == 5);
    REQUIRE(report.at("patterns").size() == 5);
    const auto bands = rows_of(out.path / "bands.csv");
    const std::size_t per_pattern = report.at("patterns")[0].at("bands").size();
    CHECK(bands.size() == 5 * per_pattern);
    CHECK(std::stod(bands[0][5]) == report.at("patterns")[0].at("bands")[0].at("share_lost"));
    // 0.1 s at a packet every 15 ms.
    CHECK(rows_of(out.path / "packets.csv").size() == 5 * 7);
    // The files are what predict takes with the same option, to the bit.
    const std::string rendered = output_of({"predict", set.path, "--rendered-by", "switch-pro"});
    CHECK(rendered.starts_with("UNCALIBRATED"));
    CHECK(output_of({"predict", out.path.string()}) == rendered.substr(rendered.find(',')));
    CHECK(output_of({"predict", set.path}) !=
          output_of({"predict", set.path, "--rendered-by", "switch-pro"}));
    const Ran ran = run_program({"space", set.path, "--rendered-by", "joy-con"});
    CHECK(ran.exit_code == 0);
    CHECK(ran.err.find("as a Joy-Con plays them, uncalibrated") != std::string::npos);
    CHECK(run_program({"predict", set.path, "--rendered-by", "wii"}).exit_code == 2);
}

TEST_CASE("--calibration: patterns as a measured voice coil plays them, and as nothing else does") {
    const ShortSet set;
    const TemporaryFolder folder;
    const std::string file = (folder.path / "coil.json").string();
    std::ofstream(file) << R"({"tactspace_calibration": 1, "actuator": "left coil", "points": [
        {"frequency_hz": 20, "g_per_full_scale": 1},
        {"frequency_hz": 500, "g_per_full_scale": 9}]})";
    const Ran ran =
        run_program({"predict", set.path, "--rendered-by", "voice-coil", "--calibration", file});
    CHECK(ran.exit_code == 0);
    CHECK(contains(ran.err, "as a voice coil plays them, calibrated: by the calibration of left"));
    CHECK(ran.out != output_of({"predict", set.path, "--rendered-by", "voice-coil"}));
    const Ran pad =
        run_program({"predict", set.path, "--rendered-by", "joy-con", "--calibration", file});
    CHECK(pad.exit_code == 1);
    CHECK(contains(pad.err, "expected --rendered-by voice-coil"));
    CHECK(run_program({"predict", set.path, "--calibration", file}).exit_code == 1);
}

}  // namespace written_files_test
