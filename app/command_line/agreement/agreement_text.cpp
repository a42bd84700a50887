#include "app/command_line/agreement/agreement.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/command_line/output.h"
#include "app/command_line/people/people.h"
#include "app/command_line/rated_sets.h"
#include "model/evaluation/said_once.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"

namespace tact {

namespace {

std::string interval_text(const Interval& interval, int digits) {
    return range_text(interval.low, interval.high, digits);
}

std::string voices_text(const Reliability& people) {
    if (people.voices < 2) return {};
    return (people.is_of_one_person ? ", one participant, " : ", ") +
           std::to_string(people.voices) +
           (people.is_of_one_person ? " repetitions" : " participants");
}

// What is the same for all metrics of the set.
std::string head_of(const SetAgreement& set) {
    const PerceptualSpace& space = rated_of(set).people.space;
    const AlienationChance& chance = rated_of(set).k_chance;
    std::string text = shown_text(set.name) + ": " + std::to_string(set.patterns) + " patterns, " +
                       std::to_string(set.people.rated_pairs) + " of " +
                       std::to_string(pair_count(set.patterns)) + " pairs rated" +
                       voices_text(set.people.reliability) + "\n" +
                       ceilings_text(set.people.ceilings) + text_of(set.raters);
    text += "their map     stress-1 " + fixed_digits(space.stress1, 3) + ", " + fit_label(space) +
            "; of random ratings " + fixed_digits(rated_of(set).random_stress.mean, 3);
    text += "\nchance        unrelated maps have K " + fixed_digits(chance.mean, 3) +
            ", nine in ten " + interval_text(chance.middle, 3) + "\n";
    const std::string unrated =
        remark_on_unrated(set.people.unrated, set.patterns + set.people.unrated.size());
    if (!unrated.empty()) text += shown_text(unrated) + "\n";
    const std::string collapsed = remark_on_people_map(rated_of(set));
    if (!collapsed.empty()) text += collapsed + "\n";
    return text + text_of(set.labels) + text_on(set.left_out);
}

std::string table_of(const SetAgreement& set) {
    std::vector<TextRow> rows{{"metric", "rho", "95 % interval", "p", "tau-b", "K", "K spread",
                               "K p", "1-K/chance", "K Procrustes", "PROTEST p", "stress-1"}};
    for (std::size_t m = 0; m < metric_count(set); ++m) {
        const Evaluation& e = set.table.evaluations[m];
        rows.push_back({key_of(set, m), fixed_digits(e.rho, 3), interval_text(e.rho_interval, 2),
                        fixed_digits(e.rho_p, 4), fixed_digits(e.tau_b, 3), fixed_digits(e.k, 3),
                        interval_text(e.k_spread, 2), fixed_digits(e.k_p, 4),
                        fixed_digits(e.k_corrected, 2), fixed_digits(e.k_procrustes, 3),
                        fixed_digits(e.protest_p, 4), fixed_digits(e.stress1, 3)});
    }
    if (!std::isnan(set.people.ceilings.of_mean)) {
        TextRow ceiling(rows.front().size(), "");
        ceiling[0] = "(ceiling)";
        ceiling[1] = fixed_digits(set.people.ceilings.of_mean, 3);
        rows.push_back(ceiling);
    }
    return aligned(rows);
}

// As printed in Table 2: two digits, "-" for what is undefined.
std::string paper_table_of(const SetAgreement& set) {
    std::vector<TextRow> rows{{"metric", "rho", "K"}};
    for (std::size_t m = 0; m < metric_count(set); ++m) {
        const Agreement agreement = agreement_of(set.table.evaluations[m], Bookkeeping::paper);
        rows.push_back(
            {key_of(set, m), fixed_digits(agreement.rho, 2), fixed_digits(agreement.k, 2)});
    }
    return aligned(rows);
}

// What a "-" of Table 2's layout stands for, where no other remark tells.
std::string paper_remarks(const SetAgreement& set) {
    std::string text;
    for (std::size_t m = 0; m < metric_count(set); ++m) {
        const Evaluation& e = set.table.evaluations[m];
        if (!e.is_failed_start) continue;
        text += std::string(key_of(set, m)) +
                ": no K, as the publication's mdscale gives up where two patterns begin on one "
                "spot";
        if (!std::isnan(e.k)) text += "; from other starts K is " + fixed_digits(e.k, 3);
        text += "\n";
    }
    return text;
}

// If it is too small to show, says so.
std::string p_text(double p) { return p < 0.00005 ? "<0.0001" : fixed_digits(p, 4); }

TextRow resampled_head(const std::string& first, const std::string& quantity, bool has_people) {
    TextRow head{first, quantity, "over patterns"};
    if (has_people) head.insert(head.end(), {"over people", "over both"});
    return head;
}

void add_resampled(TextRow& row, const Uncertain& value, bool has_people) {
    row.push_back(fixed_digits(value.value, 3));
    for (std::size_t r = 0; r < (has_people ? kResampledCount : 1); ++r) {
        row.push_back(interval_text(value.interval[r], 2));
    }
}

// The reasons for "-", each once with all metrics that it holds for. What is undefined itself has
// remarks of its own.
struct NotKnownWords {
    bool has_people = false;
    SaidOnce reasons;

