#include "app/document/editing.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "app/document/workspace.h"
#include "model/set/layers.h"
#include "model/set/vibration_search.h"
#include "model/text/names.h"

namespace tact {

namespace {

std::vector<Vibration>& vibrations(Workspace& work) { return work.document.edit().vibrations; }

// After vibrations came or went: indices that still exist.
void mend_selection(Workspace& work) {
    const std::size_t count = vibrations(work).size();
    std::erase_if(work.selection.others, [count](std::size_t index) { return index >= count; });
    if (work.selection.current >= count) work.selection.current = count == 0 ? 0 : count - 1;
    work.selection.others.erase(work.selection.current);
    work.selection.hovered.reset();
}

// After a step of undo or redo, from a set that was `before`.
void follow_step(Ui& ui, Workspace& work, const PatternSet& before, const std::string& text) {
    follow_renames(work, before, work.document.set);
    mend_selection(work);
    document_changed(work);
    say(ui, text);
}

// A mark of all that is selected, as the current one does not have it; it takes away the other one.
void toggle_mark(Ui& ui, Workspace& work, bool Vibration::*mark, bool Vibration::*other,
                 const char* set, const char* unset) {
    const Vibration* current = current_vibration(work);
    if (current == nullptr) return;
    const bool marks = !(current->*mark);
    for (const std::size_t index : selected_indices(work)) {
        vibrations(work)[index].*mark = marks;
        if (marks) vibrations(work)[index].*other = false;
    }
    document_changed(work);
    commit_step(ui, work, of_selection(work, marks ? set : unset));
}

const LayeredPattern* layers_of(const Vibration& vibration) {
    return std::get_if<LayeredPattern>(&vibration.source);
}

// The layer of the same place, or the last one.
std::size_t layer_in(const LayeredPattern& layered, std::size_t k) {
    return std::min(k, layered.layers.size() - 1);
}

const Pattern* pattern_in(const Vibration& vibration, std::size_t layer) {
    const LayeredPattern* layered = layers_of(vibration);
    if (layered == nullptr) return std::get_if<Pattern>(&vibration.source);
    return std::get_if<Pattern>(&layered->layers[layer_in(*layered, layer)].source);
}

}  // namespace

void insert_after_current(Workspace& work, std::vector<Vibration> fresh) {
    std::vector<Vibration>& all = vibrations(work);
    std::size_t place = all.empty() ? 0 : *selected_indices(work).rbegin() + 1;
    work.selection.others.clear();
    for (std::size_t k = 0; k < fresh.size(); ++k, ++place) {
        fresh[k].name = unused_name(work.document.set, fresh[k].name);
        fresh[k].generated = false;  // made by hand
        fresh[k].colour.clear();     // a copy is told from what it is a copy of
        fresh[k].ring = false;
        all.insert(all.begin() + static_cast<std::ptrdiff_t>(place), std::move(fresh[k]));
        if (k == 0) work.selection.current = place;
        if (k > 0) work.selection.others.insert(place);
    }
    work.selection.scroll_to_current = true;
    document_changed(work);
}

const Vibration* current_vibration(const Workspace& work) {
    const auto& all = work.document.set.vibrations;
    return work.selection.current < all.size() ? &all[work.selection.current] : nullptr;
}

std::vector<std::size_t> selected_indices(const Workspace& work) {
    if (work.document.set.vibrations.empty()) return {};
    std::set<std::size_t> all = work.selection.others;
    const bool hides = !work.selection.search.empty() || is_narrowed_to_picked(work.selection);
    if (!all.empty() && hides) {
        const std::vector<std::size_t> listed = listed_indices(work);
        std::erase_if(all, [&](std::size_t k) { return !std::ranges::binary_search(listed, k); });
    }
    all.insert(work.selection.current);
    return {all.begin(), all.end()};
}

std::vector<std::size_t> listed_indices(const Workspace& work) {
    const auto& all = work.document.set.vibrations;
    const VibrationSearch search(work.selection.search);
    const bool only_picked = is_narrowed_to_picked(work.selection);
    std::vector<std::size_t> indices;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (only_picked && !work.selection.picked.contains(all[k].name)) continue;
        if (search.finds(all[k])) indices.push_back(k);
    }
    return indices;
}

void select_only(Workspace& work, std::size_t index) {
    work.selection.current = index;
    work.selection.others.clear();
}

void toggle_selected(Workspace& work, std::size_t index) {
    if (index == work.selection.current) return;
    if (work.selection.others.erase(index) == 0) work.selection.others.insert(index);
}

