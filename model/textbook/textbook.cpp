#include "model/textbook/textbook.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "assets/assets.h"
#include "model/common/portable.h"
#include "model/pattern/pattern_parameter.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::array<const char*, 3> kSure{"looked up", "secondary", "from memory"};
constexpr std::array<const char*, kReceptorCount> kAfferents{"FA1", "FA2", "SA1", "SA2"};
constexpr std::array<const char*, 9> kStageKeys{"vibration", "spectrum", "filtered",
                                                "receptors", "spikes",   "networks",
                                                "central",   "brain",    "envelope"};
constexpr std::string_view kValue = "{value}";
constexpr std::size_t kMostFacts = 500;
constexpr std::size_t kMostPoints = 100;

std::string needed_text(JsonObject& object, std::string_view key) {
    std::string text = text_field(object, key, "");
    if (text.empty()) {
        const Json* got = field(object, key);
        refuse(*object.reading, place_of(object, key), "a text that is not empty",
               got == nullptr ? Json() : *got);
    }
    return text;
}

std::optional<double> number_if_there(JsonObject& object, std::string_view key) {
    if (field(object, key) == nullptr) return std::nullopt;
    return number_field(object, key, 0.0, kAnyNumber);
}

void read_points(JsonObject& object, TextbookFact& fact) {
    JsonReading& reading = *object.reading;
    for (const Json* point : array_field(object, "points", 2, kMostPoints)) {
        const std::string place = place_of(object, "points");
        if (!point->is_array() || point->size() != 2) {
            refuse(reading, place, "pairs of two numbers", *point);
            return;
        }
        const double at = number_at(reading, (*point)[0], place, kAnyNumber);
        const double value = number_at(reading, (*point)[1], place, kAnyNumber);
        if (at <= (fact.points.empty() ? 0.0 : fact.points.back().first)) {
            refuse(reading, place, "first numbers above 0 that ascend", *point);
        }
        fact.points.emplace_back(at, value);
    }
}

void read_value(JsonObject& object, TextbookFact& fact) {
    const auto value = number_if_there(object, "value");
    fact.low = value ? value : number_if_there(object, "low");
    fact.high = value ? value : number_if_there(object, "high");
    if (field(object, "points") != nullptr) {
        read_points(object, fact);
        fact.over = needed_text(object, "over");
    }
    const bool has_range = fact.low || fact.high;
    const bool is_range = !fact.low || !fact.high || *fact.low <= *fact.high;
    if (has_range == fact.points.empty() && is_range) return;
    refuse(*object.reading, object.place,
           "a value, a low or a high one in their order, or points over something", *object.value);
}

TextbookFact fact_of(JsonObject& object) {
    TextbookFact fact;
    fact.id = name_field(object, "id", "");
    fact.what = needed_text(object, "what");
    fact.says = needed_text(object, "says");
    for (const Json* stage : array_field(object, "stages", 1, kStageKeys.size())) {
        const bool known =
            stage->is_string() &&
            std::ranges::find(kStageKeys, stage->get<std::string>()) != kStageKeys.end();
        if (known) fact.stages.push_back(stage->get<std::string>());
        if (!known) refuse(*object.reading, place_of(object, "stages"), "keys of stages", *stage);
    }
    if (field(object, "receptor") != nullptr) {
        fact.receptor = kReceptors[choice_field(object, "receptor", 0, kAfferents)];
    }
    read_value(object, fact);
    fact.unit = needed_text(object, "unit");
    fact.species = needed_text(object, "species");
    fact.site = needed_text(object, "site");
    fact.cite = needed_text(object, "cite");
    fact.source = needed_text(object, "source");
    fact.read = needed_text(object, "read");
    needed_text(object, "sure");
    fact.sure = static_cast<Sure>(choice_field(object, "sure", 2, kSure));
    return fact;
}

std::string number_text(const TextbookFact& fact) {
    if (!fact.points.empty()) {
        std::string text;
        for (std::size_t k = 0; k < fact.points.size(); ++k) {
            if (k > 0) text += k + 1 == fact.points.size() ? " and " : ", ";
            text += significant_digits(fact.points[k].second, 4);
            if (k + 1 == fact.points.size()) text += " " + fact.unit;
            text += " at " + significant_digits(fact.points[k].first, 4);
        }
        return text + " " + fact.over;
    }
    if (!fact.high) return "at least " + significant_digits(*fact.low, 4) + " " + fact.unit;
    if (!fact.low) return "less than " + significant_digits(*fact.high, 4) + " " + fact.unit;
    if (*fact.low == *fact.high) return significant_digits(*fact.low, 4) + " " + fact.unit;
    return significant_digits(*fact.low, 4) + " to " + significant_digits(*fact.high, 4) + " " +
           fact.unit;
}

}  // namespace

const std::vector<TextbookFact>& textbook() {
    static const std::vector<TextbookFact> facts = [] {
        auto parsed = parse_textbook(asset("physiology/textbook.json"), "textbook.json");
        assert(parsed && "the compiled-in textbook does not parse");
        return *std::move(parsed);
    }();
    return facts;
}

const TextbookFact* fact_named(std::string_view id) {
    const auto found = std::ranges::find(textbook(), id, &TextbookFact::id);
    return found == textbook().end() ? nullptr : &*found;
}

Expected<std::vector<TextbookFact>> parse_textbook(std::string_view json, const std::string& file) {
    const auto document = parse_json(json, file);
    if (!document) return document.error();
    JsonReading reading;
    reading.file = file;
    reading.unknown = UnknownKeys::refused;
    JsonObject whole = object_at(reading, *document, "");
    needed_text(whole, "format");
    whole_field(whole, "version", 1, {1.0, 1.0});
    std::vector<TextbookFact> facts;
    Json unknown;
    read_objects(whole, "facts", 1, kMostFacts, unknown, [&](JsonObject& object, Json&) {
        TextbookFact fact = fact_of(object);
        if (std::ranges::find(facts, fact.id, &TextbookFact::id) != facts.end()) {
            refuse(reading, place_of(object, "id"), "an id that no other fact has", Json(fact.id));
        }
        facts.push_back(std::move(fact));
    });
    unknown_fields(whole);
    if (!reading.fault.empty()) return Error{reading.fault};
    return facts;
}

std::string value_text(const TextbookFact& fact) {
    return number_text(fact) + (fact.sure == Sure::from_memory ? " (from memory)" : "");
}

std::string source_text(const TextbookFact& fact) { return fact.cite + ", " + fact.species; }

std::string sentence_of(const TextbookFact& fact) {
    std::string text = fact.says;
    const std::size_t at = text.find(kValue);
    if (at != std::string::npos) text.replace(at, kValue.size(), value_text(fact));
    if (text.ends_with('.')) text.pop_back();
    return text + " (" + source_text(fact) + ").";
}

std::optional<double> value_over(const TextbookFact& fact, double at) {
    const auto& points = fact.points;
    if (points.empty() || !(at >= points.front().first) || at > points.back().first) {
        return std::nullopt;
    }
    std::size_t k = 1;
    while (k + 1 < points.size() && points[k].first < at) ++k;
    const double from = portable::log10(points[k - 1].first);
    const double share = (portable::log10(at) - from) / (portable::log10(points[k].first) - from);
    return points[k - 1].second + share * (points[k].second - points[k - 1].second);
}

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
