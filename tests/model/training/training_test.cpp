#include "model/training/training.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/dissimilarity/correlation.h"
#include "model/pattern/pattern.h"
#include "model/perceptual_model/perceptual_model.h"

namespace training_test {

using namespace tact;

namespace {

// Short ones, as time warping is quadratic, that differ in strength, frequency and rhythm.
std::vector<Waveform> patterns(int seed, int count) {
    std::vector<Waveform> waveforms;
    for (int k = 0; k < count; ++k) {
        Pattern pattern;
        pattern.duration_s = 0.12;
        pattern.amplitude_g = 0.4 + 0.35 * ((k * 3 + seed) % 5);
        pattern.carriers[0].frequency_hz = 25.0 + 37.0 * ((k * 5 + seed) % 7);
        pattern.modulation.frequency_hz = 10.0 * ((k + seed) % 4);
        if (k % 3 == 1) pattern.rhythm = {"x-", 0.03};
        waveforms.push_back(render(pattern));
    }
    return waveforms;
}

std::vector<std::string> labels(std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < count; ++k) names.push_back("v" + std::to_string(k));
    return names;
}

// People who feel just what the model with these parameters predicts, each with a pair left out.
TrainingSet rated_by(const PerceptualModelParams& model, int seed, int count, int people) {
    TrainingSet set;
    set.name = "set " + std::to_string(seed);
    set.waveforms = patterns(seed, count);
    const auto prediction = predict(set.waveforms, model);
    REQUIRE(prediction);
    set.study.labels = labels(set.waveforms.size());
    for (int person = 0; person < people; ++person) {
        std::vector<double> condensed = prediction->pm.condensed;
        if (people > 1) condensed[static_cast<std::size_t>(3 * person + 1)] = std::nan("");
        set.study.judgements.push_back({"P" + std::to_string(person), condensed});
    }
    return set;
}

PerceptualModelParams planted() {
    PerceptualModelParams model;
    model.coding.excitatory_layers = 1;
    model.coding.inhibitory_layers = 2;
    model.channel_weight = {0.5, 1.0, 0.0, 0.25};
    model.nc_weight = 0.75;
    model.oc_weight = 0.5;
    return model;
}

bool is_among(const Training& training, const PerceptualModelParams& model) {
    return std::ranges::any_of(training.best.points, [&](const GridPoint& point) {
        return nearest_model(training.grid, point, model) == model;
    });
}

}  // namespace

TEST_CASE("training: parameters planted in ratings are among the reported optima") {
    const std::vector<TrainingSet> sets{rated_by(planted(), 1, 6, 3), rated_by(planted(), 2, 5, 3)};
    const auto training = train(sets, {.units = 4, .leave_out_participants = true});
    REQUIRE(training);
    CHECK(training->best.value == 1.0);
    CHECK(is_among(*training, planted()));
    for (const TrainedSet& set : training->sets) {
        CHECK(set.rho_after == 1.0);
        CHECK(set.rho_before < 1.0);
    }
    CHECK(training->share_near_best > 0.0);
    CHECK(training->share_near_best < 0.5);
    // Whoever is left out felt the same.
    REQUIRE(training->without_participant.size() == 3);
    for (const LeftOut& person : training->without_participant) {
        CHECK(person.value == 1.0);
        CHECK(person.rho_after == 1.0);
    }
    REQUIRE(training->without_set.size() == 2);
    for (const LeftOut& set : training->without_set) {
        CHECK(set.value == 1.0);
        CHECK(set.rho_after > 0.5);
    }
}

TEST_CASE("training: without a pattern its pairs have no say, and are what the fit is tried on") {
    std::vector<TrainingSet> sets{rated_by(planted(), 1, 6, 2)};
    const auto plain = train(sets, {.units = 2, .leave_out_patterns = true});
    REQUIRE(plain);
    REQUIRE(plain->without_pattern.size() == 6);
    CHECK(plain->without_pattern[2].name == sets[0].study.labels[2]);
    // Its pairs turned round: the fit without it is the same, and fails on them.
    for (Judgement& said : sets[0].study.judgements) {
        for (std::size_t p = 0; p < said.condensed.size(); ++p) {
            const auto [i, j] = pair_at(6, p);
            if (i == 2 || j == 2) said.condensed[p] = -said.condensed[p];
        }
    }
    const auto turned = train(sets, {.units = 2, .leave_out_patterns = true});
    REQUIRE(turned);
    const LeftOut& before = plain->without_pattern[2];
    const LeftOut& after = turned->without_pattern[2];
    CHECK(before.value == after.value);
    CHECK(before.model == after.model);
    CHECK(std::abs(before.rho_after + after.rho_after) <= 1e-12);
    CHECK(plain->without_pattern[1].value != turned->without_pattern[1].value);
}

TEST_CASE("training: of equally good parameters those nearest to the ones before are chosen") {
    const PerceptualModelParams paper;
    PerceptualModelParams rounded = paper;
    rounded.channel_weight = {0.25, 0.75, 0.0, 0.5};
    const std::vector<TrainingSet> sets{rated_by(rounded, 3, 6, 1)};
    const auto training = train(sets, {.model = rounded, .units = 4});
    REQUIRE(training);
    CHECK(training->model == rounded);
    CHECK(training->value_before == training->best.value);
    CHECK(training->without_set.empty());
    CHECK(training->without_participant.empty());
}

TEST_CASE("training: the best of each value of a parameter reaches the optimum and not beyond") {
    const std::vector<TrainingSet> sets{rated_by(planted(), 4, 6, 1)};
    const auto training = train(sets, {.units = 4});
    REQUIRE(training);
    const auto planted_values = trained_values(planted());
    for (std::size_t p = 0; p < kTrainedParameters; ++p) {
        const std::vector<double>& best = training->best_of[p];
        CHECK(best.size() == 5);
        CHECK(std::ranges::max(best) == training->best.value);
        const double steps = p < 2 ? planted_values[p] : 4.0 * planted_values[p];
        CHECK(best[static_cast<std::size_t>(steps)] == training->best.value);
    }
}

TEST_CASE("training: refuses what cannot be fitted") {
    const auto fault = [](const std::vector<TrainingSet>& sets, bool participants = false) {
        const auto can = can_train(sets, {.leave_out_participants = participants});
        return can ? std::string() : can.error().message;
    };
    TrainingSet set = rated_by({}, 1, 5, 1);
    CHECK(fault({set}) == "");
    CHECK(fault({}) == "expected a set with ratings, got none");
    CHECK(fault({set}, true) ==
          "expected ratings of several participants to leave one out, got those of one");
    TrainingSet flat = set;
    for (double& value : flat.study.judgements[0].condensed) value = 2.0;
    CHECK(fault({set, flat}) == "set 1: expected ratings that differ, got the same for every pair");
    TrainingSet two = rated_by({}, 1, 2, 1);
    CHECK(fault({two}) == "set 1: expected at least three patterns, got 2");
}

TEST_CASE("training: a stop ends it without an answer, progress never goes back") {
    const std::vector<TrainingSet> sets{rated_by({}, 1, 5, 1)};
    std::stop_source source;
    double last = 0.0;
    bool is_forward = true;
    TrainingParams params{.units = 10, .threads = 1, .stop = source.get_token()};
    params.progress = [&](double share) {
        is_forward = is_forward && share >= last;
        last = share;
        if (share > 0.3) source.request_stop();
    };
    CHECK_FALSE(train(sets, params));
    CHECK(is_forward);
    CHECK(last < 1.0);
}

}  // namespace training_test
