// The part of a picture that the next one has to paint again. Private to moving pictures.
#pragma once

#include "viz/picture/picture.h"

namespace tact {

// In whole pixels; of no change one pixel at the corner, as no format takes none.
struct ChangedArea {
    int x = 0;
    int y = 0;
    int width = 1;
    int height = 1;
};

// The smallest area outside of which two pictures of one size are alike.
ChangedArea changed_area(const Image& before, const Image& after);

// The bytes of a pixel.
const std::uint8_t* bytes_at(const Image& image, int x, int y);
bool is_same_pixel(const Image& a, const Image& b, int x, int y);

}  // namespace tact
