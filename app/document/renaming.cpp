#include "app/document/renaming.h"

#include <algorithm>

#include "app/measured/import_state.h"
#include "app/subset/subset_state.h"

namespace tact {

namespace {

void rename_measured(Vibration& vibration, const std::string& before, const std::string& after) {
    auto* measurement = std::get_if<Measurement>(&vibration.source);
    if (measurement != nullptr && measurement->measures == before) measurement->measures = after;
}

}  // namespace

void rename_in(PatternSet& set, std::size_t index, const std::string& name) {
    const std::string before = set.vibrations[index].name;
    for (Vibration& vibration : set.vibrations) rename_measured(vibration, before, name);
    for (Ratings& ratings : set.ratings) std::ranges::replace(ratings.labels, before, name);
    std::ranges::replace(set.study.patterns, before, name);
    set.vibrations[index].name = name;
}

void follow_rename(App& app, const std::string& before, const std::string& after) {
    const auto follow = [&](std::string& name) {
        if (name == before) name = after;
    };
    follow(app.partner);
    follow(app.pinned);
    follow(app.tour.before.pinned);
    follow(app.play.felt_on_hover);
    if (auto& sounding = app.play.sounding) {
        std::ranges::for_each(sounding->names, follow);
        follow(sounding->as_played.name);
    }
    for (Vibration& copied : app.clipboard) rename_measured(copied, before, after);
    if (app.import) std::ranges::for_each(app.import->patterns, follow);
    if (!app.subset) return;
    follow(app.subset->reference_a);
    follow(app.subset->reference_b);
    if (auto& opened = app.subset->opened) {
        follow(opened->first);
        follow(opened->second);
    }
}

void follow_renames(App& app, const PatternSet& before, const PatternSet& after) {
    if (before.vibrations.size() != after.vibrations.size()) return;
    for (std::size_t k = 0; k < after.vibrations.size(); ++k) {
        const std::string& was = before.vibrations[k].name;
        const std::string& is = after.vibrations[k].name;
        // Else it is another pattern that came to stand here.
        if (was != is && !place_named(after, was) && !place_named(before, is)) {
            follow_rename(app, was, is);
        }
    }
}

}  // namespace tact
