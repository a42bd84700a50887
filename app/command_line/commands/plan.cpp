// tactspace plan: how sure a rating study of a number of people would be, which patterns decide
// between two metrics, and a preregistration.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "app/command_line/commands.h"
#include "app/command_line/interrupt.h"
#include "app/command_line/output.h"
#include "app/command_line/rated_sets.h"
#include "app/command_line/text_table.h"
#include "app/rendering/labels.h"
#include "app/report/preregistration_page.h"
#include "app/session/folders.h"
#include "app/session/program_version.h"
#include "model/common/fingerprint.h"
#include "model/evaluation/metric_comparison.h"
#include "model/io/set/set_file.h"
#include "model/io/set/set_fingerprint.h"
#include "model/io/studies_out/preregistration_file.h"
#include "model/planning/deciding.h"
#include "model/set/set_study.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

constexpr std::size_t kMostPeople = 1000;
constexpr std::size_t kMostNumbers = 20;
constexpr double kEnoughPower = 0.8;

Error stopped_planning() { return Error{"stopped before the study was planned"}; }

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

// A range stands for eight numbers, evenly spaced.
Expected<std::vector<std::size_t>> people_of(const std::string& text) {
    constexpr std::size_t kOfRange = 8;
    std::vector<std::size_t> all;
    if (const std::size_t dots = text.find(".."); dots != std::string::npos) {
        const auto first = count_in(std::string_view(text).substr(0, dots), 1, kMostPeople);
        const auto last = count_in(std::string_view(text).substr(dots + 2), 1, kMostPeople);
        if (!first || !last || *first > *last) return unreadable_people(text);
        const std::size_t steps = std::min(kOfRange - 1, *last - *first);
        for (std::size_t k = 0; k <= steps; ++k) {
            const std::size_t way = steps == 0 ? 0 : (k * (*last - *first) + steps / 2) / steps;
            all.push_back(*first + way);
        }
        return all;
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
    PatternSet set;  // those that are planned with
    std::string name;
    Metric rival = Metric::msm;
    StudyPlan plan;
    std::optional<DecidingPatterns> decided;
    std::vector<PlannedStudy> studies;
    NumberMark mark;  // of the pilot and the set
};

Expected<PlanAssumptions> assumed(const PlanCommand& command, const RatedPatterns* pilot,
                                  const Dissimilarity& pm) {
    PlanAssumptions all = guessed_assumptions();
    if (pilot != nullptr) {
        Expected<PlanAssumptions> found = assumptions_of(pilot->study, pm);
        if (!found) return Error{pilot->name + ": " + found.error().message};
        all = *std::move(found);
        // What is false of the pilot is false of all that is planned by it.
        for (const std::string& sentence : sentences_of(pilot->labels.mark)) {
            all.source += "; " + sentence;
        }
    }
    if (!command.rho && !command.reliability) return all;
    if (command.rho) all.rho = *command.rho;
    if (command.reliability) all.reliability = *command.reliability;
    const bool are_all_stated = command.rho && (command.reliability || pilot != nullptr);
    all.source = pilot != nullptr ? "stated, and " + all.source
                 : are_all_stated ? "stated"
                                  : "stated, and the rest guessed";
    return all;
}

PatternSet only(const PatternSet& set, const std::vector<std::size_t>& places) {
    PatternSet some = set;
    some.vibrations.clear();
    for (const std::size_t place : places) some.vibrations.push_back(set.vibrations[place]);
    some.study.patterns.clear();
    some.ratings.clear();
    return some;
}

// The matrices of pm and the rival, among the deciding patterns if it is asked for these.
Expected<Done> compare_metrics(const PlanCommand& command, std::stop_token stop,
                               PlanAnswer& answer) {
    const std::vector<Metric> metrics{Metric::pm, answer.rival};
    MetricOptions options;
    options.threads = command.common.threads;
    options.stop = stop;
    options.progress = progress_line("comparing patterns");
    const auto among_all = compared_matrices(answer.set, metrics, nullptr, options);
    if (!among_all) return stopped_planning();
    answer.plan.metric = (*among_all)[0];
    answer.plan.rival = (*among_all)[1];
    if (command.decide == 0) return Done{};
    const auto count = static_cast<std::size_t>(command.decide);
    if (count > answer.set.vibrations.size()) {
        return Error{"--decide: expected at most the " +
                     std::to_string(answer.set.vibrations.size()) + " patterns of the set, got " +
                     std::to_string(count)};
    }
    DecidingParams how;
    how.threads = command.common.threads;
    how.stop = stop;
    how.progress = progress_line("choosing patterns");
    answer.decided = deciding_patterns(answer.plan.metric, answer.plan.rival, count, how);
    if (!answer.decided) return stopped_planning();
    answer.set = only(answer.set, answer.decided->patterns);
    // PM ranks the pairs of the set that it is given.
    options.progress = {};
    const auto among_these = compared_matrices(answer.set, metrics, nullptr, options);
    if (!among_these) return stopped_planning();
    answer.plan.metric = (*among_these)[0];
    answer.plan.rival = (*among_these)[1];
    return Done{};
}

Expected<PlanAnswer> plan_answer(const PlanCommand& command, std::stop_token stop) {
    const Expected<std::vector<std::size_t>> people = people_of(command.people);
    if (!people) return people.error();
    const Expected<Metric> rival = metric_named(command.rival);
    if (!rival) return rival.error();
    if (*rival == Metric::pm) return Error{"--rival: expected another metric than pm"};
    std::optional<RatedPatterns> pilot;
    PlanAnswer answer;
    answer.rival = *rival;
    if (command.pilot.files.empty()) {
        Expected<PatternSet> set = load_as_meant(command.common);
        if (!set) return set.error();
        if (const auto pair = need_a_pair(*set, command.common); !pair) return pair.error();
        answer.set = *std::move(set);
    } else {
        auto rated = load_rated(command.common, command.pilot);
        if (!rated) return rated.error();
        if (rated->size() != 1) return Error{"expected one set for a plan with a pilot"};
        pilot = std::move(rated->front());
        answer.set = pilot->set;
        answer.mark = pilot->labels.mark;
    }
    answer.mark = answer.mark | mark_of(answer.set);
    answer.name =
        answer.set.name.empty() ? command.common.sets.front().filename().string() : answer.set.name;
    if (answer.set.vibrations.size() < kLeastRated) {
        return Error{"expected at least " + std::to_string(kLeastRated) + " patterns, got " +
                     std::to_string(answer.set.vibrations.size())};
    }
    const PatternSet whole = answer.set;
    if (const auto made = compare_metrics(command, stop, answer); !made) return made.error();
    const std::size_t pairs = pair_count(answer.set.vibrations.size());
    if (command.pairs != "all") {
        const auto count = count_in(command.pairs, 1, pairs);
        if (!count) {
            return Error{"--pairs: expected all, or a number from 1 to the " +
                         std::to_string(pairs) + " pairs of these patterns, got \"" +
                         command.pairs + "\""};
        }
        answer.plan.pairs = *count == pairs ? 0 : *count;
    }
    if (pilot) {
        // The pilot rated all patterns, whichever of them are planned with.
        const auto pm = compared_matrices(whole, std::vector{Metric::pm}, nullptr, {});
        Expected<PlanAssumptions> found = assumed(command, &*pilot, pm->front());
        if (!found) return found.error();
        answer.plan.assumed = *std::move(found);
    } else {
        answer.plan.assumed = *assumed(command, nullptr, answer.plan.metric);
    }
    PlanParams how;
    how.studies = static_cast<std::size_t>(command.studies);
    how.seed = static_cast<std::uint64_t>(command.seed);
    how.threads = command.common.threads;
    how.stop = stop;
    how.progress = progress_line("simulating studies");
    auto studies = planned_studies(answer.plan, *people, how);
    if (!studies) return stopped_planning();
    answer.studies = *std::move(studies);
    return answer;
}

std::string share_text(double share) {
    if (std::isnan(share)) return "-";
    return std::to_string(std::lround(100.0 * share)) + " %";
}

double minutes_of(const PlanAnswer& answer) {
    double longest_s = 0.0;
    for (const Vibration& one : answer.set.vibrations) {
        const Waveform waveform = waveform_of(one);
        longest_s =
            std::max(longest_s, static_cast<double>(waveform.samples_g.size()) / waveform.rate_hz);
    }
    const std::size_t patterns = answer.set.vibrations.size();
    const double minutes = predicted_minutes(answer.set.study, patterns, longest_s);
    if (answer.plan.pairs == 0) return minutes;
    return minutes * static_cast<double>(answer.plan.pairs) /
           static_cast<double>(pair_count(patterns));
}

std::string table_of(const PlanAnswer& answer) {
    std::vector<TextRow> rows{{"people", "rho", "95 % interval over patterns", "over people",
                               "over both", "pm told over patterns", "over people", "over both",
                               "reliability"}};
    for (const PlannedStudy& one : answer.studies) {
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
    const PlanAssumptions& people = answer.plan.assumed;
    const std::string rival = traits(answer.rival).key;
    const std::size_t patterns = answer.set.vibrations.size();
    const std::size_t pairs = answer.plan.pairs == 0 ? pair_count(patterns) : answer.plan.pairs;
    std::string text = text_of(Labels{.mark = answer.mark});
    text += "SIMULATED: nobody was asked. Assumed of people: rho of pm " +
            fixed_digits(people.rho, 2) + " with what they feel on average, reliability " +
            fixed_digits(people.reliability, 2) + " of one person (" + people.source + ")\n";
    text += std::to_string(patterns) + " patterns, " + std::to_string(pairs) + " pairs a person, " +
            std::to_string(answer.set.study.repetitions) + " times each: about " +
            std::to_string(std::lround(minutes_of(answer))) + " min\n";
    if (answer.decided) {
        text += "patterns on which pm and " + rival + " disagree most: rho between the two " +
                fixed_digits(answer.decided->rho, 2) + ", of all patterns " +
                fixed_digits(answer.decided->rho_all, 2) + "\n";
        for (const Vibration& one : answer.set.vibrations) text += "  " + one.name + "\n";
    }
    text += "\n" + table_of(answer);
    text += "told: finds the rho of pm above that of " + rival + " (here " +
            fixed_digits(answer.studies.back().rho_rival, 2) +
            " on average) with p < .05, two-sided; of " + std::to_string(studies) +
            " simulated studies, each analysed as compare does\n";
    const auto enough = enough_people(answer.studies, Resampled::both, kEnoughPower);
    text += enough ? "for " + share_text(kEnoughPower) + " over both: " + std::to_string(*enough) +
                         " people of those tried\n"
                   : "no number of people that was tried has " + share_text(kEnoughPower) +
                         " over both: more patterns, or patterns on which the two disagree "
                         "(--decide), do more than more people\n";
    return text;
}

nlohmann::json json_of(const PlanAnswer& answer, const PlanCommand& command) {
    nlohmann::json all = nlohmann::json::array();
    for (const PlannedStudy& one : answer.studies) {
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
                        {"rival", traits(answer.rival).key},
                        {"assumed",
                         {{"rho", answer.plan.assumed.rho},
                          {"reliability", answer.plan.assumed.reliability},
                          {"source", answer.plan.assumed.source}}},
                        {"pairs", answer.plan.pairs},
                        {"minutes", minutes_of(answer)},
                        {"patterns", names_of(answer.set)},
                        {"simulated_studies", command.studies},
                        {"seed", command.seed},
                        {"studies", all}};
    if (answer.decided) {
        json["rho_between"] = answer.decided->rho;
        json["rho_between_of_all"] = answer.decided->rho_all;
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
    for (const PlannedStudy& one : answer.studies) {
        TextRow row{std::to_string(one.people), csv_number(one.rho), csv_number(one.rho_sd),
                    csv_number(one.rho_rival), csv_number(one.reliability)};
        for (const double half : one.half_width) row.push_back(csv_number(half));
        for (const double power : one.power) row.push_back(csv_number(power));
        row.insert(row.end(),
                   {csv_number(answer.plan.assumed.rho),
                    csv_number(answer.plan.assumed.reliability), answer.plan.assumed.source, "1"});
        stream << csv_line(row);
    }
}

Expected<Done> preregister(const PlanCommand& command, const PlanAnswer& answer) {
    if (answer.studies.size() != 1) {
        return Error{"--preregister: expected one number of --people, got " +
                     std::to_string(answer.studies.size())};
    }
    Preregistration plan;
    plan.date = utc_now();
    plan.program = kProgramVersion;
    plan.set_name = answer.name;
    plan.patterns = names_of(answer.set);
    plan.set_fingerprint = study_fingerprint(answer.set, plan.patterns);
    plan.model_fingerprint = fingerprint_text(model_fingerprint(answer.set));
    plan.people = answer.studies.front().people;
    plan.pairs = answer.plan.pairs;
    plan.repetitions = answer.set.study.repetitions;
    plan.attention_pairs = answer.set.study.attention_pairs;
    plan.attention = answer.set.study.attention;
    plan.order = answer.set.study.order;
    plan.rival = traits(answer.rival).key;
    plan.assumed = answer.plan.assumed;
    plan.expected = answer.studies.front();
    const std::filesystem::path file = command.preregister / "preregistration.json";
    std::error_code none;
    if (std::filesystem::exists(file, none)) {
        return Error{file.string() +
                     ": expected a folder without a preregistration, which is written once"};
    }
    if (const auto made = make_folder(command.preregister); !made) return made;
    if (const auto written = write_atomically(file, print_preregistration(plan)); !written) {
        return written;
    }
    std::cerr << "tactspace: wrote " << file.string() << "\n";
    return write_atomically(command.preregister / "preregistration.html",
                            preregistration_page(plan));
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
        if (const auto written = write_set_file(command.out, answer->set); !written) return written;
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
