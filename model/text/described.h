// Numbers that files hold and people change, each described once, beside its struct:
//
//     template <class Visit>
//     void describe(Of<Carrier>, Visit&& visit) {
//         visit(numbers::kCarrier, &Carrier::frequency_hz);
//         ...
//     }
//
// Whatever treats all numbers of a struct alike is a visitor of such a description: a file read and
// written (model/text/described_json.h), a clamp, the table in the manual. A field of the window,
// an option of a command and an axis of a design space each take one of its numbers. So none of
// them can have a range, a key or a unit of its own.
//
// A visitor is called with what a member is, and with the member:
//     Number                   a double or an int
//     a key, OneOf             an enumerator, by its word
//     Number                   a Range: [low, high], each a number of that kind
//     a key                    a bool, or a struct that has a description itself
//     a key, several Numbers   an array of as many doubles
//     ManyOf                   a vector of such structs, of names, or with a Number of whole
//     numbers Text                     a text a key                    a map of such structs by
//     their letters
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "model/common/units.h"
#include "model/text/numbers.h"

namespace tact {

// Which struct is described.
template <class Struct>
struct Of {};

// When a file holds it.
enum class Kept {
    changed,  // where it differs from its default
    always,
    needed  // always, and a file without it is refused
};

struct Number {
    const char* key;     // in files, with its unit: "attack_s"
    const char* label;   // beside its field: "Attack"
    const char* format;  // of printf, with the unit in which it is shown: "%.4g ms"
    Range range;         // that files may hold and a person may type, in the key's unit
    Range slider;        // that a slider spans, in the key's unit
    double times = 1.0;  // what is shown of 1 of it: 1000 of s in ms
    double step = 1.0;   // of an arrow key, as shown
    double snap = 0.0;   // of the slider, as shown; 0: none
    bool logarithmic = false;
    const char* help = nullptr;  // a sentence
    Kept kept = Kept::changed;

    // The nearest value in range; the lowest of what is not finite.
    double clamped(double value) const {
        return std::isfinite(value) ? std::clamp(value, range.low, range.high) : range.low;
    }
    Range clamped(const Range& of) const { return {clamped(of.low), clamped(of.high)}; }
    int clamped(int value) const { return static_cast<int>(clamped(static_cast<double>(value))); }
    constexpr Range shown(const Range& of) const { return {times * of.low, times * of.high}; }

    // Another number of the same kind.
    constexpr Number as(const char* its_key, const char* its_label, const char* its_help) const {
        Number other = *this;
        other.key = its_key;
        other.label = its_label;
        other.help = its_help;
        return other;
    }
    constexpr Number with(Kept its_kept) const {
        Number other = *this;
        other.kept = its_kept;
        return other;
    }
};

// "a number from 0 to 50", of any if the range is of all numbers: behind "expected".
inline std::string range_words(const Range& range, const char* kind = "a number") {
    if (range.high == std::numeric_limits<double>::max()) return kind;
    return std::string(kind) + " from " + shortest_digits(range.low) + " to " +
           shortest_digits(range.high);
}

// Words of an enumeration, in its order.
struct OneOf {
    std::span<const char* const> words;
    Kept kept = Kept::changed;
};

// A text, or one that is as short as names are.
struct Text {
    const char* key;
    bool is_name = false;
};

// A list, by how many it may have.
struct ManyOf {
    const char* key;
    std::size_t least;
    std::size_t most;
    Kept kept = Kept::changed;
};

template <class Struct>
void clamp_numbers(Struct& all);

// What a visitor of numbers passes over.
template <class Struct>
struct PassOver {
    template <class Enum>
    void operator()(const char*, const OneOf&, Enum Struct::*) const {}
    void operator()(const char*, bool Struct::*) const {}
    void operator()(const Text&, std::string Struct::*) const {}
    void operator()(const ManyOf&, std::vector<std::string> Struct::*) const {}
};

template <class Struct>
struct ClampNumbers : PassOver<Struct> {
    using PassOver<Struct>::operator();
    Struct& all;

