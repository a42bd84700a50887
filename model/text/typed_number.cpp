#include "model/text/typed_number.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "model/common/portable.h"
#include "model/common/units.h"
#include "model/system/leading_number.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

enum class Quantity { acceleration, frequency, time, length, level, share, sensitivity };

struct UnitMeaning {
    std::string_view name;
    Quantity quantity;
    double size;  // in the first unit of its quantity
};

constexpr std::array<UnitMeaning, 18> kUnits{{{"g", Quantity::acceleration, 1.0},
                                              {"mg", Quantity::acceleration, 1e-3},
                                              {"m/s2", Quantity::acceleration, 0.0},
                                              {"m/s\u00b2", Quantity::acceleration, 0.0},
                                              {"Hz", Quantity::frequency, 1.0},
                                              {"kHz", Quantity::frequency, 1e3},
                                              {"ms", Quantity::time, 1.0},
                                              {"s", Quantity::time, 1e3},
                                              {"min", Quantity::time, 6e4},
                                              {"um", Quantity::length, 1.0},
                                              {"\u00b5m", Quantity::length, 1.0},
                                              {"\u03bcm", Quantity::length, 1.0},
                                              {"mm", Quantity::length, 1e3},
                                              {"cm", Quantity::length, 1e4},
                                              {"dB", Quantity::level, 1.0},
                                              {"%", Quantity::share, 1.0},
                                              {"V/g", Quantity::sensitivity, 1.0},
                                              {"mV/g", Quantity::sensitivity, 1e-3}}};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_same_word(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, {}, lower, lower);
}

std::optional<UnitMeaning> meaning_of(std::string_view unit) {
    for (UnitMeaning one : kUnits) {
        if (!is_same_word(one.name, unit)) continue;
        if (one.size == 0.0) one.size = 1.0 / kStandardGravityMPerS2;
        return one;
    }
    return std::nullopt;
}

// A text as a change or none, a number, and what is behind it.
struct Parts {
    char change = 0;  // * or /
    bool has_sign = false;
    double number = 0.0;
    std::string unit;
};

// Half of the world writes 1,5. Two commas, or one beside a point, are no number in any of it.
std::optional<Parts> parts_of(std::string text) {
    const auto commas = std::ranges::count(text, ',');
    if (commas > 1 || (commas == 1 && text.find('.') != text.npos)) return std::nullopt;
    std::ranges::replace(text, ',', '.');
    std::string_view rest = trimmed(text);
    Parts parts;
    if (!rest.empty() && (rest[0] == '*' || rest[0] == '/')) {
        parts.change = rest[0];
        rest = trimmed(rest.substr(1));
    }
    if (rest.empty()) return std::nullopt;
    parts.has_sign = rest[0] == '+' || rest[0] == '-';
    if (rest[0] == '+') {
        rest = trimmed(rest.substr(1));
        if (rest.starts_with('+') || rest.starts_with('-')) return std::nullopt;
    }
    const std::optional<LeadingNumber> number = leading_number(rest);
    if (!number) return std::nullopt;
    parts.number = number->value;
    parts.unit = trimmed(rest.substr(number->length));
    return parts;
}

std::string with_unit(double value, std::string_view unit) {
    const std::string digits = significant_digits(value, 6);
    return unit.empty() ? digits : digits + " " + std::string(unit);
}

// A change of strength by decibels is one of what is felt or measured, not of a pitch or a time.
bool takes_decibels(const NumberRules& rules) {
    const auto own = meaning_of(rules.unit);
    return !own || (own->quantity != Quantity::frequency && own->quantity != Quantity::time);
}

std::string quoted(std::string_view text) { return "\"" + std::string(trimmed(text)) + "\""; }

Error no_number(std::string_view text) {
    return Error{quoted(text) +
                 " is no number: type one such as 1.5, or a change such as *2 or -10%"};
}

