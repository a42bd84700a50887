#include "model/map/map_scale.h"

#include <cmath>

namespace tact {

double length_of_one(const Eigen::MatrixXd& places, const Dissimilarity& dissimilarity) {
    if (static_cast<std::size_t>(places.rows()) != dissimilarity.size) return 0.0;
    double both = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < dissimilarity.size; ++i) {
        const auto place = places.row(static_cast<Eigen::Index>(i));
        for (std::size_t j = i + 1; j < dissimilarity.size; ++j) {
            const double value = dissimilarity(i, j);
            const double distance = (place - places.row(static_cast<Eigen::Index>(j))).norm();
            if (!std::isfinite(value) || !std::isfinite(distance)) continue;
            both += value * distance;
            squares += value * value;
        }
    }
    return squares > 0.0 ? both / squares : 0.0;
}

}  // namespace tact
