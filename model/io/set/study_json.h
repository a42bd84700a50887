// A study's design as JSON and back: the part `study` of a set file, and of a participant's file.
//
//     {"patterns": ["a", "b"], "repetitions": 4, "attention_pairs": 3, "seed": 1, "order": "full",
//      "gap_s": 1, "rest_s": 1, "break_every": 66, "masking": 0,
//      "headphones": "audio/ALSA/pulse",
//      "attention": {"above": 80, "failures_allowed": 0}, "instructions": "..", "consent": "..",
//      "groups": [0, 3, 6]}
#pragma once

#include "model/study/study_design.h"
#include "model/text/json_fields.h"

namespace tact {

// Missing fields take their defaults. Fields that this version does not know go to `unknown`.
StudyDesign study_design_of(JsonObject& object, Json& unknown);

// Only what differs from the defaults, and the identical pairs, whose default was once another.
Json json_of(const StudyDesign& design);

}  // namespace tact
