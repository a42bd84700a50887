#include "app/command_line/agreement/methods.h"

#include <cmath>

#include "model/text/numbers.h"

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

bool has_several(std::span<const SetAgreement> sets) {
    for (const SetAgreement& set : sets) {
        if (set.table.uncertainty.people > 0) return true;
    }
    return false;
}

constexpr const char* kReferences =
    "\nBorg, I. & Leutner, D. (1985). Measuring the similarity of MDS configurations. Multivariate "
    "Behavioral Research 20, 325-334."
    "\nEfron, B. (1979). Bootstrap methods: another look at the jackknife. Annals of Statistics 7, "
    "1-26."
    "\nJackson, D. A. (1995). PROTEST: a PROcrustean randomization TEST of community environment "
    "concordance. Ecoscience 2, 297-303."
    "\nHolm, S. (1979). A simple sequentially rejective multiple test procedure. Scandinavian "
    "Journal of Statistics 6, 65-70."
    "\nKendall, M. G. (1942). Partial rank correlation. Biometrika 32, 277-283."
    "\nKruskal, J. B. (1964). Multidimensional scaling by optimizing goodness of fit to a "
    "nonmetric "
    "hypothesis. Psychometrika 29, 1-27."
    "\nLim, C. & Park, G. (2023). Can a computer tell differences between vibrations?: "
    "Physiology-based computational model for perceptual dissimilarity prediction. CHI 2023."
    "\nMantel, N. (1967). The detection of disease clustering and a generalized regression "
    "approach. Cancer Research 27, 209-220."
    "\nNili, H. et al. (2014). A toolbox for representational similarity analysis. PLoS "
    "Computational Biology 10, e1003553."
    "\nTukey, J. W. (1958). Bias and confidence in not-quite large samples. Annals of Mathematical "
    "Statistics 29, 614.\n";

}  // namespace

std::string foot_of_table(const SetAgreement& set) {
    const std::string count = std::to_string(metric_count(set));
    return "rho: Spearman's; interval: bootstrap over patterns, percentiles of " +
           grouped_digits(kEvaluation.bootstrap_draws) + " draws, seed 2; p: Mantel, one-sided, " +
           orders_text(set.patterns, kEvaluation.rho_orders, 1) +
           "\nK: alienation of the distances of two maps of " +
           std::to_string(kEvaluation.dimensions) +
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
        (set.patterns <= kExactPatterns
             ? std::string("all ways to draw them")
             : draws_text() + ", " + seed_text(kUncertainty.pattern_seed)) +
        ", maps not made again";
    const std::size_t people = set.table.uncertainty.people;
    if (people == 0) return text + "; no interval over people: it takes two or more\n";
    return text + ";\nother people, as many: jackknife of " + std::to_string(people) +
           ", Student's t of " + std::to_string(people - 1) +
           "; both: bootstrap of both at once (of K " + std::to_string(kUncertainty.map_draws) +
           " draws, each with a map of its people), " + seed_text(kUncertainty.people_seed) +
           ", wide rather than narrow\n";
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
           "partial rank correlation (Kendall 1942); interval: bootstrap over patterns, "
           "percentiles of " +
           grouped_digits(kEvaluation.bootstrap_draws) + " draws, seed 2\n";
}

std::string foot_of_paper_table() {
    return "rho: Spearman's, with mid-ranks of values that are equal within 1e-9 of the largest; "
           "K: alienation of the distances of two maps of " +
           std::to_string(kEvaluation.dimensions) +
           " dimensions, as Borg & Leutner 1985 have it (the publication gives no formula), each "
           "map "
           "by the publication's procedure: one descent from Torgerson's start, stopped at 1e-4 or "
           "after 200 steps, as mdscale does; nothing is drawn, and no test is shown\n";
}

std::string methods_text(std::span<const SetAgreement> sets) {
    const std::size_t patterns = sets.front().patterns;
    std::string text =
        "\nMethods\nAgreement of a metric with mean dissimilarity ratings is Spearman's rank "
        "correlation over the rated pairs, with mid-ranks, where values within 1e-9 of the largest "
        "count as equal, as \"predict\" writes them; it is tested one-sided by permutation of "
        "patterns (Mantel, "
        "1967; " +
        orders_text(patterns, kEvaluation.rho_orders, 1) + "). Maps of " +
        std::to_string(kEvaluation.dimensions) +
        " dimensions come from non-metric multidimensional scaling (Kruskal, 1964; stress-1, "
        "primary ties); two maps are compared by the alienation coefficient K of their distances "
        "(Borg & Leutner, 1985), with a one-sided permutation test, and by Procrustes rotation "
        "with "
        "PROTEST (Jackson, 1995; " +
        orders_text(patterns, kEvaluation.k_orders, 6) +
        "). Intervals of 95 % over patterns are bootstrap intervals (Efron, 1979; " + draws_text() +
        "). ";
    if (has_several(sets)) {
        text +=
            "Those over people come from the jackknife (Tukey, 1958) with Student's t, as a "
            "bootstrap of people weighs their noise twice; those over both from a bootstrap of "
            "patterns and people at once. Reliability is the mean of Spearman's rho between "
            "halves of the participants, stepped up by the Spearman-Brown formula; its square "
            "root bounds any correlation with the mean ratings, and correlations with single "
            "participants are bounded as Nili et al. (2014) have it. ";
    }
    text +=
        "Differences between metrics are paired, over the same draws, two-sided, and corrected "
        "after Holm (1979). ";
    std::string names;
    for (const Given& one : sets.front().table.given) {
        names += (names.empty() ? "" : ", and given ") + one.name;
    }
    if (!names.empty()) {
        text += "Partial rank correlations (Kendall, 1942) are given " + names + ". ";
    }
    return text + "Computed by tactspace (Lim & Park, 2023, reimplemented).\n\nReferences" +
           kReferences;
}

}  // namespace tact
