// How metrics agree with the people of one set, with all that has to be said of both.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/foreign/foreign_metric.h"
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
    std::vector<ForeignMetric> foreign{};  // whose matrices stand behind those of the metrics
};

// Only the rated patterns.
inline const RatedSet& rated_of(const SetAgreement& set) { return rated_part(set.people.rated); }

inline std::size_t metric_count(const SetAgreement& set) { return set.table.matrices.size(); }

inline const char* key_of(const SetAgreement& set, std::size_t metric) {
    const std::size_t own = set.table.metrics.size();
    return metric < own ? traits(set.table.metrics[metric]).key
                        : set.foreign[metric - own].key.c_str();
}

}  // namespace tact