void select_through(Workspace& work, std::size_t index) {
    const auto [first, last] = std::minmax(work.selection.current, index);
    for (const std::size_t k : listed_indices(work)) {
        if (k >= first && k <= last && k != work.selection.current) work.selection.others.insert(k);
    }
}

void select_next(Workspace& work, int step) {
    const std::vector<std::size_t>& table = work.selection.table_order;
    if (const auto at = std::ranges::find(table, work.selection.current); at != table.end()) {
        const auto last = static_cast<int>(table.size()) - 1;
        const int next = std::clamp(static_cast<int>(at - table.begin()) + step, 0, last);
        select_only(work, table[static_cast<std::size_t>(next)]);
        work.selection.scroll_to_current = true;
        return;
    }
    const std::vector<std::size_t> listed = listed_indices(work);
    if (listed.empty()) return;
    const auto last = static_cast<int>(listed.size()) - 1;
    // From a pattern that the search hides, on to the next one in the list.
    const auto from = std::ranges::lower_bound(listed, work.selection.current);
    const bool hidden = from == listed.end() || *from != work.selection.current;
    const int place = static_cast<int>(from - listed.begin()) - (hidden && step > 0 ? 1 : 0);
    const int next = std::clamp(place + step, 0, last);
    select_only(work, listed[static_cast<std::size_t>(next)]);
    work.selection.scroll_to_current = true;
}

void select_all(Workspace& work) {
    const std::vector<std::size_t> listed = listed_indices(work);
    if (listed.empty()) return;
    if (!std::ranges::binary_search(listed, work.selection.current)) select_only(work, listed[0]);
    work.selection.others.insert(listed.begin(), listed.end());
    work.selection.others.erase(work.selection.current);
}

void choose_pair(Workspace& work, std::size_t current, std::size_t partner) {
    if (partner >= work.document.set.vibrations.size()) return;
    select_only(work, current);
    work.selection.partner = work.document.set.vibrations[partner].name;
    work.selection.scroll_to_current = true;
}

const LayeredPattern* current_layers(const Workspace& work) {
    const Vibration* current = current_vibration(work);
    return current == nullptr ? nullptr : layers_of(*current);
}

std::size_t open_layer(const Workspace& work) {
    const LayeredPattern* layered = current_layers(work);
    if (layered == nullptr || work.selection.layer_of != current_vibration(work)->name) return 0;
    return layer_in(*layered, work.selection.layer);
}

void choose_layer(Workspace& work, std::size_t k) {
    if (const Vibration* current = current_vibration(work)) {
        work.selection.layer = k;
        work.selection.layer_of = current->name;
    }
}

const Pattern* shown_pattern(const Workspace& work) {
    const Vibration* current = current_vibration(work);
    return current == nullptr ? nullptr : pattern_in(*current, open_layer(work));
}

std::string shown_name(const Workspace& work) {
    const Vibration* current = current_vibration(work);
    if (current == nullptr) return {};
    const LayeredPattern* layered = current_layers(work);
    return layered == nullptr ? current->name
                              : current->name + ", " + name_of(*layered, open_layer(work));
}

Vibration layer_alone(const Workspace& work, const LayeredPattern& layered, std::size_t k) {
    Vibration alone;
    alone.name = current_vibration(work)->name + "\n" + std::to_string(k);
    if (const auto* pattern = std::get_if<Pattern>(&layered.layers[k].source)) {
        alone.source = *pattern;
    } else {
        alone.source = std::get<Measurement>(layered.layers[k].source);
    }
    return alone;
}

Vibration shown_vibration(const Workspace& work) {
    const LayeredPattern* layered = current_layers(work);
    return layered == nullptr ? *current_vibration(work)
                              : layer_alone(work, *layered, open_layer(work));
}

const Pattern* editable_layer(const Workspace& work, std::size_t index) {
    const Vibration& vibration = work.document.set.vibrations[index];
    return vibration.locked ? nullptr : pattern_in(vibration, open_layer(work));
}

const Pattern* editable_layer(const Workspace& work) {
    const Vibration* current = current_vibration(work);
    return current == nullptr ? nullptr : editable_layer(work, work.selection.current);
}

Pattern* layer_pattern(Vibration& vibration, std::size_t layer) {
    auto* layered = std::get_if<LayeredPattern>(&vibration.source);
    if (layered == nullptr) return std::get_if<Pattern>(&vibration.source);
    return std::get_if<Pattern>(&layered->layers[layer_in(*layered, layer)].source);
}

void document_changed(Workspace& work) {
    give_looks(work.document.edit());
    ++work.revision;
}

