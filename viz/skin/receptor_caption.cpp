#include "viz/skin/receptor_caption.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kFaintest = 0.30F;  // opacity of the type's colour, at a value of 0

enum class Flush { middle, left };

// The left edge of a text of this width, centred in a line.
float left_of(const Rect& line, float width_px, Flush flush) {
    return flush == Flush::left ? line.min.x : line.centre().x - width_px / 2.0F;
}

bool is_activated(const ReceptorScene& scene) {
    return scene.grid != nullptr && scene.activation.radius_mm > 0.0;
}

// The type's mark and name, and the number of activated receptors.
void draw_name(ImDrawList& list, const Theme& theme, const Rect& line, const ReceptorScene& scene,
               Flush flush) {
    const ImFont* font = theme.fonts.regular;
    const float mark_px = 3.2F * theme.mark_px;
    const float room = line.width() - mark_px;
    std::string name = traits(scene.receptor).name;
    std::string count;
    if (is_activated(scene)) {
        count = "  " + std::to_string(scene.grid->activated);
        const std::string unit = scene.grid->activated == 1 ? " receptor" : " receptors";
        if (text_size(font, name + count + unit).x <= room) count += unit;
    }
    if (text_size(font, name + count).x > room) count.clear();
    name = shortened(font, name, room);
    if (name == "\u2026") name.clear();  // the mark identifies it
    const float name_px = text_size(font, name).x;
    const float width = mark_px + name_px + text_size(font, count).x;
    const float left = left_of(line, width, flush);
    const float text_px = font_or_current(font).FontSize;
    const ImU32 hue = theme.receptor[index_of(scene.receptor)];
    draw_receptor_mark(list, theme, {left + theme.mark_px, line.min.y + 0.55F * text_px},
                       0.9F * theme.mark_px, scene.receptor, hue);
    draw_text(list, font, {left + mark_px, line.min.y}, hue, name);
    draw_text(list, font, {left + mark_px + name_px, line.min.y}, theme.text, count);
}

void draw_legend(ImDrawList& list, const Theme& theme, const Rect& line, const ReceptorScene& scene,
                 Flush flush) {
    const bool rates = scene.quantity == ReceptorQuantity::rate;
    const double largest = scene.largest_hz > 0.0 ? scene.largest_hz : centre_hz(scene);
    const std::string high = rates ? significant(largest) + " imp/s" : "amplitude at the probe";
    const ImFont* font = theme.fonts.small;
    const float text_px = font_or_current(font).FontSize;
    const float gap = 0.6F * theme.gap_px;
    const float bar_px = 44.0F * theme.scale;
    const float low_px = text_size(font, "0").x;
    const float width = low_px + bar_px + text_size(font, high).x + 2.0F * gap;
    if (width > line.width()) return;
    const float left = std::round(left_of(line, width, flush));
    draw_text(list, font, {left, line.min.y}, theme.dim_text, "0");
    const Rect bar = rect_at({left + low_px + gap, line.min.y + 0.3F * text_px},
                             {bar_px, std::round(0.5F * text_px)});
    draw_ramp(list, theme, bar, scene.receptor);
    draw_text(list, font, {bar.max.x + gap, line.min.y}, theme.dim_text, high);
}

bool has_legend(const ReceptorScene& scene) { return scene.legend && is_activated(scene); }

// "centre fires 345 in 1 s, 11.5 a cycle"; for a type that only leaks, a remark on that.
std::string counted_text(const ReceptorScene& scene, const char* fires) {
    const std::string count =
        std::to_string(*scene.centre_spikes) + " in " + tick_text(scene.duration_s) + " s";
    if (scene.only_leaks) return "filter leak: " + count;
    const std::string times = significant(scene.times_a_cycle, 2) + " a cycle";
    return fires + count + (scene.times_a_cycle > 0.0 ? ", " + times : "");
}

