#include "app/document/editing.h"

#include <algorithm>
#include <utility>

#include "app/document/renaming.h"
#include "app/ui/widgets.h"

namespace tact {

namespace {

std::vector<Vibration>& vibrations(App& app) { return app.document.set.vibrations; }

// After vibrations came or went: indices that still exist.
void mend_selection(App& app) {
    const std::size_t count = vibrations(app).size();
    std::erase_if(app.selection.others, [count](std::size_t index) { return index >= count; });
    if (app.selection.current >= count) app.selection.current = count == 0 ? 0 : count - 1;
    app.selection.others.erase(app.selection.current);
    app.selection.hovered.reset();
}

// Puts vibrations behind the current one under names that are free, and selects them.
void insert_after_current(App& app, std::vector<Vibration> fresh) {
    std::vector<Vibration>& all = vibrations(app);
    std::size_t place = all.empty() ? 0 : *selected_indices(app).rbegin() + 1;
    app.selection.others.clear();
    for (std::size_t k = 0; k < fresh.size(); ++k, ++place) {
        fresh[k].name = unused_name(app.document.set, fresh[k].name);
        fresh[k].generated = false;  // made by hand
        all.insert(all.begin() + static_cast<std::ptrdiff_t>(place), std::move(fresh[k]));
        if (k == 0) app.selection.current = place;
        if (k > 0) app.selection.others.insert(place);
    }
    app.selection.scroll_to_current = true;
    document_changed(app);
}

void show_state(App& app, const std::shared_ptr<const PatternSet>& state, const std::string& text) {
    if (!state) return;
    follow_renames(app, app.document.set, *state);
    app.document.set = *state;
    app.committed = state;
    mend_selection(app);
    document_changed(app);
    say(app, text);
}

}  // namespace

const Vibration* current_vibration(const App& app) {
    const auto& all = app.document.set.vibrations;
    return app.selection.current < all.size() ? &all[app.selection.current] : nullptr;
}

std::vector<std::size_t> selected_indices(const App& app) {
    if (app.document.set.vibrations.empty()) return {};
    std::set<std::size_t> all = app.selection.others;
    if (!all.empty() && !app.selection.search.empty()) {
        const std::vector<std::size_t> listed = listed_indices(app);
        std::erase_if(all, [&](std::size_t k) { return !std::ranges::binary_search(listed, k); });
    }
    all.insert(app.selection.current);
    return {all.begin(), all.end()};
}

std::vector<std::size_t> listed_indices(const App& app) {
    const auto& all = app.document.set.vibrations;
    const std::string wanted = lower_case(app.selection.search);
    std::vector<std::size_t> indices;
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (lower_case(all[k].name).find(wanted) != std::string::npos) indices.push_back(k);
    }
    return indices;
}

void select_only(App& app, std::size_t index) {
    app.selection.current = index;
    app.selection.others.clear();
}

void toggle_selected(App& app, std::size_t index) {
    if (index == app.selection.current) return;
    if (app.selection.others.erase(index) == 0) app.selection.others.insert(index);
}

void select_through(App& app, std::size_t index) {
    const auto [first, last] = std::minmax(app.selection.current, index);
    for (const std::size_t k : listed_indices(app)) {
        if (k >= first && k <= last && k != app.selection.current) app.selection.others.insert(k);
    }
}

void select_all(App& app) {
    const std::vector<std::size_t> listed = listed_indices(app);
    if (listed.empty()) return;
    if (!std::ranges::binary_search(listed, app.selection.current)) select_only(app, listed[0]);
    app.selection.others.insert(listed.begin(), listed.end());
    app.selection.others.erase(app.selection.current);
}

void choose_pair(App& app, std::size_t current, std::size_t partner) {
    if (partner >= app.document.set.vibrations.size()) return;
    select_only(app, current);
    app.partner = app.document.set.vibrations[partner].name;
    app.selection.scroll_to_current = true;
}

void document_changed(App& app) { ++app.revision; }

void predictions_changed(App& app) { ++app.revision; }

void commit_step(App& app, const std::string& label) {
    auto after = std::make_shared<const PatternSet>(app.document.set);
    const std::string* last = app.history.undo_label();
    const bool joins =
        std::exchange(app.editor.nudges_on, false) && last != nullptr && *last == label;
    const bool moved = joins ? app.history.join(app.committed, after, label)
                             : app.history.commit(app.committed, after, label);
    if (moved) app.committed = std::move(after);
}

void edit_patterns(App& app, const std::function<void(Pattern&)>& change) {
    for (const std::size_t index : selected_indices(app)) {
        Vibration& vibration = vibrations(app)[index];
        auto* pattern = std::get_if<Pattern>(&vibration.source);
        if (pattern == nullptr || vibration.locked) continue;
        change(*pattern);
        *pattern = clamped(std::move(*pattern));
        vibration.generated = false;
    }
    document_changed(app);
}

std::string of_selection(const App& app, const std::string& what) {
    const std::size_t count = selected_indices(app).size();
    if (count > 1) return what + " of " + std::to_string(count) + " patterns";
    const Vibration* current = current_vibration(app);
    return what + (current == nullptr ? "" : " of " + current->name);
}

void undo(App& app) {
    const std::string text = menu_text("Undid:", app.history.undo_label());
    show_state(app, app.history.undo(), text);
}

