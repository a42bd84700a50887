#include "model/metrics/frequency_balance.h"

#include "model/common/portable.h"

namespace tact {

namespace {

constexpr double kLeastShare = 1e-6;

}  // namespace

double frequency_balance_db(const Spectrum& spectrum) {
    double low = 0.0;
    double high = 0.0;
    for (std::size_t k = 0; k < spectrum.amplitude_g.size(); ++k) {
        const double f_hz = frequency_hz(spectrum, k);
        if (f_hz < kLowestBalanceHz || f_hz > kHighestBalanceHz) continue;
        const double power = spectrum.amplitude_g[k] * spectrum.amplitude_g[k];
        (f_hz < kBalanceSplitHz ? low : high) += power;
    }
    const double least = kLeastShare * (low + high);
    if (!(least > 0.0)) return 0.0;
    return 10.0 * portable::log10((high + least) / (low + least));
}

}  // namespace tact
