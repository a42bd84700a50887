#include "model/study/ratings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string_view>
#include <unordered_map>

#include "model/common/random.h"
#include "model/dissimilarity/correlation.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// Means of the known values, pair by pair.
std::vector<double> mean_of(const std::vector<const std::vector<double>*>& lists,
                            std::size_t pairs) {
    std::vector<double> mean(pairs, kNoRating);
    for (std::size_t p = 0; p < pairs; ++p) {
        double sum = 0.0;
        std::size_t count = 0;
        for (const std::vector<double>* list : lists) {
            if (!std::isfinite((*list)[p])) continue;
            sum += (*list)[p];
            ++count;
        }
        if (count > 0) mean[p] = sum / static_cast<double>(count);
    }
    return mean;
}

std::vector<const std::vector<double>*> pointers(const std::vector<std::vector<double>>& lists,
                                                 const std::vector<bool>& taken, bool side) {
    std::vector<const std::vector<double>*> result;
    for (std::size_t k = 0; k < lists.size(); ++k) {
        if (taken[k] == side) result.push_back(&lists[k]);
    }
    return result;
}

// The means of all participants, in the order in which they came.
std::vector<std::vector<double>> participants_of(const RatingStudy& study) {
    std::vector<std::vector<double>> means;
    for (Judgement& judgement : participant_means(study)) {
        means.push_back(std::move(judgement.condensed));
    }
    return means;
}

double rho_of_halves(const std::vector<std::vector<double>>& voices,
                     const std::vector<bool>& first) {
    const std::size_t pairs = voices[0].size();
    return spearman(mean_of(pointers(voices, first, true), pairs),
                    mean_of(pointers(voices, first, false), pairs));
}

// Mean over ways to part the voices; a half whose rho is NaN is ignored.
double mean_half_rho(const std::vector<std::vector<double>>& voices) {
    constexpr std::size_t kMostHalves = 1000;
    const std::size_t count = voices.size();
    double sum = 0.0;
    std::size_t known = 0;
    const auto take = [&](const std::vector<bool>& first) {
        const double rho = rho_of_halves(voices, first);
        if (std::isnan(rho)) return;
        sum += rho;
        ++known;
    };
    std::vector<bool> first(count, false);
    if (count <= 12) {  // at most 924 ways
        std::fill_n(first.begin(), count / 2, true);
        do {
            // With an even number each way comes twice, with the halves exchanged.
            if (count % 2 == 1 || first[0]) take(first);
        } while (std::prev_permutation(first.begin(), first.end()));
    } else {
        std::vector<std::size_t> order(count);
        for (std::size_t draw = 0; draw < kMostHalves; ++draw) {
            RandomStream random{random_bits(5, draw)};
            next_permutation_of(random, order);
            for (std::size_t k = 0; k < count; ++k) first[order[k]] = k < count / 2;
            take(first);
        }
    }
    return known > 0 ? sum / static_cast<double>(known) : kNoRating;
}

// Rho of every voice with the mean of the others.
std::vector<double> rho_with_others(const std::vector<std::vector<double>>& voices) {
    std::vector<double> rho(voices.size());
    std::vector<bool> own(voices.size(), false);
    for (std::size_t k = 0; k < voices.size(); ++k) {
        own[k] = true;
        rho[k] = rho_of_halves(voices, own);
        own[k] = false;
    }
    return rho;
}

double mean_rho_with_others(const std::vector<std::vector<double>>& voices) {
    double sum = 0.0;
    std::size_t known = 0;
    for (const double rho : rho_with_others(voices)) {
        if (std::isnan(rho)) continue;
        sum += rho;
        ++known;
    }
    return known > 0 ? sum / static_cast<double>(known) : kNoRating;
}

// The first of `given` that is not among `wanted`, with the number of others; empty if all are.
std::string extra_among(const std::vector<std::string>& given,
                        const std::vector<std::string>& wanted) {
    std::string first;
    std::size_t count = 0;
    for (const std::string& name : given) {
        if (std::ranges::find(wanted, name) != wanted.end()) continue;
        if (++count == 1) first = in_quotes(name);
    }
    return count < 2 ? first : first + " and " + std::to_string(count - 1) + " more";
}

struct Voices {
    std::size_t people = 0;     // who judged anything
    std::size_t simulated = 0;  // of these
    std::size_t rehearsing = 0;
};

