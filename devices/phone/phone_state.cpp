#include "devices/phone/phone_state.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "devices/phone/on_off_times.h"
#include "devices/phone/phone_requests.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

// A JSON object with its serial before its own fields.
std::string with_serial(std::int64_t serial, std::string_view object) {
    const std::string head = "{\"serial\":" + std::to_string(serial);
    const std::size_t brace = object.find('{');
    const std::size_t first = object.find_first_not_of(" \t\r\n", brace + 1);
    if (brace == object.npos || first == object.npos || object[first] == '}') return head + "}";
    return head + "," + std::string(object.substr(first));
}

std::string serial_alone(std::int64_t serial) { return with_serial(serial, {}); }

}  // namespace

std::string GivenPlay::play_fields(const std::vector<int>& ms, bool loop) {
    std::string text = "{\"ms\":[";
    for (std::size_t k = 0; k < ms.size(); ++k) {
        text += (k > 0 ? "," : "") + std::to_string(ms[k]);
    }
    const auto word = [](bool is_so) { return is_so ? "true" : "false"; };
    return text + "],\"loop\":" + word(loop) + ",\"stop\":" + word(ms.empty()) + "}";
}

std::string id_of_card(const std::string& card) {
    const Json object = kept_json(card);
    if (!object.is_object()) return {};
    const auto id = object.find("id");
    if (id == object.end() || !id->is_string()) return {};
    const auto& text = id->get_ref<const std::string&>();
    return text.size() <= kMostCardIdBytes ? text : std::string{};
}

std::string play_now(const GivenPlay& given, double now_s) {
    const double late_s = now_s - given.begun_s;
    if (given.play.loop || late_s <= kFreshPlayS) return given.json;
    const double late_ms = std::min(1e12, 1000.0 * late_s);
    const auto left = on_off_from(given.play.ms, std::llround(late_ms), false);
    return GivenPlay::play_fields(left, false);
}

std::string news_for(const PhoneState& phone, std::int64_t card, std::int64_t play, double now_s) {
    const bool has_card = card == phone.card_serial;
    const bool has_play = play == phone.play_serial;
    return "{\"card\":" +
           (has_card ? serial_alone(card) : with_serial(phone.card_serial, *phone.card)) +
           ",\"play\":" +
           (has_play ? serial_alone(play)
                     : with_serial(phone.play_serial, play_now(*phone.play, now_s))) +
           "}";
}

ConnectedPhone shown_now(const PhoneState& phone, double now_s) {
    ConnectedPhone shown = phone.shown;
    shown.is_here = now_s - phone.asked_at_s <= kHereS;
    if (phone.ways_s.empty()) return shown;
    std::vector<double> sorted = phone.ways_s;
    std::ranges::sort(sorted);
    const std::size_t half = sorted.size() / 2;
    const double way_s =
        sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
    shown.latency_s = 0.5 * way_s;
    return shown;
}

bool note_played(PhoneState& phone, std::int64_t serial, double now_s, double handshake_s) {
    if (serial == 0 || serial != phone.sent_serial) return false;
    phone.sent_serial = 0;
    const double way_s = std::max(0.0, now_s - phone.sent_at_s - handshake_s);
    if (way_s > kLongestWayS) return false;
    if (phone.ways_s.size() == kMedianOf) phone.ways_s.erase(phone.ways_s.begin());
    phone.ways_s.push_back(way_s);
    return true;
}

}  // namespace tact
