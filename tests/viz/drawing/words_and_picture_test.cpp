// Lists and tables beside or above the picture that belongs to them.
#include "viz/drawing/marks.h"

#include <doctest/doctest.h>

namespace words_and_picture_test {

using namespace tact;

namespace {

constexpr WordsWanted kList{150.0F, 420.0F, 340.0F};
const ImVec2 kLeast{110.0F, 170.0F};
constexpr float kGap = 8.0F;

WordsAndPicture in(float width, float height) {
    return words_and_picture(rect_at({10.0F, 20.0F}, {width, height}), kList, kLeast, kGap);
}

}  // namespace

TEST_CASE("words and picture: in a column the picture is below, in a wide pane beside") {
    const WordsAndPicture column = in(690.0F, 1200.0F);
    CHECK(column.picture.min.y >= column.words.max.y);
    CHECK(column.words.height() == 340.0F);
    CHECK(column.picture.width() == 690.0F);
    const WordsAndPicture wide = in(2000.0F, 900.0F);
    CHECK(wide.picture.min.x >= wide.words.max.x);
    CHECK(wide.words.width() == 420.0F);
    CHECK(wide.picture.height() == 900.0F);
}

TEST_CASE("words and picture: in a small pane the words are as wide as they must, or alone") {
    const WordsAndPicture low = in(320.0F, 280.0F);
    CHECK(low.words.width() >= 150.0F);
    CHECK_FALSE(low.picture.empty());
    const WordsAndPicture tiny = in(200.0F, 160.0F);
    CHECK(tiny.picture.empty());
    CHECK(tiny.words.size().x == 200.0F);
}

TEST_CASE("words and picture: neither leaves the pane, and they never meet") {
    for (float width = 60.0F; width < 2600.0F; width += 97.0F) {
        for (float height = 60.0F; height < 2000.0F; height += 97.0F) {
            const Rect area = rect_at({10.0F, 20.0F}, {width, height});
            const WordsAndPicture parts = words_and_picture(area, kList, kLeast, kGap);
            CHECK(area.contains(parts.words));
            CHECK((parts.picture.empty() || area.contains(parts.picture)));
            CHECK_FALSE((!parts.picture.empty() && parts.words.intersects(parts.picture)));
            CHECK((parts.picture.empty() || parts.picture.height() <= height));
        }
    }
}

}  // namespace words_and_picture_test
