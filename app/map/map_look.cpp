#include "app/map/map_look.h"

#include <algorithm>
#include <cmath>

#include "app/document/editing.h"
#include "app/ui/widgets.h"
#include "model/map/clusters.h"
#include "viz/drawing/colormap.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr int kMostClusters = 20;

const std::vector<Vibration>& shown_vibrations(const App& app) {
    return app.map.shown->request.set->vibrations;
}

std::optional<double> value_of(const Vibration& vibration, PatternParameter parameter) {
    const auto* pattern = std::get_if<Pattern>(&vibration.source);
    return pattern == nullptr ? std::nullopt : value_of(*pattern, parameter);
}

// The smallest and largest in the set; none has it: nothing.
std::optional<Range> reach_of(const App& app, PatternParameter parameter) {
    std::optional<Range> reach;
    for (const Vibration& vibration : shown_vibrations(app)) {
        const auto value = value_of(vibration, parameter);
        if (!value) continue;
        if (!reach) reach = Range{*value, *value};
        reach = Range{std::min(reach->low, *value), std::max(reach->high, *value)};
    }
    return reach;
}

double share_of(PatternParameter parameter, const Range& reach, double value) {
    if (reach.high <= reach.low) return 0.5;
    if (traits(parameter).by_ratio && reach.low > 0.0) {
        return std::log(value / reach.low) / std::log(reach.high / reach.low);
    }
    return (value - reach.low) / (reach.high - reach.low);
}

void colour_by(const App& app, PatternParameter parameter, std::vector<PatternLook>& looks) {
    const auto reach = reach_of(app, parameter);
    if (!reach) return;
    for (std::size_t k = 0; k < looks.size(); ++k) {
        const auto value = value_of(shown_vibrations(app)[k], parameter);
        looks[k] = value ? PatternLook{viridis(share_of(parameter, *reach, *value)), false}
                         : PatternLook{app.theme.dim_text, true};
    }
}

void colour_clusters(App& app, std::vector<PatternLook>& looks) {
    ShownClusters& known = app.clusters;
    const int count = app.map_look.clusters;
    if (known.of != app.map.shown || known.count != count) {
        known = {app.map.shown, count,
                 clusters(app.map.shown->prediction.pm, static_cast<std::size_t>(count))};
    }
    for (std::size_t k = 0; k < looks.size() && k < known.group.size(); ++k) {
        looks[k] = pattern_look(app.theme, known.group[k]);
    }
}

// Patterns that differ in one number alone, in its order.
std::vector<std::vector<std::size_t>> paths_along(const App& app, PatternParameter parameter) {
    struct Place {
        double value;
        std::size_t row;
    };
    std::vector<std::pair<Pattern, std::vector<Place>>> groups;
    const auto& all = shown_vibrations(app);
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto value = value_of(all[k], parameter);
        if (!value) continue;
        const Pattern rest = with_value(std::get<Pattern>(all[k].source), parameter, 1.0);
        auto group = std::ranges::find_if(groups, [&](const auto& g) { return g.first == rest; });
        if (group == groups.end()) group = groups.insert(groups.end(), {rest, {}});
        group->second.push_back({*value, k});
    }
    std::vector<std::vector<std::size_t>> paths;
    for (auto& [rest, group] : groups) {
        if (group.size() < 2) continue;
        std::ranges::stable_sort(group, {}, &Place::value);
        std::vector<std::size_t> path;
        for (const Place& place : group) path.push_back(place.row);
        paths.push_back(std::move(path));
    }
    return paths;
}

const char* parameter_name(const std::optional<PatternParameter>& parameter) {
    return parameter ? traits(*parameter).name : "none";
}

// True where another one was chosen.
bool draw_parameter_choice(App& app, const char* label, std::optional<PatternParameter>& chosen) {
    bool changed = false;
    ImGui::SetNextItemWidth(170.0F * app.theme.scale);
    if (ImGui::BeginCombo(label, parameter_name(chosen))) {
        if (ImGui::Selectable("none", !chosen)) {
            chosen.reset();
            changed = true;
        }
        for (const PatternParameter parameter : kPatternParameters) {
            if (!reach_of(app, parameter)) continue;
            if (ImGui::Selectable(traits(parameter).name, chosen == parameter)) {
                chosen = parameter;
                changed = true;
            }
            note_item(app.rects, std::string(label) + ":" + traits(parameter).key);
        }
        ImGui::EndCombo();
    }
    note_item(app.rects, std::string("look:") + label, parameter_name(chosen));
    return changed;
}

void draw_filter(App& app) {
    MapLook& look = app.map_look;
    if (draw_parameter_choice(app, "Only with", look.filter) && look.filter) {
        look.passes = reach_of(app, *look.filter).value_or(Range{0.0, 0.0});
    }
    if (!look.filter) return;
    const auto reach = reach_of(app, *look.filter);
    if (!reach) return;
    auto low = static_cast<float>(look.passes.low);
    auto high = static_cast<float>(look.passes.high);
    const auto least = static_cast<float>(reach->low);
    const auto most = static_cast<float>(reach->high);
    ImGui::SetNextItemWidth(170.0F * app.theme.scale);
    const std::string format = std::string("%.3g ") + traits(*look.filter).unit;
    const float speed = std::max(1e-4F, (most - least) / 200.0F);
    if (ImGui::DragFloatRange2("from, to", &low, &high, speed, least, most, format.c_str(),
                               format.c_str(),
                               ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput)) {
        // A float that stands at an end must not shut out the double there.
        look.passes.low = low <= least ? reach->low : static_cast<double>(low);
        look.passes.high = high >= most ? reach->high : static_cast<double>(high);
    }
    note_item(app.rects, "look:passes");
}

}  // namespace

