#include "model/planning/preregistration.h"

#include <cmath>

#include "model/text/numbers.h"

namespace tact {

namespace {

std::string word_of(RatingScaling scaling) {
    return kScalingNames[static_cast<std::size_t>(scaling)];
}

std::string word_of(StudyOrder order) {
    return order == StudyOrder::full ? "every pair as often, in random order" : "adaptive";
}

std::string words_on(int attention_pairs, const AttentionRule& rule) {
    if (attention_pairs == 0) return "no identical pairs";
    return counted(static_cast<std::size_t>(attention_pairs), "identical pair", "identical pairs") +
           ", each rated above " + significant_digits(rule.above, 6) + ", " +
           std::to_string(rule.failures_allowed) + " may be missed";
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

}  // namespace

std::vector<std::string> hypotheses_of(const Preregistration& plan) {
    return {"The dissimilarities that " + plan.metric +
                " predicts are in the order of people's mean ratings: Spearman's rho is above 0.",
            "The rho of " + plan.metric + " is above that of " + plan.rival + "."};
}

std::vector<std::string> tests_of(const Preregistration& plan) {
    return {"rho above 0: permutation of patterns (Mantel), one-sided, p < .05.",
            "rho of " + plan.metric + " less that of " + plan.rival +
                ": paired over the same draws of patterns and people at once, with the variance "
                "corrected by those of either alone, two-sided, p < .05. It is one test; where "
                "more metrics are compared, their p are corrected after Holm."};
}

std::vector<std::string> exclusion_rules_of(const Preregistration& plan) {
    std::vector<std::string> rules;
    if (plan.attention_pairs > 0) {
        rules.push_back("Who does not notice identical pairs does not count: " +
                        words_on(plan.attention_pairs, plan.attention) + ".");
    }
    rules.emplace_back("Who does not come to the end does not count.");
    rules.emplace_back("Nobody is left out by hand for what they answered.");
    return rules;
}

std::vector<PlannedAndDone> planned_and_done(const Preregistration& plan, const DoneStudy& study) {
    std::vector<PlannedAndDone> all;
    const auto add = [&all](const std::string& what, const std::string& planned,
                            const std::string& done) {
        all.push_back({what, planned, done, planned == done});
    };
    add("patterns", listed(plan.patterns), listed(study.patterns));
    add("what is felt, fingerprint", plan.set_fingerprint, study.set_fingerprint);
    add("model, fingerprint", plan.model_fingerprint, study.model_fingerprint);
    add("people who count", std::to_string(plan.people), std::to_string(study.people));
    add("repetitions", std::to_string(plan.repetitions), std::to_string(study.repetitions));
    add("attention", words_on(plan.attention_pairs, plan.attention),
        words_on(study.attention_pairs, study.attention));
    add("order of pairs", word_of(plan.order), word_of(study.order));
    add("scaling of each one's ratings", word_of(plan.scaling), word_of(study.scaling));
    add("left out by hand", "nobody",
        study.left_out_by_hand.empty() ? "nobody" : listed(study.left_out_by_hand));
    return all;
}

}  // namespace tact
