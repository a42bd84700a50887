// Odd but good input through the whole program: it works, and standard error says what was done.
#include <doctest/doctest.h>

#include <cstdio>
#include <numbers>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wave_bytes.h"

namespace odd_files_test {

namespace fs = std::filesystem;

namespace {

constexpr int kSamples = 600;

// Whole 128ths of full scale, which every encoding from 8 bits on holds exactly.
std::vector<double> exact_samples() {
    std::vector<double> samples;
    for (int n = 0; n < kSamples; ++n) {
        samples.push_back(std::round(100.0 * std::sin(0.1 * n)) / 128.0);
    }
    return samples;
}

std::string text_of(const std::vector<double>& samples, const std::string& line_end = "\n") {
    std::string text;
    char digits[32];
    for (const double sample : samples) {
        std::snprintf(digits, sizeof digits, "%.7f", sample);  // 1/128 has seven digits
        text += digits + line_end;
    }
    return text;
}

std::string wave_of(const std::vector<double>& samples, int bits, bool is_float, int rate_hz) {
    WaveBytes wave;
    wave.samples = samples;
    wave.bits = bits;
    wave.is_float = is_float;
    wave.rate_hz = rate_hz;
    return wave.file();
}

std::vector<double> sine(double frequency_hz, int rate_hz, int samples) {
    std::vector<double> result;
    for (int n = 0; n < samples; ++n) {
        result.push_back(0.9 * std::sin(2.0 * std::numbers::pi * frequency_hz * n / rate_hz));
    }
    return result;
}

bool all_zero(const std::vector<double>& values) {
    return std::ranges::all_of(values, [](double value) { return value == 0.0; });
}

}  // namespace

TEST_CASE("odd files: one vibration in every encoding is one vibration: all distances are zero") {
    const TemporaryFolder folder;
    const auto samples = exact_samples();
    folder.write("8 bit.wav", wave_of(samples, 8, false, 10'000));
    folder.write("16 bit.wav", wave_of(samples, 16, false, 10'000));
    folder.write("24 bit.wav", wave_of(samples, 24, false, 10'000));
    folder.write("32 bit.wav", wave_of(samples, 32, false, 10'000));
    folder.write("float.wav", wave_of(samples, 32, true, 10'000));
    folder.write("double.wav", wave_of(samples, 64, true, 10'000));
    folder.write("unix.txt", text_of(samples));
    folder.write("windows.txt", "\xEF\xBB\xBF" + text_of(samples, "\r\n"));
    folder.write("no end.txt", text_of(samples) + "0");
    auto padded = samples;
    padded.resize(kSamples + 1);
    folder.write("zeros at its end.txt", text_of(padded));
    for (const std::string metric : {"nc", "oc"}) {
        const Ran ran = run_program({"predict", folder.path.string(), "--metric", metric});
        CHECK(ran.exit_code == 0);
        CHECK(cells_of(ran.out).size() == 11);
        CHECK(all_zero(condensed_in(ran.out)));
        const std::string place = folder.path.string();
        CHECK(ran.err == "tactspace: " + place +
                             "/8 bit.wav and 5 more: full scale taken as 1 g\n" +
                             "tactspace: " + place +
                             ": lengths of 600 to 601 samples, the shorter ones are padded with "
                             "zeros\n");
    }
}

TEST_CASE("odd files: of several channels the first is used, and that is said") {
    const TemporaryFolder folder;
    WaveBytes stereo;
    stereo.channels = 2;
    for (const double sample : exact_samples()) {
        stereo.samples.push_back(sample);
        stereo.samples.push_back(0.5);
    }
    folder.write("stereo.wav", stereo.file());
    folder.write("first.txt", text_of(exact_samples()));
    const Ran ran = run_program({"predict", folder.path.string(), "--metric", "nc"});
    CHECK(all_zero(condensed_in(ran.out)));
    CHECK(contains(ran.err, "stereo.wav: first of 2 channels used\n"));
}

TEST_CASE("odd files: 11,025 Hz is resampled, said, and lands beside its twin at 10 kHz") {
    const TemporaryFolder folder;
    folder.write("a.wav", wave_of(sine(150.0, 11'025, 3308), 24, false, 11'025));
    folder.write("b.wav", wave_of(sine(150.0, 10'000, 3000), 24, false, 10'000));
    folder.write("c.wav", wave_of(sine(60.0, 10'000, 3000), 24, false, 10'000));
    const Ran ran = run_program({"predict", folder.path.string(), "--metric", "nc"});
    CHECK(contains(ran.err, "/a.wav: resampled from 11,025 Hz to 10,000 Hz\n"));
    const auto pairs = condensed_in(ran.out);
    REQUIRE(pairs.size() == 3);
    CHECK(pairs[0] < 0.5 * pairs[1]);
    CHECK(pairs[0] < 0.5 * pairs[2]);
}

TEST_CASE("odd files: a set file may have a byte-order mark, Windows lines and unknown keys") {
    const TemporaryFolder folder;
    const std::string lines =
        "{\"tactspace\": 1, \"mood\": \"good\",\n\"patterns\": [\n"
        "{\"name\": \"a\", \"duration_s\": 0.05, \"smell\": 3},\n"
        "{\"name\": \"b\", \"duration_s\": 0.1}]}\n";
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : lines) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const fs::path plain = folder.write("plain.json", lines);
    const fs::path odd = folder.write("odd.json", windows);
    CHECK(output_of({"predict", odd.string(), "--metric", "oc"}) ==
          output_of({"predict", plain.string(), "--metric", "oc"}));
}

TEST_CASE("odd files: names keep their spaces and their script, and count as people do") {
    const TemporaryFolder folder;
    for (const char* stem : {"buzz 10", "buzz 9", "größe", "振动 2", "振动 11", "نبض", "🫨"}) {
        folder.write(std::string(stem) + ".txt", text_of(exact_samples()));
    }
    const std::string csv = output_of({"predict", folder.path.string(), "--metric", "nc"});
    CHECK(csv.starts_with(",buzz 9,buzz 10,größe,نبض,振动 2,振动 11,🫨\n"));
    const std::string out = (folder.path / "out").string();
    output_of({"stages", folder.path.string(), "--pattern", "振动 11", "--out", out});
    CHECK(file_count(out) == 11);
}

TEST_CASE("odd files: a folder may hold other things, which are counted and left alone") {
    const TemporaryFolder folder;
    folder.write("a.txt", text_of(exact_samples()));
    folder.write("b.TXT", text_of(exact_samples()));
    folder.write("notes.pdf", "");
    folder.write(".hidden.txt", "not a number");
    const Ran ran = run_program({"predict", folder.path.string(), "--metric", "nc"});
    CHECK(ran.exit_code == 0);
    CHECK(ran.out.starts_with(",a,b\n"));
    CHECK(ran.err == "tactspace: " + folder.path.string() + ": 1 other file ignored\n");
}

TEST_CASE("odd files: a file of a folder that cannot be read is named, and an error if strict") {
    const TemporaryFolder folder;
    folder.write("a.txt", text_of(exact_samples()));
    folder.write("below/b.txt", text_of(exact_samples()));
    folder.write("below/c.txt", "not a number");
    const std::string place = folder.path.string();
    const std::string told = "tactspace: 2 files read, 1 not\ntactspace: not read: " + place +
                             "/below/c.txt:1: expected one finite number, got \"not a number\"\n";
    const Ran ran = run_program({"predict", place, "--metric", "nc"});
    CHECK(ran.exit_code == 0);
    CHECK(ran.out.starts_with(",a,b\n"));
    CHECK(ran.err.starts_with(told));
    const Ran strict = run_program({"predict", place, "--metric", "nc", "--strict"});
    CHECK(strict.exit_code == 1);
    CHECK(strict.out.empty());
    CHECK(strict.err ==
          told + "tactspace: --strict: expected every file to be read, got 2 files read, 1 not\n");
}

TEST_CASE("odd files: 1,500 short patterns are no trouble, and stand in natural order" *
          doctest::test_suite("long")) {
    constexpr std::size_t kPatterns = 1500;
    const TemporaryFolder folder;
    unsigned state = 1;
    for (std::size_t k = 1; k <= kPatterns; ++k) {
        std::string text;
        for (int n = 0; n < 20; ++n) {
            state = 1664525U * state + 1013904223U;
            text += std::to_string(static_cast<int>(state >> 16) % 1000) + "e-3\n";
        }
        folder.write("p" + std::to_string(k) + ".txt", text);
    }
    const fs::path file = folder.path / "matrix.csv";
    const Ran ran = run_program({"predict", folder.path.string(), "--out", file.string()});
    CHECK(ran.exit_code == 0);
    CHECK(ran.out == "");
    CHECK(ran.err == "");
    const auto rows = cells_of(bytes_of(file));
    REQUIRE(rows.size() == kPatterns + 1);
    for (std::size_t k = 1; k <= kPatterns; ++k) CHECK(rows[k][0] == "p" + std::to_string(k));
    // The ranks 1 .. m of NC and of OC, half of each: their sum is that of 1 .. m, ties or not.
    double sum = 0.0;
    for (const double value : condensed_in(bytes_of(file))) sum += value;
    const double pairs = 0.5 * kPatterns * (kPatterns - 1);
    CHECK(sum == 0.5 * pairs * (pairs + 1.0));
}

}  // namespace odd_files_test
