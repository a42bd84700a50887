// Procrustes alignment: the rotation, reflection, shift and scale that bring one map onto another.
//
// Source    Schoenemann & Carroll 1970; Gower 1975.
// Left out  weights.
#pragma once

#include <Eigen/Core>

namespace tact {

struct ProcrustesFit {
    Eigen::MatrixXd aligned;   // n x k: the moved map in the target's frame
    double correlation = 0.0;  // r; 1 - r^2 is the residual of a unit-size target
    Eigen::RowVectorXd moving_centre;
    Eigen::RowVectorXd target_centre;
    Eigen::MatrixXd turn;  // k x k: rotation or reflection, times the scale
};

// Aligns `moving` (n x k) to `target` (n x k). With `scale` false, size is kept (a map's size has
// no meaning but changes in it would show). Degenerate maps are only shifted.
ProcrustesFit procrustes(const Eigen::MatrixXd& moving, const Eigen::MatrixXd& target,
                         bool scale = true);

// Other points of the moving map, m x k, in the target's frame: what was fitted on the points that
// two maps have in common moves the rest as well.
Eigen::MatrixXd transformed(const ProcrustesFit& fit, const Eigen::MatrixXd& points);

}  // namespace tact