MapDecor map_decor(App& app, const MapMarks& marks, std::vector<PatternLook>& looks) {
    MapDecor decor{{}, {}, marks};
    const MapLook& look = app.map_look;
    if (look.clusters > 1) {
        colour_clusters(app, looks);
    } else if (look.colour) {
        colour_by(app, *look.colour, looks);
    }
    if (look.path) {
        if (app.paths.of != app.map.shown || app.paths.along != look.path) {
            app.paths = {app.map.shown, look.path, paths_along(app, *look.path)};
        }
        decor.paths = app.paths.paths;
    }
    const auto& all = shown_vibrations(app);
    for (std::size_t k = 0; k < all.size() && look.filter; ++k) {
        const auto value = value_of(all[k], *look.filter);
        if (!value || !look.passes.contains(*value)) decor.faint.push_back(k);
    }
    if (!look.show_pairs) decor.marks.links.clear();
    if (!look.show_spread) decor.marks.spread.clear();
    return decor;
}

void decorate(const MapDecor& decor, SpaceScene& scene) {
    scene.paths = decor.paths;
    scene.chosen = decor.marks.chosen;
    scene.faint = decor.faint;
    scene.links = decor.marks.links;
    scene.spread = decor.marks.spread;
}

void draw_map_look(App& app) {
    constexpr const char* kLook = "Look...";
    flow_on(ImGui::CalcTextSize(kLook).x, 2.0F * app.theme.gap_px);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({corner.x, corner.y + ImGui::GetStyle().FramePadding.y});
    if (link(app, "map look", kLook)) ImGui::OpenPopup("map look");
    note_item(app.rects, "link:map look");
    draw_tooltip(app, "Colour, lines, filter and groups of the map.");
    if (!ImGui::BeginPopup("map look")) return;
    MapLook& look = app.map_look;
    if (!app.map.shown) {
        dim_text(app, "No map yet.");
        ImGui::EndPopup();
        return;
    }
    if (draw_parameter_choice(app, "Colour by", look.colour)) look.clusters = 0;
    draw_parameter_choice(app, "Lines along", look.path);
    draw_filter(app);
    ImGui::SetNextItemWidth(170.0F * app.theme.scale);
    if (ImGui::SliderInt("Groups", &look.clusters, 0, kMostClusters,
                         look.clusters < 2 ? "none" : "%d", ImGuiSliderFlags_NoInput)) {
        if (look.clusters == 1) look.clusters = 0;
        if (look.clusters > 1) look.colour.reset();
    }
    note_item(app.rects, "look:groups", std::to_string(look.clusters));
    draw_tooltip(app, "Patterns that are close by PM, in one colour (average linkage).");
    ImGui::Checkbox("Pairs that are too close", &look.show_pairs);
    ImGui::Checkbox("Ellipses of uncertainty", &look.show_spread);
    ImGui::EndPopup();
}

void draw_map_legend(const App& app, const Rect& area) {
    const MapLook& look = app.map_look;
    if (!look.colour || look.clusters > 1 || !app.map.shown) return;
    const auto reach = reach_of(app, *look.colour);
    if (!reach) return;
    const Theme& theme = app.theme;
    const ParameterTraits& about = traits(*look.colour);
    const std::string unit = *about.unit == '\0' ? "" : std::string(" ") + about.unit;
    const std::string low = significant(reach->low);
    const std::string high = significant(reach->high) + unit;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low_size = text_size(theme.fonts.small, low);
    const ImVec2 high_size = text_size(theme.fonts.small, high);
    const std::string name = about.name;
    const ImVec2 name_size = text_size(theme.fonts.small, name);
    const float bar = 72.0F * theme.scale;
    const float gap = 0.75F * theme.gap_px;
    const float width = name_size.x + low_size.x + bar + high_size.x + 3.0F * gap;
    if (width > area.width()) return;
    float x = area.max.x - width;
    const float y = area.min.y;
    draw_text(list, theme.fonts.small, {x, y}, theme.text, name);
    x += name_size.x + gap;
    draw_text(list, theme.fonts.small, {x, y}, theme.dim_text, low);
    x += low_size.x + gap;
    constexpr int kPieces = 24;
    const float height = low_size.y;
    for (int k = 0; k < kPieces; ++k) {
        const float from = x + bar * static_cast<float>(k) / kPieces;
        list.AddRectFilled({from, y + 0.25F * height},
                           {from + bar / kPieces + 0.5F, y + 0.75F * height},
                           viridis((k + 0.5) / kPieces));
    }
    draw_text(list, theme.fonts.small, {x + bar + gap, y}, theme.dim_text, high);
}

void draw_point_menu(App& app, const SpaceAction& action,
                     const std::vector<std::optional<std::size_t>>& places) {
    if (action.right_clicked && places[*action.right_clicked]) {
        app.map_menu_of = *places[*action.right_clicked];
        ImGui::OpenPopup("point menu");
    }
    if (!ImGui::BeginPopup("point menu")) return;
    const std::size_t place = app.map_menu_of;
    if (place < app.document.set.vibrations.size()) {
        const Vibration& vibration = app.document.set.vibrations[place];
        dim_text(app, vibration.name);
        const bool locks = ImGui::MenuItem(vibration.locked ? "Unlock" : "Lock: always pick it");
        note_item(app.rects, "menu:lock");
        const bool drops = ImGui::MenuItem(vibration.dropped ? "Take back" : "Drop: never pick it");
        note_item(app.rects, "menu:drop");
        if (locks || drops) select_only(app, place);
        if (locks) toggle_locked(app);
        if (drops) toggle_dropped(app);
    }
    ImGui::EndPopup();
}

}  // namespace tact
