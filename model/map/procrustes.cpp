#include "model/map/procrustes.h"

#include <algorithm>
#include <cassert>

#include "model/common/decompositions.h"

namespace tact {

// With both maps centred, X the moving and Y the target, and the decomposition X'Y = U S V':
//     the rotation R = U V' maximises trace(R' X'Y) = sum S, so
//     |Y - s X R|^2 = |Y|^2 - 2 s sum S + s^2 |X|^2
// is least at s = sum S / |X|^2, where it is |Y|^2 (1 - r^2), r = sum S / (|X| |Y|).
// R may be a reflection: which of two mirror images a map is has no meaning.
ProcrustesFit procrustes(const Eigen::MatrixXd& moving, const Eigen::MatrixXd& target, bool scale) {
    assert(moving.rows() == target.rows() && moving.cols() == target.cols() && "maps of one shape");
    ProcrustesFit fit;
    fit.turn = Eigen::MatrixXd::Identity(moving.cols(), moving.cols());
    fit.moving_centre = fit.target_centre = Eigen::RowVectorXd::Zero(moving.cols());
    fit.aligned = moving;
    if (moving.size() == 0) return fit;
    fit.moving_centre = moving.colwise().mean();
    fit.target_centre = target.colwise().mean();
    const Eigen::MatrixXd x = moving.rowwise() - fit.moving_centre;
    const Eigen::MatrixXd y = target.rowwise() - fit.target_centre;
    // Each to size 1 first: products of very small or large maps would leave the range of doubles.
    const double x_size = x.stableNorm();
    const double y_size = y.stableNorm();
    // A map whose extent is rounding noise beside its distance from the origin is a point.
    const bool point = x_size <= 1e-14 * moving.stableNorm() || x_size == 0.0 ||
                       y_size <= 1e-14 * target.stableNorm() || y_size == 0.0;
    if (point) {
        fit.aligned = transformed(fit, moving);
        return fit;
    }
    const SingularValues svd = singular_values((x / x_size).transpose() * (y / y_size));
    fit.correlation = std::clamp(svd.values.sum(), 0.0, 1.0);
    const double size = scale ? fit.correlation * y_size : x_size;
    fit.turn = size / x_size * (svd.left * svd.right.transpose());
    fit.aligned = transformed(fit, moving);
    return fit;
}

Eigen::MatrixXd transformed(const ProcrustesFit& fit, const Eigen::MatrixXd& points) {
    return ((points.rowwise() - fit.moving_centre) * fit.turn).rowwise() + fit.target_centre;
}

}  // namespace tact
