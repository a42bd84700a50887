#include "model/set/set_told_apart.h"

#include <algorithm>
#include <map>

#include "model/set/felt_versions.h"
#include "model/text/numbers.h"
#include "model/told_apart/told_apart_results.h"

namespace tact {

namespace {

// Where the patterns of trials are in the set, if they are as they were then.
std::map<std::string, std::size_t> unedited_places(const PatternSet& set, const ToldApart& told) {
    std::map<std::string, std::size_t> places;
    const std::size_t known = std::min(told.patterns.size(), told.versions.size());
    for (std::size_t k = 0; k < known; ++k) {
        const auto place = place_named(set, told.patterns[k]);
        if (!place || told.versions[k].empty()) continue;
        if (version_of(set.vibrations[*place]) == told.versions[k]) {
            places[told.patterns[k]] = *place;
        }
    }
    return places;
}

// Whether one is to be taken in place of the other.
bool is_better(const ToldApart& one, const ToldApart& other) {
    if (one.synthetic != other.synthetic) return other.synthetic;
    return one.date >= other.date;
}

void note_pattern(const PatternSet& set, const std::string& name, ToldApart& told) {
    if (std::ranges::find(told.patterns, name) != told.patterns.end()) return;
    const auto place = place_named(set, name);
    told.patterns.push_back(name);
    told.versions.push_back(place ? version_of(set.vibrations[*place]) : std::string());
}

}  // namespace

ToldApart noted_trials(const PatternSet& set, ToldApart about, std::span<const OddAnswer> answers) {
    about.answers.assign(answers.begin(), answers.end());
    about.patterns.clear();
    about.versions.clear();
    for (const OddAnswer& answer : answers) {
        note_pattern(set, answer.trial.a, about);
        note_pattern(set, answer.trial.b, about);
    }
    return about;
}

ToldApart still_told(const PatternSet& set, const ToldApart& told, const Dissimilarity& pm) {
    ToldApart still = told;
    if (pm.size != set.vibrations.size()) {
        still.answers.clear();  // PM of another set
        return still;
    }
    const auto places = unedited_places(set, told);
    const auto is_gone = [&places](const OddAnswer& answer) {
        return !places.contains(answer.trial.a) || !places.contains(answer.trial.b);
    };
    std::erase_if(still.answers, is_gone);
    for (OddAnswer& answer : still.answers) {
        answer.trial.pm = pm(places.at(answer.trial.a), places.at(answer.trial.b));
    }
    std::erase_if(still.answers,
                  [](const OddAnswer& answer) { return !can_be_asked(answer.trial.pm); });
    return still;
}

std::optional<UsableTrials> newest_told(const PatternSet& set, const Dissimilarity& pm) {
    std::optional<UsableTrials> newest;
    for (std::size_t k = 0; k < set.told_apart.size(); ++k) {
        if (newest && !is_better(set.told_apart[k], newest->told)) continue;
        ToldApart still = still_told(set, set.told_apart[k], pm);
        if (still.answers.size() < limits::kFewestOddTrials) continue;
        newest = UsableTrials{k, std::move(still)};
    }
    return newest;
}

std::string told_apart_words(const PatternSet& set, const Dissimilarity& pm, double pm_of_pair) {
    const auto newest = newest_told(set, pm);
    if (!newest || !can_be_asked(pm_of_pair)) return {};
    const ToldApartResults results = results_of(newest->told);
    const std::string where = newest->told.device.empty() ? "a device" : newest->told.device;
    return "On " + where + ", " + words_at(results, pm_of_pair) + " (" +
           asked_words(newest->told, results) + ").";
}

std::string told_apart_help(const PatternSet& set, const Dissimilarity& pm) {
    const auto newest = newest_told(set, pm);
    if (!newest) return {};
    const ToldApartResults results = results_of(newest->told);
    const std::size_t all = set.told_apart[newest->place].answers.size();
    std::string text = share_words(results) + " " + threshold_words(results);
    if (all > results.trials) {
        text += " " + counted(all - results.trials, "trial does", "trials do") +
                " not count any more: a pattern was edited or removed since.";
    }
    text += newest->told.synthetic ? " Simulated: no person was asked"
                                   : std::string(" Measured on ") + kMeasuredOn;
    if (!newest->told.person.empty()) text += ": " + newest->told.person;
    if (!newest->told.date.empty()) text += ", " + newest->told.date;
    return text + ". It is not part of PM.";
}

}  // namespace tact
