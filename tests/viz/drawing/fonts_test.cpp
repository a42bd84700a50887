#include "viz/drawing/fonts.h"

#include <doctest/doctest.h>

#include <filesystem>

namespace tact::fonts_test {

TEST_CASE("fonts: the sizes are those of the design, times the scale") {
    ImFontAtlas atlas;
    const Fonts fonts = load_fonts(atlas, 2.0F, "");
    CHECK(fonts.regular->FontSize == 30.0F);
    CHECK(fonts.semibold->FontSize == 30.0F);
    CHECK(fonts.small->FontSize == 26.0F);
    CHECK(fonts.large->FontSize == 40.0F);
    CHECK(fonts.title->FontSize == 30.0F);
    CHECK(fonts.headline->FontSize == 56.0F);
    CHECK(fonts.fine->FontSize == 24.0F);
}

TEST_CASE("fonts: units, minus and the letters of neighbouring languages are there") {
    ImFontAtlas atlas;
    const Fonts fonts = load_fonts(atlas, 1.0F, "");
    if (fonts.regular->FontSize != 15.0F) return;  // no font installed: ImGui's own
    for (const ImWchar c : std::initializer_list<ImWchar>{0xB5, 0x3B1, 0x2212, 0x2026, 0x17E}) {
        CHECK(fonts.regular->FindGlyphNoFallback(c) != nullptr);
    }
}

TEST_CASE("fonts: a script beyond Latin and Greek comes with the names that need it") {
    if (!std::filesystem::exists("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf")) return;
    ImFontAtlas without;
    CHECK(load_fonts(without, 1.0F, "").regular->FindGlyphNoFallback(0x416) == nullptr);
    ImFontAtlas with;
    const Fonts fonts = load_fonts(with, 1.0F, "Жук ע");
    CHECK(fonts.regular->FindGlyphNoFallback(0x416) != nullptr);
    CHECK(fonts.small->FindGlyphNoFallback(0x5E2) != nullptr);
}

TEST_CASE("fonts: all digits are equally wide") {
    ImFontAtlas atlas;
    const Fonts fonts = load_fonts(atlas, 1.0F, "");
    for (const ImFont* font :
         {fonts.regular, fonts.semibold, fonts.title, fonts.small, fonts.fine, fonts.large}) {
        for (ImWchar c = '1'; c <= '9'; ++c) {
            CHECK(font->GetCharAdvance(c) == font->GetCharAdvance('0'));
        }
    }
}

TEST_CASE("fonts: the texture holds discs, opaque inside and clear at the corners") {
    ImFontAtlas atlas;
    const Fonts fonts = load_fonts(atlas, 1.0F, "");
    for (const ImVec4& uv : fonts.disc_uv) {
        const auto alpha_at = [&](float u, float v) {
            const int x = static_cast<int>(u * static_cast<float>(atlas.TexWidth));
            const int y = static_cast<int>(v * static_cast<float>(atlas.TexHeight));
            return static_cast<int>(atlas.TexPixelsAlpha8[y * atlas.TexWidth + x]);
        };
        CHECK(alpha_at((uv.x + uv.z) / 2, (uv.y + uv.w) / 2) == 255);
        CHECK(alpha_at(uv.x + 1e-5F, uv.y + 1e-5F) == 0);
    }
}

}  // namespace tact::fonts_test
