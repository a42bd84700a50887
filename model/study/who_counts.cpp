#include "model/study/who_counts.h"

#include <algorithm>
#include <set>
#include <utility>

#include "model/text/utf8.h"

namespace tact {

namespace {

bool is_among(const std::vector<std::string>& names, const std::string& name) {
    return std::ranges::find(names, name) != names.end();
}

const Standing* standing_of(const RatingStudy& study, const std::string& participant) {
    const auto found = std::ranges::find(study.standings, participant, &Standing::participant);
    return found == study.standings.end() ? nullptr : &*found;
}

bool took_part(const RatingStudy& study, const std::string& name) {
    return standing_of(study, name) != nullptr ||
           std::ranges::find(study.judgements, name, &Judgement::participant) !=
               study.judgements.end();
}

std::string fault_of(const RatingStudy& study, const CountRule& rule) {
    for (const ConductTest test : kConductTests) {
        if (is_on(rule.conduct, test)) {
            return "expected the folder of a study, which knows of each answer what is asked "
                   "for: " +
                   words_on(rule.conduct, test);
        }
    }
    for (const auto* names : {&rule.include, &rule.exclude}) {
        for (const std::string& name : *names) {
            if (!took_part(study, name)) {
                return "expected the name of a participant, got " + in_quotes(name);
            }
        }
    }
    for (const std::string& name : rule.include) {
        const Standing* standing = standing_of(study, name);
        if (is_among(rule.exclude, name)) {
            return "expected " + in_quotes(name) + " to be included or excluded, got both";
        }
        if (standing != nullptr && standing->rehearsal) {
            return "expected a participant who felt something, got " + in_quotes(name) + ": " +
                   kNothingFelt;
        }
    }
    return {};
}

// Whether anybody took part who is no simulation and no rehearsal.
bool has_people(const RatingStudy& study) {
    return std::ranges::any_of(study.judgements, [&study](const Judgement& judgement) {
        const Standing* standing = standing_of(study, judgement.participant);
        return standing == nullptr || (!standing->synthetic && !standing->rehearsal);
    });
}

// Why one does not count; empty: they do.
std::string reason(const RatingStudy& study, const std::string& name, const CountRule& rule,
                   bool beside_people) {
    const Standing* standing = standing_of(study, name);
    if (standing != nullptr && standing->rehearsal) return kNothingFelt;
    if (is_among(rule.exclude, name)) return excluded_because(rule.because);
    if (standing == nullptr || is_among(rule.include, name)) return {};
    if (standing->synthetic && beside_people) return kSimulated;
    return standing->excluded;
}

}  // namespace

std::string excluded_because(const std::string& because) {
    return because.empty() ? "excluded by name" : "excluded by name: " + because;
}

Expected<Counted> who_counts(RatingStudy study, const CountRule& rule) {
    if (const std::string fault = fault_of(study, rule); !fault.empty()) return Error{fault};
    std::vector<std::string> people;
    for (const Judgement& judgement : study.judgements) people.push_back(judgement.participant);
    for (const Standing& standing : study.standings) people.push_back(standing.participant);
    Counted counted;
    const bool beside_people = has_people(study);
    std::set<std::string> seen;
    for (const std::string& name : people) {
        if (!seen.insert(name).second) continue;
        std::string why = reason(study, name, rule, beside_people);
        if (!why.empty()) counted.left_out.push_back({name, std::move(why)});
    }
    const auto is_left_out = [&counted](const auto& one) {
        return std::ranges::find(counted.left_out, one.participant,
                                 &LeftOutParticipant::participant) != counted.left_out.end();
    };
    std::erase_if(study.judgements, is_left_out);
    std::erase_if(study.standings, is_left_out);
    study.left_out += counted.left_out.size();
    study.rehearsals += static_cast<std::size_t>(
        std::ranges::count(counted.left_out, kNothingFelt, &LeftOutParticipant::why));
    counted.study = std::move(study);
    return counted;
}

std::vector<std::string> remarks_on(const std::vector<LeftOutParticipant>& left_out) {
    std::vector<std::string> remarks;
    for (const LeftOutParticipant& one : left_out) {
        constexpr std::size_t kMost = 200;  // characters
        remarks.push_back(shortened(one.participant, kMost) +
                          " is not counted: " + shortened(one.why, kMost));
    }
    return remarks;
}

}  // namespace tact
