#include "model/morph/pad.h"

#include <cassert>

#include "model/morph/morph.h"

namespace tact {

Pattern mixed_among(const std::vector<Pattern>& corners, double right, double down) {
    assert(!corners.empty() && corners.size() <= kMostCorners && "a pad has one to four corners");
    const Pattern upper = corners.size() > 1 ? morphed(corners[0], corners[1], right) : corners[0];
    if (corners.size() < 3) return upper;
    const Pattern lower = corners.size() > 3 ? morphed(corners[2], corners[3], right) : corners[2];
    return morphed(upper, lower, down);
}

}  // namespace tact
