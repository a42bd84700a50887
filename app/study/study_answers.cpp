#include "app/study/study_answers.h"

#include <utility>

#include "model/set/set_study.h"

namespace tact {

namespace {

constexpr int kStartsOfWeights = 5;  // enough for a look, as below

// Enough for a look; the numbers of Compare come from the standard search.
PerceptualSpace quick_map(const Dissimilarity& dissimilarity, std::stop_token stop) {
    MdsParams params;
    params.random_starts = 20;
    params.tolerance = 1e-7;
    params.threads = 1;
    return nonmetric_mds(dissimilarity, params, stop);
}

// Splits records into those of the kind asked for, and the others.
void part_by_kind(StudyAnswers& answers, std::vector<StudyRecord> records) {
    for (StudyRecord& record : records) {
        const bool is_wanted = record.header.kind == answers.question.kind;
        (is_wanted ? answers.records : answers.others).push_back(std::move(record));
    }
}

void follow_settling(StudyAnswers& answers) {
    const StudyRecord& latest = answers.records.back();
    if (latest.header.kind != StudyKind::pairwise) return;
    if (latest.header.design.order != StudyOrder::adaptive) return;
    answers.settling = map_settling(latest.header.patterns.size(), rated_trials(latest));
}

}  // namespace

std::optional<StudyAnswers> read_answers(const StudyQuestion& question, std::stop_token stop,
                                         std::atomic<float>& progress) {
    StudyAnswers answers;
    answers.question = question;
    std::error_code none;
    if (!std::filesystem::is_directory(question.folder, none)) return answers;
    Expected<std::vector<StudyRecord>> records = read_study_folder(question.folder);
    if (!records) {
        // A folder without participants is a beginning, not a fault.
        if (!contains_study(question.folder)) return answers;
        answers.fault = records.error().message;
        return answers;
    }
    part_by_kind(answers, *std::move(records));
    if (answers.records.empty()) return answers;
    answers.founder = founder_of(answers.records)->header;
    answers.is_of_other_patterns =
        question.set == nullptr ||
        answers.records.front().header.set_fingerprint !=
            study_fingerprint(*question.set, study_patterns(*question.set));
    Expected<StudyResults> results = study_results(answers.records, question.rule);
    if (!results) {
        answers.fault = results.error().message;
        return answers;
    }
    answers.results = *std::move(results);
    answers.raters = inter_rater(answers.results->study);
    answers.effects = order_effects(counted_records(answers.records, *answers.results));
    const RatingStudy& counted = answers.results->study;
    const std::size_t rated = counted.labels.size() - unrated_patterns(counted).size();
    answers.weights = individual_weights(counted, shown_weight_dimensions(rated), kStartsOfWeights);
    answers.mean_map = quick_map(answers.results->mean, stop);
    for (const StudyRecord& record : answers.records) {
        if (stop.stop_requested()) return std::nullopt;
        answers.matrices.push_back(ratings_of(record));
        answers.maps.push_back(quick_map(answers.matrices.back(), stop));
        progress =
            static_cast<float>(answers.maps.size()) / static_cast<float>(answers.records.size());
    }
    follow_settling(answers);
    return answers;
}

}  // namespace tact
