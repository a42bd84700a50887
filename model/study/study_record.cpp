#include "model/study/study_record.h"

namespace tact {

std::string instructions_of(const StudyDesign& design, StudyKind kind) {
    if (kind == StudyKind::pairwise || !design.instructions.empty()) return instructions_of(design);
    return "You will sort vibrations into groups, so that what feels alike lies together.\n\n"
           "Click a number to feel it, as often as you like, and drag it into a group. First you "
           "make as many groups as you please; then you are asked for given numbers of groups. "
           "There is no right or wrong answer; what counts is what you feel.\n\n"
           "You may stop at any time.";
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
