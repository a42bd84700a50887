#include "model/io/people/ratings_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "model/io/people/ratings_text.h"
#include "model/io/recordings/recording.h"
#include "model/text/atomic_file.h"
#include "model/text/natural_order.h"
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
    if (reading.is_similarity) return RatingScale::similarity;
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
std::string turn(RatingStudy& study, RatingScale scale) {
    for (Judgement& judgement : study.judgements) {
        for (std::size_t p = 0; p < judgement.condensed.size(); ++p) {
            double& value = judgement.condensed[p];
            const bool is_similarity = scale == RatingScale::similarity;
            if (value < 0.0 || (is_similarity && value > 100.0)) {
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

Expected<LoadedRatings> finished(RatingsText reading, RatingScale scale) {
    LoadedRatings loaded;
    if (reading.averaged > 0) {
        loaded.remarks.push_back(
            reading.file + ": the mean is taken of " + grouped_digits(reading.averaged) +
            (reading.averaged == 1 ? " pair" : " pairs") + " with another rating in either order");
    }
    if (scale == RatingScale::guess) scale = guessed(reading, loaded.remarks);
    if (const std::string fault = turn(reading.study, scale); !fault.empty()) {
        return Error{reading.file + ": " + fault};
    }
    loaded.study = std::move(reading.study);
    return loaded;
}

Error too_many(const std::string& file) {
    return Error{file + ": expected at most 1,000 judgements"};
}

// A folder's .csv and .txt files, in natural order; of a file, the file.
Expected<std::vector<fs::path>> files_at(const fs::path& path) {
    std::error_code fault;
    if (!fs::is_directory(path, fault)) return std::vector<fs::path>{path};
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
    for (Judgement& judgement : study.judgements) {
        const std::string stem = path.stem().string();
        if (judgement.participant.empty()) {
            judgement.participant = stem;
        } else if (!study.is_named && !is_only) {
            judgement.participant = stem + " " + judgement.participant;
        }
    }
}

// A further file into the reading of the first ones.
Expected<Done> take_file(RatingsText& all, RatingsText more) {
    auto moved = matched(more.study, all.study.labels);
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
    all.is_similarity = all.is_similarity && more.is_similarity;
    return Done{};
}

}  // namespace

Expected<LoadedRatings> parse_ratings(std::string_view text, const std::string& file,
                                      RatingScale scale) {
    auto reading = ratings_text(text, file);
    if (!reading) return reading.error();
    if (reading->study.judgements.size() > kMaxJudgements) return too_many(file);
    name_participants(reading->study, file, true);
    return finished(*std::move(reading), scale);
}

Expected<LoadedRatings> read_ratings(std::span<const fs::path> paths, RatingScale scale) {
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
        auto reading = ratings_text(*text, file.string());
        if (!reading) return reading.error();
        name_participants(reading->study, file, files.size() == 1);
        if (!all) {
            all = *std::move(reading);
        } else if (const auto taken = take_file(*all, *std::move(reading)); !taken) {
            return taken.error();
        }
        if (all->study.judgements.size() > kMaxJudgements) {
            return too_many(file.string());
        }
    }
    return finished(*std::move(all), scale);
}

}  // namespace tact
