#include "model/training/training_search.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "model/perceptual_model/perceptual_model.h"
#include "tests/support/golden.h"
#include "tests/support/training_problem.h"

namespace training_search_test {

using namespace tact;

namespace {

struct Case {
    SearchProblem problem;
    std::vector<std::vector<double>> ratings;
};

// Three sets, one with pairs that nobody rated, and an objective without each.
Case random_case(std::uint64_t seed, int differences) {
    RandomStream random{seed};
    Case of;
    std::vector<ColumnPlace> all;
    for (const std::size_t patterns : {5UL, 4UL, 6UL}) {
        of.problem.sets.push_back(random_set(random, patterns, differences));
        of.ratings.push_back(
            random_ratings(random, pair_count(patterns), patterns == 6 ? 0.2 : 0.0));
        all.push_back(*add_ratings(of.problem, of.ratings.size() - 1, of.ratings.back()));
    }
    of.problem.objectives = {all, {all[1], all[2]}, {all[0], all[2]}, {all[0], all[1]}};
    return of;
}

struct BruteForce {
    double best = -std::numeric_limits<double>::infinity();
    std::uint64_t at_best = 0;
    std::uint64_t ordered = 0;
    std::vector<double> values;
};

// Every combination of the grid, one by one, by the model itself.
BruteForce every_combination(const Case& of, const std::vector<std::size_t>& sets, int units,
                             bool absolute) {
    BruteForce found;
    for (std::size_t layers = 0; layers < kTrainedLayers; ++layers) {
        PerceptualModelParams model;
        model.coding.excitatory_layers = layers_at(layers).excitatory;
        model.coding.inhibitory_layers = layers_at(layers).inhibitory;
        const int weights = units + 1;
        const int all = weights * weights * weights * weights * weights * weights;
        for (int number = 0; number < all; ++number) {
            int rest = number;
            const auto next = [&] {
                const double weight = static_cast<double>(rest % weights) / units;
                rest /= weights;
                return weight;
            };
            for (double& weight : model.channel_weight) weight = next();
            model.nc_weight = next();
            model.oc_weight = next();
            double sum = 0.0;
            for (const std::size_t s : sets) {
                const double rho = rho_at(of.problem.sets[s], model, of.ratings[s]);
                sum += absolute ? std::abs(rho) : rho;
            }
            const double value = sum / static_cast<double>(sets.size());
            if (std::isnan(value)) continue;
            ++found.ordered;
            found.values.push_back(value);
            if (value > found.best + kEqualObjective) found.at_best = 0;
            found.best = std::max(found.best, value);
            if (value >= found.best - kEqualObjective) ++found.at_best;
        }
    }
    return found;
}

std::vector<Waveform> waveforms_of(const golden::Json& set) {
    std::vector<Waveform> waveforms;
    for (const auto& pattern : set.at("patterns")) {
        waveforms.push_back(padded(render(golden::pattern_of(pattern)), 10'000));
    }
    return waveforms;
}

PerceptualModelParams model_of(const golden::Json& point) {
    PerceptualModelParams model;
    model.coding.excitatory_layers = point.at("layers")[0];
    model.coding.inhibitory_layers = point.at("layers")[1];
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        model.channel_weight[c] = point.at("channels")[c].get<int>() / 10.0;
    }
    model.nc_weight = point.at("nc").get<int>() / 10.0;
    model.oc_weight = point.at("oc").get<int>() / 10.0;
    return model;
}

// Without NC any layers will do: the first are asked for.
std::size_t layers_of(const PerceptualModelParams& model) {
    if (model.nc_weight == 0.0) return 0;
    return static_cast<std::size_t>(model.coding.excitatory_layers * (kMostTrainedLayers + 1) +
                                    model.coding.inhibitory_layers);
}

std::vector<SpikeForm> forms_of(const std::vector<Waveform>& waveforms,
                                const PerceptualModelParams& model) {
    std::vector<NeuralCode> codes;
    for (const Waveform& waveform : waveforms) codes.push_back(neural_code(waveform, model.coding));
    std::vector<SpikeForm> forms;
    for (std::size_t i = 0; i < codes.size(); ++i) {
        for (std::size_t j = i + 1; j < codes.size(); ++j) {
            forms.push_back(spike_form(codes[i], codes[j]));
        }
    }
    return forms;
}

bool same(const SearchResult& a, const SearchResult& b) {
    bool equal = a.best_of_layers == b.best_of_layers && a.best_of_channel == b.best_of_channel &&
                 a.best_of_mix == b.best_of_mix && a.histogram == b.histogram;
    for (std::size_t o = 0; o < a.optima.size(); ++o) {
        equal = equal && a.optima[o].value == b.optima[o].value &&
                a.optima[o].points == b.optima[o].points &&
                a.optima[o].classes == b.optima[o].classes &&
                a.optima[o].combinations == b.optima[o].combinations;
    }
    return equal;
}

}  // namespace

TEST_CASE("training search: finds what trying every combination finds, ties and all" *
          doctest::test_suite("long")) {
    for (const int differences : {2, 40}) {
        const Case of = random_case(11, differences);
        const auto found = search(of.problem, {.units = 2});
        REQUIRE(found);
        const std::vector<std::vector<std::size_t>> kept{{0, 1, 2}, {1, 2}, {0, 2}, {0, 1}};
        for (std::size_t o = 0; o < kept.size(); ++o) {
            const BruteForce all = every_combination(of, kept[o], 2, false);
            CHECK(found->optima[o].value == all.best);
            CHECK(found->optima[o].combinations == all.at_best);
            if (o > 0) continue;
            std::uint64_t counted = 0;
            for (const std::uint64_t bin : found->histogram) counted += bin;
            CHECK(counted == all.ordered);
            std::uint64_t near = 0;
            for (const double value : all.values) near += value >= all.best - 0.1;
            // A bin may reach beyond the line by its width.
            CHECK(
                std::abs(share_near_best(*found, 0.1) * static_cast<double>(combination_count(2)) -
                         static_cast<double>(near)) <= 0.002 * static_cast<double>(near) + 20);
        }
    }
}

TEST_CASE("training search: each listed point has the value of the optimum, by the model itself") {
    const Case of = random_case(3, 3);
    const auto found = search(of.problem, {.units = 3});
    REQUIRE(found);
    CHECK(found->optima[0].points.size() == found->optima[0].classes);
    for (const GridPoint& point : found->optima[0].points) {
        const PerceptualModelParams model = nearest_model(found->grid, point, {});
        double sum = 0.0;
        for (std::size_t s = 0; s < 3; ++s) sum += rho_at(of.problem.sets[s], model, of.ratings[s]);
        CHECK(sum / 3.0 == found->optima[0].value);
    }
}

TEST_CASE("training search: an objective of sizes counts what is the wrong way round") {
    const Case of = random_case(29, 10);
    const auto found =
        search(of.problem, {.units = 1, .objective = TrainingObjective::mean_absolute_rho});
    REQUIRE(found);
    const BruteForce all = every_combination(of, {0, 1, 2}, 1, true);
    CHECK(found->optima[0].value == all.best);
    CHECK(found->optima[0].combinations == all.at_best);
}

TEST_CASE("training search: every instruction set and number of threads finds the same") {
    const Case of = random_case(7, 5);
    const auto expected = search(of.problem, {.units = 3, .threads = 1});
    REQUIRE(expected);
    for (const TrainingKernel& kernel : training_kernels()) {
        for (const int threads : {1, 2, 4}) {
            const auto found =
                search(of.problem, {.units = 3, .threads = threads, .kernel = &kernel});
            REQUIRE(found);
            CHECK_MESSAGE(same(*found, *expected), kernel.name);
        }
    }
}

TEST_CASE("training search: long recordings are ranked as the model ranks them") {
    Case of = random_case(13, 20);
    for (SearchSet& set : of.problem.sets) {
        set.samples = 10'000'000;
        for (auto& forms : set.forms) {
            for (SpikeForm& form : forms) {
                for (auto& row : form) {
                    for (std::int64_t& count : row) count *= 300'007;
                }
            }
        }
    }
    const auto found = search(of.problem, {.units = 2});
    REQUIRE(found);
    const BruteForce all = every_combination(of, {0, 1, 2}, 2, false);
    CHECK(found->optima[0].value == all.best);
}

TEST_CASE("training search: rho is scipy's at points of the paper's grid") {
    const auto golden = golden::read("training.json");
    double worst = 0.0;
    int compared = 0;
    for (std::size_t s = 0; s < golden.at("sets").size(); ++s) {
        const std::vector<Waveform> waveforms = waveforms_of(golden.at("sets")[s]);
        std::vector<double> ratings;
        for (const auto& rating : golden.at("sets")[s].at("ratings")) {
            ratings.push_back(rating.is_null() ? INFINITY : rating.get<double>());
        }
        SearchSet set;
        set.samples = waveforms.front().samples_g.size();
        set.oc_rank = predict(waveforms, {})->oc_rank;
        set.forms.resize(kTrainedLayers);
        for (const auto& point : golden.at("points")) {
            const PerceptualModelParams model = model_of(point);
            std::vector<SpikeForm>& forms = set.forms[layers_of(model)];
            if (forms.empty()) forms = forms_of(waveforms, model);
            const double rho = rho_at(set, model, ratings);
            const auto& expected = point.at("rho")[s];
            if (expected.is_null()) {
                CHECK(std::isnan(rho));
                continue;
            }
            worst = std::max(worst, std::abs(rho - expected.get<double>()));
            ++compared;
        }
    }
    CHECK(compared > 100);
    CHECK(worst <= 1e-12);
}

TEST_CASE("training search: ratings without order are no ratings") {
    RandomStream random{1};
    SearchProblem problem;
    problem.sets.push_back(random_set(random, 4, 5));
    CHECK_FALSE(add_ratings(problem, 0, std::vector<double>(6, 3.0)));
    CHECK_FALSE(add_ratings(problem, 0, std::vector<double>(6, INFINITY)));
    const auto first = add_ratings(problem, 0, std::vector<double>{1, 2, 3, 4, 5, 6});
    const auto second = add_ratings(problem, 0, std::vector<double>{6, 5, 4, 3, 2, 1});
    const auto partial = add_ratings(problem, 0, std::vector<double>{6, 5, 4, NAN, 2, 1});
    REQUIRE((first && second && partial));
    CHECK(*first == ColumnPlace{0, 0, 0});
    CHECK(*second == ColumnPlace{0, 0, 1});
    CHECK(*partial == ColumnPlace{0, 1, 0});
}

TEST_CASE("training search: a stop ends it without an answer") {
    const Case of = random_case(1, 5);
    std::stop_source source;
    source.request_stop();
    CHECK_FALSE(search(of.problem, {.units = 10, .stop = source.get_token()}));
    std::stop_source later;
    SearchParams params{.units = 10, .stop = later.get_token()};
    params.progress = [&](double share) {
        if (share > 0.01) later.request_stop();
    };
    CHECK_FALSE(search(of.problem, params));
}

}  // namespace training_search_test
