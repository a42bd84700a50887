// A moving picture as GIF: for programs that take nothing else. 255 colours a picture, chosen for
// what changes in it.
//
// Source    GIF89a (CompuServe 1990); the loop of Netscape 2.0; compression by giflib
// Input     opaque pictures of one size, one after the other
// Output    a file that goes round for ever; times in hundredths of a second
// Left out  dithering, which would change where nothing does
// Exact     same pictures, same bytes, with the same giflib.
#pragma once

#include <string>

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

}  // namespace tact
