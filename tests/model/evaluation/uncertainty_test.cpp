#include "model/evaluation/uncertainty.h"

#include <cmath>
#include <map>

#include "model/common/random.h"
#include "model/evaluation/individuals.h"
#include "model/map/smacof.h"
#include "tests/support/golden.h"

namespace uncertainty_test {

using namespace tact;
using Eigen::MatrixXd;

namespace {

EvaluationParams quick() {
    EvaluationParams params;
    params.rho_orders = params.k_orders = 1;
    params.bootstrap_draws = 2;
    params.spread_starts = 0;
    params.chance_draws = params.stress_draws = 1;
    return params;
}

struct Compared {
    RatingStudy study;
    RatedSet rated;
    std::vector<Dissimilarity> metrics;
    std::vector<Evaluation> evaluations;
};

Compared compared(const RatingStudy& study, const std::vector<Dissimilarity>& metrics) {
    auto rated = rated_set(mean_ratings(study), quick());
    REQUIRE(rated);
    Compared result{study, *rated, metrics, {}};
    for (const Dissimilarity& metric : metrics) {
        result.evaluations.push_back(evaluate(metric, *rated, quick()));
    }
    return result;
}

// The same without a search for maps: they lie where the truth and the metrics have the patterns.
Compared with_maps(const RatingStudy& study, const std::vector<Dissimilarity>& metrics,
                   const MatrixXd& people, const std::vector<MatrixXd>& maps) {
    Compared result{study, {}, metrics, {}};
    result.rated.people.dissimilarity = mean_ratings(study);
    result.rated.people.maps = {people};
    for (std::size_t m = 0; m < metrics.size(); ++m) {
        Evaluation one;
        one.rho = spearman(metrics[m].condensed, result.rated.people.dissimilarity.condensed);
        one.map = maps[m];
        one.k = *alienation(people, maps[m]);
        result.evaluations.push_back(one);
    }
    return result;
}

Uncertainty uncertainty_of(const Compared& all, const UncertaintyParams& params = {}) {
    return uncertainty(all.study, all.rated, all.metrics, all.evaluations, 0, params);
}

RatingStudy study_of_people(std::size_t size, const std::vector<std::vector<double>>& said) {
    RatingStudy study;
    for (std::size_t k = 0; k < size; ++k) study.labels.push_back("p" + std::to_string(k));
    for (std::size_t v = 0; v < said.size(); ++v) {
        study.judgements.push_back({"P" + std::to_string(v), said[v]});
    }
    return study;
}

Compared golden_people(const golden::Json& table) {
    const std::size_t size = table.at("size");
    std::vector<Dissimilarity> metrics;
    for (const auto& one : table.at("metrics")) {
        metrics.push_back({size, one.get<std::vector<double>>()});
    }
    return compared(study_of_people(size, table.at("said").get<std::vector<std::vector<double>>>()),
                    metrics);
}

void check_spread(const Spread& got, const golden::Json& expected) {
    CHECK(std::abs(got.mean - expected.at("mean").get<double>()) <= 1e-14);
    CHECK(std::abs(got.median - expected.at("median").get<double>()) <= 1e-14);
    CHECK(std::abs(got.low - expected.at("low").get<double>()) <= 1e-14);
    CHECK(std::abs(got.high - expected.at("high").get<double>()) <= 1e-14);
}

// Standard errors of draws: two programs draw other ones, with an error of 1 / sqrt(2 draws) each.
void check_errors(const Uncertainty& got, const golden::Json& expected, Resampled by,
                  double tolerance) {
    const auto r = static_cast<std::size_t>(by);
    const auto near = [tolerance](double value, double oracle) {
        CHECK_MESSAGE(std::abs(value / oracle - 1.0) <= tolerance, value << " for " << oracle);
    };
    for (std::size_t m = 0; m < 3; ++m) {
        near(got.rho[m].error[r], expected.at("rho").at(m).get<double>());
    }
    for (std::size_t m = 0; m < 2; ++m) {
        near(got.differences[m].rho.error[r], expected.at("difference").at(m).get<double>());
    }
}

// A world in which patterns lie somewhere, metrics see them blurred, and people tell distances
// with noise of their own.
struct World {
    Eigen::Index patterns = 12;
    std::size_t people = 8;
    double people_noise = 1.0;
    std::vector<double> blur{0.4, 0.8};

