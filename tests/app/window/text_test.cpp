// For every file and size of the window: no text overlaps another one, and none leaves its pane.

#include "tests/support/drawn_texts.h"
#include "tests/support/scenes.h"

namespace text_test {

using namespace tact;

namespace {

struct Screen {
    ImVec2 size;
    float scale;
};

// A drawing whose shapes can be read back from its triangles.
void draw_exactly() {
    ImGuiStyle& style = ImGui::GetStyle();
    style.AntiAliasedLines = false;
    style.AntiAliasedLinesUseTex = false;
    style.AntiAliasedFill = false;
}

// Every visible slider is large enough to aim at.
void check_sliders(const SceneWindow& window) {
    constexpr float kLeastPx = 80.0F;
    for (const auto& [name, place] : window.places) {
        if (!name.starts_with("slider:")) continue;
        CAPTURE(name);
        CHECK(place.max.x - place.min.x >= kLeastPx * window.app.ui.theme.scale - 1.0F);
    }
}

}  // namespace

TEST_CASE("text: whatever is open, at any size, none is written over another or cut off" *
          doctest::test_suite("long")) {
    SceneWindow window;
    for (const Screen& screen :
         {Screen{{1280.0F, 720.0F}, 1.0F}, Screen{{1600.0F, 1000.0F}, 1.0F},
          Screen{{2560.0F, 1440.0F}, 1.0F}, Screen{{3840.0F, 2160.0F}, 2.0F},
          Screen{{1600.0F, 1000.0F}, 0.75F}, Screen{{1600.0F, 1000.0F}, 1.5F},
          Screen{{1600.0F, 1000.0F}, 2.0F}}) {
        CAPTURE(screen.size.x);
        CAPTURE(screen.scale);
        window.resize(screen.size, screen.scale);
        const bool is_extreme = screen.size.y < 800.0F || screen.scale == 2.0F;
        for (const Scene& scene : scenes()) {
            if (scene.is_costly && !is_extreme) continue;
            CAPTURE(scene.name);
            window.show(scene);
            draw_exactly();
            window.frame();
            const DrawnTexts drawn = texts_of(*ImGui::GetDrawData(), window.app.ui.theme.fonts);
            CHECK(drawn.texts.size() > 3);  // a page of a participant has few
            check_sliders(window);
            for (const std::string& both : met(drawn)) FAIL_CHECK("written over: " << both);
            for (const std::string& one : cut(drawn)) FAIL_CHECK("cut off: " << one);
        }
    }
}

// Every glyph is read back from its triangles; a missing one is drawn as U+FFFD.
TEST_CASE("text: a name that would steer what shows it is drawn by the numbers of its characters" *
          doctest::test_suite("long")) {
    const std::string sign = "\u202e##\u009b";
    SceneWindow window(0.2, sign);
    window.resize({1600.0F, 1000.0F}, 1.0F);
    bool is_seen = false;
    for (const Scene& scene : scenes()) {
        if (scene.is_costly) continue;
        CAPTURE(scene.name);
        window.show(scene);
        draw_exactly();
        window.frame();
        for (const DrawnText& text :
             texts_of(*ImGui::GetDrawData(), window.app.ui.theme.fonts).texts) {
            is_seen |= text.words.find("\\u202e") != text.words.npos;
            if (text.words.find("\ufffd") != text.words.npos) FAIL_CHECK("raw: " << text.words);
        }
    }
    CHECK(is_seen);
}

}  // namespace text_test
