#include "app/model_bench/threshold_shift.h"

#include <algorithm>
#include <cmath>

namespace tact {

namespace {

// What the tables may hold at most.
constexpr double kNothingLog10Um = 6.0;
constexpr double kDbPerLog10 = 20.0;

}  // namespace

std::optional<double> shift_db(const Curve& curve, const Curve& original) {
    if (curve.frequency_hz != original.frequency_hz || curve.value.empty()) return std::nullopt;
    const double first = curve.value[0] - original.value[0];
    for (std::size_t k = 1; k < curve.value.size(); ++k) {
        if (std::abs(curve.value[k] - original.value[k] - first) > 1e-9) return std::nullopt;
    }
    return kDbPerLog10 * first;
}

Curve shifted(const Curve& curve, const Curve& original, double db) {
    const Curve& from = shift_db(curve, original) ? original : curve;
    Curve result = from;
    for (double& value : result.value) {
        value = std::min(value + db / kDbPerLog10, kNothingLog10Um);
    }
    return db == 0.0 ? from : result;
}

Curve removed(const Curve& original) {
    Curve result = original;
    std::ranges::fill(result.value, kNothingLog10Um);
    return result;
}

bool is_removed(const Curve& curve) {
    return std::ranges::all_of(curve.value, [](double v) { return v >= kNothingLog10Um; });
}

}  // namespace tact
