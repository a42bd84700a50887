#include "viz/drawing/marks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "model/text/shown_text.h"
#include "viz/drawing/colour.h"

namespace tact {

namespace {

// Bytes of the UTF-8 character that starts here; 1 for what is not UTF-8.
std::size_t character_bytes(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text.front());
    const std::size_t bytes = lead < 0xC0U ? 1 : lead < 0xE0U ? 2 : lead < 0xF0U ? 3 : 4;
    return std::min(bytes, text.size());
}

// The smallest baked disc that is not smaller than this one.
const ImVec4& disc_uv_for(const Fonts& fonts, float radius_px, float& baked_px) {
    std::size_t i = 0;
    while (i + 1 < kDiscRadiiPx.size() && static_cast<float>(kDiscRadiiPx[i]) < radius_px) ++i;
    baked_px = static_cast<float>(kDiscRadiiPx[i]);
    return fonts.disc_uv[i];
}

}  // namespace

const ImFont& font_or_current(const ImFont* font) {
    return font != nullptr ? *font : *ImGui::GetFont();
}

ImVec2 text_size(const ImFont* font, std::string_view text) {
    if (has_steering(text)) return text_size(font, shown_text(text));
    const ImFont& used = font_or_current(font);
    if (text.empty()) return {0.0F, used.FontSize};  // ImGui would measure a text without an end
    return used.CalcTextSizeA(used.FontSize, 1e9F, 0.0F, text.data(), text.data() + text.size());
}

void draw_text(ImDrawList& list, const ImFont* font, ImVec2 corner, ImU32 colour,
               std::string_view text) {
    if (text.empty()) return;
    if (has_steering(text)) return draw_text(list, font, corner, colour, shown_text(text));
    const ImFont& used = font_or_current(font);
    list.AddText(&used, used.FontSize, corner, colour, text.data(), text.data() + text.size());
}

void draw_text_halo(ImDrawList& list, const ImFont* font, ImVec2 corner, ImU32 colour, ImU32 halo,
                    float width_px, std::string_view text) {
    // Four diagonal copies cover the four straight ones; whole pixels, as glyphs snap to them.
    const float w = whole_px(width_px);
    for (const ImVec2 step : {ImVec2{-w, -w}, ImVec2{w, -w}, ImVec2{-w, w}, ImVec2{w, w}}) {
        draw_text(list, font, corner + step, halo, text);
    }
    draw_text(list, font, corner, colour, text);
}

void draw_text_upwards(ImDrawList& list, const ImFont* font, ImVec2 corner, ImU32 colour,
                       std::string_view text) {
    const ImVec2 pivot{std::floor(corner.x), std::floor(corner.y)};
    const int first = list.VtxBuffer.Size;
    // Turned text must not be clipped where the level one would have been, beyond the screen too.
    const ImVec2 size = text_size(font, text);
    list.PushClipRect({pivot.x - 1.0F, pivot.y - size.x - 1.0F},
                      {pivot.x + std::max(size.x, size.y) + 1.0F, pivot.y + size.y + 1.0F});
    draw_text(list, font, pivot, colour, text);
    list.PopClipRect();
    for (int i = first; i < list.VtxBuffer.Size; ++i) {
        ImVec2& p = list.VtxBuffer[i].pos;
        p = {pivot.x + (p.y - pivot.y), pivot.y - (p.x - pivot.x)};
    }
}

float whole_px(float width_px) { return std::max(1.0F, std::round(width_px)); }

void draw_level_line(ImDrawList& list, float y, float left, float right, float width_px,
                     ImU32 colour) {
    const float top = std::round(y - width_px / 2.0F);
    list.AddRectFilled({left, top}, {right, top + whole_px(width_px)}, colour);
}

void draw_upright_line(ImDrawList& list, float x, float top, float bottom, float width_px,
                       ImU32 colour) {
    const float left = std::round(x - width_px / 2.0F);
    list.AddRectFilled({left, top}, {left + whole_px(width_px), bottom}, colour);
}

