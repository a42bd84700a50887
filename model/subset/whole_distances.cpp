#include "model/subset/whole_distances.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tact {

namespace {

// Twice the sum of the pairs of 10,000 objects still fits: 34 + 26 + 1 bits.
constexpr int kBits = 34;

}  // namespace

WholeDistances whole_distances(const Dissimilarity& dissimilarity) {
    WholeDistances whole;
    const std::size_t n = dissimilarity.size;
    whole.size = n;
    whole.square.assign(n * n, 0);
    double largest = 0.0;
    for (const double value : dissimilarity.condensed) {
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
    int bits = 0;
    std::frexp(largest, &bits);
    whole.exponent = bits - kBits;
    std::size_t k = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j, ++k) {
            const double value = dissimilarity.condensed[k];
            if (!std::isfinite(value)) continue;
            const Units units = std::llround(std::ldexp(value, -whole.exponent));
            whole.square[i * n + j] = units;
            whole.square[j * n + i] = units;
        }
    }
    Units divisor = 0;
    for (const Units value : whole.square) divisor = std::gcd(divisor, value);
    whole.divisor = std::max<Units>(divisor, 1);
    return whole;
}

Eigen::MatrixXd real_distances(const WholeDistances& distances) {
    const auto n = static_cast<Eigen::Index>(distances.size);
    return Eigen::Map<const Eigen::Matrix<Units, -1, -1>>(distances.square.data(), n, n)
        .cast<double>();
}

std::vector<Units> distinct_values(const WholeDistances& distances) {
    std::vector<Units> values;
    values.reserve(pair_count(distances.size));
    for (std::size_t i = 0; i < distances.size; ++i) {
        const Units* row = distances.row(i);
        values.insert(values.end(), row + i + 1, row + distances.size);
    }
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

double largest_meant(const WholeDistances& distances, Units units, std::size_t pairs) {
    const double rounded_off = 0.5 * static_cast<double>(pairs);
    return std::ldexp(static_cast<double>(units) + rounded_off, distances.exponent);
}

}  // namespace tact
