#include "model/evaluation/metric.h"

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace metric_test {

using namespace tact;

TEST_CASE("metrics: every one is found by its key, and says what it is and from where") {
    std::set<std::string> keys;
    for (const Metric metric : kMetrics) {
        const MetricTraits& about = traits(metric);
        CAPTURE(about.key);
        const auto found = metric_named(about.key);
        REQUIRE(found);
        CHECK(*found == metric);
        keys.insert(about.key);
        CHECK(std::string(about.name) != "");
        CHECK(std::string(about.description) != "");
        const bool says_ours = std::string(about.source).starts_with("ours");
        CHECK(says_ours == about.is_reference);
    }
    CHECK(keys.size() == kMetricCount);
}

TEST_CASE("metrics: an unknown key is told the known ones, and VibroMAF's why it is none") {
    for (const char* key : {"", "taste", "PM", "st_sim"}) {
        const auto found = metric_named(key);
        REQUIRE_FALSE(found);
        for (const Metric metric : kMetrics) {
            CHECK(found.error().message.find(traits(metric).key) != std::string::npos);
        }
    }
    const auto vibromaf = metric_named("vibromaf");
    REQUIRE_FALSE(vibromaf);
    CHECK(vibromaf.error().message.starts_with("vibromaf is no distance: "));
}

}  // namespace metric_test
