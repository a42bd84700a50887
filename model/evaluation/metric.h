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

inline constexpr std::size_t kMetricCount = 14;
inline constexpr std::array<Metric, kMetricCount> kMetrics{
    Metric::pm,    Metric::nc,      Metric::oc,         Metric::rmse,         Metric::dtw,
    Metric::msm,   Metric::mtm,     Metric::st_sim,     Metric::spqi,         Metric::level,
    Metric::bands, Metric::balance, Metric::van_rossum, Metric::no_physiology};

// How sure the definition is the one of its source.
enum class Confidence {
    high,    // published code or documentation, or ours by definition
    medium,  // several clues agree
    low      // a documented choice
};

struct MetricTraits {
    const char* key;          // as on the command line: st-sim
    const char* name;         // ST-SIM
    const char* source;       // Hassen & Steinbach 2020
    const char* description;  // one line
    Confidence confidence;
    bool is_reference;    // ours, not from the paper
    bool is_directional;  // one of a pair is the reference, and the two ways differ
};

const MetricTraits& traits(Metric metric);

// The metric of a key. An Error lists the keys; for vibromaf it says why it is left out.
Expected<Metric> metric_named(std::string_view key);

}  // namespace tact
