// What the program and the phones of a room tell each other, as plain values.
//
// Input     cards are JSON objects without a serial, made by the program
// Valid     `ms` of a play: on, off, on, .. in whole milliseconds; a first 0 if it begins with off
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/text/json_fields.h"

namespace tact {

enum class PhoneSide { both, a, b };  // which plays a phone takes

struct ConnectedPhone {
    int number = 0;
    std::string nickname;
    std::string language;
    bool vibrates = false;  // the browser has navigator.vibrate
    bool is_here = false;   // it has asked within the last 30 s
    PhoneSide side = PhoneSide::both;
    // Half the way there and back: the median of its last five plays.
    std::optional<double> latency_s{};

    bool operator==(const ConnectedPhone&) const = default;
};

struct PhoneAnswer {
    int phone = 0;
    std::string nickname;
    std::string card;  // its id
    std::string json;  // the checked "answer" object: known keys alone, of their types

    bool operator==(const PhoneAnswer&) const = default;
};

struct PhoneCards {
    std::string for_all = R"({"kind":"wait"})";
    std::map<int, std::string> for_one{};  // by the phone's number

    bool operator==(const PhoneCards&) const = default;
};

struct PhonePlay {
    std::vector<int> ms;  // empty: stop
    bool loop = false;
    PhoneSide side = PhoneSide::both;

    bool operator==(const PhonePlay&) const = default;
};

// Whether what is meant for one side is for the other, too.
inline bool is_for(PhoneSide play, PhoneSide phone) {
    return play == PhoneSide::both || phone == PhoneSide::both || play == phone;
}

// A file of the page: all that is served, from memory.
struct PageFile {
    std::string name;  // "phone.js"
    std::string type;  // "text/javascript"
    std::string text;
};

// The fields of a request's body, each of one type and bounded.
//
// Left out  where a fault is: a page is told "malformed" and no more

// An object whose known keys are taken one by one; one of a wrong type is a fault of the whole.
struct BodyFields {
    Json object;
    bool is_sound = true;

    const Json* at(const char* key) {
        const auto found = object.find(key);
        return found == object.end() ? nullptr : &*found;
    }

    std::string text(const char* key, std::size_t most_bytes) {
        const Json* value = at(key);
        if (value == nullptr) return {};
        is_sound = is_sound && value->is_string() &&
                   value->get_ref<const std::string&>().size() <= most_bytes;
        return is_sound ? value->get<std::string>() : std::string{};
    }

    bool yes_no(const char* key) {
        const Json* value = at(key);
        if (value == nullptr) return false;
        is_sound = is_sound && value->is_boolean();
        return is_sound && value->get<bool>();
    }

    std::optional<std::int64_t> whole(const char* key, std::int64_t most) {
        const Json* value = at(key);
        return value == nullptr ? std::nullopt : whole_of(*value, most);
    }

    std::optional<std::int64_t> whole_of(const Json& value, std::int64_t most) {
        const bool fits = value.is_number_unsigned() &&
                          value.get<std::uint64_t>() <= static_cast<std::uint64_t>(most);
        is_sound = is_sound && fits;
        return fits ? std::optional(value.get<std::int64_t>()) : std::nullopt;
    }
};

}  // namespace tact
