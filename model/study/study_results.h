// From what participants answered to ratings: who counts, how far they agree, and the matrix.
//
// Source    Lim & Park 2023, section 6.1: D = 100 - mean similarity over repetitions and people,
// who
//           must notice identical pairs. Outliers: Tukey 1977 (fences), on how each agrees with the
//           mean of the others.
// Output    judgements by pass, so that repetitions stay told apart
//           Whoever was asked by another design than the first participant (founder_of()) takes
//           part in another study, and is left out with what differs, unless included by name.
// Left out  the removal of outliers: they are pointed at, and counted.
// Exact     same records, same numbers, whatever their order on the disk.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/common/expected.h"
#include "model/study/conduct.h"
#include "model/study/ratings.h"
#include "model/study/study_record.h"
#include "model/study/who_counts.h"

namespace tact {

// The rule without those on conduct, which ratings_of_everyone() has applied.
CountRule by_name(CountRule rule);

// How each participant's similarities are brought to one scale before they are averaged.
enum class RatingScaling {
    none,      // the publication's
    min_max,   // each one's own range to 0..100
    standard,  // mean 50, standard deviation 10 (T-scores)
};

struct CollectRule {
    AttentionRule attention;
    bool unfinished_too = false;  // who did not come to the end counts as well
    RatingScaling scaling = RatingScaling::none;
    CountRule who;  // by name

    bool operator==(const CollectRule&) const = default;
};

struct ParticipantSummary {
    std::string code;
    bool synthetic = false;
    bool rehearsal = false;  // nothing was felt
    std::size_t answers = 0;
    std::size_t wanted = 0;
    std::size_t unfelt = 0;         // of the answers: do not count, felt not at all or in part
    std::vector<double> attention;  // similarities of identical pairs that were felt
    std::string excluded;           // why, as a phrase; empty: counted
    Conduct conduct{};              // how they answered
    double rho_with_others = 0.0;   // of those counted; NaN: unknown, or excluded
    bool is_outlier = false;
    double minutes = 0.0;  // spent on answers
    int cut_short = 0;     // plays that were not whole
};

struct StudyResults {
    StudyKind kind = StudyKind::pairwise;
    StudyOrder order = StudyOrder::full;
    NumberMark mark{};  // of what those who count said
    RatingScaling scaling = RatingScaling::none;
    RatingStudy study;  // of those counted
    std::vector<ParticipantSummary> people;
    std::vector<std::string> remarks;  // sentences without a full stop
    Dissimilarity mean;
    Reliability agreement;
};

// The ratings of everyone, and what is known of each: what who_counts() decides by.
Expected<RatingStudy> ratings_of_everyone(std::span<const StudyRecord> records,
                                          const CollectRule& rule);

// Each rule of conduct that is on, and who falls by it: sentences without a full stop.
std::vector<std::string> remarks_on_conduct(std::span<const StudyRecord> records,
                                            const ConductRule& rule);

// The records' own rule is the founder's: it is the design's.
CollectRule rule_of(std::span<const StudyRecord> records);

// Errors: no record; records of other patterns, of another kind or order of study, of one code;
// as who_counts().
Expected<StudyResults> study_results(std::span<const StudyRecord> records, const CollectRule& rule);

// The records of those who are counted.
std::vector<StudyRecord> counted_records(std::span<const StudyRecord> records,
                                         const StudyResults& results);

// A similarity is brought to the scale by factor * similarity + shift.
struct SimilarityScale {
    double factor = 1.0;
    double shift = 0.0;
};
SimilarityScale scale_of(const StudyRecord& record, RatingScaling scaling);

// As the command line and files name them.
inline constexpr const char* kScalingNames[] = {"none", "min-max", "standard"};

// The judgements of one record, pass by pass: 100 - similarity, NaN where a pass lacks the pair.
// What was not felt is left out.
std::vector<Judgement> judgements_of(const StudyRecord& record, RatingScaling scaling);

// Mean similarities as dissimilarities of one participant.
Dissimilarity ratings_of(const StudyRecord& record);

}  // namespace tact