    MatrixXd points(RandomStream& random) const {
        MatrixXd result(patterns, 3);
        for (Eigen::Index e = 0; e < result.size(); ++e) result.data()[e] = next_normal(random);
        return result;
    }
    std::vector<MatrixXd> maps(RandomStream& random, const MatrixXd& truth) const {
        std::vector<MatrixXd> all;
        for (const double one : blur) all.push_back(truth + one * points(random));
        return all;
    }
    std::vector<Dissimilarity> metrics(RandomStream& random, const MatrixXd& truth) const {
        return apart(maps(random, truth));
    }
    static std::vector<Dissimilarity> apart(const std::vector<MatrixXd>& maps) {
        std::vector<Dissimilarity> all;
        for (const MatrixXd& map : maps) {
            all.push_back({static_cast<std::size_t>(map.rows()), distances(map)});
        }
        return all;
    }
    std::vector<std::vector<double>> said(RandomStream& random, const MatrixXd& truth) const {
        std::vector<std::vector<double>> all(people, distances(truth));
        for (auto& person : all) {
            for (double& value : person) value += people_noise * next_normal(random);
        }
        return all;
    }
    Dissimilarity mean(RandomStream& random, const MatrixXd& truth) const {
        return mean_ratings(
            study_of_people(static_cast<std::size_t>(patterns), said(random, truth)));
    }
};

struct Hits {
    int rho = 0;
    int difference = 0;
    int k = 0;
};

bool holds(const Interval& interval, double value) {
    return interval.low <= value && value <= interval.high;
}

constexpr int kStudies = 200;
constexpr int kEnough = 186;  // 93 %

}  // namespace

TEST_CASE(
    "uncertainty: jackknife over people, and what single people reach, to the oracle's bits") {
    const golden::Json table = golden::read("metric_statistics.json", "people");
    const Compared all = golden_people(table);
    const Uncertainty got = uncertainty_of(all);
    check_errors(got, table.at("jackknife"), Resampled::people, 1e-10);
    const auto people = static_cast<std::size_t>(Resampled::people);
    const Uncertain& one = got.differences[1].rho;
    const double reach = table.at("t").get<double>() * one.error[people];
    // SciPy finds its quantile to ten digits.
    CHECK(std::abs(one.interval[people].high - (one.value + reach)) <= 1e-9);
    CHECK(one.value == all.evaluations[0].rho - all.evaluations[2].rho);
    const Ceilings bounds = ceilings(all.study, reliability(all.study));
    check_spread(bounds.with_others, table.at("with_others"));
    check_spread(bounds.with_all, table.at("with_all"));
    CHECK(bounds.with_others.mean < bounds.with_all.mean);
    const Individuals single =
        individuals(all.study, all.rated, all.metrics, all.evaluations, quick());
    REQUIRE(single.people.size() == 6);
    check_spread(single.rho[1], table.at("rho_of_second"));
    CHECK(single.k[0].known > 0);
}

TEST_CASE("uncertainty: bootstrap over patterns, and over both, as another program draws") {
    const golden::Json table = golden::read("metric_statistics.json", "people");
    const Uncertainty got = uncertainty_of(golden_people(table), {.draws = 6000});
    // Four standard errors of the ratio of two such: 4 / sqrt(6000), and skewness.
    check_errors(got, table.at("patterns"), Resampled::patterns, 0.06);
    check_errors(got, table.at("both"), Resampled::both, 0.06);
    for (const MetricDifference& one : got.differences) {
        for (std::size_t r = 0; r < kResampledCount; ++r) CHECK(one.p[r] <= one.p_holm[r]);
    }
}

TEST_CASE("uncertainty: the same bits for any number of threads") {
    const Compared all = golden_people(golden::read("metric_statistics.json", "people"));
    const Uncertainty one = uncertainty_of(all, {.draws = 60, .map_draws = 20, .threads = 1});
    const Uncertainty three = uncertainty_of(all, {.draws = 60, .map_draws = 20, .threads = 3});
    for (std::size_t m = 0; m < 3; ++m) {
        for (std::size_t r = 0; r < kResampledCount; ++r) {
            CHECK(one.rho[m].error[r] == three.rho[m].error[r]);
            if (m == 1) continue;  // two patterns of its map lie on one spot
            CHECK(one.k[m].error[r] == three.k[m].error[r]);
            CHECK(one.k[m].error[r] > 0.0);
        }
    }
}

TEST_CASE("uncertainty: of one voice nothing is known over people, and of equal metrics no more") {
    const World world;
    RandomStream random{3};
    const MatrixXd truth = world.points(random);
    std::vector<Dissimilarity> metrics = world.metrics(random, truth);
    metrics[1] = metrics[0];
    const Compared all =
        compared(study_of_people(12, {world.said(random, truth).front()}), metrics);
    const Uncertainty got = uncertainty_of(all, {.draws = 50});
    CHECK(got.people == 0);
    CHECK(std::isnan(got.rho[0].error[1]));
    CHECK(std::isnan(got.rho[0].interval[2].low));
    CHECK(got.differences[0].rho.value == 0.0);
    // Equal ranks are no finding of equality: another sample may tell the two apart.
    CHECK(got.differences[0].rho.why[0] == NotKnown::alike);
    CHECK(std::isnan(got.differences[0].p[0]));
    CHECK(got.rho[0].why[1] == NotKnown::one_person);
    CHECK(std::isnan(got.differences[0].p_holm[2]));
    CHECK(individuals(all.study, all.rated, all.metrics, all.evaluations, quick()).people.empty());
}

TEST_CASE("uncertainty: an error that no resample shows is not known, and neither is a p") {
    const World world;
    RandomStream random{17};
    const MatrixXd truth = world.points(random);
    const auto said = world.said(random, truth).front();
    const Compared all =
        compared(study_of_people(12, std::vector(7, said)), world.metrics(random, truth));
    const Uncertainty got = uncertainty_of(all, {.draws = 50, .map_draws = 0});
    CHECK(got.people == 7);
    for (const Uncertain& rho : got.rho) {
        CHECK(rho.why[1] == NotKnown::still);
        CHECK(std::isnan(rho.error[1]));
        CHECK(std::isnan(rho.interval[1].low));
        CHECK(rho.why[0] == NotKnown::known);
        CHECK(rho.error[0] > 0.0);
    }
    REQUIRE(got.differences.size() == 1);
    CHECK(got.differences[0].rho.value != 0.0);
    CHECK(std::isnan(got.differences[0].p[1]));
    CHECK(std::isnan(got.differences[0].p_holm[1]));
    CHECK(got.differences[0].p[0] == got.differences[0].p_holm[0]);
    for (const NotKnown why : {NotKnown::no_value, NotKnown::one_person, NotKnown::still,
                               NotKnown::alike, NotKnown::undefined}) {
        CHECK(std::string(words(why)) != "");
    }
}

TEST_CASE("uncertainty: a metric that most draws leave undefined has no error over patterns") {
    const World world;
    RandomStream random{19};
    MatrixXd truth = world.points(random).topRows(8);
    World eight = world;
    eight.patterns = 8;
    // One pair differs: with both its patterns come 41 of 100 draws.
    Dissimilarity one_pair{8, std::vector<double>(28, 1.0)};
    one_pair.condensed[5] = 2.0;
    const Compared all = compared(study_of_people(8, eight.said(random, truth)), {one_pair});
    const Uncertainty got = uncertainty_of(all, {.draws = 400, .map_draws = 0});
    CHECK_FALSE(std::isnan(got.rho[0].value));
    CHECK(got.rho[0].why[0] == NotKnown::undefined);
    CHECK(std::isnan(got.rho[0].error[0]));
}

// All ordered draws, one by one, of which the program counts multisets.
TEST_CASE("uncertainty: few patterns are drawn in all ways, each as often as it comes") {
    const std::size_t n = 4;
    World small;
    small.patterns = n;
    RandomStream random{23};
    const MatrixXd truth = small.points(random);
    const Compared all =
        compared(study_of_people(n, small.said(random, truth)), small.metrics(random, truth));
    const auto& ratings = all.rated.people.dissimilarity;
    const auto rho_of = [&](std::size_t draw, const Dissimilarity& metric) {
        std::vector<std::size_t> drawn;
        for (std::size_t k = 0; k < n; ++k, draw /= n) drawn.push_back(draw % n);
        std::vector<double> a;
        std::vector<double> b;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = i + 1; j < n; ++j) {
                if (drawn[i] == drawn[j]) continue;
                a.push_back(metric(drawn[i], drawn[j]));
                b.push_back(ratings(drawn[i], drawn[j]));
            }
        }
        return spearman(a, b);
    };
    const Uncertainty got = uncertainty_of(all, {.draws = 1, .map_draws = 0});
    for (std::size_t m = 0; m < all.metrics.size(); ++m) {
        double sum = 0.0;
        double squares = 0.0;
        double known = 0.0;
        for (std::size_t draw = 0; draw < 256; ++draw) {
            const double rho = rho_of(draw, all.metrics[m]);
            if (std::isnan(rho)) continue;
            sum += rho;
            squares += rho * rho;
            ++known;
        }
        REQUIRE(known > 128);
        const double error = std::sqrt(squares / known - sum / known * (sum / known));
        CHECK_MESSAGE(std::abs(got.rho[m].error[0] - error) <= 1e-12,
                      got.rho[m].error[0] << " for " << error);
    }
}

