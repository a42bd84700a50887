#include "app/progress/time_left.h"

#include <cmath>
#include <cstdint>

namespace tact {

namespace {

constexpr double kLeastElapsedS = 2.0;
constexpr double kLeastShare = 0.01;
constexpr double kLeastLeftS = 3.0;

std::string rounded_up(double value, double step, const char* unit) {
    const auto whole = static_cast<std::int64_t>(std::ceil(value / step - 1e-9) * step);
    return "about " + std::to_string(whole) + " " + unit;
}

std::string coarse(double seconds) {
    if (seconds <= 10.0) return rounded_up(seconds, 1.0, "s");
    if (seconds <= 60.0) return rounded_up(seconds, 5.0, "s");
    if (seconds <= 120.0) return rounded_up(seconds, 10.0, "s");
    if (seconds <= 3600.0) return rounded_up(seconds / 60.0, 1.0, "min");
    return rounded_up(seconds / 3600.0, 1.0, "h");
}

}  // namespace

std::string time_left_text(double elapsed_s, double share) {
    if (!(elapsed_s >= kLeastElapsedS) || !(share >= kLeastShare) || share >= 1.0) return {};
    const double left_s = elapsed_s * (1.0 - share) / share;
    if (left_s < kLeastLeftS) return {};
    return coarse(left_s) + " left";
}

std::string estimate_text(double seconds) {
    return seconds < 1.0 ? "less than 1 s" : coarse(seconds);
}

}  // namespace tact
