// Amplitude spectrum of a whole signal; the only room that knows FFTW.
//
// Input     samples in g at a rate; no window, no padding
// Output    one-sided peak amplitudes: a sine of 1 g on a bin gives 1 g there
// Valid     1 sample and more
// Left out  averaging, leakage correction.
// Exact     one plan per length, made without measuring, from our own sines: same bits in every run
//           and thread, on any instruction set.
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace tact {

struct Spectrum {
    double rate_hz = 1.0;
    std::size_t samples = 1;          // N
    std::vector<double> amplitude_g;  // k = 0 .. floor(N/2)
};

// k rate / N, in this order: a multiple of a rounded rate / N can miss a band edge.
double frequency_hz(const Spectrum& spectrum, std::size_t k);

// X[k] = sum_n x[n] exp(-2 pi i k n / N), k = 0 .. floor(N/2): the half that real samples need.
std::vector<std::complex<double>> half_spectrum(std::span<const double> samples);

// The N real samples of such a half, its inverse with 1/N. X[0] and, N even, X[N/2] count as real.
std::vector<double> samples_of(std::span<const std::complex<double>> half, std::size_t samples);

// A[k] = c_k / N |sum_n x[n] exp(-2 pi i k n / N)|, c_k = 1 for k = 0 and (N even) k = N/2, else 2.
Spectrum amplitude_spectrum(std::span<const double> samples_g, double rate_hz);

// The signal with each frequency times `gain` of it in Hz: a filter without delay. What rings
// before the first sample or after the last is cut off; zeros are added within, so that nothing
// comes round from the other end.
std::vector<double> zero_phase_filtered(std::span<const double> samples, double rate_hz,
                                        const std::function<double(double frequency_hz)>& gain);

}  // namespace tact
