#include "viz/skin/network_caption.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {
namespace {

constexpr float kCaptionLine = 1.15F;  // relative to its font's size

std::string centre_text(const NetworkScene& scene, std::size_t k) {
    const double centre = scene.layers[k].centre();
    const std::string exact = tick_text(centre);
    return "centre " + (exact.size() > 4 ? significant(centre) : exact);
}

// A line of words and symbols filled from the left, as long as there is room.
struct Line {
    ImDrawList& list;
    const Theme& theme;
    const Rect& place;
    float left;
};

float gap_px(const Line& line) { return 0.6F * line.theme.gap_px; }

bool fits(const Line& line, float symbols_px, const std::string& words) {
    return line.left + symbols_px + text_size(line.theme.fonts.small, words).x <= line.place.max.x;
}

void add_words(Line& line, const std::string& words) {
    draw_text(line.list, line.theme.fonts.small, {line.left, line.place.min.y}, line.theme.dim_text,
              words);
    line.left += text_size(line.theme.fonts.small, words).x + gap_px(line);
}

// Colours from one share of the scale to another.
void add_ramp(Line& line, float width_px, double from, double to) {
    constexpr int kSteps = 20;
    const float text_px = font_or_current(line.theme.fonts.small).FontSize;
    const float middle = line.place.min.y + 0.55F * text_px;
    for (int i = 0; i < kSteps; ++i) {
        line.list.AddRectFilled(
            {std::round(line.left + width_px * static_cast<float>(i) / kSteps),
             std::round(middle - 0.25F * text_px)},
            {std::round(line.left + width_px * static_cast<float>(i + 1) / kSteps),
             std::round(middle + 0.25F * text_px)},
            viridis(from + (to - from) * (i + 0.5) / kSteps));
    }
    line.left += width_px + gap_px(line);
}

void add_diamond(Line& line) {
    const float text_px = font_or_current(line.theme.fonts.small).FontSize;
    const float half = 0.4F * text_px;
    const ImVec2 middle{line.left + half, line.place.min.y + 0.55F * text_px};
    const std::array<ImVec2, 4> corners{{{middle.x, middle.y - half},
                                         {middle.x + half, middle.y},
                                         {middle.x, middle.y + half},
                                         {middle.x - half, middle.y}}};
    line.list.AddPolyline(corners.data(), 4, line.theme.text, ImDrawFlags_Closed,
                          line.theme.hairline_px);
    line.left += 2.0F * half + gap_px(line);
}

}  // namespace

ImU32 activity_colour(double spikes, double cap) {
    return viridis(cap > 0.0 ? std::sqrt(std::max(0.0, spikes / cap)) : 0.0);
}

float caption_width_px(const Theme& theme, const NetworkScene& scene) {
    float widest = text_size(theme.fonts.small, "centre 00.0").x;
    for (const std::string& name : scene.names) {
        widest = std::max(widest, text_size(theme.fonts.small, name).x);
    }
    return widest;
}

void draw_layer_caption(ImDrawList& list, const Theme& theme, const Rect& caption, bool beside,
                        const NetworkScene& scene, std::size_t k) {
    if (caption.empty()) return;
    const ImFont* font = theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    const bool last = k + 1 == scene.layers.size();
    float top = caption.min.y + 0.2F * text_px;
    if (beside) top = caption.centre().y - kCaptionLine * text_px;
    const auto line = [&](const std::string& words, ImU32 colour) {
        if (top + text_px > caption.max.y + 0.5F) return;
        const std::string text = shortened(font, words, caption.width());
        const float width = text_size(font, text).x;
        if (width > caption.width()) return;
        const float left = beside ? caption.min.x : caption.centre().x - width / 2.0F;
        draw_text(list, font, {std::floor(left), top}, colour, text);
        top += kCaptionLine * text_px;
    };
    line(scene.names[k], theme.text);
    line(centre_text(scene, k), last ? theme.series : theme.dim_text);
}

void draw_network_legend(ImDrawList& list, const Theme& theme, const Rect& place, double cap) {
    if (place.empty()) return;
    Line line{list, theme, place, place.min.x};
    const float ramp_px = 32.0F * theme.scale;
    const float gaps_px = 4.0F * gap_px(line);
    // The middle of a root scale is a quarter of its end.
    const std::string middle = significant(cap / 4.0);
    const std::string high = tick_text(cap) + " spikes, the cap";
    if (!fits(line, 2.0F * ramp_px + gaps_px, "0" + middle + high)) return;
    add_words(line, "0");
    add_ramp(line, ramp_px, 0.0, 0.5);
    add_words(line, middle);
    add_ramp(line, ramp_px, 0.5, 1.0);
    add_words(line, high);
    line.left += theme.gap_px;
    const std::string cone = "cells that reach the centre";
    if (!fits(line, font_or_current(theme.fonts.small).FontSize + gap_px(line), cone)) return;
    add_diamond(line);
    add_words(line, cone);
}

}  // namespace tact
