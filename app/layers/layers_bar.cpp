#include "app/layers/layers.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/ui/widgets.h"
#include "model/set/layers.h"
#include "viz/drawing/colour.h"
#include "viz/drawing/imgui_versions.h"
#include "viz/drawing/marks.h"

namespace tact {

namespace {

constexpr float kNamePx = 150.0F;
constexpr float kLeastWavePx = 40.0F;

std::string row_id(const char* what, std::size_t k) {
    return std::string(what) + std::to_string(k + 1);
}

// Points down where rows are open below it, else to the right.
void draw_arrow(const Theme& theme, ImVec2 centre, bool down) {
    const float r = 3.5F * theme.scale;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (down) {
        list.AddTriangleFilled(centre + ImVec2{-r, -0.6F * r}, centre + ImVec2{r, -0.6F * r},
                               centre + ImVec2{0.0F, 0.8F * r}, theme.dim_text);
    } else {
        list.AddTriangleFilled(centre + ImVec2{-0.6F * r, -r}, centre + ImVec2{0.8F * r, 0.0F},
                               centre + ImVec2{-0.6F * r, r}, theme.dim_text);
    }
}

void draw_rename(Ui& ui, Workspace& work, LayersBar& bar, std::size_t k) {
    if (!bar.is_typing) focus_next_item();
    ImGui::SetNextItemWidth(kNamePx * ui.theme.scale);
    ImGui::InputText("##layer name", &bar.name, ImGuiInputTextFlags_AutoSelectAll);
    note_item(ui.rects, row_id("layer name:", k), bar.name);
    if (ImGui::IsItemActive()) bar.is_typing = true;
    if (ImGui::IsItemActive() || !bar.is_typing) return;
    bar.renaming.reset();
    ui.waiting.emplace_back([&ui, &work, k, name = bar.name] {
        edit_layer(work, k, [&name](Layer& layer) { layer.name = cut_name(name); });
        commit_step(ui, work, "Rename a layer of " + current_vibration(work)->name);
    });
}

void draw_name(Ui& ui, Workspace& work, LayersBar& bar, const LayeredPattern& layered,
               std::size_t k, bool folded) {
    const Theme& theme = ui.theme;
    const bool is_open = k == open_layer(work);
    if (bar.renaming == k && bar.renaming_of == current_vibration(work)->name) {
        return draw_rename(ui, work, bar, k);
    }
    const Rect cell =
        rect_at(ImGui::GetCursorScreenPos(), {kNamePx * theme.scale, ImGui::GetFrameHeight()});
    if (ImGui::InvisibleButton("layer", cell.size())) {
        if (is_open) {
            bar.is_folded = !folded;
        } else {
            ui.waiting.emplace_back([&work, k] { choose_layer(work, k); });
        }
    }
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        bar.renaming = k;
        bar.renaming_of = current_vibration(work)->name;
        bar.name = name_of(layered, k);
        bar.is_typing = false;
        bar.is_folded = false;
    }
    const std::string name = name_of(layered, k);
    say_of_last_item(
        ui, {.id = row_id("layer:", k),
             .text = name + (is_open ? ", open" : ""),
             .tip = is_open ? "Open in the editor. A click folds the rows of the others; a double "
                              "click renames it."
                            : "Opens this layer in the editor. A double click renames it."});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (is_open || ImGui::IsItemHovered()) {
        list.AddRectFilled(cell.min, cell.max, is_open ? faded(theme.text, 0.16F) : theme.hover,
                           theme.rounding_px);
    }
    const float indent = 18.0F * theme.scale;
    draw_arrow(theme, {cell.min.x + 0.5F * indent, cell.centre().y}, is_open && !folded);
    const float room = cell.width() - indent - 4.0F * theme.scale;
    draw_text(list, theme.fonts.regular,
              {cell.min.x + indent, cell.centre().y - 0.5F * ImGui::GetTextLineHeight()},
              sounds(layered, k) ? theme.text : theme.dim_text,
              shortened(theme.fonts.regular, name, room));
}

void draw_mark(Ui& ui, Workspace& work, const LayeredPattern& layered, std::size_t k,
               bool Layer::*mark, const char* word, const char* verb, const char* help) {
    const bool on = layered.layers[k].*mark;
    ImGui::SameLine(0.0F, 0.5F * ui.theme.gap_px);
    if (toggle(ui,
               {.id = row_id((std::string("layer ") + verb + ":").c_str(), k),
                .label = word,
                .tip = help,
                .value = on ? "on" : "off"},
               on)) {
        ui.waiting.emplace_back([&ui, &work, k, mark, on, verb] {
            edit_layer(work, k, [mark, on](Layer& layer) { layer.*mark = !on; });
            commit_step(ui, work, std::string(on ? "End " : "") + verb + " of " + shown_name(work));
        });
    }
}

// The layer's waveform where it lies within the whole.
void draw_wave(Ui& ui, Workspace& work, const LayeredPattern& layered, std::size_t k,
               const Rect& area) {
    const Theme& theme = ui.theme;
    const Layer& layer = layered.layers[k];
    const double whole_s = duration_s(layered);
    const double own_s = duration_s(layer);
    if (!(whole_s > 0.0) || !(own_s > 0.0)) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(area.min, area.max, faded(theme.text, 0.05F), theme.rounding_px);
    const auto x = [&](double at_s) {
        return area.min.x + static_cast<float>(at_s / whole_s) * area.width();
    };
    const Rect own{{x(layer.offset_s), area.min.y}, {x(layer.offset_s + own_s), area.max.y}};
    const Vibration alone = layer_alone(work, layered, k);
    const ImU32 colour = look_of(ui, work, work.selection.current).colour;
    const double reach_g = layer.gain > 0.0 ? work.cache.reach_g / layer.gain : 1e6;
    draw_thumbnail(ui, work, own, alone, sounds(layered, k) ? colour : faded(colour, 0.3F), reach_g,
                   own_s);
    note_rect(ui.rects, row_id("layer wave:", k), own.min, own.max);
}

void draw_row(Ui& ui, Workspace& work, LayersBar& bar, const LayeredPattern& layered, std::size_t k,
              bool folded) {
    const float s = ui.theme.scale;
    ImGui::PushID(static_cast<int>(k));
    draw_name(ui, work, bar, layered, k, folded);
    draw_mark(ui, work, layered, k, &Layer::mute, "M", "mute", "Mute: this layer does not sound.");
    draw_mark(ui, work, layered, k, &Layer::solo, "S", "solo",
              "Solo: of all layers, only those with solo sound.");
    ImGui::SameLine(0.0F, ui.theme.gap_px);
    const float remove_px = ImGui::GetFrameHeight();
    const float wave_px = ImGui::GetContentRegionAvail().x - remove_px - 0.5F * ui.theme.gap_px;
    const Rect wave = rect_at(ImGui::GetCursorScreenPos(), {wave_px, ImGui::GetFrameHeight()});
    if (wave_px >= kLeastWavePx * s) {
        draw_wave(ui, work, layered, k, wave);
        ImGui::Dummy(wave.size());
        ImGui::SameLine(0.0F, 0.5F * ui.theme.gap_px);
    }
    if (button(ui,
               {.id = row_id("layer remove:", k),
                .label = "\u00D7",
                .tip = "Remove this layer. Ctrl+Z brings it back.",
                .enabled = layered.layers.size() > 1},
               {remove_px, 0.0F})) {
        ui.waiting.emplace_back([&ui, &work, k] { remove_layer(ui, work, k); });
    }
    ImGui::PopID();
}

bool has_room_for_both(const Ui& ui, float room_px) { return room_px >= 520.0F * ui.theme.scale; }

// Gain and begin of the open layer.
void draw_numbers(Ui& ui, Workspace& work, const LayeredPattern& layered) {
    const std::size_t k = open_layer(work);
    const Layer& layer = layered.layers[k];
    const float gap = 2.0F * ui.theme.gap_px;
    const float room = ImGui::GetContentRegionAvail().x;
    const bool beside = has_room_for_both(ui, room);
    const float width = beside ? 0.5F * (room - gap) : room;
    const auto draw = [&](const Field& field, double value, const char* what, auto write) {
        double edited = value;
        const FieldEdit edit = draw_short_field(ui, field, width, edited);
        if (edit.changed && edited != value) {
            edit_layer(work, k, [&](Layer& one) { write(one, edited); });
        }
        if (edit.finished) {
            commit_step(ui, work, std::string("Change ") + what + " of " + shown_name(work));
        }
    };
    draw({.id = "layer_gain",
          .label = "Gain",
          .format = "%.2f",
          .slider = {0.0, 2.0},
          .typed = limits::kLayerGain,
          .step = 0.05,
          .snap = 0.01,
          .help = "Factor of all that this layer is. Typed values reach 10.",
          .normal = 1.0},
         layer.gain, "gain", [](Layer& one, double value) { one.gain = value; });
    if (beside) ImGui::SameLine(0.0F, gap);
    const double most_ms = std::max(1.0, 1000.0 * (limits::kDurationS.high - duration_s(layer)));
    draw({.id = "layer_offset_ms",
          .label = "Begins at",
          .format = "%.5g ms",
          .slider = {0.0, std::min(most_ms, std::max(1000.0, 1000.0 * duration_s(layered)))},
          .typed = {0.0, most_ms},
          .step = 5.0,
          .snap = 1.0,
          .help = "When this layer begins, from the start of the pattern.",
          .normal = 0.0},
         1000.0 * layer.offset_s, "begin",
         [](Layer& one, double value) { one.offset_s = value / 1000.0; });
}

}  // namespace

