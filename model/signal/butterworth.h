// Butterworth filters as second-order sections: the frequency tuning of a mechanoreceptor channel.
//
// Source    bilinear transform with pre-warped edges (Oppenheim & Schafer, Discrete-Time Signal
//           Processing, 7.1); equals scipy.signal.butter(order, ..., output="sos").
// Input     a signal and its rate; zero initial state
// Output    the filtered signal, causal, same length
// Valid     0 < edges < rate / 2; order 1-20. The polynomial form is unstable at these edges.
// Left out  high-pass, band-stop, zero phase.
// Exact     one arithmetic on every code path: a different last bit can flip a spike count.
#pragma once

#include <span>
#include <vector>

namespace tact {

// b0 + b1/z + b2/z^2 over 1 + a1/z + a2/z^2.
struct Section {
    double b0, b1, b2;
    double a1, a2;
};

// `order` per edge: 2 * order in total.
std::vector<Section> band_pass(int order, double low_hz, double high_hz, double rate_hz);
std::vector<Section> low_pass(int order, double edge_hz, double rate_hz);

// Runs the sections one after the other.
std::vector<double> filtered(std::span<const Section> sections, std::span<const double> signal);

// |H| at a frequency.
double gain(std::span<const Section> sections, double frequency_hz, double rate_hz);

}  // namespace tact
