#include "model/io/recordings/wave_file.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "model/io/recordings/text_waveform.h"
#include "tests/support/mutations.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wave_bytes.h"

namespace wave_file_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

std::vector<double> sine(double frequency_hz, double rate_hz, std::size_t count) {
    std::vector<double> samples(count);
    for (std::size_t n = 0; n < count; ++n) {
        samples[n] = 0.5 * std::sin(2.0 * std::numbers::pi * frequency_hz * static_cast<double>(n) /
                                    rate_hz);
    }
    return samples;
}

Recording read(const fs::path& path, const RecordingOptions& options = {}) {
    auto recording = read_wave_file(path, options);
    REQUIRE_MESSAGE(recording, (recording ? "" : recording.error().message));
    CHECK(recording->waveform.rate_hz == kModelRateHz);
    return *std::move(recording);
}

std::string fault(const fs::path& path, const RecordingOptions& options = {}) {
    const auto recording = read_wave_file(path, options);
    REQUIRE_FALSE(recording);
    CHECK(recording.error().message.starts_with(path.string()));
    return recording.error().message.substr(path.string().size());
}

double difference(const std::vector<double>& a, const std::vector<double>& b, std::size_t margin) {
    REQUIRE(a.size() == b.size());
    double largest = 0.0;
    for (std::size_t n = margin; n + margin < a.size(); ++n) {
        largest = std::max(largest, std::abs(a[n] - b[n]));
    }
    return largest;
}

bool has(const Recording& recording, const std::string& remark) {
    return std::ranges::count(recording.remarks, remark) == 1;
}

}  // namespace

