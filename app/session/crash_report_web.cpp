// A page that fails is told of by its browser, and has no next start that could find a report.
#include "app/session/session.h"

namespace tact {

void watch_for_crashes(const std::filesystem::path&) {}

void note_command(const char*) {}

std::optional<std::filesystem::path> take_crash_report(const std::filesystem::path&) {
    return std::nullopt;
}

}  // namespace tact
