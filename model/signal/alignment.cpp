#include "model/signal/alignment.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>

#include "model/common/portable.h"
#include "model/signal/spectrum.h"

namespace tact {

namespace {

using Samples = std::vector<double>;

// c[l mod N] = sum_n recording[n + l] intended[n] for every lag l; N has room for all of them.
Samples cross_correlation(const Samples& recording, const Samples& intended) {
    const std::size_t count = std::bit_ceil(recording.size() + intended.size());
    const auto spectrum_of = [count](Samples samples) {
        samples.resize(count, 0.0);
        return half_spectrum(samples);
    };
    std::vector<std::complex<double>> product = spectrum_of(recording);
    const std::vector<std::complex<double>> other = spectrum_of(intended);
    for (std::size_t k = 0; k < product.size(); ++k) product[k] *= std::conj(other[k]);
    return samples_of(product, count);
}

std::ptrdiff_t best_lag(const Samples& recording, const Samples& intended) {
    // Lags of a steady tone differ by rounding only.
    constexpr double kEqual = 1.0 - 1e-9;
    const Samples correlation = cross_correlation(recording, intended);
    double most = 0.0;
    for (const double value : correlation) most = std::max(most, std::abs(value));
    if (most == 0.0) return 0;
    const auto count = static_cast<std::ptrdiff_t>(correlation.size());
    const auto is_best = [&](std::ptrdiff_t lag) {
        const auto place = static_cast<std::size_t>(lag < 0 ? lag + count : lag);
        return std::abs(correlation[place]) >= kEqual * most;
    };
    const auto last = static_cast<std::ptrdiff_t>(std::max(recording.size(), intended.size()));
    for (std::ptrdiff_t lag = 0; lag < last; ++lag) {
        if (lag < static_cast<std::ptrdiff_t>(recording.size()) && is_best(lag)) return lag;
        if (lag < static_cast<std::ptrdiff_t>(intended.size()) && is_best(-lag)) return -lag;
    }
    return 0;
}

double likeness(const Samples& a, const Samples& b) {
    double product = 0.0;
    double energy_a = 0.0;
    double energy_b = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) {
        product += a[n] * b[n];
        energy_a += a[n] * a[n];
        energy_b += b[n] * b[n];
    }
    const double scale = std::sqrt(energy_a) * std::sqrt(energy_b);
    return scale > 0.0 ? std::min(std::abs(product) / scale, 1.0) : 0.0;
}

// The factor that makes b most like a, dB.
double gain_db_of(const Samples& a, const Samples& b) {
    double product = 0.0;
    double energy = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) {
        product += a[n] * b[n];
        energy += b[n] * b[n];
    }
    const double factor = energy > 0.0 ? std::abs(product) / energy : 0.0;
    return factor > 0.0 ? 20.0 * portable::log10(factor) : 0.0;
}

std::string silence_text(std::size_t samples, double rate_hz, const char* where) {
    char text[96];
    std::snprintf(text, sizeof text, "%.3g s of silence added at its %s: the recording is shorter",
                  static_cast<double>(samples) / rate_hz, where);
    return text;
}

}  // namespace

Alignment aligned(const Waveform& recording, const Waveform& intended) {
    assert(recording.rate_hz == intended.rate_hz && "expected one rate");
    const Samples& from = recording.samples_g;
    const std::size_t count = intended.samples_g.size();
    Alignment result;
    result.waveform = {intended.rate_hz, Samples(count, 0.0)};
    if (from.empty() || count == 0) {
        result.missing_after = count;
        return result;
    }
    result.lag = best_lag(from, intended.samples_g);
    const auto have = static_cast<std::ptrdiff_t>(from.size());
    const auto want = static_cast<std::ptrdiff_t>(count);
    const std::ptrdiff_t begin = std::clamp<std::ptrdiff_t>(-result.lag, 0, want);
    const std::ptrdiff_t end = std::clamp<std::ptrdiff_t>(have - result.lag, begin, want);
    std::copy(from.begin() + begin + result.lag, from.begin() + end + result.lag,
              result.waveform.samples_g.begin() + begin);
    result.missing_before = static_cast<std::size_t>(begin);
    result.missing_after = static_cast<std::size_t>(want - end);
    result.correlation = likeness(result.waveform.samples_g, intended.samples_g);
    result.gain_db = gain_db_of(result.waveform.samples_g, intended.samples_g);
    return result;
}

std::vector<std::string> remarks_on(const Alignment& alignment) {
    std::vector<std::string> remarks;
    const double rate_hz = alignment.waveform.rate_hz;
    if (alignment.missing_before > 0) {
        remarks.push_back(silence_text(alignment.missing_before, rate_hz, "start"));
    }
    if (alignment.missing_after > 0) {
        remarks.push_back(silence_text(alignment.missing_after, rate_hz, "end"));
    }
    if (alignment.correlation >= kLeastAlike && std::abs(alignment.gain_db) > kMostGainDb) {
        char text[96];
        std::snprintf(text, sizeof text, "%.1f dB %s than its pattern: are unit and scale right?",
                      std::abs(alignment.gain_db), alignment.gain_db > 0.0 ? "stronger" : "weaker");
        remarks.emplace_back(text);
    }
    if (alignment.correlation < kLeastAlike) {
        char text[96];
        std::snprintf(text, sizeof text,
                      "hardly like its pattern (correlation %.2f): is it another one's?",
                      alignment.correlation);
        remarks.emplace_back(text);
    }
    return remarks;
}

}  // namespace tact
