#include "model/set/set_ratings.h"

#include <algorithm>
#include <cmath>

namespace tact {

bool is_synthetic(const Ratings& ratings) { return ratings.file.starts_with(kSyntheticRatings); }

std::string ratings_source(const std::string& file, std::size_t left_out) {
    if (left_out == 0) return file;
    return file + " (" + std::to_string(left_out) +
           (left_out == 1 ? " participant left out)" : " participants left out)");
}

std::vector<Ratings> kept_ratings(const RatingStudy& study, const std::string& file) {
    const bool is_many = study.judgements.size() > kMostKeptRatings;
    const std::string marked =
        (file.starts_with(kSyntheticRatings) ? "" : kSyntheticRatings) + file;
    std::vector<Ratings> kept;
    for (const Judgement& judgement : is_many ? participant_means(study) : study.judgements) {
        const auto standing =
            std::ranges::find(study.standings, judgement.participant, &Standing::participant);
        const bool is_nobody = standing != study.standings.end() && standing->synthetic;
        Ratings ratings{judgement.participant,
                        study.labels,
                        judgement.condensed,
                        {},
                        is_nobody ? marked : file};
        std::ranges::replace_if(
            ratings.condensed, [](double value) { return std::isnan(value); }, kUnrated);
        kept.push_back(std::move(ratings));
    }
    return kept;
}

Expected<RatingStudy> study_of(const PatternSet& set) {
    if (set.ratings.empty()) return Error{"expected ratings of the patterns, got none"};
    RatingStudy study;
    study.labels = names_of(set);
    for (const Ratings& ratings : set.ratings) {
        const RatingStudy one{ratings.labels, true, {{ratings.name, ratings.condensed}}};
        const Expected<RatingStudy> fitting = spread_over(one, study.labels);
        if (!fitting) {
            return Error{"ratings \"" + ratings.name + "\": " + fitting.error().message};
        }
        study.judgements.push_back(fitting->judgements.front());
        for (double& value : study.judgements.back().condensed) {
            if (!std::isfinite(value)) value = std::nan("");
        }
        if (is_synthetic(ratings)) study.standings.push_back({ratings.name, true});
    }
    return matched(study, study.labels);
}

}  // namespace tact
