#include "model/map/random_stress.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "model/common/parallel.h"
#include "model/common/random.h"
#include "model/map/mds.h"

namespace tact {

RandomStress random_stress(std::size_t objects, int dimensions, const RandomStressParams& params) {
    const auto k = static_cast<std::size_t>(std::max(dimensions, 1));
    if (objects <= k + 1 || params.draws == 0) return {};
    MdsParams mds;
    mds.dimensions = dimensions;
    mds.random_starts = params.random_starts;
    mds.tolerance = 1e-7;  // far below the spread of the draws
    mds.threads = 1;
    std::vector<double> stress(params.draws);
    parallel_for(params.draws, params.threads, {}, [&](std::size_t draw) {
        RandomStream random{random_bits(params.seed, draw)};
        std::vector<std::size_t> order(pair_count(objects));
        next_permutation_of(random, order);
        Dissimilarity dissimilarity{objects, {}};
        for (const std::size_t rank : order) {
            dissimilarity.condensed.push_back(static_cast<double>(rank + 1));
        }
        const PerceptualSpace best = nonmetric_mds(dissimilarity, mds);
        stress[draw] = best.is_interval ? best.collapsed_stress1 : best.stress1;
    });
    std::ranges::sort(stress);
    const double sum = std::accumulate(stress.begin(), stress.end(), 0.0);
    return {sum / static_cast<double>(stress.size()),
            {quantile(stress, 0.05), quantile(stress, 0.95)}};
}

}  // namespace tact