// All lines of receptor_state_text().
std::vector<std::string> state_lines(const ReceptorScene& scene) {
    if (!is_activated(scene) || scene.silent || !scene.centre_spikes) {
        return {receptor_state_text(scene, nullptr, 1e6F)};
    }
    return {counted_text(scene, "centre fires "),
            "rate by Eq. 2: " + significant(scene.activation.rate_hz) + " imp/s",
            "as far as " + significant(scene.activation.radius_mm, 2) + " mm"};
}

// The longest of 1, 2, 5 and 10 mm that fits into this number of pixels; 0: none.
double bar_length_mm(float px_per_mm, float most_px) {
    double length_mm = 0.0;
    for (const double candidate_mm : {1.0, 2.0, 5.0, 10.0}) {
        if (static_cast<float>(candidate_mm) * px_per_mm <= most_px) length_mm = candidate_mm;
    }
    return length_mm;
}

}  // namespace

std::string receptor_state_text(const ReceptorScene& scene, const ImFont* font, float room_px) {
    std::vector<std::string> wordings{"not computed yet"};
    if (scene.grid != nullptr && scene.activation.radius_mm <= 0.0) {
        wordings = {"below threshold", "silent"};
    } else if (scene.grid != nullptr && scene.silent) {
        wordings = {"nothing in its band", "silent"};
    } else if (scene.grid != nullptr) {
        const std::string rate = significant(scene.activation.rate_hz) + " imp/s";
        const std::string radius =
            ", as far as " + significant(scene.activation.radius_mm, 2) + " mm";
        wordings = {rate + radius, rate};
        if (scene.centre_spikes) {
            const std::string count = std::to_string(*scene.centre_spikes);
            const std::string centre = counted_text(scene, "centre fires ");
            const std::string fires = counted_text(scene, "fires ");
            const std::string in_short = scene.only_leaks ? "filter leak" : count + " spikes";
            wordings = {centre + " (rate by Eq. 2: " + rate + ")" + radius,
                        centre + radius,
                        fires + radius,
                        fires,
                        in_short,
                        scene.only_leaks ? "leak" : count};
        }
    }
    for (const std::string& wording : wordings) {
        if (text_size(font, wording).x <= room_px) return wording;
    }
    return {};
}

float caption_line_px(const Theme& theme) {
    return 1.25F * font_or_current(theme.fonts.small).FontSize;
}

ImU32 value_colour(const Theme& theme, Receptor receptor, double value) {
    return mixed(skin_colour(theme), theme.receptor[index_of(receptor)],
                 kFaintest + (1.0F - kFaintest) * static_cast<float>(value));
}

// The text's colour, which is most visible in either theme, with a touch of the type's.
ImU32 firing_colour(const Theme& theme, Receptor receptor) {
    return mixed(theme.receptor[index_of(receptor)], theme.text, theme.is_dark ? 0.9F : 0.75F);
}

ImU32 beyond_colour(const Theme& theme) { return mixed(theme.pane, theme.dim_text, 0.45F); }

void draw_ramp(ImDrawList& list, const Theme& theme, const Rect& bar, Receptor receptor) {
    constexpr int kSteps = 24;
    for (int i = 0; i < kSteps; ++i) {
        const float from = std::round(bar.min.x + bar.width() * static_cast<float>(i) / kSteps);
        const float to = std::round(bar.min.x + bar.width() * static_cast<float>(i + 1) / kSteps);
        list.AddRectFilled({from, bar.min.y}, {to, bar.max.y},
                           value_colour(theme, receptor, (i + 0.5) / kSteps));
    }
}

void draw_caption(ImDrawList& list, const Theme& theme, const Rect& caption,
                  const ReceptorScene& scene) {
    if (caption.empty()) return;
    const float text_px = caption_line_px(theme);
    Rect line = rect_at(caption.min, {caption.width(), 1.15F * text_px});
    draw_name(list, theme, line, scene, Flush::middle);
    line = rect_at({line.min.x, line.max.y}, {line.width(), text_px});
    if (line.max.y > caption.max.y + 0.5F) return;
    const ImFont* font = theme.fonts.small;
    const std::string state = receptor_state_text(scene, font, line.width());
    draw_text(list, font, {line.centre().x - text_size(font, state).x / 2.0F, line.min.y},
              theme.dim_text, state);
    line = rect_at({line.min.x, line.max.y}, {line.width(), text_px});
    if (!has_legend(scene) || line.max.y > caption.max.y + 0.5F) return;
    draw_legend(list, theme, line, scene, Flush::middle);
}