TEST_CASE("uncertainty: whose patterns are not all rated, the rated ones alone count") {
    const World world;
    RandomStream random{5};
    const MatrixXd truth = world.points(random);
    const auto said = world.said(random, truth);
    const auto metrics = world.metrics(random, truth);
    const RatingStudy some = study_of_people(12, said);
    RatingStudy more = some;
    more.labels.push_back("nobody rated");
    for (const auto& name : some.labels) REQUIRE(name != more.labels.back());
    const RatingStudy spread = *spread_over(some, more.labels);
    std::vector<Dissimilarity> wider;
    for (const Dissimilarity& metric : metrics) {
        Dissimilarity one{13, {}};
        for (std::size_t i = 0; i < 13; ++i) {
            for (std::size_t j = i + 1; j < 13; ++j) {
                one.condensed.push_back(j == 12 ? 0.5 : metric(i, j));
            }
        }
        wider.push_back(one);
    }
    const Uncertainty whole = uncertainty_of(compared(some, metrics), {.draws = 40});
    const Uncertainty part = uncertainty_of(compared(spread, wider), {.draws = 40});
    for (std::size_t r = 0; r < kResampledCount; ++r) {
        CHECK(whole.rho[1].error[r] == part.rho[1].error[r]);
        CHECK(whole.differences[0].p[r] == part.differences[0].p[r]);
    }
}

