#include "model/ask/moved_point.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "model/common/random.h"
#include "model/map/mds.h"
#include "model/map/procrustes.h"
#include "model/pattern/pattern_parameter.h"
#include "tests/model/ask/short_sets.h"

namespace moved_point_test {

using namespace tact;

namespace {

Prediction predicted_of(const PatternSet& set) { return *predict(model_waveforms(set), set.model); }

Eigen::MatrixXd map_of(const PatternSet& set) {
    return nonmetric_mds(predicted_of(set).pm, standard_mds_params(set.vibrations.size(), 2))
        .points;
}

double diameter_of(const Eigen::MatrixXd& points) {
    double largest = 0.0;
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        for (Eigen::Index j = 0; j < i; ++j) {
            largest = std::max(largest, (points.row(i) - points.row(j)).norm());
        }
    }
    return largest;
}

}  // namespace

TEST_CASE("moved point: an unchanged pattern is where it is; the same bits on any threads") {
    const PatternSet set = short_set(10, {0.25, 30.0, 6.0, 4});
    const MapAsItIs map{model_waveforms(set), set.model, map_of(set), {}};
    auto one = MovedPoint::of(map, 2, 1, {});
    auto four = MovedPoint::of(map, 2, 4, {});
    REQUIRE(one);
    REQUIRE(four);
    CHECK(((*one)(map.waveforms[2], {})->at - map.points.row(2)).norm() < 1e-12);
    Pattern changed = std::get<Pattern>(set.vibrations[2].source);
    changed.amplitude_g = 3.0;
    const Waveform waveform = render(changed);
    CHECK((*one)(waveform, {})->at == (*four)(waveform, {})->at);
    std::stop_source stop;
    stop.request_stop();
    CHECK_FALSE(MovedPoint::of(map, 2, 1, stop.get_token()));
    CHECK_FALSE((*one)(waveform, stop.get_token()));
}

TEST_CASE("moved point: it is where the map has the point once the number is really set" *
          doctest::test_suite("long")) {
    const PatternSet set = short_set(10, {0.25, 30.0, 6.0, 4});
    const Eigen::MatrixXd points = map_of(set);
    const auto base = std::make_shared<const Prediction>(predicted_of(set));
    RandomStream random{3};
    int near = 0;
    constexpr int kTries = 50;
    for (int tried = 0; tried < kTries; ++tried) {
        const std::size_t row = next_index(random, set.vibrations.size());
        const PatternParameter parameter =
            std::array{PatternParameter::amplitude, PatternParameter::carrier,
                       PatternParameter::modulation}[next_index(random, 3)];
        PatternSet changed = set;
        auto& pattern = std::get<Pattern>(changed.vibrations[row].source);
        const double value = *value_of(pattern, parameter);
        pattern = with_value(pattern, parameter, std::max(1.0, value) * (1.0 + next_even(random)));
        auto moved = MovedPoint::of({model_waveforms(set), set.model, points, base}, row, 0, {});
        const auto place = moved->mapped_again(render(pattern), {});
        const auto quick = (*moved)(render(pattern), {});
        const Eigen::MatrixXd after = procrustes(map_of(changed), points, false).aligned;
        const double off =
            (place->at - after.row(static_cast<Eigen::Index>(row))).norm() / diameter_of(after);
        const double quickly =
            (quick->at - after.row(static_cast<Eigen::Index>(row))).norm() / diameter_of(after);
        CHECK(off <= 0.02);
        near += quickly <= 0.02;
    }
    // Going on from how it lies: for the rest another minimum of the map is lower then.
    CHECK(near >= 25);
}

}  // namespace moved_point_test
