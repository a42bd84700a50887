#include "model/text/utc_time.h"

#include <ctime>

#include "model/system/calendar.h"

namespace tact {

std::string utc_now() {
    const std::time_t now = std::time(nullptr);
    const std::tm parts = utc_parts(now).value_or(std::tm{});
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text;
}

std::string utc_today() { return utc_now().substr(0, 10); }

}  // namespace tact