// The truth: that of a world of hundreds of patterns.
TEST_CASE("coverage: intervals over patterns hold the truth of a simulated world" *
          doctest::test_suite("long")) {
    World large;
    large.patterns = 400;
    RandomStream random{11};
    double rho = 0.0;
    double difference = 0.0;
    constexpr int kWorlds = 4;
    for (int world = 0; world < kWorlds; ++world) {
        const MatrixXd truth = large.points(random);
        const auto maps = large.maps(random, truth);
        const auto metrics = World::apart(maps);
        const Dissimilarity mean = large.mean(random, truth);
        const double one = spearman(metrics[0].condensed, mean.condensed);
        rho += one / kWorlds;
        difference += (one - spearman(metrics[1].condensed, mean.condensed)) / kWorlds;
    }
    const World world;
    // Fewer patterns have another K on average: that of as many is what is meant.
    double k = 0.0;
    constexpr int kSmallWorlds = 2000;
    for (int other = 0; other < kSmallWorlds; ++other) {
        const MatrixXd truth = world.points(random);
        k += *alienation(truth, world.maps(random, truth)[1]) / kSmallWorlds;
    }
    Hits patterns;
    Hits both;
    for (int study = 0; study < kStudies; ++study) {
        const MatrixXd truth = world.points(random);
        const auto maps = world.maps(random, truth);
        const Uncertainty got =
            uncertainty_of(with_maps(study_of_people(12, world.said(random, truth)),
                                     World::apart(maps), truth, maps),
                           {.draws = 200, .map_draws = 0});
        patterns.rho += holds(got.rho[0].interval[0], rho) ? 1 : 0;
        patterns.difference += holds(got.differences[0].rho.interval[0], difference) ? 1 : 0;
        patterns.k += holds(got.k[1].interval[0], k) ? 1 : 0;
        both.rho += holds(got.rho[0].interval[2], rho) ? 1 : 0;
        both.difference += holds(got.differences[0].rho.interval[2], difference) ? 1 : 0;
    }
    CHECK(patterns.rho >= kEnough);
    CHECK(patterns.difference >= kEnough);
    CHECK(patterns.k >= kEnough);
    CHECK(both.rho >= kEnough);
    CHECK(both.difference >= kEnough);
}

