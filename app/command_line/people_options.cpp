// People: comparing with what they said, asking them, and fitting the model to them.
#include "app/command_line/options.h"

#include "model/evaluation/individuals.h"
#include "model/pattern/pattern_parameter.h"
#include "model/study/study_numbers.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

// "19.8 % pass 1, 0.78 % pass 3".
std::string blind_passes() {
    std::string text;
    for (const int pairs : {1, kAttentionPairs}) {
        text += (text.empty() ? "" : ", ") +
                significant_digits(100.0 * chance_to_pass(pairs, {}), 2) + " % pass " +
                std::to_string(pairs);
    }
    return text;
}

void add_study_design(CLI::App& study, StudyCommand& command) {
    CLI::App& design = *study.add_option_group("Design", "in place of the design in the set");
    design.add_option("--seed", command.seed, "of orders, sides and simulated answers")
        ->check(within(numbers::kStudySeed.range));
    design.add_option("--repetitions", command.repetitions, "of every pair; the publication: 4")
        ->check(within(numbers::kRepetitions.range));
    design
        .add_option("--attention", command.attention_pairs,
                    "pairs of identical patterns, each of another; of those who answer blindly " +
                        blind_passes() + " (binomial, exact; above 80, none missed)")
        ->check(within(numbers::kAttentionPairs.range));
    design.add_flag("--adaptive", command.adaptive,
                    "pairs in an order that settles the map early; not the publication's design");
    design.add_flag("--sorting", command.sorting,
                    "patterns sorted into groups, not rated by pairs");
}

// What is to be done: one task, or collecting with a report.
void add_study_tasks(CLI::App& study, StudyCommand& command) {
    CLI::App& task = *study.add_option_group("Task");
    CLI::Option* simulate =
        task.add_option("--simulate", command.simulate,
                        "writes this many synthetic participants into --out DIR")
            ->check(within(1, 1000));
    task.add_option("--collect", command.collect,
                    "a folder of participants' files: who counts, how far they agree, their mean "
                    "matrix; default for --report: the folder beside the set, \"NAME study\"")
        ->excludes(simulate);
    task.add_option("--report", command.report,
                    "folder for all of a study: participants, answers, reliability, metrics and "
                    "maps as CSV, a page, scripts in R and Python that compute its numbers again")
        ->excludes(simulate);
    CLI::Option* pack =
        task.add_option("--pack", command.pack,
                        "writes the study into --out DIR for another program to ask: stimuli, "
                        "trials and a script, jspsych or psychopy")
            ->check(CLI::IsMember({"jspsych", "psychopy"}))
            ->excludes("--report", "--collect", "--simulate");
    task.add_option("--unpack", command.unpack,
                    "turns answers of a packed study, files or folders of .csv, into participants "
                    "in --out DIR")
        ->excludes(pack)
        ->excludes("--report", "--collect", "--simulate");
    study
        .add_option("--participants", command.participants,
                    "that a pack has trials for; default: 40")
        ->check(within(1, 1000))
        ->needs(pack);
    task.require_option(1, 2);
}

void add_simulated_participants(CLI::App& study, StudyCommand& command) {
    CLI::App& crowd = *study.add_option_group("Simulated", "participants made up by the model");
    crowd.add_option("--noise", command.noise, "standard deviation of a rating, points of 100")
        ->check(within(0.0, 100.0));
    crowd.add_option("--bias", command.bias, "points added to every similarity")
        ->check(within(-100.0, 100.0));
    crowd.add_option("--lapses", command.lapses, "share of trials that each answers blindly")
        ->check(within(0.0, 1.0));
    crowd
        .add_option("--inattentive", command.inattentive,
                    "share of participants who answer blindly throughout")
        ->check(within(0.0, 1.0));
    auto* map = crowd.add_option("--from-map", command.from_map,
                                 "coordinates that they feel by, as of tactspace space");
    crowd.add_option("--from-matrix", command.from_matrix, "dissimilarities that they feel by")
        ->excludes(map);
    add_table_hints(crowd, command.written);
}

