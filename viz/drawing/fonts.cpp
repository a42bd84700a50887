#include "viz/drawing/fonts.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include <imgui_freetype.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <filesystem>
#include <set>
#include <vector>

#include "model/text/shown_text.h"
namespace tact {
namespace {

using Characters = std::set<ImWchar>;

constexpr const char* kInter = "/usr/share/fonts/opentype/inter/Inter-";
constexpr const char* kDejaVu = "/usr/share/fonts/truetype/dejavu/DejaVuSans";

// Fonts of other scripts at Debian's paths, tried in this order for what is still missing.
constexpr std::array kFurtherFonts{
    "/usr/share/fonts/opentype/noto/NotoSansCJK-Regular.ttc",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansDevanagari-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansBengali-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansTamil-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansThai-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansArabic-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansHebrew-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSansSymbols2-Regular.ttf",
    "/usr/share/fonts/opentype/ipafont-gothic/ipag.ttf",
    "/usr/share/fonts/truetype/wqy/wqy-zenhei.ttc",
    "/usr/share/fonts/truetype/nanum/NanumGothic.ttf",
    "/usr/share/fonts/truetype/unifont/unifont.ttf",
};

Characters wanted_characters(const std::string& extra_text) {
    static constexpr ImWchar kRanges[] = {
        0x0020, 0x007E, 0x00A0, 0x017F,  // Latin-1, Latin Extended-A
        0x0391, 0x03C9,                  // Greek
        0x2010, 0x2027, 0x2030, 0x203A,  // dashes, quotation marks, ellipsis, per mille, prime
        0x207B, 0x207B, 0x2070, 0x2079,  // superscripts
        0x2190, 0x2195, 0x21BA, 0x21BB, 0x27F2, 0x27F3,                                  // arrows
        0x2212, 0x2212, 0x221E, 0x221E, 0x2248, 0x2248, 0x2260, 0x2260, 0x2264, 0x2265,  // maths
        0x25A0, 0x25A1, 0x25B2, 0x25BD, 0x25C0, 0x25C1, 0x25C6, 0x25CF,                  // shapes
        0x2605, 0x2606, 0x2713, 0x2713, 0x2715, 0x2715, 0x26A0, 0x26A0, 0x2630, 0x2630,
        0xFFFD, 0xFFFD, 0};
    ImFontGlyphRangesBuilder builder;
    builder.AddRanges(kRanges);
    builder.AddText(extra_text.c_str());
    Characters characters;
    for (ImWchar c = 0x20; c < 0xFFFF; ++c) {
        if (builder.GetBit(c) && !is_steering(c)) characters.insert(c);
    }
    return characters;
}

// The part of `wanted` that the font file has; nothing if there is no such file.
Characters covered(FT_Library library, const std::string& path, const Characters& wanted) {
    FT_Face face = nullptr;
    if (FT_New_Face(library, path.c_str(), 0, &face) != 0) return {};
    Characters result;
    for (const ImWchar c : wanted) {
        if (FT_Get_Char_Index(face, c) != 0) result.insert(c);
    }
    FT_Done_Face(face);
    return result;
}

// ImGui's zero-terminated list of first and last characters.
std::vector<ImWchar> ranges_of(const Characters& characters) {
    std::vector<ImWchar> ranges;
    for (const ImWchar c : characters) {
        if (!ranges.empty() && ranges.back() + 1 == c) {
            ranges.back() = c;
        } else {
            ranges.insert(ranges.end(), {c, c});
        }
    }
    ranges.push_back(0);
    return ranges;
}

struct Loader {
    ImFontAtlas& atlas;
    FT_Library library;
    Characters wanted;
    std::deque<std::vector<ImWchar>> ranges;  // must stay where they are until the atlas is built
    std::vector<std::string> files;           // of each entry of the atlas's ConfigData
};

// One size of one face: each file of the chain adds only what the files before it lack.
ImFont* add_font(Loader& loader, float size_px, const std::vector<std::string>& chain) {
    ImFont* font = nullptr;
    Characters missing = loader.wanted;
    for (const std::string& path : chain) {
        const Characters has = covered(loader.library, path, missing);
        if (has.empty()) continue;
        loader.ranges.push_back(ranges_of(has));
        ImFontConfig config;
        config.MergeMode = font != nullptr;
        ImFont* added = loader.atlas.AddFontFromFileTTF(path.c_str(), size_px, &config,
                                                        loader.ranges.back().data());
        if (added == nullptr) continue;
        loader.files.push_back(path);
        if (font == nullptr) font = added;
        std::erase_if(missing, [&](ImWchar c) { return has.contains(c); });
        if (missing.empty()) break;
    }
    if (font != nullptr) return font;
    ImFontConfig config;
    config.SizePixels = std::floor(size_px);
    loader.files.emplace_back();
    return loader.atlas.AddFontDefault(&config);
}

std::vector<std::string> chain_of(const std::string& inter, const std::string& dejavu) {
    std::vector<std::string> chain{kInter + inter, kDejaVu + dejavu, kDejaVu + std::string{".ttf"}};
    chain.insert(chain.end(), kFurtherFonts.begin(), kFurtherFonts.end());
    return chain;
}

// Inter's default figures are proportional and ImGui cannot ask for its tabular ones: give every
// digit the width of the widest and centre it there.
void make_figures_tabular(ImFont& font) {
    float widest = 0.0F;
    for (ImWchar c = '0'; c <= '9'; ++c) widest = std::max(widest, font.GetCharAdvance(c));
    for (ImWchar c = '0'; c <= '9'; ++c) {
        // FindGlyph is const; the glyph is ours to change, and so is its index of widths.
        auto* glyph = const_cast<ImFontGlyph*>(font.FindGlyphNoFallback(c));
        if (glyph == nullptr) return;
        const float shift = std::floor((widest - glyph->AdvanceX) / 2.0F);
        glyph->X0 += shift;
        glyph->X1 += shift;
        glyph->AdvanceX = widest;
        font.IndexAdvanceX[c] = widest;
    }
}

// ImGui's FreeType builder rounds every advance up to whole pixels, which spaces small text out.
// This rounds to the nearest, from the unhinted advances of the font file.
void tighten(FT_Library library, ImFontAtlas& atlas, const std::vector<std::string>& files) {
    for (int i = 0; i < atlas.ConfigData.Size; ++i) {
        FT_Face face = nullptr;
        const std::string& file = files[static_cast<std::size_t>(i)];
        if (FT_New_Face(library, file.c_str(), 0, &face) != 0) continue;
        const ImFontConfig& config = atlas.ConfigData[i];
        FT_Size_RequestRec size{FT_SIZE_REQUEST_TYPE_REAL_DIM, 0, 0, 0, 0};
        size.height = static_cast<FT_Long>(std::lround(config.SizePixels * 64.0F));
        FT_Request_Size(face, &size);
        for (const ImWchar* range = config.GlyphRanges; range[0] != 0; range += 2) {
            for (unsigned c = range[0]; c <= range[1]; ++c) {
                auto* glyph = const_cast<ImFontGlyph*>(
                    config.DstFont->FindGlyphNoFallback(static_cast<ImWchar>(c)));
                if (glyph == nullptr || FT_Load_Char(face, c, FT_LOAD_NO_HINTING) != 0) continue;
                const double advance = static_cast<double>(face->glyph->linearHoriAdvance);
                glyph->AdvanceX = static_cast<float>(std::round(advance / 65536.0));
                config.DstFont->IndexAdvanceX[static_cast<int>(c)] = glyph->AdvanceX;
            }
        }
        FT_Done_Face(face);
    }
}

// A font's design size over the line height that ImGui asks FreeType for; 1 if there is no font.
float em_of(FT_Library library, const std::string& path) {
    FT_Face face = nullptr;
    if (FT_New_Face(library, path.c_str(), 0, &face) != 0) return 1.0F;
    const float em = static_cast<float>(face->units_per_EM) /
                     static_cast<float>(face->ascender - face->descender);
    FT_Done_Face(face);
    return em;
}

// Paints a disc whose edge falls off over one pixel around its radius.
void paint_disc(ImFontAtlas& atlas, const ImFontAtlasCustomRect& rect) {
    const float centre = static_cast<float>(rect.Width) / 2.0F;
    const float radius = centre - 1.0F;
    for (int y = 0; y < rect.Height; ++y) {
        for (int x = 0; x < rect.Width; ++x) {
            const float distance = std::hypot(static_cast<float>(x) + 0.5F - centre,
                                              static_cast<float>(y) + 0.5F - centre);
            const float cover = std::clamp(radius + 0.5F - distance, 0.0F, 1.0F);
            const int at = (rect.Y + y) * atlas.TexWidth + rect.X + x;
            atlas.TexPixelsAlpha8[at] = static_cast<unsigned char>(cover * 255.0F + 0.5F);
        }
    }
}

}  // namespace

std::u32string without_glyph(const ImFont& font, std::string_view text) {
    std::set<char32_t> lacking;
    for (const char* at = text.data(); at < text.data() + text.size();) {
        unsigned int character = 0;
        at += std::max(1, ImTextCharFromUtf8(&character, at, text.data() + text.size()));
        if (character < 0x80 || is_steering(static_cast<char32_t>(character))) continue;
        if (character > IM_UNICODE_CODEPOINT_MAX ||
            font.FindGlyphNoFallback(static_cast<ImWchar>(character)) == nullptr) {
            lacking.insert(static_cast<char32_t>(character));
        }
    }
    return {lacking.begin(), lacking.end()};
}

const char* package_for(std::u32string_view characters) {
    const auto is_hangul = [](char32_t c) {
        return (c >= 0x1100 && c <= 0x11FF) || (c >= 0x3130 && c <= 0x318F) ||
               (c >= 0xAC00 && c <= 0xD7A3);
    };
    const auto is_east_asian = [](char32_t c) { return c >= 0x2E80 && c <= 0xFFEF; };
    if (std::ranges::all_of(characters, is_hangul)) return "The package fonts-nanum";
    if (std::ranges::all_of(characters, is_east_asian)) return "The package fonts-noto-cjk";
    return "The package fonts-noto-core";
}

Fonts load_fonts(ImFontAtlas& atlas, float scale, const std::string& extra_text) {
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) library = nullptr;
    Loader loader{atlas, library, wanted_characters(extra_text), {}, {}};
    const auto regular = chain_of("Regular.otf", ".ttf");
    const auto semibold = chain_of("SemiBold.otf", "-Bold.ttf");

