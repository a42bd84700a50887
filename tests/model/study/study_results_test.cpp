#include "model/study/study_results.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

#include "model/io/people/ratings_file.h"
#include "model/io/people/study_csv.h"
#include "model/study/synthetic_study.h"
#include "tests/support/temporary_folder.h"

namespace study_results_test {

using namespace tact;

namespace {

const std::vector<double> kTruth{10, 30, 60, 25, 55, 40};  // of four patterns

StudyRecord simulated(const std::string& code, const SyntheticRaterParams& params,
                      std::uint64_t number) {
    StudyRecord record;
    record.header.synthetic = true;
    record.header.set_fingerprint = "f";
    record.header.patterns = {"a", "b", "c", "d"};
    record.header.design.attention_pairs = 3;
    record.header.participant.code = code;
    const SyntheticRater rater{params, {4, kTruth}, number};
    std::uint64_t serial = 0;
    for (const Trial& trial : trial_list(plan_of(record.header.design, 4, number))) {
        record.answers.push_back(
            {trial, rating_of(rater, trial, serial), 1, 1, response_s_of(rater, serial), ""});
        ++serial;
    }
    return record;
}

std::vector<StudyRecord> crowd(std::size_t count, const SyntheticRaterParams& params) {
    std::vector<StudyRecord> records;
    for (std::size_t k = 1; k <= count; ++k) {
        records.push_back(simulated("P" + std::to_string(k), params, k));
    }
    return records;
}

StudyResults results_of(const std::vector<StudyRecord>& records, const CollectRule& rule = {}) {
    auto results = study_results(records, rule);
    REQUIRE_MESSAGE(results, (results ? "" : results.error().message));
    return *std::move(results);
}

}  // namespace

TEST_CASE("study results: raters without noise give back the matrix they were made from") {
    const StudyResults results = results_of(crowd(3, {0.0, 0.0, 0.0, 0.0, 1}));
    for (std::size_t p = 0; p < kTruth.size(); ++p) {
        CHECK(std::abs(results.mean.condensed[p] - 100.0 * kTruth[p] / 60.0) <= 0.5);
    }
    CHECK(results.agreement.spearman_brown == 1.0);
    CHECK(results.study.judgements.size() == 3 * 4);  // a pass each
    CHECK(results.mark.synthetic);
    for (const ParticipantSummary& person : results.people) {
        CHECK(person.rho_with_others == 1.0);
        CHECK_FALSE(person.is_outlier);
    }
}

TEST_CASE("study results: noise averages out, and bias of the scale keeps the order") {
    const StudyResults results = results_of(crowd(40, {15.0, 0.0, 8.0, 0.0, 3}));
    const StudyResults quiet = results_of(crowd(40, {0.0, 0.0, 0.0, 0.0, 3}));
    // Clamping to 0..100 pulls the ends in.
    for (std::size_t p = 0; p < kTruth.size(); ++p) {
        CHECK(std::abs(results.mean.condensed[p] - quiet.mean.condensed[p]) <= 9.0);
    }
    CHECK(results.agreement.one_with_others > 0.8);
}

TEST_CASE("study results: who misses identical pairs, or stops, is left out with the reason") {
    std::vector<StudyRecord> records = crowd(4, {5.0, 0.0, 0.0, 0.0, 1});
    for (PairAnswer& answer : records[1].answers) {
        if (answer.trial.is_attention()) answer.similarity = 80.0;  // not above
    }
    records[2].answers.resize(10);
    const StudyResults results = results_of(records);
    CHECK(results.people[1].excluded == "identical patterns rated 80, 80, 80, expected above 80");
    CHECK(results.people[2].excluded == "unfinished, 10 of 27 trials");
    CHECK(results.people[3].excluded.empty());
    CHECK(results.remarks.size() == 2);
    CHECK(results.agreement.voices == 2);
    CollectRule lenient;
    lenient.attention.failures_allowed = 3;
    lenient.unfinished_too = true;
    CHECK(results_of(records, lenient).agreement.voices == 4);
    lenient.attention = {79.0, 0};
    CHECK(results_of(records, lenient).agreement.voices == 4);
}

TEST_CASE("study results: who answers blindly is an outlier") {
    std::vector<StudyRecord> records = crowd(9, {5.0, 0.0, 3.0, 0.0, 1});
    StudyRecord blind = simulated("X", {5.0, 0.0, 0.0, 1.0, 1}, 2);
    for (PairAnswer& answer : blind.answers) {
        if (answer.trial.is_attention()) answer.similarity = 100.0;
    }
    records.push_back(blind);
    const StudyResults results = results_of(records);
    CHECK(results.people.back().code == "X");
    CHECK(results.people.back().is_outlier);
    CHECK(results.people.back().excluded.empty());
    CHECK(std::ranges::count(results.people, true, &ParticipantSummary::is_outlier) == 1);
}

TEST_CASE("study results: an outlier is below Q1 - 1.5 IQR of how all agree, and nobody else is") {
    std::size_t between = 0;  // the fences of 1.5 and 3 IQR
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        std::vector<StudyRecord> records;
        for (std::size_t k = 1; k <= 9; ++k) {
            const double noise = k == 9 ? 25.0 : 8.0;
            records.push_back(simulated("P" + std::to_string(k), {noise, 0.0, 0.0, 0.0, seed}, k));
        }
        CollectRule rule;
        rule.attention.failures_allowed = 100;
        const StudyResults results = results_of(records, rule);
        std::vector<double> rho;
        for (const ParticipantSummary& one : results.people) rho.push_back(one.rho_with_others);
        std::ranges::sort(rho);
        REQUIRE(rho.size() == 9);
        const double width = rho[6] - rho[2];  // quartiles of nine are the third and the seventh
        for (const ParticipantSummary& one : results.people) {
            CHECK(one.is_outlier == (one.rho_with_others < rho[2] - 1.5 * width));
            between += one.is_outlier && one.rho_with_others >= rho[2] - 3.0 * width ? 1 : 0;
        }
    }
    CHECK(between > 0);
}

