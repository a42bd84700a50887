#include "model/design_space/spectral_lines.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <complex>

#include "model/common/portable.h"
#include "model/physiology/activation.h"

namespace tact {

namespace {

using Phasor = std::complex<double>;  // of g cos(2 pi f t + angle)

constexpr double kEqualHz = 1e-9;

struct PhasorLine {
    double frequency_hz;
    Phasor phasor;
};

void add_line(std::vector<PhasorLine>& lines, double frequency_hz, Phasor phasor) {
    // Below 0 Hz a cosine is the one of its mirrored angle.
    if (frequency_hz < 0.0) phasor = std::conj(phasor);
    lines.push_back({std::abs(frequency_hz), phasor});
}

void add_carrier(std::vector<PhasorLine>& lines, const Carrier& carrier, double amplitude_g,
                 const Modulation& modulation) {
    const auto& [f_hz, weight, phase_rad] = carrier;
    const auto& [kind, by_hz, depth] = modulation;
    const Phasor cosine = portable::polar(amplitude_g * weight, phase_rad);
    const Phasor sine = cosine * Phasor(0.0, -1.0);
    if (by_hz == 0.0) return add_line(lines, f_hz, sine);
    double side = 0.5;
    if (kind == ModulationKind::am) {
        add_line(lines, f_hz, sine);
        side *= depth;
    }
    add_line(lines, f_hz - by_hz, side * cosine);
    add_line(lines, f_hz + by_hz, -side * cosine);
}

}  // namespace

std::vector<SpectralLine> spectral_lines(const Pattern& pattern) {
    assert(!is_drawn(pattern) && "what is drawn has no lines");
    std::vector<PhasorLine> all;
    for (const Carrier& carrier : pattern.carriers) {
        add_carrier(all, carrier, pattern.amplitude_g, pattern.modulation);
    }
    std::ranges::stable_sort(all, {}, &PhasorLine::frequency_hz);
    std::vector<SpectralLine> lines;
    for (std::size_t k = 0; k < all.size();) {
        const double f_hz = all[k].frequency_hz;
        Phasor sum;
        for (; k < all.size() && all[k].frequency_hz - f_hz <= kEqualHz; ++k) sum += all[k].phasor;
        // Lines that cancel leave rounding behind.
        const double floor_g = kFaintestComponentG * (1.0 + pattern.amplitude_g);
        if (f_hz > kEqualHz && portable::abs(sum) > floor_g)
            lines.push_back({f_hz, portable::abs(sum)});
    }
    return lines;
}

double most_displacement_um(const std::vector<SpectralLine>& lines) {
    double sum_um = 0.0;
    for (const SpectralLine& line : lines) {
        sum_um += displacement_um(line.amplitude_g, line.frequency_hz);
    }
    return sum_um;
}

std::optional<double> detectability_db(const std::vector<SpectralLine>& lines,
                                       const PhysiologyTables& tables) {
    std::optional<double> best_db;
    for (const SpectralLine& line : lines) {
        const double f_hz = line.frequency_hz;
        if (f_hz < kLowestComponentHz || f_hz > kHighestComponentHz) continue;
        const double level = portable::log10(displacement_um(line.amplitude_g, f_hz));
        for (const Receptor receptor : kReceptors) {
            const double above_db = 20.0 * (level - at(tables.threshold[index_of(receptor)], f_hz));
            best_db = std::max(best_db.value_or(above_db), above_db);
        }
    }
    return best_db;
}

}  // namespace tact
