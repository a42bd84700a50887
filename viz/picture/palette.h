// The few colours that stand best for the many of a picture. Private to moving pictures.
//
// Source    median cut: Heckbert 1982, Color image quantization for frame buffer display
// Output    as many as asked for at most; all of them as they are where they are few enough
// Exact     same pixels, same palette
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace tact {

struct Rgb {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;

    bool operator==(const Rgb&) const = default;
};

struct Palette {
    std::vector<Rgb> colours;
    std::unordered_map<std::uint32_t, std::uint8_t> known;  // of colours looked up already
};

Palette palette_of(const std::vector<Rgb>& pixels, std::size_t most);

// The nearest of the palette.
std::uint8_t nearest_colour(Palette& palette, Rgb colour);

}  // namespace tact
