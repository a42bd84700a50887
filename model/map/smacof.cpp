#include "model/map/smacof.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "model/dissimilarity/dissimilarity.h"
#include "model/system/pauses.h"

namespace tact {

namespace {

// Points nearer than this share of the mean distance have no direction to be moved in.
constexpr double kNoDistance = 1e-12;

// A map together with what its stress is made of.
//
// An unknown pair is given dhat = b d, the disparity that would leave it where it is: the quadratic
// still lies above the stress of the known pairs, and no weights have to be inverted.
struct Fit {
    Eigen::MatrixXd points;
    std::vector<double> distances;  // of all pairs, condensed
    std::vector<double> fitted;     // disparities; share * distance for unknown pairs
    double stress1 = 0.0;
    double share = 1.0;  // b = sum dhat^2 / sum d^2, the size at which the map suits dhat best
    double size = 0.0;   // sum of dhat^2 over known pairs
};

void measure(const Eigen::MatrixXd& points, std::span<double> result) {
    const Eigen::Index n = points.rows();
    std::ranges::fill(result, 0.0);
    for (Eigen::Index c = 0; c < points.cols(); ++c) {
        const double* x = points.col(c).data();
        double* row = result.data();
        for (Eigen::Index i = 0; i < n; ++i) {
            for (Eigen::Index j = i + 1; j < n; ++j) {
                const double gap = x[i] - x[j];
                row[j - i - 1] += gap * gap;
            }
            row += n - i - 1;
        }
    }
    for (double& value : result) value = std::sqrt(value);
}

// dhat is the projection of d on a cone, of the ordered vectors or of an interval scale, so sum d
// dhat = sum dhat^2 and
//     stress-1^2 = sum (d - dhat)^2 / sum d^2 = 1 - b.
// The first form is kept for the value: 1 - b loses half the digits of a small stress.
void judge(const PairOrder& order, std::span<const double> interval_of, FitScratch& scratch,
           Fit& fit) {
    measure(fit.points, fit.distances);
    if (interval_of.empty()) {
        fit_disparities(order, fit.distances, scratch, fit.fitted);
    } else {
        fit_interval(order, interval_of, fit.distances, fit.fitted);
    }
    double residual = 0.0;
    double size = 0.0;
    fit.size = 0.0;
    const auto add = [&](std::size_t p) {
        const double miss = fit.distances[p] - fit.fitted[p];
        residual += miss * miss;
        size += fit.distances[p] * fit.distances[p];
        fit.size += fit.fitted[p] * fit.fitted[p];
    };
    if (order.unknown.empty()) {
        for (std::size_t p = 0; p < fit.distances.size(); ++p) add(p);  // in order of memory
    } else {
        for (const std::size_t p : order.ascending) add(p);
    }
    fit.stress1 = size > 0.0 ? std::sqrt(residual / size) : 0.0;
    fit.share = size > 0.0 ? fit.size / size : 1.0;
    for (const std::size_t p : order.unknown) fit.fitted[p] = fit.share * fit.distances[p];
}

void guttman(const Fit& fit, std::span<double> ratio, Eigen::MatrixXd& image) {
    const Eigen::Index n = fit.points.rows();
    for (std::size_t p = 0; p < ratio.size(); ++p) {
        ratio[p] = fit.distances[p] > kNoDistance ? fit.fitted[p] / fit.distances[p] : 0.0;
    }
    image.setZero();
    for (Eigen::Index c = 0; c < fit.points.cols(); ++c) {
        const double* x = fit.points.col(c).data();
        double* y = image.col(c).data();
        const double* row = ratio.data();
        for (Eigen::Index i = 0; i < n; ++i) {
            double pull = 0.0;
            for (Eigen::Index j = i + 1; j < n; ++j) {
                const double part = row[j - i - 1] * (x[i] - x[j]);
                pull += part;
                y[j] -= part;
            }
            y[i] += pull;
            row += n - i - 1;
        }
    }
}

// What a step is lengthened by while longer ones are rewarded. A fixed length of 2 halves the
// number of steps of plain SMACOF; this saves as much again where the descent crawls along a
// valley. From 1.3 to 1.5 all take a fifth fewer fits than 1.1 does, failed steps included.
constexpr double kRelaxationGrowth = 1.3;

}  // namespace

std::vector<double> distances(const Eigen::MatrixXd& points) {
    std::vector<double> result(pair_count(static_cast<std::size_t>(points.rows())));
    measure(points, result);
    return result;
}

namespace {

Fit fit_of(const Eigen::MatrixXd& points) {
    const std::size_t pairs = pair_count(static_cast<std::size_t>(points.rows()));
    return {points, std::vector<double>(pairs), std::vector<double>(pairs)};
}

// Steps in a row that gain next to nothing before a descent rests: one may be an accident of its
// length.
constexpr int kSlowSteps = 3;

// With B_ij = -dhat_ij / d_ij, the Guttman transform X' = B X / n never raises stress: it minimises
// a quadratic that lies above the stress and touches it at X. The size of dhat is free and set to
// sum dhat^2 = pairs; then X suits dhat best at size b, and the relaxed step is
//     Y = b X + relaxation (X' - b X).
// X' - b X is the steepest descent of stress, so longer steps often fall further. Relaxation grows
// while they do; when stress would rise, X' itself is taken and relaxation starts again at 1.
// L-BFGS on the same direction was tried: fewer steps below 20 points, but it stalled on some maps
// of 300.
//
// `here` is judged. It, the step and the relaxation are all that a step depends on.
Descent descend_from(Fit here, int step, double relaxation, const PairOrder& order,
                     FitScratch& scratch, const DescentParams& params,
                     const std::stop_token& stop) {
    const double n = static_cast<double>(here.points.rows());
    const double known = static_cast<double>(order.ascending.size());
    if (stop.stop_requested()) return {here.points, here.stress1, step};
    std::vector<double> ratio(here.distances.size());
    Fit there = here;
    Eigen::MatrixXd image = here.points;
    int slow_steps = 0;
    while (step < params.max_steps && here.size > 0.0 && !stop.stop_requested()) {
        if (slow_steps == kSlowSteps) return {here.points, here.stress1, step, relaxation, true};
        ++step;
        pause_if_due();
        const double unit = std::sqrt(known / here.size);
        guttman(here, ratio, image);
        image *= unit / n;
        if (stop.stop_requested()) break;  // a step of millions of pairs takes long
        bool plain = relaxation <= 1.0;
        there.points = unit * here.share * (1.0 - relaxation) * here.points + relaxation * image;
        judge(order, params.interval_of, scratch, there);
        if (!plain && there.stress1 > here.stress1) {
            if (stop.stop_requested()) break;
            plain = true;
            relaxation = 1.0;
            there.points = image;
            judge(order, params.interval_of, scratch, there);
        } else {
            relaxation *= kRelaxationGrowth;
        }
        if (there.stress1 > here.stress1) break;  // rounding: as low as doubles go
        const double fall = here.stress1 - there.stress1;
        std::swap(here, there);
        if (params.watch != nullptr) (*params.watch)(here.points, here.stress1);
        slow_steps = fall < params.rest_at ? slow_steps + 1 : 0;
        if (fall >= params.tolerance) continue;
        // A relaxed step that gains nothing may have jumped across the valley: ask a plain one.
        if (plain) break;
        relaxation = 1.0;
    }
    return {here.points, here.stress1, step};
}

}  // namespace

Descent descend(const PairOrder& order, const Eigen::MatrixXd& start, const DescentParams& params,
                std::stop_token stop) {
    assert(start.allFinite() && "a start of numbers");
    const double known = static_cast<double>(order.ascending.size());
    FitScratch scratch = fit_scratch(order);
    Fit here = fit_of(start);
    assert(known + static_cast<double>(order.unknown.size()) ==
               static_cast<double>(here.distances.size()) &&
           "an order of these points");
    judge(order, params.interval_of, scratch, here);
    if (here.size > 0.0 && !stop.stop_requested()) {
        here.points *= std::sqrt(known * here.share / here.size);
        judge(order, params.interval_of, scratch, here);
    }
    return descend_from(std::move(here), 0, 1.0, order, scratch, params, stop);
}

Descent continued(const PairOrder& order, const Descent& resting, const DescentParams& params,
                  std::stop_token stop) {
    FitScratch scratch = fit_scratch(order);
    Fit here = fit_of(resting.points);
    judge(order, params.interval_of, scratch, here);
    return descend_from(std::move(here), resting.steps, resting.relaxation, order, scratch, params,
                        stop);
}

}  // namespace tact