void draw_path(ImDrawList& list, std::span<const ImVec2> points, ImU32 colour, float width_px) {
    constexpr std::size_t kPiece = 2048;
    for (std::size_t begin = 0; begin + 1 < points.size(); begin += kPiece) {
        // Each piece begins where the one before it ended.
        const std::size_t count = std::min(kPiece + 1, points.size() - begin);
        list.AddPolyline(points.data() + begin, static_cast<int>(count), colour, 0, width_px);
    }
}

std::string shortened(const ImFont* font, std::string_view text, float width_px) {
    if (has_steering(text)) return shortened(font, shown_text(text), width_px);
    if (text_size(font, text).x <= width_px) return std::string{text};
    std::size_t kept = 0;
    while (kept < text.size()) {
        const std::size_t next = kept + character_bytes(text.substr(kept));
        if (text_size(font, std::string{text.substr(0, next)} + "…").x > width_px) break;
        kept = next;
    }
    return std::string{text.substr(0, kept)} + "…";
}

void draw_disc(ImDrawList& list, const Theme& theme, ImVec2 centre, float radius_px, ImU32 colour) {
    float baked_px = 0.0F;
    const ImVec4& uv = disc_uv_for(theme.fonts, radius_px, baked_px);
    if (uv.z <= uv.x) {
        list.AddCircleFilled(centre, radius_px, colour);
        return;
    }
    const float half = radius_px * (baked_px + 1.0F) / baked_px;  // the margin is scaled with it
    list.PrimReserve(6, 4);
    list.PrimRectUV({centre.x - half, centre.y - half}, {centre.x + half, centre.y + half},
                    {uv.x, uv.y}, {uv.z, uv.w}, colour);
}

void draw_pattern_mark(ImDrawList& list, const Theme& theme, ImVec2 centre, float radius_px,
                       const PatternLook& look, ImU32 ground) {
    draw_disc(list, theme, centre, radius_px, look.colour);
    if (look.ring) draw_disc(list, theme, centre, radius_px * 0.5F, ground);
}

void draw_selection_ring(ImDrawList& list, const Theme& theme, ImVec2 centre, float radius_px) {
    const float step = 1.5F * theme.scale;
    const ImU32 ink = readable_on(theme.pane);
    const ImU32 ground = readable_on(ink);
    draw_disc(list, theme, centre, radius_px + 3.6F * step, ground);
    draw_disc(list, theme, centre, radius_px + 2.8F * step, ink);
    draw_disc(list, theme, centre, radius_px + 1.4F * step, ground);
}

void draw_selection_frame(ImDrawList& list, const Theme& theme, const Rect& area) {
    const ImU32 ink = readable_on(theme.pane);
    const float line = theme.hairline_px;
    const auto frame = [&](float inner_px, ImU32 colour) {
        const ImVec2 in{inner_px, inner_px};
        list.AddRect(area.min + in, area.max - in, colour, theme.rounding_px, 0, line);
    };
    frame(0.5F * line, ink);
    frame(1.5F * line, readable_on(ink));
}

void draw_receptor_mark(ImDrawList& list, const Theme& theme, ImVec2 centre, float radius_px,
                        Receptor receptor) {
    draw_receptor_mark(list, theme, centre, radius_px, receptor,
                       theme.receptor[index_of(receptor)]);
}