void add_collected_answers(CLI::App& study, StudyCommand& command) {
    CLI::App& rule = *study.add_option_group("Collected", "who counts, and what is written");
    rule.add_option("--above", command.attention_above,
                    "similarity that identical patterns must exceed; the publication: 80")
        ->check(within(0.0, 100.0));
    rule.add_option("--failures", command.failures_allowed, "identical pairs that may be missed")
        ->check(within(0, 100));
    rule.add_flag("--unfinished", command.unfinished, "count who did not come to the end, too");
    add_who_counts(rule, command.who);
    rule.add_flag("--everyone", command.everyone, "write excluded participants as well, marked");
    rule.add_option("--scaling", command.scaling, "of each participant: none, min-max or standard")
        ->check(CLI::IsMember({"none", "min-max", "standard"}));
    rule.add_option("--weights", command.weights,
                    "how much each participant uses every dimension of a common map of this many "
                    "(INDSCAL); in --report 3")
        ->check(within(1, kMostWeightedDimensions));
    rule.add_option("--matrix", command.matrix, "file for the mean matrix, .csv");
    rule.add_option("--psych-ds", command.psych_ds,
                    "folder for a Psych-DS dataset, as archives of psychology read it: answers and "
                    "participants with every column described, and the set");
    rule.add_option("--rdms", command.rdms,
                    "file for the matrix of each person as NumPy arrays, .npz, as rsatoolbox takes "
                    "them");
}

}  // namespace

void add_compare_command(CLI::App& app, CompareCommand& options, Chosen& chosen) {
    CLI::App& compare = add_command(
        app, "compare", "how well metrics agree with people: rho and K of each", options, chosen);
    add_rendering(compare, options.common);
    add_exporting(compare, options.common);
    add_ratings(compare, options.ratings);
    compare.add_option("--metric", options.metrics, "only these of those below")
        ->check(fault_of_metric);
    compare.add_option(
        "--metric-from", options.metrics_from,
        "also a metric of your own: a file with a matrix, or FILE.py:FUNCTION, which "
        "gets two arrays of samples in g and the rate in Hz, and returns a number "
        "of 0 or more");
    add_only(compare, options.common);
    compare.add_option("--dim", options.dimensions, "of the maps: 2 or 3")->check(within(2, 3));
    compare.add_option("--out", options.out, "file for the answer, instead of standard output");
    compare.footer(list_of_metrics());
    compare.add_option("--given", options.given,
                       "partial rho given a nuisance: duration, level, or a file with a matrix");
    compare.add_option("--csv", options.csv, "file for a table with a row a metric");
    compare.add_option("--people-csv", options.people_csv,
                       "file for a table with a row a participant and metric");
    compare.add_option("--differences-csv", options.differences_csv,
                       "file for a table of the differences between pm and each metric");
    CLI::Option* methods = compare.add_flag("--methods", options.methods,
                                            "also a paragraph for a paper on how, with references");
    methods->excludes("--json");
    compare.add_flag("--paper-mode", options.paper_mode,
                     "digits and averages as in Table 2 of Lim & Park 2023");
}

void add_paper_command(CLI::App& app, PaperCommand& command, Chosen& chosen) {
    CLI::App& paper = add_command(
        app, "paper",
        "the publication's Table 2 and its figures, of your sets and ratings: a page, pictures, "
        "tables and scripts",
        command, chosen);
    add_ratings(paper, command.ratings);
    paper.add_option("--metric-from", command.metrics_from,
                     "also a metric of your own, as for compare");
    std::vector<std::string> parameters;
    for (const PatternParameter parameter : kPatternParameters) {
        parameters.emplace_back(traits(parameter).key);
    }
    paper
        .add_option("--along", command.along,
                    "the number along which patterns are joined in the maps; default: the one that "
                    "joins most")
        ->check(CLI::IsMember(parameters));
    paper.add_option("--out", command.out, "folder that is empty or not there")->required();
}

