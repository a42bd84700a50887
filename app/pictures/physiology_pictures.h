// Pictures of the physiology for a page: what the model's tables say, and how one receptor fires.
//
// Exact     same input, same bytes.
#pragma once

#include "app/pictures/pictures.h"
#include "model/physiology/neural_coding_params.h"
#include "model/set/pattern_set.h"

namespace tact {

// Slopes of the rate-intensity functions and absolute thresholds over frequency, of all four types.
Picture tables_picture(const PhysiologyTables& tables, const PictureSize& size);

// The receptor under the probe of the type that fires most: what it perceives, the energy against
// its threshold, its spikes.
Picture firing_picture(const Vibration& vibration, const NeuralCodingParams& params,
                       const PictureSize& size);

}  // namespace tact
