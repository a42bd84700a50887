#include "viz/skin/receptor_legend.h"

#include <cmath>
#include <string>

#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"
#include "viz/skin/receptor_caption.h"

namespace tact {
namespace {

// A stripe for each type: they have one scale.
void draw_ramps(ImDrawList& list, const Theme& theme, const Rect& bar) {
    const float stripe_px = bar.height() / static_cast<float>(kReceptorCount);
    for (const Receptor type : kReceptors) {
        const float top = bar.min.y + stripe_px * static_cast<float>(index_of(type));
        draw_ramp(list, theme, {{bar.min.x, top}, {bar.max.x, top + stripe_px}}, type);
    }
}

// A sign and its words, if they fit; returns the place of the next sign.
template <class DrawSign>
float draw_entry(ImDrawList& list, const Theme& theme, const Rect& line, float left, float sign_px,
                 const std::string& words, DrawSign draw_sign) {
    const ImFont* font = theme.fonts.small;
    const float gap = 0.6F * theme.gap_px;
    const float right = left + sign_px + gap + text_size(font, words).x;
    if (right > line.max.x) return line.max.x;  // the signs after it do not fit either
    draw_sign(ImVec2{left + sign_px / 2.0F, line.min.y + 0.55F * font_or_current(font).FontSize});
    draw_text(list, font, {left + sign_px + gap, line.min.y}, theme.dim_text, words);
    return right + 2.0F * theme.gap_px;
}

}  // namespace

void draw_receptor_legend(ImDrawList& list, const Theme& theme, const Rect& line,
                          double largest_hz) {
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    const float mark_px = theme.mark_px;
    const Receptor example = Receptor::pacinian;
    const ImU32 hue = theme.receptor[index_of(example)];
    float left = line.min.x;
    draw_text(list, theme.fonts.small, line.min, theme.dim_text, "0");
    left += text_size(theme.fonts.small, "0").x + 0.6F * theme.gap_px;
    const float bar_px = 64.0F * theme.scale;
    const float high_px = 4.0F * std::round(0.2F * text_px);
    left = draw_entry(list, theme, line, left, bar_px, significant(largest_hz) + " imp/s",
                      [&](ImVec2 at) {
                          const ImVec2 half{bar_px / 2.0F, high_px / 2.0F};
                          draw_ramps(list, theme, {at - half, at + half});
                      });
    left = draw_entry(list, theme, line, left, 4.0F * mark_px, "fires now", [&](ImVec2 at) {
        draw_disc(list, theme, at, 1.8F * mark_px, faded(hue, 0.32F));
        draw_receptor_mark(list, theme, at, mark_px, example, firing_colour(theme, example));
    });
    left = draw_entry(
        list, theme, line, left, 2.5F * mark_px, "beyond the finger\u2019s edge", [&](ImVec2 at) {
            draw_receptor_mark(list, theme, at, mark_px, example, beyond_colour(theme));
        });
    left =
        draw_entry(list, theme, line, left, 4.0F * mark_px, "as far as the type responds",
                   [&](ImVec2 at) { list.AddCircle(at, 1.8F * mark_px, hue, 0, theme.trace_px); });
    draw_entry(
        list, theme, line, left, 4.0F * mark_px, "the probe, and 1 mm around it", [&](ImVec2 at) {
            const ImU32 dim = faded(theme.dim_text, 0.9F);
            list.AddCircle(at, 1.0F * mark_px, dim, 0, theme.hairline_px);
            list.AddCircle(at, 1.8F * mark_px, faded(theme.dim_text, 0.5F), 0, theme.hairline_px);
        });
}

}  // namespace tact
