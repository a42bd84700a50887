#include "viz/skin/receptor_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/skin/receptor_caption.h"

namespace tact {
namespace {

constexpr float kPickSlackPx = 4.0F;

float flash_of(const ReceptorScene& scene, std::size_t i) {
    return i < scene.flash.size() ? std::clamp(scene.flash[i], 0.0F, 1.0F) : 0.0F;
}

ImU32 hue_of(const Theme& theme, const ReceptorScene& scene) {
    return theme.receptor[index_of(scene.receptor)];
}

// Neighbours never touch, not even while they flash (then 1.35 times as large).
float mark_radius_px(const Theme& theme, const ReceptorLayout& layout, const ReceptorScene& scene) {
    const double radius_mm = std::min(0.33 * scene.grid->interval_mm, 0.45);
    return std::max(theme.scale, static_cast<float>(radius_mm) * layout.skin.px_per_mm);
}

struct Mark {
    ImVec2 at;
    float radius;
    float foot_y;  // diameter relative to the spacing on the skin
    double value;
    float flash;
    bool beyond;  // the finger's edge
};

std::vector<Mark> marks_of(const Theme& theme, const ReceptorLayout& layout,
                           const ReceptorScene& scene) {
    const float radius = mark_radius_px(theme, layout, scene);
    std::vector<Mark> marks;
    marks.reserve(scene.grid->receptors.size());
    for (const GridReceptor& receptor : scene.grid->receptors) {
        const float flash = flash_of(scene, marks.size());
        const double value = shown_value(scene, receptor.distance_mm);
        const ImVec2 at =
            to_pixel(layout.skin, scene.grid->x_mm(receptor), scene.grid->y_mm(receptor), value);
        const float foot_y = at.y + static_cast<float>(value) * layout.skin.height_px;
        const bool beyond =
            !is_on_fingertip(scene.grid->x_mm(receptor), scene.grid->y_mm(receptor));
        marks.push_back({at, radius * (1.0F + 0.35F * flash), foot_y, value, flash, beyond});
    }
    return marks;
}

// The probe, the hot zone around it, and the largest radius of a responding receptor.
void draw_zones(ImDrawList& list, const Theme& theme, const ReceptorLayout& layout,
                const ReceptorScene& scene) {
    const ImU32 dim = faded(theme.dim_text, 0.5F);
    draw_skin_circle(list, layout.skin, kHotZoneMm, 0.0, dim, theme.hairline_px);
    draw_skin_circle(list, layout.skin, kProbeRadiusMm, 0.0, faded(theme.dim_text, 0.9F),
                     theme.hairline_px);
    if (scene.activation.radius_mm <= 0.0) return;
    draw_skin_circle(list, layout.skin, scene.activation.radius_mm, 0.0,
                     faded(hue_of(theme, scene), 0.75F), theme.trace_px);
}

// The value as a surface over the skin: constant in the hot zone, falling beyond.
void draw_surface(ImDrawList& list, const Theme& theme, const ReceptorLayout& layout,
                  const ReceptorScene& scene) {
    constexpr int kRings = 7;
    constexpr int kMeridians = 18;
    const double reach_mm = scene.activation.radius_mm;
    if (layout.skin.height_px <= 0.0F || reach_mm <= kHotZoneMm) return;
    const ImU32 ink = faded(hue_of(theme, scene), 0.28F * std::min(1.0F, scene.tilted));
    const auto radius_mm = [&](int ring) {
        return kHotZoneMm * std::pow(reach_mm / kHotZoneMm, static_cast<double>(ring) / kRings);
    };
    for (int ring = 0; ring < kRings; ++ring) {
        draw_skin_circle(list, layout.skin, radius_mm(ring), shown_value(scene, radius_mm(ring)),
                         ink, theme.hairline_px);
    }
    for (int meridian = 0; meridian < kMeridians; ++meridian) {
        const double turn = 2.0 * std::numbers::pi * meridian / kMeridians;
        std::array<ImVec2, kRings + 1> points;
        for (int ring = 0; ring <= kRings; ++ring) {
            const double r = radius_mm(ring);
            points[static_cast<std::size_t>(ring)] = to_pixel(
                layout.skin, r * std::cos(turn), r * std::sin(turn), shown_value(scene, r));
        }
        list.AddPolyline(points.data(), kRings + 1, ink, 0, theme.hairline_px);
    }
}

// From the skin up to each mark.
void draw_stems(ImDrawList& list, const Theme& theme, const ReceptorLayout& layout,
                const ReceptorScene& scene, std::span<const Mark> marks) {
    if (layout.skin.height_px <= 0.0F) return;
    for (const Mark& mark : marks) {
        const ImU32 ink = faded(value_colour(theme, scene.receptor, mark.value), 0.45F);
        draw_upright_line(list, mark.at.x, mark.at.y, mark.foot_y, theme.hairline_px, ink);
    }
}

void draw_mark(ImDrawList& list, const Theme& theme, const ReceptorScene& scene, const Mark& mark) {
    const ImU32 grey = beyond_colour(theme);
    const ImU32 resting = mark.beyond ? grey : value_colour(theme, scene.receptor, mark.value);
    const ImU32 firing =
        mark.beyond ? mixed(grey, theme.dim_text, 0.6F) : firing_colour(theme, scene.receptor);
    draw_receptor_mark(list, theme, mark.at, mark.radius, scene.receptor,
                       mixed(resting, firing, mark.flash));
}

void draw_ringed(ImDrawList& list, const Theme& theme, const ReceptorScene& scene, const Mark& mark,
                 ImU32 ring) {
    draw_disc(list, theme, mark.at, mark.radius + 5.0F * theme.scale, ring);
    draw_disc(list, theme, mark.at, mark.radius + 3.0F * theme.scale, skin_colour(theme));
    draw_mark(list, theme, scene, mark);
}

// The selected one and the one under the mouse, over all others.
void draw_asked_for(ImDrawList& list, const Theme& theme, const ReceptorScene& scene,
                    std::span<const Mark> marks, std::optional<std::size_t> pointed) {
    if (pointed && *pointed < marks.size() && pointed != scene.selected) {
        draw_ringed(list, theme, scene, marks[*pointed], theme.text);
    }
    if (scene.selected && *scene.selected < marks.size()) {
        draw_ringed(list, theme, scene, marks[*scene.selected], theme.accent);
    }
}

// Resting marks first, then a glow under firing ones, then their marks: nothing hides a spike.
void draw_marks(ImDrawList& list, const Theme& theme, const ReceptorScene& scene,
                std::span<const Mark> marks) {
    std::vector<std::size_t> order(marks.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    if (scene.tilted > 0.0F) {
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return marks[i].foot_y; });
    }
    for (const std::size_t i : order) {
        if (marks[i].flash <= 0.0F) draw_mark(list, theme, scene, marks[i]);
    }
    const ImU32 glow = hue_of(theme, scene);
    for (const Mark& mark : marks) {
        if (mark.flash <= 0.0F || mark.beyond) continue;
        draw_disc(list, theme, mark.at, 1.8F * mark.radius, faded(glow, 0.32F * mark.flash));
    }
    for (const std::size_t i : order) {
        if (marks[i].flash > 0.0F) draw_mark(list, theme, scene, marks[i]);
    }
}

// The nearest mark within reach of the mouse.
std::optional<std::size_t> nearest(const Theme& theme, std::span<const Mark> marks, ImVec2 mouse) {
    std::optional<std::size_t> best;
    float least = 1e9F;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const ImVec2 away = mouse - marks[i].at;
        const float distance = std::hypot(away.x, away.y);
        if (distance > marks[i].radius + kPickSlackPx * theme.scale || distance >= least) continue;
        least = distance;
        best = i;
    }
    return best;
}

