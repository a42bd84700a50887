#include "model/map/explained_share.h"

#include <cassert>
#include <cmath>
#include <vector>

namespace tact {

double explained_share(const Eigen::MatrixXd& places, std::span<const double> values) {
    assert(static_cast<std::size_t>(places.rows()) == values.size() && "a value for each place");
    std::vector<Eigen::Index> rows;
    for (Eigen::Index k = 0; k < places.rows(); ++k) {
        if (places.row(k).allFinite() && std::isfinite(values[static_cast<std::size_t>(k)])) {
            rows.push_back(k);
        }
    }
    if (rows.size() < 3) return 0.0;
    const auto count = static_cast<double>(rows.size());
    Eigen::RowVectorXd middle = Eigen::RowVectorXd::Zero(places.cols());
    double mean = 0.0;
    for (const Eigen::Index k : rows) {
        middle += places.row(k) / count;
        mean += values[static_cast<std::size_t>(k)] / count;
    }
    Eigen::RowVectorXd along = Eigen::RowVectorXd::Zero(places.cols());
    double spread = 0.0;
    double all = 0.0;
    for (const Eigen::Index k : rows) {
        const Eigen::RowVectorXd off = places.row(k) - middle;
        const double value = values[static_cast<std::size_t>(k)] - mean;
        along += value * off;
        spread += value * value;
        all += off.squaredNorm();
    }
    constexpr double kNothing = 1e-12;  // of rounding, beside squares of the mean
    if (!(spread > kNothing * count * mean * mean) || !(all > 0.0)) return 0.0;
    return along.squaredNorm() / (spread * all);
}

}  // namespace tact
