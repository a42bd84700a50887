#include "app/command_line/people/people.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

#include "app/command_line/output.h"
#include "app/command_line/rated_sets.h"
#include "app/session/program_version.h"
#include "app/session/session.h"
#include "model/io/people/study_file.h"
#include "model/io/studies_out/experiment_pack.h"
#include "model/io/studies_out/packed_answers.h"
#include "model/set/set_ratings.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utc_time.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr const char* kIndent = "              ";

std::string with_interval(const Icc& icc) {
    return fixed_digits(icc.value, 3) + " (" + range_text(icc.interval.low, icc.interval.high, 2) +
           ")";
}

std::string text_of(const Shift& shift, const char* label, const char* what) {
    if (shift.comparisons == 0) return {};
    return std::string(label) + what + " " + fixed_digits(shift.mean, 1) +
           " points of 100 on average, " +
           (std::isnan(shift.p)
                ? signs_text(shift)
                : "p " + fixed_digits(shift.p, 4) + " (" + signs_text(shift) + ", two-sided)") +
           ", " + std::to_string(shift.people) + (shift.people == 1 ? " person\n" : " people\n");
}

nlohmann::json json_of(const Shift& shift) {
    return {{"people", shift.people},
            {"comparisons", shift.comparisons},
            {"mean_points", shift.mean},  // NaN becomes null
            {"p", shift.p},
            {"signs", shift.signs},
            {"all_signs", shift.is_exact}};
}

std::string ends_text(const IndividualWeights& weights, std::size_t dimension) {
    const DimensionEnds ends = ends_of(weights, dimension);
    return "dimension " + std::to_string(dimension + 1) + " leads from " + in_quotes(ends.low) +
           " to " + in_quotes(ends.high) + "\n";
}

constexpr const char* kFootOfWeights =
    "weight: how much of one's ratings stands in a dimension (INDSCAL, Carroll & Chang 1970; least "
    "squares on scalar products, each person's to one size, weights not below 0; the best of 21 "
    "starts, seed 1); explained: share of that; descriptions, nothing is tested\n";

}  // namespace

std::string text_of(const InterRater& raters) {
    if (raters.people < 2) return {};
    return std::string(kIndent) + "ICC(2,1) " + with_interval(raters.single) +
           " of one person, ICC(3,k) " + with_interval(raters.mean) + " of the mean of " +
           std::to_string(raters.people) + ", Krippendorff's alpha " +
           fixed_digits(raters.alpha, 3) + "\n" + kIndent + "(95 % intervals, of " +
           std::to_string(raters.pairs) +
           " pairs rated by all, as if pairs were independent; alpha of interval data)\n";
}

std::string text_of(const OrderEffects& effects) {
    return text_of(effects.felt_first, "order         ",
                   "of the pattern earlier in the set, felt first less second:") +
           text_of(effects.side, "sides         ",
                   "of the pattern earlier in the set, on the left less right:") +
           text_of(effects.practice, "practice      ", "last repetition less first:");
}

nlohmann::json json_of(const OrderEffects& effects) {
    return {{"felt_first", json_of(effects.felt_first)},
            {"side", json_of(effects.side)},
            {"practice", json_of(effects.practice)}};
}

std::string text_of(const IndividualWeights& weights) {
    if (weights.people.empty()) {
        return "no individual weights: they take two people who rated every pair, and two patterns "
               "more than dimensions\n";
    }
    TextRow head{"individual weights"};
    for (Eigen::Index r = 0; r < weights.group.cols(); ++r) {
        head.push_back("dimension " + std::to_string(r + 1));
    }
    head.emplace_back("explained");
    std::vector<TextRow> rows{head};
    for (const PersonWeights& person : weights.people) {
        TextRow row{person.participant};
        for (const double weight : person.weights) row.push_back(fixed_digits(weight, 3));
        row.push_back(fixed_digits(person.explained, 3));
        rows.push_back(row);
    }
    std::string text = aligned(rows);
    for (std::size_t r = 0; r < weights.mean.size(); ++r) text += ends_text(weights, r);
    for (const std::string& one : weights.left_out) {
        text += shown_text(one) + " did not rate every pair, or all alike, and has no weights\n";
    }
    return text + kFootOfWeights;
}

