#include "model/algebra/set_edits.h"

#include "model/set/pattern_set.h"

namespace tact {

namespace {

Expected<std::vector<Edit>> resolved(const PatternSet& set, std::span<const NamedEdit> edits) {
    std::vector<Edit> all;
    for (const NamedEdit& named : edits) {
        Edit edit{named.kind, named.number};
        if (traits(named.kind).needs == EditNeeds::pattern) {
            const Expected<std::size_t> place = place_of(set, named.other);
            if (!place) {
                return Error{std::string(traits(named.kind).key) + ": " + place.error().message};
            }
            edit.other = set.vibrations[*place].source;
            edit.other_name = named.other;
        }
        all.push_back(std::move(edit));
    }
    return all;
}

// The edits are resolved once for all patterns; what is wrong with them is said of the first.
Expected<VibrationSource> edited_source(const PatternSet& set, std::size_t place,
                                        const Expected<std::vector<Edit>>& edits) {
    if (!edits) return edits.error();
    const Vibration& vibration = set.vibrations[place];
    Expected<VibrationSource> result = edited_source(vibration, *edits, set.model.coding.tables);
    if (!result) return Error{"\"" + vibration.name + "\", " + result.error().message};
    return result;
}

}  // namespace

Expected<PatternSet> with_edits(const PatternSet& set, std::span<const std::string> names,
                                std::span<const NamedEdit> edits) {
    const Expected<std::vector<Edit>> all = resolved(set, edits);
    PatternSet changed = set;
    for (const std::string& name : names) {
        const Expected<std::size_t> place = place_of(set, name);
        if (!place) return place.error();
        Vibration& vibration = changed.vibrations[*place];
        if (vibration.locked) return Error{"\"" + name + "\" is locked: unlock it to edit it"};
        const Expected<VibrationSource> source = edited_source(set, *place, all);
        if (!source) return source.error();
        vibration.source = *source;
        vibration.generated = false;
    }
    return changed;
}

Expected<EditedSet> with_edits_of_all(const PatternSet& set, std::span<const NamedEdit> edits) {
    const Expected<std::vector<Edit>> all = resolved(set, edits);
    EditedSet result{set, {}};
    bool any = false;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        Vibration& vibration = result.set.vibrations[k];
        if (vibration.locked) continue;
        const Expected<VibrationSource> source = edited_source(set, k, all);
        if (!source) {
            result.left.push_back(source.error().message);
            continue;
        }
        any = true;
        vibration.source = *source;
        vibration.generated = false;
    }
    if (any) return result;
    if (!result.left.empty()) return Error{result.left.front()};
    return Error{"expected a pattern that is not locked, got none"};
}

Expected<PatternSet> with_edited_copy(const PatternSet& set, const std::string& name,
                                      std::span<const NamedEdit> edits, const std::string& as) {
    const Expected<std::size_t> place = place_of(set, name);
    if (!place) return place.error();
    const Expected<VibrationSource> source = edited_source(set, *place, resolved(set, edits));
    if (!source) return source.error();
    PatternSet changed = set;
    Vibration copy;
    copy.name = unused_name(set, as);
    copy.source = *source;
    copy.note = set.vibrations[*place].note;
    changed.vibrations.insert(changed.vibrations.begin() + static_cast<std::ptrdiff_t>(*place) + 1,
                              std::move(copy));
    return changed;
}

}  // namespace tact