TEST_CASE("wave file: every usual encoding gives the same vibration, to its own precision") {
    const TemporaryFolder folder;
    WaveBytes wave;
    wave.samples = sine(150.0, 10'000.0, 1001);
    const auto check = [&](int bits, bool is_float, double tolerance) {
        CAPTURE(bits);
        wave.bits = bits;
        wave.is_float = is_float;
        const Recording recording = read(folder.write("a.wav", wave.file()));
        CHECK(difference(recording.waveform.samples_g, wave.samples, 0) <= tolerance);
        CHECK(recording.remarks == std::vector<std::string>{"full scale taken as 1 g"});
    };
    for (const int bits : {8, 16, 24, 32})
        check(bits, false, std::ldexp(1.0, -bits));  // half a step
    check(32, true, 1e-7);
    check(64, true, 0.0);
}

TEST_CASE("wave file: another rate is resampled, and said") {
    const TemporaryFolder folder;
    WaveBytes wave{11'025, 1, 64, true, sine(150.0, 11'025.0, 11'025)};
    const Recording recording = read(folder.write("a.wav", wave.file()));
    CHECK(has(recording, "resampled from 11,025 Hz to 10,000 Hz"));
    // Far below 0.1 % of amplitude or frequency; 100 ms at either end belong to the filter.
    CHECK(difference(recording.waveform.samples_g, sine(150.0, 10'000.0, 10'000), 1000) <= 1e-6);
}

TEST_CASE("wave file: of several channels the first is read, unless another is asked for") {
    const TemporaryFolder folder;
    WaveBytes wave;
    wave.channels = 2;
    wave.samples = {0.5, -0.25, 0.125, 0.75};
    const fs::path file = folder.write("stereo.wav", wave.file());
    const Recording first = read(file);
    CHECK(first.waveform.samples_g == std::vector<double>{0.5, 0.125});
    CHECK(has(first, "first of 2 channels used"));
    const Recording second = read(file, {1.0, 1});
    CHECK(second.waveform.samples_g == std::vector<double>{-0.25, 0.75});
    CHECK(second.remarks.empty());
    CHECK(fault(file, {1.0, 2}) == ": expected channel 3, got a file of 2");
}

TEST_CASE("wave file: a silent channel is named, with the first one that is not") {
    const TemporaryFolder folder;
    WaveBytes wave;
    wave.channels = 4;
    wave.samples = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.25, 0.0, 0.0, 0.0, 0.0, -0.5};
    const fs::path four = folder.write("four.wav", wave.file());
    CHECK(has(read(four), "channel 1 is silent, channel 3 is not"));
    CHECK(has(read(four, {1.0, 1}), "channel 2 is silent, channel 3 is not"));
    CHECK(read(four, {1.0, 2}).remarks.empty());
    CHECK(read(four, {1.0, 3}).remarks.empty());
    wave.samples.assign(8, 0.0);
    CHECK(has(read(folder.write("all.wav", wave.file())),
              "channel 1 is silent, and so are the others"));
    wave.channels = 1;
    CHECK(has(read(folder.write("one.wav", wave.file())), "it is silent"));
}

TEST_CASE("wave file: the scale is the caller's, else the sidecar's, else 1 g") {
    const TemporaryFolder folder;
    WaveBytes wave;
    wave.samples = {0.5, -0.25};
    const fs::path file = folder.write("a.wav", wave.file());
    CHECK(read(file).scale_g == 1.0);
    folder.write("a.wav.json", "{\"scale_g\": 4, \"made by\": \"someone\"}");
    const Recording sidecar = read(file);
    CHECK(sidecar.scale_g == 4.0);
    CHECK(sidecar.waveform.samples_g == std::vector<double>{2.0, -1.0});
    CHECK(sidecar.remarks.empty());
    CHECK(read(file, {2.0, {}}).waveform.samples_g == std::vector<double>{1.0, -0.5});

    folder.write("a.wav.json", "{\"scale_g\": \"big\"}");
    CHECK(contains(fault(file), ".json: /scale_g: expected a number from"));
    folder.write("a.wav.json", "{\"scale_g\": ");
    CHECK(contains(fault(file), ".json, line 1"));
    folder.write("a.wav.json", "{\"channel\": 2}");
    CHECK(fault(file) == ": expected channel 2, got a file of 1");
}

TEST_CASE("wave file: one that is shorter than its header says is refused wherever it is cut") {
    const TemporaryFolder folder;
    WaveBytes wave;
    wave.samples = sine(100.0, 10'000.0, 200);
    const std::string whole = wave.file();
    for (std::size_t length = 0; length < whole.size(); ++length) {
        CAPTURE(length);
        CHECK_FALSE(read_wave_file(folder.write("cut.wav", whole.substr(0, length))));
    }
    CHECK(fault(folder.write("cut.wav", whole.substr(0, whole.size() - 100))) ==
          ": is truncated: expected 400 bytes of samples, as its header says, got 300");
    CHECK(read(folder.write("whole.wav", whole)).waveform.samples_g.size() == 200);
}

TEST_CASE("wave file: no sample, no number and no minute too many") {
    const TemporaryFolder folder;
    WaveBytes wave;
    CHECK(fault(folder.write("a.wav", wave.file())) == ": expected at least one sample, got none");

    wave = {10'000, 2, 32, true, {0.0, 0.0, 1.0, 0.0, 0.5, std::nan("")}};
    const fs::path file = folder.write("a.wav", wave.file());
    CHECK(contains(fault(file, {1.0, 1}), ": sample 3 is nan, expected a finite number"));
    CHECK(read(file).waveform.samples_g.size() == 3);
    wave.samples[2] = std::numeric_limits<double>::infinity();
    CHECK(contains(fault(folder.write("a.wav", wave.file())), ": sample 2 is inf"));

    wave = {100, 1, 8, false, std::vector<double>(6000)};
    CHECK(read(folder.write("a.wav", wave.file())).waveform.samples_g.size() == 600'000);
    wave.samples.push_back(0.0);
    CHECK(contains(fault(folder.write("a.wav", wave.file())), ": expected at most 60 s"));
    wave = {99, 1, 8, false, {0.0}};
    CHECK(contains(fault(folder.write("a.wav", wave.file())), "expected a rate of 100 Hz"));
    wave = {192'000, 1, 16, false, {0.0}};
    CHECK(contains(fault(folder.write("a.wav", wave.file())), "at least one sample at 10 kHz"));
}

TEST_CASE("wave file: what is no WAV file is refused") {
    const TemporaryFolder folder;
    CHECK(
        contains(fault(folder.write("a.wav", "fLaC....................")), "expected a WAV file"));
    CHECK(fault(folder.path / "none.wav") == ": there is no such file");
    CHECK(fault(folder.path) == ": is a folder, expected a file");
}

TEST_CASE(
    "wave file: written and read again, the samples are the same to the precision of the file") {
    const TemporaryFolder folder;
    const fs::path file = folder.path / "\u9707\u52a8 1.wav";
    const Waveform waveform{kModelRateHz, sine(150.0, 10'000.0, 500)};
    const auto check = [&](WaveEncoding encoding, double scale_g, double tolerance_g) {
        REQUIRE(write_wave_file(file, waveform, {encoding, scale_g}));
        const Recording recording = read(file);
        CHECK(recording.scale_g == scale_g);
        CHECK(difference(recording.waveform.samples_g, waveform.samples_g, 0) <= tolerance_g);
    };
    check(WaveEncoding::float32, 1.0, 1e-7);
    CHECK_FALSE(fs::exists(file.string() + ".json"));
    check(WaveEncoding::float32, 3.0, 1e-7);
    check(WaveEncoding::int16, 2.0, 2.0 * std::ldexp(1.0, -16));
    check(WaveEncoding::int24, 0.5, 0.5 * std::ldexp(1.0, -23));  // the peak is full scale
    check(WaveEncoding::float32, 1.0, 1e-7);                      // the sidecar follows
}

TEST_CASE("wave file: a peak beyond full scale is refused rather than cut off") {
    const TemporaryFolder folder;
    const fs::path file = folder.path / "a.wav";
    const auto written =
        write_wave_file(file, {kModelRateHz, {0.0, -2.5}}, {WaveEncoding::int16, 2.0});
    REQUIRE_FALSE(written);
    CHECK(written.error().message ==
          file.string() + ": expected a peak within the full scale of 2 g, got 2.5 g");
    CHECK(file_count(folder.path) == 0);
    CHECK(write_wave_file(file, {kModelRateHz, {0.0, -2.5}}, {WaveEncoding::float32, 1.0}));
    CHECK(read(file).waveform.samples_g == std::vector<double>{0.0, -2.5});
}

TEST_CASE(
    "wave file: the same waveform gives the same bytes, and a failed save leaves the old ones") {
    const TemporaryFolder folder;
    const Waveform waveform{kModelRateHz, sine(150.0, 10'000.0, 50)};
    REQUIRE(write_wave_file(folder.path / "a.wav", waveform));
    REQUIRE(write_wave_file(folder.path / "b.wav", waveform));
    CHECK(bytes_of(folder.path / "a.wav") == bytes_of(folder.path / "b.wav"));
    CHECK_FALSE(write_wave_file(folder.path / "a.wav" / "below.wav", waveform));
    CHECK(bytes_of(folder.path / "a.wav") == bytes_of(folder.path / "b.wav"));
    CHECK(file_count(folder.path) == 2);
}

TEST_CASE("wave file: all of many channels are read, or the one that is asked for") {
    const TemporaryFolder folder;
    constexpr std::size_t kChannels = 1000;
    WaveBytes wave;
    wave.channels = static_cast<int>(kChannels);
    const auto sample = [](std::size_t channel, std::size_t frame) {
        return std::ldexp(static_cast<double>(channel) - 31.0 * static_cast<double>(frame), -15);
    };
    constexpr std::size_t kFrames = 150;  // more than one block of them
    for (std::size_t n = 0; n < kFrames; ++n) {
        for (std::size_t k = 0; k < kChannels; ++k) wave.samples.push_back(sample(k, n));
    }
    const fs::path file = folder.write("many.wav", wave.file());
    const auto all = read_wave_channels(file);
    REQUIRE_MESSAGE(all, (all ? "" : all.error().message));
    REQUIRE(all->channels.size() == kChannels);
    CHECK(all->rate_hz == 10'000.0);
    CHECK_FALSE(all->scale_g);
    for (std::size_t k = 0; k < kChannels; ++k) {
        REQUIRE(all->channels[k].size() == kFrames);
        for (std::size_t n = 0; n < kFrames; ++n) REQUIRE(all->channels[k][n] == sample(k, n));
    }
    const auto last = read_wave_channels(file, kChannels);
    REQUIRE(last);
    REQUIRE(last->channels.size() == 1);
    CHECK(last->channels[0] == all->channels.back());
    CHECK(contains(read_wave_channels(file, kChannels + 1).error().message,
                   "expected channel 1001, got a file of 1000"));
    const auto refused =
        read_wave_channels(file, 0, [](std::size_t channels) { return std::to_string(channels); });
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message == file.string() + ": 1000");
}

TEST_CASE("wave file: a scale that came with other samples is used, and said to be doubtful") {
    const TemporaryFolder folder;
    const fs::path file = folder.path / "a.wav";
    REQUIRE(write_wave_file(file, {kModelRateHz, {0.5, 1.0}}, {WaveEncoding::int16, 1.0}));
    const std::string old_samples = bytes_of(file);
    REQUIRE(write_wave_file(file, {kModelRateHz, {0.5, 4.0}}, {WaveEncoding::int16, 4.0}));
    CHECK(read(file).remarks.empty());
    folder.write("a.wav", old_samples);  // as after a power cut between the two files
    const Recording mixed = read(file);
    CHECK(mixed.scale_g == 4.0);
    REQUIRE(mixed.remarks.size() == 1);
    CHECK(contains(mixed.remarks[0], "full scale of 4 g may not be that of these"));
    CHECK(contains(read_wave_channels(file)->remark, "may not be"));
    CHECK(read(file, {1.0, {}}).remarks.empty());
}

TEST_CASE("wave file: what could not be read again is not written") {
    const TemporaryFolder folder;
    const fs::path file = folder.path / "a.wav";
    const double inf = std::numeric_limits<double>::infinity();
    for (const auto encoding : {WaveEncoding::float32, WaveEncoding::int16, WaveEncoding::int24}) {
        for (const double sample : {std::nan(""), inf, -inf, 1.1e6}) {
            CAPTURE(sample);
            for (const std::vector<double>& samples :
                 {std::vector<double>{sample, 0.5}, std::vector<double>{0.5, sample, -0.5}}) {
                const Waveform waveform{kModelRateHz, samples};
                CHECK_FALSE(write_wave_file(file, waveform, {encoding, 2.0}));
                CHECK_FALSE(write_text_waveform(folder.path / "a.txt", waveform));
            }
        }
    }
    CHECK(file_count(folder.path) == 0);
}

TEST_CASE("wave file: of any bytes no pipe is made, and none is waited for") {
    const TemporaryFolder folder;
    REQUIRE(::mkfifo((folder.path / "a.wav").c_str(), 0600) == 0);
    CHECK(fault(folder.path / "a.wav") == ": is a pipe, expected a file");
    WaveBytes wave;
    wave.samples = {0.5};
    const fs::path file = folder.write("b.wav", wave.file());
    REQUIRE(::mkfifo((folder.path / "b.wav.json").c_str(), 0600) == 0);
    CHECK(contains(fault(file), "is a pipe, expected a file"));
}

TEST_CASE("wave file: after an accident it is refused, or written and read again the same") {
    const TemporaryFolder folder;
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < 400; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        WaveBytes wave;
        wave.channels = 1 + static_cast<int>(seed % 3);
        wave.bits = seed % 2 == 0 ? 16 : 32;
        wave.is_float = wave.bits == 32;
        for (int n = 0; n < 60; ++n) wave.samples.push_back(std::sin(0.3 * n));
        const fs::path file = folder.write("a.wav", after_mishaps(wave.file(), random));
        const auto recording = read_wave_file(file);
        if (!recording) {
            CHECK(recording.error().message.starts_with(file.string() + ": "));
            continue;
        }
        ++accepted;
        if (!write_wave_file(folder.path / "b.wav", recording->waveform)) continue;
        const auto first = read_wave_file(folder.path / "b.wav");
        REQUIRE_MESSAGE(first, (first ? "" : first.error().message));
        REQUIRE(first->waveform.samples_g.size() == recording->waveform.samples_g.size());
        for (std::size_t n = 0; n < first->waveform.samples_g.size(); ++n) {
            CHECK(first->waveform.samples_g[n] ==
                  static_cast<float>(recording->waveform.samples_g[n]));
        }
    }
    CHECK(accepted > 20);
}

TEST_CASE("waves: the head of each encoding is as long as its format wants, and whole") {
    for (const auto encoding : {WaveEncoding::float32, WaveEncoding::int16, WaveEncoding::int24}) {
        const auto written = wave_text({kModelRateHz, {0.0, 0.5, -0.25}}, {encoding, 1.0}, "w");
        REQUIRE(written);
        const std::string& bytes = written->bytes;
        const auto number = [&](std::size_t at, std::size_t count) {
            std::uint32_t value = 0;
            for (std::size_t k = 0; k < count; ++k) {
                value |= std::uint32_t{static_cast<std::uint8_t>(bytes.at(at + k))} << (8 * k);
            }
            return value;
        };
        CHECK(number(4, 4) == bytes.size() - 8);
        // Chunk by chunk to the end.
        std::size_t at = 12;
        std::string names;
        while (at < bytes.size()) {
            names += bytes.substr(at, 4);
            if (bytes.substr(at, 4) == "fmt ") {
                const bool is_float = encoding == WaveEncoding::float32;
                CHECK(number(at + 4, 4) == (is_float ? 18 : 16));
                CHECK(number(at + 8, 2) == (is_float ? 3 : 1));
                if (is_float) CHECK(number(at + 24, 2) == 0);
            }
            at += 8 + number(at + 4, 4) + number(at + 4, 4) % 2;
        }
        CHECK(at >= bytes.size());
        CHECK(names.find("data") != std::string::npos);
    }
}

}  // namespace wave_file_test