    void add(const std::string& quantity, const std::string& metric, const Uncertain& value) {
        for (std::size_t r = 0; r < (has_people ? kResampledCount : 1); ++r) {
            if (value.why[r] == NotKnown::known || value.why[r] == NotKnown::no_value) continue;
            reasons.add(
                quantity + " over " + kResampledNames[r] + " not known: " + words(value.why[r]),
                metric);
        }
    }
    std::string text() const {
        std::string all;
        for (const auto& [which, metrics] : reasons.said) all += which + " (" + metrics + ")\n";
        return all;
    }
};

std::string uncertainty_text(const SetAgreement& set) {
    const Uncertainty& all = set.table.uncertainty;
    const bool has_people = all.people > 0;
    TextRow head = resampled_head("95 % intervals", "rho", has_people);
    const TextRow of_k = resampled_head("K", "", has_people);
    head.push_back("K");
    head.insert(head.end(), of_k.begin() + 2, of_k.end());
    std::vector<TextRow> rows{head};
    for (std::size_t m = 0; m < metric_count(set); ++m) {
        TextRow row{key_of(set, m)};
        add_resampled(row, all.rho[m], has_people);
        add_resampled(row, all.k[m], has_people);
        rows.push_back(row);
    }
    NotKnownWords not_known{has_people, {}};
    for (std::size_t m = 0; m < metric_count(set); ++m) {
        not_known.add("rho", key_of(set, m), all.rho[m]);
        not_known.add("K", key_of(set, m), all.k[m]);
    }
    return "\n" + aligned(rows) + not_known.text() + foot_of_uncertainty(set);
}

std::string differences_text(const SetAgreement& set) {
    const Uncertainty& all = set.table.uncertainty;
    if (all.differences.empty()) return {};
    const bool has_people = all.people > 0;
    TextRow head{"rho of pm less", "difference"};
    for (std::size_t r = 0; r < (has_people ? kResampledCount : 1); ++r) {
        head.insert(head.end(), {std::string("over ") + kResampledNames[r], "p", "Holm"});
    }
    std::vector<TextRow> rows{head};
    for (const MetricDifference& one : all.differences) {
        TextRow row{key_of(set, one.metric), fixed_digits(one.rho.value, 3)};
        for (std::size_t r = 0; r < (has_people ? kResampledCount : 1); ++r) {
            row.insert(row.end(), {interval_text(one.rho.interval[r], 2), p_text(one.p[r]),
                                   p_text(one.p_holm[r])});
        }
        rows.push_back(row);
    }
    NotKnownWords not_known{has_people, {}};
    for (const MetricDifference& one : all.differences) {
        not_known.add("difference", key_of(set, one.metric), one.rho);
    }
    return "\n" + aligned(rows) + not_known.text() + foot_of_differences(set);
}

TextRow spread_row(const std::string& name, const Spread& rho) {
    return {name, fixed_digits(rho.median, 3), range_text(rho.low, rho.high, 2),
            fixed_digits(rho.mean, 3)};
}

std::string people_table_text(const SetAgreement& set) {
    const Individuals& all = set.table.individuals;
    if (all.people.empty()) return {};
    std::vector<TextRow> rows{
        {"with one person", "median rho", "quartiles", "mean", "median K", "quartiles", "mean"}};
    for (std::size_t m = 0; m < metric_count(set); ++m) {
        TextRow row = spread_row(key_of(set, m), all.rho[m]);
        const TextRow k = spread_row("", all.k[m]);
        row.insert(row.end(), k.begin() + 1, k.end());
        rows.push_back(row);
    }
    const Ceilings& bounds = set.people.ceilings;
    for (const auto& [name, of] : {std::pair{"(the others)", &bounds.with_others},
                                   std::pair{"(all, self too)", &bounds.with_all}}) {
        TextRow row = spread_row(name, *of);
        row.insert(row.end(), 3, "");
        rows.push_back(row);
    }
    return "\n" + aligned(rows) + foot_of_people(set);
}

std::string given_text(const SetAgreement& set) {
    if (set.table.given.empty()) return {};
    TextRow head{"partial rho"};
    TextRow alone{"(that alone)"};
    for (const Given& one : set.table.given) {
        head.insert(head.end(), {"given " + one.name, "95 % interval"});
        alone.insert(alone.end(), {fixed_digits(one.rho_alone, 3), ""});
    }
    std::vector<TextRow> rows{head};
    for (std::size_t m = 0; m < metric_count(set); ++m) {
        TextRow row{key_of(set, m)};
        for (const Given& one : set.table.given) {
            row.push_back(fixed_digits(one.metrics[m].rho, 3));
            row.push_back(interval_text(one.metrics[m].interval, 2));
        }
        rows.push_back(row);
    }
    rows.push_back(alone);
    return "\n" + aligned(rows) + foot_of_given(set);
}

// Says so where PM is not better than something without physiology.
std::string verdict_on_pm(const SetAgreement& set) {
    std::vector<MetricRho> agreements;
    for (std::size_t m = 0; m < set.table.metrics.size(); ++m) {
        agreements.push_back({set.table.metrics[m], set.table.evaluations[m].rho});
    }
    const std::optional<Metric> best = unbeaten_by_pm(agreements);
    if (!best) return {};
    return std::string("pm does not beat ") + traits(*best).key +
           " on this set, which takes no model of the nerves\n";
}

// Where each metric of one's own is from, and whether PM is better.
std::string foreign_text(const SetAgreement& set) {
    const std::vector<Metric>& own = set.table.metrics;
    const std::vector<Evaluation>& all = set.table.evaluations;
    const auto pm = std::ranges::find(own, Metric::pm);
    std::string text;
    for (std::size_t k = 0; k < set.foreign.size(); ++k) {
        const bool is_unbeaten =
            pm != own.end() &&
            all[own.size() + k].rho >= all[static_cast<std::size_t>(pm - own.begin())].rho;
        text += set.foreign[k].key + ": from " + set.foreign[k].from + ", not of this program" +
                (is_unbeaten ? "; pm does not beat it on this set\n" : "\n");
    }
    return text;
}

std::string remarks_text(const SetAgreement& set, bool is_paper) {
    SaidOnce remarks;
    for (std::size_t m = 0; m < metric_count(set); ++m) {
        const Evaluation& e = set.table.evaluations[m];
        for (const std::string& remark : e.remarks) {
            const bool is_of_best_map =
                is_paper && !std::isnan(e.k_published) && remark.starts_with("no K");
            remarks.add(
                (is_of_best_map ? "K by the publication's procedure alone; by the best map " : "") +
                    remark,
                key_of(set, m));
        }
    }
    std::string text;
    for (const auto& [remark, of] : remarks.said) text += of + ": " + remark + "\n";
    const auto dimensions = static_cast<std::size_t>(rated_of(set).people.space.points.cols());
    if (set.patterns <= 2 * dimensions + 1) {
        text += "K and stress of so few patterns say little: any ratings fit in " +
                std::to_string(dimensions) + " dimensions\n";
    }
    return text + verdict_on_pm(set) + foreign_text(set);
}

}  // namespace

std::string ceilings_text(const Ceilings& ceilings) {
    if (ceilings.voices < 2) {
        return "people        no repetitions: how far a metric can agree is not known\n";
    }
    const auto bound = [](const Spread& spread) {
        return fixed_digits(spread.mean, 3) + " (median " + fixed_digits(spread.median, 3) + ")";
    };
    return "people        reliability of their mean " + fixed_digits(ceilings.reliability, 3) +
           " (split halves, Spearman-Brown)\nceiling       rho " +
           fixed_digits(ceilings.of_mean, 3) +
           " with their mean: the square root of its reliability\n" +
           (ceilings.is_of_one_person ? "one pass      " : "one person    ") +
           "the best there could be has a mean rho of " + bound(ceilings.with_others) + " to " +
           bound(ceilings.with_all) +
           ":\n              of each with the mean of the others, and with that of all, oneself "
           "included\n";
}

std::string agreement_text(const SetAgreement& set, bool is_paper) {
    const std::string head = head_of(set) + "\n";
    if (is_paper) {
        return head + paper_table_of(set) + foot_of_paper_table(set) + paper_remarks(set) +
               remarks_text(set, true);
    }
    return head + table_of(set) + foot_of_table(set) + remarks_text(set, false) +
           uncertainty_text(set) + differences_text(set) + given_text(set) + people_table_text(set);
}

MeanAgreement mean_of(std::span<const SetAgreement> sets, std::size_t metric, Bookkeeping books) {
    std::vector<Agreement> agreements;
    for (const SetAgreement& set : sets) {
        agreements.push_back(agreement_of(set.table.evaluations[metric], books));
    }
    return mean_agreement(agreements, books);
}

std::string means_text(std::span<const SetAgreement> sets, Bookkeeping books) {
    const bool is_paper = books == Bookkeeping::paper;
    std::string text = "\nmeans over " + std::to_string(sets.size()) + " sets";
    text += is_paper ? ", as in Table 2: of |rho|, undefined ones as 0, failed maps as K = 1\n"
                     : "; undefined ones are left out\n";
    std::vector<TextRow> rows;
    rows.push_back({"metric", is_paper ? "|rho|" : "rho", is_paper ? "signed rho" : "|rho|", "K",
                    "undefined rho", "failed maps"});
    for (std::size_t m = 0; m < metric_count(sets.front()); ++m) {
        const MeanAgreement mean = mean_of(sets, m, books);
        const std::string with_sign = fixed_digits(mean.signed_rho, 3);
        const std::string absolute = fixed_digits(mean.absolute_rho, 3);
        rows.push_back({key_of(sets.front(), m), is_paper ? absolute : with_sign,
                        is_paper ? with_sign : absolute, fixed_digits(mean.k, 3),
                        std::to_string(mean.undefined_rho), std::to_string(mean.failed_maps)});
    }
    return text + aligned(rows);
}

}  // namespace tact
