// Painting only what changed gives the picture that painting all gives, in the program's real
// frames.
#include "viz/picture/frame_damage.h"

#include <doctest/doctest.h>

#include "tests/support/program.h"
#include "viz/picture/picture.h"

namespace frame_damage_test {

using namespace tact;

namespace {

AlphaTexture atlas() {
    AlphaTexture texture;
    unsigned char* alpha = nullptr;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&alpha, &texture.width, &texture.height);
    texture.alpha = alpha;
    return texture;
}

void fill(Image& image, const Rect& rect, ImU32 colour) {
    for (int y = static_cast<int>(rect.min.y); y < static_cast<int>(rect.max.y); ++y) {
        for (int x = static_cast<int>(rect.min.x); x < static_cast<int>(rect.max.x); ++x) {
            auto* pixel = image.rgba.data() + 4 * (y * image.width + x);
            for (int c = 0; c < 4; ++c) {
                pixel[c] = static_cast<std::uint8_t>(colour >> (8 * c));
            }
        }
    }
}

struct Screens {
    Image kept;
    FramePrint print;
    double painted = 0.0;  // share of the last frame

    // The frame as the window paints it, and as a whole.
    bool same_as_whole(ImDrawData& frame, ImU32 background) {
        const auto width = static_cast<int>(frame.DisplaySize.x);
        const auto height = static_cast<int>(frame.DisplaySize.y);
        if (kept.rgba.empty()) kept = blank_image(width, height, background);
        FramePrint now = print_of(frame, background);
        painted = 0.0;
        for (const Rect& rect : damage(print, now)) {
            fill(kept, rect, background);
            ClippedFrame clipped(frame, rect);
            rasterise(*clipped.data(), atlas(), kept);
            painted += static_cast<double>(rect.width() * rect.height()) / (width * height);
        }
        print = std::move(now);
        Image whole = blank_image(width, height, background);
        rasterise(frame, atlas(), whole);
        return whole == kept;
    }
};

}  // namespace

TEST_CASE("frame damage: while things move, the kept picture is the whole one" *
          doctest::test_suite("long")) {
    Program program(short_patterns(4));
    ImGui::GetIO().DisplaySize = {1000.0F, 700.0F};
    program.wait_for_stages();
    Screens screens;
    const auto check = [&] {
        program.frame();
        CHECK(screens.same_as_whole(*ImGui::GetDrawData(), program.app.ui.theme.background));
    };
    check();
    CHECK(screens.painted == 1.0);
    program.app.timeline.playhead = {.at_s = 0.01, .speed = 0.1, .playing = true, .loop = true};
    for (int k = 0; k < 5; ++k) check();
    CHECK(screens.painted < 0.5);
    program.app.timeline.playhead.playing = false;
    program.hover(program.at("plot:brain").middle());
    for (int k = 0; k < 3; ++k) check();
    program.click("stage:receptors");
    check();
    program.click("row:p2");
    check();
    program.press('p', true);  // the palette: another window on top
    check();
    program.press_key(key::kEscape);
    check();
}

TEST_CASE("frame damage: a frame like the last one needs no paint") {
    Program program(short_patterns(2));
    Screens screens;
    for (int k = 0; k < 60; ++k) program.frame();  // tooltips and eases end
    screens.same_as_whole(*ImGui::GetDrawData(), program.app.ui.theme.background);
    program.frame();
    CHECK(screens.same_as_whole(*ImGui::GetDrawData(), program.app.ui.theme.background));
    CHECK(screens.painted == 0.0);
}

TEST_CASE("frame damage: another size or background is painted whole") {
    FramePrint before{{100.0F, 50.0F}, 1, {}, {}};
    FramePrint now = before;
    CHECK(damage(before, now).empty());
    now.background = 2;
    CHECK(damage(before, now).size() == 1);
    now = before;
    now.size.x = 101.0F;
    REQUIRE(damage(before, now).size() == 1);
    CHECK(damage(before, now)[0].width() == 101.0F);
}

TEST_CASE("frame damage: it is never more than a few rectangles, whatever changed") {
    FramePrint before{{1000.0F, 1000.0F}, 0, {"a"}, {{}}};
    FramePrint now = before;
    for (std::uint64_t k = 0; k < 30; ++k) {
        const auto at = static_cast<float>(30 * k);
        now.commands[0].push_back({k + 1, {{at, at}, {at + 4.0F, at + 4.0F}}});
    }
    const std::vector<Rect> marked = damage(before, now, 8);
    CHECK(marked.size() <= 8);
    for (const CommandPrint& print : now.commands[0]) {
        CHECK(std::any_of(marked.begin(), marked.end(),
                          [&](const Rect& rect) { return rect.contains(print.area); }));
    }
}

}  // namespace frame_damage_test
