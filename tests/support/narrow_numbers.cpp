// Prints one fingerprint a line of numbers that rooms of the model compute: for tests/narrow, which
// compares those of a build with integers of 32 bits with those of one with 64.
#include <cmath>
#include <cstdio>
#include <vector>

#include "model/common/fingerprint.h"
#include "model/common/portable.h"
#include "model/common/random.h"
#include "model/design_space/sobol.h"
#include "model/dissimilarity/dissimilarity.h"
#include "model/dtw/dtw.h"
#include "model/map/isotonic.h"

namespace {

using namespace tact;

void print(const char* what, const std::vector<double>& numbers) {
    const auto* bytes = reinterpret_cast<const char*>(numbers.data());
    std::printf("%s %zu %s\n", what, numbers.size(),
                fingerprint_text({bytes, numbers.size() * sizeof(double)}).c_str());
}

std::vector<double> drawn(std::uint64_t stream, std::size_t count) {
    RandomStream random{stream};
    std::vector<double> numbers(count);
    for (double& number : numbers) number = next_normal(random);
    return numbers;
}

void print_random() {
    RandomStream random{7};
    std::vector<double> numbers;
    for (std::size_t k = 1; k < 5000; ++k) {
        numbers.push_back(next_even(random));
        numbers.push_back(static_cast<double>(next_index(random, k * 811)));
    }
    print("random", numbers);
}

void print_functions() {
    std::vector<double> numbers;
    for (const double x : drawn(1, 5000)) {
        const double positive = x * x + 1e-9;
        for (const double y :
             {portable::sin(1e3 * x), portable::cos(1e6 * x), portable::tan(x), portable::atan(x),
              portable::exp(20.0 * x), portable::log(positive), portable::log2(positive),
              portable::log10(positive), portable::pow(positive, x), portable::erfc(x)}) {
            numbers.push_back(y);
        }
    }
    print("functions", numbers);
}

// Shapes of a strip and less, with both signs: a lost sign bit shows in every sum.
void print_dtw() {
    std::vector<std::vector<double>> signals;
    for (std::size_t k = 0; k < 24; ++k) signals.push_back(drawn(100 + k, 3 + 17 * k));
    std::vector<SignalPair> pairs;
    for (const auto& a : signals) {
        for (const auto& b : signals) pairs.push_back({a, b});
    }
    print("dtw", dtw(pairs, {.threads = 1}));
    print("dtw-at-cost", dtw(pairs, {.threads = 1, .waiting_cost = 0.25}));
    std::vector<double> single;
    for (const SignalPair& pair : pairs) single.push_back(dtw(pair.a, pair.b));
    print("dtw-alone", single);
}

void print_design() {
    std::vector<double> numbers;
    for (std::uint32_t point = 0; point < 2000; ++point) {
        for (std::size_t d = 0; d < kSobolDimensions; ++d) {
            numbers.push_back(sobol_coordinate(point, d, 0x9e3779b9U));
        }
    }
    print("sobol", numbers);
}

void print_pairs() {
    constexpr std::size_t kObjects = 40;
    Dissimilarity d{kObjects, drawn(9, pair_count(kObjects))};
    for (double& value : d.condensed) value = std::abs(value);
    print("ranks", average_ranks(quantised(d.condensed)));
    print("disparities", disparities(d.condensed, drawn(10, d.condensed.size())));
}

}  // namespace

int main() {
    print_random();
    print_functions();
    print_dtw();
    print_design();
    print_pairs();
}
