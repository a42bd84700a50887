#include "model/set/felt_versions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "model/set/set_ratings.h"

namespace tact {

namespace {

// Versions of a set's waveforms, each made once.
class Versions {
  public:
    explicit Versions(const PatternSet& set) : set_(set) {
        for (std::size_t k = 0; k < set.vibrations.size(); ++k) place_[set.vibrations[k].name] = k;
    }
    const Vibration* find(const std::string& name) const {
        const auto found = place_.find(name);
        return found == place_.end() ? nullptr : &set_.vibrations[found->second];
    }
    const std::string& of(const std::string& name) {
        std::string& version = version_[name];
        if (version.empty()) version = version_of(*find(name));
        return version;
    }

  private:
    const PatternSet& set_;
    std::map<std::string, std::size_t> place_;
    std::map<std::string, std::string> version_;
};

// Whether each label has a rating.
std::vector<bool> rated_labels(const Ratings& ratings) {
    const std::size_t n = ratings.labels.size();
    std::vector<bool> rated(n, false);
    std::size_t p = 0;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j, ++p) {
            if (std::isfinite(ratings.condensed[p])) rated[i] = rated[j] = true;
        }
    }
    return rated;
}

std::string version_at(const std::vector<std::string>& versions, std::size_t k) {
    return k < versions.size() ? versions[k] : std::string();
}

std::vector<std::string> in_order_of(const PatternSet& set, const std::set<std::string>& names) {
    std::vector<std::string> ordered;
    for (const Vibration& vibration : set.vibrations) {
        if (names.contains(vibration.name)) ordered.push_back(vibration.name);
    }
    return ordered;
}

void look_at_twins(StalePatterns& stale, const PatternSet& set, Versions& versions) {
    for (const Vibration& vibration : set.vibrations) {
        const auto* twin = std::get_if<Measurement>(&vibration.source);
        if (twin == nullptr || twin->measures.empty()) continue;
        if (versions.find(twin->measures) == nullptr) {
            stale.lone_twins.push_back(vibration.name);
        } else if (twin->measures_version.empty()) {
            stale.unknown_twins.push_back(vibration.name);
        } else if (versions.of(twin->measures) != twin->measures_version) {
            stale.twins.push_back(vibration.name);
        }
    }
}

// What no version equals: another one was felt, and nobody knows which.
constexpr const char* kAnother = "another";

// By the one fingerprint of all patterns, where single versions are not known.
bool is_another_set(const RatingStudy& study, const PatternSet& set) {
    if (study.fingerprint.empty()) return false;
    const std::vector<std::string> unrated = unrated_patterns(study);
    std::vector<std::string> felt = names_of(set);
    std::erase_if(felt, [&](const std::string& name) {
        return std::ranges::find(study.labels, name) == study.labels.end() ||
               std::ranges::find(unrated, name) != unrated.end();
    });
    return study_fingerprint(set, felt) != study.fingerprint;
}

}  // namespace

std::string version_of(const Vibration& vibration) {
    PatternSet alone;
    alone.vibrations = {vibration};
    alone.vibrations[0].name.clear();  // renaming makes no other pattern
    return study_fingerprint(alone, {""});
}

StalePatterns stale_patterns(const PatternSet& set) {
    Versions versions(set);
    StalePatterns stale;
    std::set<std::string> edited;
    std::set<std::string> unrecorded;
    for (const Ratings& ratings : set.ratings) {
        const std::vector<bool> rated = rated_labels(ratings);
        for (std::size_t k = 0; k < ratings.labels.size(); ++k) {
            const std::string& name = ratings.labels[k];
            const std::string version = version_at(ratings.versions, k);
            if (!rated[k]) continue;
            if (versions.find(name) == nullptr) {
                const bool is_new = std::ranges::find(stale.gone, name) == stale.gone.end();
                if (is_new) stale.gone.push_back(name);
            } else if (version.empty()) {
                unrecorded.insert(name);
            } else if (versions.of(name) != version) {
                edited.insert(name);
            }
        }
    }
    stale.edited = in_order_of(set, edited);
    stale.unrecorded = in_order_of(set, unrecorded);
    look_at_twins(stale, set, versions);
    return stale;
}

