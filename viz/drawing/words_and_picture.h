// How a list, a table or a text shares a pane with the picture that belongs to it.
//
// Left out  moving the border by hand.
#pragma once

#include "viz/drawing/geometry.h"

namespace tact {

struct WordsWanted {
    float least_px;   // narrower they cannot be read
    float most_px;    // wider they are no easier to read
    float height_px;  // all of them, at that width
};

struct WordsAndPicture {
    Rect words;
    Rect picture;  // empty: there is no room for it
};

// Beside each other, or the picture below, whichever lets the picture be larger: it has what the
// words leave, but is no higher than wide. Pure, for tests.
WordsAndPicture words_and_picture(const Rect& area, const WordsWanted& words,
                                  ImVec2 least_picture_px, float gap_px);

}  // namespace tact
