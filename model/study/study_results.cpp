#include "model/study/study_results.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "model/common/distributions.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

bool is_felt(const StudyRecord& record, std::size_t k) { return felt_of(record, k) == Felt::whole; }

// What makes similarities of one participant comparable with others'.
SimilarityScale scale_by(const std::vector<double>& values, RatingScaling scaling) {
    if (scaling == RatingScaling::none || values.empty()) return {};
    const auto count = static_cast<double>(values.size());
    double centre = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double squares = 0.0;
    for (const double value : values) squares += (value - centre) * (value - centre);
    double unit = std::sqrt(squares / count) / 10.0;
    if (scaling == RatingScaling::min_max) {
        const auto [low, high] = std::ranges::minmax(values);
        centre = 0.5 * (low + high);
        unit = (high - low) / 100.0;
    }
    // Who always says the same has no scale: all in the middle.
    const double factor = unit > 0.0 ? 1.0 / unit : 0.0;
    return {factor, 50.0 - factor * centre};
}

std::vector<Judgement> judgements_of_answers(const StudyRecord& record, RatingScaling scaling) {
    const std::size_t n = record.header.patterns.size();
    const SimilarityScale scale = scale_of(record, scaling);
    std::vector<Judgement> passes;
    std::vector<std::size_t> rated(pair_count(n), 0);
    for (std::size_t k = 0; k < record.answers.size(); ++k) {
        const PairAnswer& answer = record.answers[k];
        if (answer.trial.is_attention() || !is_felt(record, k)) continue;
        const auto [low, high] = std::minmax(answer.trial.left, answer.trial.right);
        const std::size_t pair = pair_index(n, low, high);
        const std::size_t pass = rated[pair]++;
        if (pass == passes.size()) {
            passes.push_back(
                {record.header.participant.code, std::vector<double>(pair_count(n), kNoRating)});
        }
        passes[pass].condensed[pair] = 100.0 - (scale.factor * answer.similarity + scale.shift);
    }
    return passes;
}

std::string count_of(std::size_t part, std::size_t whole, const char* what) {
    return grouped_digits(part) + " of " + grouped_digits(whole) + " " + what;
}

// By the first of the rules on conduct that they fall by.
std::string fault_of_conduct(const StudyRecord& record, const CollectRule& rule) {
    for (const ConductTest test : kConductTests) {
        if (std::string fault = fault_of(record, rule.who.conduct, test); !fault.empty()) {
            return fault;
        }
    }
    return {};
}

std::string reason_to_exclude(const ParticipantSummary& person, const StudyRecord& record,
                              const CollectRule& rule) {
    if (person.answers == 0) return "no answer";
    if (person.rehearsal) return kNothingFelt;
    if (person.unfelt == person.answers) return "no answer to what was felt whole";
    if (!record.excluded.empty()) return excluded_because(record.excluded);
    if (!rule.unfinished_too && person.answers < person.wanted) {
        const bool pairs = record.header.kind == StudyKind::pairwise;
        return "unfinished, " +
               count_of(person.answers, person.wanted, pairs ? "trials" : "rounds");
    }
    std::string low;
    int failures = 0;
    for (const double similarity : person.attention) {
        if (similarity > rule.attention.above) continue;
        ++failures;
        low += (low.empty() ? "" : ", ") + shortest_digits(similarity);
    }
    if (failures <= rule.attention.failures_allowed) return fault_of_conduct(record, rule);
    return "identical patterns rated " + low + ", expected above " +
           shortest_digits(rule.attention.above);
}

// A changed design is another study; empty: it is the founder's.
std::string fault_of_design(const StudyRecord& record, const StudyRecord& founder) {
    const auto changes = changes_since(founder.header, record.header);
    if (changes.empty()) return {};
    return "another study than " + founder.header.participant.code +
           "'s: " + words_on_changes(changes);
}

