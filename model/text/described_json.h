// Structs that are described (model/text/described.h) as JSON and back.
//
// Reading   a key that is missing leaves its member as it was; the first fault stays in the
//           reading, with its place. Keys that the description does not have go to `unknown`, those
//           of a list by position.
// Writing   members in the order of the description, each when it is Kept; a struct and a list
//           within where they differ from the default.
// A struct that is more than its members has functions of its own, which are found by their
// argument: take_fields(JsonObject&, Rhythm&, Json&), put_fields(Json&, const Rhythm&, ...).
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "model/text/described.h"
#include "model/text/json_fields.h"

namespace tact {

template <class Struct>
void take_fields(JsonObject& object, Struct& all, Json& unknown);

// Without defaults, everything is written.
template <class Struct>
void put_fields(Json& object, const Struct& all, const Struct* defaults);

template <class Struct>
struct TakeFields {
    JsonObject& object;
    Struct& all;
    Json& unknown;

    void operator()(const Number& number, double Struct::*member) const {
        JsonReading& reading = *object.reading;
        const bool is_there = object.value != nullptr && object.value->contains(number.key);
        if (number.kept == Kept::needed && !is_there && reading.fault.empty()) {
            reading.fault = reading.file + ": " + place_of(object, number.key) +
                            ": expected a number, it is missing";
        }
        all.*member = number_field(object, number.key, all.*member, number.range);
    }
    void operator()(const Number& number, int Struct::*member) const {
        all.*member = whole_field(object, number.key, all.*member, number.range);
    }
    void operator()(const Number& number, Range Struct::*member) const {
        const auto ends = array_field(object, number.key, 2, 2);
        const std::string place = place_of(object, number.key);
        if (ends.size() != 2) return;
        all.*member = {number_at(*object.reading, *ends[0], place + "/0", number.range),
                       number_at(*object.reading, *ends[1], place + "/1", number.range)};
    }
    template <std::size_t n>
    void operator()(const char* key, const std::array<Number, n>& numbers,
                    std::array<double, n> Struct::*member) const {
        JsonObject fields = object_field(object, key);
        for (std::size_t k = 0; k < n; ++k) {
            double& value = (all.*member)[k];
            value = number_field(fields, numbers[k].key, value, numbers[k].range);
        }
        note_unknown(unknown, key, unknown_fields(fields));
    }
    void operator()(const char* key, bool Struct::*member) const {
        all.*member = yes_no_field(object, key, all.*member);
    }
    template <class Enum>
    void operator()(const char* key, const OneOf& one, Enum Struct::*member) const {
        all.*member = static_cast<Enum>(
            choice_field(object, key, static_cast<std::size_t>(all.*member), one.words));
    }
    template <class Part>
    void operator()(const char* key, Part Struct::*part) const {
        if (*key == '\0') return take_fields(object, all.*part, unknown);
        JsonObject fields = object_field(object, key);
        take_part(key, fields, all.*part, unknown);
    }
    template <class Part>
    void operator()(const char* key, std::optional<Part> Struct::*part) const {
        if (object.value == nullptr || !object.value->contains(key)) return;
        JsonObject fields = object_field(object, key);
        take_part(key, fields, (all.*part).emplace(), unknown);
    }
    template <class One>
    void operator()(const char* key, std::map<char, One> Struct::*by_letter) const {
        JsonObject letters = object_field(object, key);
        Json of_letters = Json::object();
        for (const char* letter : kLetters) {
            if (letters.value == nullptr || !letters.value->contains(letter)) continue;
            JsonObject fields = object_field(letters, letter);
            take_part(letter, fields, (all.*by_letter)[*letter], of_letters);
        }
        of_letters.update(unknown_fields(letters));
        note_unknown(unknown, key, of_letters);
    }
    template <class One>
    void operator()(const ManyOf& list, std::vector<One> Struct::*member) const {
        std::vector<One> read;
        read_objects(object, list.key, list.least, list.most, unknown,
                     [&](JsonObject& fields, Json& of_one) {
                         take_fields(fields, read.emplace_back(), of_one);
                     });
        if (!read.empty()) all.*member = std::move(read);
    }

    void operator()(const Text& text, std::string Struct::*member) const {
        all.*member = text.is_name ? name_field(object, text.key, all.*member)
                                   : text_field(object, text.key, all.*member);
    }
    void operator()(const ManyOf& list, std::vector<std::string> Struct::*member) const {
        each_of(list, [this, member](const Json& name, const std::string& place) {
            (all.*member).push_back(name_at(*object.reading, name, place));
        });
    }
    void operator()(const ManyOf& list, const Number& number,
                    std::vector<int> Struct::*member) const {
        each_of(list, [this, &number, member](const Json& one, const std::string& place) {
            const double value = number_at(*object.reading, one, place, number.range);
            (all.*member).push_back(static_cast<int>(value));
        });
    }

