// Points at random, and what is to be mapped: known distances, or an order that no map has.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/map/mds.h"

namespace tact {

inline Eigen::MatrixXd random_map(Eigen::Index n, Eigen::Index k, std::uint32_t seed) {
    std::mt19937 generator(seed);
    Eigen::MatrixXd points(n, k);
    for (Eigen::Index e = 0; e < points.size(); ++e) {
        points.data()[e] = static_cast<double>(generator()) / 2147483648.0 - 1.0;
    }
    return points;
}

inline Dissimilarity of_points(const Eigen::MatrixXd& points) {
    return {static_cast<std::size_t>(points.rows()), distances(points)};
}

inline Dissimilarity random_dissimilarity(std::size_t n, std::uint32_t seed) {
    std::mt19937 generator(seed);
    Dissimilarity result{n, std::vector<double>(pair_count(n))};
    for (double& value : result.condensed) value = static_cast<double>(generator());
    return result;
}

inline MdsParams mds_with(int dimensions, int random_starts) {
    MdsParams params;
    params.dimensions = dimensions;
    params.random_starts = random_starts;
    return params;
}

}  // namespace tact
