#include "model/told_apart/threshold_posterior.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "model/told_apart/told_apart_results.h"
#include "tests/support/golden.h"

namespace threshold_posterior_test {

using namespace tact;

namespace {

std::vector<AskedPm> answers_in(const golden::Json& json) {
    std::vector<AskedPm> answers;
    for (const auto& one : json) answers.push_back({one[0], one[1]});
    return answers;
}

Range range_in(const golden::Json& json) { return {json[0], json[1]}; }

}  // namespace

TEST_CASE("threshold: posterior, predictions and information are those of NumPy") {
    for (const golden::Json& one : golden::read("told_apart.json", "cases")) {
        const std::vector<AskedPm> answers = answers_in(one.at("answers"));
        CAPTURE(answers.size());
        const ThresholdPosterior posterior =
            threshold_posterior(range_in(one.at("range_pm")), answers);
        std::vector<double> thresholds;
        for (const double probability : one.at("probability")) {
            thresholds.push_back(threshold_below(posterior, probability));
        }
        CHECK(golden::worst_difference(thresholds, one.at("threshold_pm")) < 1e-12);
        for (std::size_t k = 0; k < one.at("pm").size(); ++k) {
            const PredictedShare share = predicted_share(posterior, one.at("pm")[k]);
            CHECK(golden::worst_difference({share.share, share.interval.low, share.interval.high},
                                           one.at("predicted")[k]) < 1e-12);
            const double nats = expected_information(posterior, one.at("pm")[k]);
            // Differences of entropies, which are up to 0.7.
            CHECK(std::abs(nats - one.at("information")[k].get<double>()) < 1e-14);
        }
    }
}

TEST_CASE("threshold: a grid of 61 is as good as one of 4,801") {
    // Half a step of the grid, 8 % of a PM at most here: where nearly all of the probability is in
    // one step, as of steep slopes, its evenness is what moves a quantile. An interval of 40
    // answers is ten times as wide.
    for (const golden::Json& one : golden::read("told_apart.json", "cases")) {
        const ThresholdPosterior posterior =
            threshold_posterior(range_in(one.at("range_pm")), answers_in(one.at("answers")));
        for (std::size_t k = 0; k < one.at("probability").size(); ++k) {
            const double own = threshold_below(posterior, one.at("probability")[k]);
            const double fine = one.at("fine_threshold_pm")[k];
            CHECK(std::abs(std::log(own / fine)) < 0.5 * posterior.step);
        }
    }
}

TEST_CASE(
    "threshold: three quarters are right at it, a third far below, all but lapses far above") {
    for (const double slope : {1.0, 3.0, 16.0}) {
        CHECK(share_right(12.0, 12.0, slope) == doctest::Approx(0.75).epsilon(1e-14));
        CHECK(share_right(1e-30, 12.0, slope) == doctest::Approx(1.0 / 3.0).epsilon(1e-14));
        CHECK(share_right(1e30, 12.0, slope) == doctest::Approx(0.98).epsilon(1e-14));
    }
    CHECK(share_right(5.0, INFINITY, 3.0) == kOddGuess);
    CHECK(share_right(0.0, 12.0, 3.0) == kOddGuess);
    // From a tenth to nine tenths of the way: the factors that the header states.
    for (const auto& [slope, factor] : {std::pair{1.0, 81.0}, std::pair{16.0, 1.316}}) {
        const double log_odds = std::log(9.0);
        CHECK(std::exp(2.0 * log_odds / slope) == doctest::Approx(factor).epsilon(1e-3));
    }
}

TEST_CASE("threshold: PM times a factor is a threshold times that factor") {
    const std::vector<AskedPm> answers{{3, false}, {8, true}, {8, false}, {20, true}, {40, true}};
    std::vector<AskedPm> scaled = answers;
    for (AskedPm& answer : scaled) answer.pm *= 7.0;
    const ThresholdPosterior one = threshold_posterior({3, 40}, answers);
    const ThresholdPosterior other = threshold_posterior({21, 280}, scaled);
    for (const double probability : {0.025, 0.5, 0.975}) {
        CHECK(threshold_below(other, probability) ==
              doctest::Approx(7.0 * threshold_below(one, probability)).epsilon(1e-10));
    }
    CHECK(expected_information(other, 70.0) ==
          doctest::Approx(expected_information(one, 10.0)).epsilon(1e-10));
}

TEST_CASE("threshold: a right answer lowers it, a wrong one raises it, wherever it is asked") {
    const std::vector<AskedPm> before{{5, false}, {15, true}, {10, true}};
    const double now = threshold_below(threshold_posterior({2, 50}, before), 0.5);
    for (const double pm : {2.0, 5.0, 12.0, 50.0}) {
        for (const bool is_right : {true, false}) {
            std::vector<AskedPm> after = before;
            after.push_back({pm, is_right});
            const double then = threshold_below(threshold_posterior({2, 50}, after), 0.5);
            CHECK((then < now) == is_right);
        }
    }
}

TEST_CASE("threshold: silly numbers give no NaN") {
    const std::vector<AskedPm> answers{
        {0, true}, {-3, false}, {std::nan(""), true}, {INFINITY, 1}, {5, true}};
    const ThresholdPosterior posterior = threshold_posterior({5, 5}, answers);
    CHECK(std::accumulate(posterior.weight.begin(), posterior.weight.end(), 0.0) ==
          doctest::Approx(1.0).epsilon(1e-12));
    CHECK(std::isfinite(threshold_below(posterior, 0.5)));
    CHECK(predicted_share(posterior, 0.0).share == kOddGuess);
    CHECK(expected_information(posterior, std::nan("")) == 0.0);
    CHECK(range_of_pm(std::vector<double>{0.0, -1.0, std::nan("")}) == Range{1.0, 1.0});
    // The far ends of what a file may hold, and far more answers than a set keeps.
    const std::vector<AskedPm> many(5000, AskedPm{1e12, false});
    const ThresholdPosterior wide = threshold_posterior({1e-300, 1e12}, many);
    CHECK(std::isfinite(threshold_below(wide, 0.5)));
    CHECK(std::isfinite(predicted_share(wide, 1.0).share));
    CHECK(std::isfinite(expected_information(wide, 1.0)));
}

TEST_CASE("threshold: the interval of a share is Wilson's, by another way of computing it") {
    for (const golden::Json& one : golden::read("told_apart.json", "cases")) {
        std::size_t right = 0;
        for (const AskedPm& answer : answers_in(one.at("answers"))) right += answer.is_right;
        const Interval interval = wilson_interval(right, one.at("answers").size());
        // A root found to 1e-15 of a function that is flat at 0 and 1.
        CHECK(std::abs(interval.low - one.at("wilson")[0].get<double>()) < 1e-9);
        CHECK(std::abs(interval.high - one.at("wilson")[1].get<double>()) < 1e-9);
    }
}

}  // namespace threshold_posterior_test
