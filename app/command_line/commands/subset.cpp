// tactspace subset: which k patterns nobody confuses.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "app/command_line/rated_sets.h"
#include "app/report/report.h"
#include "app/session/program_version.h"
#include "app/subset/subset.h"
#include "model/io/people/ratings_file.h"
#include "model/io/set/set_file.h"
#include "model/map/mds.h"
#include "model/set/felt_versions.h"
#include "model/subset/set_subset.h"
#include "model/subset/subset.h"
#include "model/subset/subset_stability.h"
#include "model/tasks/set_pairs.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

bool is_by_pm(const SubsetCommand& command) {
    return command.matrix.empty() && command.ratings.empty() && command.metric == "pm";
}

// What is picked from.
struct Source {
    PatternSet set;   // as it is meant: what is written
    PatternSet felt;  // as a device plays it: what is compared
    Labels labels;
    SetPairs pairs{};          // of what is compared; by ratings or a matrix all count as felt
    NumberMark matrix_mark{};  // of the file of a matrix
};

Expected<Dissimilarity> of_ratings(const SubsetCommand& command, Source& source) {
    const std::vector<fs::path>& files = command.ratings;
    const Expected<AnswerColumns> columns = told_columns(command.columns, command.written);
    if (!columns) return columns.error();
    const Expected<LoadedRatings> loaded = read_ratings(files, RatingScale::guess, {}, *columns);
    if (!loaded) return with_columns_option(loaded.error());
    for (const std::string& remark : loaded->remarks) {
        std::cerr << "tactspace: " << remark << "\n";
    }
    Expected<RatingStudy> study = matched(loaded->study, names_of(source.set));
    if (!study) return Error{files.front().string() + ": " + study.error().message};
    note_edited(*study, source.set);
    source.labels.mark = source.labels.mark | mark_of(*study);
    source.labels.edited = study->edited;
    source.labels.gone = study->gone;
    Dissimilarity mean = mean_ratings(*study);
    const auto unrated =
        std::ranges::count_if(mean.condensed, [](double value) { return !std::isfinite(value); });
    if (unrated > 0) {
        std::fprintf(stderr, "tactspace: %td pairs were not rated and count as alike\n", unrated);
    }
    return mean;
}

Expected<SetPairs> of_metric(const SubsetCommand& command, const PatternSet& felt,
                             std::stop_token stop) {
    PairsRequest request{*metric_named(command.metric)};
    request.options.threads = command.common.threads;
    request.options.stop = std::move(stop);
    request.options.progress = progress_line("comparing patterns");
    auto pairs = set_pairs(felt, request);
    if (!pairs) return Error{"stopped before all patterns were compared"};
    return *std::move(pairs);
}

Expected<Source> source_of(const SubsetCommand& command, std::stop_token stop) {
    Expected<FeltSet> sets = load_felt(command.common);
    if (!sets) return sets.error();
    if (const auto pair = need_a_pair(sets->meant, command.common); !pair) return pair.error();
    Source source{std::move(sets->meant), std::move(sets->felt), std::move(sets->labels)};
    if (command.matrix.empty() && command.ratings.empty()) {
        Expected<SetPairs> pairs = of_metric(command, source.felt, std::move(stop));
        if (!pairs) return pairs.error();
        source.pairs = *std::move(pairs);
        return source;
    }
    Expected<Dissimilarity> matrix = command.matrix.empty()
                                         ? of_ratings(command, source)
                                         : dissimilarities_in(command.matrix, names_of(source.set),
                                                              command.written, &source.matrix_mark);
    if (!matrix) return matrix.error();
    source.pairs.apart = *std::move(matrix);
    return source;
}

