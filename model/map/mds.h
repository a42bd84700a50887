// Non-metric multidimensional scaling: points whose distances have the order of dissimilarities.
//
// Source    Kruskal 1964 (stress-1, primary ties); de Leeuw 1977, de Leeuw & Mair 2009 (SMACOF);
//           Torgerson 1952 (classical start; of many objects by landmarks, landmarks.h).
// Input     a dissimilarity matrix; NaN pairs are ignored
// Output    coordinates, centred, on principal axes, mean squared distance 1, with stress-1
// Left out  ratio scaling, secondary ties, weights, individual differences.
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <stop_token>
#include <string>
#include <vector>

#include "model/dissimilarity/dissimilarity.h"
#include "model/map/isotonic.h"
#include "model/map/smacof.h"

namespace tact {

// What Eigen takes the processor's caches for: the blocks of its products decide their last bits.
inline constexpr std::array<std::ptrdiff_t, 3> kBlockCacheBytes{32'768, 262'144, 2'097'152};

struct MdsParams {
    int dimensions = 3;
    int random_starts = 100;  // besides the classical one
    // How often at most a badly placed point of the best map is tried on the other side.
    int turned_points = 0;
    std::uint64_t seed = 1;
    double tolerance = 1e-10;  // stop when stress-1 falls by less in a step
    int max_steps = 3000;
    // smacof(): distances are to be a constant and a multiple of the dissimilarities.
    bool is_interval = false;
    int threads = 0;  // 0: all cores

    bool operator==(const MdsParams&) const = default;
};

// Why a map says nothing, or nothing much.
enum class MdsVerdict {
    fine,
    trivial,   // n <= k + 1: any dissimilarities fit
    constant,  // all dissimilarities equal: any map fits; none is made
    too_few,   // fewer than two objects
    colocated  // different objects fell onto one point
};

struct PerceptualSpace {
    Eigen::MatrixXd points;  // n x k
    double stress1 = 0.0;
    MdsVerdict verdict = MdsVerdict::fine;
    // Where every start that was run came to rest, the classical first: the few lowest then descend
    // to their ends.
    std::vector<double> start_stress;
    bool stopped = false;  // a stop was asked for before the last start
    // Stress says nothing although it is near 0: groups collapsed onto points (Kruskal 1964 names
    // this trap), or there are so few patterns (2k + 1 at most) that nearly any order fits.
    bool is_degenerate = false;
    // Distances go by the size of dissimilarities, as groups collapse in the best map by their
    // order; the stress-1 of that is here, NaN where it was not searched for.
    bool is_interval = false;
    double collapsed_stress1 = std::numeric_limits<double>::quiet_NaN();
};

// Classical scaling: n x k coordinates, columns of vanished eigenvalues zero. NaN pairs count as
// the mean of the others.
Eigen::MatrixXd torgerson(const Dissimilarity& dissimilarity, int dimensions);

// The index-th random start of a seed, from 1 on: n x k, even in the cube [-1, 1)^k.
Eigen::MatrixXd random_start(Eigen::Index n, Eigen::Index k, std::uint64_t seed, std::size_t index);

// SMACOF from one start; stress never rises from step to step. A start of another shape, with NaN,
// or with all points in one place is replaced by Torgerson's.
PerceptualSpace smacof(const Dissimilarity& dissimilarity, const Eigen::MatrixXd& start,
                       const MdsParams& params, std::stop_token stop = {});

// The best of the classical and the random starts, of equals the first; then with the points turned
// that make it better. Starts descend until steps gain next to nothing, and the lowest of them to
// their ends: the others would end above. Where groups collapse in that, the best by interval
// scaling, whose distances are a constant and a multiple of the dissimilarities (Borg & Groenen
// 2005, 13.3: a stronger model in place of a degenerate one), unless they collapse in that too.
// `progress` gets the number of starts done, `lower` the points of every step that comes below all
// before it: both from any thread but never from two at once.
PerceptualSpace nonmetric_mds(const Dissimilarity& dissimilarity, const MdsParams& params,
                              std::stop_token stop = {},
                              const std::function<void(std::size_t)>& progress = {},
                              const std::function<void(const Eigen::MatrixXd&)>& lower = {});

// Why the map says nothing, or nothing much, and what to do: a sentence without a full stop, or
// empty.
std::string remark_on(const PerceptualSpace& space);

// "degenerate", or the word of Kruskal's scale.
std::string fit_label(const PerceptualSpace& space);

// The publication's own procedure, by which its K were made: MATLAB's mdscale with its defaults,
// one descent from Torgerson's start that stops at 1e-4 or after 200 steps. It stops before groups
// collapse where a thorough search finds the degenerate map.
MdsParams published_mds_params(int dimensions);

// What this program runs by default for n objects: a hundred random starts for small sets, fewer
// as a start gets dearer. Window and command line agree by it.
MdsParams standard_mds_params(std::size_t objects, int dimensions);

}  // namespace tact
