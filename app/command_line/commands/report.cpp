// tactspace report: one page about a set, to be sent.

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/interrupt.h"
#include "app/command_line/output.h"
#include "app/document/pattern_looks.h"
#include "app/report/report.h"
#include "app/session/program_version.h"
#include "model/subset/set_subset.h"
#include "model/tasks/set_pairs.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

struct ReportAnswer {
    Dissimilarity pm;
    SubsetAnswer subset;
    CloseGroups confused;  // within a felt step
    CloseGroups closer;
    CloserThan closer_than;
    PerceptualSpace space;
    std::optional<Stability> stability;
    std::vector<PatternGroup> alike;    // as many as are picked
    std::vector<std::size_t> unfelt;    // that may not be picked unless they are kept ...
    std::vector<std::size_t> left_out;  // ... which these are not
};

Error stopped() { return Error{"stopped before the report was made"}; }

// Half of a small set: the most distinct of all but one would say nothing.
std::size_t picked_count(const ReportCommand& command, std::size_t patterns) {
    constexpr std::size_t kUsual = 8;
    if (command.count) return static_cast<std::size_t>(*command.count);
    return std::clamp((patterns + 1) / 2, std::size_t{2}, kUsual);
}

Expected<SubsetAnswer> picked_for_report(const ReportCommand& command, const PatternSet& set,
                                         const Dissimilarity& pm,
                                         std::span<const std::size_t> unfelt,
                                         std::stop_token stop) {
    SubsetProblem problem = subset_problem(set, picked_count(command, set.vibrations.size()),
                                           SubsetObjective::max_min, unfelt);
    if (!command.count) {
        problem.count = possible_count(problem, set.vibrations.size(), problem.count);
    }
    SubsetOptions options;
    options.time_limit_s = command.time_limit_s;
    options.threads = command.common.threads;
    options.stop = stop;
    tell_search(options, "picking", problem.objective);
    return most_distinct_subset(pm, problem, options);
}

// What pairs are held against: a number, a pair of names, or the subset's weakest pair.
Expected<CloserThan> closer_than(const ReportCommand& command, const PatternSet& set,
                                 const ReportAnswer& answer) {
    if (command.confused_at.empty()) return closer_than_picked(answer.subset);
    if (const auto number = finite_number_in(command.confused_at)) {
        if (*number < 0.0) return Error{"--closer-than: expected a PM of 0 or more"};
        return CloserThan{*number, "PM " + significant_digits(*number, 4),
                          "a value that was given"};
    }
    const auto pair = pair_of(set, "--closer-than", command.confused_at);
    if (!pair) return pair.error();
    const std::string names = set.vibrations[pair->a].name + " and " + set.vibrations[pair->b].name;
    return CloserThan{answer.pm(pair->a, pair->b), names,
                      "as far apart as " + names + ", a pair that was given"};
}

Expected<Done> look_at_likeness(const ReportCommand& command, const FeltSet& sets,
                                std::stop_token stop, ReportAnswer& answer) {
    MdsParams params = standard_mds_params(answer.pm.size, 3);
    params.threads = command.common.threads;
    answer.space = nonmetric_mds(answer.pm, params, stop);
    if (stop.stop_requested()) return stopped();
    if (command.draws == 0) return Done{};
    StabilityParams sure;
    sure.draws = static_cast<std::size_t>(command.draws);
    sure.threads = command.common.threads;
    sure.stop = stop;
    sure.progress = progress_line("drawing models");
    const SubsetProblem problem = subset_problem(sets.meant, answer.subset.best.members.size(),
                                                 SubsetObjective::max_min, answer.unfelt);
    answer.stability =
        subset_stability(sets.felt, problem, answer.subset.best, answer.space.points, sure);
    if (!answer.stability) return stopped();
    return Done{};
}

Expected<ReportAnswer> answer_of(const ReportCommand& command, const FeltSet& sets,
                                 std::stop_token stop) {
    PairsRequest request{Metric::pm, !command.include_unfelt};
    request.options.threads = command.common.threads;
    request.options.stop = stop;
    request.options.progress = progress_line("comparing patterns");
    auto pairs = set_pairs(sets.felt, request);
    if (!pairs) return stopped();
    ReportAnswer answer;
    answer.pm = std::move(pairs->apart);
    answer.unfelt = std::move(pairs->unfelt);
    answer.left_out = left_out_unfelt(sets.meant, answer.unfelt);
    auto subset = picked_for_report(command, sets.meant, answer.pm, answer.unfelt, stop);
    if (!subset) return unpickable(subset.error(), answer.left_out.size());
    answer.subset = *std::move(subset);
    Expected<CloserThan> than = closer_than(command, sets.meant, answer);
    if (!than) return than.error();
    answer.closer_than = *std::move(than);
    const Dissimilarity felt = felt_pairs(answer.pm, answer.unfelt);
    answer.closer = groups_below(felt, answer.closer_than.dissimilarity);
    answer.confused = groups_within_a_step(sets.meant, felt);
    answer.alike = groups_at(groups_of_set(sets.meant, answer.pm, answer.unfelt), answer.pm,
                             answer.subset.best.members.size());
    if (const auto looked = look_at_likeness(command, sets, stop, answer); !looked) {
        return looked.error();
    }
    return answer;
}

