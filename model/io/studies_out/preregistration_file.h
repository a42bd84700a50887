// A planned study in a file of its own, written once and never changed.
//
//     {"tactspace_preregistration": 1, "date": "2026-11-28", "program": "tactspace 0.1.0",
//      "set": "..", "set_fingerprint": "0123456789abcdef", "model_fingerprint": "..",
//      "patterns": ["..", ..], "people": 20, "pairs": 0, "repetitions": 4,
//      "attention": {"pairs": 3, "above": 80, "failures_allowed": 0}, "order": "full",
//      "scaling": "none", "metric": "pm", "rival": "msm",
//      "assumed": {"rho": 0.67, "reliability": 0.4, "source": ".."},
//      "expected": {"rho": .., "rho_rival": .., "half_width": {"patterns": .., ..},
//                   "power": {"patterns": .., "people": .., "both": ..}},
//      "hypotheses": [".."], "tests": [".."], "exclusion_rules": [".."]}
//
// Output    errors as "FILE: PLACE: expected WHAT, got GOT"; the sentences at the end are for
//           people, and are not read back
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/common/expected.h"
#include "model/planning/preregistration.h"

namespace tact {

inline constexpr int kPreregistrationFormat = 1;

Expected<Preregistration> parse_preregistration(std::string_view text, const std::string& file);
std::string print_preregistration(const Preregistration& plan);

Expected<Preregistration> read_preregistration(const std::filesystem::path& path);

}  // namespace tact
