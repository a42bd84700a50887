#include "app/report/report.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>

#include "tests/support/wave_bytes.h"

namespace wave_html_test {

using namespace tact;

namespace {

std::string decoded(std::string_view text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bits;
    for (const char c : text) {
        if (c == '=') continue;
        const std::size_t value = digits.find(c);
        REQUIRE(value != std::string::npos);
        for (int k = 5; k >= 0; --k) bits += (value >> k & 1U) != 0 ? '1' : '0';
    }
    std::string bytes;
    for (std::size_t at = 0; at + 8 <= bits.size(); at += 8) {
        bytes += static_cast<char>(std::stoi(bits.substr(at, 8), nullptr, 2));
    }
    return bytes;
}

int sample_at(const std::string& wave, std::size_t k) {
    const auto low = static_cast<unsigned char>(wave.at(44 + 2 * k));
    const auto high = static_cast<signed char>(wave.at(45 + 2 * k));
    return 256 * high + low;
}

Waveform tone(double hz, double amplitude_g, double seconds) {
    Waveform wave;
    for (int n = 0; n < static_cast<int>(seconds * wave.rate_hz); ++n) {
        wave.samples_g.push_back(amplitude_g *
                                 std::sin(2.0 * std::acos(-1.0) * hz * n / wave.rate_hz));
    }
    return wave;
}

}  // namespace

TEST_CASE("base64: the examples of RFC 4648") {
    CHECK(base64("").empty());
    CHECK(base64("f") == "Zg==");
    CHECK(base64("fo") == "Zm8=");
    CHECK(base64("foo") == "Zm9v");
    CHECK(base64("foobar") == "Zm9vYmFy");
    std::string all;
    for (int k = 0; k < 256; ++k) all += static_cast<char>(k);
    CHECK(decoded(base64(all)) == all);
}

TEST_CASE("players: a WAV of 16 bits, full scale at the g that was said, cut off beyond it") {
    const Waveform wave{4000.0, {0.0, 1.0, -2.0, 4.0}};
    const std::string bytes = wave_bytes(wave, 2.0);
    const WaveBytes expected{.rate_hz = 4000, .samples = {}};
    CHECK(bytes.size() == 44 + 8);
    CHECK(bytes.substr(12, 24) == "fmt " + std::string("\x10\0\0\0", 4) +
                                      expected.format().substr(expected.format().size() - 16));
    CHECK(sample_at(bytes, 0) == 0);
    CHECK(sample_at(bytes, 1) == 16384);
    CHECK(sample_at(bytes, 2) == -32767);
    CHECK(sample_at(bytes, 3) == 32767);
    CHECK(sample_at(wave_bytes(wave, 0.0), 3) == 0);  // of silence, no scale can be told
}

TEST_CASE("players: as long as the vibration, with its tones, up to where carriers go") {
    for (const double hz : {60.0, 1000.0}) {
        const std::string html = player_html(tone(hz, 1.0, 0.5), 1.0, "a \"tone\"");
        CHECK(html.find("aria-label=\"a &quot;tone&quot;\"") != std::string::npos);
        const std::size_t begin = html.find("base64,") + 7;
        const std::string wave = decoded(html.substr(begin, html.find('"', begin) - begin));
        const auto count = static_cast<std::size_t>(0.5 * kPlayerRateHz);
        REQUIRE(wave.size() == 44 + 2 * count);
        double energy = 0.0;
        for (std::size_t k = 200; k < count - 200; ++k) {
            energy +=
                std::pow(sample_at(wave, k) / 32767.0, 2.0) / static_cast<double>(count - 400);
        }
        CHECK(std::abs(energy - 0.5) < 0.005);  // the filter is flat to a per cent at 1 kHz
        CHECK(player_bytes(tone(hz, 1.0, 0.5)) >= html.size() - 100);
    }
}

TEST_CASE("thumbnails: a louder pattern is taller, a shorter one ends sooner, silence is a line") {
    const auto height = [](const std::string& svg) {
        int most = 0;
        for (std::size_t at = svg.find(" -"); at != std::string::npos;
             at = svg.find(" -", at + 1)) {
            const std::size_t path = svg.find("<path");
            if (at > path) most = std::max(most, std::stoi(svg.substr(at + 2)));
        }
        return most;
    };
    const std::string loud = thumbnail_html(tone(100.0, 2.0, 1.0), 2.0, 1.0).html;
    const std::string soft = thumbnail_html(tone(100.0, 0.5, 1.0), 2.0, 1.0).html;
    CHECK(height(loud) > 45);
    CHECK(height(soft) > 8);
    CHECK(height(soft) < 18);
    CHECK(height(thumbnail_html({10'000.0, std::vector<double>(100, 0.0)}, 2.0, 1.0).html) == 1);
    const std::string brief = thumbnail_html(tone(100.0, 2.0, 0.25), 2.0, 1.0).html;
    CHECK(brief.find("L60 -1L") != std::string::npos);
    CHECK(loud.find("L60 -1L") == std::string::npos);
    CHECK(loud.size() < 2'000);
}

TEST_CASE("thumbnails: modulated faster than can be drawn is lighter, with an outline") {
    Waveform fast = tone(200.0, 1.0, 1.0);
    for (std::size_t n = 0; n < fast.samples_g.size(); ++n) {
        const double time_s = static_cast<double>(n) / fast.rate_hz;
        fast.samples_g[n] *= 0.5 + 0.5 * std::sin(2.0 * std::acos(-1.0) * 40.0 * time_s);
    }
    const WaveThumbnail light = thumbnail_html(fast, 1.0, 1.0);
    CHECK(light.is_light);
    CHECK(light.html.find("opacity=\".") != std::string::npos);
    CHECK(light.html.find("class=\"edge\"") != std::string::npos);
    const WaveThumbnail plain = thumbnail_html(tone(200.0, 1.0, 1.0), 1.0, 1.0);
    CHECK_FALSE(plain.is_light);
    CHECK(plain.html.find("opacity") == std::string::npos);
    CHECK(plain.html.find("edge") == std::string::npos);
}

}  // namespace wave_html_test