ParticipantSummary summary_of(const StudyRecord& record, const StudyRecord& founder,
                              const CollectRule& rule) {
    ParticipantSummary person;
    person.code = record.header.participant.code;
    person.synthetic = record.header.synthetic;
    person.answers = answers_given(record);
    person.wanted = answers_wanted(record);
    person.rho_with_others = kNoRating;
    double seconds = 0.0;
    std::size_t without_device = 0;
    for (std::size_t k = 0; k < person.answers; ++k) {
        if (felt_of(record, k) == Felt::nothing) ++without_device;
        if (!is_felt(record, k)) ++person.unfelt;
    }
    person.rehearsal = person.answers > 0 && without_device == person.answers;
    for (std::size_t k = 0; k < record.answers.size(); ++k) {
        const PairAnswer& answer = record.answers[k];
        if (answer.trial.is_attention() && is_felt(record, k)) {
            person.attention.push_back(answer.similarity);
        }
        seconds += answer.response_s;
    }
    for (const SortingAnswer& answer : record.sortings) seconds += answer.response_s;
    person.minutes = seconds / 60.0;
    person.conduct = conduct_of(record);
    person.cut_short = cut_short_plays(record);
    person.excluded = reason_to_exclude(person, record, rule);
    if (person.excluded.empty()) person.excluded = fault_of_design(record, founder);
    return person;
}

std::string fault_of(const StudyRecord& record, const StudyRecord& first) {
    const std::string who = "participant " + in_quotes(record.header.participant.code);
    const std::string as = " as that of " + in_quotes(first.header.participant.code);
    if (record.header.kind != first.header.kind)
        return who + ": expected a study of the same kind" + as;
    if (record.header.patterns != first.header.patterns ||
        record.header.set_fingerprint != first.header.set_fingerprint) {
        return who + ": felt other patterns, expected the same" + as;
    }
    if (record.header.design.order != first.header.design.order) {
        return who + ": expected the same order of trials (full or adaptive)" + as;
    }
    return {};
}

// Tukey's lower fence on the agreement with the others; of fewer than four nobody is an outlier.
void mark_outliers(StudyResults& results) {
    std::vector<double> known;
    for (const ParticipantSummary& person : results.people) {
        if (!std::isnan(person.rho_with_others)) known.push_back(person.rho_with_others);
    }
    if (known.size() < 4) return;
    std::ranges::sort(known);
    const double low = quantile(known, 0.25);
    const double fence = low - 1.5 * (quantile(known, 0.75) - low);
    for (ParticipantSummary& person : results.people) {
        person.is_outlier = person.rho_with_others < fence;
    }
}

// In the order of their codes. Errors: as study_results().
Expected<std::vector<const StudyRecord*>> in_order(std::span<const StudyRecord> records) {
    if (records.empty()) return Error{"expected participants of a study, got none"};
    std::vector<const StudyRecord*> sorted;
    for (const StudyRecord& record : records) sorted.push_back(&record);
    const auto code = [](const StudyRecord* record) -> const std::string& {
        return record->header.participant.code;
    };
    std::ranges::stable_sort(sorted, {}, code);
    const auto equal = std::ranges::adjacent_find(sorted, {}, code);
    if (equal != sorted.end()) {
        return Error{"participant " + in_quotes(code(*equal)) +
                     " is there twice, expected one file each"};
    }
    for (const StudyRecord* record : sorted) {
        if (const std::string fault = fault_of(*record, records.front()); !fault.empty()) {
            return Error{fault};
        }
    }
    return sorted;
}

// Who is left out, and which answers of those who are not.
void say_what_was_excluded(StudyResults& results, const std::vector<LeftOutParticipant>& left_out) {
    results.remarks = remarks_on(left_out);
    for (const ParticipantSummary& person : results.people) {
        if (!person.excluded.empty() || person.unfelt == 0) continue;
        results.remarks.push_back(person.code + ": " +
                                  count_of(person.unfelt, person.answers, "answers") +
                                  " are left out, as nothing was felt or not the whole");
    }
    if (left_out.size() == results.people.size()) {
        results.remarks.emplace_back("nobody is counted: there are no ratings yet");
    }
}

}  // namespace

SimilarityScale scale_of(const StudyRecord& record, RatingScaling scaling) {
    std::vector<double> values;
    for (std::size_t k = 0; k < record.answers.size(); ++k) {
        const PairAnswer& answer = record.answers[k];
        if (!answer.trial.is_attention() && is_felt(record, k)) {
            values.push_back(answer.similarity);
        }
    }
    return scale_by(values, scaling);
}

