// How phones come to the desk: new ones, those that come back, and whether there is a place.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "devices/phone/phone_desk.h"
#include "devices/phone/phone_names.h"
#include "devices/phone/phone_token.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

PhoneReply welcome(const PhoneState& phone) {
    Json reply;
    reply["phone"] = phone.secret;
    reply["number"] = phone.shown.number;
    reply["nickname"] = phone.shown.nickname;
    return {200, text_of_json(reply)};
}

}  // namespace

std::set<std::string> PhoneDesk::names_but(const PhoneState* own) const {
    std::set<std::string> names;
    for (const Phone& phone : phones_) {
        if (phone.get() != own) names.insert(phone->shown.nickname);
    }
    return names;
}

PhoneReply PhoneDesk::join(const JoinRequest& request) {
    PhoneReply reply{kRoomIsFull, R"({"error":"full"})"};
    {
        const std::lock_guard lock(mutex_);
        if (is_closed_) return {kPhoneGone, {}};
        const double now_s = now_s_();
        if (!take_token(joins_, joins_size_, now_s)) return {kTooManyRequests, {}};
        const Phone known = phone_with(request.phone);
        const Phone phone = known ? come_back(request, known) : new_phone(request, now_s);
        if (!phone) return reply;
        phone->shown.vibrates = request.vibrates;
        phone->shown.language = request.language;
        phone->asked_at_s = now_s;
        reply = welcome(*phone);
    }
    tell_news();
    return reply;
}

// Its page was loaded again, and has neither card nor play.
PhoneDesk::Phone PhoneDesk::come_back(const JoinRequest& request, const Phone& phone) {
    phone->shown.nickname = unique_nickname(request.nickname, names_but(phone.get()));
    ++phone->card_serial;
    ++phone->play_serial;
    phone->changed.notify_all();
    return phone;
}

PhoneDesk::Phone PhoneDesk::new_phone(const JoinRequest& request, double now_s) {
    auto secret = random_secret();
    if (!secret || !has_room(now_s)) return nullptr;
    const auto phone = std::make_shared<PhoneState>();
    phone->shown.number = ++last_number_;
    phone->shown.nickname = unique_nickname(request.nickname, names_but(nullptr));
    phone->secret = *std::move(secret);
    phone->requests = full_bucket(kRequestsOfPhone, now_s);
    give_card(*phone);
    const GivenPlayPtr& latest = latest_for(PhoneSide::both);
    phone->play = latest->play.loop ? latest : std::make_shared<const GivenPlay>();
    phones_.push_back(phone);
    return phone;
}

// Where all places are taken, that of the phone that has been gone for longest may be free.
bool PhoneDesk::has_room(double now_s) {
    if (phones_.size() < most_phones_) return true;
    const auto longest =
        std::ranges::min_element(phones_, {}, [](const Phone& phone) { return phone->asked_at_s; });
    if (longest == phones_.end() || now_s - (*longest)->asked_at_s <= kGoneS) return false;
    (*longest)->is_closed = true;
    (*longest)->changed.notify_all();
    phones_.erase(longest);
    return true;
}

}  // namespace tact
