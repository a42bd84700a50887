#include "model/metrics/rank_average.h"

#include <cassert>

namespace tact {

Dissimilarity rank_average(std::span<const Dissimilarity> matrices) {
    assert(!matrices.empty() && "nothing to average");
    Dissimilarity sum{matrices[0].size, std::vector<double>(matrices[0].condensed.size(), 0.0)};
    for (const Dissimilarity& matrix : matrices) {
        assert(matrix.size == sum.size && "matrices of different objects");
        const auto ranks = average_ranks(matrix.condensed);
        for (std::size_t k = 0; k < ranks.size(); ++k) sum.condensed[k] += ranks[k];
    }
    for (double& value : sum.condensed) value /= static_cast<double>(matrices.size());
    return sum;
}

}  // namespace tact
