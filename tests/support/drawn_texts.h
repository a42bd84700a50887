// The texts of a frame, and which of them meet, or are cut off.
//
// Two texts meet where both are to be seen: one that a plate or a window lies over is not. Up and
// down a pane may scroll; to the sides nothing may leave it.
#pragma once

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "model/text/utf8.h"
#include "viz/drawing/fonts.h"
#include "viz/picture/frame_shapes.h"

namespace tact {

struct DrawnText {
    std::string words;
    Rect box;    // of the ink
    Rect shown;  // what a clip leaves of it
    std::size_t order = 0;
    bool upright = true;
};

struct DrawnTexts {
    std::vector<DrawnText> texts;
    std::vector<std::pair<std::size_t, Rect>> plates;  // opaque, with their order
};

inline std::string words_of(const TextRun& run) {
    std::string words;
    for (const ImWchar character : run.characters) {
        char letters[5];
        words += ImTextCharToUtf8(letters, character);
    }
    return words;
}

inline DrawnTexts texts_of(const ImDrawData& frame, const Fonts& fonts) {
    DrawnTexts drawn;
    std::size_t order = 0;
    for (const Shape& shape : shapes_of(frame, fonts)) {
        ++order;
        const bool opaque = (shape.colour >> IM_COL32_A_SHIFT) == 0xFFU;
        if (const auto* plate = std::get_if<Rect>(&shape.form)) {
            if (opaque)
                drawn.plates.push_back({order, shape.clip ? common(*plate, *shape.clip) : *plate});
        }
        if (const auto* rounded = std::get_if<Polygons>(&shape.form);
            rounded != nullptr && opaque) {
            for (const auto& outline : rounded->outlines) {
                Rect box{outline.front(), outline.front()};
                for (const ImVec2 corner : outline) box = around(box, {corner, corner});
                drawn.plates.push_back({order, shape.clip ? common(box, *shape.clip) : box});
            }
        }
        const auto* run = std::get_if<TextRun>(&shape.form);
        if (run == nullptr) continue;
        Rect shown = run->box;
        if (shape.clip) shown = common(shown, *shape.clip);
        if (run->kept) shown = common(shown, *run->kept);
        drawn.texts.push_back({words_of(*run), run->box, shown, order, run->direction.x > 0.99F});
    }
    return drawn;
}

inline bool meet(const Rect& a, const Rect& b) {
    constexpr float kTouchPx = 1.0F;  // soft edges
    return a.min.x + kTouchPx < b.max.x && b.min.x + kTouchPx < a.max.x &&
           a.min.y + kTouchPx < b.max.y && b.min.y + kTouchPx < a.max.y;
}

inline bool covers(const Rect& plate, const Rect& what) {
    return plate.min.x <= what.min.x && plate.min.y <= what.min.y && plate.max.x >= what.max.x &&
           plate.max.y >= what.max.y;
}

// "this | that", of all that are written over each other.
inline std::vector<std::string> met(const DrawnTexts& drawn) {
    std::vector<std::string> found;
    const auto is_covered = [&drawn](const Rect& what, std::size_t after, std::size_t before) {
        return std::ranges::any_of(drawn.plates, [&](const auto& plate) {
            return plate.first > after && plate.first < before && covers(plate.second, what);
        });
    };
    for (std::size_t i = 0; i < drawn.texts.size(); ++i) {
        for (std::size_t j = i + 1; j < drawn.texts.size(); ++j) {
            const DrawnText& under = drawn.texts[i];
            const DrawnText& over = drawn.texts[j];
            if (!meet(under.shown, over.shown)) continue;
            if (is_covered(common(under.shown, over.shown), under.order, over.order)) continue;
            found.push_back(under.words + " | " + over.words);
        }
    }
    return found;
}

// Those whose sides are cut off, and those of which a line is left that nobody can read: cut from
// above or below where nothing scrolls.
inline std::vector<std::string> cut(const DrawnTexts& drawn) {
    constexpr float kSoftPx = 1.5F;
    std::vector<std::string> found;
    for (const DrawnText& text : drawn.texts) {
        if (!(text.shown.min.x < text.shown.max.x) || !(text.shown.min.y < text.shown.max.y))
            continue;
        if (text.box.min.x < text.shown.min.x - kSoftPx ||
            text.box.max.x > text.shown.max.x + kSoftPx) {
            found.push_back(text.words);
        }
    }
    return found;
}

}  // namespace tact
