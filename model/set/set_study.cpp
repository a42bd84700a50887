#include "model/set/set_study.h"

#include <algorithm>

#include "model/common/fingerprint.h"

namespace tact {

std::string study_fingerprint(const PatternSet& set, const std::vector<std::string>& names) {
    std::uint64_t sum = 0;
    for (const std::string& name : names) {
        sum = mixed(sum, std::span<const char>(name));
        if (const auto place = place_named(set, name)) {
            const Waveform waveform = waveform_of(set.vibrations[*place]);
            sum = mixed(sum, std::span<const double>(waveform.samples_g));
        }
    }
    return fingerprint_text(sum);
}

std::vector<std::string> study_patterns(const PatternSet& set) {
    std::vector<std::string> names = names_of(set);
    const std::vector<std::string>& chosen = set.study.patterns;
    if (chosen.empty()) return names;
    std::erase_if(names, [&chosen](const std::string& name) {
        return std::ranges::find(chosen, name) == chosen.end();
    });
    return names;
}

}  // namespace tact
