// One descent of stress-1 from one start, by majorisation.
//
// Source    de Leeuw 1977 (SMACOF); de Leeuw & Heiser 1980 (relaxed step); Salakhutdinov & Roweis
//           2003 (adaptive over-relaxation with a fall-back).
// Input     order of the pairs, a finite start (n x k) that is not one point
// Output    points of a local minimum, sum of squared distances about one per pair
// Left out  global search (see mds.h), weights.
// Exact     same input, same bits: every sum runs in one fixed order.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <stop_token>
#include <vector>

#include "model/map/isotonic.h"

namespace tact {

struct DescentParams {
    double tolerance = 1e-10;  // stop when stress-1 falls by less in a step
    int max_steps = 3000;
    // Not empty: disparities by interval scaling of these dissimilarities, a value a pair; the
    // stress is of that, too.
    std::span<const double> interval_of{};
    // Above 0: the descent rests once several steps in a row have each gained less than this.
    double rest_at = 0.0;
    // Gets points and stress-1 after every step; null: nobody does.
    const std::function<void(const Eigen::MatrixXd&, double)>* watch = nullptr;
};

struct Descent {
    Eigen::MatrixXd points;  // n x k
    double stress1 = 0.0;
    int steps = 0;
    double relaxation = 1.0;  // of the next step
    bool rests = false;       // it is not at its end
};

// Stress never rises from step to step; a descent that is stopped returns where it has come to.
Descent descend(const PairOrder& order, const Eigen::MatrixXd& start, const DescentParams& params,
                std::stop_token stop = {});

// Continues one that rests, of the same order: in the end it has the bits of one that did not rest.
Descent continued(const PairOrder& order, const Descent& resting, const DescentParams& params,
                  std::stop_token stop = {});

// Euclidean distances between the rows of an n x k matrix, condensed.
std::vector<double> distances(const Eigen::MatrixXd& points);

}  // namespace tact
