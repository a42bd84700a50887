// WAV files made by hand, byte by byte: no library between the test and the format.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

inline void put_number(std::string& bytes, std::uint64_t value, int length) {
    for (int k = 0; k < length; ++k) bytes += static_cast<char>(value >> (8 * k) & 0xFF);
}

struct WaveBytes {
    int rate_hz = 10'000;
    int channels = 1;
    int bits = 16;
    bool is_float = false;
    std::vector<double> samples;  // frame by frame, 1 is full scale

    std::string data() const {
        std::string bytes;
        for (const double sample : samples) {
            if (is_float && bits == 32) {
                put_number(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(sample)), 4);
            } else if (is_float) {
                put_number(bytes, std::bit_cast<std::uint64_t>(sample), 8);
            } else {
                const double full_scale = std::ldexp(1.0, bits - 1);
                const auto value = static_cast<std::int64_t>(std::lround(sample * full_scale));
                const std::int64_t offset = bits == 8 ? 128 : 0;  // 8 bits have no sign
                put_number(bytes, static_cast<std::uint64_t>(value + offset), bits / 8);
            }
        }
        return bytes;
    }

    std::string format() const {
        std::string bytes;
        const int frame_bytes = channels * bits / 8;
        put_number(bytes, is_float ? 3 : 1, 2);
        put_number(bytes, static_cast<std::uint64_t>(channels), 2);
        put_number(bytes, static_cast<std::uint64_t>(rate_hz), 4);
        put_number(bytes, static_cast<std::uint64_t>(rate_hz) * static_cast<unsigned>(frame_bytes),
                   4);
        put_number(bytes, static_cast<std::uint64_t>(frame_bytes), 2);
        put_number(bytes, static_cast<std::uint64_t>(bits), 2);
        return bytes;
    }

    static std::string chunk(const std::string& name, const std::string& content) {
        std::string bytes = name;
        put_number(bytes, content.size(), 4);
        bytes += content;
        if (content.size() % 2 == 1) bytes += '\0';
        return bytes;
    }

    std::string file() const {
        const std::string content =
            "WAVE" + chunk("fmt ", format()) + chunk("LIST", "odd") + chunk("data", data());
        return chunk("RIFF", content);
    }
};
