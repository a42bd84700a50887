#include "viz/picture/frame_text.h"

#include <cmath>

namespace tact {
namespace {

constexpr float kUnbounded = 1e9F;
constexpr float kSamePx = 0.25F;  // pens are on whole pixels at most sizes, and exact at all

// Where a point of the texture lies in the glyph's own coordinates: pixels of the font's size,
// from the pen at the top of the line.
ImVec2 in_glyph(const ImFontGlyph& g, ImVec2 uv) {
    return {g.X0 + (uv.x - g.U0) / (g.U1 - g.U0) * (g.X1 - g.X0),
            g.Y0 + (uv.y - g.V0) / (g.V1 - g.V0) * (g.Y1 - g.Y0)};
}

// By its corner; a quad whose left or top was cut begins inside the glyph's place.
const FontGlyph* find(const GlyphIndex& index, ImVec2 low, ImVec2 high) {
    const auto found = index.find({low.x, low.y});
    if (found != index.end()) return &found->second;
    for (const auto& [corner, candidate] : index) {
        const ImFontGlyph& g = *candidate.glyph;
        if (low.x >= g.U0 && low.y >= g.V0 && high.x <= g.U1 && high.y <= g.V1) return &candidate;
    }
    return nullptr;
}

float along(ImVec2 direction, ImVec2 p) { return direction.x * p.x + direction.y * p.y; }
float across(ImVec2 direction, ImVec2 p) { return direction.x * p.y - direction.y * p.x; }

float advance_px(const ImFont& font, float size_px, ImWchar character) {
    return font.GetCharAdvance(character) * size_px / font.FontSize;
}

// ImGui cuts the quads of level text at the sides of a fine clip.
std::optional<Rect> kept_of(const ImFontGlyph& g, const TexturedQuad& quad) {
    const bool whole = quad[0].uv.x == g.U0 && quad[0].uv.y == g.V0 && quad[2].uv.x == g.U1 &&
                       quad[2].uv.y == g.V1;
    if (whole) return std::nullopt;
    Rect kept{{-kUnbounded, -kUnbounded}, {kUnbounded, kUnbounded}};
    if (quad[0].uv.x > g.U0) kept.min.x = quad[0].pos.x;
    if (quad[0].uv.y > g.V0) kept.min.y = quad[0].pos.y;
    if (quad[2].uv.x < g.U1) kept.max.x = quad[2].pos.x;
    if (quad[2].uv.y < g.V1) kept.max.y = quad[2].pos.y;
    return kept;
}

}  // namespace

GlyphIndex glyph_index(const Fonts& fonts) {
    GlyphIndex index;
    for (const ImFont* font : {fonts.regular, fonts.semibold, fonts.presented, fonts.small,
                               fonts.fine, fonts.large, fonts.headline}) {
        if (font == nullptr) continue;
        for (const ImFontGlyph& glyph : font->Glyphs) {
            if (glyph.Visible != 0) index.insert({{glyph.U0, glyph.V0}, {font, &glyph}});
        }
    }
    return index;
}

std::optional<DrawnGlyph> glyph_of(const GlyphIndex& index, const TexturedQuad& quad) {
    const FontGlyph* found = find(index, quad[0].uv, quad[2].uv);
    if (found == nullptr) return std::nullopt;
    const ImFontGlyph& g = *found->glyph;
    const ImVec2 corner = in_glyph(g, quad[0].uv);
    const float glyph_width = in_glyph(g, quad[2].uv).x - corner.x;
    const ImVec2 side = quad[1].pos - quad[0].pos;
    const float width = std::hypot(side.x, side.y);
    if (!(width > 0.0F) || !(glyph_width > 0.0F)) return std::nullopt;
    const float scale = width / glyph_width;

    DrawnGlyph drawn;
    drawn.character = static_cast<ImWchar>(g.Codepoint);
    drawn.font = found->font;
    drawn.size_px = scale * found->font->FontSize;
    drawn.direction = side * (1.0F / width);
    drawn.along_px = along(drawn.direction, quad[0].pos) - scale * corner.x;
    const float baseline = std::round(found->font->Ascent);  // as the font builder rounds it
    drawn.across_px = across(drawn.direction, quad[0].pos) + scale * (baseline - corner.y);
    drawn.box = {quad[0].pos, quad[0].pos};
    for (const ImDrawVert& v : quad) drawn.box = around(drawn.box, {v.pos, v.pos});
    drawn.kept = kept_of(g, quad);
    return drawn;
}

TextRun run_of(const DrawnGlyph& glyph) {
    TextRun run;
    run.characters = {glyph.character};
    run.along_px = {glyph.along_px};
    run.across_px = glyph.across_px;
    run.direction = glyph.direction;
    run.font = glyph.font;
    run.size_px = glyph.size_px;
    run.box = glyph.box;
    run.kept = glyph.kept;
    return run;
}

bool extend(TextRun& run, const DrawnGlyph& glyph) {
    const bool same_type = run.font == glyph.font &&
                           std::abs(run.size_px - glyph.size_px) < 0.02F * run.size_px &&
                           along(run.direction, glyph.direction) > 0.999F;
    if (!same_type || std::abs(run.across_px - glyph.across_px) > kSamePx) return false;
    const ImFont& font = *run.font;
    const float end = run.along_px.back() + advance_px(font, run.size_px, run.characters.back());
    const float gap = glyph.along_px - end;
    const bool spaced = std::abs(gap - advance_px(font, run.size_px, ' ')) <= kSamePx;
    if (!spaced && std::abs(gap) > kSamePx) return false;
    if (spaced) {
        run.characters.push_back(' ');
        run.along_px.push_back(end);
    }
    run.characters.push_back(glyph.character);
    run.along_px.push_back(glyph.along_px);
    run.box = around(run.box, glyph.box);
    if (glyph.kept) run.kept = run.kept ? common(*run.kept, *glyph.kept) : *glyph.kept;
    return true;
}

std::optional<float> offset_of_copy(const TextRun& a, const TextRun& b) {
    const bool same_type =
        a.font == b.font && a.size_px == b.size_px && along(a.direction, b.direction) > 0.999F;
    if (!same_type || a.characters != b.characters) return std::nullopt;
    return std::max(std::abs(a.along_px.front() - b.along_px.front()),
                    std::abs(a.across_px - b.across_px));
}

}  // namespace tact
