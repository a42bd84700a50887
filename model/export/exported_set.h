// Patterns as files of another program, and as they come back from these.
//
// What was written is read by our own readers with the same actuator map. A Kotlin builder is read
// as the XML of the same envelope, a C initialiser from its arrays: no other reader of these is
// there.
//
// Valid     patterns without fault (model/pattern/drawn_fault.h)
// Output    what does not come back at all is silence as long as the pattern, and said in words
// Left out  what the device makes of it: devices/calibration.
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/export/export_target.h"
#include "model/set/pattern_set.h"

namespace tact {

struct ExportedPattern {
    std::string text;                  // of the file
    std::vector<std::string> remarks;  // what was lost or changed; sentences without their stop
    Pattern back;                      // what the file holds, as it is read

    bool operator==(const ExportedPattern&) const = default;
};

// `date` is ISO 8601, for formats that have to have one; it changes nothing that comes back.
ExportedPattern exported(const Pattern& pattern, const std::string& name,
                         const ExportTarget& target, const std::string& date = "2026-01-01");

struct ExportedSet {
    // Of each vibration; none of a recording, which no such format holds.
    std::vector<std::optional<ExportedPattern>> patterns;
    PatternSet back;             // recordings as they are
    std::size_t recordings = 0;  // of these
};

// Nothing when stopped.
std::optional<ExportedSet> exported_set(const PatternSet& set, const ExportTarget& target,
                                        int threads = 0, std::stop_token stop = {},
                                        const std::string& date = "2026-01-01");

}  // namespace tact