Voices voices_of(const RatingStudy& study) {
    std::set<std::string_view> people;
    std::set<std::string_view> simulated;
    std::set<std::string_view> rehearsing;
    for (const Judgement& judgement : study.judgements) people.insert(judgement.participant);
    for (const Standing& standing : study.standings) {
        if (!people.contains(standing.participant)) continue;
        if (standing.synthetic) simulated.insert(standing.participant);
        if (standing.rehearsal) rehearsing.insert(standing.participant);
    }
    return {people.size(), simulated.size(), rehearsing.size()};
}

// Whether each object has a pair with a value.
std::vector<bool> rated_ones(const RatingStudy& study) {
    std::vector<bool> rated(study.labels.size(), false);
    for (const Judgement& judgement : study.judgements) {
        std::size_t p = 0;
        for (std::size_t i = 0; i < rated.size(); ++i) {
            for (std::size_t j = i + 1; j < rated.size(); ++j, ++p) {
                if (std::isfinite(judgement.condensed[p])) rated[i] = rated[j] = true;
            }
        }
    }
    return rated;
}

// The first five, and how many more.
std::string first_names(const std::vector<std::string>& names) {
    constexpr std::size_t kNamed = 5;
    std::string text;
    for (std::size_t k = 0; k < std::min(kNamed, names.size()); ++k) {
        text += (k == 0 ? "" : ", ") + in_quotes(names[k]);
    }
    if (names.size() > kNamed) text += " and " + std::to_string(names.size() - kNamed) + " more";
    return text;
}

// What the study says of these patterns, in their order; unnamed ones go by their place.
RatingStudy moved_to(const RatingStudy& study, const std::vector<std::string>& names) {
    // Mostly the labels are these names already, and to find each takes a walk through all.
    if (study.is_named && study.labels == names) return study;
    std::vector<std::size_t> from;
    for (std::size_t k = 0; k < names.size(); ++k) {
        const auto found = std::ranges::find(study.labels, names[k]);
        from.push_back(study.is_named ? static_cast<std::size_t>(found - study.labels.begin()) : k);
    }
    const std::size_t known = study.labels.size();
    RatingStudy result{names, true,         {},         study.standings, study.fingerprint,
                       {},    study.edited, study.gone, study.left_out,  study.rehearsals};
    for (const std::size_t k : from) {
        if (study.versions.empty()) break;
        result.versions.push_back(k < known ? study.versions[k] : std::string());
    }
    for (const Judgement& judgement : study.judgements) {
        Judgement moved{judgement.participant, {}};
        for (std::size_t i = 0; i < from.size(); ++i) {
            for (std::size_t j = i + 1; j < from.size(); ++j) {
                const auto [low, high] = std::minmax(from[i], from[j]);
                moved.condensed.push_back(
                    high < known ? judgement.condensed[pair_index(known, low, high)] : kNoRating);
            }
        }
        result.judgements.push_back(std::move(moved));
    }
    return result;
}

}  // namespace

std::string words_on_simulated(const RatingStudy& study) {
    const Voices voices = voices_of(study);
    if (voices.simulated == 0) return {};
    if (voices.simulated == voices.people) return "nobody was asked";
    return std::to_string(voices.simulated) + " of " + std::to_string(voices.people) +
           " were simulated";
}

bool is_partly_synthetic(const RatingStudy& study) { return voices_of(study).simulated > 0; }

NumberMark mark_of(const RatingStudy& study) {
    const Voices voices = voices_of(study);
    return {.synthetic = voices.simulated > 0,
            .rehearsal = voices.rehearsing > 0,
            .stale = !study.edited.empty(),
            .left_out = study.left_out,
            .rehearsals = study.rehearsals};
}

std::string words_on_edited(const std::vector<std::string>& edited) {
    if (edited.empty()) return {};
    return std::to_string(edited.size()) +
           (edited.size() == 1 ? " pattern was" : " patterns were") + " edited since " +
           (edited.size() == 1 ? "it was" : "they were") + " rated: " + first_names(edited);
}

std::string words_on_gone(const std::vector<std::string>& gone) {
    if (gone.empty()) return {};
    return std::to_string(gone.size()) + " rated " +
           (gone.size() == 1 ? "pattern is" : "patterns are") +
           " not in the set, and left out: " + first_names(gone);
}

Expected<RatingStudy> spread_over(const RatingStudy& study, const std::vector<std::string>& names) {
    if (!study.is_named && study.labels.size() != names.size()) {
        return Error{"expected ratings of " + std::to_string(names.size()) +
                     " patterns, as many as the set has, got " +
                     std::to_string(study.labels.size())};
    }
    if (const std::string extra = extra_among(study.labels, names);
        study.is_named && !extra.empty()) {
        return Error{"expected names of patterns of the set, got " + extra};
    }
    return moved_to(study, names);
}

