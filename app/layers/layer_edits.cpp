#include "app/layers/layers.h"

#include <string>
#include <utility>
#include <vector>

#include "app/document/editing.h"
#include "model/set/layers.h"
#include "model/text/names.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

Vibration* editable(Workspace& work) {
    const Vibration* current = current_vibration(work);
    if (current == nullptr || current->locked) return nullptr;
    return &work.document.edit().vibrations[work.selection.current];
}

// What a person adds to a bed most often is as long, and softer.
Layer new_layer(const LayeredPattern& beside) {
    Layer layer;
    Pattern pattern;
    pattern.amplitude_g = 0.5;
    pattern.duration_s = duration_s(beside);
    layer.source = pattern;
    layer.name = "layer " + std::to_string(beside.layers.size() + 1);
    return layer;
}

}  // namespace

void edit_layer(Workspace& work, std::size_t k, const std::function<void(Layer&)>& change) {
    Vibration* vibration = editable(work);
    auto* layered =
        vibration == nullptr ? nullptr : std::get_if<LayeredPattern>(&vibration->source);
    if (layered == nullptr || k >= layered->layers.size()) return;
    LayeredPattern changed = *layered;
    change(changed.layers[k]);
    if (!fault_of(changed).empty()) return;
    *layered = std::move(changed);
    vibration->generated = false;
    document_changed(work);
}

std::string cut_name(const std::string& name) {
    return std::string(whole_characters(name, kMaxNameBytes));
}

void add_layer(Ui& ui, Workspace& work) {
    Vibration* vibration = editable(work);
    if (vibration == nullptr) return;
    LayeredPattern layered = as_layers(vibration->source);
    if (layered.layers.size() >= limits::kMaxLayers) return;
    if (layered.layers.size() == 1 && layered.layers[0].name.empty())
        layered.layers[0].name = "bed";
    layered.layers.push_back(new_layer(layered));
    vibration->source = std::move(layered);
    vibration->generated = false;
    choose_layer(work, limits::kMaxLayers);  // the last one
    document_changed(work);
    commit_step(ui, work, "Add a layer to " + current_vibration(work)->name);
}

void remove_layer(Ui& ui, Workspace& work, std::size_t k) {
    Vibration* vibration = editable(work);
    auto* layered =
        vibration == nullptr ? nullptr : std::get_if<LayeredPattern>(&vibration->source);
    if (layered == nullptr || k >= layered->layers.size() || layered->layers.size() < 2) return;
    LayeredPattern rest = *layered;
    const std::string name = name_of(rest, k);
    rest.layers.erase(rest.layers.begin() + static_cast<std::ptrdiff_t>(k));
    if (rest.layers.size() == 1) rest.layers[0].mute = rest.layers[0].solo = false;
    vibration->source = without_needless_layers(std::move(rest));
    vibration->generated = false;
    choose_layer(work, k == 0 ? 0 : k - 1);
    document_changed(work);
    commit_step(ui, work, "Remove " + name + " of " + current_vibration(work)->name);
}

namespace {

LayeredPattern layers_of_selected(const Workspace& work) {
    LayeredPattern all;
    for (const std::size_t index : selected_indices(work)) {
        const Vibration& vibration = work.document.set.vibrations[index];
        LayeredPattern own = as_layers(vibration.source);
        for (std::size_t k = 0; k < own.layers.size(); ++k) {
            Layer& layer = own.layers[k];
            if (own.layers.size() == 1) {
                layer.name = vibration.name;
            } else {
                layer.name = name_of(own, k);
            }
            all.layers.push_back(std::move(layer));
        }
    }
    return all;
}

}  // namespace

bool can_be_layered(const Workspace& work) {
    return selected_indices(work).size() > 1 &&
           layers_of_selected(work).layers.size() <= limits::kMaxLayers;
}

void layer_selected(Ui& ui, Workspace& work) {
    if (!can_be_layered(work)) return;
    LayeredPattern layered = layers_of_selected(work);
    if (const std::string fault = fault_of(layered); !fault.empty()) {
        return complain(ui, "These cannot be layers: " + fault + ".");
    }
    Vibration fresh;
    for (const Layer& layer : layered.layers) {
        fresh.name += (fresh.name.empty() ? "" : " + ") + layer.name;
    }
    fresh.name = cut_name(fresh.name);
    fresh.source = std::move(layered);
    add_vibrations(ui, work, {std::move(fresh)}, "Layer patterns");
}

void split_layers(Ui& ui, Workspace& work) {
    const LayeredPattern* layered = current_layers(work);
    if (layered == nullptr) return;
    std::vector<Vibration> parts;
    for (std::size_t k = 0; k < layered->layers.size(); ++k) {
        Layer layer = layered->layers[k];
        layer.mute = layer.solo = false;
        Vibration part;
        part.name = cut_name(current_vibration(work)->name + ", " + name_of(*layered, k));
        part.source = without_needless_layers({{std::move(layer)}});
        parts.push_back(std::move(part));
    }
    add_vibrations(ui, work, std::move(parts), "Split " + current_vibration(work)->name);
}

}  // namespace tact
