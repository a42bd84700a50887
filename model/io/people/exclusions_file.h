// Who is left out of a study by whoever runs it, and why: a file beside the participants' own,
// which nobody changes.
//
//     {"tactspace_exclusions": 1, "excluded": [
//       {"participant": "S20", "because": "pressed one key throughout", "at":
//       "2026-11-23T10:00:00Z"}]}
//
// Output    errors as "FILE: PLACE: expected .."
// Valid     each participant once, with a reason; at most kMaxExclusions. Strict: a key that is not
//           known, or a name that nobody in the folder has, is an Error, as who is meant would
//           count.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/common/expected.h"
#include "model/study/who_counts.h"

namespace tact {

inline constexpr const char* kExclusionsFile = "exclusions.json";
inline constexpr std::size_t kMaxExclusions = 10'000;

struct Exclusion {
    std::string participant;
    std::string because;
    std::string at;  // UTC

    bool operator==(const Exclusion&) const = default;
};

Expected<std::vector<Exclusion>> parse_exclusions(std::string_view text, const std::string& file);
std::string print_exclusions(const std::vector<Exclusion>& exclusions);

// None where the folder has no such file.
Expected<std::vector<Exclusion>> read_exclusions(const std::filesystem::path& folder);

// Into the folder of a study what a rule says by name: who is excluded with a reason is recorded,
// with the time of day `at`; a record of who is included is taken back. Sentences on what changed,
// without a full stop; the file is left alone where nothing did. Errors: participants that the
// folder does not have.
Expected<std::vector<std::string>> record_exclusions(const std::filesystem::path& folder,
                                                     const CountRule& rule, const std::string& at);

}  // namespace tact