    Fonts fonts;
    constexpr TypeLadder kType;
    const auto load = [&](float size, const std::vector<std::string>& chain) {
        return add_font(loader, std::round(size * scale), chain);
    };
    fonts.regular = load(kType.body, regular);
    fonts.semibold = fonts.title = load(kType.body, semibold);
    fonts.presented = load(kType.presented, regular);
    fonts.fine = load(kType.fine, regular);
    fonts.small = load(kType.small, regular);
    fonts.large = load(kType.large, semibold);
    // Numbers alone: names are never set so large.
    std::erase_if(loader.wanted, [](ImWchar c) { return c > 0xFF; });
    fonts.headline = load(kType.headline, semibold);
    std::array<int, kDiscRadiiPx.size()> discs{};
    for (std::size_t i = 0; i < discs.size(); ++i) {
        const int size = 2 * kDiscRadiiPx[i] + 2;
        discs[i] = atlas.AddCustomRectRegular(size, size);
    }

    atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    atlas.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    atlas.Build();
    tighten(library, atlas, loader.files);
    fonts.em = em_of(library, loader.files.front());
    for (ImFontConfig& config : atlas.ConfigData) config.GlyphRanges = nullptr;  // ours end here
    if (library != nullptr) FT_Done_FreeType(library);

    for (ImFont* font : atlas.Fonts) make_figures_tabular(*font);
    for (std::size_t i = 0; i < discs.size(); ++i) {
        const ImFontAtlasCustomRect& rect = *atlas.GetCustomRectByIndex(discs[i]);
        paint_disc(atlas, rect);
        ImVec2 low;
        ImVec2 high;
        atlas.CalcCustomRectUV(&rect, &low, &high);
        fonts.disc_uv[i] = {low.x, low.y, high.x, high.y};
    }
    return fonts;
}

}  // namespace tact
