#include "app/command_line/people/people_words.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/command_line/text_table.h"
#include "model/text/numbers.h"
#include "model/text/shown_text.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr const char* kIndent = "              ";

std::string with_interval(const Icc& icc) {
    return fixed_digits(icc.value, 3) + " (" + range_text(icc.interval.low, icc.interval.high, 2) +
           ")";
}

std::string text_of(const Shift& shift, const char* label, const char* what) {
    if (shift.comparisons == 0) return {};
    return std::string(label) + what + " " + fixed_digits(shift.mean, 1) +
           " points of 100 on average, " +
           (std::isnan(shift.p)
                ? signs_text(shift)
                : "p " + fixed_digits(shift.p, 4) + " (" + signs_text(shift) + ", two-sided)") +
           ", " + std::to_string(shift.people) + (shift.people == 1 ? " person\n" : " people\n");
}

nlohmann::json json_of(const Shift& shift) {
    return {{"people", shift.people},
            {"comparisons", shift.comparisons},
            {"mean_points", shift.mean},  // NaN becomes null
            {"p", shift.p},
            {"signs", shift.signs},
            {"all_signs", shift.is_exact}};
}

std::string ends_text(const IndividualWeights& weights, std::size_t dimension) {
    const DimensionEnds ends = ends_of(weights, dimension);
    return "dimension " + std::to_string(dimension + 1) + " leads from " + in_quotes(ends.low) +
           " to " + in_quotes(ends.high) + "\n";
}

constexpr const char* kFootOfWeights =
    "weight: how much of one's ratings stands in a dimension (INDSCAL, Carroll & Chang 1970; least "
    "squares on scalar products, each person's to one size, weights not below 0; the best of 21 "
    "starts, seed 1); explained: share of that; descriptions, nothing is tested\n";

}  // namespace

std::string text_of(const InterRater& raters) {
    if (raters.people < 2) return {};
    return std::string(kIndent) + "ICC(2,1) " + with_interval(raters.single) +
           " of one person, ICC(3,k) " + with_interval(raters.mean) + " of the mean of " +
           std::to_string(raters.people) + ", Krippendorff's alpha " +
           fixed_digits(raters.alpha, 3) + "\n" + kIndent + "(95 % intervals, of " +
           std::to_string(raters.pairs) +
           " pairs rated by all, as if pairs were independent; alpha of interval data)\n";
}

std::string text_of(const OrderEffects& effects) {
    return text_of(effects.felt_first, "order         ",
                   "of the pattern earlier in the set, felt first less second:") +
           text_of(effects.side, "sides         ",
                   "of the pattern earlier in the set, on the left less right:") +
           text_of(effects.practice, "practice      ", "last repetition less first:");
}

nlohmann::json json_of(const OrderEffects& effects) {
    return {{"felt_first", json_of(effects.felt_first)},
            {"side", json_of(effects.side)},
            {"practice", json_of(effects.practice)}};
}

std::string text_of(const IndividualWeights& weights) {
    if (weights.people.empty()) {
        return "no individual weights: they take two people who rated every pair, and two patterns "
               "more than dimensions\n";
    }
    TextRow head{"individual weights"};
    for (Eigen::Index r = 0; r < weights.group.cols(); ++r) {
        head.push_back("dimension " + std::to_string(r + 1));
    }
    head.emplace_back("explained");
    std::vector<TextRow> rows{head};
    for (const PersonWeights& person : weights.people) {
        TextRow row{person.participant};
        for (const double weight : person.weights) row.push_back(fixed_digits(weight, 3));
        row.push_back(fixed_digits(person.explained, 3));
        rows.push_back(row);
    }
    std::string text = aligned(rows);
    for (std::size_t r = 0; r < weights.mean.size(); ++r) text += ends_text(weights, r);
    for (const std::string& one : weights.left_out) {
        text += shown_text(one) + " did not rate every pair, or all alike, and has no weights\n";
    }
    return text + kFootOfWeights;
}

nlohmann::json json_of(const IndividualWeights& weights) {
    nlohmann::json people = nlohmann::json::array();
    for (const PersonWeights& person : weights.people) {
        people.push_back({{"participant", person.participant},
                          {"weights", person.weights},
                          {"explained", person.explained}});
    }
    nlohmann::json places = nlohmann::json::array();
    for (Eigen::Index i = 0; i < weights.group.rows(); ++i) {
        std::vector<double> place;
        for (Eigen::Index r = 0; r < weights.group.cols(); ++r) {
            place.push_back(weights.group(i, r));
        }
        places.push_back(place);
    }
    return {{"labels", weights.labels},
            {"common_map", places},
            {"people", people},
            {"left_out", weights.left_out},
            {"explained", people.empty() ? nlohmann::json() : nlohmann::json(weights.explained)}};
}

}  // namespace tact
