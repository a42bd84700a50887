#include "model/set/set_ratings.h"

#include <algorithm>
#include <cmath>

#include "model/common/fingerprint.h"
#include "model/set/felt_versions.h"

namespace tact {

std::vector<Ratings> kept_ratings(const RatingStudy& study, const std::string& file) {
    const bool is_many = study.judgements.size() > kMostKeptRatings;
    std::vector<Ratings> kept;
    for (const Judgement& judgement : is_many ? participant_means(study) : study.judgements) {
        const auto standing =
            std::ranges::find(study.standings, judgement.participant, &Standing::participant);
        const bool is_nobody = standing != study.standings.end() && standing->synthetic;
        Ratings ratings{
            judgement.participant,
            study.labels,
            judgement.condensed,
            {},
            file,
            {},
            {.synthetic = is_nobody, .left_out = study.left_out, .rehearsals = study.rehearsals}};
        std::ranges::replace_if(
            ratings.condensed, [](double value) { return std::isnan(value); }, kUnrated);
        kept.push_back(std::move(ratings));
    }
    return kept;
}

namespace {

// One voice of the set as a study of its own.
RatingStudy alone(const Ratings& ratings) {
    RatingStudy one{ratings.labels, true, {{ratings.name, ratings.condensed}}};
    for (double& value : one.judgements.front().condensed) {
        if (!std::isfinite(value)) value = std::nan("");
    }
    return one;
}

}  // namespace

Expected<RatingStudy> study_of(const PatternSet& set) {
    if (set.ratings.empty()) return Error{"expected ratings of the patterns, got none"};
    RatingStudy study;
    study.labels = names_of(set);
    std::string fault;  // of the first voice that does not fit as it is
    for (const Ratings& ratings : set.ratings) {
        const RatingStudy one = alone(ratings);
        if (const auto fits = spread_over(one, study.labels); !fits && fault.empty()) {
            fault = "ratings \"" + ratings.name + "\": " + fits.error().message;
        }
        Expected<RatingStudy> voice = spread_over(without_gone(one, study.labels), study.labels);
        study.judgements.push_back(std::move(voice->judgements.front()));
        study.left_out = std::max(study.left_out, ratings.mark.left_out);
        study.rehearsals = std::max(study.rehearsals, ratings.mark.rehearsals);
        if (ratings.mark.synthetic) study.standings.push_back({ratings.name, true});
    }
    Expected<RatingStudy> fitting = matched(study, study.labels);
    const std::size_t rated = study.labels.size() - unrated_patterns(study).size();
    if (!fault.empty() && (!fitting || rated < kLeastRated)) return Error{fault};
    if (!fitting) return fitting;
    const StalePatterns stale = stale_patterns(set);
    fitting->edited = stale.edited;
    fitting->gone = stale.gone;
    return fitting;
}

std::string study_fingerprint(const PatternSet& set, const std::vector<std::string>& names) {
    std::uint64_t sum = 0;
    for (const std::string& name : names) {
        sum = mixed(sum, std::span<const char>(name));
        if (const auto place = place_named(set, name)) {
            const Waveform waveform = waveform_of(set.vibrations[*place]);
            sum = mixed(sum, std::span<const double>(waveform.samples_g));
        }
    }
    return fingerprint_text(sum);
}

std::vector<std::string> study_patterns(const PatternSet& set) {
    std::vector<std::string> names = names_of(set);
    const std::vector<std::string>& chosen = set.study.patterns;
    if (chosen.empty()) return names;
    std::erase_if(names, [&chosen](const std::string& name) {
        return std::ranges::find(chosen, name) == chosen.end();
    });
    return names;
}

}  // namespace tact
