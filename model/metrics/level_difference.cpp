#include "model/metrics/level_difference.h"

#include <algorithm>
#include <cmath>

#include "model/common/portable.h"
#include "model/signal/waveform.h"

namespace tact {

namespace {

constexpr double kSilenceG = 1e-6;

}  // namespace

double level_db(std::span<const double> samples_g) {
    Waveform centred;
    centred.samples_g = without_mean(samples_g);
    return 20.0 * portable::log10(std::max(rms_g(centred), kSilenceG));
}

double level_difference(std::span<const double> x_g, std::span<const double> y_g) {
    return std::abs(level_db(x_g) - level_db(y_g));
}

}  // namespace tact
