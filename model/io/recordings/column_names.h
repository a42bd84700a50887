// What the names of a recording's columns say: time or axis, and in what unit.
//
// Input     names as loggers write them, in any case: "Time [ms]", "ax_g", "linear acceleration x"
// Output    lower case; unknown units as they are written
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "model/io/recordings/acceleration_table.h"

namespace tact {

// "Time [ms]" as its word and its unit: "time", "ms"; "ax_g" has the unit "g".
std::pair<std::string, std::string> word_and_unit(const std::string& name);

std::optional<double> time_unit_of(const std::string& unit);  // in s
std::optional<AccelerationUnit> unit_of(const std::string& unit);

bool is_time(const std::string& word);

// A time that counts from the row before: "time diff", "dt".
bool is_step_of_time(const std::string& word);

// Names that stand for an axis; others ("sample", "temperature") are passed over where some of
// these are there.
bool is_axis(const std::string& word);

// Made of the axes, and none itself.
bool is_total(const std::string& word);

}  // namespace tact
