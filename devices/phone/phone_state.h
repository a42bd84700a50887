// What the desk (phone_desk.h) keeps of each phone, and what it tells it.
//
// A phone has a serial for its card and one for its play: the page says which it has, and what is
// new has a larger one.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/http/token_bucket.h"
#include "devices/phone/phone_values.h"

namespace tact {

inline constexpr double kHereS = 30.0;       // since it asked: it is still there
inline constexpr double kFreshPlayS = 0.25;  // a play that is later begins where it would be by now
inline constexpr std::size_t kMedianOf = 5;  // ways there and back
inline constexpr double kLongestWayS = 10.0;  // what takes longer measures something else

// A play that was given out, shared by all phones that have it.
struct GivenPlay {
    PhonePlay play{};
    double begun_s = 0.0;
    std::string json = play_fields(play.ms, false);  // without its serial

    static std::string play_fields(const std::vector<int>& ms, bool loop);
};

using GivenPlayPtr = std::shared_ptr<const GivenPlay>;

struct PhoneState {
    ConnectedPhone shown;  // but for is_here and latency_s
    std::string secret;
    bool is_closed = false;
    double asked_at_s = 0.0;
    TokenBucket requests;

    std::shared_ptr<const std::string> card;
    std::string card_id;  // empty: it has none
    std::int64_t card_serial = 1;
    GivenPlayPtr play;
    std::int64_t play_serial = 1;

    std::int64_t sent_serial = 0;  // of the last play that it was sent, until it has told of it
    double sent_at_s = 0.0;
    std::vector<double> ways_s{};  // there and back, of the last plays

    std::uint64_t polls = 0;  // the last one is answered later, those before it at once
    std::condition_variable changed{};
};

// "id" of a card, if it has one of a length that an answer may name.
std::string id_of_card(const std::string& card);

// {"card": .., "play": ..}: each whole if the page has another serial of it.
std::string news_for(const PhoneState& phone, std::int64_t card, std::int64_t play, double now_s);

// The play as it is to be felt from now on: JSON without its serial.
std::string play_now(const GivenPlay& given, double now_s);

ConnectedPhone shown_now(const PhoneState& phone, double now_s);

// The phone tells that a play has begun. `handshake_s` is no part of the way. Whether it was
// measured.
bool note_played(PhoneState& phone, std::int64_t serial, double now_s, double handshake_s);

}  // namespace tact
