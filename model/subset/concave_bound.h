// The largest sum that r of some objects could have, from a concave relaxation.
//
//     sum = C + c'x + 1/2 x'Dx,  x_i = 1 for those taken, else 0, sum of x = r;  as x_i^2 = x_i,
//     s/2 sum (x_i - x_i^2) may be added for any s. With s no less than the largest eigenvalue of D
//     among vectors of zero sum, that is concave over shares 0 <= x_i <= 1, and lies below its
//     tangent at any x: no r objects have more than the tangent's r largest slopes give.
//
// Source    eigenvalue bounds of quadratic 0-1 programs: Hammer & Rubin 1970; tangents of distance
//           sums, which are concave for Euclidean points: Spiers, Bui & Loxton 2023. Shares move
//           two at a time, as in Platt 1998.
// Input     distances of a few thousand objects
// Output    a bound, good to 1e-10 of itself
// Left out  a shift of its own for each object, which gains a tenth of the gap at most.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace tact {

// The shift s of some objects; it also serves for any of them alone.
double concave_shift(const Eigen::MatrixXd& distances, std::span<const std::size_t> objects);

// About how long that takes here, by what a few took once; it cannot be stopped on the way.
double shift_seconds(std::size_t objects);

struct Relaxation {
    std::vector<std::size_t> objects;  // still to choose from, in no order
    std::vector<double> linear;        // c: of each, the sum of its distances to those chosen
    std::vector<double> share;         // x
    std::vector<double> slope;         // of the relaxed sum
    double chosen_sum = 0.0;           // C
    double shift = 0.0;                // s ...
    std::size_t shift_of = 0;          // ... computed for this many objects
};

// `chosen` are taken, of the others none yet.
Relaxation relaxed(const Eigen::MatrixXd& distances, std::span<const std::size_t> chosen,
                   std::span<const std::size_t> objects);

// Computes the shift again for the objects left.
void renew_shift(Relaxation& relaxation, const Eigen::MatrixXd& distances);

// Removes the object at a place: chosen, or left out for good. The last one moves to its place.
void choose(Relaxation& relaxation, const Eigen::MatrixXd& distances, std::size_t place);
void leave_out(Relaxation& relaxation, const Eigen::MatrixXd& distances, std::size_t place);

struct TangentBound {
    double bound = 0.0;
    double value = 0.0;       // of the relaxed sum at the shares
    double last_slope = 0.0;  // the r-th largest ...
    double next_slope = 0.0;  // ... and the one after it
};

// Moves shares towards the largest relaxed sum of r objects, until the bound is below `floor` or
// has little left to fall. 1 <= r <= number of objects.
TangentBound tighten(Relaxation& relaxation, const Eigen::MatrixXd& distances, std::size_t r,
                     double floor);

// What rounding may have taken from a bound.
double slack_of(double bound);

}  // namespace tact
