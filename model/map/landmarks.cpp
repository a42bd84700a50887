#include "model/map/landmarks.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/map/mds.h"

namespace tact {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Pairs by their objects, in units of the largest, so that no square overflows.
class Scaled {
  public:
    explicit Scaled(const Dissimilarity& all) : all_(all) {
        double sum = 0.0;
        std::size_t known = 0;
        for (const double value : all.condensed) {
            if (std::isnan(value)) continue;
            unit_ = std::max(unit_, value);
            sum += value;
            ++known;
        }
        mean_ = known > 0 ? sum / static_cast<double>(known) : 0.0;
    }

    double unit() const { return unit_ > 0.0 ? unit_ : 1.0; }

    double operator()(std::size_t i, std::size_t j) const {
        const double value = all_(i, j);
        return (std::isnan(value) ? mean_ : value) / unit();
    }

  private:
    const Dissimilarity& all_;
    double unit_ = 0.0;
    double mean_ = 0.0;
};

Dissimilarity among(const Scaled& scaled, const std::vector<std::size_t>& chosen) {
    Dissimilarity some;
    some.size = chosen.size();
    some.condensed.reserve(pair_count(chosen.size()));
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        for (std::size_t j = i + 1; j < chosen.size(); ++j) {
            some.condensed.push_back(scaled(chosen[i], chosen[j]));
        }
    }
    return some;
}

}  // namespace

MatrixXd landmark_scaling(const Dissimilarity& dissimilarity, int dimensions,
                          std::size_t landmarks) {
    const std::size_t n = dissimilarity.size;
    if (n <= landmarks) return torgerson(dissimilarity, dimensions);
    const Scaled scaled(dissimilarity);
    std::vector<std::size_t> chosen(landmarks);
    for (std::size_t k = 0; k < landmarks; ++k) chosen[k] = k * n / landmarks;
    const MatrixXd own = torgerson(among(scaled, chosen), dimensions);

    const auto squares_to = [&](std::size_t object) {
        VectorXd squares(static_cast<Index>(landmarks));
        for (std::size_t k = 0; k < landmarks; ++k) {
            const double value = scaled(object, chosen[k]);
            squares(static_cast<Index>(k)) = value * value;
        }
        return squares;
    };
    VectorXd mean = VectorXd::Zero(static_cast<Index>(landmarks));
    for (const std::size_t one : chosen) mean += squares_to(one);
    mean /= static_cast<double>(landmarks);

    // Each axis of the landmarks, by the square of its length.
    MatrixXd axes = own;
    for (Index d = 0; d < axes.cols(); ++d) {
        const double square = axes.col(d).squaredNorm();
        if (square > 0.0) axes.col(d) /= square;
    }
    MatrixXd points(static_cast<Index>(n), axes.cols());
    for (std::size_t k = 0; k < n; ++k) {
        points.row(static_cast<Index>(k)) =
            -0.5 * (squares_to(k) - mean).transpose() * axes * scaled.unit();
    }
    return points;
}

}  // namespace tact
