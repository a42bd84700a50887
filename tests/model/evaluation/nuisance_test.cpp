#include "model/evaluation/nuisance.h"

#include <cmath>

#include "model/study/ratings.h"
#include "tests/support/golden.h"

namespace nuisance_test {

using namespace tact;

namespace {

Vibration sounding(double duration_s, double amplitude_g) {
    Pattern pattern;
    pattern.duration_s = duration_s;
    pattern.amplitude_g = amplitude_g;
    Vibration vibration;
    vibration.source = pattern;
    return vibration;
}

}  // namespace

TEST_CASE("nuisance: partial rho is what regression leaves of the ranks") {
    const golden::Json table = golden::read("metric_statistics.json", "people");
    const std::size_t size = table.at("size");
    RatingStudy study;
    for (std::size_t k = 0; k < size; ++k) study.labels.push_back(std::to_string(k));
    for (const auto& one : table.at("said")) {
        study.judgements.push_back({std::to_string(study.judgements.size()), one});
    }
    const Dissimilarity metric{size, table.at("metrics").at(1).get<std::vector<double>>()};
    const Dissimilarity nuisance{size, table.at("given").get<std::vector<double>>()};
    const Given got = given("file", nuisance, mean_ratings(study), {metric}, {});
    CHECK(std::abs(got.metrics[0].rho - table.at("partial_of_second").get<double>()) <= 1e-12);
    // Ends of intervals of other draws.
    const auto interval = table.at("partial_interval").get<std::vector<double>>();
    CHECK(std::abs(got.metrics[0].interval.low - interval[0]) <= 0.05);
    CHECK(std::abs(got.metrics[0].interval.high - interval[1]) <= 0.03);
}

TEST_CASE("nuisance: a metric that is the nuisance itself says nothing beyond it") {
    const Dissimilarity length{4, {1, 2, 3, 4, 5, 7}};
    const Dissimilarity ratings{4, {2, 1, 4, 3, 6, 5}};
    const Given got = given("length", length, ratings, {length}, {.draws = 20});
    CHECK(got.rho_alone == spearman(length.condensed, ratings.condensed));
    CHECK(std::isnan(got.metrics[0].rho));
    CHECK(std::isnan(got.metrics[0].interval.low));
}

TEST_CASE("nuisance: twice as long is so many seconds, twice as strong is 6 dB") {
    PatternSet set;
    set.vibrations = {sounding(0.5, 0.4), sounding(1.0, 0.4), sounding(1.0, 0.8)};
    const auto length = nuisance_named("duration", set);
    const auto level = nuisance_named("level", set);
    REQUIRE(length);
    REQUIRE(level);
    // The last sample of a sine may be 0.
    CHECK(std::abs((*length)(0, 1) - 0.5) <= 0.001);
    CHECK((*length)(1, 2) == 0.0);
    CHECK(std::abs((*level)(1, 2) - 6.0206) <= 1e-4);
    CHECK_FALSE(nuisance_named("colour", set));
}

}  // namespace nuisance_test
