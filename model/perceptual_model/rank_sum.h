// PM of one pair from its ranks in NC and OC.
//
// Source    Lim & Park 2023, section 5.3.
// Exact     equal sums are equal numbers: in doubles 0.1 and 0.3 of two ranks and of their exchange
//           may differ by rounding, and the ranks of PM with them.
#pragma once

namespace tact {

// w_NC rank_NC + w_OC rank_OC. Weights, within +-kLargestWeight, count to twelve decimals and ranks
// to halves: a sum of whole numbers.
double pm_of(double nc_rank, double oc_rank, double nc_weight, double oc_weight);

}  // namespace tact