// With the locks of the set. A pattern that is asked for is not dropped by them, nor the reverse.
Expected<Done> apply_locks(const SubsetCommand& command, PatternSet& set) {
    for (const auto& [names, keep] : {std::pair(&command.keep, true), {&command.drop, false}}) {
        for (const std::string& name : *names) {
            const Expected<std::size_t> place = place_of(set, name);
            if (!place) return Error{(keep ? "--keep: " : "--drop: ") + place.error().message};
            Vibration& vibration = set.vibrations[*place];
            if (!keep && std::ranges::find(command.keep, name) != command.keep.end()) {
                return Error{"--drop: \"" + name + "\" is to be kept as well"};
            }
            vibration.locked = keep;
            vibration.dropped = !keep;
        }
    }
    return Done{};
}

const char* objective_name(SubsetObjective objective) {
    return objective == SubsetObjective::max_min ? "max-min" : "max-sum";
}

nlohmann::json json_of(const Subset& subset, const Names& names) {
    nlohmann::json patterns = nlohmann::json::array();
    for (const std::size_t member : subset.members) patterns.push_back(names[member]);
    return {{"patterns", patterns},
            {"weakest",
             {{"a", names[subset.weakest.first]},
              {"b", names[subset.weakest.second]},
              {"dissimilarity", subset.weakest_dissimilarity}}},
            {"sum", subset.sum}};
}

struct SubsetResult {
    std::vector<std::size_t> left_out;  // as nobody feels them
    SubsetObjective objective = SubsetObjective::max_min;
    SubsetAnswer answer;
    std::vector<CurvePoint> curve;
    std::optional<Stability> stability;
};

nlohmann::json json_of(const SubsetResult& result, const SubsetCommand& command,
                       const Names& names) {
    const SubsetAnswer& answer = result.answer;
    nlohmann::json json = json_of(answer.best, names);
    json["objective"] = objective_name(result.objective);
    json["optimal"] = answer.proof == SubsetProof::optimal;
    json["bound"] = answer.bound;
    if (command.alternatives > 0) {
        json["alternatives"] = nlohmann::json::array();
        for (const Subset& other : answer.alternatives) {
            json["alternatives"].push_back(json_of(other, names));
        }
        json["alternatives_proven"] = answer.are_alternatives_proven;
    }
    if (!result.left_out.empty()) {
        for (const std::size_t k : result.left_out) json["left_out_unfelt"].push_back(names[k]);
    }
    for (const CurvePoint& point : result.curve) {
        json["curve"].push_back(
            {{"k", point.count}, {"weakest", point.weakest}, {"bound", point.bound}});
    }
    if (result.stability) {
        json["sensitivity"] = {{"draws", result.stability->draws},
                               {"same", result.stability->share_same},
                               {"same_weakest", result.stability->share_weakest}};
        for (std::size_t k = 0; k < names.size(); ++k) {
            json["sensitivity"]["picked"][names[k]] = result.stability->share_picked[k];
        }
    }
    return json;
}

std::string proof_text(const SubsetResult& result) {
    const SubsetAnswer& answer = result.answer;
    const bool by_sum = result.objective == SubsetObjective::max_sum;
    switch (answer.proof) {
        case SubsetProof::optimal:
            return "optimal: no other has a larger " +
                   std::string(by_sum ? "sum" : "distance of its weakest pair");
        case SubsetProof::ties_open:
            return "no weakest pair can be farther apart; time ran out before the sum was settled";
        case SubsetProof::open:
            break;
    }
    return "time ran out: the best found so far; no " +
           std::string(by_sum ? "sum" : "weakest pair") + " is above " +
           significant_digits(answer.bound, 6);
}

// What an alternative has that the best has not: "- a + b".
std::string exchange_text(const Subset& best, const Subset& other, const Names& names) {
    std::string text;
    for (const std::size_t member : best.members) {
        if (!std::ranges::binary_search(other.members, member)) text += "- " + names[member] + " ";
    }
    for (const std::size_t member : other.members) {
        if (!std::ranges::binary_search(best.members, member)) text += "+ " + names[member] + " ";
    }
    return text;
}

