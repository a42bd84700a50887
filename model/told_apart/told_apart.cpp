#include "model/told_apart/told_apart.h"

#include <algorithm>

namespace tact {

void rename_in(ToldApart& told, const std::string& before, const std::string& after) {
    for (OddAnswer& answer : told.answers) {
        if (answer.trial.a == before) answer.trial.a = after;
        if (answer.trial.b == before) answer.trial.b = after;
    }
    std::ranges::replace(told.patterns, before, after);
}

ToldApart among(const ToldApart& told, const std::vector<std::string>& names) {
    const auto is_there = [](const std::vector<std::string>& all, const std::string& name) {
        return std::ranges::find(all, name) != all.end();
    };
    ToldApart part = told;
    part.patterns.clear();
    part.versions.clear();
    for (std::size_t k = 0; k < told.patterns.size(); ++k) {
        if (!is_there(names, told.patterns[k])) continue;
        part.patterns.push_back(told.patterns[k]);
        part.versions.push_back(k < told.versions.size() ? told.versions[k] : std::string());
    }
    const std::size_t gone = std::erase_if(part.answers, [&](const OddAnswer& answer) {
        return !is_there(part.patterns, answer.trial.a) || !is_there(part.patterns, answer.trial.b);
    });
    if (gone > 0) part.unknown_json.clear();  // it is kept by the places of answers
    return part;
}

}  // namespace tact
