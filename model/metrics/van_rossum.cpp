#include "model/metrics/van_rossum.h"

#include <cassert>
#include <cmath>

#include "model/common/portable.h"
#include "model/common/units.h"

namespace tact {

namespace {

// What is left of a tail a sample later.
double decay(const VanRossumParams& params) {
    assert(params.tau_s > 0.0 && "a tail takes time");
    return portable::exp(-1.0 / (kModelRateHz * params.tau_s));
}

std::vector<double> tail(std::vector<double> spikes, double decay) {
    for (std::size_t n = 1; n < spikes.size(); ++n) spikes[n] += decay * spikes[n - 1];
    return spikes;
}

// Between samples f falls: the integral from one to the next is f^2 tau/2 (1 - decay^2), and after
// the last f^2 tau/2.
double squared_distance(const std::vector<double>& x, const std::vector<double>& y, double decay) {
    assert(x.size() == y.size() && "patterns were not padded");
    if (x.empty()) return 0.0;
    double squares = 0.0;
    for (std::size_t n = 0; n < x.size(); ++n) squares += (x[n] - y[n]) * (x[n] - y[n]);
    const double last = (x.back() - y.back()) * (x.back() - y.back());
    return ((1.0 - decay * decay) * squares + decay * decay * last) / 2.0;
}

}  // namespace

SpikeTails spike_tails(const NeuralCode& code, const PerReceptor<double>& channel_weight,
                       const VanRossumParams& params) {
    const double left = decay(params);
    SpikeTails tails;
    if (params.lines == SpikeLines::together) {
        tails.lines.push_back(tail(predicted_brain_waveform(code, channel_weight), left));
        return tails;
    }
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        PerReceptor<double> alone{};
        alone[c] = channel_weight[c];
        tails.lines.push_back(tail(predicted_brain_waveform(code, alone), left));
    }
    return tails;
}

double van_rossum(const SpikeTails& x, const SpikeTails& y, const VanRossumParams& params) {
    assert(x.lines.size() == y.lines.size() && "different lines");
    double squares = 0.0;
    for (std::size_t k = 0; k < x.lines.size(); ++k) {
        squares += squared_distance(x.lines[k], y.lines[k], decay(params));
    }
    return std::sqrt(squares);
}

}  // namespace tact
