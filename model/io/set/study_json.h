// A study's design as JSON and back: the part `study` of a set file, and of a participant's file.
//
//     {"patterns": ["a", "b"], "repetitions": 4, "attention_pairs": 3, "seed": 1, "order": "full",
//      "gap_s": 1, "rest_s": 1, "break_every": 66, "masking": 0,
//      "headphones": "audio/ALSA/pulse",
//      "attention": {"above": 80, "failures_allowed": 0}, "instructions": "..", "consent": "..",
//      "groups": [0, 3, 6]}
//
// And the changes that they feel, the part `felt_steps`: {"amplitude_g": 1.19, "mix": 0.2}, factors
// where a number is felt by ratio.
#pragma once

#include "model/pattern/felt_steps.h"
#include "model/study/study_design.h"
#include "model/text/json_fields.h"

namespace tact {

// Missing fields take their defaults. Fields that this version does not know go to `unknown`.
StudyDesign study_design_of(JsonObject& object, Json& unknown);

// Only what differs from the defaults, and the identical pairs, whose default was once another.
Json json_of(const StudyDesign& design);

FeltSteps felt_steps_of(JsonObject& object, Json& unknown);
Json json_of(const FeltSteps& steps);  // only what differs from the usual ones

}  // namespace tact
