#include "viz/charts/dendrogram_view.h"

#include <algorithm>
#include <cmath>

#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr float kMostNamePx = 96.0F;  // longer ones are shortened
constexpr float kFootPx = 6.0F;       // of a colour below each object

struct Layout {
    Plot plot;
    float foot_px = 0.0F;
    bool has_names = false;
};

Layout layout_of(const Theme& theme, const Rect& area, const DendrogramScene& scene) {
    const double most = scene.tree.joins.empty() ? 1.0 : scene.tree.joins.back().height;
    const PlotLabels labels{"", scene.title, true};
    const Axis y{0.0, 1.06 * std::max(most, 1e-9)};
    const Axis x{0.0, static_cast<double>(std::max<std::size_t>(scene.tree.size, 1))};
    Layout layout{plot_within(area, theme, x, y, labels), kFootPx * theme.scale, false};
    const float line_px = text_size(theme.fonts.small, "0").y;
    const float each_px = layout.plot.area.width() / static_cast<float>(x.high);
    float names_px = 0.0F;
    for (const std::string& name : scene.names) {
        if (each_px < line_px) break;
        names_px = std::max(names_px, text_size(theme.fonts.small, name).x);
    }
    names_px = std::min(names_px, kMostNamePx * theme.scale);
    layout.has_names = names_px > 0.0F && names_px < 0.5F * area.height();
    const float below = layout.foot_px + (layout.has_names ? names_px + 0.5F * theme.gap_px : 0.0F);
    const Rect above{area.min, {area.max.x, area.max.y - below}};
    layout.plot = plot_within(above, theme, x, y, labels);
    return layout;
}

struct Branch {
    std::size_t number = 0;
    std::size_t first = 0;  // of its objects from the left
};

std::size_t objects_in(const GroupTree& tree, std::size_t branch) {
    return branch < tree.size ? 1 : tree.joins[branch - tree.size].objects;
}

double height_of(const GroupTree& tree, std::size_t branch) {
    return branch < tree.size ? 0.0 : tree.joins[branch - tree.size].height;
}

// From the top down: what is narrower than a pixel is a line and has no inside.
class TreeDrawing {
  public:
    TreeDrawing(ImDrawList& list, const Theme& theme, const Plot& plot,
                const DendrogramScene& scene)
        : list_(list), theme_(theme), plot_(plot), scene_(scene) {}

    void draw() {
        const GroupTree& tree = scene_.tree;
        if (tree.joins.empty()) return;
        std::vector<Branch> waiting{{tree.size + tree.joins.size() - 1, 0}};
        const float each_px = plot_.area.width() / static_cast<float>(tree.size);
        while (!waiting.empty()) {
            const Branch branch = waiting.back();
            waiting.pop_back();
            const GroupJoin& join = tree.joins[branch.number - tree.size];
            const std::size_t second = branch.first + objects_in(tree, join.a);
            const ImU32 colour = colour_of(join, branch.first);
            const float y = to_pixel(plot_.y, join.height);
            draw_level_line(list_, y, x_of(join.a), x_of(join.b), theme_.hairline_px, colour);
            for (const Branch& child : {Branch{join.a, branch.first}, Branch{join.b, second}}) {
                const float width = each_px * static_cast<float>(objects_in(tree, child.number));
                const bool is_line = child.number < tree.size || width < 1.0F;
                const double foot = is_line ? 0.0 : height_of(tree, child.number);
                draw_upright_line(list_, x_of(child.number), y, to_pixel(plot_.y, foot),
                                  theme_.hairline_px, colour);
                if (!is_line) waiting.push_back(child);
            }
        }
    }

  private:
    float x_of(std::size_t branch) const { return to_pixel(plot_.x, scene_.places.x[branch]); }

    // Below the cut all is one group's; above it nobody's.
    ImU32 colour_of(const GroupJoin& join, std::size_t first) const {
        if (join.height > scene_.cut) return theme_.dim_text;
        return scene_.looks[scene_.places.order[first]].colour;
    }

    ImDrawList& list_;
    const Theme& theme_;
    const Plot& plot_;
    const DendrogramScene& scene_;
};

// A colour below each object, runs of one colour at once, and names where they have room.
void draw_feet(ImDrawList& list, const Theme& theme, const Layout& layout,
               const DendrogramScene& scene) {
    const Plot& plot = layout.plot;
    const auto& order = scene.places.order;
    const float top = plot.area.max.y + 1.0F;
    for (std::size_t k = 0; k < order.size();) {
        std::size_t end = k + 1;
        const ImU32 colour = scene.looks[order[k]].colour;
        while (end < order.size() && scene.looks[order[end]].colour == colour) ++end;
        const float left = to_pixel(plot.x, static_cast<double>(k));
        const float right = to_pixel(plot.x, static_cast<double>(end));
        const float gap = right - left > 3.0F ? 0.5F : 0.0F;
        list.AddRectFilled({left + gap, top}, {right - gap, top + layout.foot_px - 1.0F}, colour);
        k = end;
    }
    const ImFont* font = theme.fonts.small;
    const float line_px = text_size(font, "0").y;
    for (std::size_t k = 0; layout.has_names && k < order.size(); ++k) {
        const std::string name = shortened(font, scene.names[order[k]], kMostNamePx * theme.scale);
        const float x = to_pixel(plot.x, static_cast<double>(k) + 0.5) - 0.5F * line_px;
        const float below = top + layout.foot_px + 0.25F * theme.gap_px + text_size(font, name).x;
        const bool is_lit = scene.lit == order[k];
        draw_text_upwards(list, font, {x, below}, is_lit ? theme.text : theme.dim_text, name);
    }
}