ReceptorAction read_mouse(const char* id, const Theme& theme, const Rect& area, const Rect& map,
                          std::span<const Mark> marks) {
    ImGui::SetCursorScreenPos(area.min);
    const bool clicked = ImGui::InvisibleButton(id, area.size());
    ReceptorAction action;
    if (!ImGui::IsItemHovered()) return action;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (map.contains(mouse)) action.hovered = nearest(theme, marks, mouse);
    if (action.hovered) {
        action.hovered_at = marks[*action.hovered].at;
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    }
    if (clicked) action.clicked = action.hovered;
    action.clicked_empty = clicked && !action.hovered;
    return action;
}

}  // namespace

double centre_hz(const ReceptorScene& scene) {
    const bool is_known = scene.centre_spikes && scene.duration_s > 0.0;
    return is_known ? *scene.centre_spikes / scene.duration_s : scene.activation.rate_hz;
}

double shown_value(const ReceptorScene& scene, double distance_mm) {
    if (scene.activation.radius_mm <= 0.0) return 0.0;
    if (scene.quantity == ReceptorQuantity::amplitude) {
        const double near = kHotZoneMm / std::max(distance_mm, kHotZoneMm);
        return near * near;
    }
    const double centre = centre_hz(scene);
    const double largest = scene.largest_hz > 0.0 ? scene.largest_hz : centre;
    if (largest <= 0.0 || scene.activation.rate_hz <= 0.0) return 0.0;
    // Receptors share impulses in the ratio of their rates.
    const double share = rate_at_hz(scene.activation, distance_mm) / scene.activation.rate_hz;
    return std::clamp(share * centre / largest, 0.0, 1.0);
}

