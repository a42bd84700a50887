#include "model/evaluation/metric.h"

#include <string>

namespace tact {

namespace {

constexpr const char* kPaper = "Lim & Park 2023";
constexpr const char* kPark = "Park & Kuchenbecker 2019";
constexpr const char* kOurs = "ours, not from the paper";

// In the order of Metric.
constexpr std::array<MetricTraits, kMetricCount> kTraits{{
    {"pm", "PM", kPaper, "physiology-based model: ranks of neural coding and of rhythm, added",
     Confidence::high, false, false},
    {"nc", "NC", kPaper, "neural coding: predicted brain waveforms", Confidence::high, false,
     false},
    {"oc", "OC", kPaper, "rhythm: time warping of envelopes", Confidence::high, false, false},
    {"rmse", "Spectral RMSE", "Romano & Kuchenbecker 2012",
     "root of the mean squared difference of amplitude spectra", Confidence::medium, false, false},
    {"dtw", "DTW", "Berndt & Clifford 1994", "dynamic time warping of the waveforms themselves",
     Confidence::medium, false, false},
    {"msm", "Msm", kPark,
     "spectral matching: difference of spectra smoothed over a tenth of the frequency",
     Confidence::medium, false, false},
    {"mtm", "Mtm", kPark, "temporal matching: one minus the correlation of the waveforms",
     Confidence::medium, false, false},
    {"st-sim", "ST-SIM", "Hassen & Steinbach 2020",
     "spectral and temporal similarity: spectra over threshold and shapes, block by block",
     Confidence::high, false, true},
    {"spqi", "SPQI", "Noll et al. 2022",
     "spectral perceptual quality index: power over threshold that differs, block by block",
     Confidence::high, false, true},
    {"level", "Level difference", kOurs, "difference of the RMS levels in dB", Confidence::high,
     true, false},
    {"bands", "Nine bands", kOurs, "levels over threshold in nine bands, Euclidean",
     Confidence::high, true, false},
    {"balance", "Balance", "ours, not from the paper; after Bernard et al. 2023",
     "balance of power above and below 100 Hz, in dB", Confidence::low, true, false},
    {"van-rossum", "van Rossum", kOurs, "neural coding with van Rossum's spike distance",
     Confidence::high, true, false},
    {"no-physiology", "No physiology", kOurs, "mean of the ranks of Msm, Mtm and OC",
     Confidence::high, true, false},
}};

}  // namespace

const MetricTraits& traits(Metric metric) { return kTraits[static_cast<std::size_t>(metric)]; }

Expected<Metric> metric_named(std::string_view key) {
    if (key == "vibromaf") {
        return Error{
            "vibromaf is no distance: it was trained to rate what codecs do to a vibration, and "
            "what it gives for different vibrations means nothing; st-sim and spqi are two of its "
            "features"};
    }
    std::string keys;
    for (const Metric metric : kMetrics) {
        if (traits(metric).key == key) return metric;
        keys += (keys.empty() ? "" : ", ") + std::string(traits(metric).key);
    }
    return Error{std::string(key) + " is no metric; expected one of " + keys};
}

}  // namespace tact
