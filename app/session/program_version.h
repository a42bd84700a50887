// The program's name and version, as files of its making say it.
#pragma once

namespace tact {

inline constexpr const char* kProgramVersion = "tactspace " TACT_VERSION;

}  // namespace tact
