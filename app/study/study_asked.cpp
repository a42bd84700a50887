#include "app/study/study_asked.h"

#include <array>
#include <cmath>

#include "app/document/editing.h"
#include "app/study/study_follow.h"
#include "model/io/people/study_file.h"
#include "model/set/set_study.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

int whole(double value) { return static_cast<int>(std::lround(value)); }

constexpr Field count(const char* id, const char* label, Range slider, Range typed,
                      const char* help, const char* format = "%.0f") {
    return {.id = id,
            .label = label,
            .format = format,
            .slider = slider,
            .typed = typed,
            .step = 1,
            .snap = 1,
            .help = help};
}

constexpr Field seconds(const char* id, const char* label, const char* help) {
    return {.id = id,
            .label = label,
            .format = "%.2f s",
            .slider = {0.0, 3.0},
            .typed = limits::kPauseS,
            .step = 0.1,
            .snap = 0.1,
            .help = help};
}

const auto kTrials = std::to_array<StudyNumber>({
    {count("study_repetitions", "Repetitions", {1, 8}, limits::kRepetitions,
           "How often every pair is rated. The publication: 4."),
     [](const StudyDesign& d) { return double(d.repetitions); },
     [](StudyDesign& d, double value) { d.repetitions = whole(value); }},
    {count("study_attention", "Identical pairs", {0, 10}, limits::kAttentionPairs,
           "Trials with one pattern on both buttons, each time another: who does not rate them as "
           "the same was not attending. The publication: 1, which one in five blind answers pass."),
     [](const StudyDesign& d) { return double(d.attention_pairs); },
     [](StudyDesign& d, double value) { d.attention_pairs = whole(value); }},
    {count("study_above", "Pass mark", {50, 100}, limits::kSimilarity,
           "Similarity that identical patterns must exceed, or the participant is not counted. "
           "The publication: 80.",
           "%.0f of 100"),
     [](const StudyDesign& d) { return d.attention.above; },
     [](StudyDesign& d, double value) { d.attention.above = value; }},
    {count("study_failures", "Allowed failures", {0, 5}, limits::kAttentionPairs,
           "Identical pairs that a participant may miss and still be counted."),
     [](const StudyDesign& d) { return double(d.attention.failures_allowed); },
     [](StudyDesign& d, double value) { d.attention.failures_allowed = whole(value); }},
    {count("study_break", "Break every", {0, 200}, limits::kBreakEvery,
           "Trials between two breaks; 0: none.", "%.0f trials"),
     [](const StudyDesign& d) { return double(d.break_every); },
     [](StudyDesign& d, double value) { d.break_every = whole(value); }},
    {count("study_seed", "Seed", {0, 100}, limits::kStudySeed,
           "The order of trials and sides is drawn from the seed and the participant's code: the "
           "same again for the same two."),
     [](const StudyDesign& d) { return double(d.seed); },
     [](StudyDesign& d, double value) { d.seed = whole(value); }, false},
    {seconds("study_gap", "Gap", "Silence between two vibrations, at least. The publication: 1 s."),
     [](const StudyDesign& d) { return d.gap_s; },
     [](StudyDesign& d, double value) { d.gap_s = value; }, false},
    {seconds("study_rest", "Pause in training", "Silence after every vibration of the training."),
     [](const StudyDesign& d) { return d.rest_s; },
     [](StudyDesign& d, double value) { d.rest_s = value; }},
    {{.id = "study_masking",
      .label = "Masking noise",
      .format = "%.0f %%",
      .slider = {0.0, 100.0},
      .typed = {0.0, 100.0},
      .step = 5.0,
      .snap = 1.0,
      .help = "Level of pink noise, of full scale, on the participant's headphones, so that the "
              "actuator is felt "
              "and not heard; 0: off. It needs a second sound output."},
     [](const StudyDesign& d) { return 100.0 * d.masking; },
     [](StudyDesign& d, double value) { d.masking = value / 100.0; },
     false},
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
