// The part `model` of a set file: parameters of the perceptual model as JSON and back.
//
//     {"coding": {"excitatory_layers": 2, "tables": {"meissner": {"slope": [[f_hz, v], ...],
//      "threshold": [...]}, ...}}, "envelope": {"scale": "raw"}, "nc_weight": 0.3}
//
// Names are those of the structs and enumerators in perceptual_model_params.h; receptors go by
// name. Beside them in a set file, where they were trained: "trained_on", a sentence, "synthetic":
// true where nobody was asked, and "changed_by_hand": true if they were since.
#pragma once

#include "model/perceptual_model/perceptual_model_params.h"
#include "model/text/json_fields.h"

namespace tact {

// Missing fields take their defaults. Fields that this version does not know go to `unknown`.
PerceptualModelParams model_of(JsonObject& object, Json& unknown);

// Only what differs from the defaults; tables, kernels and channel weights as a whole.
Json json_of(const PerceptualModelParams& params);

}  // namespace tact
