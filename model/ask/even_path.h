// The most even way through layers of places: one of each layer, in order, so that the distances
// between neighbours are as alike as can be.
//
// Input     layers of ascending shares of a way; a distance for any two shares of neighbouring
//           layers
// Output    for each layer the index of its place: the way within the tolerance whose shares are
//           spread most evenly; if there is no such way, the one with the smallest ratio of largest
//           to smallest distance
// Valid     distances at least 0
// Exact     same input, same way. Dynamic programming for each distance that could be the smallest
//           one (a bottleneck, then a sum of squares). If there are more than 1,500 distances, only
//           every n-th is tried as the smallest; narrowing makes up for it.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "model/ask/steps.h"
#include "model/morph/morph.h"

namespace tact {

struct EvenPath {
    std::vector<std::size_t> chosen;  // empty: there is no way with all distances above 0
    double ratio = 0.0;               // of the largest distance to the smallest
};

// `distance(layer, i, j)`: of place i of that layer to place j of the next one.
using LayerDistance = std::function<double(std::size_t layer, std::size_t i, std::size_t j)>;

EvenPath even_path(const std::vector<std::vector<double>>& layers, const LayerDistance& distance,
                   double tolerance);

// How far places on the way from one pattern to another are apart, as the model sees them. Private
// to the room.

class PathDistances {
  public:
    PathDistances(const StepsQuestion& question, const StepsOptions& options);

    Pattern at(double share) const;

    // Makes the codes of these places, those not yet known, on several threads. False when stopped.
    bool prepare(const std::vector<double>& shares);

    // Distances of pairs of prepared places, in their order: exact, or with envelopes at 1 kHz for
    // a hundredth of the work. Infinite for some when stopped.
    using Pairs = std::vector<std::pair<double, double>>;
    std::vector<double> of(const Pairs& pairs, bool exact) const;

    // Takes the largest NC and OC of these pairs for 1; the largest OC is that of the pair whose
    // coarse one is largest, exactly. Before that, distances are 0.
    void scale_by(const Pairs& pairs);
    // Takes these for 1.
    void scale_to(double largest_nc, double largest_oc);

    // An NC and an OC as they are scaled.
    double sum_of(double nc, double oc) const { return nc_scale_ * nc + oc_scale_ * oc; }

  private:
    struct Place {
        std::shared_ptr<const PatternCode> code;
        std::vector<double> coarse;  // its envelope
    };
    std::vector<double> nc_of(const Pairs& pairs) const;
    std::vector<double> oc_of(const Pairs& pairs, bool exact) const;

    const StepsQuestion& question_;
    const StepsOptions& options_;
    std::size_t samples_ = 0;
    std::map<double, Place> places_;
    Morph morph_;
    double nc_scale_ = 0.0;
    double oc_scale_ = 0.0;
};

// A first look along the way from one pattern to another. Private to the room.

// The whole way, bisected where it goes far.
struct PathOverview {
    std::vector<double> shares;
    std::vector<double> coarse;  // of all pairs, row by row; the lower half is 0
};

// False when stopped. Distances of the path have their scale from then on.
bool look_over(PathDistances& path, PathOverview& overview);

// All its coarse distances by the scale that the path has now.
void measure(const PathDistances& path, PathOverview& overview);

// Each with the next one.
PathDistances::Pairs neighbours_of(const std::vector<double>& shares);

// Where the way goes farthest at once; none when stopped.
std::optional<PathJump> largest_jump(PathDistances& path, const PathOverview& overview);

}  // namespace tact