TEST_CASE("study results: a rehearsal never counts, nor what was answered without a device") {
    std::vector<StudyRecord> records = crowd(4, {5.0, 0.0, 0.0, 0.0, 1});
    records[0].header.device.name = kNoDevice;
    records[1].header.device.name = "pad";
    records[1].devices = {{20, {kNoDevice, "", {}}, ""}};
    const StudyResults results = results_of(records);
    CHECK(results.people[0].rehearsal);
    CHECK(results.people[0].excluded == kNothingFelt);
    CHECK(results.people[1].excluded.empty());
    CHECK(results.people[1].unfelt == 7);
    CHECK(results.agreement.voices == 3);
    CHECK(contains(results.remarks.back(), "P2: 7 of 27 answers are left out"));
    // All that was answered before the device went is there, and nothing of after.
    std::size_t rated = 0;
    for (const Judgement& one : judgements_of(records[1], RatingScaling::none)) {
        rated += static_cast<std::size_t>(
            std::ranges::count_if(one.condensed, [](double value) { return !std::isnan(value); }));
    }
    std::size_t felt = 0;
    for (std::size_t k = 0; k < 20; ++k) felt += records[1].answers[k].trial.is_attention() ? 0 : 1;
    CHECK(rated == felt);
    CollectRule rule;
    rule.who.include = {"P1"};
    CHECK(contains(study_results(records, rule).error().message, kNothingFelt));
    rule.who = {{}, {"P3"}};
    CHECK(results_of(records, rule).people[2].excluded == "excluded by name");
}

