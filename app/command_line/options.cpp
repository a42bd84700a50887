#include "app/command_line/options.h"

#include <algorithm>
#include <map>
#include <vector>

#include "devices/calibration/rendering.h"
#include "model/evaluation/metric.h"
#include "model/io/effects/actuator_map.h"
#include "model/io/formats/write_effect.h"
#include "model/text/described.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// Rules on how people answered, of a study's folder; none is on by itself.
void add_conduct(CLI::App& command, ConductRule& rule) {
    CLI::Option* fast = command
                            .add_option("--too-fast", rule.fast_below_s,
                                        "leave out who answered in less than this many seconds too "
                                        "often (--too-fast-share)")
                            ->check(within(limits::kFastBelowS));
    command
        .add_option("--too-fast-share", rule.fast_share,
                    "share of a person's answers that may be that fast; default: 0.1")
        ->check(within(limits::kFastShare))
        ->needs(fast);
    command
        .add_option("--repeat-rho", rule.repeat_rho,
                    "leave out whose own repetitions agree less than this (mean Spearman's rho)")
        ->check(within(limits::kRho));
    command
        .add_option("--most-replays", rule.replays,
                    "leave out who replayed more than this many per trial, on average")
        ->check(within(limits::kReplays));
}

}  // namespace

CLI::Validator within(double low, double high) {
    const std::string from_to = shortest_digits(low) + " to " + shortest_digits(high);
    const auto fault = [low, high, from_to](const std::string& text) -> std::string {
        const std::optional<double> number = finite_number_in(text);
        // What reads whole numbers after this takes 010 for eight.
        const std::size_t first = std::min(text.find_first_not_of("+- \t"), text.size());
        const bool is_octal = first + 1 < text.size() && text[first] == '0' &&
                              text[first + 1] >= '0' && text[first + 1] <= '9';
        if (!number || is_octal || *number < low || *number > high) {
            return "expected " + range_words({low, high}) + ", got \"" + text + "\"";
        }
        return {};
    };
    return {fault, from_to};
}

CLI::Validator within(Range range) { return within(range.low, range.high); }

void add_threads(CLI::App& command, int& threads) {
    command.add_option("--threads", threads, "threads to use; 0: all cores")
        ->check(within(0, 1024));
}

void add_common(CLI::App& command, CommonOptions& options) {
    command.add_option("SET", options.sets, kSetHelp)->required();
    command.add_flag("--strict", options.strict,
                     "End with exit code 1 where a file of a folder cannot be read; default: it is "
                     "left out and named");
    command.add_option("--actuator", options.actuator,
                       "how effect files meet g and Hz: a file (.acf or .json) or one of " +
                           actuator_names() + "; default: their format's own");
    add_threads(command, options.threads);
    command.add_flag("--json", options.json, "JSON instead of CSV on standard output");
    command.add_option("--model", options.model,
                       "file of model parameters, as train writes it, instead of the set's own");
}

void add_ratings(CLI::App& command, RatingFiles& ratings) {
    command.add_option("--ratings", ratings.files,
                       "files of ratings, one a participant, or a folder of them or of a "
                       "study's participants; for several "
                       "sets a file or folder each. Without it, the ratings in the set file");
    command
        .add_option("--scale", ratings.scale,
                    "what a high rating means: similarity (0-100), dissimilarity, or guess")
        ->check(CLI::IsMember({"guess", "similarity", "dissimilarity"}));
    command.add_option("--columns", ratings.columns, kAnswerColumnsHelp);
    add_table_hints(command, ratings.written);
    add_who_counts(command, ratings.who);
}

void add_table_hints(CLI::App& command, TableHints& written) {
    const auto add = [&command](const char* name, std::optional<char>& target,
                                const std::map<std::string, char>& signs, const char* help) {
        std::vector<std::string> words;
        for (const auto& [word, sign] : signs) words.push_back(word);
        command
            .add_option_function<std::string>(
                name, [&target, signs](const std::string& word) { target = signs.at(word); }, help)
            ->check(CLI::IsMember(words));
    };
    add("--separator", written.separator,
        {{"comma", ','}, {"semicolon", ';'}, {"tab", '\t'}, {"blank", ' '}},
        "between the cells of tables that are read; default: found in the file");
    add("--decimal", written.decimal, {{"point", '.'}, {"comma", ','}},
        "sign of numbers in tables that are read; default: found in the file");
}

void add_who_counts(CLI::App& command, CountRule& who) {
    command.add_option("--include", who.include,
                       "participants who count though a rule leaves them out; a rehearsal never "
                       "does");
    CLI::Option* exclude =
        command.add_option("--exclude", who.exclude, "participants who do not count, by name");
    command
        .add_option(
            "--because", who.because,
            "why; of a study's folder it is recorded there with the names, heeded from then "
            "on, and taken back by --include")
        ->needs(exclude)
        ->check([](const std::string& why) {
            return why.find_first_not_of(" \t") == why.npos ? std::string("expected a reason")
                                                            : std::string();
        });
    add_conduct(command, who.conduct);
}

void add_rendering(CLI::App& command, CommonOptions& options) {
    std::vector<std::string> keys;
    for (const ActuatorKind kind : kActuatorKinds) keys.emplace_back(traits(kind).key);
    command
        .add_option("--rendered-by", options.rendered_by,
                    "the patterns as this kind of device plays them")
        ->check(CLI::IsMember(keys));
    command
        .add_option("--full-scale", options.full_scale_g,
                    "acceleration that the device's full scale stands for, g; default: 1")
        ->check(within(kFullScaleRangeG));
    command
        .add_option("--level", options.rendered_level, "how strong it plays them, 0-1; default: 1")
        ->check(within(0.0, 1.0));
    command.add_option("--calibration", options.rendered_calibration,
                       "of a voice coil, in the place of its full scale; see calibrate");
}

void add_exporting(CLI::App& command, CommonOptions& options) {
    std::string keys;
    for (const TargetTraits& one : target_formats()) keys += std::string(" ") + one.key;
    command.add_option("--exported-as", options.exported_as,
                       "the patterns as they come back from files, FORMAT or FORMAT:ACTUATOR, "
                       "before any device plays them; formats:" +
                           keys);
}

void add_only(CLI::App& command, CommonOptions& options) {
    command
        .add_option_function<std::string>(
            "--only",
            [&options](const std::string& side) {
                options.only = side == "measured" ? Side::measured : Side::intended;
            },
            "intended or measured: leaves out the measured twins, or everything but them; compare "
            "holds a "
            "twin against the ratings of the pattern that it measures")
        ->check(CLI::IsMember({"intended", "measured"}));
}

std::string fault_of_metric(const std::string& key) {
    const Expected<Metric> metric = metric_named(key);
    return metric ? "" : metric.error().message;
}

std::string list_of_metrics() {
    std::string list = "Metrics:";
    for (const Metric metric : kMetrics) {
        const MetricTraits& about = traits(metric);
        const std::string key = about.key;
        list += "\n  " + key + std::string(15 - key.size(), ' ') + about.description;
        if (about.is_reference) list += " (a reference, not from the paper)";
    }
    return list;
}

}  // namespace tact
