// Every way of saying how far apart two vibrations are, by name: PM, its parts, the paper's rivals,
// and reference metrics of ours that a good model has to beat.
//
// Source    Lim & Park 2023, sections 2.3 and 6, and what each file of model/metrics names.
// Left out  VibroMAF (Noll et al. 2022), which is no distance: a regression trained on the
//           distortions of codecs alone, it rates 0..10 how well a vibration is kept, and between
//           vibrations that differ it gives numbers such as -14. Two of its features are here,
//           ST-SIM and SPQI.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "model/common/expected.h"

namespace tact {

enum class Metric {
    pm,
    nc,
    oc,
    rmse,
    dtw,
    msm,
    mtm,
    st_sim,
    spqi,
    level,
    bands,
    balance,
    van_rossum,
    no_physiology
};

// How sure the definition is the one of its source.
enum class Confidence {
    high,    // published code or documentation, or ours by definition
    medium,  // several clues agree
    low      // a documented choice
};

struct MetricTraits {
    Metric metric;
    const char* key;          // as on the command line: st-sim
    const char* name;         // ST-SIM
    const char* source;       // Hassen & Steinbach 2020
    const char* description;  // one line
    Confidence confidence;
    bool is_reference;    // ours, not from the paper
    bool is_directional;  // one of a pair is the reference, and the two ways differ
};

// A row for each metric, in the order of Metric: what lists, counts or names metrics goes by them.
inline constexpr auto kMetricTraits = std::to_array<MetricTraits>({
    {Metric::pm, "pm", "PM", "Lim & Park 2023",
     "physiology-based model: ranks of neural coding and of rhythm, added", Confidence::high, false,
     false},
    {Metric::nc, "nc", "NC", "Lim & Park 2023", "neural coding: predicted brain waveforms",
     Confidence::high, false, false},
    {Metric::oc, "oc", "OC", "Lim & Park 2023", "rhythm: time warping of envelopes",
     Confidence::high, false, false},
    {Metric::rmse, "rmse", "Spectral RMSE", "Romano & Kuchenbecker 2012",
     "root of the mean squared difference of amplitude spectra", Confidence::medium, false, false},
    {Metric::dtw, "dtw", "DTW", "Berndt & Clifford 1994",
     "dynamic time warping of the waveforms themselves", Confidence::medium, false, false},
    {Metric::msm, "msm", "Msm", "Park & Kuchenbecker 2019",
     "spectral matching: difference of spectra smoothed over a tenth of the frequency",
     Confidence::medium, false, false},
    {Metric::mtm, "mtm", "Mtm", "Park & Kuchenbecker 2019",
     "temporal matching: one minus the correlation of the waveforms", Confidence::medium, false,
     false},
    {Metric::st_sim, "st-sim", "ST-SIM", "Hassen & Steinbach 2020",
     "spectral and temporal similarity: spectra over threshold and shapes, block by block",
     Confidence::high, false, true},
    {Metric::spqi, "spqi", "SPQI", "Noll et al. 2022",
     "spectral perceptual quality index: power over threshold that differs, block by block",
     Confidence::high, false, true},
    {Metric::level, "level", "Level difference", "ours, not from the paper",
     "difference of the RMS levels in dB", Confidence::high, true, false},
    {Metric::bands, "bands", "Nine bands", "ours, not from the paper",
     "levels over threshold in nine bands, Euclidean", Confidence::high, true, false},
    {Metric::balance, "balance", "Balance", "ours, not from the paper; after Bernard et al. 2023",
     "balance of power above and below 100 Hz, in dB", Confidence::low, true, false},
    {Metric::van_rossum, "van-rossum", "van Rossum", "ours, not from the paper",
     "neural coding with van Rossum's spike distance", Confidence::high, true, false},
    {Metric::no_physiology, "no-physiology", "No physiology", "ours, not from the paper",
     "mean of the ranks of Msm, Mtm and OC", Confidence::high, true, false},
});

inline constexpr std::size_t kMetricCount = kMetricTraits.size();
inline constexpr std::array<Metric, kMetricCount> kMetrics = [] {
    std::array<Metric, kMetricCount> all{};
    for (std::size_t k = 0; k < kMetricCount; ++k) all[k] = kMetricTraits[k].metric;
    return all;
}();

const MetricTraits& traits(Metric metric);

// The metric of a key. An Error lists the keys; for vibromaf it says why it is left out.
Expected<Metric> metric_named(std::string_view key);

}  // namespace tact
