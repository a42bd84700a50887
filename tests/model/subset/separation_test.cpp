#include "model/subset/separation.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/common/random.h"
#include "model/map/mds.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/subset/set_subset.h"
#include "model/subset/subset_stability.h"

namespace separation_test {

using namespace tact;

namespace {

// Short ones: DTW is quadratic. The first two are nearly alike.
PatternSet short_set() {
    PatternSet set;
    set.duration_s = 0.2;
    const auto add = [&set](const char* name, double carrier_hz, double modulation_hz, double g) {
        Pattern pattern;
        pattern.duration_s = 0.2;
        pattern.amplitude_g = g;
        pattern.carriers[0].frequency_hz = carrier_hz;
        pattern.modulation.frequency_hz = modulation_hz;
        Vibration vibration;
        vibration.name = name;
        vibration.source = pattern;
        set.vibrations.push_back(vibration);
    };
    add("a", 150.0, 0.0, 1.0);
    add("b", 155.0, 0.0, 1.0);
    add("c", 60.0, 0.0, 1.6);
    add("d", 250.0, 20.0, 1.0);
    add("e", 80.0, 10.0, 0.5);
    return set;
}

Prediction predicted(const PatternSet& set) { return *predict(model_waveforms(set), set.model); }

Dissimilarity on_a_line(const std::vector<double>& x) {
    Dissimilarity result{x.size(), {}};
    for (std::size_t i = 0; i < x.size(); ++i) {
        for (std::size_t j = i + 1; j < x.size(); ++j) {
            result.condensed.push_back(std::abs(x[i] - x[j]));
        }
    }
    return result;
}

double nearest(const Dissimilarity& pm, std::size_t place) {
    double least = 1e300;
    for (std::size_t k = 0; k < pm.size; ++k) {
        if (k != place) least = std::min(least, pm(place, k));
    }
    return least;
}

}  // namespace

TEST_CASE("confusable: pairs up to the threshold, the closest first, no more than asked for") {
    const Dissimilarity line = on_a_line({0.0, 1.0, 3.0, 7.0});
    const auto pairs = confusable_pairs(line, 3.0, 10);
    REQUIRE(pairs.size() == 3);
    CHECK(pairs[0] == ConfusablePair{0, 1, 1.0});
    CHECK(pairs[1] == ConfusablePair{1, 2, 2.0});
    CHECK(pairs[2] == ConfusablePair{0, 2, 3.0});
    CHECK(confusable_pairs(line, 3.0, 1) == std::vector{ConfusablePair{0, 1, 1.0}});
    CHECK(among(line, std::vector<std::size_t>{0, 2, 3}).condensed ==
          std::vector<double>{3.0, 7.0, 4.0});
    CHECK(threshold_at(line, 0.0) == 1.0);
    CHECK(threshold_at(line, 1.0) == 7.0);
    CHECK(std::isnan(threshold_at({1, {}}, 0.5)));
}

TEST_CASE("separation: each change brings the pattern's PM to all others above the threshold") {
    const PatternSet set = short_set();
    const Prediction prediction = predicted(set);
    const double threshold = prediction.pm(0, 1);
    REQUIRE(nearest(prediction.pm, 1) <= threshold);
    const auto all = separations(set, prediction, 1, threshold);
    REQUIRE(all);
    REQUIRE_FALSE(all->empty());
    double steps = 0.0;
    for (const Separation& one : *all) {
        CAPTURE(traits(one.parameter).key);
        PatternSet changed = set;
        auto& pattern = std::get<Pattern>(changed.vibrations[1].source);
        CHECK(value_of(pattern, one.parameter) == one.from);
        pattern = with_value(pattern, one.parameter, one.to);
        const Dissimilarity pm = predicted(changed).pm;
        CHECK(nearest(pm, 1) == one.nearest);
        CHECK(pm(1, one.nearest_to) == one.nearest);
        CHECK(one.nearest > threshold);
        CHECK(one.steps >= steps);  // the smallest first
        steps = one.steps;
    }
}

TEST_CASE("separation: where one step is not enough, larger changes are found") {
    const PatternSet set = short_set();
    const Prediction prediction = predicted(set);
    const double threshold = threshold_at(prediction.pm, 0.4);
    const auto all = separations(set, prediction, 1, threshold);
    REQUIRE(all);
    REQUIRE_FALSE(all->empty());
    CHECK(all->front().steps > 1.0);
    CHECK(all->front().nearest > threshold);
}

TEST_CASE("separation: never less than a felt step, in random sets" * doctest::test_suite("long")) {
    RandomStream random{11};
    for (int drawn = 0; drawn < 12; ++drawn) {
        PatternSet set = short_set();
        for (Vibration& vibration : set.vibrations) {
            auto& pattern = std::get<Pattern>(vibration.source);
            pattern.amplitude_g = 1.0 + 0.9 * next_even(random);
            pattern.carriers[0].frequency_hz = 150.0 + 120.0 * next_even(random);
            pattern.modulation.frequency_hz = 5.0 * static_cast<double>(next_index(random, 4));
        }
        set.felt_steps.size[0] = 1.1 + 0.4 * std::abs(next_even(random));
        const Prediction prediction = predicted(set);
        SeparationOptions options;
        options.by_a_step = drawn % 2 == 0;
        if (drawn % 3 == 0) options.share = 0.2;
        const double threshold = threshold_at(prediction.pm, 0.1 * (drawn % 4));
        const auto all = separations(set, prediction, 1, threshold, options);
        REQUIRE(all);
        for (const Separation& one : *all) {
            CAPTURE(traits(one.parameter).key);
            CHECK(one.steps >= 1.0 - 1e-9);
            CHECK(steps_between(set.felt_steps, one.parameter, one.from, one.to) == one.steps);
        }
    }
}

TEST_CASE("separation: after the change no pair of the pattern is listed any more") {
    PatternSet set = short_set();
    std::get<Pattern>(set.vibrations[1].source) = std::get<Pattern>(set.vibrations[0].source);
    const Prediction prediction = predicted(set);
    for (const bool by_share : {true, false}) {
        SeparationOptions options;
        options.by_a_step = !by_share;
        if (by_share) options.share = 0.3;
        const double threshold = by_share ? threshold_at(prediction.pm, 0.3) : prediction.pm(0, 1);
        CHECK(pairs_within_a_step(set, prediction.pm).size() == 1);
        const auto all = separations(set, prediction, 1, threshold, options);
        REQUIRE(all);
        REQUIRE_FALSE(all->empty());
        for (const Separation& one : *all) {
            PatternSet changed = set;
            auto& pattern = std::get<Pattern>(changed.vibrations[1].source);
            pattern = with_value(pattern, one.parameter, one.to);
            const Dissimilarity pm = predicted(changed).pm;
            const auto listed = by_share ? confusable_pairs(pm, threshold_at(pm, 0.3), 99)
                                         : pairs_within_a_step(changed, pm);
            for (const ConfusablePair& pair : listed) CHECK((pair.a != 1 && pair.b != 1));
        }
    }
}

TEST_CASE("separation: from a subset alone, changes are found that do not part it from all") {
    const PatternSet set = short_set();
    const Prediction prediction = predicted(set);
    SeparationOptions options;
    options.from = {1, 2, 3};  // the pattern itself is among them
    const double threshold = prediction.pm(1, 2);
    const auto all = separations(set, prediction, 1, threshold, options);
    REQUIRE(all);
    REQUIRE_FALSE(all->empty());
    bool only_from_these = false;
    for (const Separation& one : *all) {
        CAPTURE(traits(one.parameter).key);
        PatternSet changed = set;
        auto& pattern = std::get<Pattern>(changed.vibrations[1].source);
        pattern = with_value(pattern, one.parameter, one.to);
        const Dissimilarity pm = predicted(changed).pm;
        CHECK(std::min(pm(1, 2), pm(1, 3)) == one.nearest);
        CHECK(one.nearest > threshold);
        CHECK((one.nearest_to == 2 || one.nearest_to == 3));
        only_from_these |= nearest(pm, 1) <= threshold;
    }
    CHECK(only_from_these);
}

TEST_CASE("separation: the same on one and on four threads; none when stopped") {
    const PatternSet set = short_set();
    const Prediction prediction = predicted(set);
    SeparationOptions options;
    options.threads = 1;
    const auto one = separations(set, prediction, 0, prediction.pm(0, 1), options);
    options.threads = 4;
    CHECK(separations(set, prediction, 0, prediction.pm(0, 1), options) == one);
    std::stop_source stop;
    stop.request_stop();
    options.stop = stop.get_token();
    CHECK_FALSE(separations(set, prediction, 0, prediction.pm(0, 1), options));
}

TEST_CASE("separation: past a limit in seconds it says so, and gives no more than it confirmed") {
    const PatternSet set = short_set();
    const Prediction prediction = predicted(set);
    SeparationOptions options;
    bool is_cut_off = false;
    options.cut_off = [&is_cut_off] { is_cut_off = true; };
    const auto whole = separations(set, prediction, 0, prediction.pm(0, 1), options);
    REQUIRE(whole);
    CHECK_FALSE(is_cut_off);
    options.time_limit_s = 0.0;
    const auto none = separations(set, prediction, 0, prediction.pm(0, 1), options);
    REQUIRE(none);
    CHECK(none->empty());
    CHECK(is_cut_off);
    // A stop by the person is no answer, limit or not.
    std::stop_source stop;
    stop.request_stop();
    options.stop = stop.get_token();
    is_cut_off = false;
    CHECK_FALSE(separations(set, prediction, 0, prediction.pm(0, 1), options));
    CHECK_FALSE(is_cut_off);
}

TEST_CASE("pattern parameters: a number that a pattern has not stays none") {
    Pattern plain;
    CHECK_FALSE(value_of(plain, PatternParameter::second_carrier));
    CHECK_FALSE(value_of(plain, PatternParameter::depth));
    CHECK(with_value(plain, PatternParameter::second_carrier, 80.0) == plain);
    Pattern drawn;
    drawn.amplitude_curve = {{0.5, 0.25}};
    drawn.frequency_curve = {{0.5, 80.0}};
    drawn.transients = {{0.5}};
    CHECK_FALSE(value_of(drawn, PatternParameter::carrier));
    CHECK(with_value(drawn, PatternParameter::carrier, 90.0) == drawn);
    Pattern louder = drawn;
    louder.amplitude_g = 2.0;
    CHECK(with_value(drawn, PatternParameter::amplitude, 2.0) == louder);
    CHECK(value_of(with_value(plain, PatternParameter::attack, 0.25), PatternParameter::attack) ==
          0.25);
}

TEST_CASE("stability: draws without any uncertainty all pick the same, and no point moves") {
    const PatternSet set = short_set();
    const Prediction prediction = predicted(set);
    const SubsetProblem problem = subset_problem(set, 3, SubsetObjective::max_min);
    const Subset subset = most_distinct_subset(prediction.pm, problem)->best;
    MdsParams mds = standard_mds_params(5, 3);
    const PerceptualSpace space = nonmetric_mds(prediction.pm, mds);
    StabilityParams params;
    params.draws = 3;
    params.threshold_db = 0.0;
    params.weight_step = 0.0;
    params.turned_share = 0.0;
    CHECK(drawn_params(set.model, params, 2) == set.model);
    const auto certain = subset_stability(set, problem, subset, space.points, params);
    REQUIRE(certain);
    const double sum = [&] {
        double all = 0.0;
        for (const double share : certain->share_picked) all += share;
        return all;
    }();
    CHECK(std::abs(sum - 3.0) <= 1e-12);  // three members in every draw
    for (const double share : certain->share_picked) CHECK((share == 0.0 || share == 1.0));
    REQUIRE(certain->moves.size() == 5);
    for (const Eigen::Matrix3Xd& moves : certain->moves) {
        CHECK(moves.cols() == 3);
        CHECK(moves.norm() <= 1e-8);
    }

    params = {};
    params.draws = 6;
    params.threads = 1;
    const auto one = subset_stability(set, problem, subset, space.points, params);
    params.threads = 4;
    const auto four = subset_stability(set, problem, subset, space.points, params);
    REQUIRE(one);
    REQUIRE(four);
    CHECK(one->share_picked == four->share_picked);
    CHECK(one->moves == four->moves);
    double moved = 0.0;
    double moved_at_first = 0.0;
    for (const Eigen::Matrix3Xd& moves : one->moves) {
        CHECK(moves.cols() == 6);
        moved += moves.norm();
        moved_at_first += moves.col(0).norm();
    }
    CHECK(moved > 0.0);
    CHECK(moved_at_first <= 1e-7);  // the first draw is the model in use
    std::stop_source stop;
    stop.request_stop();
    params.stop = stop.get_token();
    CHECK_FALSE(subset_stability(set, problem, subset, space.points, params));
}

TEST_CASE("stability: drawn thresholds stay within their decibels, and every draw is another") {
    const PerceptualModelParams params;
    const StabilityParams stability;
    CHECK(drawn_params(params, stability, 0) == params);
    for (std::size_t draw = 1; draw < 50; ++draw) {
        const PerceptualModelParams drawn = drawn_params(params, stability, draw);
        for (const Receptor type : kReceptors) {
            const auto& before = params.coding.tables.threshold[index_of(type)].value;
            const auto& after = drawn.coding.tables.threshold[index_of(type)].value;
            for (std::size_t k = 0; k < before.size(); ++k) {
                CHECK(std::abs(after[k] - before[k]) <= 6.0 / 20.0 + 1e-12);
            }
            CHECK(drawn.channel_weight[index_of(type)] >= 0.0);
        }
        CHECK_FALSE(drawn == drawn_params(params, stability, draw + 1));
        CHECK(drawn == drawn_params(params, stability, draw));
    }
}

TEST_CASE("stability: draws lie about the model in use, whatever its orders and choices are") {
    PerceptualModelParams other;
    other.coding.components = Components::peaks;
    other.coding.split = WindowSplit::first;
    other.coding.band_pass_order_per_edge = 9;
    other.coding.low_pass_order = 20;
    other.envelope.alignment = EnvelopeAlignment::centred;
    for (const PerceptualModelParams& model : {PerceptualModelParams{}, other}) {
        constexpr int kDraws = 400;
        int turned = 0;
        int shifted = 0;
        double band_pass = 0.0;
        double low_pass = 0.0;
        for (std::size_t draw = 1; draw <= kDraws; ++draw) {
            const PerceptualModelParams drawn = drawn_params(model, {}, draw);
            turned += drawn.coding.components != model.coding.components ? 1 : 0;
            shifted += drawn.envelope.alignment != model.envelope.alignment ? 1 : 0;
            const int edge =
                drawn.coding.band_pass_order_per_edge - model.coding.band_pass_order_per_edge;
            const int low = drawn.coding.low_pass_order - model.coding.low_pass_order;
            CHECK(std::abs(edge) <= 1);
            CHECK(std::abs(low) <= 2);
            CHECK(drawn.coding.low_pass_order <= limits::kFilterOrder.high);
            band_pass += edge;
            low_pass += low;
        }
        // One in four, and a mean of zero: four standard deviations.
        CHECK(std::abs(turned - kDraws / 4) <= 35);
        CHECK(std::abs(shifted - kDraws / 4) <= 35);
        CHECK(std::abs(band_pass / kDraws) <= 0.17);
        if (model.coding.low_pass_order <= limits::kFilterOrder.high - 2) {
            CHECK(std::abs(low_pass / kDraws) <= 0.29);
        }
    }
}

TEST_CASE("part of a set: its patterns and their ratings, by names") {
    PatternSet set = short_set();
    set.vibrations[1].locked = true;
    set.vibrations[4].dropped = true;
    const SubsetProblem problem = subset_problem(set, 3, SubsetObjective::max_sum);
    CHECK(problem.keep == std::vector<std::size_t>{1});
    CHECK(problem.drop == std::vector<std::size_t>{4});
    set.ratings.push_back({"P1", {"e", "d", "b", "a"}, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}, {}, {}});
    set.ratings.push_back({"P2", {"d", "c"}, {7.0}, {}, {}});
    ToldApart told;
    told.answers = {{{"a", "e", 3.0, 0, false}, 0, 0.0}, {{"a", "c", 4.0, 0, false}, 0, 0.0}};
    told.patterns = {"a", "e", "c"};
    told.versions = {"1", "2", "3"};
    set.told_apart = {told, among(told, {"a", "c"})};
    const PatternSet part = part_of(set, std::vector<std::size_t>{0, 1, 4});
    CHECK(names_of(part) == std::vector<std::string>{"a", "b", "e"});
    REQUIRE(part.ratings.size() == 1);  // of one pattern nothing is left to say
    REQUIRE(part.told_apart.size() == 1);
    CHECK(part.told_apart[0].answers == std::vector{told.answers[0]});
    CHECK(part.told_apart[0].versions == std::vector<std::string>{"1", "2"});
    CHECK(part.ratings[0].labels == std::vector<std::string>{"a", "b", "e"});
    CHECK(part.ratings[0].condensed == std::vector<double>{6.0, 3.0, 2.0});
}

TEST_CASE("separation: a threshold that is no finite number parts nothing, and asks for no work") {
    const PatternSet set = short_set();
    const Prediction prediction = predicted(set);
    SeparationOptions options;
    options.progress = [](double) { FAIL("work was begun"); };
    for (const double threshold : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        const auto found = separations(set, prediction, 0, threshold, options);
        REQUIRE(found);
        CHECK(found->empty());
        CHECK(confusable_pairs(prediction.pm, threshold, 100).empty());
    }
}

TEST_CASE("confusable: a share of the pairs holds as many as it says, for every percent") {
    Dissimilarity all{15, {}};  // 105 pairs; the first 101 count
    for (std::size_t k = 0; k < pair_count(all.size); ++k) {
        all.condensed.push_back(k < 101 ? 0.1 * static_cast<double>(k) : std::nan(""));
    }
    for (int percent = 0; percent <= 100; ++percent) {
        const double share = std::stod(std::to_string(percent) + "e-2");
        CHECK(confusable_pairs(all, threshold_at(all, share), 999).size() ==
              static_cast<std::size_t>(percent) + 1);
    }
}

}  // namespace separation_test
