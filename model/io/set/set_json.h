// The set file's JSON: a set as a document and back.
//
// Source    format 1 of the set file. Keys that this version does not know are kept with the value
//           that they belong to, as text in its `unknown_json`.
//           Those of a carrier, a point or a transient are kept with its position: where one is
//           removed, its successor gets them, and those of the last are dropped.
// Left out  the waveforms of recordings: they have files of their own. Their paths are text; one
//           that is not UTF-8 is written with "%E9" for such a byte, and "percent_encoded": true.
#pragma once

#include <filesystem>

#include "model/set/pattern_set.h"
#include "model/text/json_fields.h"

namespace tact {

inline constexpr int kSetFormat = 1;

// The set of a document. Recordings have no waveform yet, their path as the document names it, and
// the scale 0 where it gives none. A fault is left in `reading`.
PatternSet set_of(JsonReading& reading, const Json& document, std::vector<std::string>& remarks);

// Only what differs from the defaults, besides what a reader looks for first. Paths of recordings
// become relative to `folder`, unless that is empty.
Json json_of(const PatternSet& set, const std::filesystem::path& folder);

// The same of a pattern alone (pattern_json.cpp). What is drawn is written only where there is any.
Pattern pattern_of(JsonObject& object, double set_duration_s, Json& unknown);
Json json_of(const Pattern& pattern, double set_duration_s);

// {"layers": [...]}. Recordings of layers have no waveform yet, as those of a set.
LayeredPattern layered_of(JsonObject& object, double set_duration_s, Json& unknown);
Json json_of(const LayeredPattern& layered, double set_duration_s,
             const std::filesystem::path& folder);

}  // namespace tact
