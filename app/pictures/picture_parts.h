// What pictures of single views share. Private to them.
#pragma once

#include <string>

#include "app/pictures/pictures.h"
#include "viz/drawing/geometry.h"

namespace tact {

// `extra_text`: letters that the picture needs besides the usual ones.
PictureOptions options_of(const PictureSize& size, std::string extra_text);

Rect whole_picture();

// Title at the top left, a dim detail after it, cut where the picture ends; what is left below.
Rect draw_title(const Theme& theme, const std::string& title, const std::string& detail);

}  // namespace tact
