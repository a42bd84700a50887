#include "app/study/study.h"

#include <array>
#include <utility>

#include "app/document/editing.h"
#include "app/study/parts.h"
#include "model/io/people/study_file.h"
#include "model/set/set_ratings.h"
#include "model/study/study_numbers.h"

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

namespace fs = std::filesystem;

namespace {

template <const Number& number, auto... path>
constexpr DescribedField<StudyDesign> row(const char* id) {
    return described_field<number, StudyDesign, path...>(id);
}

using Design = StudyDesign;

constexpr auto kTrials = std::to_array<StudyNumber>({
    {row<numbers::kRepetitions, &Design::repetitions>("study_repetitions")},
    {row<numbers::kAttentionPairs, &Design::attention_pairs>("study_attention")},
    {row<numbers::kPassMark, &Design::attention, &AttentionRule::above>("study_above")},
    {row<numbers::kFailuresAllowed, &Design::attention, &AttentionRule::failures_allowed>(
        "study_failures")},
    {row<numbers::kBreakEvery, &Design::break_every>("study_break")},
    {row<numbers::kStudySeed, &Design::seed>("study_seed"), false},
    {row<numbers::kGap, &Design::gap_s>("study_gap"), false},
    {row<numbers::kRest, &Design::rest_s>("study_rest")},
    {row<numbers::kMasking, &Design::masking>("study_masking"), false},
});

}  // namespace

std::span<const StudyNumber> study_numbers() { return kTrials; }

namespace {

// The study as the document has it. The fingerprint is empty: of a large set it takes longer than
// a frame may.
StudyHeader asked_now(const Workspace& work, const StudyState& studying) {
    StudyHeader header;
    header.kind = studying.kind;
    header.patterns = study_names(work);
    header.design = work.document.set.study;
    return header;
}

}  // namespace

std::vector<std::string> design_changes(const Workspace& work, const StudyState& studying) {
    const auto& answers = studying.answers;
    if (!answers || !answers->founder || answers->question.kind != studying.kind ||
        answers->question.folder != study_folder(work, studying)) {
        return {};
    }
    StudyHeader now = asked_now(work, studying);
    // What patterns feel like was compared where the answers were read.
    const std::string& felt = answers->founder->set_fingerprint;
    now.set_fingerprint = answers->is_of_other_patterns ? "edited" : felt;
    return changes_since(*answers->founder, now);
}

std::string another_study_words(const std::vector<std::string>& changes) {
    return "This is another study than that of the folder's first participant: " +
           words_on_changes(changes) + ".";
}

std::string design_obstacle(const Workspace& work, const StudyState& studying) {
    const auto changes = design_changes(work, studying);
    return changes.empty() ? "" : another_study_words(changes);
}

void begin_another_study(Ui& ui, const Workspace& work, StudyState& studying) {
    StudyHeader now = asked_now(work, studying);
    now.set_fingerprint = study_fingerprint(work.document.set, now.patterns);
    const fs::path folder = study_folder(work, studying);
    fs::path beside;
    for (int number = 2;
         beside.empty() || (contains_study(beside) && (!changes_on_disk(beside, now).empty()));
         ++number) {
        beside = folder.parent_path() / (folder.filename().string() + " " + std::to_string(number));
    }
    set_study_folder(work, studying, beside);
    ++studying.folder_revision;
    say(ui, "Participants of this study are in " + beside.string() + ".");
}

void take_design_back(Ui& ui, Workspace& work, const StudyState& studying) {
    if (!studying.answers || !studying.answers->founder) return;
    const StudyHeader& founder = *studying.answers->founder;
    StudyDesign& design = work.document.edit().study;
    StudyDesign fixed = founder.design;
    // Nobody is asked by these.
    fixed.seed = design.seed;
    fixed.headphones = design.headphones;
    fixed.attention = design.attention;
    // The words of the other kind of study are not the founder's.
    if (founder.kind == StudyKind::pairwise) fixed.groups = design.groups;
    if (study_names(work) != founder.patterns) fixed.patterns = founder.patterns;
    design = fixed;
    if (study_names(work).size() == work.document.set.vibrations.size()) design.patterns.clear();
    document_changed(work);
    commit_step(ui, work, "Take the study's design back");
    say(ui, "The design is that of " + founder.participant.code + " again.");
}

}  // namespace tact
