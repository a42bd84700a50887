// What a run notes of all pairs, so that no frame has to.
#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>

#include "app/map/map.h"
#include "model/map/group_tree.h"
#include "model/map/map_scale.h"
#include "tests/support/mixed_set.h"

namespace map_facts_test {

using namespace tact;

namespace {

// Short: DTW is quadratic.
PatternSet short_mixed_set(std::size_t patterns) {
    PatternSet set = mixed_set(patterns);
    set.duration_s = 0.15;
    for (Vibration& vibration : set.vibrations) {
        auto& pattern = std::get<Pattern>(vibration.source);
        pattern.duration_s = std::min(0.05 * pattern.duration_s, 0.15);
        pattern.attack_s = 0.0;
        pattern.transients.clear();
    }
    return set;
}

LiveMap map_of(const PatternSet& set, bool preview) {
    LiveMapRequest request;
    request.set = std::make_shared<const PatternSet>(set);
    request.preview = preview;
    std::atomic<float> progress{0.0F};
    auto map = LiveMapWork(1)(request, {}, progress);
    REQUIRE(map.has_value());
    return *std::move(map);
}

}  // namespace

TEST_CASE("map facts: they are those of its pairs, however the map is turned") {
    const PatternSet set = short_mixed_set(8);
    for (const bool preview : {true, false}) {
        const LiveMap map = map_of(set, preview);
        CHECK(map.alike.pm == clustered_order(group_tree(map.prediction.pm)));
        CHECK(map.alike.nc == clustered_order(group_tree(map.prediction.nc)));
        CHECK(map.alike.oc == clustered_order(group_tree(map.prediction.oc)));
        CHECK(map.prediction.pm.condensed[map.closest] == map.sorted_pm.front());
        CHECK(std::ranges::is_sorted(map.sorted_pm));
        CHECK(map.sorted_pm.back() == largest_pm(map));
        const Eigen::Matrix3d turn = (Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()) *
                                      Eigen::AngleAxisd(-1.9, Eigen::Vector3d::UnitZ()))
                                         .toRotationMatrix();
        const Eigen::MatrixXd turned = map.space.points * turn.transpose();
        CHECK(map.length_of_pm > 0.0);
        CHECK(length_of_one(turned, map.prediction.pm) == doctest::Approx(map.length_of_pm));
    }
}

TEST_CASE("map facts: patterns are kept at their own lengths, and compared at the set's") {
    const PatternSet set = short_mixed_set(8);
    const LiveMap map = map_of(set, false);
    const std::vector<Waveform> whole = model_waveforms(set);
    PredictOptions alone;
    alone.threads = 1;
    CHECK(map.prediction.pm == predict(whole, set.model, alone)->pm);
    std::size_t kept = 0;
    std::size_t padded = 0;
    for (std::size_t k = 0; k < whole.size(); ++k) {
        kept += map.prediction.codes[k]->waveform.samples_g.size();
        padded += whole[k].samples_g.size();
        CHECK(coded_waveform(*map.prediction.codes[k]) == whole[k]);
    }
    CHECK(2 * kept < padded);
    // What computes with whole waveforms takes the codes as they are.
    alone.previous = &map.prediction;
    CHECK(predict(whole, set.model, alone)->codes == map.prediction.codes);
}

}  // namespace map_facts_test
