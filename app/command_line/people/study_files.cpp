#include "app/command_line/people/study_files.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include "app/command_line/rated_sets.h"
#include "app/session/program_version.h"
#include "model/io/people/study_file.h"
#include "model/set/set_study.h"
#include "model/text/utc_time.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

namespace fs = std::filesystem;

RatingScaling scaling_of(const std::string& word) {
    const auto found = std::ranges::find(kScalingNames, word);
    return static_cast<RatingScaling>(found - std::begin(kScalingNames));
}

// Records of one kind, felt from this set.
Expected<std::vector<StudyRecord>> records_for(const StudyCommand& command, const PatternSet& set) {
    const fs::path folder = study_folder_of(command);
    Expected<std::vector<StudyRecord>> records = read_study_folder(folder);
    if (!records) return records;
    const StudyKind kind = command.sorting ? StudyKind::sorting : StudyKind::pairwise;
    std::erase_if(*records, [kind](const StudyRecord& one) { return one.header.kind != kind; });
    if (records->empty()) {
        return Error{folder.string() + ": expected participants who " +
                     (command.sorting ? "sorted patterns, got others; leave out --sorting"
                                      : "rated pairs, got others; for those who sorted --sorting")};
    }
    const StudyHeader& header = records->front().header;
    for (const std::string& name : header.patterns) {
        if (!place_named(set, name)) {
            return Error{folder.string() + ": has answers about " + in_quotes(name) +
                         ", expected patterns of the set"};
        }
    }
    return records;
}

}  // namespace

fs::path study_folder_of(const StudyCommand& command) {
    if (!command.collect.empty()) return command.collect;
    const fs::path& set = command.common.sets.front();
    std::string stem = set.stem().string();
    if (stem.ends_with(".tactspace")) stem.resize(stem.size() - 10);
    return set.parent_path() / (stem + " study");
}

Expected<CollectedStudy> collected_study(const StudyCommand& command, const PatternSet& set) {
    CollectedStudy study;
    Expected<std::vector<StudyRecord>> records = records_for(command, set);
    if (!records) return records.error();
    study.records = *std::move(records);
    const StudyHeader& header = study.records.front().header;
    study.has_changed = study_fingerprint(set, header.patterns) != header.set_fingerprint;
    if (study.has_changed) {
        std::cerr << "tactspace: the patterns have changed since they were felt\n";
    }
    CollectRule rule = rule_of(study.records);
    rule.attention.above = command.attention_above.value_or(rule.attention.above);
    rule.attention.failures_allowed =
        command.failures_allowed.value_or(rule.attention.failures_allowed);
    rule.unfinished_too = command.unfinished;
    rule.scaling = scaling_of(command.scaling);
    rule.who = command.who;
    study.rule = rule;
    Expected<StudyResults> results = study_results(study.records, rule);
    if (!results) return results.error();
    study.results = *std::move(results);
    const fs::path folder = study_folder_of(command);
    if (const auto recorded = record_who_counts({&folder, 1}, rule.who); !recorded) {
        return recorded.error();
    }
    return study;
}

StudyDataset dataset_of(const PatternSet& set, const CollectedStudy& study) {
    return {set.name.empty() ? "A rating study" : set.name,
            kProgramVersion,
            utc_today(),
            study.records,
            study.results,
            set};
}

}  // namespace tact
