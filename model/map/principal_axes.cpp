#include "model/map/principal_axes.h"

#include <algorithm>
#include <cmath>

#include "model/common/decompositions.h"

namespace tact {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Variances that differ by less than this share of the largest count as equal, and those below it
// as none.
constexpr double kEqualVariance = 1e-9;

// The first row at least half as long as the longest: not the longest itself, which rounding would
// choose among equals.
Index first_long_row(const MatrixXd& rows) {
    double longest = 0.0;
    for (Index i = 0; i < rows.rows(); ++i) longest = std::max(longest, rows.row(i).norm());
    Index i = 0;
    while (i + 1 < rows.rows() && rows.row(i).norm() < 0.5 * longest) ++i;
    return i;
}

// Turns columns [first, first + count), which have equal variance: the first axis through the first
// object, the second through what the next leaves over, and so on.
void lay_through_objects(MatrixXd& points, Index first, Index count) {
    const MatrixXd block = points.middleCols(first, count);
    MatrixXd rest = block;
    for (Index c = 0; c < count; ++c) {
        const Eigen::RowVectorXd axis = rest.row(first_long_row(rest)).normalized();
        points.col(first + c) = block * axis.transpose();
        rest -= (rest * axis.transpose()).eval() * axis;
    }
}

}  // namespace

MatrixXd on_principal_axes(const MatrixXd& points) {
    if (points.rows() == 0 || points.cols() == 0) return points;
    const MatrixXd centred = points.rowwise() - points.colwise().mean();
    const SymmetricEigen eigen = symmetric_eigen(centred.transpose() * centred);
    const Eigen::VectorXd variance = eigen.values.reverse();
    MatrixXd result = centred * eigen.vectors.rowwise().reverse();
    const double close = kEqualVariance * variance(0);
    for (Index first = 0; first < result.cols();) {
        Index end = first + 1;
        while (end < result.cols() && variance(end - 1) - variance(end) <= close) ++end;
        if (variance(first) <= close) {
            // What is left is rounding noise, whose sign would be anyone's guess.
            result.middleCols(first, end - first).setZero();
        } else if (end - first > 1) {
            lay_through_objects(result, first, end - first);
        }
        first = end;
    }
    mirror_to_positive(result);
    return result;
}

void mirror_to_positive(MatrixXd& points) {
    for (Index c = 0; c < points.cols(); ++c) {
        double largest = 0.0;
        for (Index i = 0; i < points.rows(); ++i) {
            largest = std::max(largest, std::abs(points(i, c)));
        }
        Index i = 0;
        while (i + 1 < points.rows() && std::abs(points(i, c)) < (1.0 - 1e-9) * largest) ++i;
        if (points.rows() > 0 && points(i, c) < 0.0) points.col(c) = -points.col(c);
    }
}

}  // namespace tact
