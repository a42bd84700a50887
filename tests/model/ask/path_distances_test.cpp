#include "model/ask/even_path.h"

#include <doctest/doctest.h>

#include <algorithm>

namespace path_distances_test {

using namespace tact;

namespace {

StepsQuestion short_question(StepMeasure measure) {
    StepsQuestion question;
    question.from.duration_s = question.to.duration_s = 0.3;
    question.from.rhythm = {"x-x-xx", 0.05};
    question.to.amplitude_g = 1.6;
    question.to.modulation.frequency_hz = 12.0;
    question.measure = measure;
    return question;
}

const PathDistances::Pairs kPairs{{0.0, 0.5}, {0.5, 1.0}, {0.0, 1.0}};

std::vector<double> distances(const StepsQuestion& question, bool exact) {
    const StepsOptions options;
    PathDistances path(question, options);
    REQUIRE(path.prepare({0.0, 0.5, 1.0}));
    path.scale_by(kPairs);
    return path.of(kPairs, exact);
}

Prediction predicted(const StepsQuestion& question) {
    std::vector<Waveform> waveforms;
    for (const double share : {0.0, 0.5, 1.0}) {
        waveforms.push_back(render(morphed(question.from, question.to, share)));
    }
    return *predict(waveforms, question.model);
}

std::vector<double> in_order(const Dissimilarity& all) { return {all(0, 1), all(1, 2), all(0, 2)}; }

}  // namespace

TEST_CASE("path distances: exact ones are those of a prediction, with and without waiting costs") {
    for (const double waiting_cost : {0.0, 0.002}) {
        CAPTURE(waiting_cost);
        StepsQuestion question = short_question(StepMeasure::oc);
        question.model.envelope.waiting_cost = waiting_cost;
        const Prediction truth = predicted(question);
        const auto told = distances(question, true);
        for (std::size_t k = 0; k < told.size(); ++k) {
            CHECK(told[k] == doctest::Approx(in_order(truth.oc)[k]).epsilon(1e-9));
        }
    }
    StepsQuestion waiting = short_question(StepMeasure::oc);
    waiting.model.envelope.waiting_cost = 0.002;
    CHECK(distances(waiting, true) != distances(short_question(StepMeasure::oc), true));
}

TEST_CASE("path distances: coarse ones are near the exact ones, in their unit") {
    const auto coarse = distances(short_question(StepMeasure::oc), false);
    const auto exact = distances(short_question(StepMeasure::oc), true);
    for (std::size_t k = 0; k < exact.size(); ++k) {
        CHECK(coarse[k] == doctest::Approx(exact[k]).epsilon(0.15));
    }
}

TEST_CASE("path distances: NC and OC weigh as the model says, by their largest among the pairs") {
    StepsQuestion question = short_question(StepMeasure::pm);
    question.model.nc_weight = 0.3;
    question.model.oc_weight = 0.7;
    const Prediction truth = predicted(question);
    const auto nc = in_order(truth.nc);
    const auto oc = in_order(truth.oc);
    const auto told = distances(question, true);
    for (std::size_t k = 0; k < told.size(); ++k) {
        CHECK(told[k] == doctest::Approx(0.3 * nc[k] / std::ranges::max(nc) +
                                         0.7 * oc[k] / std::ranges::max(oc))
                             .epsilon(1e-9));
    }
}

}  // namespace path_distances_test
