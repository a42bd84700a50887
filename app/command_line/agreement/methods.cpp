#include "app/command_line/agreement/agreement.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <span>
#include <utility>

#include "app/command_line/output.h"
#include "app/command_line/rated_sets.h"
#include "app/foreign/foreign.h"
#include "app/session/program_version.h"
#include "model/tasks/set_agreement.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utc_time.h"

namespace tact {

namespace {

const EvaluationParams kEvaluation;
const UncertaintyParams kUncertainty;

std::string seed_text(std::uint64_t seed) { return "seed " + std::to_string(seed); }

// Permutations: all orders of up to seven objects.
std::string orders_text(std::size_t patterns, std::size_t drawn, std::uint64_t seed) {
    if (patterns <= 7) return "all orders of the patterns";
    return grouped_digits(drawn) + " orders of the patterns, " + seed_text(seed);
}

std::string draws_text() { return grouped_digits(kUncertainty.draws) + " draws"; }

// How many dimensions the maps have.
std::string dimensions_of(const SetAgreement& set) {
    return std::to_string(rated_of(set).people.space.points.cols());
}

bool has_several(std::span<const SetAgreement> sets) {
    for (const SetAgreement& set : sets) {
        if (set.table.uncertainty.people > 0) return true;
    }
    return false;
}

// What a paragraph names and how the reference list has it, by author.
struct Reference {
    const char* named;
    const char* whole;
};
constexpr Reference kReferences[]{
    {"Borg & Leutner, 1985",
     "Borg, I. & Leutner, D. (1985). Measuring the similarity of MDS configurations. Multivariate "
     "Behavioral Research 20, 325-334."},
    {"Efron, 1979",
     "Efron, B. (1979). Bootstrap methods: another look at the jackknife. Annals of Statistics 7, "
     "1-26."},
    {"Holm (1979)",
     "Holm, S. (1979). A simple sequentially rejective multiple test procedure. Scandinavian "
     "Journal of Statistics 6, 65-70."},
    {"Jackson, 1995",
     "Jackson, D. A. (1995). PROTEST: a PROcrustean randomization TEST of community environment "
     "concordance. Ecoscience 2, 297-303."},
    {"Kendall, 1942", "Kendall, M. G. (1942). Partial rank correlation. Biometrika 32, 277-283."},
    {"Kruskal, 1964",
     "Kruskal, J. B. (1964). Multidimensional scaling by optimizing goodness of fit to a nonmetric "
     "hypothesis. Psychometrika 29, 1-27."},
    {"Lim & Park, 2023",
     "Lim, C. & Park, G. (2023). Can a computer tell differences between vibrations?: "
     "Physiology-based computational model for perceptual dissimilarity prediction. CHI 2023."},
    {"Mantel, 1967",
     "Mantel, N. (1967). The detection of disease clustering and a generalized regression "
     "approach. Cancer Research 27, 209-220."},
    {"Nili et al. (2014)",
     "Nili, H. et al. (2014). A toolbox for representational similarity analysis. PLoS "
     "Computational Biology 10, e1003553."},
    {"Schütt et al., 2023",
     "Schütt, H. H., Kipnis, A. D., Diedrichsen, J. & Kriegeskorte, N. (2023). Statistical "
     "inference on representational geometries. eLife 12, e82566."},
    {"Tukey, 1958",
     "Tukey, J. W. (1958). Bias and confidence in not-quite large samples. Annals of Mathematical "
     "Statistics 29, 614."}};

// The references that the paragraph names, a line each.
std::string references_of(const std::string& paragraph) {
    std::string text = "\n\nReferences";
    for (const Reference& one : kReferences) {
        if (paragraph.find(one.named) != std::string::npos) text += std::string("\n") + one.whole;
    }
    return text + "\n";
}

// How many took part in each set, who is left out and why.
std::string people_of(std::span<const SetAgreement> sets) {
    std::string text;
    for (const SetAgreement& set : sets) {
        if (set.people.participants == 0) continue;
        text += set.name + ": ratings of " +
                counted(set.people.participants, "participant", "participants");
        if (set.people.mark.synthetic) text += ", simulated";
        if (!set.left_out.empty()) {
            text += "; left out";
            for (const LeftOutParticipant& one : set.left_out) {
                text += (&one == &set.left_out.front() ? " " : ", ") + one.participant + " (" +
                        one.why + ")";
            }
        }
        text += ". ";
    }
    return text;
}

}  // namespace

std::string foot_of_table(const SetAgreement& set) {
    const std::string count = std::to_string(metric_count(set));
    return "rho: Spearman's; interval: that over patterns of the next table; p: Mantel, "
           "one-sided, " +
           orders_text(set.patterns, kEvaluation.rho_orders, 1) +
           "\nK: alienation of the distances of two maps of " + dimensions_of(set) +
           " dimensions, as Borg & Leutner 1985 have it (the publication gives no formula); its p "
           "and PROTEST's: one-sided, " +
           orders_text(set.patterns, kEvaluation.k_orders, 6) +
           "; spread: over maps that fit practically as well\n"
           "no p of this table is corrected for " +
           count + (metric_count(set) == 1 ? " metric\n" : " metrics\n");
}

std::string foot_of_uncertainty(const SetAgreement& set) {
    std::string text =
        "estimate and 1.96 standard errors, if other patterns had been taken: "
        "bootstrap over patterns, " +
        (set.patterns <= kExactObjects
             ? std::string("all ways to draw them")
             : draws_text() + ", " + seed_text(kUncertainty.pattern_seed)) +
        ", maps not made again";
    const std::size_t people = set.table.uncertainty.people;
    if (people == 0) return text + "; no interval over people: it takes two or more\n";
    return text + ";\nother people, as many: jackknife of " + std::to_string(people) +
           ", Student's t of " + std::to_string(people - 1) +
           "; both: bootstrap of both at once (of K " + std::to_string(kUncertainty.map_draws) +
           " draws, each with a map of its people), " + seed_text(kUncertainty.people_seed) +
           ", corrected by those of patterns and of people alone (Schütt et al. 2023), Student's t "
           "of " +
           std::to_string(std::min(people, set.patterns) - 1) + "\n";
}

std::string foot_of_differences(const SetAgreement& set) {
    return "the same draws for every metric (paired); intervals and p, two-sided, by standard "
           "errors as above; Holm: p corrected for " +
           std::to_string(set.table.uncertainty.differences.size()) + " differences\n";
}

std::string foot_of_people(const SetAgreement& set) {
    return "of " + std::to_string(set.table.individuals.people.size()) +
           " participants, each with their own mean and map; nothing is drawn; (the others), (all, "
           "self too): rho of each with the mean of the others, and of all, between which the best "
           "metric there could be lies (Nili et al. 2014); K: of those who rated every pair\n";
}

std::string foot_of_given(const SetAgreement& set) {
    std::string text;
    for (const Given& one : set.table.given) {
        if (!std::isnan(one.rho_alone)) continue;
        text += one.name + ": no partial rho, because it is the same for every rated pair\n";
    }
    return text +
           "partial rank correlation (Kendall 1942); interval: 1.96 standard errors over patterns, "
           "as of rho\n";
}

std::string foot_of_paper_table(const SetAgreement& set) {
    return "rho: Spearman's, with mid-ranks of values that are equal within 1e-9 of the largest; "
           "K: alienation of the distances of two maps of " +
           dimensions_of(set) +
           " dimensions, as Borg & Leutner 1985 have it (the publication gives no formula), each "
           "map "
           "by the publication's procedure: one descent from Torgerson's start, stopped at 1e-4 or "
           "after 200 steps, as mdscale does; nothing is drawn, and no test is shown\n";
}

std::string methods_text(std::span<const SetAgreement> sets) {
    const std::size_t patterns = sets.front().patterns;
    bool has_differences = false;
    for (const SetAgreement& set : sets) {
        has_differences = has_differences || !set.table.uncertainty.differences.empty();
    }
    std::string text =
        people_of(sets) +
        "Agreement of a metric with mean dissimilarity ratings is Spearman's rank "
        "correlation over the rated pairs, with mid-ranks, where values within 1e-9 of the largest "
        "count as equal, as \"predict\" writes them; it is tested one-sided by permutation of "
        "patterns (Mantel, 1967; " +
        orders_text(patterns, kEvaluation.rho_orders, 1) + "). Maps of " +
        dimensions_of(sets.front()) +
        " dimensions come from non-metric multidimensional scaling (Kruskal, 1964; stress-1, "
        "primary ties; where groups of patterns collapse in the map of least stress, the best map "
        "in which none do); two maps are compared by the alienation coefficient K of their "
        "distances (Borg & Leutner, 1985), with a one-sided permutation test, and by Procrustes "
        "rotation with PROTEST (Jackson, 1995; " +
        orders_text(patterns, kEvaluation.k_orders, 6) +
        "). Intervals of 95 % over patterns are 1.96 standard errors of a bootstrap (Efron, "
        "1979; " +
        draws_text() + ", " + seed_text(kUncertainty.pattern_seed) + "). ";
    if (has_several(sets)) {
        text +=
            "Those over people come from the jackknife (Tukey, 1958) with Student's t, as a "
            "bootstrap of people weighs their noise twice; those over both from a bootstrap of "
            "patterns and people at once (" +
            seed_text(kUncertainty.people_seed) +
            "), whose variance is corrected by those of either alone (Schütt et al., 2023), with "
            "Student's t of the fewer of the two less one. "
            "Reliability is the mean of Spearman's rho between halves of the participants, stepped "
            "up by the Spearman-Brown formula; its square root is the correlation with the mean "
            "ratings that a perfect metric is expected to have, and correlations with single "
            "participants are bounded as Nili et al. (2014) have it. ";
    }
    if (has_differences) {
        text +=
            "Differences between metrics are paired, over the same draws, two-sided, and corrected "
            "after Holm (1979). ";
    }
    std::string names;
    for (const Given& one : sets.front().table.given) {
        names += (names.empty() ? "" : ", and given ") + one.name;
    }
    if (!names.empty()) {
        text += "Partial rank correlations (Kendall, 1942) are given " + names + ". ";
    }
    text += std::string("Computed by ") + kProgramVersion +
            " (Lim & Park, 2023, reimplemented) on " + utc_today() + ".";
    return "\nMethods\n" + text + references_of(text);
}

namespace {

void tell_remark(const std::string& remark) {
    std::cerr << "tactspace: " << shown_text(remark) << "\n";
}

// Those asked for, or all.
Expected<std::vector<Metric>> metrics_of(const CompareCommand& command) {
    if (command.metrics.empty()) return std::vector<Metric>(kMetrics.begin(), kMetrics.end());
    std::vector<Metric> metrics;
    for (const std::string& key : command.metrics) {
        const Expected<Metric> metric = metric_named(key);
        if (!metric) return metric.error();
        metrics.push_back(*metric);
    }
    return metrics;
}

// "duration", "level", or a matrix in a file by the names of the set.
Expected<std::vector<Nuisance>> nuisances_of(const CompareCommand& command, const PatternSet& set) {
    std::vector<Nuisance> nuisances;
    for (const std::string& given : command.given) {
        if (auto named = nuisance_named(given, set)) {
            nuisances.push_back({given, *std::move(named)});
            continue;
        }
        Expected<Dissimilarity> read =
            dissimilarities_in(given, names_of(set), command.ratings.written);
        if (!read) return read.error();
        nuisances.push_back({std::filesystem::path(given).stem().string(), *std::move(read)});
    }
    return nuisances;
}

Expected<SetAgreement> agreement_of(const CompareCommand& command, std::span<const Metric> metrics,
                                    const RatedPatterns& patterns) {
    const Expected<std::vector<Nuisance>> nuisances = nuisances_of(command, patterns.set);
    if (!nuisances) return nuisances.error();
    // Before all that takes long: what is wrong with them is told at once.
    std::vector<ForeignMetric> foreign;
    std::vector<Dissimilarity> theirs;
    for (const std::string& from : command.metrics_from) {
        Expected<Dissimilarity> matrix = foreign_matrix(
            from, patterns.set, {.written = command.ratings.written, .remark = tell_remark});
        if (!matrix) return matrix.error();
        theirs.push_back(*std::move(matrix));
        foreign.push_back(foreign_metric(from));
    }
    EvaluationParams params;
    params.threads = command.common.threads;
    params.dimensions = command.dimensions;
    MetricOptions options;
    options.threads = command.common.threads;
    options.progress = progress_line("comparing metrics");
    auto matrices = *compared_matrices(patterns.set, metrics, nullptr, options);
    std::ranges::move(theirs, std::back_inserter(matrices));
    AgreementRequest request{{metrics.begin(), metrics.end()}, std::move(matrices), *nuisances};
    request.params = params;
    request.progress = progress_line("resampling");
    PeopleAgreement all = *people_agreement(patterns.study, std::move(request));
    if (!all.fault.empty()) return Error{patterns.name + ": " + all.fault};
    const std::size_t rated = patterns.set.vibrations.size() - all.people.unrated.size();
    return SetAgreement{patterns.name,         rated,
                        std::move(all.people), patterns.left_out,
                        patterns.labels,       std::move(all.table),
                        std::move(all.raters), std::move(foreign)};
}

}  // namespace

Expected<std::vector<ComparedSet>> compared_sets(const CompareCommand& command) {
    const Expected<std::vector<Metric>> metrics = metrics_of(command);
    if (!metrics) return metrics.error();
    Expected<std::vector<RatedPatterns>> all = load_rated(command.common, command.ratings);
    if (!all) return all.error();
    std::vector<ComparedSet> sets;
    for (RatedPatterns& patterns : *all) {
        Expected<SetAgreement> agreement = agreement_of(command, *metrics, patterns);
        if (!agreement) return agreement.error();
        sets.push_back({std::move(patterns.set), *std::move(agreement)});
    }
    return sets;
}

}  // namespace tact
