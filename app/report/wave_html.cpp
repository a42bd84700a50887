#include "app/report/report.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "model/signal/resample.h"
#include "viz/drawing/wave_body.h"

namespace tact {

namespace {

constexpr std::size_t kColumns = 96;
constexpr int kHalfHeight = 50;

void put(std::string& bytes, std::uint32_t value, int length) {
    for (int k = 0; k < length; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xFFU);
}

// Down is positive in a picture.
int height_of(double g, double reach_g) {
    const double share = reach_g > 0.0 ? std::clamp(g / reach_g, -1.0, 1.0) : 0.0;
    return static_cast<int>(std::lround(-share * kHalfHeight));
}

// Outline of the columns from `first` to `last`. Silence is a line, too.
std::string outline(std::span<const Extremes> columns, std::size_t first, std::size_t last,
                    double reach_g) {
    std::string above;
    std::string below;
    for (std::size_t k = first; k <= last; ++k) {
        const std::string x = std::to_string(k);
        const int top = height_of(columns[k].high, reach_g) - 1;
        const int bottom = height_of(columns[k].low, reach_g) + 1;
        above += (k == first ? "M" : "L") + x + " " + std::to_string(top);
        below = "L" + x + " " + std::to_string(bottom) + below;
    }
    return above + below + "Z";
}

}  // namespace

WaveThumbnail thumbnail_html(const Waveform& waveform, double reach_g, double end_s) {
    const Waveform whole = padded(waveform, sample_count(end_s, waveform.rate_hz));
    const WaveBody body =
        wave_body(whole.samples_g, 0.0, end_s * whole.rate_hz, kColumns, {.least = 0.01 * reach_g});
    std::vector<int> tones_percent;
    for (const double strength : body.strength)
        tones_percent.push_back(static_cast<int>(10 * std::lround(10.0 * body_tone(strength))));
    const bool is_light = std::ranges::any_of(tones_percent, [](int tone) { return tone < 100; });
    std::string paths;
    for (std::size_t k = 0; k < tones_percent.size();) {
        const int tone = tones_percent[k];
        std::size_t last = k;
        while (last + 1 < tones_percent.size() && tones_percent[last + 1] == tone) ++last;
        // To where the next begins.
        const std::size_t end = std::min(last + 1, tones_percent.size() - 1);
        const std::string opacity = tone < 100 ? " opacity=\"." + std::to_string(tone) + "\"" : "";
        paths += "<path" + opacity + " d=\"" + outline(body.columns, k, end, reach_g) + "\"/>";
        k = last + 1;
    }
    // What is light has an outline: how high it is stays as clear.
    if (is_light) {
        paths += "<path class=\"edge\" d=\"" +
                 outline(body.columns, 0, body.columns.size() - 1, reach_g) + "\"/>";
    }
    const std::string height = std::to_string(2 * kHalfHeight + 2);
    return {"<svg class=\"wave\" aria-hidden=\"true\" preserveAspectRatio=\"none\" viewBox=\"0 -" +
                std::to_string(kHalfHeight + 1) + " " + std::to_string(kColumns - 1) + " " +
                height + "\">" + paths + "</svg>",
            is_light};
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            three = three << 8U |
                    (k < count ? static_cast<unsigned char>(bytes[at + k]) : std::uint32_t{0});
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= count ? kDigits[three >> (18 - 6 * k) & 63U] : '=';
        }
    }
    return text;
}

std::string wave_bytes(const Waveform& waveform, double full_scale_g) {
    constexpr std::uint32_t kHeaderBytes = 36;
    const auto rate = static_cast<std::uint32_t>(std::lround(waveform.rate_hz));
    const auto data = static_cast<std::uint32_t>(2 * waveform.samples_g.size());
    std::string bytes = "RIFF";
    put(bytes, kHeaderBytes + data, 4);
    bytes += "WAVEfmt ";
    put(bytes, 16, 4);  // bytes of what follows
    put(bytes, 1, 2);   // PCM
    put(bytes, 1, 2);   // channel
    put(bytes, rate, 4);
    put(bytes, 2 * rate, 4);
    put(bytes, 2, 2);  // bytes a frame
    put(bytes, 16, 2);
    bytes += "data";
    put(bytes, data, 4);
    for (const double g : waveform.samples_g) {
        const double share = full_scale_g > 0.0 ? std::clamp(g / full_scale_g, -1.0, 1.0) : 0.0;
        put(bytes, static_cast<std::uint32_t>(std::lround(32767.0 * share)), 2);
    }
    return bytes;
}

std::size_t player_bytes(const Waveform& waveform) {
    return static_cast<std::size_t>(duration_s(waveform) * kPlayerRateHz * 2.0 * 4.0 / 3.0) + 200;
}

std::string player_html(const Waveform& waveform, double full_scale_g, const std::string& name,
                        bool is_ready) {
    const Waveform played = resampled(waveform, kPlayerRateHz);
    return "<audio controls preload=\"" + std::string(is_ready ? "metadata" : "none") +
           "\" aria-label=\"" + html_escaped(name) + "\" src=\"data:audio/wav;base64," +
           base64(wave_bytes(played, full_scale_g)) + "\"></audio>";
}

}  // namespace tact
