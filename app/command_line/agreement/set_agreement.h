// How metrics agree with the people of one set, with all that has to be said of both.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/rendering/labels.h"
#include "model/evaluation/metric_comparison.h"
#include "model/study/agreement.h"
#include "model/study/who_counts.h"

namespace tact {

struct SetAgreement {
    std::string name;
    std::size_t patterns = 0;  // rated ones
    RatedPeople people;
    std::vector<LeftOutParticipant> left_out;
    Labels labels;
    MetricTable table;
    InterRater raters;
};

// Only the rated patterns.
inline const RatedSet& rated_of(const SetAgreement& set) { return rated_part(set.people.rated); }

inline const char* key_of(const SetAgreement& set, std::size_t metric) {
    return traits(set.table.metrics[metric]).key;
}

}  // namespace tact
