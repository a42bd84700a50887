// When something was made, for files that say so.
#pragma once

#include <string>

namespace tact {

// "2026-11-21T18:40:00Z", of the system's clock.
std::string utc_now();

// "2026-11-21", of the same clock.
std::string utc_today();

}  // namespace tact
