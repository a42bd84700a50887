#include "model/textbook/noticed.h"

#include <algorithm>
#include <cmath>

#include "model/pattern/pattern_parameter.h"
#include "model/text/numbers.h"
#include "model/textbook/textbook.h"

namespace tact {

namespace {

constexpr double kAtOnce = 2.0;  // times the noticeable difference

// Frequency of the only carrier; nullopt: it has several, or its frequency is a curve.
std::optional<double> frequency_hz(const Pattern& pattern) {
    if (pattern.carriers.size() != 1) return std::nullopt;
    const auto hz = value_of(pattern, PatternParameter::carrier);
    return hz && *hz > 0.0 ? hz : std::nullopt;
}

// The difference against the noticeable one, both in the fact's unit.
std::string verdict(double difference, const TextbookFact& fact) {
    if (difference < *fact.low) return "most people do not notice that";
    if (difference <= *fact.high) return "about what people just notice";
    if (difference <= kAtOnce * *fact.high) return "people notice that";
    return "people tell these apart at once";
}

std::string said(const std::string& what, const std::string& how, const TextbookFact& fact) {
    return "People: " + what + "; " + how + " (just noticeable: " + value_text(fact) + ", " +
           source_text(fact) + ").";
}

// Difference in % of the lower one.
double apart_percent(double a, double b) { return 100.0 * (std::max(a, b) / std::min(a, b) - 1.0); }

std::string of_frequency(double a_hz, double b_hz) {
    const TextbookFact& fact = *fact_named("frequency jnd");
    const double ratio = std::max(a_hz, b_hz) / std::min(a_hz, b_hz);
    std::string what =
        significant_digits(a_hz, 4) + " against " + significant_digits(b_hz, 4) + " Hz, ";
    what += ratio >= 2.0 ? significant_digits(ratio, 3) + " times"
                         : significant_digits(apart_percent(a_hz, b_hz), 3) + " %";
    return said(what, verdict(apart_percent(a_hz, b_hz), fact), fact);
}

std::string of_amplitude(double a_g, double b_g) {
    const TextbookFact& fact = *fact_named("amplitude jnd");
    const double db = std::abs(20.0 * std::log10(a_g / b_g));
    const std::string what = significant_digits(a_g, 3) + " against " + significant_digits(b_g, 3) +
                             " g, " + significant_digits(db, 3) + " dB";
    return said(what, verdict(db, fact), fact);
}

}  // namespace

std::string noticed_text(const Pattern& a, const Pattern& b) {
    const auto a_hz = frequency_hz(a);
    const auto b_hz = frequency_hz(b);
    if (!a_hz || !b_hz) return {};
    if (*a_hz != *b_hz) return of_frequency(*a_hz, *b_hz);
    if (!(a.amplitude_g > 0.0) || !(b.amplitude_g > 0.0)) return {};
    if (a.amplitude_g == b.amplitude_g) return {};
    if (!a.amplitude_curve.empty() || !b.amplitude_curve.empty()) return {};
    return of_amplitude(a.amplitude_g, b.amplitude_g);
}

bool tell_by_frequency(const Pattern& a, const Pattern& b) {
    const auto a_hz = frequency_hz(a);
    const auto b_hz = frequency_hz(b);
    if (!a_hz || !b_hz) return false;
    return apart_percent(*a_hz, *b_hz) > kAtOnce * *fact_named("frequency jnd")->high;
}

}  // namespace tact
