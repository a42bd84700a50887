#include "model/physiology/activation.h"

#include <algorithm>
#include <cmath>

#include "model/common/portable.h"
#include "model/common/units.h"
#include "model/physiology/log_curve.h"

namespace tact {

namespace {

bool is_peak(const std::vector<double>& amplitude, std::size_t k) {
    const double above = k + 1 < amplitude.size() ? amplitude[k + 1] : 0.0;
    return amplitude[k] >= amplitude[k - 1] && amplitude[k] > above;
}

// Also sets the distance of the farthest firing receptor.
Activation with_radius(Activation summed) {
    if (summed.rate_hz <= 0.0 || summed.slope_sum <= 0.0) return {};
    summed.radius_mm = std::min(
        kFingertipMm, kHotZoneMm * portable::pow(10.0, summed.rate_hz / (2.0 * summed.slope_sum)));
    return summed;
}

}  // namespace

std::vector<Component> components(const Spectrum& spectrum, const NeuralCodingParams& params) {
    std::vector<Component> result;
    double largest_g = 0.0;
    for (std::size_t k = 1; k < spectrum.amplitude_g.size(); ++k) {
        const double bin_hz = frequency_hz(spectrum, k);
        const double amplitude_g = spectrum.amplitude_g[k];
        if (bin_hz < kLowestComponentHz || bin_hz > kHighestComponentHz) continue;
        largest_g = std::max(largest_g, amplitude_g);
        if (amplitude_g <= kFaintestComponentG) continue;
        if (params.components == Components::peaks && !is_peak(spectrum.amplitude_g, k)) continue;
        const double skin_um = params.skin_input == SkinInput::displacement
                                   ? displacement_um(amplitude_g, bin_hz)
                                   : amplitude_g;
        result.push_back({bin_hz, amplitude_g, skin_um});
    }
    if (params.components == Components::peaks) {
        std::erase_if(result, [&](const Component& component) {
            return component.amplitude_g < params.peak_fraction * largest_g;
        });
    }
    return result;
}

PerReceptor<Activation> activations(const std::vector<Component>& components,
                                    const NeuralCodingParams& params) {
    PerReceptor<Activation> result;
    PerReceptor<LogCurve> slopes;
    PerReceptor<LogCurve> thresholds;
    for (std::size_t c = 0; c < kReceptorCount; ++c) {
        slopes[c] = log_curve(params.tables.slope[c]);
        thresholds[c] = log_curve(params.tables.threshold[c]);
    }
    for (const Component& component : components) {
        const double level = portable::log10(component.skin_um);
        const LogFrequency frequency = log_frequency(component.frequency_hz);
        for (std::size_t c = 0; c < kReceptorCount; ++c) {
            const double above = level - at(thresholds[c], frequency);
            if (above <= 0.0 && params.subthreshold == Subthreshold::ignored) continue;
            const double alpha = at(slopes[c], frequency);
            result[c].rate_hz += alpha * above;
            result[c].slope_sum += alpha;
        }
    }
    for (Activation& one : result) one = with_radius(one);
    return result;
}

double rate_at_hz(const Activation& activation, double distance_mm) {
    if (distance_mm <= kHotZoneMm) return activation.rate_hz;
    const double fall = 2.0 * activation.slope_sum * portable::log10(distance_mm / kHotZoneMm);
    return std::max(0.0, activation.rate_hz - fall);
}

}  // namespace tact
