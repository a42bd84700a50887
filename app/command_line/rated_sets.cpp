#include "app/command_line/rated_sets.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>

#include "app/command_line/output.h"
#include "model/io/people/exclusions_file.h"
#include "model/io/people/ratings_file.h"
#include "model/io/people/study_file.h"
#include "model/set/felt_versions.h"
#include "model/set/measured_twin.h"
#include "model/tasks/set_people.h"
#include "model/text/shown_text.h"
#include "model/text/utc_time.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

RatingScale scale_of(const std::string& word) {
    if (word == "similarity") return RatingScale::similarity;
    if (word == "dissimilarity") return RatingScale::dissimilarity;
    return RatingScale::guess;
}

// The ratings that a set file brings along, each as one voice.
Expected<Counted> own_ratings(const PatternSet& set, const fs::path& path, const CountRule& who) {
    if (set.ratings.empty()) {
        return Error{path.string() + ": has no ratings of its own, expected --ratings FILE"};
    }
    Expected<Counted> counted = set_people(set, who);
    if (!counted) return Error{path.string() + ": " + counted.error().message};
    return counted;
}

// `set`: before --side and --exported-as.
Expected<Counted> ratings_for(const PatternSet& set, const fs::path& path,
                              std::span<const fs::path> files, const RatingFiles& how) {
    if (files.empty()) return own_ratings(set, path, how.who);
    const Expected<AnswerColumns> columns = told_columns(how.columns, how.written);
    if (!columns) return columns.error();
    Expected<LoadedRatings> loaded = read_ratings(files, scale_of(how.scale), how.who, *columns);
    if (!loaded) return with_columns_option(loaded.error());
    for (const std::string& remark : loaded->remarks) std::cerr << "tactspace: " << remark << "\n";
    Expected<RatingStudy> study = matched(loaded->study, names_of(set));
    if (!study) return Error{files.front().string() + ": " + study.error().message};
    if (const auto recorded = record_who_counts(files, how.who); !recorded) {
        return recorded.error();
    }
    note_edited(*study, set);
    return Counted{*std::move(study), std::move(loaded->left_out)};
}

// People rated intended patterns: on the measured side each is stood in for by its twin.
PatternSet of_side(const PatternSet& set, Side side) {
    return side == Side::measured ? measured_stand_ins(set) : one_side(set, side);
}

// Twins are a likely reason for ratings that do not fit.
Error with_hint(Error error, const PatternSet& set) {
    if (std::ranges::any_of(set.vibrations, measures_another)) {
        error.message += " (--only intended leaves out what measures another pattern)";
    }
    return error;
}

}  // namespace

std::string text_on(const std::vector<LeftOutParticipant>& left_out) {
    std::string text;
    for (const std::string& remark : remarks_on(left_out)) text += shown_text(remark) + "\n";
    return text;
}

Expected<Done> record_who_counts(std::span<const fs::path> files, const CountRule& who) {
    std::error_code none;
    for (const fs::path& file : files) {
        if (!is_study(file)) {
            if (!who.because.empty()) {
                std::cerr << "tactspace: " << file.string()
                          << " is no study's folder: who is excluded is so this once\n";
            }
            continue;
        }
        const fs::path folder = fs::is_directory(file, none) ? file : file.parent_path();
        const auto said = record_exclusions(folder, who, utc_now());
        if (!said) return said.error();
        for (const std::string& one : *said) std::cerr << "tactspace: " << one << "\n";
    }
    return Done{};
}

nlohmann::json json_of(const std::vector<LeftOutParticipant>& left_out) {
    nlohmann::json all = nlohmann::json::array();
    for (const LeftOutParticipant& one : left_out) {
        all.push_back({{"participant", one.participant}, {"why", one.why}});
    }
    return all;
}