// Half sides for the area pi r^2: square sqrt(pi)/2 r, triangle (equilateral, from its centre to a
// corner) sqrt(4 pi / (3 sqrt 3)) r, diamond sqrt(pi / 2) r.
void draw_receptor_mark(ImDrawList& list, const Theme& theme, ImVec2 centre, float radius_px,
                        Receptor receptor, ImU32 colour) {
    switch (receptor) {
        case Receptor::meissner:
            draw_disc(list, theme, centre, radius_px, colour);
            return;
        case Receptor::pacinian: {
            const float half = 0.886F * radius_px;
            list.AddRectFilled({centre.x - half, centre.y - half},
                               {centre.x + half, centre.y + half}, colour);
            return;
        }
        case Receptor::merkel: {
            const float corner = 1.555F * radius_px;
            const float side = 0.866F * corner;
            const float base = centre.y + 0.5F * corner;
            list.AddTriangleFilled({centre.x, centre.y - corner}, {centre.x + side, base},
                                   {centre.x - side, base}, colour);
            return;
        }
        case Receptor::ruffini: {
            const float d = 1.253F * radius_px;
            list.AddQuadFilled({centre.x, centre.y - d}, {centre.x + d, centre.y},
                               {centre.x, centre.y + d}, {centre.x - d, centre.y}, colour);
            return;
        }
    }
}

void draw_stale(ImDrawList& list, const Theme& theme, const Rect& area, double time_s) {
    if (area.empty()) return;
    list.AddRectFilled(area.min, area.max, faded(theme.pane, 0.55F));
    const float pitch = 14.0F * theme.scale;
    const float phase = static_cast<float>(std::fmod(time_s * 0.5, 1.0)) * pitch;
    const ImU32 colour = faded(theme.dim_text, 0.16F);
    list.PushClipRect(area.min, area.max, true);
    for (float x = area.min.x - area.height() + phase; x < area.max.x; x += pitch) {
        list.AddLine({x, area.max.y}, {x + area.height(), area.min.y}, colour, theme.hairline_px);
    }
    list.PopClipRect();
}

std::vector<std::string> wrapped(const ImFont* font, std::string_view text, float width_px) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        std::size_t kept = 0;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
            if (kept > 0 && text_size(font, text.substr(0, end)).x > width_px) break;
            kept = end;
            at = end + 1;
            if (end < text.size() && text[end] == '\n') break;
        }
        lines.push_back(shortened(font, text.substr(0, kept), width_px));
        text.remove_prefix(std::min(kept + 1, text.size()));
    }
    return lines;
}

void draw_empty(ImDrawList& list, const Theme& theme, const Rect& area, std::string_view title,
                std::string_view reason) {
    const Fonts& f = theme.fonts;
    const std::string head = shortened(f.regular, title, area.width());
    const ImVec2 head_size = text_size(f.regular, head);
    const ImVec2 middle = area.centre();
    draw_text(list, f.regular, {middle.x - head_size.x / 2, middle.y - head_size.y}, theme.text,
              head);
    float y = middle.y + 4.0F * theme.scale;
    for (const std::string& line : wrapped(f.small, reason, area.width())) {
        const ImVec2 size = text_size(f.small, line);
        draw_text(list, f.small, {middle.x - size.x / 2, y}, theme.dim_text, line);
        y += size.y;
    }
}

void draw_readout(ImDrawList& list, const Theme& theme, const Rect& bounds, ImVec2 at,
                  std::span<const std::string> lines) {
    const float pad = 6.0F * theme.scale;
    ImVec2 size{0, 0};
    for (const std::string& line : lines) {
        const ImVec2 extent = text_size(theme.fonts.small, line);
        size = {std::max(size.x, extent.x), size.y + extent.y};
    }
    size = size + ImVec2{2 * pad, 2 * pad};
    const float away = 12.0F * theme.scale;
    Rect plate = rect_at({at.x + away, at.y - away - size.y}, size);
    if (plate.max.x > bounds.max.x) plate = rect_at({at.x - away - size.x, plate.min.y}, size);
    plate = moved_into(plate, bounds);
    list.AddRectFilled(plate.min, plate.max, faded(theme.hover, 0.96F), theme.rounding_px);
    ImVec2 corner = plate.min + ImVec2{pad, pad};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        draw_text(list, theme.fonts.small, corner, i == 0 ? theme.text : theme.dim_text, lines[i]);
        corner.y += text_size(theme.fonts.small, lines[i]).y;
    }
}

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
