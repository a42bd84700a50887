// Disparities: the numbers closest to the distances of a map that keep the order of
// dissimilarities.
//
// Source    Kruskal 1964 (stress-1, primary and secondary approach to ties); de Leeuw 1977
//           (tertiary); Ayer et al. 1955 (pooling of adjacent violators).
// Input     dissimilarities, quantised before they are compared; NaN pairs are ignored
// Output    disparities in the order of the input, stress-1
// Exact     same input, same bits.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tact {

// Weighted least-squares monotone (non-decreasing) fit: pool adjacent violators.
// `weights` empty: all 1. Errors none; result has the length of `values`.
std::vector<double> monotone_fit(std::span<const double> values,
                                 std::span<const double> weights = {});

// What equal dissimilarities ask of their disparities. Maps are made by the primary one.
enum class Ties {
    primary,    // nothing: they take the order of their distances
    secondary,  // to be equal
    tertiary    // to have means in order, and the spread of their distances
};

// Disparities of `distances` in the order of `dissimilarities`, and their stress-1. The disparity
// of a NaN pair is NaN, and stress-1 leaves out pairs of a NaN disparity.
std::vector<double> disparities(std::span<const double> dissimilarities,
                                std::span<const double> distances, Ties ties = Ties::primary);
double stress1(std::span<const double> distances, std::span<const double> fitted);

// Kruskal's verbal scale: "perfect" (< 1e-6), "excellent" (at most .025), "good" (at most .05),
// "fair" (at most .10), else "poor".
std::string stress_label(double stress1);

// What a descent needs to know of the dissimilarities, found once for all starts and steps.
struct PairOrder {
    std::vector<std::size_t> ascending;                     // known pairs by (value, position)
    std::vector<std::pair<std::size_t, std::size_t>> ties;  // [first, end) of equal values, >= 2
    std::vector<std::size_t> unknown;                       // positions of NaN and infinite pairs
    std::size_t levels = 0;                                 // different values among the known
};

PairOrder order_pairs(std::span<const double> dissimilarities);

// Room for the fit of one descent, so that a step allocates nothing.
struct FitScratch {
    struct Pool {
        double sum;
        double weight;
        std::size_t end;
    };
    std::vector<std::size_t> ascending;
    std::vector<double> values;
    std::vector<Pool> pools;
    std::vector<std::pair<double, std::size_t>> tied;  // distance and pair
};

FitScratch fit_scratch(const PairOrder& order);

// Interval scaling: the disparities are a constant and a multiple of the dissimilarities, both not
// negative, where these are counted from the least. Writes those of the known pairs into `fitted`.
void fit_interval(const PairOrder& order, std::span<const double> dissimilarities,
                  std::span<const double> distances, std::span<double> fitted);

// Writes the disparities of the known pairs into `fitted`, leaves the unknown ones alone.
// `scratch` comes from fit_scratch(order) and carries nothing that changes the result.
void fit_disparities(const PairOrder& order, std::span<const double> distances, FitScratch& scratch,
                     std::span<double> fitted);

}  // namespace tact
