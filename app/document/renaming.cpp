#include "app/document/editing.h"

#include <algorithm>

#include "model/set/layers.h"

namespace tact {

namespace {

void rename_measured(Vibration& vibration, const std::string& before, const std::string& after) {
    for (Measurement* measurement : recordings_in(vibration)) {
        if (measurement->measures == before) measurement->measures = after;
    }
}

}  // namespace

void rename_in(PatternSet& set, std::size_t index, const std::string& name) {
    const std::string before = set.vibrations[index].name;
    for (Vibration& vibration : set.vibrations) rename_measured(vibration, before, name);
    for (Ratings& ratings : set.ratings) std::ranges::replace(ratings.labels, before, name);
    for (ToldApart& told : set.told_apart) rename_in(told, before, name);
    std::ranges::replace(set.study.patterns, before, name);
    set.vibrations[index].name = name;
}

void follow_rename(Workspace& work, const Renaming& renaming) {
    follow(renaming, work.selection.partner);
    follow(renaming, work.selection.pinned);
    follow(renaming, work.selection.layer_of);
    for (Vibration& copied : work.clipboard) {
        rename_measured(copied, renaming.before, renaming.after);
    }
    work.changes.renamings.push_back(renaming);
}

void follow_renames(Workspace& work, const PatternSet& before, const PatternSet& after) {
    if (before.vibrations.size() != after.vibrations.size()) return;
    for (std::size_t k = 0; k < after.vibrations.size(); ++k) {
        const std::string& was = before.vibrations[k].name;
        const std::string& is = after.vibrations[k].name;
        // Else it is another pattern that came to stand here.
        if (was != is && !place_named(after, was) && !place_named(before, is)) {
            follow_rename(work, {was, is});
        }
    }
}

}  // namespace tact
