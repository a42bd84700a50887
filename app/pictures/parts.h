// Parts that the files of this room share.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

#include "app/pictures/pictures.h"
#include "viz/drawing/geometry.h"

namespace tact {

// What pictures of single views share. Private to them.

// `extra_text`: letters that the picture needs besides the usual ones.
PictureOptions options_of(const PictureSize& size, std::string extra_text);

Rect whole_picture();

// Title at the top left, a dim detail after it, cut where the picture ends; what is left below.
Rect draw_title(const Theme& theme, const std::string& title, const std::string& detail);

// Other programs that take what we make: whether they are there, and writing to them.

// In a folder of PATH.
bool is_installed(const std::string& program);

// All of it; a program that has gone is false, not the end of ours.
bool write_unharmed(std::FILE* to, const void* bytes, std::size_t count);

}  // namespace tact