void model_changed(Workspace& work) {
    PatternSet& set = work.document.edit();
    set.model_origin.changed_by_hand = !set.model_origin.trained_on.empty();
    if (set.model == PerceptualModelParams{}) set.model_origin = {};
    document_changed(work);
}

void predictions_changed(Workspace& work) { ++work.revision; }

void follow_stale(Workspace& work) {
    if (work.stale_of == work.document.committed) return;
    work.stale_of = work.document.committed;
    work.stale = stale_patterns(*work.stale_of);
}

void commit_step(Ui& ui, Workspace& work, const std::string& label) {
    const std::string* last = work.document.history.undo_label();
    const bool joins =
        std::exchange(ui.field.nudges_on, false) && last != nullptr && *last == label;
    work.document.commit(label, joins);
}

namespace {

// In the place of the layer's, where the vibration has layers.
void put(Vibration& vibration, std::size_t layer, Pattern pattern) {
    Pattern* kept = vibration.locked ? nullptr : layer_pattern(vibration, layer);
    if (kept == nullptr) return;
    *kept = clamped(std::move(pattern));
    vibration.generated = false;
}

}  // namespace

const Pattern* editable_pattern(const Vibration& vibration) {
    return vibration.locked ? nullptr : std::get_if<Pattern>(&vibration.source);
}

void edit_current_pattern(Workspace& work, const Pattern& pattern) {
    if (current_vibration(work) == nullptr) return;
    put(vibrations(work)[work.selection.current], open_layer(work), pattern);
    document_changed(work);
}

void edit_current_recording(Workspace& work, const Measurement& recording,
                            const std::string& note) {
    const Vibration* vibration = current_vibration(work);
    if (vibration == nullptr || vibration->locked) return;
    if (!std::holds_alternative<Measurement>(vibration->source)) return;
    Vibration& edited = vibrations(work)[work.selection.current];
    edited.source = recording;
    edited.note = note;
    document_changed(work);
}

void edit_patterns(Workspace& work, const std::function<void(Pattern&)>& change) {
    for (const std::size_t index : selected_indices(work)) {
        const Pattern* before = editable_layer(work, index);
        if (before == nullptr) continue;
        Pattern pattern = *before;
        change(pattern);
        put(vibrations(work)[index], open_layer(work), std::move(pattern));
    }
    document_changed(work);
}

void put_sources(Workspace& work, const std::vector<std::size_t>& places,
                 const std::vector<VibrationSource>& sources) {
    for (std::size_t k = 0; k < places.size(); ++k) {
        Vibration& vibration = vibrations(work)[places[k]];
        if (vibration.locked || vibration.source == sources[k]) continue;
        vibration.source = sources[k];
        if (auto* pattern = std::get_if<Pattern>(&vibration.source)) *pattern = clamped(*pattern);
        vibration.generated = false;
    }
    document_changed(work);
}

std::string of_selection(const Workspace& work, const std::string& what) {
    const std::size_t count = selected_indices(work).size();
    if (count > 1) return what + " of " + patterns_text(count);
    const Vibration* current = current_vibration(work);
    return what + (current == nullptr ? "" : " of " + current->name);
}

void undo(Ui& ui, Workspace& work) {
    const PatternSet before = work.document.set;
    if (!work.document.undo()) return;
    follow_step(ui, work, before, menu_text("Undid:", work.document.history.redo_label()));
}

void redo(Ui& ui, Workspace& work) {
    const PatternSet before = work.document.set;
    if (!work.document.redo()) return;
    follow_step(ui, work, before, menu_text("Did again:", work.document.history.undo_label()));
}

void add_pattern(Ui& ui, Workspace& work) {
    Vibration fresh;
    fresh.name = "pattern";
    Pattern pattern;
    pattern.duration_s = work.document.set.duration_s;
    fresh.source = pattern;
    add_vibrations(ui, work, {fresh}, "Add pattern");
}

void add_vibrations(Ui& ui, Workspace& work, std::vector<Vibration> fresh,
                    const std::string& label) {
    insert_after_current(work, std::move(fresh));
    commit_step(ui, work, label);
}

void duplicate_selected(Ui& ui, Workspace& work) {
    std::vector<Vibration> copies;
    for (const std::size_t index : selected_indices(work)) {
        copies.push_back(vibrations(work)[index]);
    }
    if (copies.empty()) return;
    const std::string label = of_selection(work, "Duplicate");
    const std::string done = of_selection(work, "Made a duplicate");
    insert_after_current(work, std::move(copies));
    commit_step(ui, work, label);
    say(ui, done + ".");
}

