// tactspace plan: how sure a rating study of a number of people would be, which patterns decide
// between two metrics, and a preregistration.

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "app/command_line/rated_sets.h"
#include "app/rendering/rendering.h"
#include "app/report/report.h"
#include "app/session/program_version.h"
#include "model/io/set/set_file.h"
#include "model/planning/set_plan.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

constexpr std::size_t kMostPeople = kMostPlannedPeople;
constexpr std::size_t kMostNumbers = 20;
constexpr double kEnoughPower = 0.8;

Error unreadable_people(const std::string& text) {
    return Error{"--people: expected A..B or numbers such as 8,12,20, each from 1 to " +
                 std::to_string(kMostPeople) + ", got \"" + text + "\""};
}

std::optional<std::size_t> count_in(std::string_view text, std::size_t least, std::size_t most) {
    const auto number = finite_number_in(text);
    const bool is_count = number && *number == std::floor(*number) &&
                          *number >= static_cast<double>(least) &&
                          *number <= static_cast<double>(most);
    return is_count ? std::optional(static_cast<std::size_t>(*number)) : std::nullopt;
}

Expected<std::vector<std::size_t>> people_of(const std::string& text) {
    std::vector<std::size_t> all;
    if (const std::size_t dots = text.find(".."); dots != std::string::npos) {
        const auto first = count_in(std::string_view(text).substr(0, dots), 1, kMostPeople);
        const auto last = count_in(std::string_view(text).substr(dots + 2), 1, kMostPeople);
        if (!first || !last || *first > *last) return unreadable_people(text);
        return people_between(*first, *last);
    }
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        const auto count = count_in(std::string_view(text).substr(at, end - at), 1, kMostPeople);
        if (!count || all.size() == kMostNumbers) return unreadable_people(text);
        all.push_back(*count);
        at = end + 1;
    }
    return all;
}

struct PlanAnswer {
    SetPlan plan;
    std::string name;
    NumberMark mark;  // of the pilot and the set
};

// The set of the command, with what it says of a pilot.
struct PlanGround {
    PatternSet set;
    std::optional<RatingStudy> pilot;
    std::string of_pilot;
    std::string pilot_name;
    NumberMark mark;
};

Expected<PlanGround> ground_of(const PlanCommand& command) {
    if (command.pilot.files.empty()) {
        Expected<PatternSet> set = load_as_meant(command.common);
        if (!set) return set.error();
        if (const auto pair = need_a_pair(*set, command.common); !pair) return pair.error();
        const NumberMark mark = mark_of(*set);
        return PlanGround{*std::move(set), {}, {}, {}, mark};
    }
    auto rated = load_rated(command.common, command.pilot);
    if (!rated) return rated.error();
    if (rated->size() != 1) return Error{"expected one set for a plan with a pilot"};
    RatedPatterns& one = rated->front();
    // What is false of the pilot is false of all that is planned by it.
    std::string said;
    for (const std::string& sentence : sentences_of(one.labels.mark)) {
        said += (said.empty() ? "" : "; ") + sentence;
    }
    const NumberMark mark = one.labels.mark | mark_of(one.set);
    return PlanGround{std::move(one.set), std::move(one.study), said, one.name, mark};
}

// 0: all of them.
Expected<std::size_t> pairs_of(const PlanCommand& command, std::size_t patterns) {
    if (command.pairs == "all") return std::size_t{0};
    const std::size_t most =
        pair_count(command.decide > 0 ? static_cast<std::size_t>(command.decide) : patterns);
    if (const auto count = count_in(command.pairs, 1, most)) return *count;
    return Error{"--pairs: expected all, or a number from 1 to the " + std::to_string(most) +
                 " pairs of these patterns, got \"" + command.pairs + "\""};
}

