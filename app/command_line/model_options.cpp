// What the model says of a set, and what follows from it.
#include "app/command_line/options.h"

#include "model/ask/steps.h"

namespace tact {

namespace {

// Most seconds or dissimilarities: more than anybody has, and few enough for a clock to count.
constexpr double kMost = 1e9;

// "amplitude_g, carrier_hz, .. or release_s".
std::string parameter_keys() {
    std::string keys = traits(kPatternParameters.front()).key;
    for (const PatternParameter parameter : kPatternParameters) {
        if (parameter == kPatternParameters.front()) continue;
        keys += (parameter == kPatternParameters.back() ? " or " : ", ");
        keys += traits(parameter).key;
    }
    return keys;
}

}  // namespace

void add_predict_command(CLI::App& app, PredictCommand& command, Chosen& chosen) {
    CLI::App& predict = add_command(
        app, "predict", "dissimilarity matrix of a set, as labelled CSV", command, chosen);
    add_rendering(predict, command.common);
    add_exporting(predict, command.common);
    predict.add_option("--metric", command.metric, "pm unless another of those below")
        ->check(fault_of_metric);
    predict.add_option("--out", command.out, "file for the matrix");
    predict.add_option("--image", command.image, "picture of the matrix, .png or .svg");
    predict.add_flag("--resume", command.resume,
                     "continue where a stopped run with the same --out left off: pm, nc and oc");
    auto* part = predict.add_option(
        "--part", command.part,
        "K/N: the K-th of N runs, each by itself, which keep their tiles beside --out");
    predict.add_flag("--join", command.join, "the matrix of what N runs with --part have kept")
        ->excludes(part);
    predict.add_flag("--first-as-reference", command.first_as_reference,
                     "st-sim and spqi: the earlier pattern of a pair is the reference, instead of "
                     "the mean of both ways");
    add_only(predict, command.common);
    predict.footer(list_of_metrics());
}

void add_space_command(CLI::App& app, SpaceCommand& command, Chosen& chosen) {
    CLI::App& space =
        add_command(app, "space", "coordinates of the perceptual space, as CSV", command, chosen);
    add_rendering(space, command.common);
    add_exporting(space, command.common);
    CLI::App& of = *space.add_option_group("Of", "the dissimilarity that is mapped; default: PM");
    auto* metric = of.add_option("--metric", command.metric, "another metric of those below")
                       ->check(fault_of_metric);
    auto* matrix =
        of.add_option("--matrix", command.matrix, "file with a matrix that has the patterns' names")
            ->excludes(metric);
    of.add_flag("--people", command.people, "what people said, by the set file or --ratings")
        ->excludes(metric)
        ->excludes(matrix);
    add_ratings(of, command.ratings);
    of.get_option("--ratings")->excludes(metric)->excludes(matrix);
    space.footer(list_of_metrics());
    space.add_option("--align-to", command.align_to,
                     "turned onto this map, coordinates as of space: Procrustes, with PROTEST's p");
    space.add_option("--dim", command.dimensions, "2 or 3")->check(within(2, 3));
    add_only(space, command.common);
    space.add_option("--starts", command.starts, "random starts in addition to Torgerson's")
        ->check(within(0, 100'000));
    space.add_option("--out", command.out, "file for the coordinates");
    space.add_option("--image", command.image, "picture of the space, .png or .svg");
}

namespace {

void add_unfelt(CLI::App& command, bool& include) {
    command.add_flag("--include-unfelt", include,
                     "also picks among patterns that no receptor answers to (default: they are "
                     "left out, but for kept ones)");
}

}  // namespace

void add_subset_command(CLI::App& app, SubsetCommand& command, Chosen& chosen) {
    CLI::App& subset = add_command(app, "subset", "the k most distinct patterns of a set, proven",
                                   command, chosen);
    add_rendering(subset, command.common);
    add_exporting(subset, command.common);
    add_only(subset, command.common);
    subset.add_option("-k,--count", command.count, "how many to pick")
        ->required()
        ->check(within(2, 10'000));
    subset
        .add_option("--objective", command.objective,
                    "max-min: the weakest pair as far apart as can be; max-sum: all pairs together")
        ->check(CLI::IsMember({"max-min", "max-sum"}));
    subset.add_option("--keep", command.keep, "a pattern to pick, as are locked ones; repeatable")
        ->allow_extra_args(false);
    subset.add_option("--drop", command.drop, "a pattern not to pick; repeatable")
        ->allow_extra_args(false);
    CLI::Option* metric =
        subset.add_option("--metric", command.metric, "pm unless another of those below")
            ->check(fault_of_metric);
    CLI::Option* matrix =
        subset.add_option("--matrix", command.matrix, "dissimilarities from a CSV file, by names");
    CLI::Option* ratings =
        subset.add_option("--ratings", command.ratings, "dissimilarities as people rated them");
    subset.add_option("--columns", command.columns, kAnswerColumnsHelp)->needs(ratings);
    add_table_hints(subset, command.written);
    matrix->excludes(metric)->excludes(ratings);
    ratings->excludes(metric);
    subset.add_option("--time-limit", command.time_limit_s, "s; default: 60")
        ->check(within(0.0, kMost));
    subset.add_option("--alternatives", command.alternatives, "how many of the next best to list")
        ->check(within(0, 1000));
    add_unfelt(subset, command.include_unfelt);
    subset.add_flag("--curve", command.curve, "also the weakest pair for other counts");
    subset
        .add_option("--sensitivity", command.draws,
                    "draws of what is uncertain in the model: how often each pattern is picked")
        ->check(within(0, 100'000));
    subset.add_option("--out", command.out, "a set file for the subset");
    subset.add_option("--report", command.report,
                      "a folder for the subset, a page about it and the map");
    subset.footer(list_of_metrics());
}

void add_report_command(CLI::App& app, ReportCommand& command, Chosen& chosen) {
    CLI::App& report = add_command(app, "report",
                                   "one page to send: groups that feel the same, the most "
                                   "distinct patterns, map, matrix, players",
                                   command, chosen);
    add_rendering(report, command.common);
    add_only(report, command.common);
    report.add_option("--out", command.out, "file for the page, .html")->required();
    add_unfelt(report, command.include_unfelt);
    report
        .add_option("-k,--count", command.count,
                    "how many most distinct patterns; default: 8, or half of a small set")
        ->check(within(2, 10'000));
    report.add_option(
        "--closer-than,--confused-at", command.confused_at,
        "lists pairs closer than this PM, or than the pair of these two names with a comma "
        "between (default: closer than the weakest pair of the most distinct)");
    report
        .add_option("--sure", command.draws,
                    "draws of what is uncertain in the model: how often the subset stays")
        ->check(within(0, 100'000));
    report.add_option("--time-limit", command.time_limit_s, "s for the search; default: 60")
        ->check(within(0.0, kMost));
}

void add_groups_command(CLI::App& app, GroupsCommand& command, Chosen& chosen) {
    CLI::App& groups = add_command(
        app, "groups", "a set in groups of alike patterns: a tree, cut by a number or by PM",
        command, chosen);
    add_rendering(groups, command.common);
    add_exporting(groups, command.common);
    add_only(groups, command.common);
    CLI::Option* count = groups
                             .add_option("-n,--count", command.count,
                                         "number of groups; default: 8, or half of a small set")
                             ->check(within(1, 10'000));
    groups
        .add_option("--cut", command.cut,
                    "instead the PM at which the tree is cut: two groups stay apart whose pairs "
                    "have a mean above it")
        ->check(within(0.0, kMost))
        ->excludes(count);
    groups.add_option("--matrix", command.matrix,
                      "dissimilarities from a CSV file, by names, instead of PM");
    add_table_hints(groups, command.written);
    groups.add_option("--out", command.out, "a table of all patterns with their groups, .csv");
    groups.add_option("--central", command.central,
                      "a set file for the most central pattern of each group, or its locked ones");
    groups.footer(
        "Patterns that nobody feels, and dropped ones, are no part of the tree. --json has the "
        "whole tree,\nits joins as SciPy's linkage numbers them.");
}

void add_separate_command(CLI::App& app, SeparateCommand& command, Chosen& chosen) {
    CLI::App& separate = add_command(
        app, "separate", "the smallest changes that part two patterns people may confuse", command,
        chosen);
    add_rendering(separate, command.common);
    add_only(separate, command.common);
    separate.add_option("--out", command.out, "file for the answer, instead of standard output");
    separate.add_option("--pair", command.pair, "names of the two, with a comma between")
        ->required();
    separate.add_option("--change", command.change,
                        "the one of them to change; default: either that is not locked");
    separate
        .add_option(
            "--among", command.among,
            "a pattern to keep away from, such as one of a subset; repeatable; default: all")
        ->allow_extra_args(false);
    CLI::Option* closest =
        separate
            .add_option(
                "--closest", command.percent,
                "%, default: 5. A change must bring the pattern farther from each other pattern "
                "than that share of all pairs are apart, and farther than this pair is now")
            ->check(within(0.0, 100.0));
    separate
        .add_option("--time-limit", command.time_limit_s,
                    "s for the search of changes, for each pattern that may be changed; "
                    "default: 120")
        ->check(within(0.0, kMost));
    separate.add_option("--threshold", command.threshold, "instead farther than this PM")
        ->check(within(0.0, kMost))
        ->excludes(closest);
}

void add_steps_command(CLI::App& app, StepsCommand& command, Chosen& chosen) {
    CLI::App& steps = add_command(
        app, "steps", "patterns between two, each as far from the next as all others are", command,
        chosen);
    steps.add_option("--from", command.from, "name of the pattern at one end")->required();
    steps.add_option("--to", command.to, "name of the pattern at the other end")->required();
    steps
        .add_option("-n,--count", command.count,
                    "number of patterns, both ends included; default: 5")
        ->check(within(2, static_cast<double>(kMostSteps)));
    steps.add_option("--parameter", command.parameter,
                     "only this number of --from changes, to what --to has: " + parameter_keys() +
                         "; default: all numbers in which the two differ");
    steps
        .add_option(
            "--metric", command.metric,
            "what is even: pm, the parts of PM as they are before they are ranked (ranks of "
            "neighbours cannot be equal), or one of the parts, nc or oc; default: pm")
        ->check(CLI::IsMember({"pm", "nc", "oc"}));
    steps.add_option("--out", command.out, "a set file for them")->required();
    steps.footer("Rhythms that differ are morphed: notes move, stretch, split and fade.");
}

void add_findings_command(CLI::App& app, FindingsCommand& command, Chosen& chosen) {
    CLI::App& findings =
        *app.add_subcommand("findings", "what the publication found, checked one by one");
    add_threads(findings, command.threads);
    findings.add_flag("--json", command.json, "JSON instead of text");
    CLI::Option& morse = *findings.add_flag(
        "--morse", command.morse,
        "instead: every metric against the ratings of 598 people, who heard 36 Morse signals "
        "(Rothkopf 1957)");
    findings
        .add_flag("--variants", command.variants,
                  "instead: what a cost of waiting in the OC part, or other thresholds, would "
                  "change of both")
        ->excludes(&morse);
    findings.add_option("--csv", command.csv, "file for the same as a table");
    findings.callback([&] { chosen = [&command] { return run(command); }; });
}

}  // namespace tact