namespace {

double reach_mm(const PerReceptor<Activation>& activation, double finger_mm) {
    double reach_mm = finger_mm / 2.0;
    for (const Activation& a : activation) reach_mm = std::max(reach_mm, a.radius_mm);
    return 1.05 * reach_mm;
}

}  // namespace

double common_extent_mm(const PerReceptor<Activation>& activation) {
    return reach_mm(activation, kFingertipLengthMm);
}

double common_width_mm(const PerReceptor<Activation>& activation) {
    return reach_mm(activation, kFingertipWidthMm);
}

// Words stand where they leave more room to the map: beneath it, or in a low and wide area beside
// it.
ReceptorLayout receptor_layout(const Theme& theme, const Rect& area, const ReceptorScene& scene) {
    ReceptorLayout layout;
    // The name is shown at any size: colours alone do not identify the type.
    const float lines = area.height() >= 150.0F * theme.scale  ? 3.2F
                        : area.height() >= 90.0F * theme.scale ? 2.2F
                                                               : 1.2F;
    const float caption_px = lines * caption_line_px(theme);
    const double half_width_mm =
        scene.half_width_mm > 0.0 ? scene.half_width_mm : scene.half_extent_mm;
    const auto slim = static_cast<float>(half_width_mm / scene.half_extent_mm);
    const float gap = theme.gap_px;
    const float words_px = least_caption_px(theme) + gap;
    const float beneath = std::max(0.0F, std::min(area.width() / slim, area.height() - caption_px));
    const float beside = std::min((area.width() - words_px) / slim, area.height());
    layout.beside = beside > 1.1F * beneath;
    const float height = layout.beside ? beside : beneath;
    const float width = slim * height;
    if (layout.beside) {
        const float top = area.centre().y - height / 2.0F;
        layout.map = rect_at({area.min.x, std::floor(top)}, {width, height});
        layout.caption = {{layout.map.max.x + gap, area.min.y}, area.max};
    } else {
        layout.map =
            rect_at({std::floor(area.centre().x - width / 2.0F), area.min.y}, {width, height});
    }
    if (!layout.beside && lines > 0.0F) {
        layout.caption = {{area.min.x, layout.map.max.y},
                          {area.max.x, layout.map.max.y + caption_px}};
    }
    const ImVec2 half{height / 2.0F, height / 2.0F};
    const ImVec2 middle = layout.map.centre();
    layout.skin = skin_view({middle - half, middle + half}, scene.half_extent_mm, scene.tilted);
    return layout;
}

ReceptorAction draw_receptors(const char* id, const Theme& theme, const Rect& area,
                              const ReceptorScene& scene) {
    const ReceptorLayout layout = receptor_layout(theme, area, scene);
    if (layout.map.width() < 8.0F) return {};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::vector<Mark> marks =
        scene.grid != nullptr ? marks_of(theme, layout, scene) : std::vector<Mark>{};
    const ReceptorAction action = read_mouse(id, theme, area, layout.map, marks);

    // Receptors beyond the map are left out, so that they do not cover the caption.
    list.PushClipRect(layout.map.min, layout.map.max, true);
    draw_fingertip(list, theme, layout.skin);
    draw_zones(list, theme, layout, scene);
    draw_surface(list, theme, layout, scene);
    draw_stems(list, theme, layout, scene, marks);
    draw_marks(list, theme, scene, marks);
    draw_asked_for(list, theme, scene, marks, action.hovered ? action.hovered : scene.pointed);
    if (scene.stale) draw_stale(list, theme, layout.map, ImGui::GetTime());
    list.PopClipRect();
    if (layout.beside) {
        draw_caption_beside(list, theme, layout.caption, scene, layout.skin.px_per_mm);
    } else {
        draw_scale_bar(list, theme, layout.map, area.max.x, layout.skin.px_per_mm);
        draw_caption(list, theme, layout.caption, scene);
    }
    return action;
}

}  // namespace tact
