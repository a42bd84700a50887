// Seconds since 1970 as parts of a date, from any thread.
#pragma once

#include <ctime>
#include <optional>

namespace tact {

// None: a year that is no number of the system's.
std::optional<std::tm> utc_parts(std::time_t seconds);
std::optional<std::tm> local_parts(std::time_t seconds);  // in the time zone of this computer

}  // namespace tact
