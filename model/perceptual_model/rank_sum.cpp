#include "model/perceptual_model/rank_sum.h"

#include <cmath>
#include <cstdint>

#include "model/physiology/nc_matrix.h"

namespace tact {

namespace {

// Beyond 64 bits: weights of up to 1000 in units of 1e-12, ranks of up to 5e7 pairs.
__extension__ using Wide = __int128;

Wide part(double rank, double weight) {
    return static_cast<Wide>(std::llround(2.0 * rank)) * weight_units(weight);
}

}  // namespace

double pm_of(double nc_rank, double oc_rank, double nc_weight, double oc_weight) {
    const Wide sum = part(nc_rank, nc_weight) + part(oc_rank, oc_weight);
    return static_cast<double>(sum) / (2.0 * kWeightUnits);
}

}  // namespace tact
