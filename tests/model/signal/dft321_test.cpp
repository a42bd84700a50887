#include "model/signal/simulated_measurement.h"

#include <cmath>
#include <vector>

#include "tests/support/golden.h"

namespace dft321_test {

using namespace tact;
using golden::noise;
using Samples = std::vector<double>;

namespace {

double energy(const Samples& samples) {
    double sum = 0.0;
    for (const double sample : samples) sum += sample * sample;
    return sum;
}

}  // namespace

TEST_CASE("dft321: equals NumPy") {
    for (const auto& expected : golden::read("measured.json", "dft321")) {
        std::vector<Samples> axes;
        for (const std::uint32_t seed : expected.at("seeds")) {
            const double amplitude = 1.0 + static_cast<double>(axes.size());
            axes.push_back(without_mean(noise(seed, expected.at("samples"), amplitude).samples_g));
        }
        CHECK(golden::worst_difference(dft321(axes), expected.at("expected")) < 1e-12);
    }
}

TEST_CASE("dft321: energy is kept, and a single axis comes out as it was") {
    std::vector<Samples> axes;
    double sum = 0.0;
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        axes.push_back(noise(seed, 1001, 1.0).samples_g);
        sum += energy(axes.back());
    }
    CHECK(std::abs(energy(dft321(axes)) - sum) < 1e-11 * sum);
    axes[0].assign(1001, 0.0);
    axes[2].assign(1001, 0.0);
    CHECK(golden::worst_difference(dft321(axes), axes[1]) < 1e-12);
    // Axes that cancel still move.
    axes[0] = axes[1];
    for (double& sample : axes[0]) sample = -sample;
    CHECK(std::abs(energy(dft321(axes)) - 2.0 * energy(axes[1])) < 1e-11 * sum);
    CHECK(dft321({}).empty());
    CHECK(dft321(std::vector<Samples>(3)).empty());
    CHECK(dft321(std::vector<Samples>(3, Samples(5, 0.0))) == Samples(5, 0.0));
}

}  // namespace dft321_test