TEST_CASE("study results: scaling takes a person's use of the scale out of the mean") {
    StudyRecord wide = simulated("wide", {0.0, 0.0, 0.0, 0.0, 1}, 1);
    StudyRecord narrow = wide;
    narrow.header.participant.code = "narrow";
    for (PairAnswer& answer : narrow.answers) answer.similarity = 80.0 + 0.2 * answer.similarity;
    for (const RatingScaling scaling : {RatingScaling::min_max, RatingScaling::standard}) {
        CollectRule rule;
        rule.scaling = scaling;
        const auto one = mean_ratings({{"a", "b", "c", "d"}, true, judgements_of(wide, scaling)});
        const auto two = mean_ratings({{"a", "b", "c", "d"}, true, judgements_of(narrow, scaling)});
        for (std::size_t p = 0; p < kTruth.size(); ++p) {
            CHECK(std::abs(one.condensed[p] - two.condensed[p]) <= 1e-9);
        }
        for (PairAnswer& answer : wide.answers) {
            if (scaling == RatingScaling::standard) answer.similarity = 7.0;
        }
    }
    // Always the same: all in the middle, not NaN.
    CHECK(judgements_of(wide, RatingScaling::standard)[0].condensed ==
          std::vector<double>(6, 50.0));
}

TEST_CASE("study results: T-scores of a person have mean 50 and a population deviation of 10") {
    const StudyRecord record = simulated("P1", {}, 3);
    const SimilarityScale scale = scale_of(record, RatingScaling::standard);
    std::vector<double> scores;
    for (const PairAnswer& answer : record.answers) {
        if (answer.trial.is_attention()) continue;
        scores.push_back(scale.factor * answer.similarity + scale.shift);
    }
    REQUIRE(scores.size() > 6);
    const auto count = static_cast<double>(scores.size());
    const double mean = std::accumulate(scores.begin(), scores.end(), 0.0) / count;
    double squares = 0.0;
    for (const double score : scores) squares += (score - mean) * (score - mean);
    CHECK(std::abs(mean - 50.0) <= 1e-9);
    CHECK(std::abs(std::sqrt(squares / count) - 10.0) <= 1e-9);
}

TEST_CASE("study results: other patterns, or one code twice, are refused") {
    std::vector<StudyRecord> records = crowd(2, {});
    records[1].header.set_fingerprint = "g";
    CHECK(contains(study_results(records, {}).error().message,
                   "participant \"P2\": felt other patterns"));
    records[1] = records[0];
    CHECK(contains(study_results(records, {}).error().message, "\"P1\" is there twice"));
    records[1].header.participant.code = "P2";
    records[1].header.design.order = StudyOrder::adaptive;
    CHECK(contains(study_results(records, {}).error().message, "order of trials"));
    CHECK_FALSE(study_results({}, {}));
}

TEST_CASE(
    "study results: who was asked by a changed design is left out, and what changed is said") {
    std::vector<StudyRecord> records = crowd(3, {});
    for (StudyRecord& record : records) record.header.synthetic = false;
    for (StudyRecord& record : records) {
        record.header.begun = "2026-01-0" + record.header.participant.code.substr(1);
    }
    const auto remarks = [](const StudyResults& results) {
        std::string text;
        for (const std::string& remark : results.remarks) text += remark + "\n";
        return text;
    };
    CHECK(results_of(records).remarks.empty());
    records[0].header.begun = "2026-01-09";  // began last, though first in the folder
    records[0].header.design.gap_s = 0.25;
    const StudyResults results = results_of(records);
    CHECK(contains(remarks(results),
                   "P1 is not counted: another study than P2's: gap 0.25 s, not 1 s"));
    CHECK(results.mean == results_of({records[1], records[2]}).mean);
    CollectRule rule;
    rule.who.include = {"P1"};
    CHECK(results_of(records, rule).remarks.empty());
}

TEST_CASE("study results: the CSV reads back as the same ratings") {
    std::vector<StudyRecord> records = crowd(3, {});
    records[1].answers.resize(3);
    const StudyResults results = results_of(records);
    std::ostringstream csv;
    write_study_csv(csv, records, results, StudyRows::counted);
    CHECK(csv.str().starts_with("participant,trial,a,b,side,rating,replays,response_s,attention,"));
    const auto loaded = parse_ratings(csv.str(), "r.csv", RatingScale::guess);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    CHECK(loaded->remarks.empty());  // nothing to guess
    const auto study = matched(loaded->study, {"a", "b", "c", "d"});
    REQUIRE(study);
    CHECK(mean_ratings(*study) == results.mean);
    CHECK(study->judgements == results.study.judgements);
    std::ostringstream all;
    write_study_csv(all, records, results, StudyRows::everyone);
    CHECK(contains(all.str(), "\nP2,1,"));
    CHECK_FALSE(contains(csv.str(), "\nP2,"));
}