void add_plan_command(CLI::App& app, PlanCommand& command, Chosen& chosen) {
    CLI::App& plan = add_command(
        app, "plan",
        "a study before it is run: how many people, which patterns, and a preregistration", command,
        chosen);
    plan.add_option("--people", command.people,
                    "numbers of people to try, A..B or 8,12,20; default: 5..40");
    plan.add_option("--pairs", command.pairs,
                    "that each person rates, dealt so that all are rated as often: all, or a "
                    "number; default: all");
    plan.add_option("--rival", command.rival, "the metric that pm is to be told from; default: msm")
        ->check(fault_of_metric);
    CLI::App& assumed = *plan.add_option_group("Assumed", "of people who were not asked yet");
    CLI::Option* pilot = assumed.add_option(
        "--pilot", command.pilot.files,
        "ratings of a few people, as for compare: how alike they rate and how far pm agrees");
    assumed.add_option("--scale", command.pilot.scale, "of the pilot's ratings; default: guess")
        ->check(CLI::IsMember({"guess", "similarity", "dissimilarity"}));
    assumed.add_option("--columns", command.pilot.columns, kAnswerColumnsHelp);
    assumed
        .add_option("--rho", command.rho,
                    "of pm with what people feel on average, without noise; default: 0.67, the "
                    "publication's mean, a guess for any other set")
        ->check(within(0.0, 1.0));
    assumed
        .add_option("--reliability", command.reliability,
                    "of one person's ratings, the share that is not their own noise; default: "
                    "0.4, a guess")
        ->check(within(0.01, 1.0))
        ->excludes(pilot);
    plan.add_option("--studies", command.studies,
                    "simulated for each number of people; default: 200")
        ->check(within(20, 10'000));
    plan.add_option("--seed", command.seed, "of the simulation; default: 12")
        ->check(within(limits::kStudySeed));
    plan.add_option("--decide", command.decide,
                    "plan with this many patterns of the set only: those on which pm and the rival "
                    "disagree most, so that their ratings can decide")
        ->check(within(3, static_cast<double>(limits::kMaxStudyPatterns)));
    plan.add_option("--out", command.out, "file for the set of the patterns that are planned with");
    plan.add_option("--csv", command.csv, "file for the table, a row a number of people");
    plan.add_option("--preregister", command.preregister,
                    "folder for a preregistration, which needs one number of --people: a page, and "
                    "a file that \"study --report DIR --planned FILE\" holds the study against");
    plan.footer(list_of_metrics());
}

void add_study_command(CLI::App& app, StudyCommand& command, Chosen& chosen) {
    CLI::App& study = add_command(
        app, "study", "a rating study: simulate participants, or collect what they said", command,
        chosen);
    add_study_tasks(study, command);
    study.add_option("--planned", command.planned,
                     "the preregistration.json of \"plan --preregister\": the report marks what "
                     "departs from it");
    study.get_option("--simulate")
        ->needs(study.add_option("--out", command.out,
                                 "folder for simulated participants; file for collected ratings, "
                                 ".csv"));
    add_study_design(study, command);
    add_simulated_participants(study, command);
    add_collected_answers(study, command);
}

void add_train_command(CLI::App& app, TrainCommand& command, Chosen& chosen) {
    CLI::App& train = add_command(
        app, "train", "the parameters of the model that agree best with ratings", command, chosen);
    add_rendering(train, command.common);
    add_only(train, command.common);
    add_ratings(train, command.ratings);
    train
        .add_option("--objective", command.objective,
                    "mean over the sets of Spearman's rho, or of its size: mean-rho, mean-abs-rho")
        ->check(CLI::IsMember({"mean-rho", "mean-abs-rho"}));
    train.add_option("--step", command.step, "of the weights from 0 to 1; 0.1 as published")
        ->check(within(0.0, 1.0))
        ->check(fault_of_step);
    train
        .add_option("--leave-out", command.leave_out,
                    "fit without each of them and try on it: sets, participants (who felt the same "
                    "vibrations) or patterns")
        ->check(CLI::IsMember({"sets", "participants", "patterns"}));
    train.add_option("--csv", command.csv,
                     "file for a table of the fits: of all, and without what was left out");
    train.add_option("--out", command.out,
                     "file for the parameters, for --model of other commands and the model bench");
}

}  // namespace tact
