// A moving picture as APNG: as many colours as there are, and no library but zlib.
//
// Source    PNG, third edition (W3C 2023), chunks acTL, fcTL, fdAT; CRC of its annex D
// Input     opaque pictures of one size, one after the other
// Output    a file that programs without APNG show the first picture of
// Left out  rows are not filtered: what stays the same from picture to picture is left transparent,
//           which packs better than any filter
// Exact     same pictures, same bytes, with the same zlib.
#pragma once

#include <cstdint>
#include <string>

#include "viz/picture/picture.h"

namespace tact {

struct ApngWriter {
    double frame_s = 0.04;
    std::string bytes{};  // so far
    Image before{};
    std::uint32_t frames = 0;
    std::uint32_t chunks = 0;  // of frames: they are numbered
};

void add_frame(ApngWriter& writer, const Image& image);

// The file; the writer is then empty.
std::string finished(ApngWriter& writer);

}  // namespace tact