  private:
    template <class Take>
    void each_of(const ManyOf& list, const Take& take) const {
        const auto elements = array_field(object, list.key, list.least, list.most);
        for (std::size_t k = 0; k < elements.size(); ++k) {
            take(*elements[k], place_of(object, list.key) + "/" + std::to_string(k));
        }
    }

    static constexpr const char* kLetters[] = {"A", "B", "C", "D", "E", "F", "G", "H", "I",
                                               "J", "K", "L", "M", "N", "O", "P", "Q", "R",
                                               "S", "T", "U", "V", "W", "X", "Y", "Z"};

    template <class Part>
    static void take_part(const char* key, JsonObject& fields, Part& part, Json& unknown_of_all) {
        Json of_part = Json::object();
        take_fields(fields, part, of_part);
        of_part.update(unknown_fields(fields));
        note_unknown(unknown_of_all, key, of_part);
    }
};

// Not yet the unknown fields of the object itself, as other keys of it may be taken elsewhere.
template <class Struct>
void take_fields(JsonObject& object, Struct& all, Json& unknown) {
    describe(Of<Struct>{}, TakeFields<Struct>{object, all, unknown});
}

template <class Struct>
struct PutFields {
    Json& object;
    const Struct& all;
    const Struct* defaults;

    template <class Value>
    bool is_usual(Value Struct::*member) const {
        return defaults != nullptr && all.*member == defaults->*member;
    }

    template <class Value>
    void operator()(const Number& number, Value Struct::*member) const {
        if (number.kept == Kept::changed && is_usual(member)) return;
        object[number.key] = all.*member;
    }
    void operator()(const Number& number, Range Struct::*member) const {
        if (number.kept == Kept::changed && is_usual(member)) return;
        object[number.key] = {(all.*member).low, (all.*member).high};
    }
    template <std::size_t n>
    void operator()(const char* key, const std::array<Number, n>& numbers,
                    std::array<double, n> Struct::*member) const {
        if (is_usual(member)) return;
        for (std::size_t k = 0; k < n; ++k) object[key][numbers[k].key] = (all.*member)[k];
    }
    void operator()(const char* key, bool Struct::*member) const {
        if (!is_usual(member)) object[key] = all.*member;
    }
    template <class Enum>
    void operator()(const char* key, const OneOf& one, Enum Struct::*member) const {
        if (one.kept == Kept::changed && is_usual(member)) return;
        object[key] = one.words[static_cast<std::size_t>(all.*member)];
    }
    template <class Part>
    void operator()(const char* key, Part Struct::*part) const {
        if (is_usual(part)) return;
        const Part* usual = defaults == nullptr ? nullptr : &(defaults->*part);
        put_fields(*key == '\0' ? object : object[key] = Json::object(), all.*part, usual);
    }
    template <class Part>
    void operator()(const char* key, std::optional<Part> Struct::*part) const {
        const Part usual{};
        if (all.*part) put_fields(object[key] = Json::object(), *(all.*part), &usual);
    }
    template <class One>
    void operator()(const char* key, std::map<char, One> Struct::*by_letter) const {
        const One usual{};
        for (const auto& [letter, one] : all.*by_letter) {
            put_fields(object[key][std::string(1, letter)] = Json::object(), one, &usual);
        }
    }
    template <class One>
    void operator()(const ManyOf& list, std::vector<One> Struct::*member) const {
        if (list.kept == Kept::changed && is_usual(member)) return;
        Json& elements = object[list.key] = Json::array();
        const One usual{};
        for (const One& one : all.*member) {
            put_fields(elements.emplace_back(Json::object()), one, &usual);
        }
    }
    void operator()(const Text& text, std::string Struct::*member) const {
        if (!is_usual(member)) object[text.key] = all.*member;
    }
    void operator()(const ManyOf& list, std::vector<std::string> Struct::*member) const {
        if (!is_usual(member)) object[list.key] = all.*member;
    }
    void operator()(const ManyOf& list, const Number&, std::vector<int> Struct::*member) const {
        if (!is_usual(member)) object[list.key] = all.*member;
    }
};

template <class Struct>
void put_fields(Json& object, const Struct& all, const Struct* defaults) {
    describe(Of<Struct>{}, PutFields<Struct>{object, all, defaults});
}

}  // namespace tact
