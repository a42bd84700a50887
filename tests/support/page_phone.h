// A phone of a test that does what the page does: joins, polls, plays, answers.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/raw_phone.h"

namespace tact::raw_phone {

// A page that was opened.
struct Phone {
    Place place;
    std::string secret{};
    int number = 0;
    std::int64_t card = 0;  // serials that it has
    std::int64_t play = 0;

    Reply join(const std::string& nickname, bool vibrates = true) {
        const nlohmann::json body{
            {"nickname", nickname}, {"vibrates", vibrates}, {"language", "en"}, {"phone", secret}};
        const Reply reply = asked(place, "POST", "join", body.dump());
        if (reply.status != 200) return reply;
        const auto told = nlohmann::json::parse(reply.body);
        secret = told.at("phone");
        number = told.at("number");
        return reply;
    }
    std::string next_text() const {
        const nlohmann::json body{{"phone", secret}, {"card", card}, {"play", play}};
        return request_text("POST", place.path + "next", body.dump());
    }
    // What is new, and the serials are kept.
    nlohmann::json news_of(const Reply& reply) {
        if (reply.status != 200) return {};
        auto news = nlohmann::json::parse(reply.body);
        card = news.at("card").at("serial");
        play = news.at("play").at("serial");
        return news;
    }
    nlohmann::json next() { return news_of(sent(place, next_text())); }
    int tell(const nlohmann::json& what) const {
        nlohmann::json body = what;
        body["phone"] = secret;
        return asked(place, "POST", "tell", body.dump()).status;
    }
};

}  // namespace tact::raw_phone