// The number that was typed as it is, or the factor by which the present one changes.
struct Meaning {
    double number = 0.0;
    std::optional<double> factor{};
    bool divides = false;  // by the factor: 0.3 / 3 is not 0.3 * (1 / 3) to the last bit
};

Expected<Meaning> level_meant(std::string_view text, const Parts& parts, const NumberRules& rules) {
    if (!takes_decibels(rules)) {
        return Error{quoted(text) + " changes a strength: this is a number of " +
                     std::string(rules.unit)};
    }
    if (parts.has_sign) return Meaning{0.0, portable::pow(10.0, parts.number / 20.0)};
    return Error{quoted(text) + " is neither more nor less: type +3dB or -3dB"};
}

// Before it is held against the range.
Expected<Meaning> meant(std::string_view text, const Parts& parts, const NumberRules& rules) {
    if (parts.change != 0) {
        if (!parts.unit.empty()) return no_number(text);
        return Meaning{0.0, parts.number, parts.change == '/'};
    }
    if (parts.unit.empty() || is_same_word(parts.unit, rules.unit)) return Meaning{parts.number};
    const auto typed = meaning_of(parts.unit);
    if (!typed) return no_number(text);
    if (typed->quantity == Quantity::share) {
        if (parts.has_sign) return Meaning{0.0, 1.0 + parts.number / 100.0};
        return Error{quoted(text) + " is neither more nor less: type +10% or -10%"};
    }
    if (typed->quantity == Quantity::level) return level_meant(text, parts, rules);
    const auto own = meaning_of(rules.unit);
    if (own && own->quantity == typed->quantity) {
        // Divided, not multiplied by a reciprocal: 0.2 s are 200 ms to the last bit.
        return Meaning{typed->size >= own->size ? parts.number * (typed->size / own->size)
                                                : parts.number / (own->size / typed->size)};
    }
    const std::string wanted =
        rules.unit.empty() ? "a number without a unit" : "a number of " + std::string(rules.unit);
    return Error{quoted(text) + " is in " + parts.unit + ": this is " + wanted};
}

double applied(const Meaning& meaning, double present) {
    if (!meaning.factor) return meaning.number;
    return meaning.divides ? present / *meaning.factor : present * *meaning.factor;
}

}  // namespace

Expected<TypedNumber> typed_number(std::string_view text, double present,
                                   const NumberRules& rules) {
    const auto parts = parts_of(std::string(text));
    if (!parts) return no_number(text);
    const Expected<Meaning> meaning = meant(text, *parts, rules);
    if (!meaning) return meaning.error();
    const double value = applied(*meaning, present);
    if (!std::isfinite(value)) return no_number(text);
    if (std::fpclassify(value) == FP_SUBNORMAL) {
        return Error{quoted(text) + " is too near zero to be computed with: type 0"};
    }
    if (rules.whole && value != std::floor(value)) {
        return Error{quoted(text) + " is no whole number"};
    }
    TypedNumber typed{std::clamp(value, rules.allowed.low, rules.allowed.high)};
    if (meaning->factor) {
        typed.factor = meaning->divides ? 1.0 / *meaning->factor : *meaning->factor;
    }
    if (typed.value != value) {
        const bool above = value > rules.allowed.high;
        typed.remark = with_unit(value, rules.unit) +
                       (above ? " is too much: " : " is too little: ") +
                       with_unit(typed.value, rules.unit) +
                       (above ? ", the most, was taken" : ", the least, was taken");
    }
    return typed;
}

std::string_view unit_in(std::string_view format) {
    const std::size_t mark = format.find('%');
    if (mark == format.npos) return {};
    const std::size_t kind = format.find_first_of("gfeGFEdi", mark);
    if (kind == format.npos) return {};
    const std::string_view unit = trimmed(format.substr(kind + 1));
    return unit == "%%" ? unit.substr(1) : unit;
}

std::string_view leading_unit(std::string_view words) {
    const std::string_view first = words.substr(0, words.find_first_of(" ,;"));
    return meaning_of(first) ? first : std::string_view{};
}

std::string shown_number(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace tact
