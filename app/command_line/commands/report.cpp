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
#include "model/perceptual_model/perceptual_model.h"
#include "model/subset/set_subset.h"
#include "model/text/atomic_file.h"
#include "model/text/numbers.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

struct ReportAnswer {
    Dissimilarity pm;
    SubsetAnswer subset;
    Confusion confused;
    std::string confused_at;
    PerceptualSpace space;
    std::optional<Stability> stability;
};

Error stopped() { return Error{"stopped before the report was made"}; }

// Of a small set half: the most distinct of all but one would say nothing.
std::size_t picked_count(const ReportCommand& command, std::size_t patterns) {
    constexpr std::size_t kUsual = 8;
    if (command.count) return static_cast<std::size_t>(*command.count);
    return std::clamp((patterns + 1) / 2, std::size_t{2}, kUsual);
}

Expected<SubsetAnswer> picked_for_report(const ReportCommand& command, const PatternSet& set,
                                         const Dissimilarity& pm, std::stop_token stop) {
    SubsetProblem problem =
        subset_problem(set, picked_count(command, set.vibrations.size()), SubsetObjective::max_min);
    if (!command.count) problem.count = std::max(problem.count, problem.keep.size());
    SubsetOptions options;
    options.time_limit_s = command.time_limit_s;
    options.threads = command.common.threads;
    options.stop = stop;
    options.progress = progress_line("picking");
    return most_distinct_subset(pm, problem, options);
}

// What counts as confused: a number, a pair of names, or as far apart as the subset's weakest pair.
Expected<double> threshold_of(const ReportCommand& command, const PatternSet& set,
                              ReportAnswer& answer) {
    if (command.confused_at.empty()) {
        answer.confused_at = confused_at_words(answer.subset, answer.subset.best.members.size());
        return answer.subset.best.weakest_dissimilarity;
    }
    if (const auto number = finite_number_in(command.confused_at)) {
        if (*number < 0.0) return Error{"--confused-at: expected a PM of 0 or more"};
        answer.confused_at = "a value that was given";
        return *number;
    }
    const auto pair = pair_of(set, "--confused-at", command.confused_at);
    if (!pair) return pair.error();
    answer.confused_at = "as far apart as " + set.vibrations[pair->a].name + " and " +
                         set.vibrations[pair->b].name + ", a pair that was given";
    return answer.pm(pair->a, pair->b);
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
    const SubsetProblem problem =
        subset_problem(sets.meant, answer.subset.best.members.size(), SubsetObjective::max_min);
    answer.stability =
        subset_stability(sets.felt, problem, answer.subset.best, answer.space.points, sure);
    if (!answer.stability) return stopped();
    return Done{};
}

Expected<ReportAnswer> answer_of(const ReportCommand& command, const FeltSet& sets,
                                 std::stop_token stop) {
    PredictOptions options;
    options.threads = command.common.threads;
    options.stop = stop;
    options.progress = progress_line("comparing patterns");
    auto prediction = predict(model_waveforms(sets.felt), sets.felt.model, options);
    if (!prediction) return stopped();
    ReportAnswer answer;
    answer.pm = std::move(prediction->pm);
    auto subset = picked_for_report(command, sets.meant, answer.pm, stop);
    if (!subset) return subset.error();
    answer.subset = *std::move(subset);
    const Expected<double> threshold = threshold_of(command, sets.meant, answer);
    if (!threshold) return threshold.error();
    answer.confused = confusion(answer.pm, {*threshold, kSameShare * *threshold});
    if (const auto looked = look_at_likeness(command, sets, stop, answer); !looked) {
        return looked.error();
    }
    return answer;
}

nlohmann::json json_of(const ReportAnswer& answer, const std::vector<std::string>& names) {
    const Confusion& confused = answer.confused;
    nlohmann::json json{{"confused_below", confused.thresholds.confused},
                        {"confused_at", answer.confused_at},
                        {"same_below", confused.thresholds.same},
                        {"confused_pairs", confused.confused_pairs},
                        {"groups", nlohmann::json::array()},
                        {"distinct", distinct_count(confused)},
                        {"optimal", answer.subset.proof == SubsetProof::optimal},
                        {"bound", answer.subset.bound}};
    for (const ConfusedGroup& group : confused.groups) {
        nlohmann::json members = nlohmann::json::array();
        for (const std::size_t place : group.members) members.push_back(names[place]);
        json["groups"].push_back(members);
    }
    for (const std::size_t place : answer.subset.best.members) {
        json["picked"].push_back(names[place]);
    }
    for (std::size_t k = 0; k < names.size(); ++k) {
        const NearestNeighbour& nearest = confused.nearest[k];
        json["nearest"][names[k]] = {
            {"pattern", names[nearest.place]},
            {"dissimilarity", nearest.dissimilarity},
            {"verdict", kConfusionVerdicts[static_cast<std::size_t>(nearest.verdict)]}};
    }
    return json;
}

std::string text_of(const ReportAnswer& answer, const std::vector<std::string>& names) {
    const Confusion& confused = answer.confused;
    std::string text = "confused below PM " + significant_digits(confused.thresholds.confused, 6) +
                       ", " + answer.confused_at + ": " + grouped_digits(confused.confused_pairs) +
                       " of " + grouped_digits(answer.pm.condensed.size()) + " pairs\n";
    for (const ConfusedGroup& group : confused.groups) {
        text += "\n";
        for (const std::size_t place : group.members) text += names[place] + "\n";
    }
    if (confused.groups.empty()) text += "no groups: all patterns are clear of each other\n";
    return text;
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
                  .confusion = answer->confused,
                  .confused_at = answer->confused_at,
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
            nlohmann::json json = json_of(*answer, names);
            add_labels(json, sets->labels);
            stream << json.dump() << "\n";
        } else {
            stream << text_of(sets->labels) << text_of(*answer, names);
        }
    });
}

}  // namespace tact