Expected<std::vector<RatedPatterns>> load_rated(const CommonOptions& common,
                                                const RatingFiles& files) {
    const auto& sets = common.sets;
    const auto& ratings = files.files;
    if (sets.size() > 1 && !ratings.empty() && ratings.size() != sets.size()) {
        return Error{"expected a file or a folder of ratings for each of the " +
                     std::to_string(sets.size()) + " sets, got " + std::to_string(ratings.size())};
    }
    std::vector<RatedPatterns> all;
    for (std::size_t k = 0; k < sets.size(); ++k) {
        CommonOptions one = common;
        one.sets = {sets[k]};
        one.only = Side::both;  // the ratings decide who stands for which
        Expected<FeltSet> loaded = load_felt(one);
        if (!loaded) return loaded.error();
        const PatternSet set = of_side(loaded->felt, common.only);
        loaded->labels.only = common.only;
        loaded->labels.mark.synthetic_patterns = has_synthetic_patterns(set);
        if (const auto pair = need_a_pair(set, one); !pair) return pair.error();
        const auto all_files = std::span(ratings);
        const bool one_each = sets.size() > 1 && !ratings.empty();
        auto people = ratings_for(of_side(loaded->meant, common.only), sets[k],
                                  one_each ? all_files.subspan(k, 1) : all_files, files);
        if (!people) return with_hint(people.error(), set);
        // What measures a pattern is no version of it.
        if (common.only == Side::measured) people->study.edited.clear();
        loaded->labels.edited = people->study.edited;
        if (!people->study.edited.empty()) {
            std::cerr << "tactspace: the patterns have changed since they were felt\n";
        }
        loaded->labels.mark = loaded->labels.mark | mark_of(people->study);
        loaded->labels.gone = people->study.gone;
        if (!people->study.gone.empty()) {
            std::cerr << "tactspace: " << words_on_gone(people->study.gone) << "\n";
        }
        const auto unrated = unrated_patterns(people->study);
        if (!unrated.empty()) {
            std::cerr << "tactspace: " << remark_on_unrated(unrated, set.vibrations.size()) << "\n";
        }
        std::string name = set.name.empty() ? sets[k].filename().string() : set.name;
        if (common.only != Side::both) {
            name += std::string(", ") + kSideNames[static_cast<std::size_t>(common.only)];
        }
        all.push_back({set, name, std::move(people->study), std::move(people->left_out),
                       std::move(loaded->labels)});
    }
    return all;
}

Expected<AnswerColumns> told_columns(const std::string& columns, const TableHints& written) {
    Expected<AnswerColumns> told = answer_columns(columns);
    if (!told) return Error{"--columns: " + told.error().message};
    told->written = written;
    return told;
}

Error with_columns_option(Error error) {
    const bool lists_columns = error.message.find("; the columns are ") != std::string::npos;
    if (lists_columns) error.message += "; --columns a=..,b=..,rating=.. says which";
    return error;
}

namespace {

// Says how a table was understood, if it was read.
template <class Table>
Expected<Table> with_its_remarks(const std::filesystem::path& file, Expected<Table> table) {
    if (!table) return table;
    for (const std::string& remark : table->remarks) {
        std::cerr << "tactspace: " << shown_text(file.string() + ": " + remark) << "\n";
    }
    return table;
}

}  // namespace

Expected<LabelledMatrix> told_matrix(const std::filesystem::path& file, const TableHints& written) {
    return with_its_remarks(file, read_matrix_file(file, written));
}

Expected<LabelledPoints> told_points(const std::filesystem::path& file, const TableHints& written) {
    return with_its_remarks(file, read_coordinates_file(file, written));
}

Expected<Dissimilarity> dissimilarities_in(const std::filesystem::path& file,
                                           const std::vector<std::string>& names,
                                           const TableHints& written, NumberMark* mark) {
    const Expected<LabelledMatrix> matrix = told_matrix(file, written);
    if (!matrix) return matrix.error();
    if (mark != nullptr) *mark = matrix->mark;
    return dissimilarities_of(*matrix, names, file.string());
}

}  // namespace tact