Expected<PlanAnswer> plan_answer(const PlanCommand& command, std::stop_token stop) {
    const Expected<std::vector<std::size_t>> people = people_of(command.people);
    if (!people) return people.error();
    const Expected<Metric> rival = metric_named(command.rival);
    if (!rival) return rival.error();
    Expected<PlanGround> ground = ground_of(command);
    if (!ground) return ground.error();
    const Expected<std::size_t> pairs = pairs_of(command, ground->set.vibrations.size());
    if (!pairs) return pairs.error();
    const std::string name = ground->set.name.empty()
                                 ? command.common.sets.front().filename().string()
                                 : ground->set.name;
    std::map<std::string, std::function<void(double)>> lines;
    const PlanWatch watch{stop, [&lines](const char* what, double share) {
                              auto& line = lines[what];
                              if (!line) line = progress_line(what);
                              line(share);
                          }};
    Expected<SetPlan> plan = set_plan({.set = std::move(ground->set),
                                       .rival = *rival,
                                       .people = *people,
                                       .pairs = *pairs,
                                       .decide = static_cast<std::size_t>(command.decide),
                                       .pilot = std::move(ground->pilot),
                                       .of_pilot = ground->of_pilot,
                                       .rho = command.rho,
                                       .reliability = command.reliability,
                                       .studies = static_cast<std::size_t>(command.studies),
                                       .seed = static_cast<std::uint64_t>(command.seed),
                                       .threads = command.common.threads},
                                      watch);
    if (!plan) return plan.error();
    return PlanAnswer{*std::move(plan), name, ground->mark};
}

std::string share_text(double share) { return std::isnan(share) ? "-" : percent(share); }

std::string table_of(const PlanAnswer& answer) {
    std::vector<TextRow> rows{{"people", "rho", "95 % interval over patterns", "over people",
                               "over both", "pm told over patterns", "over people", "over both",
                               "reliability"}};
    for (const PlannedStudy& one : answer.plan.studies) {
        TextRow row{std::to_string(one.people), fixed_digits(one.rho, 2)};
        for (const double half : one.half_width) {
            row.push_back(std::isnan(half) ? "-" : "+-" + fixed_digits(half, 2));
        }
        for (const double power : one.power) row.push_back(share_text(power));
        row.push_back(fixed_digits(one.reliability, 2));
        rows.push_back(row);
    }
    return aligned(rows);
}

std::string text_of(const PlanAnswer& answer, int studies) {
    const PlanAssumptions& people = answer.plan.plan.assumed;
    const std::string rival = traits(answer.plan.rival).key;
    const std::size_t patterns = answer.plan.set.vibrations.size();
    const std::size_t pairs =
        answer.plan.plan.pairs == 0 ? pair_count(patterns) : answer.plan.plan.pairs;
    std::string text = text_of(Labels{.mark = answer.mark});
    text += "SIMULATED: nobody was asked. Assumed of people: rho of pm " +
            fixed_digits(people.rho, 2) + " with what they feel on average, reliability " +
            fixed_digits(people.reliability, 2) + " of one person (" + people.source + ")\n";
    text += std::to_string(patterns) + " patterns, " + std::to_string(pairs) + " pairs a person, " +
            std::to_string(answer.plan.set.study.repetitions) + " times each: about " +
            std::to_string(std::lround(minutes_of(answer.plan))) + " min\n";
    if (answer.plan.decided) {
        text += "patterns on which pm and " + rival + " disagree most: rho between the two " +
                fixed_digits(answer.plan.decided->rho, 2) + ", of all patterns " +
                fixed_digits(answer.plan.decided->rho_all, 2) + "\n";
        for (const Vibration& one : answer.plan.set.vibrations) text += "  " + one.name + "\n";
    }
    text += "\n" + table_of(answer);
    text += "told: finds the rho of pm above that of " + rival + " (here " +
            fixed_digits(answer.plan.studies.back().rho_rival, 2) +
            " on average) with p < .05, two-sided; of " + std::to_string(studies) +
            " simulated studies, each analysed as compare does\n";
    const auto enough = enough_people(answer.plan.studies, Resampled::both, kEnoughPower);
    text += enough ? "for " + share_text(kEnoughPower) + " over both: " + std::to_string(*enough) +
                         " people of those tried\n"
                   : "no number of people that was tried has " + share_text(kEnoughPower) +
                         " over both: more patterns, or patterns on which the two disagree "
                         "(--decide), do more than more people\n";
    return text;
}

