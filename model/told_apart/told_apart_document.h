// Results of trials for other programs: a document of JSON, and a table.
//
// Output    shares from 0 to 1, times in seconds, PM as it was in the answers; every one says that
//           it was measured on one person, on one device
// Left out  the form in which a set file keeps the answers: told_apart_field()
// Exact     numbers read back as the same ones
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

#include "model/text/json_fields.h"
#include "model/told_apart/told_apart.h"
#include "model/told_apart/told_apart_results.h"

namespace tact {

// {"measured_on", "synthetic", "device", "person", "date", "trials", "right", "share_right", ..,
// "threshold": {"said", "pm", "low_pm", "high_pm"}, "words": [..], "pairs": [..]}
nlohmann::ordered_json told_apart_document(const ToldApart& told, const ToldApartResults& results);

// A row an answer, with a header.
std::string told_apart_csv(const ToldApart& told);

// Trials of one person on one device as JSON and back: the part `told_apart` of a set file.
//
//     [{"measured_on": "one person, on one device", "device": "phone Kim (web vibration)",
//       "person": "Kim", "date": "2026-11-28T21:12:53Z", "seed": "000000000000002a",
//       "patterns": ["Pulse", "Buzz"], "versions": ["0123456789abcdef", "fedcba9876543210"],
//       "trials": [{"a": "Pulse", "b": "Buzz", "pm": 9, "odd_one": "b", "odd_place": 2,
//                   "answer": 2, "response_s": 5.2}, ..]}, ..]
//
// Source    ours. Plays are counted from 1; `odd_one` is the one of the two that is played once.
//           A trial needs all of its keys but `response_s`: none has a usual value.
//           "synthetic": true: nobody was asked
// Left out  what the trials say: it is computed.

// None where the key is missing. A fault is left in the reading.
std::vector<ToldApart> told_apart_field(JsonObject& object);

Json json_of(const ToldApart& told);

}  // namespace tact
