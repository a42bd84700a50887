#include "model/common/decompositions.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <cassert>

namespace tact {

using Eigen::MatrixXd;
using Eigen::VectorXd;

SymmetricEigen symmetric_eigen(const MatrixXd& symmetric) {
    const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(symmetric);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

VectorXd symmetric_eigenvalues(const MatrixXd& symmetric) {
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

SingularValues singular_values(const MatrixXd& square) {
    assert(square.rows() == square.cols());
    const Eigen::JacobiSVD<MatrixXd, Eigen::NoQRPreconditioner> svd(
        square, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return {svd.singularValues(), svd.matrixU(), svd.matrixV()};
}

VectorXd solved_symmetric(const MatrixXd& a, const VectorXd& b) { return a.ldlt().solve(b); }

}  // namespace tact
