#include "model/morph/morph_parts.h"

#include <algorithm>
#include <cmath>

#include "model/common/portable.h"

namespace tact {

namespace {

// A jump is told by what holds so shortly before it.
constexpr double kJustBefore = 1e-9;
constexpr double kSameHeight = 1e-6;

}  // namespace

double between(double a, double b, double share, BlendBy by) {
    if (a == b) return a;
    if (by == BlendBy::ratio && a > 0.0 && b > 0.0) return a * portable::pow(b / a, share);
    return (1.0 - share) * a + share * b;
}

std::vector<std::pair<double, double>> blended(const BentLine& a, const BentLine& b, double share,
                                               BlendBy by) {
    std::vector<double> places{0.0, 1.0};
    for (const BentLine* line : {&a, &b}) {
        for (const double bend : line->bends) {
            if (bend > 0.0 && bend < 1.0) places.push_back(bend);
        }
    }
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const auto height = [&](double place) { return between(a.at(place), b.at(place), share, by); };
    std::vector<std::pair<double, double>> line;
    for (const double place : places) {
        const double here = height(place == 1.0 ? 1.0 - kJustBefore : place);
        if (place > 0.0 && place < 1.0) {
            const double before = height(place - kJustBefore);
            const double large = std::max(std::abs(here), std::abs(before));
            if (std::abs(here - before) > kSameHeight * large) line.emplace_back(place, before);
        }
        line.emplace_back(place, here);
    }
    return line;
}

}  // namespace tact
