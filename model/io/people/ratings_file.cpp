#include "model/io/people/ratings_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_set>
#include <utility>

#include "model/io/people/ratings_text.h"
#include "model/io/people/study_file.h"
#include "model/io/recordings/recording.h"
#include "model/study/study_results.h"
#include "model/text/atomic_file.h"
#include "model/text/names.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace fs = std::filesystem;

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
double mean(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return values.empty() ? kUnknown : sum / static_cast<double>(values.size());
}

std::string rounded(double value) { return shortest_digits(std::round(value * 10.0) / 10.0); }

// The scale that the ratings of identical pairs speak for, and a remark that says so.
RatingScale guessed(const RatingsText& reading, std::vector<std::string>& remarks) {
    std::vector<double> others;
    for (const Judgement& judgement : reading.study.judgements) {
        for (const double value : judgement.condensed) {
            if (!std::isnan(value)) others.push_back(value);
        }
    }
    const double same = mean(reading.identical);
    const bool is_similarity = same > mean(others);
    const std::string what = is_similarity ? "similarities from 0 to 100" : "dissimilarities";
    const std::string why = reading.identical.empty()
                                ? "no rating of identical patterns tells which they are"
                                : "identical patterns are rated " + rounded(same) + ", others " +
                                      rounded(mean(others)) + " on average";
    remarks.push_back(reading.file + ": taken as " + what + ", as " + why);
    return is_similarity ? RatingScale::similarity : RatingScale::dissimilarity;
}

// Numbers as dissimilarities; what is wrong with one of them, or empty.
std::string turn(RatingStudy& study, RatingScale scale, bool is_scaled) {
    for (Judgement& judgement : study.judgements) {
        for (std::size_t p = 0; p < judgement.condensed.size(); ++p) {
            double& value = judgement.condensed[p];
            const bool is_similarity = scale == RatingScale::similarity;
            const bool is_out = value < 0.0 || (is_similarity && value > 100.0);
            if (is_out && !is_scaled) {
                const auto [i, j] = pair_at(study.labels.size(), p);
                return std::string("expected ") +
                       (is_similarity ? "similarities from 0 to 100"
                                      : "dissimilarities that are not negative") +
                       ", got " + shortest_digits(value) + " for " + in_quotes(study.labels[i]) +
                       " and " + in_quotes(study.labels[j]);
            }
            if (is_similarity) value = 100.0 - value;
        }
    }
    return {};
}

// Ratings of those who count.
Expected<LoadedRatings> gated(RatingStudy study, std::vector<std::string> remarks,
                              const std::string& file, const CountRule& who) {
    auto counted = who_counts(std::move(study), who);
    if (!counted) return Error{file + ": " + counted.error().message};
    if (counted->study.judgements.empty()) {
        const std::string why =
            counted->left_out.empty() ? "" : ": " + remarks_on(counted->left_out).front();
        return Error{file + ": expected a participant who counts, got none" + why};
    }
    for (std::string& remark : remarks_on(counted->left_out)) remarks.push_back(std::move(remark));
    return LoadedRatings{std::move(counted->study), std::move(remarks),
                         std::move(counted->left_out)};
}

Expected<LoadedRatings> finished(RatingsText reading, RatingScale scale, const CountRule& who) {
    std::vector<std::string> remarks = std::move(reading.remarks);
    if (reading.averaged > 0) {
        remarks.push_back(
            reading.file + ": the mean is taken of " + grouped_digits(reading.averaged) +
            (reading.averaged == 1 ? " pair" : " pairs") + " with another rating in either order");
    }
    if (reading.is_scaled) {
        remarks.push_back(reading.file + ": the column scaled is taken, not rating");
    }
    if (scale == RatingScale::guess) scale = reading.scale;
    if (scale == RatingScale::guess) scale = guessed(reading, remarks);
    if (const std::string fault = turn(reading.study, scale, reading.is_scaled); !fault.empty()) {
        return Error{reading.file + ": " + fault};
    }
    return gated(std::move(reading.study), std::move(remarks), reading.file, who);
}

// The most ratings of all together that are read: a gigabyte.
constexpr std::size_t kMostCells = 125'000'000;

// What is wrong with how many there are, or empty.
std::string fault_of_size(const RatingStudy& study) {
    const std::size_t pairs = std::max<std::size_t>(pair_count(study.labels.size()), 1);
    std::unordered_set<std::string_view> people;
    for (const Judgement& judgement : study.judgements) people.insert(judgement.participant);
    if (people.size() > kMaxParticipants) return "expected at most 1,000 participants";
    if (study.judgements.size() > kMostCells / pairs) {
        return "expected at most " + grouped_digits(kMostCells / pairs) + " passes through " +
               grouped_digits(pairs) + " pairs, got " + grouped_digits(study.judgements.size());
    }
    return {};
}

