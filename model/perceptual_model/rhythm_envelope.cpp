#include "model/perceptual_model/rhythm_envelope.h"

#include <algorithm>
#include <cmath>

namespace tact {

std::vector<double> rhythm_envelope(std::span<const double> samples_g,
                                    const EnvelopeParams& params) {
    const std::size_t n = samples_g.size();
    // A centred window looks half its length ahead.
    const std::size_t ahead =
        params.alignment == EnvelopeAlignment::centred ? kEnvelopeSamples / 2 : 0;
    std::vector<double> envelope(n, 0.0);
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t end = std::min(k + ahead + 1, n);
        const std::size_t begin =
            k + ahead + 1 > kEnvelopeSamples ? k + ahead + 1 - kEnvelopeSamples : 0;
        // Summed anew at each sample: a running sum would drift away from silence.
        double sum = 0.0;
        for (std::size_t m = begin; m < end; ++m) sum += std::abs(samples_g[m]);
        envelope[k] = sum / static_cast<double>(kEnvelopeSamples);
    }
    if (params.scale == EnvelopeScale::raw || n == 0) return envelope;
    const double peak = *std::ranges::max_element(envelope);
    if (peak > 0.0) {
        for (double& value : envelope) value /= peak;
    }
    return envelope;
}

std::vector<double> decimated(std::span<const double> envelope, std::size_t factor) {
    std::vector<double> coarse;
    for (std::size_t begin = 0; begin < envelope.size(); begin += factor) {
        const std::size_t end = std::min(begin + factor, envelope.size());
        double sum = 0.0;
        for (std::size_t n = begin; n < end; ++n) sum += envelope[n];
        coarse.push_back(sum / static_cast<double>(end - begin));
    }
    return coarse;
}

}  // namespace tact
