#include "app/map/map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/document/editing.h"
#include "app/ui/widgets.h"
#include "model/map/explained_share.h"
#include "model/map/group_tree.h"
#include "model/set/parameter_paths.h"
#include "model/text/numbers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/marks.h"
#include "viz/drawing/plot.h"

namespace tact {

namespace {

constexpr int kMostClusters = 20;

const std::vector<Vibration>& shown_vibrations(const ShownMap& shown_map) {
    return shown_map.transition.shown->request.set->vibrations;
}

// The smallest and largest in the set; none has it: nothing.
std::optional<Range> reach_of(const ShownMap& shown_map, PatternParameter parameter) {
    std::optional<Range> reach;
    for (const Vibration& vibration : shown_vibrations(shown_map)) {
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

// Eight colours on many patterns mean nothing. Many patterns take the number that explains most of
// the map, if one explains a good part.
const ShownExplained& explained(ShownMap& shown_map) {
    ShownExplained& known = shown_map.explained;
    if (known.of == shown_map.transition.shown) return known;
    known = {shown_map.transition.shown, std::nullopt, 0.0};
    constexpr std::size_t kFew = 24;
    constexpr double kLeast = 0.25;
    const auto& all = shown_vibrations(shown_map);
    const Eigen::MatrixXd& places = shown_map.transition.to;
    if (all.size() <= kFew || static_cast<std::size_t>(places.rows()) != all.size()) return known;
    for (const PatternParameter parameter : kPatternParameters) {
        const auto reach = reach_of(shown_map, parameter);
        if (!reach) continue;
        std::vector<double> shares;
        for (const Vibration& vibration : all) {
            const auto value = value_of(vibration, parameter);
            shares.push_back(value ? share_of(parameter, *reach, *value)
                                   : std::numeric_limits<double>::quiet_NaN());
        }
        const double share = explained_share(places, shares);
        if (share < std::max(kLeast, known.share)) continue;
        known.by = parameter;
        known.share = share;
    }
    return known;
}

// By what the points are coloured, if by a number.
std::optional<PatternParameter> colour_of(ShownMap& shown_map) {
    const MapLook& look = shown_map.look;
    if (look.is_chosen || look.colour) return look.colour;
    return explained(shown_map).by;
}

void colour_by(const Ui& ui, const ShownMap& shown_map, PatternParameter parameter,
               std::vector<PatternLook>& looks) {
    const auto reach = reach_of(shown_map, parameter);
    if (!reach) return;
    const MarkColours colours = mark_colours(ui.theme.pane);
    for (std::size_t k = 0; k < looks.size(); ++k) {
        const auto value = value_of(shown_vibrations(shown_map)[k], parameter);
        looks[k] = value ? PatternLook{colours(share_of(parameter, *reach, *value)), false}
                         : PatternLook{ui.theme.dim_text, true};
    }
}

void colour_clusters(const Ui& ui, ShownMap& shown_map, std::vector<PatternLook>& looks) {
    ShownClusters& known = shown_map.clusters;
    const int count = shown_map.look.clusters;
    if (known.of != shown_map.transition.shown || known.count != count) {
        known = {shown_map.transition.shown, count,
                 clusters(group_tree(shown_map.transition.shown->prediction.pm),
                          static_cast<std::size_t>(count))};
    }
    for (std::size_t k = 0; k < looks.size() && k < known.group.size(); ++k) {
        looks[k] = pattern_look(ui.theme, known.group[k]);
    }
}

const char* parameter_name(const std::optional<PatternParameter>& parameter, const char* none) {
    return parameter ? traits(*parameter).name : none;
}

constexpr float kPopupPx = 290.0F;
constexpr float kLabelPx = 96.0F;
constexpr float kChoicePx = 170.0F;

void label_of_row(const Ui& ui, const char* label) {
    const float begin = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    dim_text(ui, label);
    ImGui::SameLine(begin + kLabelPx * ui.theme.scale);
}

// True where another one was chosen.
bool draw_parameter_choice(Ui& ui, const ShownMap& shown_map, const char* label, const char* none,
                           std::optional<PatternParameter>& chosen) {
    bool changed = false;
    label_of_row(ui, label);
    const Item shown{.id = std::string("look:") + label,
                     .label = parameter_name(chosen, none),
                     .value = parameter_name(chosen, "none")};
    drop_down(
        ui, shown, kChoicePx * ui.theme.scale,
        [&] {
            if (ImGui::Selectable(none, !chosen)) {
                chosen.reset();
                changed = true;
            }
            for (const PatternParameter parameter : kPatternParameters) {
                if (!reach_of(shown_map, parameter)) continue;
                const Item item{.id = std::string(label) + ":" + traits(parameter).key,
                                .label = traits(parameter).name};
                if (!option(ui, item, chosen == parameter)) continue;
                chosen = parameter;
                changed = true;
            }
        },
        ImGuiComboFlags_HeightRegular);
    return changed;
}

void draw_filter(Ui& ui, ShownMap& shown_map) {
    MapLook& look = shown_map.look;
    if (draw_parameter_choice(ui, shown_map, "Only with", "all", look.filter) && look.filter) {
        look.passes = reach_of(shown_map, *look.filter).value_or(Range{0.0, 0.0});
    }
    if (!look.filter) return;
    const auto reach = reach_of(shown_map, *look.filter);
    if (!reach) return;
    NumberEntry entry{.id = "passes from",
                      .label = "From",
                      .format = "%.4g",
                      .rules = {*reach, traits(*look.filter).unit},
                      .width_px = 72.0F * ui.theme.scale};
    ImGui::BeginGroup();
    ImGui::AlignTextToFramePadding();
    dim_text(ui, "from");
    reset_by_label(ui, reach->low, look.passes.low);
    ImGui::SameLine();
    enter_number(ui, entry, look.passes.low);
    note_item(ui.rects, "look:passes from", significant(look.passes.low, 6));
    ImGui::SameLine();
    dim_text(ui, "to");
    reset_by_label(ui, reach->high, look.passes.high);
    ImGui::SameLine();
    entry.id = "passes to";
    entry.label = "To";
    enter_number(ui, entry, look.passes.high);
    note_item(ui.rects, "look:passes to", significant(look.passes.high, 6));
    if (*traits(*look.filter).unit != '\0') {
        ImGui::SameLine();
        dim_text(ui, traits(*look.filter).unit);
    }
    ImGui::EndGroup();
    note_item(ui.rects, "look:passes");
}

}  // namespace

MapDecor map_decor(const Ui& ui, ShownMap& shown_map, const MapMarks& marks,
                   std::vector<PatternLook>& looks) {
    MapDecor decor{{}, {}, marks};
    const MapLook& look = shown_map.look;
    if (marks.looks.size() == looks.size()) {
        looks = marks.looks;
    } else if (look.clusters > 1) {
        colour_clusters(ui, shown_map, looks);
    } else if (const auto colour = colour_of(shown_map)) {
        colour_by(ui, shown_map, *colour, looks);
    }
    if (look.path) {
        if (shown_map.paths.of != shown_map.transition.shown ||
            shown_map.paths.along != look.path) {
            shown_map.paths = {shown_map.transition.shown, look.path,
                               paths_along(shown_vibrations(shown_map), *look.path)};
        }
        decor.paths = shown_map.paths.paths;
    }
    const auto& all = shown_vibrations(shown_map);
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
    const MapMaybes& maybes = decor.marks.maybes;
    const auto rows = [](const Eigen::MatrixXd& points) {
        return points.rows() > 0 ? &points : nullptr;
    };
    scene.maybes = {rows(maybes.proposals), maybes.proposal_names, maybes.lit,
                    rows(maybes.track),     maybes.track_words,    rows(maybes.cloud),
                    maybes.wanted,          maybes.reached};
}

void draw_map_look(Ui& ui, ShownMap& shown_map) {
    constexpr const char* kLook = "Look...";
    flow_on(ImGui::CalcTextSize(kLook).x, 2.0F * ui.theme.gap_px);
    const Item item{.id = "link:map look",
                    .label = kLook,
                    .tip = "Colour, lines, filter and groups of the map."};
    if (row_link(ui, item)) ImGui::OpenPopup("map look");
    open_beside_pane(ui.theme, kPopupPx * ui.theme.scale);
    if (!ImGui::BeginPopup("map look")) return;
    ImGui::PushFont(ui.theme.fonts.semibold);
    ImGui::TextUnformatted("Look of the map");
    ImGui::PopFont();
    MapLook& look = shown_map.look;
    if (!shown_map.transition.shown) {
        dim_text(ui, "No map yet.");
        ImGui::EndPopup();
        return;
    }
    std::optional<PatternParameter> colour = colour_of(shown_map);
    if (draw_parameter_choice(ui, shown_map, "Colour by", "pattern", colour)) {
        look.colour = colour;
        look.is_chosen = true;
        look.clusters = 0;
    }
    draw_parameter_choice(ui, shown_map, "Lines along", "none", look.path);
    draw_filter(ui, shown_map);
    int groups = std::max(1, look.clusters);
    label_of_row(ui, "Groups");
    reset_by_label(ui, 0, look.clusters);
    if (enter_whole_with_buttons(ui,
                                 {.id = "groups",
                                  .label = "Groups",
                                  .format = "%.0f",
                                  .rules = {{1.0, kMostClusters}},
                                  .width_px = kChoicePx * ui.theme.scale},
                                 groups)) {
        look.clusters = groups < 2 ? 0 : groups;
        if (look.clusters > 1) look.colour.reset();
    }
    say_of_last_item(
        ui,
        {.id = "look:groups",
         .text = std::to_string(look.clusters),
         .tip =
             "Patterns that are close by PM, in one colour (average linkage); 1 shows no groups."});
    const auto draw_shown = [&ui](const char* id, const char* label, bool& on) {
        check(ui, {.id = id, .label = label}, on);
    };
    draw_shown("look:pairs", "Pairs that are too close", look.show_pairs);
    draw_shown("look:spread", "Ellipses of uncertainty", look.show_spread);
    ImGui::EndPopup();
}

void draw_map_legend(Ui& ui, ShownMap& shown_map, const Rect& area) {
    const MapLook& look = shown_map.look;
    if (look.clusters > 1 || !shown_map.transition.shown) return;
    const auto colour = colour_of(shown_map);
    const auto reach = colour ? reach_of(shown_map, *colour) : std::nullopt;
    if (!reach) return;
    const Theme& theme = ui.theme;
    const ParameterTraits& about = traits(*colour);
    const std::string unit = *about.unit == '\0' ? "" : std::string(" ") + about.unit;
    const std::string low = significant(reach->low);
    const std::string high = significant(reach->high) + unit;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 low_size = text_size(theme.fonts.small, low);
    const ImVec2 high_size = text_size(theme.fonts.small, high);
    std::string name = about.name;
    if (!look.is_chosen && !look.colour) {
        name = "colour: " + name + ", explains " +
               significant(100.0 * explained(shown_map).share, 2) + " % of the map";
    }
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
    const MarkColours colours = mark_colours(theme.pane);
    const float height = low_size.y;
    for (int k = 0; k < kPieces; ++k) {
        const float from = x + bar * static_cast<float>(k) / kPieces;
        list.AddRectFilled({from, y + 0.25F * height},
                           {from + bar / kPieces + 0.5F, y + 0.75F * height},
                           colours((k + 0.5) / kPieces));
    }
    draw_text(list, theme.fonts.small, {x + bar + gap, y}, theme.dim_text, high);
    note_rect(ui.rects, "map:colour", {area.max.x - width, y}, {area.max.x, y + height}, name);
}

}  // namespace tact
