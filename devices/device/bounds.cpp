#include "devices/device/bounds.h"

#include <algorithm>
#include <limits>

namespace tact {

double kept_level(double level, double largest_level) {
    const double asked = level > 0.0 ? std::min(level, 1.0) : 0.0;
    return asked > largest_level ? std::max(0.0, largest_level) : asked;
}

double kept_s(double duration_s, bool loop, double longest_s) {
    const double whole_s = loop ? std::numeric_limits<double>::infinity() : duration_s;
    return longest_s < whole_s ? std::max(0.0, longest_s) : whole_s;
}

}  // namespace tact
