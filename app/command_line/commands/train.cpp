// tactspace train: the parameters of the model that agree best with what people said.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/command_line/commands.h"
#include "app/command_line/endings.h"
#include "app/command_line/output.h"
#include "app/command_line/rated_sets.h"
#include "app/model_bench/model_bench.h"
#include "app/session/program_version.h"
#include "model/io/set/model_file.h"
#include "model/set/pattern_set.h"
#include "model/tasks/set_training.h"
#include "model/text/atomic_file.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/training/training.h"

namespace tact {

namespace {

constexpr std::size_t kListedTies = 20;

TextRow row_of(const std::string& name, const std::vector<std::string>& parameters) {
    TextRow row{name};
    row.insert(row.end(), parameters.begin(), parameters.end());
    return row;
}

TextRow parameters_row(const std::string& name, const PerceptualModelParams& model, double step) {
    return row_of(name, parameter_texts(model, step));
}

TextRow names_row(const std::string& first) {
    TextRow row{first};
    row.insert(row.end(), kTrainedNames.begin(), kTrainedNames.end());
    return row;
}

std::string head_of(const Training& training) {
    const bool absolute = training.objective == TrainingObjective::mean_absolute_rho;
    const auto different =
        kTrainedLayers * training.grid.channels.size() * training.grid.mixes.size();
    std::string text =
        std::string(absolute ? "mean |rho| " : "mean rho ") + fixed_digits(training.best.value, 3) +
        ", before " + fixed_digits(training.value_before, 3) + ", over " +
        std::to_string(training.sets.size()) + (training.sets.size() == 1 ? " set\n" : " sets\n");
    text += "searched " + grouped_digits(combination_count(training.grid.units)) +
            " combinations, " + grouped_digits(different) + " that differ\n";
    text += grouped_digits(training.best.combinations) + " of them are the best, " +
            fixed_digits(100.0 * training.share_near_best, 3) + " % at most " +
            fixed_digits(kNearBest, 2) + " below\n";
    return text;
}

std::string parameters_text(const Training& training) {
    const double step = 1.0 / training.grid.units;
    return aligned({names_row("parameters"), parameters_row("before", training.before, step),
                    parameters_row("trained", training.model, step)});
}

// The smallest of each proportion; the layers where OC alone decides are any.
std::string ties_text(const Training& training) {
    if (training.best.classes < 2) return {};
    std::vector<TextRow> rows{names_row("equally good")};
    for (const GridPoint& point : training.best.points) {
        if (rows.size() > kListedTies) break;
        rows.push_back(row_of("x " + std::to_string(combinations_of(training.grid, point)),
                              parameter_texts(training.grid, point)));
    }
    std::string text = aligned(rows);
    const std::uint64_t more = training.best.classes - (rows.size() - 1);
    if (more > 0) text += "and " + grouped_digits(more) + " more; --json lists them\n";
    return "\nin proportion, and how many combinations each stands for\n" + text;
}

std::string marginals_text(const Training& training) {
    const std::size_t weights = training.best_of[7].size();
    const std::size_t steps = std::max(weights, training.best_of[0].size());
    std::vector<TextRow> rows{names_row("best with layers / weight")};
    for (std::size_t k = 0; k < steps; ++k) {
        const double step = 1.0 / training.grid.units;
        const std::string weight =
            k < weights ? weight_text(static_cast<double>(k) * step, step) : "-";
        TextRow row{(k <= kMostTrainedLayers ? std::to_string(k) : "-") + " / " + weight};
        for (const auto& best : training.best_of) {
            row.push_back(k < best.size() && std::isfinite(best[k]) ? fixed_digits(best[k], 3)
                                                                    : "");
        }
        rows.push_back(row);
    }
    return "\n" + aligned(rows);
}

std::string sets_text(const Training& training) {
    std::vector<TextRow> rows{{"set", "patterns", "rated pairs", "rho before", "rho trained"}};
    for (const TrainedSet& set : training.sets) {
        rows.push_back({set.name, std::to_string(set.patterns), std::to_string(set.rated_pairs),
                        fixed_digits(set.rho_before, 3), fixed_digits(set.rho_after, 3)});
    }
    return "\n" + aligned(rows);
}

// What was left out, by the word of --leave-out, and what it was tried on.
struct LeftOutTable {
    const char* option;
    const char* what;
    const std::vector<LeftOut>& rows;
    const char* meaning;
};

std::vector<LeftOutTable> left_out_tables(const Training& training) {
    return {
        {"sets", "set", training.without_set, "tried on other vibrations than the fit has seen"},
        {"participants", "participant", training.without_participant,
         "tried on another person, on the same vibrations: it says nothing of others"},
        {"patterns", "pattern", training.without_pattern,
         "tried on the pairs with a vibration that the fit has not seen, by the same people"}};
}

// On what was left out: what to expect of sets and people that nothing was fitted to.
std::string left_out_text(const Training& training, const LeftOutTable& table) {
    const std::vector<LeftOut>& left_out = table.rows;
    if (left_out.empty()) return {};
    const char* what = table.what;
    TextRow head = names_row(std::string("without ") + what);
    head.insert(head.end(), {"of the rest", "rho before", "rho of it"});
    std::vector<TextRow> rows{head};
    for (const LeftOut& one : left_out) {
        TextRow row = parameters_row(one.name, one.model, 1.0 / training.grid.units);
        row.insert(row.end(), {fixed_digits(one.value, 3), fixed_digits(one.rho_before, 3),
                               fixed_digits(one.rho_after, 3)});
        rows.push_back(row);
    }
    const LeftOutMean mean = mean_of(left_out);
    const std::string text = "\n" + aligned(rows) + table.meaning + "\n";
    if (std::isnan(mean.rho_after)) return text;
    return text + "mean of what was left out: rho " + fixed_digits(mean.rho_after, 3) +
           ", before " + fixed_digits(mean.rho_before, 3) + "\n";
}

std::string people_text(const std::vector<RatedPatterns>& rated) {
    std::string text;
    for (const RatedPatterns& one : rated) {
        text += text_of(one.labels) + text_on(one.left_out);
        const std::string unrated =
            remark_on_unrated(unrated_patterns(one.study), one.study.labels.size());
        if (!unrated.empty()) text += unrated + "\n";
    }
    return text;
}

std::string json_text(const Trained& trained, const TrainRequest& request,
                      const std::vector<RatedPatterns>& rated) {
    nlohmann::json all = json_of(trained, request);
    for (std::size_t s = 0; s < rated.size(); ++s) {
        all["sets"][s]["left_out"] = json_of(rated[s].left_out);
        add_labels(all["sets"][s], rated[s].labels);
    }
    return text_of_json(all) + "\n";
}

std::string text_of(const Training& training, const TrainCommand& command,
                    const std::vector<RatedPatterns>& rated) {
    std::string text = head_of(training) + people_text(rated) + "\n" + parameters_text(training) +
                       ties_text(training) + sets_text(training) + marginals_text(training);
    for (const LeftOutTable& table : left_out_tables(training)) {
        if (command.leave_out == table.option) text += left_out_text(training, table);
    }
    return text +
           "rho: Spearman's, of PM with the mean ratings of each set; every combination is "
           "tried: nothing is drawn or resampled, and there is no test\n";
}

// A row a fit: of all ratings on each set, then without what was left out on just that.
void write_csv(std::ostream& stream, const Training& training, const TrainCommand& command,
               const std::vector<RatedPatterns>& rated) {
    TextRow head{"left_out",   "tried_on", "synthetic",  "people_left_out",
                 "rehearsals", "patterns", "rated_pairs"};
    head.insert(head.end(), kTrainedNames.begin(), kTrainedNames.end());
    head.insert(head.end(), {"objective", "value", "rho_before", "rho_after"});
    stream << csv_line(head);
    NumberMark all;
    const auto add = [&](const std::string& left_out, const std::string& tried_on,
                         const NumberMark& mark, const TextRow& counts,
                         const PerceptualModelParams& model, double value, double before,
                         double after) {
        TextRow row{left_out, tried_on, mark.synthetic ? "1" : "0", std::to_string(mark.left_out),
                    std::to_string(mark.rehearsals)};
        row.insert(row.end(), counts.begin(), counts.end());
        for (const double one : trained_values(model)) row.push_back(csv_number(one));
        row.insert(row.end(),
                   {command.objective, csv_number(value), csv_number(before), csv_number(after)});
        stream << csv_line(row);
    };
    for (std::size_t s = 0; s < training.sets.size(); ++s) {
        const TrainedSet& set = training.sets[s];
        const NumberMark mark = mark_of(rated[s].study);
        all = all | mark;
        add("", set.name, mark, {std::to_string(set.patterns), std::to_string(set.rated_pairs)},
            training.model, training.best.value, set.rho_before, set.rho_after);
    }
    for (const LeftOutTable& table : left_out_tables(training)) {
        if (command.leave_out != table.option) continue;
        for (const LeftOut& one : table.rows) {
            add(table.what, one.name, all, {"", ""}, one.model, one.value, one.rho_before,
                one.rho_after);
        }
    }
}

// The sets that are asked for, with the choices of the first one's model.
TrainRequest request_of(const TrainCommand& command, const std::vector<RatedPatterns>& rated) {
    TrainRequest request;
    for (const RatedPatterns& one : rated) {
        request.sets.push_back(training_set(one.name, one.set, one.study, command.common.threads));
        if (!(one.set.model == rated.front().set.model)) {
            std::cerr << "tactspace: " << one.name << ": has another model than "
                      << rated.front().name << ", whose choices are taken for all\n";
        }
    }
    const auto place_of = [](const std::string& word, const auto& words) {
        return std::ranges::find(words, word) - std::begin(words);
    };
    request.model = rated.front().set.model;
    request.units = *units_of_step(command.step);
    request.objective =
        static_cast<TrainingObjective>(place_of(command.objective, kObjectiveNames));
    request.leave_out = static_cast<LeaveOut>(place_of(command.leave_out, kLeaveOutNames));
    request.program = kProgramVersion;
    request.threads = command.common.threads;
    request.progress = progress_line("searching");
    return request;
}

}  // namespace

std::string fault_of_step(const std::string& text) {
    const auto units = units_of_step(std::strtod(text.c_str(), nullptr));
    return units ? std::string() : units.error().message;
}

Expected<Done> run(const TrainCommand& command) {
    const Interrupt interrupt;  // first: threads inherit what it blocks
    const Expected<std::vector<RatedPatterns>> rated = load_rated(command.common, command.ratings);
    if (!rated) return rated.error();
    TrainRequest request = request_of(command, *rated);
    request.stop = interrupt.token();
    if (const auto fits = can_train(request); !fits) return fits;
    if (const auto writable = writable_result(command.csv); !writable) return writable;
    if (!command.out.empty()) {
        // Better known before the work than after it.
        if (const auto file = AtomicFile::open(command.out); !file) return file.error();
    }
    const std::optional<Trained> trained = train(request);
    if (!trained) return Error{"stopped before the search was done; nothing was written"};
    const Training& training = trained->training;
    if (!command.out.empty()) {
        const auto written = write_model_file(command.out, {training.model, trained->record});
        if (!written) return written;
    }
    if (!command.csv.empty()) {
        const auto written = write_result(command.csv, [&](std::ostream& stream) {
            write_csv(stream, training, command, *rated);
        });
        if (!written) return written;
    }
    const std::string text = command.common.json ? json_text(*trained, request, *rated)
                                                 : text_of(training, command, *rated);
    return write_result({}, [&text](std::ostream& stream) { stream << text; });
}

}  // namespace tact
