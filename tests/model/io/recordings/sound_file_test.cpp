#include "model/io/recordings/sound_file.h"

#include <doctest/doctest.h>
#include <sndfile.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "tests/support/temporary_folder.h"

namespace sound_file_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

using Frames = std::vector<double>;  // interleaved

// A sound of libsndfile's own making.
fs::path sound(const fs::path& path, int format, int rate_hz, int channels, const Frames& frames) {
    SF_INFO info{};
    info.samplerate = rate_hz;
    info.channels = channels;
    info.format = format;
    SNDFILE* file = sf_open(path.c_str(), SFM_WRITE, &info);
    REQUIRE(file != nullptr);
    sf_write_double(file, frames.data(), static_cast<sf_count_t>(frames.size()));
    sf_close(file);
    return path;
}

Frames tone(double hz, double amplitude, int rate_hz, double seconds) {
    Frames x;
    for (int n = 0; n < rate_hz * seconds; ++n) {
        x.push_back(amplitude * std::sin(2.0 * std::numbers::pi * hz * n / rate_hz));
    }
    return x;
}

std::string fault_of(const fs::path& path) {
    const auto read = read_sound_file(path);
    REQUIRE(!read);
    const std::string& message = read.error().message;
    CHECK(message.starts_with(path.string() + ": "));
    CHECK(message.find('\n') == std::string::npos);
    return message.substr(path.string().size() + 2);
}