float least_caption_px(const Theme& theme) {
    const float name_px = 3.2F * theme.mark_px + text_size(theme.fonts.regular, "Meissner  0000").x;
    return std::max(name_px, text_size(theme.fonts.small, "fires 000 in 00.0 s").x);
}

void draw_caption_beside(ImDrawList& list, const Theme& theme, const Rect& caption,
                         const ReceptorScene& scene, float px_per_mm) {
    if (caption.empty()) return;
    const ImFont* font = theme.fonts.small;
    const float line_px = caption_line_px(theme);
    const float name_px = 1.15F * line_px;
    const float left_px = caption.height() - name_px;
    const auto fitting = static_cast<std::size_t>(std::max(0.0F, left_px / line_px));
    std::vector<std::string> state = state_lines(scene);
    const auto is_wide = [&](const std::string& line) {
        return text_size(font, line).x > caption.width();
    };
    if (state.size() > fitting || std::ranges::any_of(state, is_wide)) {
        state = {receptor_state_text(scene, font, caption.width())};
    }
    const double bar_mm = bar_length_mm(px_per_mm, 0.5F * caption.width());
    const bool legend = has_legend(scene) && state.size() < fitting;
    const bool bar = bar_mm > 0.0 && state.size() + (legend ? 1 : 0) < fitting;
    const std::size_t lines = state.size() + (legend ? 1 : 0) + (bar ? 1 : 0);
    const float height = name_px + line_px * static_cast<float>(std::min(lines, fitting));
    float top = std::round(std::max(caption.min.y, caption.centre().y - height / 2.0F));
    const auto next_line = [&](float px) {
        top += px;
        return rect_at({caption.min.x, top - px}, {caption.width(), px});
    };
    draw_name(list, theme, next_line(name_px), scene, Flush::left);
    if (fitting == 0) return;
    for (const std::string& words : state) {
        draw_text(list, font, next_line(line_px).min, theme.dim_text, words);
    }
    if (legend) draw_legend(list, theme, next_line(line_px), scene, Flush::left);
    if (!bar) return;
    const Rect line = next_line(line_px);
    const float length_px = static_cast<float>(bar_mm) * px_per_mm;
    const float text_px = font_or_current(font).FontSize;
    draw_level_line(list, line.min.y + 0.55F * text_px, line.min.x, line.min.x + length_px,
                    1.5F * theme.scale, theme.dim_text);
    draw_text(list, font, {line.min.x + length_px + 0.6F * theme.gap_px, line.min.y},
              theme.dim_text, tick_text(bar_mm) + " mm");
}

void draw_scale_bar(ImDrawList& list, const Theme& theme, const Rect& map, float right_px,
                    float px_per_mm) {
    if (map.height() < 4.0F * font_or_current(theme.fonts.small).FontSize) return;
    const ImVec2 left{map.max.x + 0.5F * theme.gap_px, map.max.y - 2.0F * theme.scale};
    const double length_mm =
        bar_length_mm(px_per_mm, std::min(0.5F * map.width(), right_px - left.x));
    const std::string text = tick_text(length_mm) + " mm";
    if (length_mm <= 0.0 || left.x + text_size(theme.fonts.small, text).x > right_px) return;
    const float length = static_cast<float>(length_mm) * px_per_mm;
    draw_level_line(list, left.y, left.x, left.x + length, 1.5F * theme.scale, theme.dim_text);
    const float text_px = font_or_current(theme.fonts.small).FontSize;
    draw_text(list, theme.fonts.small, {left.x, left.y - text_px - 3.0F * theme.scale},
              theme.dim_text, text);
}

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
