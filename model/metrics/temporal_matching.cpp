#include "model/metrics/temporal_matching.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "model/metrics/product_sum.h"
#include "model/signal/waveform.h"

namespace tact {

namespace {

// Norm below which a signal is constant, for signals of norm 1 and less.
constexpr double kConstantNorm = 1e-12;

double signed_as(double product, CorrelationSign sign) {
    return sign == CorrelationSign::dropped ? std::abs(product) : product;
}

// The largest sum of products over all lags that leave an overlap.
double best_product(std::span<const double> x, std::span<const double> y, CorrelationSign sign) {
    double best = signed_as(product_sum(x, y), sign);
    for (std::size_t lag = 1; lag < x.size(); ++lag) {
        const std::size_t overlap = x.size() - lag;
        best = std::max({best, signed_as(product_sum(x.subspan(lag), y.first(overlap)), sign),
                         signed_as(product_sum(y.subspan(lag), x.first(overlap)), sign)});
    }
    return best;
}

}  // namespace

CentredSamples centred_samples(std::span<const double> samples,
                               const TemporalMatchingParams& params) {
    CentredSamples centred;
    centred.samples = params.removes_mean ? without_mean(samples)
                                          : std::vector<double>(samples.begin(), samples.end());
    const double norm = std::sqrt(product_sum(centred.samples, centred.samples));
    const double whole_norm = std::sqrt(product_sum(samples, samples));
    if (norm >= kConstantNorm * std::max(1.0, whole_norm)) {
        centred.energy = product_sum(centred.samples, centred.samples);
    }
    return centred;
}

double temporal_matching(const CentredSamples& x, const CentredSamples& y,
                         const TemporalMatchingParams& params) {
    assert(x.samples.size() == y.samples.size() && "patterns were not padded");
    if (x.energy == 0.0 && y.energy == 0.0) return 0.0;
    if (x.energy == 0.0 || y.energy == 0.0) return 1.0;
    const double product = params.lag == CorrelationLag::best
                               ? best_product(x.samples, y.samples, params.sign)
                               : signed_as(product_sum(x.samples, y.samples), params.sign);
    // Rounding may take r of twins beyond 1.
    return std::clamp(1.0 - product / std::sqrt(x.energy * y.energy), 0.0, 2.0);
}

}  // namespace tact
