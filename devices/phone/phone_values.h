// What the program and the phones of a room tell each other, as plain values.
//
// Input     cards are JSON objects without a serial, made by the program
// Valid     `ms` of a play: on, off, on, .. in whole milliseconds; a first 0 if it begins with off
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace tact
