#include "model/tasks/set_people.h"

#include <algorithm>
#include <utility>

#include "model/set/set_ratings.h"

namespace tact {

Expected<Counted> set_people(const PatternSet& meant, const CountRule& who) {
    Expected<RatingStudy> study = study_of(meant);
    if (!study) return study.error();
    CountRule rule = who;
    for (const Standing& one : study->standings) {
        const bool is_excluded =
            std::ranges::find(rule.exclude, one.participant) != rule.exclude.end();
        if (!is_excluded) rule.include.push_back(one.participant);
    }
    return who_counts(*std::move(study), rule);
}

}  // namespace tact