RatingStudy without_gone(const RatingStudy& study, const std::vector<std::string>& names) {
    if (!study.is_named) return study;
    std::vector<std::string> left;
    std::vector<std::string> gone = study.gone;
    for (const std::string& label : study.labels) {
        const bool is_there = std::ranges::find(names, label) != names.end();
        (is_there ? left : gone).push_back(label);
    }
    if (left.size() == study.labels.size()) return study;
    RatingStudy present = moved_to(study, left);
    present.gone = std::move(gone);
    present.fingerprint.clear();  // of all of them
    return present;
}

Expected<RatingStudy> matched(const RatingStudy& study, const std::vector<std::string>& names) {
    RatingStudy present = without_gone(study, names);
    if (present.labels.size() < kLeastRated) present = study;  // refused, or as few as the set has
    Expected<RatingStudy> spread = spread_over(present, names);
    if (!spread) return spread;
    const std::size_t unrated = unrated_patterns(*spread).size();
    if (unrated > 0 && names.size() - unrated < kLeastRated) {
        return Error{"expected ratings of at least three patterns of the set, got those of " +
                     std::to_string(names.size() - unrated)};
    }
    return spread;
}

std::vector<std::string> unrated_patterns(const RatingStudy& study) {
    const std::vector<bool> rated = rated_ones(study);
    std::vector<std::string> names;
    for (std::size_t k = 0; k < rated.size(); ++k) {
        if (!rated[k]) names.push_back(study.labels[k]);
    }
    return names;
}

std::string remark_on_unrated(const std::vector<std::string>& unrated, std::size_t patterns) {
    if (unrated.empty()) return {};
    // As after a rehearsal: nothing is left that they could be left out of.
    if (unrated.size() == patterns) return "No pattern was rated by anyone who counts";
    return std::to_string(unrated.size()) + " of " + std::to_string(patterns) +
           " patterns were not rated and are left out: " + first_names(unrated);
}

Dissimilarity mean_ratings(const RatingStudy& study) {
    const std::vector<std::vector<double>> voices = participants_of(study);
    return {study.labels.size(), mean_of(pointers(voices, std::vector<bool>(voices.size()), false),
                                         pair_count(study.labels.size()))};
}

std::vector<Judgement> participant_means(const RatingStudy& study) {
    std::unordered_map<std::string, std::size_t> place;
    std::vector<std::vector<const std::vector<double>*>> repetitions;
    std::vector<Judgement> means;
    for (const Judgement& judgement : study.judgements) {
        const auto [entry, is_new] = place.emplace(judgement.participant, repetitions.size());
        if (is_new) {
            repetitions.emplace_back();
            means.push_back({judgement.participant, {}});
        }
        repetitions[entry->second].push_back(&judgement.condensed);
    }
    for (std::size_t k = 0; k < means.size(); ++k) {
        means[k].condensed = mean_of(repetitions[k], pair_count(study.labels.size()));
    }
    return means;
}

std::vector<VoiceAgreement> agreement_with_others(const RatingStudy& study) {
    const std::vector<Judgement> means = participant_means(study);
    if (means.size() < 2) return {};
    const std::vector<double> rho = rho_with_others(participants_of(study));
    std::vector<VoiceAgreement> all;
    for (std::size_t k = 0; k < means.size(); ++k) all.push_back({means[k].participant, rho[k]});
    return all;
}

Reliability reliability(const RatingStudy& study) {
    Reliability result;
    std::vector<std::vector<double>> voices = participants_of(study);
    if (voices.size() == 1 && study.judgements.size() > 1) {
        result.is_of_one_person = true;
        voices.clear();
        for (const Judgement& judgement : study.judgements) voices.push_back(judgement.condensed);
    }
    result.voices = voices.size();
    result.half_rho = result.spearman_brown = kNoRating;
    result.one_with_others = result.ceiling_of_mean = kNoRating;
    if (voices.size() < 2) return result;
    const double half = mean_half_rho(voices);
    result.half_rho = half;
    if (half > -1.0) result.spearman_brown = 2.0 * half / (1.0 + half);
    result.one_with_others = mean_rho_with_others(voices);
    result.ceiling_of_mean = std::sqrt(result.spearman_brown);  // NaN below 0
    return result;
}

}  // namespace tact
