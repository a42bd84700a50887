#include "model/told_apart/told_apart_results.h"

#include <doctest/doctest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "model/text/csv.h"
#include "model/text/numbers.h"
#include "model/told_apart/odd_trials.h"
#include "model/told_apart/told_apart_document.h"
#include "tests/model/told_apart/trial_pairs.h"
#include "tests/support/temporary_folder.h"

namespace told_apart_results_test {

using namespace tact;

namespace {

// An answer to a pair of this PM.
OddAnswer answer(double pm, bool is_right) {
    return {{"a" + std::to_string(std::lround(pm)), "b", pm, 1, false}, is_right ? 1 : 2, 1.5};
}

// Right and wrong answers at each PM.
ToldApart told(const std::vector<std::tuple<double, int, int>>& counts) {
    ToldApart told;
    told.device = "phone Kim (web vibration)";
    told.person = "Kim";
    told.date = "2026-11-28T21:12:53Z";
    for (const auto& [pm, right, wrong] : counts) {
        for (int k = 0; k < right; ++k) told.answers.push_back(answer(pm, true));
        for (int k = 0; k < wrong; ++k) told.answers.push_back(answer(pm, false));
    }
    return told;
}

std::string threshold_said(const std::vector<std::tuple<double, int, int>>& counts) {
    return threshold_words(results_of(told(counts)));
}

}  // namespace

TEST_CASE("told apart: a threshold between what was asked is given with its interval") {
    const ToldApartResults results =
        results_of(told({{4, 3, 5}, {10, 3, 1}, {20, 4, 0}, {40, 4, 0}}));
    CHECK(results.said == ThresholdSaid::found);
    CHECK(results.trials == 20);
    CHECK(results.right == 14);
    CHECK(threshold_words(results) ==
          "Pairs beyond PM 10 (4.6 to 26) were told apart in at least 75 % of trials.");
    CHECK(pm_digits(results.threshold_pm) == "10");
    CHECK(pm_digits(results.threshold.high) == "26");
    CHECK(results.threshold.low < results.threshold_pm);
    CHECK(results.threshold_pm < results.threshold.high);
    CHECK(share_words(results) ==
          "14 of 20 trials were right: 70 % (48 to 85 %). A guess is right in a third of trials.");
}

TEST_CASE("told apart: what the data do not say is not said") {
    CHECK(threshold_said({{4, 3, 0}, {12, 3, 0}}) ==
          "Too few trials to say from which PM pairs are told apart: 6 of at least 10.");
    CHECK(threshold_said({}) ==
          "Too few trials to say from which PM pairs are told apart: 0 of at least 10.");
    const std::string all = threshold_said({{4, 20, 0}});
    CHECK(all ==
          "All 20 trials were right. The PM from which pairs are told apart in 75 % of "
          "trials is below 4, the smallest that was asked.");
    CHECK(threshold_said({{4, 5, 0}, {20, 5, 0}}) ==
          "All 10 trials were right. The PM from which pairs are told apart in 75 % of trials is "
          "most likely below 4, the smallest that was asked, and below 4.5 with 95 % certainty.");
    CHECK(threshold_said({{4, 1, 4}, {8, 4, 3}, {12, 5, 3}}) ==
          "10 of 20 trials right: guesses may be right as often. The PM from which pairs are told "
          "apart in 75 % of trials is most likely above 12, the largest that was asked, and above "
          "9.6 with 95 % certainty.");
    const std::string none = threshold_said({{4, 0, 10}, {40, 0, 10}});
    CHECK(none ==
          "None of 20 trials was right. The PM from which pairs are told apart in 75 % of "
          "trials is above 40, the largest that was asked.");
    const std::string guesses = threshold_said({{20, 4, 6}, {40, 4, 6}});
    CHECK(contains(guesses, "8 of 20 trials right: guesses may be right as often."));
    CHECK(contains(guesses, "above 40, the largest that was asked"));
    const std::string unclear = threshold_said({{10, 4, 2}, {11, 4, 2}});
    CHECK(unclear ==
          "These trials do not say from which PM pairs are told apart: it may be below 10, the "
          "smallest that was asked, or above 11, the largest.");
    CHECK(
        contains(threshold_said({{4, 8, 2}}), "below 4 or above it, the only one that was asked."));
    // An end beyond what was asked is said to be beyond.
    CHECK(contains(threshold_said({{4, 4, 4}, {8, 4, 4}, {12, 4, 0}}), "(6 to above 12)"));
}

TEST_CASE("told apart: the predicted share rises with PM, and says where nothing was asked") {
    const ToldApartResults results = results_of(told({{4, 2, 4}, {12, 5, 3}, {40, 6, 0}}));
    double last = kOddGuess;
    for (const double pm : {1.0, 4.0, 9.0, 12.0, 30.0, 80.0}) {
        const PredictedShare share = predicted_share(results.posterior, pm);
        CHECK(share.share > last);
        CHECK(share.interval.low <= share.share);
        CHECK(share.share <= share.interval.high);
        last = share.share;
    }
    const auto percent_at = [&](double pm) {
        return percent(predicted_share(results.posterior, pm).share);
    };
    CHECK(words_at(results, 9.0) ==
          "pairs at PM 9 were told apart in about " + percent_at(9.0) + " of trials");
    CHECK(words_at(results, 2.5) ==
          "pairs at PM 2.5, less than any that was asked, may be told "
          "apart in about " +
              percent_at(2.5) + " of trials");
    CHECK(words_at(results, 1200.0) ==
          "pairs at PM 1,200, more than any that was asked, may be "
          "told apart in about " +
              percent_at(1200.0) + " of trials");
}

TEST_CASE("told apart: numbers of PM are written as people do") {
    CHECK(pm_digits(9.949) == "9.9");
    CHECK(pm_digits(9.96) == "10");
    CHECK(pm_digits(0.451) == "0.45");
    CHECK(pm_digits(1234.5) == "1,235");
    CHECK(pm_digits(1e16) == "1e+16");
}

TEST_CASE("told apart: each pair has its row, by rising PM, and the rows are all trials") {
    const ToldApart course = synthetic_trials({10.0, 3.0, 8}, twelve_pairs(40, 5));
    const ToldApartResults results = results_of(course);
    std::size_t trials = 0;
    std::size_t right = 0;
    for (std::size_t k = 0; k < results.pairs.size(); ++k) {
        const ToldApartPair& pair = results.pairs[k];
        trials += pair.trials;
        right += pair.right;
        CHECK(pair.right <= pair.trials);
        if (k > 0) CHECK(results.pairs[k - 1].pm <= pair.pm);
    }
    CHECK(trials == 40);
    CHECK(right == results.right);
    CHECK(asked_words(course, results) == "simulated, 40 trials");
    // In another order the answers say the same, but for the last bits of a product.
    ToldApart turned = course;
    std::ranges::reverse(turned.answers);
    CHECK(results_of(turned).threshold_pm == doctest::Approx(results.threshold_pm).epsilon(1e-12));
}

TEST_CASE("told apart: answers that cannot be placed are left out, and nothing is NaN") {
    ToldApart silly = told({{4, 6, 4}, {9, 5, 1}});
    silly.answers.push_back(answer(0.0, true));
    silly.answers.push_back({{"a", "b", std::nan(""), 0, false}, 0, 0.0});
    silly.answers.push_back({{"a", "b", INFINITY, 0, false}, 0, 0.0});
    const ToldApartResults results = results_of(silly);
    CHECK(results.trials == 16);
    const ToldApartResults none = results_of({});
    CHECK(none.trials == 0);
    CHECK(none.interval.low == 0.0);
    CHECK(none.interval.high == 1.0);
    CHECK(std::isfinite(none.threshold_pm));
    CHECK(share_words(none) == "No trial was answered.");
}

TEST_CASE("told apart: a document says that one person was measured, on one device") {
    const ToldApart course = told({{4, 2, 4}, {12, 5, 3}, {40, 6, 0}});
    const nlohmann::ordered_json document = told_apart_document(course, results_of(course));
    CHECK(document["measured_on"] == "one person, on one device");
    CHECK(document["device"] == "phone Kim (web vibration)");
    CHECK(document["trials"] == 20);
    CHECK(document["share_right"] == 0.65);
    CHECK(document["threshold"]["said"] == "found");
    CHECK(document["threshold"]["pm"] == results_of(course).threshold_pm);
    CHECK(document["pairs"].size() == 3);
    CHECK(document["pairs"][1]["share_right"] == 5.0 / 8.0);
    CHECK(document["words"].size() == 2);
    const auto few = told_apart_document({}, results_of({}));
    CHECK(few["threshold"]["said"] == "too few trials");
    CHECK_FALSE(few["threshold"].contains("pm"));
    CHECK_FALSE(few.contains("share_right"));
}

TEST_CASE("told apart: a table has a row an answer, whatever the names are") {
    ToldApart course = told({{4, 1, 1}});
    course.person = "=Kim, \"K\"";
    course.answers[0].trial.odd_is_b = true;
    const std::string text = told_apart_csv(course);
    CHECK(contains(text, "'=Kim"));  // no formula in a spreadsheet
    CsvReader reader{text};
    const CsvRecord head = next_record(reader);
    CHECK(head.fields.size() == 14);
    const CsvRecord first = next_record(reader);
    REQUIRE(first.fields.size() == 14);
    CHECK(first.fields == std::vector<std::string>{"one person, on one device", "0",
                                                   "phone Kim (web vibration)", "=Kim, \"K\"",
                                                   "2026-11-28T21:12:53Z", "1", "a4", "b", "4", "2",
                                                   "b", "2", "1", "1.5"});
    const CsvRecord second = next_record(reader);
    CHECK(second.fields[10] == "a4");
    CHECK(second.fields[11] == "3");
    CHECK(second.fields[12] == "0");
    CHECK(next_record(reader).line == 0);
}

TEST_CASE("told apart: a renamed pattern keeps its answers, a removed one takes its own along") {
    ToldApart course = told({{4, 1, 1}, {12, 1, 0}});
    course.patterns = {"a4", "b", "a12"};
    course.versions = {"1", "2", "3"};
    rename_in(course, "b", "c");
    CHECK(course.answers[2].trial.b == "c");
    CHECK(course.patterns == std::vector<std::string>{"a4", "c", "a12"});
    const ToldApart part = among(course, {"c", "a4"});
    CHECK(part.answers.size() == 2);
    CHECK(part.patterns == std::vector<std::string>{"a4", "c"});
    CHECK(part.versions == std::vector<std::string>{"1", "2"});
    CHECK(among(course, {"a4", "c", "a12"}) == course);
}

}  // namespace told_apart_results_test
