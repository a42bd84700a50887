// How a participant answered: how fast, how alike a second time, with how many replays. Rules on
// it say who does not count; each is off until its number is given.
//
// Source    ours: a researcher states such rules before the data are seen. Those on identical
//           patterns are the publication's (model/study/study_design.h).
// Input     answers that were felt whole (felt_of())
// Left out  guesses of what is too fast for a set: it depends on how long the patterns are.
// Exact     same record, same numbers.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "model/study/ratings.h"
#include "model/study/study_record.h"

namespace tact {

struct ConductRule {
    std::optional<double> fast_below_s{};  // an answer sooner than this is fast ...
    double fast_share = 0.1;               // ... and at most this share of one's answers may be so
    std::optional<double> repeat_rho{};    // between one's own repetitions, at least
    std::optional<double> replays{};       // a trial, on average, at most

    bool operator==(const ConductRule&) const = default;
};

namespace limits {
inline constexpr Range kFastBelowS{0, 3600};
inline constexpr Range kFastShare{0, 1};
inline constexpr Range kRho{-1, 1};
inline constexpr Range kReplays{0, 1000};
}  // namespace limits

enum class ConductTest { speed, repetition, replays };
inline constexpr std::array kConductTests{ConductTest::speed, ConductTest::repetition,
                                          ConductTest::replays};

bool is_on(const ConductRule& rule, ConductTest test);
bool is_any_on(const ConductRule& rule);

// "at most 10 % of the answers in under 2 s": what the rule asks for.
std::string words_on(const ConductRule& rule, ConductTest test);

// Why the participant falls by it, as a phrase; empty: they do not, or it is off or not known.
std::string fault_of(const StudyRecord& record, const ConductRule& rule, ConductTest test);

// The mean of Spearman's rho over all two of one participant's passes; NaN of fewer than two.
double repeat_rho(std::span<const Judgement> passes);

struct Conduct {
    std::size_t answers = 0;         // that were felt whole
    double median_response_s = 0.0;  // NaN of none, as all of these
    double replays = 0.0;            // a trial: plays beyond the first of each side; NaN of sorting
    double repeat_rho = 0.0;
};
Conduct conduct_of(const StudyRecord& record);

}  // namespace tact
