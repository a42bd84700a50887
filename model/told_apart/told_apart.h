// Whether one person told patterns apart on one device: what was asked and answered, as a set keeps
// it.
//
// Source    odd-one-out trials of three plays, two of one pattern and one of another (the triangle
//           test of ISO 4120; Green & Swets 1966): a guess is right in a third of them
// Valid     PM belongs to the set as it was then (model/perceptual_model): where patterns were
//           added since, or the model changed, the same pair has another one
// Left out  what it says (told_apart_results.h); which answers still count (model/set)
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "model/common/units.h"

namespace tact {

// The words that go wherever such numbers go.
inline constexpr const char* kMeasuredOn = "one person, on one device";

// Three plays, counted from 0: the odd one is of one pattern, the other two are of the other.
struct OddOneOut {
    std::string a;  // names of the pair
    std::string b;
    double pm = 0.0;  // of the pair, when it was asked
    int odd_place = 0;
    bool odd_is_b = false;  // the odd play is of b, the other two are of a

    bool operator==(const OddOneOut&) const = default;
};

struct OddAnswer {
    OddOneOut trial;
    int place = 0;            // that the person took for the odd one
    double response_s = 0.0;  // from when the trial was shown

    bool is_right() const { return place == trial.odd_place; }
    bool operator==(const OddAnswer&) const = default;
};

struct ToldApart {
    std::string device;      // "phone Kim (web vibration)"
    std::string person;      // a nickname
    std::string date;        // UTC, ISO 8601
    std::uint64_t seed = 1;  // of the order of the trials
    bool synthetic = false;  // no person was asked
    std::vector<OddAnswer> answers;
    std::vector<std::string> patterns;  // of all answers
    std::vector<std::string> versions;  // of each of them then (model/set/felt_versions.h)
    std::string unknown_json{};         // keys of the file that this version does not know

    bool operator==(const ToldApart&) const = default;
};

namespace limits {
inline constexpr int kFewestOddTrials = 10;          // fewer say nothing
inline constexpr int kMostOddTrials = 40;            // more tire
inline constexpr std::size_t kMostToldApart = 1000;  // of a set
inline constexpr Range kAskedPm{0.0, 1e12};
inline constexpr Range kOddResponseS{0.0, 86'400.0};
}  // namespace limits

// Pairs of PM 0 are next to identical, and have no place on a scale of ratios.
inline bool can_be_asked(double pm) { return pm > 0.0 && pm <= limits::kAskedPm.high; }

// Another name of a pattern.
void rename_in(ToldApart& told, const std::string& before, const std::string& after);

// Those of the answers whose both patterns are among the names, with the patterns' versions.
ToldApart among(const ToldApart& told, const std::vector<std::string>& names);

}  // namespace tact
