#include "model/evaluation/metric.h"

#include <string>

namespace tact {

namespace {

constexpr bool is_in_order() {
    for (std::size_t k = 0; k < kMetricCount; ++k) {
        if (static_cast<std::size_t>(kMetrics[k]) != k) return false;
    }
    return true;
}
static_assert(is_in_order(), "expected a row for each metric, in the order of Metric");

}  // namespace

const MetricTraits& traits(Metric metric) {
    return kMetricTraits[static_cast<std::size_t>(metric)];
}

Expected<Metric> metric_named(std::string_view key) {
    if (key == "vibromaf") {
        return Error{
            "vibromaf is no distance: it was trained to rate what codecs do to a vibration, and "
            "what it gives for different vibrations means nothing; st-sim and spqi are two of its "
            "features"};
    }
    std::string keys;
    for (const Metric metric : kMetrics) {
        if (traits(metric).key == key) return metric;
        keys += (keys.empty() ? "" : ", ") + std::string(traits(metric).key);
    }
    return Error{std::string(key) + " is no metric; expected one of " + keys};
}

}  // namespace tact
