#include "viz/picture/program_icon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "viz/drawing/colour.h"

namespace tact {

namespace {

// In the units of the drawing, which is 128 wide.
constexpr float kSide = 128.0F;

struct Spot {
    float x;
    float y;
};

struct Disc {
    Spot centre;
    float radius;
    ImU32 colour;
};

constexpr std::array kDiscs{Disc{{34, 38}, 8, rgb(0xE69F00)}, Disc{{66, 28}, 6, rgb(0x009E73)},
                            Disc{{94, 46}, 10, rgb(0x56B4E9)}};

// The tops and feet of the wave, which swings evenly from one to the next.
constexpr std::array kSwings{Spot{18, 84},  Spot{28, 80},  Spot{37, 93},  Spot{46, 69},
                             Spot{55, 105}, Spot{64, 62},  Spot{73, 105}, Spot{82, 70},
                             Spot{91, 92},  Spot{100, 81}, Spot{110, 84}};
constexpr float kWaveHalf = 3.0F;

float wave_at(float x) {
    std::size_t k = 1;
    while (k + 1 < kSwings.size() && kSwings[k].x < x) ++k;
    const Spot from = kSwings[k - 1];
    const Spot to = kSwings[k];
    const float share = std::clamp((x - from.x) / (to.x - from.x), 0.0F, 1.0F);
    return from.y + (to.y - from.y) * 0.5F * (1.0F - std::cos(std::numbers::pi_v<float> * share));
}

bool is_on_wave(Spot at) {
    // Most of the icon is above it: nothing is to be looked for there.
    constexpr float kTop = 62.0F;
    constexpr float kFoot = 105.0F;
    if (at.y < kTop - kWaveHalf || at.y > kFoot + kWaveHalf) return false;
    for (float x = at.x - kWaveHalf; x <= at.x + kWaveHalf; x += 0.5F) {
        const float on = std::clamp(x, kSwings.front().x, kSwings.back().x);
        if (std::hypot(at.x - on, at.y - wave_at(on)) <= kWaveHalf) return true;
    }
    return false;
}

bool is_on_plate(Spot at) {
    constexpr float kHalf = 56.0F;
    constexpr float kRound = 24.0F;
    const float x = std::max(0.0F, std::abs(at.x - 0.5F * kSide) - (kHalf - kRound));
    const float y = std::max(0.0F, std::abs(at.y - 0.5F * kSide) - (kHalf - kRound));
    return std::hypot(x, y) <= kRound;
}

std::optional<ImU32> colour_at(Spot at) {
    for (const Disc& disc : kDiscs) {
        if (std::hypot(at.x - disc.centre.x, at.y - disc.centre.y) <= disc.radius)
            return disc.colour;
    }
    if (is_on_wave(at)) return rgb(0x56B4E9);
    if (is_on_plate(at)) return rgb(0x14181D);
    return std::nullopt;
}

}  // namespace

Image program_icon(int side) {
    constexpr int kSamples = 4;  // along each side of a pixel
    Image image{side, side, {}};
    image.rgba.reserve(static_cast<std::size_t>(4 * side * side));
    const float step = kSide / static_cast<float>(side * kSamples);
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            std::array<int, 3> sum{};
            int covered = 0;
            for (int k = 0; k < kSamples * kSamples; ++k) {
                const Spot at{(static_cast<float>(column * kSamples + k % kSamples) + 0.5F) * step,
                              (static_cast<float>(row * kSamples + k / kSamples) + 0.5F) * step};
                const auto colour = colour_at(at);
                if (!colour) continue;
                ++covered;
                sum[0] += static_cast<int>((*colour >> IM_COL32_R_SHIFT) & 0xFFU);
                sum[1] += static_cast<int>((*colour >> IM_COL32_G_SHIFT) & 0xFFU);
                sum[2] += static_cast<int>((*colour >> IM_COL32_B_SHIFT) & 0xFFU);
            }
            for (const int channel : sum) {
                image.rgba.push_back(
                    static_cast<std::uint8_t>(covered > 0 ? channel / covered : 0));
            }
            image.rgba.push_back(static_cast<std::uint8_t>(255 * covered / (kSamples * kSamples)));
        }
    }
    return image;
}

}  // namespace tact