std::vector<Judgement> judgements_of(const StudyRecord& record, RatingScaling scaling) {
    if (record.header.kind == StudyKind::pairwise) return judgements_of_answers(record, scaling);
    std::vector<Sorting> sortings;
    for (std::size_t k = 0; k < record.sortings.size(); ++k) {
        if (is_felt(record, k)) sortings.push_back(record.sortings[k].groups);
    }
    if (sortings.empty()) return {};
    Dissimilarity sorted = sorting_dissimilarity(record.header.patterns.size(), sortings);
    for (double& value : sorted.condensed) value *= 100.0;  // as the ratings of pairs
    return {{record.header.participant.code, std::move(sorted.condensed)}};
}

Dissimilarity ratings_of(const StudyRecord& record) {
    return mean_ratings({record.header.patterns, true, judgements_of(record, RatingScaling::none)});
}

std::vector<std::string> remarks_on_conduct(std::span<const StudyRecord> records,
                                            const ConductRule& rule) {
    std::vector<std::string> remarks;
    for (const ConductTest test : kConductTests) {
        if (!is_on(rule, test)) continue;
        std::string fallen;
        for (const StudyRecord& record : records) {
            if (fault_of(record, rule, test).empty()) continue;
            fallen += (fallen.empty() ? "" : ", ") + record.header.participant.code;
        }
        remarks.push_back("rule: " + words_on(rule, test) + "; " +
                          (fallen.empty() ? "nobody falls" : fallen + " fell") + " by it");
    }
    return remarks;
}

CollectRule rule_of(std::span<const StudyRecord> records) {
    CollectRule rule;
    if (!records.empty()) rule.attention = founder_of(records)->header.design.attention;
    return rule;
}

CountRule by_name(CountRule rule) {
    rule.conduct = {};
    return rule;
}

Expected<RatingStudy> ratings_of_everyone(std::span<const StudyRecord> records,
                                          const CollectRule& rule) {
    const auto sorted = in_order(records);
    if (!sorted) return sorted.error();
    const StudyHeader& header = records.front().header;
    RatingStudy study{header.patterns, true, {}, {}, header.set_fingerprint, header.versions};
    for (const StudyRecord* record : *sorted) {
        const ParticipantSummary person = summary_of(*record, *founder_of(records), rule);
        if (person.synthetic || !person.excluded.empty()) {
            study.standings.push_back(
                {person.code, person.synthetic, person.rehearsal, person.excluded});
        }
        for (Judgement& judgement : judgements_of(*record, rule.scaling)) {
            study.judgements.push_back(std::move(judgement));
        }
    }
    return study;
}

Expected<StudyResults> study_results(std::span<const StudyRecord> records,
                                     const CollectRule& rule) {
    Expected<RatingStudy> everyone = ratings_of_everyone(records, rule);
    if (!everyone) return everyone.error();
    StudyResults results;
    results.kind = records.front().header.kind;
    results.order = records.front().header.design.order;
    results.scaling = rule.scaling;
    const auto sorted = in_order(records);
    for (const StudyRecord* record : *sorted) {
        results.people.push_back(summary_of(*record, *founder_of(records), rule));
    }
    Expected<Counted> counted = who_counts(*std::move(everyone), by_name(rule.who));
    if (!counted) return counted.error();
    for (ParticipantSummary& person : results.people) {
        const auto left_out =
            std::ranges::find(counted->left_out, person.code, &LeftOutParticipant::participant);
        person.excluded = left_out == counted->left_out.end() ? "" : left_out->why;
    }
    results.study = std::move(counted->study);
    results.mark = mark_of(results.study);
    const std::vector<VoiceAgreement> agreement = agreement_with_others(results.study);
    for (ParticipantSummary& person : results.people) {
        const auto found = std::ranges::find(agreement, person.code, &VoiceAgreement::participant);
        if (found != agreement.end()) person.rho_with_others = found->rho;
    }
    mark_outliers(results);
    say_what_was_excluded(results, counted->left_out);
    for (std::string& remark : remarks_on_conduct(records, rule.who.conduct)) {
        results.remarks.push_back(std::move(remark));
    }
    results.mean = mean_ratings(results.study);
    results.agreement = reliability(results.study);
    return results;
}

std::vector<StudyRecord> counted_records(std::span<const StudyRecord> records,
                                         const StudyResults& results) {
    std::vector<StudyRecord> counted;
    for (const StudyRecord& record : records) {
        const auto person = std::ranges::find(results.people, record.header.participant.code,
                                              &ParticipantSummary::code);
        if (person != results.people.end() && person->excluded.empty()) counted.push_back(record);
    }
    return counted;
}

}  // namespace tact
