// Patterns as files of another program, and as they come back from these.
//
// What was written is read by our own readers with the same actuator map; the two files of a pair
// as one pattern. A Kotlin builder is read as the XML of the same envelope, a C initialiser and a
// table of samples from their own numbers: no other reader of these is there.
//
// Valid     patterns without fault (model/pattern/drawn_fault.h)
// Output    what does not come back at all is silence as long as the pattern, and said in words
// Left out  what the device makes of it: devices/calibration.
// Exact     same input, same bits, on any number of threads.
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "model/export/envelope_error.h"
#include "model/export/export_target.h"
#include "model/set/pattern_set.h"

namespace tact {

struct ExportedPattern {
    std::string text;    // of the file
    std::string beside;  // of its second file, where the format has one
    // What was lost or changed, the most important last; sentences without a stop. None of what
    // costs less than 0.1 dB and 1 ms (envelope_error.h).
    std::vector<std::string> remarks;
    VibrationSource back;                  // what the file holds, as it is read
    std::optional<EnvelopeError> error{};  // of what is not samples

    bool operator==(const ExportedPattern&) const = default;
};

// Whether the format holds it: recordings in samples alone.
bool is_held(const Vibration& vibration, TargetFormat format);

// `date` is ISO 8601, for formats that have to have one; it changes nothing that comes back.
ExportedPattern exported(const Pattern& pattern, const std::string& name,
                         const ExportTarget& target, const std::string& date = "2026-01-01");

// The same of anything that the format holds.
ExportedPattern exported(const Vibration& vibration, const ExportTarget& target,
                         const std::string& date = "2026-01-01");

// With a full scale of samples, where it has none: one for all, so that the loudest just fits;
// stopped, of those that were looked at.
ExportTarget with_full_scale(ExportTarget target, const PatternSet& set, int threads = 0,
                             std::stop_token stop = {});

struct ExportedSet {
    ExportTarget target{};  // with its full scale
    // One per vibration; empty for a recording, except in samples.
    std::vector<std::optional<ExportedPattern>> patterns{};
    PatternSet back{};           // recordings that are not written as they are
    std::size_t recordings = 0;  // of these
};

// Nothing when stopped.
std::optional<ExportedSet> exported_set(const PatternSet& set, const ExportTarget& target,
                                        int threads = 0, std::stop_token stop = {},
                                        const std::string& date = "2026-01-01");

}  // namespace tact
