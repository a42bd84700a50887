// A moving picture as GIF: for programs that take nothing else. 255 colours a picture, chosen for
// what changes in it.
//
// Source    GIF89a (CompuServe 1990); the loop of Netscape 2.0; compression by giflib
// Input     opaque pictures of one size, one after the other
// Output    a file that goes round for ever; times in hundredths of a second
// Left out  dithering, which would change where nothing does
// Exact     same pictures, same bytes, with the same giflib.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "model/common/expected.h"
#include "viz/picture/picture.h"

struct GifFileType;

namespace tact {

struct GifWriter {
    double frame_s = 0.04;
    std::string bytes{};  // so far: giflib writes to where it is, which must stay
    Image before{};
    GifFileType* file = nullptr;
    int frames = 0;

    explicit GifWriter(double each_s) : frame_s(each_s) {}
    GifWriter(const GifWriter&) = delete;
    GifWriter& operator=(const GifWriter&) = delete;
    ~GifWriter();
};

Expected<Done> add_frame(GifWriter& writer, const Image& image);

// The file; nothing can be added to the writer any more.
Expected<std::string> finished(GifWriter& writer);

// The few colours that stand best for the many of a picture. Private to moving pictures.
//
// Source    median cut: Heckbert 1982, Color image quantization for frame buffer display
// Output    as many as asked for at most; all of them as they are where they are few enough
// Exact     same pixels, same palette

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