void draw_lit(ImDrawList& list, const Theme& theme, const Layout& layout,
              const DendrogramScene& scene) {
    if (!scene.lit) return;
    const auto found = std::ranges::find(scene.places.order, *scene.lit);
    if (found == scene.places.order.end()) return;
    const double at = static_cast<double>(found - scene.places.order.begin()) + 0.5;
    const float x = to_pixel(layout.plot.x, at);
    draw_upright_line(list, x, to_pixel(layout.plot.y, scene.cut), layout.plot.area.max.y,
                      theme.trace_px, theme.text);
}

// In the accent colour, as it can be moved.
void draw_cut(ImDrawList& list, const Theme& theme, const Plot& plot, const DendrogramScene& scene,
              bool is_held) {
    const float y = std::clamp(to_pixel(plot.y, scene.cut), plot.area.min.y, plot.area.max.y);
    const float width = (is_held ? 2.0F : 1.0F) * theme.trace_px;
    draw_level_line(list, y, plot.area.min.x, plot.area.max.x, width, theme.accent);
    const ImFont* font = theme.fonts.semibold;
    const std::string words(scene.words);
    const ImVec2 size = text_size(font, words);
    const float above = y - size.y - 0.25F * theme.gap_px;
    const float top = above < plot.area.min.y ? y + 0.25F * theme.gap_px : above;
    draw_text_halo(list, font, {plot.area.max.x - size.x, top}, theme.text, theme.pane,
                   2.0F * theme.scale, words);
}

}  // namespace

DendrogramPlaces dendrogram_places(const GroupTree& tree) {
    DendrogramPlaces places{clustered_order(tree),
                            std::vector<double>(tree.size + tree.joins.size(), 0.0)};
    for (std::size_t k = 0; k < places.order.size(); ++k) {
        places.x[places.order[k]] = static_cast<double>(k) + 0.5;
    }
    for (std::size_t k = 0; k < tree.joins.size(); ++k) {
        const GroupJoin& join = tree.joins[k];
        places.x[tree.size + k] = 0.5 * (places.x[join.a] + places.x[join.b]);
    }
    return places;
}

DendrogramAction draw_dendrogram(const char* id, const Theme& theme, const Rect& area,
                                 const DendrogramScene& scene) {
    DendrogramAction action;
    if (area.width() < 60.0F || area.height() < 60.0F || scene.tree.size < 2) return action;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const Layout layout = layout_of(theme, area, scene);
    const Plot& plot = layout.plot;
    const std::string title = shortened(theme.fonts.small, scene.title, area.width());
    draw_axes(list, theme, plot, {"", title, true});
    ImGui::SetCursorScreenPos(area.min);
    ImGui::InvisibleButton(id, area.size());
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool is_over = ImGui::IsItemHovered();
    const bool is_below = ImGui::GetIO().MouseClickedPos[0].y > plot.area.max.y;
    const bool is_held = ImGui::IsItemActive() && !is_below;
    if (is_held) action.cut = std::clamp(to_value(plot.y, mouse.y), 0.0, plot.y.high);
    if (is_over && mouse.x >= plot.area.min.x && mouse.x < plot.area.max.x) {
        const double at = std::floor(to_value(plot.x, mouse.x));
        const auto k = static_cast<std::size_t>(std::max(at, 0.0));
        action.hovered = scene.places.order[std::min(k, scene.tree.size - 1)];
        const bool is_foot = mouse.y > plot.area.max.y;
        ImGui::SetMouseCursor(is_foot ? ImGuiMouseCursor_Hand : ImGuiMouseCursor_ResizeNS);
        if (is_foot && ImGui::IsMouseClicked(0)) action.clicked = action.hovered;
    }
    TreeDrawing(list, theme, plot, scene).draw();
    draw_feet(list, theme, layout, scene);
    draw_lit(list, theme, layout, scene);
    draw_cut(list, theme, plot, scene, is_held);
    if (scene.stale) draw_stale(list, theme, area, ImGui::GetTime());
    return action;
}

float dendrogram_height_px(const Theme& theme, const Rect& area, const DendrogramScene& scene,
                           double height) {
    return to_pixel(layout_of(theme, area, scene).plot.y, height);
}

}  // namespace tact