    explicit ClampNumbers(Struct& clamped) : all(clamped) {}

    template <class Value>
    void operator()(const Number& number, Value Struct::*member) const {
        all.*member = number.clamped(all.*member);
    }
    template <std::size_t n>
    void operator()(const char*, const std::array<Number, n>& numbers,
                    std::array<double, n> Struct::*member) const {
        for (std::size_t k = 0; k < n; ++k) {
            (all.*member)[k] = numbers[k].clamped((all.*member)[k]);
        }
    }
    template <class Part>
    void operator()(const char*, Part Struct::*part) const {
        clamp_numbers(all.*part);
    }
    template <class Part>
    void operator()(const char*, std::optional<Part> Struct::*part) const {
        if (all.*part) clamp_numbers(*(all.*part));
    }
    template <class One>
    void operator()(const char*, std::map<char, One> Struct::*by_letter) const {
        for (auto& [letter, one] : all.*by_letter) clamp_numbers(one);
    }
    template <class One>
    void operator()(const ManyOf&, std::vector<One> Struct::*list) const {
        for (One& one : all.*list) clamp_numbers(one);
    }
    void operator()(const ManyOf&, const Number& number, std::vector<int> Struct::*list) const {
        for (int& one : all.*list) one = number.clamped(one);
    }
};

// Every number to the nearest in its range; how many there are stays.
template <class Struct>
void clamp_numbers(Struct& all) {
    describe(Of<Struct>{}, ClampNumbers<Struct>(all));
}

template <class Struct, class Take>
void each_number(const Struct& usual, const std::string& place, Take&& take);

template <class Struct, class Take>
struct EachNumber : PassOver<Struct> {
    using PassOver<Struct>::operator();
    const Struct& usual;
    const std::string& place;
    Take& take;

    EachNumber(const Struct& of, const std::string& at, Take& with)
        : usual(of), place(at), take(with) {}

    template <class Value>
    void operator()(const Number& number, Value Struct::*member) const {
        if constexpr (std::is_same_v<Value, Range>) {
            take(place + number.key + "/0", number, (usual.*member).low);
            take(place + number.key + "/1", number, (usual.*member).high);
        } else {
            take(place + number.key, number, static_cast<double>(usual.*member));
        }
    }
    template <std::size_t n>
    void operator()(const char* key, const std::array<Number, n>& numbers,
                    std::array<double, n> Struct::*member) const {
        for (std::size_t k = 0; k < n; ++k) {
            take(place + key + "/" + numbers[k].key, numbers[k], (usual.*member)[k]);
        }
    }
    template <class Part>
    void operator()(const char* key, Part Struct::*part) const {
        each_number(usual.*part, place + (*key == '\0' ? "" : std::string(key) + "/"), take);
    }
    template <class Part>
    void operator()(const char* key, std::optional<Part> Struct::*) const {
        each_number(Part{}, place + key + "/", take);
    }
    template <class One>
    void operator()(const char* key, std::map<char, One> Struct::*) const {
        each_number(One{}, place + key + "/A/", take);
    }
    template <class One>
    void operator()(const ManyOf& list, std::vector<One> Struct::*) const {
        each_number(One{}, place + list.key + "/0/", take);
    }
    void operator()(const ManyOf& list, const Number& number, std::vector<int> Struct::*) const {
        take(place + list.key + "/0", number, number.range.low);
    }
};

// Calls `take` with the place in a file, "carriers/0/frequency_hz", the description and the default
// of every number: of lists those of the first, of letters those of A.
template <class Struct, class Take>
void each_number(const Struct& usual, const std::string& place, Take&& take) {
    describe(Of<Struct>{}, EachNumber<Struct, std::remove_reference_t<Take>>(usual, place, take));
}

}  // namespace tact
