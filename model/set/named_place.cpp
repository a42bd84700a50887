#include "model/set/named_place.h"

namespace tact {

Expected<std::size_t> place_of(const PatternSet& set, const std::string& name) {
    if (set.vibrations.empty()) return Error{"the set is empty, expected at least one pattern"};
    if (const auto place = place_named(set, name)) return *place;
    std::string known;
    for (std::size_t k = 0; k < set.vibrations.size(); ++k) {
        constexpr std::size_t kNamed = 12;
        if (k < kNamed) known += (k == 0 ? "" : ", ") + set.vibrations[k].name;
        if (k == kNamed) known += ", ...";
    }
    return Error{"there is no pattern \"" + name + "\", expected one of " + known};
}

Expected<std::size_t> pattern_place_of(const PatternSet& set, const std::string& name) {
    const Expected<std::size_t> place = place_of(set, name);
    if (!place || std::holds_alternative<Pattern>(set.vibrations[*place].source)) return place;
    const bool has_layers = std::holds_alternative<LayeredPattern>(set.vibrations[*place].source);
    return Error{"expected a pattern made of parameters, got " +
                 std::string(has_layers ? "the layers of" : "the recording") + " \"" + name + "\""};
}

const Pattern* pattern_named(const PatternSet& set, const std::string& name) {
    const auto place = place_named(set, name);
    return place ? std::get_if<Pattern>(&set.vibrations[*place].source) : nullptr;
}

}  // namespace tact
