// The lines of a participant's file, as study_file.h shows them: each JSON and back.
//
// Output    what is wrong with a line, as "PLACE: FIELD: expected .."
#pragma once

#include <cstddef>
#include <string>

#include "model/study/study_record.h"
#include "model/text/json_fields.h"

namespace tact {

inline constexpr int kStudyFormat = 1;

std::string header_line(const StudyHeader& header);
std::string device_line(const DeviceChange& change);
std::string answer_line(const StudyHeader& header, std::size_t serial, const PairAnswer& answer);
std::string answer_line(const StudyHeader& header, std::size_t serial, const SortingAnswer& answer);

// The first line into the record, and any other; what is wrong with it, or empty.
std::string take_header(StudyRecord& record, const Json& value, const std::string& place);
std::string take_line(StudyRecord& record, const Json& value, const std::string& place);

}  // namespace tact
