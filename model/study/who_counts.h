// Who counts of those who took part, and why others do not: the one gate in front of every mean,
// comparison and fit.
//
// Input     ratings of everyone, with what is known of who gave them (Standing)
// Output    the ratings of those who count, and the others with the reason
// Left out  outliers, who are pointed at (model/study/study_results.h) and count all the same
// Exact     same input, same answer.
#pragma once

#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/study/conduct.h"
#include "model/study/ratings.h"

namespace tact {

// What a simulated participant is left out for.
inline constexpr const char* kSimulated = "simulated, and nobody is averaged with a simulation";

// Participants by name who are to count though a rule leaves them out, and the other way round; and
// rules on how they answered, for ratings of which that is known.
struct CountRule {
    std::vector<std::string> include;
    std::vector<std::string> exclude;
    std::string because{};  // of `exclude`, as a phrase
    ConductRule conduct{};

    bool operator==(const CountRule&) const = default;
};

struct LeftOutParticipant {
    std::string participant;
    std::string why;  // a phrase

    bool operator==(const LeftOutParticipant&) const = default;
};

struct Counted {
    RatingStudy study;
    std::vector<LeftOutParticipant> left_out;
};

// What a rehearsal is left out for.
inline constexpr const char* kNothingFelt = "a rehearsal, nothing was felt";

// The reason for someone left out by the experimenter.
std::string excluded_because(const std::string& because);

// An excluded participant counts if included by name; a rehearsal never does. Beside people who
// felt something, simulated participants count only if included by name. Errors: a name that nobody
// has, one that is to be both, a rehearsal that is to count; a rule of conduct, which records alone
// answer (model/study/study_results.h).
Expected<Counted> who_counts(RatingStudy study, const CountRule& rule = {});

// A sentence on each, without a full stop.
std::vector<std::string> remarks_on(const std::vector<LeftOutParticipant>& left_out);

}  // namespace tact
