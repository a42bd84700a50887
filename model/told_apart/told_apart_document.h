// Results of trials for other programs: a document of JSON, and a table.
//
// Output    shares from 0 to 1, times in seconds, PM as it was in the answers; every one says that
//           it was measured on one person, on one device
// Left out  the form in which a set file keeps the answers (model/told_apart/told_apart_json.h)
// Exact     numbers read back as the same ones
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/told_apart/told_apart_results.h"

namespace tact {

// {"measured_on", "synthetic", "device", "person", "date", "trials", "right", "share_right", ..,
// "threshold": {"said", "pm", "low_pm", "high_pm"}, "words": [..], "pairs": [..]}
nlohmann::ordered_json told_apart_document(const ToldApart& told, const ToldApartResults& results);

// A row an answer, with a header.
std::string told_apart_csv(const ToldApart& told);

}  // namespace tact