TEST_CASE("study results: compare takes from the CSV whom the study counts, scaled as it is") {
    std::vector<StudyRecord> records = crowd(5, {5.0, 0.0, 3.0, 0.0, 1});
    for (PairAnswer& answer : records[1].answers) {
        if (answer.trial.is_attention()) answer.similarity = 5.0;
    }
    records[2].header.device.name = kNoDevice;
    records[3].devices = {{20, {kNoDevice, "", {}}, ""}};
    for (const RatingScaling scaling :
         {RatingScaling::none, RatingScaling::min_max, RatingScaling::standard}) {
        CollectRule rule;
        rule.scaling = scaling;
        for (const std::size_t more : {0U, 1U}) {
            const std::vector<std::string> include(more, "P2");
            rule.who.include = include;
            const StudyResults results = results_of(records, rule);
            std::ostringstream csv;
            write_study_csv(csv, records, results, StudyRows::everyone);
            const auto loaded = parse_ratings(csv.str(), "r.csv", RatingScale::guess);
            REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
            CHECK(loaded->left_out.size() == 2 - include.size());
            CHECK(loaded->study.fingerprint == "f");
            CHECK(is_partly_synthetic(loaded->study));
            const auto study = matched(loaded->study, {"a", "b", "c", "d"});
            REQUIRE(study);
            const Dissimilarity mean = mean_ratings(*study);
            for (std::size_t p = 0; p < mean.condensed.size(); ++p) {
                CHECK(std::abs(mean.condensed[p] - results.mean.condensed[p]) <= 1e-9);
            }
        }
    }
    // Asked for by name from a file that leaves them out.
    std::ostringstream csv;
    write_study_csv(csv, records, results_of(records), StudyRows::everyone);
    const auto with = parse_ratings(csv.str(), "r.csv", RatingScale::guess, {{"P2"}, {}});
    REQUIRE(with);
    CHECK(participant_means(with->study).size() == 4);
    CHECK_FALSE(parse_ratings(csv.str(), "r.csv", RatingScale::guess, {{"P3"}, {}}));
}

TEST_CASE("study results: sortings of several people become a matrix") {
    StudyRecord first;
    first.header.kind = StudyKind::sorting;
    first.header.patterns = {"a", "b", "c", "d", "e"};
    first.header.design.groups = {2, 3, 4};
    first.header.participant.code = "P1";
    first.sortings = {{2, {0, 0, 1, 1, 1}, 30.0, ""},
                      {3, {0, 0, 1, 2, 2}, 30.0, ""},
                      {4, {0, 1, 2, 3, 3}, 30.0, ""}};
    StudyRecord second = first;
    second.header.participant.code = "P2";
    second.sortings = {{2, {0, 0, 0, 1, 1}, 30.0, ""},
                       {3, {0, 1, 1, 2, 2}, 30.0, ""},
                       {4, {0, 1, 1, 2, 3}, 30.0, ""}};
    const StudyResults results = results_of({first, second});
    CHECK(results.mean(0, 1) == doctest::Approx(61.1111111).epsilon(1e-8));
    CHECK(results.mean(3, 4) == doctest::Approx(22.2222222).epsilon(1e-8));
    CHECK(results.people[0].minutes == doctest::Approx(1.5));
    std::ostringstream csv;
    const std::vector<StudyRecord> records{first, second};
    write_study_csv(csv, records, results, StudyRows::everyone);
    const auto loaded = parse_ratings(csv.str(), "s.csv", RatingScale::guess);
    REQUIRE_MESSAGE(loaded, (loaded ? "" : loaded.error().message));
    CHECK(loaded->study.judgements == results.study.judgements);
}

}  // namespace study_results_test