void remove_selected(Ui& ui, Workspace& work) {
    std::set<std::size_t> all = work.selection.others;
    if (current_vibration(work) != nullptr) all.insert(work.selection.current);
    std::vector<std::size_t> gone(all.begin(), all.end());
    const std::vector<std::size_t> listed = listed_indices(work);
    const std::size_t hidden = std::erase_if(
        gone, [&listed](std::size_t k) { return !std::ranges::binary_search(listed, k); });
    std::erase_if(gone, [&](std::size_t index) { return vibrations(work)[index].locked; });
    if (gone.empty()) {
        if (current_vibration(work) == nullptr) return;
        return say(ui, hidden > 0
                           ? "Not deleted: the search hides what is selected. Clear it first."
                           : "Locked patterns are not deleted.");
    }
    const bool is_one = gone.size() == 1;
    const std::string what = is_one ? vibrations(work)[gone[0]].name : patterns_text(gone.size());
    for (auto index = gone.rbegin(); index != gone.rend(); ++index) {
        vibrations(work).erase(vibrations(work).begin() + static_cast<std::ptrdiff_t>(*index));
    }
    work.selection.others.clear();
    work.selection.current = gone.front();
    mend_selection(work);
    document_changed(work);
    commit_step(ui, work, "Delete " + what);
    say(ui, "Deleted " + what + ". Ctrl+Z brings " + (is_one ? "it" : "them") + " back." +
                (hidden > 0 ? " What the search hides was kept." : ""));
}

void move_vibration(Ui& ui, Workspace& work, std::size_t from, std::size_t to) {
    std::vector<Vibration>& all = vibrations(work);
    if (from == to || from >= all.size() || to >= all.size()) return;
    const std::string label = "Move " + all[from].name;
    const auto at = [&all](std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k); };
    if (from < to) std::rotate(at(from), at(from + 1), at(to + 1));
    if (from > to) std::rotate(at(to), at(from), at(from + 1));
    select_only(work, to);
    document_changed(work);
    commit_step(ui, work, label);
}

void rename_vibration(Ui& ui, Workspace& work, std::size_t index, const std::string& name) {
    std::vector<Vibration>& all = vibrations(work);
    if (index >= all.size() || all[index].name == name) return;
    if (name.empty()) {
        complain(ui, "A pattern needs a name: " + all[index].name + " keeps its own");
        return;
    }
    if (const std::string fault = name_fault(name); !fault.empty()) {
        complain(ui, "Not renamed: " + fault);
        return;
    }
    const bool taken =
        std::ranges::any_of(all, [&name](const Vibration& v) { return v.name == name; });
    if (taken) {
        complain(ui, "There is already a pattern called " + name + ": names are unique in a set");
        return;
    }
    const std::string before = all[index].name;
    rename_in(work.document.edit(), index, name);
    follow_rename(work, {before, name});
    all[index].generated = false;  // a name given by hand is to stay
    ui.fonts_outdated = true;      // the name may need new glyphs
    document_changed(work);
    commit_step(ui, work, "Rename " + before);
}

void toggle_locked(Ui& ui, Workspace& work) {
    toggle_mark(ui, work, &Vibration::locked, &Vibration::dropped, "Lock", "Unlock");
}

void toggle_dropped(Ui& ui, Workspace& work) {
    toggle_mark(ui, work, &Vibration::dropped, &Vibration::locked, "Exclude", "Include");
}

std::vector<std::size_t> unfelt_indices(const Workspace& work) {
    const std::vector<Vibration>& all = work.document.set.vibrations;
    std::vector<std::size_t> unfelt;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool is_free = !all[k].locked && !all[k].dropped;
        if (is_free && work.selection.unfelt.contains(all[k].name)) unfelt.push_back(k);
    }
    return unfelt;
}

void exclude_unfelt(Ui& ui, Workspace& work) {
    const std::vector<std::size_t> unfelt = unfelt_indices(work);
    if (unfelt.empty()) return;
    for (const std::size_t index : unfelt) vibrations(work)[index].dropped = true;
    document_changed(work);
    const std::string what = patterns_text(unfelt.size());
    commit_step(ui, work, "Exclude " + what + " not felt");
    say(ui, "Excluded " + what + " that no receptor answers to. Ctrl+Z takes it back.");
}

double shown_duration_s(const Workspace& work) { return longest_s(work.document.set); }

void note_pressed(Workspace& work, const Vibration& vibration) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool is_drag = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >=
                         io.MouseDragThreshold * io.MouseDragThreshold;
    if (!io.MouseDown[ImGuiMouseButton_Left] || is_drag) return;
    work.selection.pressed = vibration;
}

}  // namespace tact
