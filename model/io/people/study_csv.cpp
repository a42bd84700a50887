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

// What is said of every answer, after what it was.
std::string marks_of(const StudyRecord& record, std::size_t k, const std::string& at,
                     const std::string& excluded) {
    const Felt felt = felt_of(record, k);
    std::string why = excluded;
    if (why.empty() && felt == Felt::nothing) why = "nothing was felt";
    if (why.empty() && felt == Felt::in_part) why = "not felt whole";
    std::string text = why.empty() ? ",0" : ",1";
    text += record.header.synthetic ? ",1" : ",0";
    text += felt == Felt::nothing ? ",1" : ",0";
    text += felt == Felt::in_part ? ",0," : ",1,";
    return text + csv_field(why) + "," + csv_field(device_of(record, k).name) + "," +
           csv_field(record.header.set_fingerprint) + "," + csv_field(at);
}

// Which of the two, by their order in the set.
const char* felt_first(const PairAnswer& answer) {
    if (answer.first == FeltFirst::unknown) return "NA";
    return (answer.first == FeltFirst::left) == (answer.trial.left <= answer.trial.right) ? "a"
                                                                                          : "b";
}

void write_pairs(std::ostream& stream, const StudyRecord& record, const std::string& excluded,
                 RatingScaling scaling) {
    const auto& names = record.header.patterns;
    const SimilarityScale scale = scale_of(record, scaling);
    for (std::size_t k = 0; k < record.answers.size(); ++k) {
        const PairAnswer& answer = record.answers[k];
        const Trial& trial = answer.trial;
        stream << csv_field(record.header.participant.code) << ',' << k + 1 << ','
               << csv_field(names[std::min(trial.left, trial.right)]) << ','
               << csv_field(names[std::max(trial.left, trial.right)]) << ','
               << (trial.left <= trial.right ? "a," : "b,") << shortest_digits(answer.similarity)
               << ',' << replays_of(answer) << ',' << shortest_digits(answer.response_s) << ','
               << (trial.is_attention() ? '1' : '0') << marks_of(record, k, answer.at, excluded)
               << ',' << felt_first(answer);
        if (scaling != RatingScaling::none) {
            stream << ',' << kScalingNames[static_cast<std::size_t>(scaling)] << ','
                   << shortest_digits(scale.factor * answer.similarity + scale.shift);
        }
        stream << '\n';
    }
}

void write_sortings(std::ostream& stream, const StudyRecord& record, const std::string& excluded) {
    for (std::size_t t = 0; t < record.sortings.size(); ++t) {
        const SortingAnswer& answer = record.sortings[t];
        for (std::size_t k = 0; k < answer.groups.size(); ++k) {
            if (answer.groups[k] == kUnsorted) continue;
            stream << csv_field(record.header.participant.code) << ',' << t + 1 << ','
                   << answer.asked_groups << ',' << answer.groups[k] + 1 << ','
                   << csv_field(record.header.patterns[k]) << ','
                   << shortest_digits(answer.response_s) << marks_of(record, t, answer.at, excluded)
                   << '\n';
        }
    }
}

}  // namespace

void write_study_csv(std::ostream& stream, std::span<const StudyRecord> records,
                     const StudyResults& results, StudyRows rows) {
    const bool is_pairs = results.kind == StudyKind::pairwise;
    stream << (is_pairs ? "participant,trial,a,b,side,rating,replays,response_s,attention,"
                        : "participant,round,asked_groups,group,pattern,response_s,")
           << "excluded,synthetic,rehearsal,whole,why,device,fingerprint,at"
           << (is_pairs ? ",felt_first" : "")
           << (is_pairs && results.scaling != RatingScaling::none ? ",scaling,scaled\n" : "\n");
    for (const StudyRecord& record : records) {
        const ParticipantSummary* summary = summary_of(results, record);
        const std::string excluded = summary == nullptr ? "not known" : summary->excluded;
        if (!excluded.empty() && rows == StudyRows::counted) continue;
        if (is_pairs) write_pairs(stream, record, excluded, results.scaling);
        if (!is_pairs) write_sortings(stream, record, excluded);
    }
}

}  // namespace tact
