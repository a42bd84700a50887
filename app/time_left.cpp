#include "app/time_left.h"

#include <cmath>

namespace tact {

namespace {

constexpr double kLeastElapsedS = 2.0;
constexpr double kLeastShare = 0.01;
constexpr double kLeastLeftS = 3.0;

std::string rounded_up(double value, double step, const char* unit) {
    const auto whole = static_cast<long>(std::ceil(value / step - 1e-9) * step);
    return "about " + std::to_string(whole) + " " + unit + " left";
}

}  // namespace

std::string time_left_text(double elapsed_s, double share) {
    if (!(elapsed_s >= kLeastElapsedS) || !(share >= kLeastShare) || share >= 1.0) return {};
    const double left_s = elapsed_s * (1.0 - share) / share;
    if (left_s < kLeastLeftS) return {};
    if (left_s <= 10.0) return rounded_up(left_s, 1.0, "s");
    if (left_s <= 60.0) return rounded_up(left_s, 5.0, "s");
    if (left_s <= 3600.0) return rounded_up(left_s / 60.0, 1.0, "min");
    return rounded_up(left_s / 3600.0, 1.0, "h");
}

}  // namespace tact
