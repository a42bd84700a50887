#include "model/io/recordings/column_names.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

// Units behind an underscore; unsupported ones are listed so that they can be refused.
bool is_unit_word(std::string_view text) {
    constexpr std::array kUnits{"s",     "ms",   "us",   "ns",       "min",    "g",     "v",
                                "mps2",  "ms2",  "m/s2", "m/s^2",    "mg",     "ug",    "gal",
                                "mv",    "uv",   "kv",   "mm/s2",    "mm/s^2", "cm/s2", "cm/s^2",
                                "ft/s2", "mms2", "lsb",  "adc",      "counts", "raw",   "mps",
                                "m/s",   "mm/s", "dps",  "m/s\u00b2"};
    return std::ranges::find(kUnits, text) != kUnits.end();
}

// Columns that are called by their unit alone. "a", "g" and "s" are names, too.
bool is_unit_name(std::string_view text) {
    constexpr std::array kUnits{"v",       "volt",   "volts",        "voltage", "mv",
                                "mg",      "gal",    "lsb",          "adc",     "counts",
                                "raw",     "ms",     "us",           "ns",      "second",
                                "seconds", "millis", "milliseconds", "micros",  "microseconds"};
    return std::ranges::find(kUnits, text) != kUnits.end();
}

}  // namespace

std::pair<std::string, std::string> word_and_unit(const std::string& name) {
    std::string text = lower_case(std::string(trimmed(name)));
    const std::size_t bracket = text.find_first_of("([");
    if (bracket != text.npos) {
        std::string unit = text.substr(bracket + 1);
        unit = unit.substr(0, unit.find_first_of(")]"));
        return {std::string(trimmed(text.substr(0, bracket))), std::string(trimmed(unit))};
    }
    const std::size_t underscore = text.rfind('_');
    if (underscore != text.npos && underscore > 0) {
        const std::string end = text.substr(underscore + 1);
        if (is_unit_word(end)) return {text.substr(0, underscore), end};
    }
    // "Beschleunigung in m/s2", "time in ms".
    const std::size_t in = text.rfind(" in ");
    if (in != text.npos) return {text.substr(0, in), std::string(trimmed(text.substr(in + 4)))};
    if (is_unit_name(text) || (text.size() > 1 && is_unit_word(text))) return {text, text};
    // "t/ms", "a / m/s2", "acc g": what stands last.
    for (const std::size_t cut : {text.find('/'), text.rfind(' ')}) {
        if (cut == text.npos || cut == 0) continue;
        const std::string end(trimmed(text.substr(cut + 1)));
        if (is_unit_word(end)) return {std::string(trimmed(text.substr(0, cut))), end};
    }
    return {text, ""};
}

std::optional<double> time_unit_of(const std::string& unit) {
    const auto is = [&unit](std::initializer_list<std::string_view> names) {
        return std::ranges::find(names, unit) != names.end();
    };
    if (is({"s", "sec", "secs", "second", "seconds", "sekunden"})) return 1.0;
    if (is({"ms", "msec", "millis", "millisecond", "milliseconds"})) return 1e-3;
    if (is({"us", "usec", "micros", "microsecond", "microseconds", "\u00b5s", "\u03bcs"}))
        return 1e-6;
    if (is({"ns", "nsec", "nanos", "nanosecond", "nanoseconds"})) return 1e-9;
    return std::nullopt;
}

std::optional<AccelerationUnit> unit_of(const std::string& unit) {
    if (unit == "g") return AccelerationUnit::g;
    if (unit == "v" || unit == "volt" || unit == "volts" || unit == "voltage")
        return AccelerationUnit::volt;
    for (const char* same :
         {"m/s2", "m/s^2", "m/s\u00b2", "m/s/s", "mps2", "ms2", "ms-2", "m s-2"}) {
        if (unit == same) return AccelerationUnit::m_per_s2;
    }
    return std::nullopt;
}

bool is_time(const std::string& word) {
    return word == "t" || word.starts_with("time") || word.starts_with("zeit") ||
           word.starts_with("elapsed") || word == "second" || word == "seconds" ||
           word == "millis" || word == "micros" || word == "dt" || word == "delta t" ||
           word == "delta_t";
}

bool is_step_of_time(const std::string& word) {
    if (word == "dt" || word == "delta t" || word == "delta_t") return true;
    const auto has = [&word](const char* part) { return word.find(part) != word.npos; };
    return is_time(word) && (has("diff") || has("delta") || has("step") || has("interval"));
}

bool is_axis(const std::string& whole) {
    std::string_view word = whole;
    for (const std::string_view end : {" value", " axis"}) {
        if (word.ends_with(end)) word.remove_suffix(end.size());
    }
    if (word.empty()) return false;
    for (const char* letter : {"x", "y", "z"}) {
        for (const char* prefix : {"", "a", "acc", "acc ", "acc_", "accel_", "accel ", "accel",
                                   "acceleration ", "acceleration_", "axis ", "a_", "a "}) {
            if (word == std::string(prefix) + letter) return true;
        }
    }
    // "linear acceleration x", "user acc y"; forces in g: "gfx".
    const std::string_view last = word.substr(word.size() - 1);
    const bool is_letter = last == "x" || last == "y" || last == "z";
    const bool is_of_acceleration = word.find("acc") != word.npos || word.starts_with("gf");
    const bool is_apart = word.size() > 1 && (word[word.size() - 2] == ' ' || word.size() == 3);
    if (is_letter && is_of_acceleration && is_apart) return true;
    return word.starts_with("acc") || word == "a" || word == "g" || word.starts_with("volt");
}

bool is_total(const std::string& word) {
    for (const char* begin : {"abs", "total", "norm", "magnitude", "resultant", "tgf", "|a|"}) {
        if (word.starts_with(begin)) return true;
    }
    return false;
}

}  // namespace tact