void redo(App& app) {
    const std::string text = menu_text("Did again:", app.history.redo_label());
    show_state(app, app.history.redo(), text);
}

void add_pattern(App& app) {
    Vibration fresh;
    fresh.name = "pattern";
    Pattern pattern;
    pattern.duration_s = app.document.set.duration_s;
    fresh.source = pattern;
    insert_after_current(app, {fresh});
    commit_step(app, "Add pattern");
}

void duplicate_selected(App& app) {
    std::vector<Vibration> copies;
    for (const std::size_t index : selected_indices(app)) {
        copies.push_back(vibrations(app)[index]);
    }
    if (copies.empty()) return;
    const std::string label = of_selection(app, "Duplicate");
    insert_after_current(app, std::move(copies));
    commit_step(app, label);
}

void remove_selected(App& app) {
    std::set<std::size_t> all = app.selection.others;
    if (current_vibration(app) != nullptr) all.insert(app.selection.current);
    std::vector<std::size_t> gone(all.begin(), all.end());
    const std::vector<std::size_t> listed = listed_indices(app);
    const std::size_t hidden = std::erase_if(
        gone, [&listed](std::size_t k) { return !std::ranges::binary_search(listed, k); });
    std::erase_if(gone, [&app](std::size_t index) { return vibrations(app)[index].locked; });
    if (gone.empty()) {
        if (current_vibration(app) == nullptr) return;
        return say(app, hidden > 0
                            ? "Not deleted: the search hides what is selected. Clear it first."
                            : "Locked patterns are not deleted.");
    }
    const std::string label = gone.size() == 1
                                  ? "Delete " + vibrations(app)[gone[0]].name
                                  : "Delete " + std::to_string(gone.size()) + " patterns";
    for (auto index = gone.rbegin(); index != gone.rend(); ++index) {
        vibrations(app).erase(vibrations(app).begin() + static_cast<std::ptrdiff_t>(*index));
    }
    app.selection.others.clear();
    app.selection.current = gone.front();
    mend_selection(app);
    document_changed(app);
    commit_step(app, label);
    say(app, label + ". Ctrl+Z brings it back." +
                 (hidden > 0 ? " What the search hides was kept." : ""));
}

void copy_selected(App& app) {
    app.clipboard.clear();
    for (const std::size_t index : selected_indices(app)) {
        app.clipboard.push_back(vibrations(app)[index]);
    }
    say(app, app.clipboard.size() == 1
                 ? "Copied " + app.clipboard[0].name
                 : "Copied " + std::to_string(app.clipboard.size()) + " patterns");
}

void paste(App& app) {
    if (app.clipboard.empty()) {
        say(app, "Nothing to paste: copy a pattern first");
        return;
    }
    insert_after_current(app, app.clipboard);
    commit_step(app,
                app.clipboard.size() == 1 ? "Paste " + app.clipboard[0].name : "Paste patterns");
}

void move_vibration(App& app, std::size_t from, std::size_t to) {
    std::vector<Vibration>& all = vibrations(app);
    if (from == to || from >= all.size() || to >= all.size()) return;
    const std::string label = "Move " + all[from].name;
    const auto at = [&all](std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k); };
    if (from < to) std::rotate(at(from), at(from + 1), at(to + 1));
    if (from > to) std::rotate(at(to), at(from), at(from + 1));
    select_only(app, to);
    document_changed(app);
    commit_step(app, label);
}

void rename_vibration(App& app, std::size_t index, const std::string& name) {
    std::vector<Vibration>& all = vibrations(app);
    if (index >= all.size() || all[index].name == name) return;
    if (name.empty()) {
        complain(app, "A pattern needs a name: " + all[index].name + " keeps its own");
        return;
    }
    const bool taken =
        std::ranges::any_of(all, [&name](const Vibration& v) { return v.name == name; });
    if (taken) {
        complain(app, "There is already a pattern called " + name + ": names are unique in a set");
        return;
    }
    const std::string before = all[index].name;
    rename_in(app.document.set, index, name);
    follow_rename(app, {before, name});
    all[index].generated = false;  // a name given by hand is to stay
    app.fonts_outdated = true;     // the name may need new glyphs
    document_changed(app);
    commit_step(app, "Rename " + before);
}

void toggle_locked(App& app) {
    const Vibration* current = current_vibration(app);
    if (current == nullptr) return;
    const bool lock = !current->locked;
    for (const std::size_t index : selected_indices(app)) {
        vibrations(app)[index].locked = lock;
        if (lock) vibrations(app)[index].dropped = false;
    }
    document_changed(app);
    commit_step(app, of_selection(app, lock ? "Lock" : "Unlock"));
}

void toggle_dropped(App& app) {
    const Vibration* current = current_vibration(app);
    if (current == nullptr) return;
    const bool drop = !current->dropped;
    for (const std::size_t index : selected_indices(app)) {
        vibrations(app)[index].dropped = drop;
        if (drop) vibrations(app)[index].locked = false;
    }
    document_changed(app);
    commit_step(app, of_selection(app, drop ? "Drop" : "Take back"));
}

double shown_duration_s(const App& app) { return longest_s(app.document.set); }

void say(App& app, const std::string& text) { app.status = {text, false, app.time_s}; }

void complain(App& app, const std::string& text) { app.status = {text, true, app.time_s}; }

}  // namespace tact
