#include "viz/drawing/words_and_picture.h"

#include <algorithm>
#include <cmath>

namespace tact {

namespace {

// Beside a picture, words that scroll are better than a picture that is a strip.
constexpr float kShareOfWords = 0.48F;

bool has_room(const Rect& picture, ImVec2 least_px) {
    return picture.width() >= least_px.x && picture.height() >= least_px.y;
}

WordsAndPicture beside(const Rect& area, const WordsWanted& words, float gap_px) {
    const float wanted = std::max(words.least_px, kShareOfWords * area.width());
    const float x = area.min.x + std::floor(std::min(words.most_px, wanted));
    return {{area.min, {x, area.max.y}}, {{x + gap_px, area.min.y}, area.max}};
}

WordsAndPicture below(const Rect& area, const WordsWanted& words, float gap_px) {
    const float y = area.min.y + std::ceil(words.height_px);
    const float top = y + gap_px;
    return {{area.min, {area.max.x, y}},
            {{area.min.x, top}, {area.max.x, std::min(area.max.y, top + area.width())}}};
}

// Side of the largest square in it: neither a strip nor a column shows much.
float worth(const Rect& picture) { return std::min(picture.width(), picture.height()); }

}  // namespace

WordsAndPicture words_and_picture(const Rect& area, const WordsWanted& words,
                                  ImVec2 least_picture_px, float gap_px) {
    const WordsAndPicture side = beside(area, words, gap_px);
    const WordsAndPicture under = below(area, words, gap_px);
    const bool has_side = has_room(side.picture, least_picture_px);
    const bool has_under = has_room(under.picture, least_picture_px);
    if (has_under && (!has_side || worth(under.picture) >= worth(side.picture))) return under;
    if (has_side) return side;
    return {area, {area.max, area.max}};
}

}  // namespace tact