nlohmann::json json_of(const IndividualWeights& weights) {
    nlohmann::json people = nlohmann::json::array();
    for (const PersonWeights& person : weights.people) {
        people.push_back({{"participant", person.participant},
                          {"weights", person.weights},
                          {"explained", person.explained}});
    }
    nlohmann::json places = nlohmann::json::array();
    for (Eigen::Index i = 0; i < weights.group.rows(); ++i) {
        std::vector<double> place;
        for (Eigen::Index r = 0; r < weights.group.cols(); ++r) {
            place.push_back(weights.group(i, r));
        }
        places.push_back(place);
    }
    return {{"labels", weights.labels},
            {"common_map", places},
            {"people", people},
            {"left_out", weights.left_out},
            {"explained", people.empty() ? nlohmann::json() : nlohmann::json(weights.explained)}};
}

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

namespace {

namespace fs = std::filesystem;

// The .csv files of folders, in the order of their names, and single ones.
std::vector<fs::path> answer_files(const std::vector<fs::path>& paths) {
    std::vector<fs::path> files;
    for (const fs::path& path : paths) {
        std::error_code none;
        if (!fs::is_directory(path, none)) {
            files.push_back(path);
            continue;
        }
        const std::size_t before = files.size();
        for (const auto& entry : fs::directory_iterator(path, none)) {
            if (entry.path().extension() == ".csv") files.push_back(entry.path());
        }
        std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
    }
    return files;
}

}  // namespace

Expected<Done> write_new_folder(const fs::path& folder, const std::vector<DatasetFile>& files) {
    std::error_code none;
    if (fs::exists(folder, none) && !fs::is_empty(folder, none)) {
        return Error{folder.string() + ": expected a folder that is empty or not there"};
    }
    for (const DatasetFile& file : files) {
        const fs::path path = folder / fs::path(file.path);
        if (const auto made = make_folder(path.parent_path()); !made) return made;
        if (const auto written = write_atomically(path, file.text); !written) return written;
    }
    return Done{};
}

Expected<Done> pack_study(const StudyCommand& command, const PatternSet& set) {
    if (command.out.empty()) return Error{"--pack: expected a folder as --out"};
    if (command.sorting || command.adaptive) {
        return Error{"--pack: expected pairs in the full order, which alone can be packed"};
    }
    const PackFor what = command.pack == kPackNames[0] ? PackFor::jspsych : PackFor::psychopy;
    const auto count = static_cast<std::size_t>(command.participants);
    const auto files = pack_files(set, what, count);
    if (!files) return files.error();
    if (const auto written = write_new_folder(command.out, *files); !written) return written;
    std::cerr << "tactspace: packed trials of " << counted(count, "participant", "participants")
              << " into " << command.out.string() << ", see README.txt there\n";
    return Done{};
}

Expected<Done> unpack_study(const StudyCommand& command, StudyHeader header) {
    if (command.out.empty()) return Error{"--unpack: expected a folder as --out"};
    header.device = {"not told", "uncalibrated", {}};
    std::vector<StudyRecord> records;
    for (const fs::path& file : answer_files(command.unpack)) {
        const Expected<std::string> text = read_text_file(file);
        if (!text) return text.error();
        Expected<std::vector<StudyRecord>> read = packed_answers(*text, file.string(), header);
        if (!read) return read.error();
        for (StudyRecord& record : *read) {
            const std::string& code = record.header.participant.code;
            const bool is_known = std::ranges::any_of(records, [&code](const StudyRecord& other) {
                return other.header.participant.code == code;
            });
            if (is_known) {
                return Error{file.string() + ": expected each participant in one file, got " +
                             in_quotes(code) + " again"};
            }
            records.push_back(std::move(record));
        }
    }
    if (records.empty()) return Error{"--unpack: expected .csv files, got none"};
    for (const StudyRecord& record : records) {
        if (record.header.set_fingerprint == header.set_fingerprint) continue;
        std::cerr << "tactspace: the patterns have changed since they were packed\n";
        break;
    }
    if (const auto made = make_folder(command.out); !made) return made;
    for (const StudyRecord& record : records) {
        const fs::path file = command.out / study_file_name(record.header.participant.code);
        std::error_code none;
        if (fs::exists(file, none)) {
            return Error{file.string() +
                         ": is there already, expected a folder without this "
                         "participant"};
        }
    }
    for (const StudyRecord& record : records) {
        const auto written =
            write_study_file(command.out / study_file_name(record.header.participant.code), record);
        if (!written) return written;
    }
    std::cerr << "tactspace: " << counted(records.size(), "participant", "participants") << " in "
              << command.out.string() << "\n";
    return Done{};
}

}  // namespace tact
