#include "model/signal/butterworth.h"

#include <cassert>
#include <cmath>
#include <complex>
#include <numbers>

#include "model/common/portable.h"

namespace tact {

namespace {

using Complex = std::complex<double>;

// Analogue edge whose bilinear image is at `frequency_hz`: w = 2 fs tan(pi f / fs).
double prewarped(double frequency_hz, double rate_hz) {
    return 2.0 * rate_hz * portable::tan(std::numbers::pi * frequency_hz / rate_hz);
}

// Smith 1962. Each library of C++ divides complex numbers in its own way, with other last bits.
Complex quotient(Complex a, Complex b) {
    if (std::abs(b.real()) < std::abs(b.imag())) {
        const double ratio = b.real() / b.imag();
        const double sum = b.real() * ratio + b.imag();
        return {(a.real() * ratio + a.imag()) / sum, (a.imag() * ratio - a.real()) / sum};
    }
    const double ratio = b.imag() / b.real();
    const double sum = b.imag() * ratio + b.real();
    return {(a.imag() * ratio + a.real()) / sum, (a.imag() - a.real() * ratio) / sum};
}

Complex bilinear(Complex s, double rate_hz) {
    return quotient(2.0 * rate_hz + s, 2.0 * rate_hz - s);
}

// Poles of the unit low-pass in the upper half plane, and the real one (-1) of an odd order last:
// the others are their conjugates.
std::vector<Complex> prototype_poles(int order) {
    std::vector<Complex> poles;
    for (int k = 0; k < order / 2; ++k) {
        poles.push_back(
            portable::polar(1.0, std::numbers::pi * (2 * k + 1 + order) / (2.0 * order)));
    }
    if (order % 2 == 1) poles.emplace_back(-1.0, 0.0);
    return poles;
}

Complex response(const Section& section, Complex z_inverse) {
    const Complex z2 = z_inverse * z_inverse;
    return quotient(section.b0 + section.b1 * z_inverse + section.b2 * z2,
                    1.0 + section.a1 * z_inverse + section.a2 * z2);
}

Complex z_inverse_at(double frequency_hz, double rate_hz) {
    return portable::polar(1.0, -2.0 * std::numbers::pi * frequency_hz / rate_hz);
}

// Each section gets gain 1 where the whole filter has it, so none over- or underflows.
void normalise(std::vector<Section>& sections, double frequency_hz, double rate_hz) {
    for (Section& section : sections) {
        const double scale =
            1.0 / portable::abs(response(section, z_inverse_at(frequency_hz, rate_hz)));
        section.b0 *= scale;
        section.b1 *= scale;
        section.b2 *= scale;
    }
}

}  // namespace

std::vector<Section> band_pass(int order, double low_hz, double high_hz, double rate_hz) {
    assert(order >= 1 && low_hz > 0.0 && low_hz < high_hz && high_hz < rate_hz / 2.0);
    const double low = prewarped(low_hz, rate_hz);
    const double high = prewarped(high_hz, rate_hz);
    const double centre = std::sqrt(low * high);
    std::vector<Section> sections;
    // s -> (s^2 + centre^2) / (s (high - low)) sends each prototype pole to two, and puts a zero
    // at z = 1 and one at z = -1 into every section.
    const auto add = [&](Complex z1, Complex z2) {
        sections.push_back({1.0, 0.0, -1.0, -(z1 + z2).real(), (z1 * z2).real()});
    };
    for (const Complex pole : prototype_poles(order)) {
        const Complex middle = pole * (high - low) / 2.0;
        const Complex root = portable::sqrt(middle * middle - centre * centre);
        const Complex first = bilinear(middle + root, rate_hz);
        const Complex second = bilinear(middle - root, rate_hz);
        if (pole.imag() == 0.0) {
            add(first, second);  // a conjugate pair or two real poles
        } else {
            add(first, std::conj(first));
            add(second, std::conj(second));
        }
    }
    const double centre_hz = portable::atan(centre / (2.0 * rate_hz)) * rate_hz / std::numbers::pi;
    normalise(sections, centre_hz, rate_hz);
    return sections;
}

std::vector<Section> low_pass(int order, double edge_hz, double rate_hz) {
    assert(order >= 1 && edge_hz > 0.0 && edge_hz < rate_hz / 2.0);
    const double edge = prewarped(edge_hz, rate_hz);
    std::vector<Section> sections;
    for (const Complex pole : prototype_poles(order)) {
        const Complex z = bilinear(pole * edge, rate_hz);
        if (pole.imag() == 0.0) {
            sections.push_back({1.0, 1.0, 0.0, -z.real(), 0.0});
        } else {
            sections.push_back({1.0, 2.0, 1.0, -2.0 * z.real(), std::norm(z)});
        }
    }
    normalise(sections, 0.0, rate_hz);
    return sections;
}

// Sample by sample through all sections, not section by section: a section waits for its own last
// output, and meanwhile the processor works on the others. The arithmetic of each is the same.
std::vector<double> filtered(std::span<const Section> sections, std::span<const double> signal) {
    struct State {
        double first = 0.0;
        double second = 0.0;
    };
    std::vector<State> states(sections.size());
    std::vector<double> result(signal.begin(), signal.end());
    for (double& sample : result) {
        double value = sample;
        for (std::size_t k = 0; k < sections.size(); ++k) {
            const Section& section = sections[k];
            State& state = states[k];
            const double out = section.b0 * value + state.first;
            state.first = section.b1 * value - section.a1 * out + state.second;
            state.second = section.b2 * value - section.a2 * out;
            value = out;
        }
        sample = value;
    }
    return result;
}

double gain(std::span<const Section> sections, double frequency_hz, double rate_hz) {
    double product = 1.0;
    for (const Section& section : sections) {
        product *= portable::abs(response(section, z_inverse_at(frequency_hz, rate_hz)));
    }
    return product;
}

}  // namespace tact
