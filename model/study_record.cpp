#include "model/study_record.h"

#include <algorithm>
#include <cstdio>

#include "model/fingerprint.h"

namespace tact {

std::string instructions_of(const StudyDesign& design, StudyKind kind) {
    if (kind == StudyKind::pairwise || !design.instructions.empty()) return instructions_of(design);
    return "You will sort vibrations into groups, so that what feels alike lies together.\n\n"
           "Click a number to feel it, as often as you like, and drag it into a group. First you "
           "make as many groups as you please; then you are asked for given numbers of groups. "
           "There is no right or wrong answer; what counts is what you feel.\n\n"
           "You may stop at any time.";
}

std::string study_fingerprint(const PatternSet& set, const std::vector<std::string>& names) {
    std::uint64_t sum = 0;
    for (const std::string& name : names) {
        sum = mixed(sum, std::span<const char>(name));
        if (const auto place = place_named(set, name)) {
            const Waveform waveform = waveform_of(set.vibrations[*place]);
            sum = mixed(sum, std::span<const double>(waveform.samples_g));
        }
    }
    char text[24];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(sum));
    return text;
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

std::size_t answers_wanted(const StudyRecord& record) {
    const StudyHeader& header = record.header;
    if (header.kind == StudyKind::pairwise) {
        return trial_count(header.design, header.patterns.size());
    }
    if (!header.design.groups.empty()) return header.design.groups.size();
    // Until it is known, a free choice of the middle is expected.
    const std::size_t free_choice = record.sortings.empty()
                                        ? header.patterns.size() / 2
                                        : group_count(record.sortings.front().groups);
    return sorting_rounds(header.patterns.size(), free_choice).size();
}

std::size_t answers_given(const StudyRecord& record) {
    return record.header.kind == StudyKind::pairwise ? record.answers.size()
                                                     : record.sortings.size();
}

}  // namespace tact
