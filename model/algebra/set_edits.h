// Edits of patterns within their set.
//
// Source    ours
// Output    the set with every other vibration as it was, or one sentence on what cannot be edited
//           A recording that is edited has no file yet: store_measurements() writes one
// Left out  locked patterns: refused by name.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/algebra/algebra.h"
#include "model/algebra/source_edits.h"
#include "model/set/pattern_set.h"

namespace tact {

// An edit that names the other pattern.
struct NamedEdit {
    EditKind kind = EditKind::stretch;
    double number = 0.0;
    std::string other{};
};

// All edits of each named pattern, in their order. Another pattern is as it was in `set`, also
// where it is edited itself. An Error names the first that cannot be edited.
Expected<PatternSet> with_edits(const PatternSet& set, std::span<const std::string> names,
                                std::span<const NamedEdit> edits);

// All edits of every pattern that is not locked and can have them; an Error if none can.
struct EditedSet {
    PatternSet set;
    std::vector<std::string> left;  // "buzz", trim: expected ...: of each that stays as it was
};
Expected<EditedSet> with_edits_of_all(const PatternSet& set, std::span<const NamedEdit> edits);

// The edits of one pattern as a new one right behind it, by that name or one like it that is free.
Expected<PatternSet> with_edited_copy(const PatternSet& set, const std::string& name,
                                      std::span<const NamedEdit> edits, const std::string& as);

}  // namespace tact
