// Eigen's decompositions, compiled once: each file that has one of its own takes ten seconds more.
#pragma once

#include <Eigen/Core>

namespace tact {

struct SymmetricEigen {
    Eigen::VectorXd values;   // rising
    Eigen::MatrixXd vectors;  // a column each, of length 1
};

// The matrix is symmetric; only its lower triangle is read.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& symmetric);
Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& symmetric);

// left * values.asDiagonal() * right.transpose()
struct SingularValues {
    Eigen::VectorXd values;  // falling, none negative
    Eigen::MatrixXd left, right;
};

// The matrix is square.
SingularValues singular_values(const Eigen::MatrixXd& square);

// x of a x = b, for a symmetric a that is semi-definite, by L D L'; not finite where a is singular.
Eigen::VectorXd solved_symmetric(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

}  // namespace tact