std::string stability_text(const Stability& stability, const Names& names) {
    std::vector<TextRow> rows{{"picked in", "draws"}};
    for (const std::size_t k : ever_picked(stability)) {
        rows.push_back({names[k], fixed_digits(100.0 * stability.share_picked[k], 0) + " %"});
    }
    return "\n" + counted(static_cast<std::size_t>(stability.draws), "draw", "draws") +
           " of the model: the same subset in " + fixed_digits(100.0 * stability.share_same, 0) +
           " %, the same weakest pair in " + fixed_digits(100.0 * stability.share_weakest, 0) +
           " %\n" + aligned(rows);
}

std::string text_of(const SubsetResult& result, const Names& names) {
    const SubsetAnswer& answer = result.answer;
    const Subset& best = answer.best;
    std::string text;
    for (const std::size_t member : best.members) text += names[member] + "\n";
    text += "\nweakest pair  " + significant_digits(best.weakest_dissimilarity, 6) + "  " +
            names[best.weakest.first] + " and " + names[best.weakest.second] + "\nsum           " +
            significant_digits(best.sum, 6) + "\n" + proof_text(result) + "\n";
    if (!result.left_out.empty()) {
        text += left_out_words(result.left_out.size()) + " (--include-unfelt):";
        for (const std::size_t k : result.left_out) text += " " + names[k];
        text += "\n";
    }
    if (!answer.alternatives.empty()) {
        std::vector<TextRow> rows{{"alternatives", "weakest", "sum"}};
        for (const Subset& other : answer.alternatives) {
            rows.push_back({exchange_text(best, other, names),
                            significant_digits(other.weakest_dissimilarity, 6),
                            significant_digits(other.sum, 6)});
        }
        text += "\n" + aligned(rows);
        if (!answer.are_alternatives_proven) text += "time ran out: others may lie between\n";
    }
    if (!result.curve.empty()) {
        std::vector<TextRow> rows{{"k", "weakest", "at most"}};
        for (const CurvePoint& point : result.curve) {
            rows.push_back({std::to_string(point.count), significant_digits(point.weakest, 6),
                            significant_digits(point.bound, 6)});
        }
        text += "\n" + aligned(rows);
    }
    return result.stability ? text + stability_text(*result.stability, names) : text;
}

// Twice the count, and some more, tell whether another one would do better.
std::size_t last_of_curve(const SubsetCommand& command) {
    return static_cast<std::size_t>(2 * command.count + 4);
}

// The map of the set as the window has it.
PerceptualSpace map_of(const SubsetCommand& command, const Source& source, std::stop_token stop) {
    MdsParams params = standard_mds_params(source.pairs.apart.size, 3);
    params.threads = command.common.threads;
    return nonmetric_mds(source.pairs.apart, params, stop);
}

std::optional<Stability> stability_of(const SubsetCommand& command, const Source& source,
                                      const SubsetProblem& problem, const Subset& subset,
                                      std::stop_token stop) {
    StabilityParams params;
    params.draws = static_cast<std::size_t>(command.draws);
    params.time_limit_s = command.time_limit_s;
    params.threads = command.common.threads;
    params.stop = stop;
    params.progress = progress_line("drawing models");
    const PerceptualSpace space = map_of(command, source, stop);
    return subset_stability(source.felt, problem, subset, space.points, params);
}

Expected<SubsetResult> picked(const SubsetCommand& command, const Source& source,
                              std::stop_token stop) {
    SubsetResult result;
    if (command.objective == "max-sum") result.objective = SubsetObjective::max_sum;
    if (!command.include_unfelt) result.left_out = left_out_unfelt(source.set, source.pairs.unfelt);
    const SubsetProblem problem = subset_problem(
        source.set, static_cast<std::size_t>(command.count), result.objective, result.left_out);
    SubsetOptions options;
    options.time_limit_s = command.time_limit_s;
    options.alternatives = static_cast<std::size_t>(command.alternatives);
    options.threads = command.common.threads;
    options.stop = stop;
    tell_search(options, "picking", problem.objective);
    Expected<SubsetAnswer> answer = most_distinct_subset(source.pairs.apart, problem, options);
    if (!answer) return unpickable(answer.error(), result.left_out.size());
    result.answer = *std::move(answer);
    if (command.curve) {
        options.progress = progress_line("trying other counts");
        result.curve =
            weakest_by_count(source.pairs.apart, problem, last_of_curve(command), options);
    }
    if (command.draws > 0) {
        result.stability = stability_of(command, source, problem, result.answer.best, stop);
    }
    return result;
}