// Participants' files as a study collected by its own rule.
Expected<LoadedRatings> read_records(std::span<const fs::path> paths, const CountRule& who) {
    const std::string name = paths.front().string();
    const auto records = read_studies(paths);
    if (!records) return records.error();
    CollectRule rule = rule_of(*records);
    rule.who = who;
    auto everyone = ratings_of_everyone(*records, rule);
    if (!everyone) return Error{name + ": " + everyone.error().message};
    return gated(*std::move(everyone), remarks_on_conduct(*records, who.conduct), name,
                 by_name(who));
}

// A folder's .csv and .txt files, in natural order; of a study's report its answers; of a file, the
// file.
Expected<std::vector<fs::path>> files_at(const fs::path& path) {
    std::error_code fault;
    if (!fs::is_directory(path, fault)) return std::vector<fs::path>{path};
    if (fs::exists(path / kAnswersFile, fault)) return std::vector<fs::path>{path / kAnswersFile};
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(path, fault), end; !fault && entry != end;
         entry.increment(fault)) {
        const std::string kind = extension_of(entry->path());
        if (kind == ".csv" || kind == ".txt") files.push_back(entry->path());
    }
    if (fault) return Error{path.string() + ": cannot be read: " + fault.message()};
    if (files.empty()) {
        return Error{path.string() + ": expected .csv or .txt files of ratings, got none"};
    }
    std::ranges::sort(files, [](const fs::path& a, const fs::path& b) {
        return naturally_before(a.stem().string(), b.stem().string());
    });
    return files;
}

// Whoever has no name goes by that of the file; numbers of rows are the file's own.
void name_participants(RatingStudy& study, const fs::path& path, bool is_only) {
    const std::string stem = path.stem().string();
    for (Judgement& judgement : study.judgements) {
        if (judgement.participant.empty()) {
            judgement.participant = stem;
        } else if (!study.is_named && !is_only) {
            judgement.participant = stem + " " + judgement.participant;
        }
    }
    for (Standing& standing : study.standings) {
        if (standing.participant.empty()) standing.participant = stem;
    }
}

// A further file into the reading of the first ones.
Expected<Done> take_file(RatingsText& all, RatingsText more) {
    auto moved = spread_over(more.study, all.study.labels);
    if (more.study.is_named != all.study.is_named) {
        return Error{more.file + ": expected " + (all.study.is_named ? "names" : "no names") +
                     " of patterns, as in " + all.file};
    }
    if (!moved) return Error{more.file + ": " + moved.error().message + ", as in " + all.file};
    for (Judgement& judgement : moved->judgements) {
        all.study.judgements.push_back(std::move(judgement));
    }
    all.identical.insert(all.identical.end(), more.identical.begin(), more.identical.end());
    all.averaged += more.averaged;
    if (all.scale != more.scale) all.scale = RatingScale::guess;
    if (all.is_scaled != more.is_scaled) {
        return Error{more.file + ": expected the column scaled in all files or in none, as in " +
                     all.file};
    }
    for (Standing& standing : more.study.standings) {
        all.study.standings.push_back(std::move(standing));
    }
    all.study.left_out += more.study.left_out;
    all.study.rehearsals += more.study.rehearsals;
    for (std::string& remark : more.remarks) all.remarks.push_back(std::move(remark));
    if (all.study.fingerprint != more.study.fingerprint) all.study.fingerprint.clear();
    return Done{};
}

}  // namespace

Expected<LoadedRatings> parse_ratings(std::string_view text, const std::string& file,
                                      RatingScale scale, const CountRule& who,
                                      const AnswerColumns& columns) {
    auto reading = ratings_text(text, file, columns);
    if (!reading) return reading.error();
    if (const std::string fault = fault_of_size(reading->study); !fault.empty()) {
        return Error{file + ": " + fault};
    }
    name_participants(reading->study, file, true);
    return finished(*std::move(reading), scale, who);
}

Expected<LoadedRatings> read_ratings(std::span<const fs::path> paths, RatingScale scale,
                                     const CountRule& who, const AnswerColumns& columns) {
    const auto studies = std::ranges::count_if(paths, is_study);
    if (studies > 0 && studies == std::ssize(paths)) return read_records(paths, who);
    std::vector<fs::path> files;
    for (const fs::path& path : paths) {
        const auto found = files_at(path);
        if (!found) return found.error();
        files.insert(files.end(), found->begin(), found->end());
    }
    if (files.empty()) return Error{"expected a file of ratings, got none"};
    std::optional<RatingsText> all;
    for (const fs::path& file : files) {
        const auto text = read_text_file(file);
        if (!text) return text.error();
        auto reading = ratings_text(*text, file.string(), columns);
        if (!reading) return reading.error();
        name_participants(reading->study, file, files.size() == 1);
        if (!all) {
            all = *std::move(reading);
        } else if (const auto taken = take_file(*all, *std::move(reading)); !taken) {
            return taken.error();
        }
        if (const std::string fault = fault_of_size(all->study); !fault.empty()) {
            return Error{file.string() + ": " + fault};
        }
    }
    return finished(*std::move(all), scale, who);
}

}  // namespace tact