nlohmann::json json_of(const CloseGroups& close, const std::vector<std::string>& names) {
    nlohmann::json groups = nlohmann::json::array();
    for (const CloseGroup& group : close.groups) {
        nlohmann::json members = nlohmann::json::array();
        for (const std::size_t place : group.members) members.push_back(names[place]);
        groups.push_back(members);
    }
    return groups;
}

// "groups", "distinct" and verdicts are of felt steps; what begins with "closer" is of a pair.
nlohmann::json json_of(const ReportAnswer& answer, const PatternSet& set,
                       const std::vector<std::string>& names) {
    nlohmann::json json{{"groups", json_of(answer.confused, names)},
                        {"confused_pairs", answer.confused.pairs},
                        {"distinct", distinct_count(answer.confused)},
                        {"closer_below", answer.closer_than.dissimilarity},
                        {"closer_than", answer.closer_than.words},
                        {"closer_source", answer.closer_than.source},
                        {"closer_pairs", answer.closer.pairs},
                        {"closer_groups", json_of(answer.closer, names)},
                        {"optimal", answer.subset.proof == SubsetProof::optimal},
                        {"bound", answer.subset.bound}};
    for (const std::size_t place : answer.subset.best.members) {
        json["picked"].push_back(names[place]);
    }
    json["alike"] = nlohmann::json::array();
    for (const PatternGroup& group : answer.alike) {
        nlohmann::json members = nlohmann::json::array();
        for (const std::size_t place : group.members) members.push_back(names[place]);
        json["alike"].push_back({{"central", names[group.central]}, {"patterns", members}});
    }
    for (const std::size_t k : answer.unfelt) json["not_felt"].push_back(names[k]);
    for (const std::size_t k : answer.left_out) json["left_out_unfelt"].push_back(names[k]);
    for (std::size_t k = 0; k < names.size(); ++k) {
        const NearestNeighbour& nearest = answer.closer.nearest[k];
        json["nearest"][names[k]] = {{"pattern", names[nearest.place]},
                                     {"dissimilarity", nearest.dissimilarity},
                                     {"verdict", nullptr}};
        if (nearest.place == k) continue;  // it was compared with none
        json["nearest"][names[k]]["verdict"] = words_of(pair_verdict(set, k, nearest.place));
    }
    return json;
}

std::string text_of(const CloseGroups& close, const std::vector<std::string>& names) {
    std::string text;
    for (const CloseGroup& group : close.groups) {
        text += "\n";
        for (const std::size_t place : group.members) text += names[place] + "\n";
    }
    return text;
}

std::string text_of(const ReportAnswer& answer, const std::vector<std::string>& names) {
    const std::string pairs = " of " + grouped_digits(answer.pm.condensed.size()) + " pairs";
    const CloserThan& than = answer.closer_than;
    return "the same, within a felt step: " + grouped_digits(answer.confused.pairs) + pairs + "\n" +
           text_of(answer.confused, names) + "\ncloser than " + shown_text(than.words) +
           ", below PM " + significant_digits(than.dissimilarity, 6) + ", " + than.source + ": " +
           grouped_digits(answer.closer.pairs) + pairs + "\n" + text_of(answer.closer, names);
}

}  // namespace

Expected<Done> run(const ReportCommand& command) {
    const Interrupt interrupt;
    if (const auto writable = writable_result(command.out); !writable) return writable.error();
    Expected<FeltSet> sets = load_felt(command.common);
    if (!sets) return sets.error();
    if (const auto pair = need_a_pair(sets->meant, command.common); !pair) return pair.error();
    give_looks(sets->meant);
    const Expected<ReportAnswer> answer = answer_of(command, *sets, interrupt.token());
    if (!answer) return answer.error();
    Report report{.set = sets->meant,
                  .felt = sets->felt,
                  .dissimilarity = answer->pm,
                  .answer = answer->subset,
                  .space = answer->space,
                  .confused = answer->confused,
                  .closer = answer->closer,
                  .alike = answer->alike,
                  .unfelt = answer->unfelt,
                  .left_out = left_out_words(answer->left_out.size()),
                  .closer_than = answer->closer_than,
                  .by = sets->labels.by,
                  .program = kProgramVersion,
                  .date = utc_today()};
    if (answer->stability) report.stability = &*answer->stability;
    report.labels = lines_of(sets->labels);
    if (const auto written = write_atomically(command.out, report_page(report)); !written) {
        return written;
    }
    std::cerr << "tactspace: wrote " << command.out.string() << "\n";
    const std::vector<std::string> names = names_of(sets->meant);
    return write_result({}, [&](std::ostream& stream) {
        if (command.common.json) {
            nlohmann::json json = json_of(*answer, sets->meant, names);
            add_labels(json, sets->labels);
            stream << text_of_json(json) << "\n";
        } else {
            stream << text_of(sets->labels) << text_of(*answer, shown_texts(names));
        }
    });
}

}  // namespace tact