Expected<Done> write_report_of(const SubsetCommand& command, const Source& source,
                               const SubsetResult& result, std::stop_token stop) {
    const PerceptualSpace space = map_of(command, source, stop);
    const std::string quantity = !command.matrix.empty() ? "Dissimilarity"
                                 : !command.ratings.empty()
                                     ? "Rating"
                                     : traits(*metric_named(command.metric)).name;
    const CloserThan than = closer_than_picked(result.answer);
    Report report{.set = source.set,
                  .felt = source.felt,
                  .dissimilarity = source.pairs.apart,
                  .quantity = source.labels.mark.synthetic ? "Synthetic rating" : quantity,
                  .objective = result.objective,
                  .answer = result.answer,
                  .space = space,
                  .space_of = quantity,
                  .alike = alike_patterns(source.set, source.pairs, than.dissimilarity,
                                          result.answer.best.members.size()),
                  .unfelt = source.pairs.unfelt,
                  .left_out = left_out_words(result.left_out.size()),
                  .closer_than = than,
                  .by = source.labels.by,
                  .program = kProgramVersion,
                  .date = utc_today(),
                  .mark = source.labels.mark | source.matrix_mark,
                  .labels = lines_of(source.labels)};
    for (std::string& said : sentences_of(source.matrix_mark)) {
        report.labels.push_back(std::move(said));
    }
    if (result.stability) report.stability = &*result.stability;
    return write_subset(command.report, report);
}

}  // namespace

Expected<Done> run(const SubsetCommand& command) {
    if (command.draws > 0 && !is_by_pm(command)) {
        return Error{"--sensitivity is for pm: only PM has the model's parameters"};
    }
    const bool is_metric = command.matrix.empty() && command.ratings.empty();
    for (const auto& [option, value] : {std::pair("--rendered-by", &command.common.rendered_by),
                                        std::pair("--exported-as", &command.common.exported_as)}) {
        if (is_metric || value->empty()) continue;
        return Error{std::string(option) +
                     " is for a metric: ratings and matrices are taken unchanged"};
    }
    const Interrupt interrupt;
    Expected<Source> source = source_of(command, interrupt.token());
    if (!source) return source.error();
    if (const auto locked = apply_locks(command, source->set); !locked) return locked;
    const Expected<SubsetResult> result = picked(command, *source, interrupt.token());
    if (!result) return result.error();
    // The best so far, without what was not begun, is not what was asked for.
    if (interrupt.token().stop_requested()) return Error{"stopped, and nothing is written"};
    if (!command.out.empty()) {
        const PatternSet part = part_of(source->set, result->answer.best.members);
        if (const auto written = write_set_file(command.out, part); !written) return written;
    }
    if (!command.report.empty()) {
        const auto written = write_report_of(command, *source, *result, interrupt.token());
        if (!written) return written;
    }
    const Names names = names_of(source->set);
    const std::string matrix_mark = corner_text(source->matrix_mark);
    return write_result({}, [&](std::ostream& stream) {
        if (command.common.json) {
            nlohmann::json json = json_of(*result, command, names);
            add_labels(json, source->labels);
            if (!command.ratings.empty()) json["synthetic"] = source->labels.mark.synthetic;
            if (!matrix_mark.empty()) json["mark"] = matrix_mark;
            stream << text_of_json(json) << "\n";
        } else {
            if (!matrix_mark.empty()) stream << matrix_mark << "\n";
            stream << text_of(source->labels) << text_of(*result, shown_texts(names));
        }
    });
}

}  // namespace tact
