#include "model/metrics/band_levels.h"

#include <algorithm>
#include <cmath>

#include "model/common/portable.h"
#include "model/common/units.h"

namespace tact {

namespace {

// The band of a frequency; kBandCount outside all of them.
std::size_t band_of(double f_hz) {
    if (f_hz < kLowestBandHz || f_hz > kHighestBandHz) return kBandCount;
    std::size_t band = 0;
    for (; band + 1 < kBandCount; ++band) {
        const double share = static_cast<double>(band + 1) / static_cast<double>(kBandCount);
        if (f_hz < kLowestBandHz * portable::pow(kHighestBandHz / kLowestBandHz, share)) break;
    }
    return band;
}

double lowest_threshold_um(const PhysiologyTables& tables, double f_hz) {
    double lowest = at(tables.threshold[0], f_hz);
    for (const Curve& curve : tables.threshold) lowest = std::min(lowest, at(curve, f_hz));
    return portable::pow(10.0, lowest);
}

}  // namespace

BandLevels band_levels_db(const Spectrum& spectrum, const PhysiologyTables& tables) {
    BandLevels power{};
    for (std::size_t k = 0; k < spectrum.amplitude_g.size(); ++k) {
        const double f_hz = frequency_hz(spectrum, k);
        const std::size_t band = band_of(f_hz);
        if (band == kBandCount) continue;
        const double ratio =
            displacement_um(spectrum.amplitude_g[k], f_hz) / lowest_threshold_um(tables, f_hz);
        power[band] += ratio * ratio;
    }
    for (double& level : power) level = 10.0 * portable::log10(std::max(level, 1.0));
    return power;
}

double band_distance(const BandLevels& x_db, const BandLevels& y_db) {
    double squares = 0.0;
    for (std::size_t b = 0; b < kBandCount; ++b) {
        squares += (x_db[b] - y_db[b]) * (x_db[b] - y_db[b]);
    }
    return std::sqrt(squares);
}

}  // namespace tact