// The same truth as below, of four patterns, whose six pairs often keep their ranks whoever goes.
TEST_CASE("coverage: of few pairs an interval over people is right, or not given" *
          doctest::test_suite("long")) {
    World world;
    world.patterns = 4;
    world.people = 6;
    RandomStream random{29};
    int given = 0;
    int held = 0;
    for (int study = 0; study < 2 * kStudies; ++study) {
        const MatrixXd truth = world.points(random);
        const auto maps = world.maps(random, truth);
        const auto metrics = World::apart(maps);
        double rho = 0.0;
        constexpr int kOthers = 100;
        for (int other = 0; other < kOthers; ++other) {
            rho += spearman(metrics[0].condensed, world.mean(random, truth).condensed) / kOthers;
        }
        Compared all =
            with_maps(study_of_people(4, world.said(random, truth)), metrics, truth, maps);
        all.rated.people.maps.clear();
        const Uncertain got = uncertainty_of(all, {.draws = 1, .map_draws = 0}).rho[0];
        if (got.why[1] != NotKnown::known) continue;
        ++given;
        held += holds(got.interval[1], rho) ? 1 : 0;
    }
    MESSAGE("given in " << given << " of " << 2 * kStudies << ", right in " << held);
    CHECK(given >= kStudies);
    CHECK(given < 2 * kStudies);
    CHECK(held >= given * 93 / 100);
}

// The truth: the mean of what as many other people would have of the same patterns.
TEST_CASE("coverage: intervals over people hold the truth of a simulated world" *
          doctest::test_suite("long")) {
    const World world;
    RandomStream random{13};
    Hits hits;
    for (int study = 0; study < kStudies; ++study) {
        const MatrixXd truth = world.points(random);
        const auto maps = world.maps(random, truth);
        const auto metrics = World::apart(maps);
        double rho = 0.0;
        double difference = 0.0;
        constexpr int kOthers = 100;
        for (int other = 0; other < kOthers; ++other) {
            const Dissimilarity mean = world.mean(random, truth);
            const double one = spearman(metrics[0].condensed, mean.condensed);
            rho += one / kOthers;
            difference += (one - spearman(metrics[1].condensed, mean.condensed)) / kOthers;
        }
        Compared all =
            with_maps(study_of_people(12, world.said(random, truth)), metrics, truth, maps);
        all.rated.people.maps.clear();  // no K: each person left out would need another map
        const Uncertainty got = uncertainty_of(all, {.draws = 1, .map_draws = 0});
        hits.rho += holds(got.rho[0].interval[1], rho) ? 1 : 0;
        hits.difference += holds(got.differences[0].rho.interval[1], difference) ? 1 : 0;
    }
    CHECK(hits.rho >= kEnough);
    CHECK(hits.difference >= kEnough);
}

// The truth over people: as above, of maps; over both: that of other worlds as well.
TEST_CASE(
    "coverage: intervals of K over people, and over both, hold the truth of a simulated world" *
    doctest::test_suite("long")) {
    const World world;
    RandomStream random{17};
    MdsParams near = standard_mds_params(12, 3);
    near.tolerance = 1e-7;
    const auto map_of = [&](const Dissimilarity& mean, const MatrixXd& truth) {
        return smacof(mean, truth, near).points;
    };
    double of_worlds = 0.0;
    constexpr int kWorlds = 1000;
    for (int other = 0; other < kWorlds; ++other) {
        const MatrixXd truth = world.points(random);
        const MatrixXd seen = world.maps(random, truth)[0];
        of_worlds += *alienation(map_of(world.mean(random, truth), truth), seen) / kWorlds;
    }
    int people = 0;
    int both = 0;
    for (int study = 0; study < kStudies; ++study) {
        const MatrixXd truth = world.points(random);
        const auto maps = world.maps(random, truth);
        double k = 0.0;
        constexpr int kOthers = 20;
        for (int other = 0; other < kOthers; ++other) {
            k += *alienation(map_of(world.mean(random, truth), truth), maps[0]) / kOthers;
        }
        const RatingStudy said = study_of_people(12, world.said(random, truth));
        const Uncertainty got = uncertainty_of(
            with_maps(said, World::apart(maps), map_of(mean_ratings(said), truth), maps),
            {.draws = 30, .map_draws = 30});
        people += holds(got.k[0].interval[1], k) ? 1 : 0;
        both += holds(got.k[0].interval[2], of_worlds) ? 1 : 0;
    }
    CAPTURE(people);
    CAPTURE(both);
    CHECK(people >= kEnough);
    CHECK(both >= kEnough);
}

}  // namespace uncertainty_test