bool has(const SoundFile& sound, const std::string& part) {
    for (const auto& remark : sound.remarks) {
        if (remark.find(part) != std::string::npos) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("sound file: one tone is the same one in every format and at every rate") {
    const TemporaryFolder folder;
    const auto check = [&](const char* name, int format, int rate_hz) {
        CAPTURE(name);
        CAPTURE(rate_hz);
        const fs::path path =
            sound(folder.path / name, format, rate_hz, 1, tone(150.0, 0.5, rate_hz, 1.0));
        CHECK(is_sound_file(path));
        const auto read = read_sound_file(path);
        REQUIRE(read);
        CHECK(read->waveform.rate_hz == kModelRateHz);
        CHECK(std::abs(read->duration_s - 1.0) <= 0.001);
        CHECK(std::abs(rms_g(read->waveform) - 0.5 / std::sqrt(2.0)) <= 0.01);
        CHECK(!read->scale_g);
    };
    for (const int rate_hz : {8000, 11'025, 44'100, 48'000, 96'000}) {
        check("a.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, rate_hz);
        check("a.flac", SF_FORMAT_FLAC | SF_FORMAT_PCM_24, rate_hz);
    }
    check("a.ogg", SF_FORMAT_OGG | SF_FORMAT_VORBIS, 44'100);
    check("a.aiff", SF_FORMAT_AIFF | SF_FORMAT_PCM_16, 44'100);
    check("a.au", SF_FORMAT_AU | SF_FORMAT_FLOAT, 22'050);
    check("a.caf", SF_FORMAT_CAF | SF_FORMAT_PCM_24, 48'000);
    check("sound without an ending", SF_FORMAT_FLAC | SF_FORMAT_PCM_16, 44'100);
}

TEST_CASE("sound file: channels are mixed, and what cancels, clips or is offset is said") {
    const TemporaryFolder folder;
    const fs::path path = folder.path / "a.flac";
    constexpr int kFlac = SF_FORMAT_FLAC | SF_FORMAT_PCM_16;
    const Frames one = tone(200.0, 0.4, 44'100, 1.0);
    Frames both;
    Frames against;
    Frames offset;
    Frames clipped;
    for (const double x : one) {
        both.insert(both.end(), {x, 0.0});
        against.insert(against.end(), {x, -0.9 * x});
        offset.push_back(x + 0.3);
        clipped.push_back(std::clamp(4.0 * x, -0.999, 0.999));
    }
    const auto mixed = read_sound_file(sound(path, kFlac, 44'100, 2, both));
    REQUIRE(mixed);
    CHECK(has(*mixed, "2 channels are mixed"));
    CHECK(!has(*mixed, "cancel"));
    CHECK(std::abs(rms_g(mixed->waveform) - 0.2 / std::sqrt(2.0)) <= 0.002);
    const auto gone = read_sound_file(sound(path, kFlac, 44'100, 2, against));
    REQUIRE(gone);
    CHECK(has(*gone, "cancel each other"));
    const auto centred = read_sound_file(sound(path, kFlac, 44'100, 1, offset));
    REQUIRE(centred);
    CHECK(has(*centred, "a constant offset of 0.3"));
    CHECK(std::abs(rms_g(centred->waveform) - 0.4 / std::sqrt(2.0)) <= 0.004);
    const auto hot = read_sound_file(sound(path, kFlac, 44'100, 1, clipped));
    REQUIRE(hot);
    CHECK(has(*hot, "is clipped: "));
    Frames clicks(44'100, 0.0);
    clicks[1000] = clicks[30'000] = 0.9;
    const auto clean = read_sound_file(sound(path, kFlac, 44'100, 1, clicks));
    REQUIRE(clean);
    CHECK(!has(*clean, "clipped"));
}

TEST_CASE("sound file: what is no sound, silent, too long or too short is refused in a sentence") {
    const TemporaryFolder folder;
    const fs::path path = folder.path / "a.flac";
    constexpr int kFlac = SF_FORMAT_FLAC | SF_FORMAT_PCM_16;
    CHECK(fault_of(sound(path, kFlac, 8000, 1, Frames(8000, 0.0))) == "is silent");
    CHECK(fault_of(sound(path, kFlac, 8000, 1, Frames(8000, 0.25))) == "is silent");
    CHECK(fault_of(sound(path, kFlac, 8000, 2, Frames(16'000, 0.0))) ==
          "is silent, or its channels cancel each other");
    CHECK(fault_of(sound(path, kFlac, 8000, 1, tone(100.0, 0.5, 8000, 61.0))) ==
          "expected at most 60 s of sound, got 61 s: cut out the part that is to be felt");
    CHECK(fault_of(sound(path, kFlac, 8000, 1, Frames(4, 0.5))) ==
          "expected 1 ms of sound at least");
    CHECK(fault_of(sound(folder.path / "a.wav", SF_FORMAT_WAV | SF_FORMAT_PCM_16, 8000, 1,
                         Frames(8000, 0.0))) == "is silent");
    for (const char* name : {"a.mp3", "a.png", "none.ogg"}) {
        const fs::path other = folder.path / name;
        if (name[0] != 'n') std::ofstream(other) << "no sound at all, whatever its name says";
        CHECK(!is_sound_file(other));
        CHECK(!fault_of(other).empty());
    }
    CHECK(fault_of(folder.path / "a.png") == "expected a sound file, as WAV, FLAC, Ogg or MP3");
    Frames nan = tone(100.0, 0.5, 8000, 1.0);
    nan[17] = std::numeric_limits<double>::quiet_NaN();
    CHECK(fault_of(sound(folder.path / "a.aiff", SF_FORMAT_AIFF | SF_FORMAT_DOUBLE, 8000, 1, nan))
              .find("sample 18 is") == 0);
}

TEST_CASE("sound file: tables of samples and of accelerations are sounds, in g") {
    const TemporaryFolder folder;
    std::ofstream text(folder.path / "a.txt");
    std::ofstream table(folder.path / "a.csv");
    table << "time (s),acceleration (g)\n";
    const Frames x = tone(100.0, 2.0, 10'000, 0.5);
    for (std::size_t n = 0; n < x.size(); ++n) {
        text << x[n] << "\n";
        table << 1e-4 * static_cast<double>(n) << "," << x[n] << "\n";
    }
    text.close();
    table.close();
    for (const char* name : {"a.txt", "a.csv"}) {
        const auto read = read_sound_file(folder.path / name);
        REQUIRE_MESSAGE(read, (read ? "" : read.error().message));
        CHECK(read->scale_g == 1.0);
        CHECK(std::abs(rms_g(read->waveform) - 2.0 / std::sqrt(2.0)) <= 0.02);
    }
}

}  // namespace sound_file_test
