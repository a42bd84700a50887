// The part `generator` of a set file: a design space as JSON and back.
//
//     {"design": "sobol", "samples": 120, "seed": 1,
//      "amplitude_g": [0.5, 1, 2],                       levels; a single number: fixed
//      "carriers": [{"frequency_hz": {"from": 60, "to": 300, "steps": 5, "spacing": "log",
//                    "multiple_of": 1}, "weight": 1}],   a range
//      "modulation": {"kinds": ["product", "am"], "frequency_hz": [0, 4, 16], "depth": 1},
//      "rhythm": {"texts": ["", "x=--"], "unit_s": 0.125},
//      "attack_s": 0, "release_s": 0, "duration_s": 1,
//      "constraints": {"band_hz": [40, 400], "displacement_um": 100, "detectable_db": 6}}
//
// Instead of weights two carriers may have "mix", the share of the second; "displacement_mm" is
// read, too.
#pragma once

#include "model/design_space/design_space.h"
#include "model/text/json_fields.h"

namespace tact {

// Missing fields take their defaults, the duration that of the set. Fields that this version does
// not know go to `unknown`.
DesignSpace design_space_of(JsonObject& object, double set_duration_s, Json& unknown);

// Only what differs from the defaults, besides the design.
Json json_of(const DesignSpace& space, double set_duration_s);

}  // namespace tact
