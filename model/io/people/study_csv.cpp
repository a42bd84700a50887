#include "model/io/people/study_csv.h"

#include <algorithm>
#include <ostream>

#include "model/io/tables/matrix_file.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

const ParticipantSummary* summary_of(const StudyResults& results, const StudyRecord& record) {
    const auto found = std::ranges::find(results.people, record.header.participant.code,
                                         &ParticipantSummary::code);
    return found == results.people.end() ? nullptr : &*found;
}

std::string ending_of(const StudyRecord& record, bool is_excluded) {
    return std::string(is_excluded ? ",1" : ",0") + (record.header.synthetic ? ",1\n" : ",0\n");
}

void write_pairs(std::ostream& stream, const StudyRecord& record, bool is_excluded) {
    const auto& names = record.header.patterns;
    for (std::size_t k = 0; k < record.answers.size(); ++k) {
        const PairAnswer& answer = record.answers[k];
        const Trial& trial = answer.trial;
        const int replays =
            std::max(answer.plays_left - 1, 0) + std::max(answer.plays_right - 1, 0);
        stream << csv_field(record.header.participant.code) << ',' << k + 1 << ','
               << csv_field(names[std::min(trial.left, trial.right)]) << ','
               << csv_field(names[std::max(trial.left, trial.right)]) << ','
               << (trial.left <= trial.right ? "a," : "b,") << shortest_digits(answer.similarity)
               << ',' << replays << ',' << shortest_digits(answer.response_s) << ','
               << (trial.is_attention() ? '1' : '0') << ending_of(record, is_excluded);
    }
}

void write_sortings(std::ostream& stream, const StudyRecord& record, bool is_excluded) {
    for (std::size_t t = 0; t < record.sortings.size(); ++t) {
        const SortingAnswer& answer = record.sortings[t];
        for (std::size_t k = 0; k < answer.groups.size(); ++k) {
            if (answer.groups[k] == kUnsorted) continue;
            stream << csv_field(record.header.participant.code) << ',' << t + 1 << ','
                   << answer.asked_groups << ',' << answer.groups[k] + 1 << ','
                   << csv_field(record.header.patterns[k]) << ','
                   << shortest_digits(answer.response_s) << ending_of(record, is_excluded);
        }
    }
}

}  // namespace

void write_study_csv(std::ostream& stream, std::span<const StudyRecord> records,
                     const StudyResults& results, StudyRows rows) {
    const bool is_pairs = results.kind == StudyKind::pairwise;
    stream << (is_pairs ? "participant,trial,a,b,side,rating,replays,response_s,attention,"
                          "excluded,synthetic\n"
                        : "participant,round,asked_groups,group,pattern,response_s,excluded,"
                          "synthetic\n");
    for (const StudyRecord& record : records) {
        const ParticipantSummary* summary = summary_of(results, record);
        const bool is_excluded = summary == nullptr || !summary->excluded.empty();
        if (is_excluded && rows == StudyRows::counted) continue;
        if (is_pairs) write_pairs(stream, record, is_excluded);
        if (!is_pairs) write_sortings(stream, record, is_excluded);
    }
}

}  // namespace tact