namespace {

bool is_in(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

}  // namespace

std::string words_on_twin(const StalePatterns& stale, const std::string& twin) {
    if (is_in(stale.twins, twin)) return ", which was edited since";
    if (is_in(stale.lone_twins, twin)) return ", which is no longer in the set";
    if (is_in(stale.unknown_twins, twin)) return ", version not recorded";
    return {};
}

std::string mark_in_list(const StalePatterns& stale, const std::string& name) {
    if (is_in(stale.twins, name) || is_in(stale.lone_twins, name)) return "stale";
    return is_in(stale.edited, name) ? "edited" : "";
}

void note_edited(RatingStudy& study, const PatternSet& set) {
    study.edited.clear();
    Versions versions(set);
    const std::vector<std::string> unrated = unrated_patterns(study);
    const bool all = study.versions.empty() && is_another_set(study, set);
    for (std::size_t k = 0; k < study.labels.size(); ++k) {
        const std::string& name = study.labels[k];
        const std::string version = version_at(study.versions, k);
        const bool is_rated = std::ranges::find(unrated, name) == unrated.end();
        if (!is_rated || versions.find(name) == nullptr) continue;
        if (all || (!version.empty() && versions.of(name) != version)) study.edited.push_back(name);
    }
}

void note_versions(std::vector<Ratings>& ratings, const RatingStudy& study, const PatternSet& set) {
    Versions versions(set);
    const bool is_another = study.versions.empty() && is_another_set(study, set);
    for (Ratings& one : ratings) {
        const std::vector<bool> rated = rated_labels(one);
        one.versions.assign(one.labels.size(), "");
        for (std::size_t k = 0; k < one.labels.size(); ++k) {
            if (!rated[k] || versions.find(one.labels[k]) == nullptr) continue;
            const auto label = std::ranges::find(study.labels, one.labels[k]);
            std::string told =
                version_at(study.versions, static_cast<std::size_t>(label - study.labels.begin()));
            if (told.empty()) told = is_another ? kAnother : versions.of(one.labels[k]);
            one.versions[k] = std::move(told);
        }
    }
}

void keep_versions(const PatternSet& before, PatternSet& after) {
    Versions was(before);
    Versions is(after);
    const auto was_before = [&](const std::string& name) -> std::string {
        const Vibration* old = was.find(name);
        const Vibration* now = is.find(name);
        if (old == nullptr || now == nullptr || old->source == now->source) return {};
        return was.of(name) == is.of(name) ? std::string() : was.of(name);
    };
    for (std::size_t r = 0; r < std::min(before.ratings.size(), after.ratings.size()); ++r) {
        Ratings& ratings = after.ratings[r];
        if (ratings.labels != before.ratings[r].labels) continue;
        const std::vector<bool> rated = rated_labels(ratings);
        for (std::size_t k = 0; k < ratings.labels.size(); ++k) {
            if (!rated[k] || !version_at(ratings.versions, k).empty()) continue;
            std::string version = was_before(ratings.labels[k]);
            if (version.empty()) continue;
            ratings.versions.resize(ratings.labels.size());
            ratings.versions[k] = std::move(version);
        }
    }
    for (Vibration& vibration : after.vibrations) {
        auto* twin = std::get_if<Measurement>(&vibration.source);
        if (twin == nullptr || twin->measures.empty() || !twin->measures_version.empty()) continue;
        twin->measures_version = was_before(twin->measures);
    }
}

void describe_set(StudyHeader& header, const PatternSet& set) {
    header.set_name = set.name;
    header.patterns = study_patterns(set);
    header.set_fingerprint = study_fingerprint(set, header.patterns);
    header.versions.clear();
    for (const std::string& name : header.patterns) {
        header.versions.push_back(version_of(set.vibrations[*place_named(set, name)]));
    }
}

}  // namespace tact
