#include "model/system/calendar.h"

namespace tact {

std::optional<std::tm> utc_parts(std::time_t seconds) {
    std::tm parts{};
    if (gmtime_r(&seconds, &parts) == nullptr) return std::nullopt;
    return parts;
}

std::optional<std::tm> local_parts(std::time_t seconds) {
    std::tm parts{};
    if (localtime_r(&seconds, &parts) == nullptr) return std::nullopt;
    return parts;
}

}  // namespace tact
