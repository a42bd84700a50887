// Fisher's F: what intervals of ratios of mean squares are read from.
//
// Source    its distribution is a regularised incomplete beta (DLMF 8.17), by the continued
// fraction
//           DLMF 8.17.22 with Lentz's method; log gamma by Stirling's series (DLMF 5.11.1)
// Valid     degrees of freedom above 0, whole or not, up to 1e7; quantiles to 1e-10 relative
// Exact     same input, same bits, on any instruction set.
#pragma once

namespace tact {

// The share of F(df1, df2) below a value; 0 below 0.
double f_share_below(double value, double df1, double df2);

// The value below which a share (0 < share < 1) lies.
double f_quantile(double share, double df1, double df2);

}  // namespace tact
