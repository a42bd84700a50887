#include <algorithm>
#include <cmath>
#include <limits>

#include "model/ask/steps.h"
#include "model/morph/morph.h"
#include "model/text/numbers.h"

namespace tact {

namespace {}  // namespace

double unevenness(const std::vector<double>& values) {
    if (values.empty()) return 0.0;
    const auto [least, most] = std::ranges::minmax_element(values);
    if (*least > 0.0) return *most / *least - 1.0;
    return *most > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

bool is_even(const EvenSteps& steps) { return steps.uneven <= kEvenWithin; }

std::string sentence_on(const StepsQuestion& question, const EvenSteps& steps) {
    const char* measure = question.measure == StepMeasure::nc   ? "NC"
                          : question.measure == StepMeasure::oc ? "OC"
                                                                : "continuous PM";
    const std::string in = std::string(" in ") + measure;
    if (!(steps.ends_apart > 0.0)) {
        return "The two do not differ" + in + ": every step between them is the same.";
    }
    if (is_even(steps)) {
        return "Neighbours are equally far" + in + ", within " + percent(steps.uneven) + ".";
    }
    std::string text =
        "There are no " + std::to_string(steps.patterns.size()) + " even steps" + in +
        ": neighbours differ by " +
        (std::isfinite(steps.uneven) ? percent(steps.uneven) : std::string("any factor")) +
        " at best.";
    if (!steps.jump) return text;
    const std::string far = percent(steps.jump->distance / steps.ends_apart);
    const double smallest = *std::ranges::min_element(steps.apart);
    if (steps.jump->distance >= 0.5 * smallest) {
        text += " At " + percent(steps.jump->share) + " of the way the path jumps by " + far +
                " of the distance of the two.";
    } else {
        text += " The path nowhere jumps by more than " + far + " of the distance of the two, at " +
                percent(steps.jump->share) +
                " of the way: it turns, so that neighbours lie no more evenly.";
    }
    for (const std::string& what : morph_jumps(question.from, question.to)) {
        text += " At half of the way " + what + " changes at once.";
    }
    return text;
}

std::string pm_sentence_on(const EvenSteps& steps) {
    const auto [least, most] = std::ranges::minmax_element(steps.pm);
    return "PM of neighbours, in the set of these patterns: " + significant_digits(*least, 3) +
           " to " + significant_digits(*most, 3) + ", of at most " +
           significant_digits(steps.largest_pm, 3) +
           ". PM counts ranks, so neighbours cannot be equal in it.";
}

std::optional<Pattern> end_along(const Pattern& from, const Pattern& to,
                                 PatternParameter parameter) {
    const auto value = value_of(to, parameter);
    if (!value || !value_of(from, parameter)) return std::nullopt;
    return with_value(from, parameter, *value);
}

}  // namespace tact
