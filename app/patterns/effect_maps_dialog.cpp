#include "app/patterns/patterns.h"

#include <algorithm>
#include <set>
#include <string>

#include "app/document/editing.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/io/formats/read_effects.h"
#include "model/text/numbers.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kMapsDialogPx = 640.0F;
constexpr float kMapComboPx = 270.0F;
constexpr float kFormatPx = 208.0F;

const char* name_of_format(const MapInUse& use) {
    const EffectFormat* format = format_named(use.format);
    return format != nullptr ? format->name : use.format.c_str();
}

const ActuatorMap* known_map(const std::string& name) {
    const auto maps = bundled_actuators();
    const auto found = std::ranges::find(maps, name, &ActuatorMap::name);
    return found != maps.end() ? &*found : nullptr;
}

std::string own_map(const MapInUse& use) {
    const EffectFormat* format = format_named(use.format);
    return format != nullptr ? format->map : "";
}

std::string map_label(const std::string& name, const std::string& own) {
    const ActuatorMap* map = known_map(name);
    const bool is_guessed = map != nullptr && map->source.find("guess") != map->source.npos;
    return name + (name == own ? ", the format's own" : "") + (is_guessed ? ", guessed" : "");
}

// The chosen map; empty: no choice.
std::string draw_map_combo(Ui& ui, const MapInUse& use) {
    const std::string own = own_map(use);
    std::string chosen;
    ImGui::PushID(use.format.c_str());
    const Item shown{.id = "effects:map of " + use.format,
                     .label = map_label(use.actuators, own),
                     .enabled = use.has_files,
                     .value = use.actuators};
    drop_down(ui, shown, kMapComboPx * ui.theme.scale, [&] {
        for (const ActuatorMap& map : bundled_actuators()) {
            const bool is_used = map.name == use.actuators;
            const Item item{.id = "effects map:" + map.name,
                            .label = map_label(map.name, own),
                            .tip = map.source};
            if (option(ui, item, is_used) && !is_used) chosen = map.name;
        }
    });
    ImGui::PopID();
    return chosen;
}

void draw_source(Ui& ui, const MapInUse& use) {
    std::string text;
    if (const ActuatorMap* map = known_map(use.actuators)) text = map->source;
    if (!use.has_files) text += " Its files are not known: open them to read them by another.";
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + kFormatPx * ui.theme.scale);
    ImGui::PushFont(ui.theme.fonts.small);
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, text);
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
}

void draw_no_maps(Ui& ui) {
    std::string endings;
    for (const std::string& one : effect_endings()) endings += (endings.empty() ? "" : ", ") + one;
    const std::string text =
        "No pattern here came from an effect file. Bring some in by File > Open... or File > Add "
        "to set... (" +
        endings +
        "): the map that each format was read by then stands here, and another can be chosen.";
    ImGui::PushTextWrapPos(0.0F);
    dim_text(ui, {.id = "effects:none", .text = text});
    ImGui::PopTextWrapPos();
}

}  // namespace

void draw_effect_maps_line(Ui& ui, Workspace& work) {
    if (!work.effects.is_told) return;
    std::set<std::string> names;
    for (const auto& [name, count] : actuators_of(work.document.set)) names.insert(name);
    if (names.empty()) return;
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    const std::string text = names.size() == 1
                                 ? "Read by " + all
                                 : "Read by " + std::to_string(names.size()) + " actuator maps";
    const float right = ImGui::GetContentRegionMax().x - button_width("\u00d7");
    const float change = right - ui.theme.gap_px - ImGui::CalcTextSize("Change...").x;
    const float room = change - ui.theme.gap_px - ImGui::GetCursorPosX();
    ImGui::PushFont(ui.theme.fonts.small);
    dim_text(ui, {.id = "effects:maps",
                  .text = shortened(ui.theme.fonts.small, text, room),
                  .tip = "What 0 to 1 of the effect files became in Hz and g, by " + all,
                  .value = all});
    ImGui::PopFont();
    ImGui::SameLine(change);
    if (link(ui, {.id = "button:change maps", .label = "Change..."})) ui.dialog = kEffectMapsDialog;
    ImGui::SameLine(right);
    if (small_button(ui, {.id = "button:hide maps",
                          .label = "\u00d7",
                          .tip = "File > Actuator maps... has it, too"})) {
        work.effects.is_told = false;
    }
}

void draw_effect_maps_dialog(Ui& ui, Workspace& work) {
    if (!begin_dialog(ui, kEffectMapsDialog, kMapsDialogPx)) return;
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(
        "How the 0 to 1 of effect files is read as Hz and g, for the device that they are for.");
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
    const std::vector<MapInUse> in_use = maps_in_use(work);
    if (in_use.empty()) draw_no_maps(ui);
    for (const MapInUse& use : in_use) {
        const float left = ImGui::GetCursorPosX();
        ImGui::AlignTextToFramePadding();
        dim_text(ui, name_of_format(use));
        ImGui::SameLine(left + kFormatPx * ui.theme.scale);
        const std::string chosen = draw_map_combo(ui, use);
        ImGui::SameLine();
        dim_text(ui, counted(use.patterns, "pattern", "patterns"));
        draw_source(ui, use);
        if (!chosen.empty()) read_by_map(ui, work, use.format, chosen);
    }
    end_dialog(ui);
}

}  // namespace tact