nlohmann::json json_of(const PlanAnswer& answer, const PlanCommand& command) {
    nlohmann::json all = nlohmann::json::array();
    for (const PlannedStudy& one : answer.plan.studies) {
        nlohmann::json json{{"people", one.people},
                            {"rho", one.rho},
                            {"rho_sd", one.rho_sd},
                            {"rho_rival", one.rho_rival},
                            {"reliability", one.reliability}};
        for (std::size_t r = 0; r < kResampledCount; ++r) {
            json["half_width"][kResampledNames[r]] = one.half_width[r];
            json["power"][kResampledNames[r]] = one.power[r];
        }
        all.push_back(json);
    }
    nlohmann::json json{{"simulated", true},
                        {"rival", traits(answer.plan.rival).key},
                        {"assumed",
                         {{"rho", answer.plan.plan.assumed.rho},
                          {"reliability", answer.plan.plan.assumed.reliability},
                          {"source", answer.plan.plan.assumed.source}}},
                        {"pairs", answer.plan.plan.pairs},
                        {"minutes", minutes_of(answer.plan)},
                        {"patterns", names_of(answer.plan.set)},
                        {"simulated_studies", command.studies},
                        {"seed", command.seed},
                        {"studies", all}};
    if (answer.plan.decided) {
        json["rho_between"] = answer.plan.decided->rho;
        json["rho_between_of_all"] = answer.plan.decided->rho_all;
    }
    add_labels(json, {.mark = answer.mark});
    return json;
}

void write_csv(std::ostream& stream, const PlanAnswer& answer) {
    TextRow head{"people", "rho", "rho_sd", "rho_rival", "reliability"};
    for (const char* by : kResampledNames) head.push_back(std::string("half_width_") + by);
    for (const char* by : kResampledNames) head.push_back(std::string("power_") + by);
    head.insert(head.end(), {"assumed_rho", "assumed_reliability", "assumed_from", "simulated"});
    stream << csv_line(head);
    for (const PlannedStudy& one : answer.plan.studies) {
        TextRow row{std::to_string(one.people), csv_number(one.rho), csv_number(one.rho_sd),
                    csv_number(one.rho_rival), csv_number(one.reliability)};
        for (const double half : one.half_width) row.push_back(csv_number(half));
        for (const double power : one.power) row.push_back(csv_number(power));
        row.insert(row.end(), {csv_number(answer.plan.plan.assumed.rho),
                               csv_number(answer.plan.plan.assumed.reliability),
                               answer.plan.plan.assumed.source, "1"});
        stream << csv_line(row);
    }
}

Expected<Done> preregister(const PlanCommand& command, const PlanAnswer& answer) {
    if (answer.plan.studies.size() != 1) {
        return Error{"--preregister: expected one number of --people, got " +
                     std::to_string(answer.plan.studies.size())};
    }
    const auto written = write_preregistration(
        command.preregister,
        preregistration_of(answer.plan, answer.name, kProgramVersion, utc_now()));
    if (!written) return written;
    std::cerr << "tactspace: wrote " << (command.preregister / "preregistration.json").string()
              << "\n";
    return Done{};
}

}  // namespace

Expected<Done> run(const PlanCommand& command) {
    const Interrupt interrupt;
    for (const auto* file : {&command.out, &command.csv}) {
        if (const auto writable = writable_result(*file); !writable) return writable;
    }
    const Expected<PlanAnswer> answer = plan_answer(command, interrupt.token());
    if (!answer) return answer.error();
    if (!command.preregister.empty()) {
        if (const auto written = preregister(command, *answer); !written) return written;
    }
    if (!command.out.empty()) {
        if (const auto written = write_set_file(command.out, answer->plan.set); !written)
            return written;
    }
    if (!command.csv.empty()) {
        const auto written =
            write_result(command.csv, [&](std::ostream& stream) { write_csv(stream, *answer); });
        if (!written) return written;
    }
    return write_result({}, [&](std::ostream& stream) {
        stream << (command.common.json ? text_of_json(json_of(*answer, command)) + "\n"
                                       : text_of(*answer, command.studies));
    });
}

}  // namespace tact
