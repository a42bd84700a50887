#include "model/map/alienation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "model/common/decompositions.h"
#include "model/common/parallel.h"
#include "model/common/random.h"
#include "model/map/procrustes.h"
#include "model/map/smacof.h"

namespace tact {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// To length 1; false of nothing.
bool normalise(std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    if (!(largest > 0.0) || !std::isfinite(largest)) return false;
    double sum = 0.0;
    for (double& value : values) {
        value /= largest;
        sum += value * value;
    }
    for (double& value : values) value /= std::sqrt(sum);
    return true;
}

// sqrt(1 - c^2) of unit vectors as the length of what one lacks of the other: near 0, the formula
// itself would leave nothing but rounding.
double unlikeness(std::span<const double> a, std::span<const double> b) {
    const double c = std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
    double sum = 0.0;
    for (std::size_t p = 0; p < a.size(); ++p) sum += (a[p] - c * b[p]) * (a[p] - c * b[p]);
    return std::min(std::sqrt(sum), 1.0);
}

Expected<std::vector<double>> unit_distances(const MatrixXd& points) {
    if (points.rows() < 3) {
        return Error{"alienation: expected at least three points, got " +
                     std::to_string(points.rows())};
    }
    if (!points.allFinite()) return Error{"alienation: expected finite coordinates"};
    const MatrixXd centred = points.rowwise() - points.colwise().mean();
    // An extent that is rounding noise beside the distance from the origin counts as 0.
    const double extent = centred.cwiseAbs().maxCoeff();
    if (extent <= 1e-14 * points.cwiseAbs().maxCoeff()) {
        return Error{"alienation: expected points that differ, got all on one spot"};
    }
    std::vector<double> d = distances(centred / extent);  // whose squares are in range
    normalise(d);
    return d;
}

struct Shapes {
    std::vector<double> a;  // distances, of length 1
    std::vector<double> b;
};

Expected<Shapes> shapes_of(const MatrixXd& a, const MatrixXd& b) {
    if (a.rows() != b.rows()) {
        return Error{"alienation: expected maps of equally many points, got " +
                     std::to_string(a.rows()) + " and " + std::to_string(b.rows())};
    }
    auto first = unit_distances(a);
    if (!first) return first.error();
    auto second = unit_distances(b);
    if (!second) return second.error();
    return Shapes{*std::move(first), *std::move(second)};
}

// With columns of zeros: the same shape among more dimensions.
MatrixXd widened(const MatrixXd& points, Index columns) {
    MatrixXd result = MatrixXd::Zero(points.rows(), columns);
    result.leftCols(points.cols()) = points;
    return result;
}

// Centred, with a sum of squares of 1, of points that differ.
MatrixXd of_unit_size(const MatrixXd& points) {
    const MatrixXd centred = points.rowwise() - points.colwise().mean();
    return centred / centred.stableNorm();
}

MatrixXd gaussian_points(Index n, Index k, RandomStream& random) {
    MatrixXd points(n, k);
    for (Index e = 0; e < points.size(); ++e) points.data()[e] = next_normal(random);
    return points;
}

}  // namespace

Expected<double> alienation(const MatrixXd& a, const MatrixXd& b) {
    const auto shapes = shapes_of(a, b);
    if (!shapes) return shapes.error();
    return unlikeness(shapes->a, shapes->b);
}

Expected<double> alienation_procrustes(const MatrixXd& a, const MatrixXd& b) {
    if (const auto shapes = shapes_of(a, b); !shapes) return shapes.error();
    const Index columns = std::max(a.cols(), b.cols());
    const double r = procrustes(widened(a, columns), widened(b, columns)).correlation;
    return std::sqrt((1.0 - r) * (1.0 + r));
}

Expected<PermutationTest> protest(const MatrixXd& a, const MatrixXd& b,
                                  const PermutationParams& params) {
    if (const auto shapes = shapes_of(a, b); !shapes) return shapes.error();
    const Index columns = std::max(a.cols(), b.cols());
    const MatrixXd fixed = of_unit_size(widened(a, columns)).transpose();
    const MatrixXd moved = of_unit_size(widened(b, columns));
    // The correlation after alignment (procrustes.cpp); sizes do not change with the names.
    const auto fit = [&fixed](const MatrixXd& points) {
        return singular_values(fixed * points).values.sum();
    };
    const double observed = fit(moved);
    constexpr double kRounding = 1e-12;
    return permutation_test(static_cast<std::size_t>(a.rows()), params,
                            [&](std::span<const std::size_t> order) {
                                MatrixXd points(moved.rows(), columns);
                                for (Index i = 0; i < points.rows(); ++i) {
                                    const std::size_t from = order[static_cast<std::size_t>(i)];
                                    points.row(i) = moved.row(static_cast<Index>(from));
                                }
                                return fit(points) >= observed - kRounding;
                            });
}

double alienation_of_fit(std::span<const double> distances, std::span<const double> disparities) {
    std::vector<double> d;
    std::vector<double> fitted;
    for (std::size_t p = 0; p < distances.size(); ++p) {
        if (std::isnan(disparities[p])) continue;
        d.push_back(distances[p]);
        fitted.push_back(disparities[p]);
    }
    return normalise(d) && normalise(fitted) ? unlikeness(d, fitted) : 0.0;
}

AlienationChance chance_alienation(std::size_t points, int dimensions,
                                   const AlienationChanceParams& params) {
    if (points < 3 || params.draws == 0) return {};
    const auto n = static_cast<Index>(points);
    const Index k = std::max(dimensions, 1);
    std::vector<double> values(params.draws);
    parallel_for(params.draws, params.threads, {}, [&](std::size_t draw) {
        RandomStream random{random_bits(params.seed, draw)};
        const MatrixXd a = gaussian_points(n, k, random);
        const MatrixXd b = gaussian_points(n, k, random);
        const auto value = alienation(a, b);
        values[draw] = value ? *value : 1.0;  // equal random points: as good as never
    });
    std::ranges::sort(values);
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return {sum / static_cast<double>(values.size()),
            {quantile(values, 0.05), quantile(values, 0.95)}};
}

double corrected_alienation(double alienation, const AlienationChance& chance) {
    return chance.mean > 0.0 ? 1.0 - alienation / chance.mean : 0.0;
}

Expected<PermutationTest> alienation_test(const MatrixXd& a, const MatrixXd& b,
                                          const PermutationParams& params) {
    const auto shapes = shapes_of(a, b);
    if (!shapes) return shapes.error();
    const MatrixXd square = square_of({static_cast<std::size_t>(b.rows()), shapes->b});
    // K falls as the product of the distances grows.
    const double observed =
        std::inner_product(shapes->a.begin(), shapes->a.end(), shapes->b.begin(), 0.0);
    constexpr double kRounding = 1e-12;
    return permutation_test(
        static_cast<std::size_t>(a.rows()), params, [&](std::span<const std::size_t> order) {
            return permuted_product(shapes->a, square, order) >= observed - kRounding;
        });
}

}  // namespace tact