void draw_layers_bar(Ui& ui, Workspace& work, LayersBar& bar, float room_px) {
    if (current_layers(work) == nullptr) return;
    const LayeredPattern layered = *current_layers(work);  // edits replace the document's own
    constexpr float kMostShare = 0.55F;
    const bool beside = has_room_for_both(ui, ImGui::GetContentRegionAvail().x);
    const auto rows = static_cast<float>(layered.layers.size() + (beside ? 1 : 2));
    const bool is_tight = rows * ImGui::GetFrameHeightWithSpacing() > kMostShare * room_px;
    const bool folded = bar.is_folded.value_or(is_tight);
    ImGui::BeginDisabled(current_vibration(work)->locked);
    for (std::size_t k = 0; k < layered.layers.size(); ++k) {
        if (!folded || k == open_layer(work)) draw_row(ui, work, bar, layered, k, folded);
    }
    draw_numbers(ui, work, layered);
    ImGui::EndDisabled();
}

void draw_add_layer(Ui& ui, Workspace& work) {
    const LayeredPattern* layered = current_layers(work);
    const std::size_t count = layered == nullptr ? 1 : layered->layers.size();
    const bool is_full = count >= limits::kMaxLayers;
    if (button(ui, {.id = "button:add layer",
                    .label = "Add layer",
                    .tip = "A second vibration at the same time: notes or ticks over this one.",
                    .why_not = is_full ? "A pattern has at most four layers." : "",
                    .enabled = !current_vibration(work)->locked})) {
        ui.waiting.emplace_back([&ui, &work] { add_layer(ui, work); });
    }
}

}  // namespace tact
