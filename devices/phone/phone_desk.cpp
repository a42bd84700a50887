#include "devices/phone/phone_desk.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <utility>

#include "devices/phone/phone_names.h"
#include "model/text/json_fields.h"

namespace tact {

namespace {

auto has_number(int number) {
    return [number](const auto& phone) { return phone->shown.number == number; };
}

}  // namespace

double steady_now_s() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

// A whole class may come at once.
PhoneDesk::PhoneDesk(std::size_t most_phones, std::function<void()> news,
                     std::function<double()> now_s)
    : most_phones_(most_phones),
      joins_size_{20.0, static_cast<double>(most_phones + 50)},
      news_(std::move(news)),
      now_s_(std::move(now_s)),
      joins_(full_bucket(joins_size_, now_s_())),
      card_for_all_(std::make_shared<const std::string>(cards_.for_all)) {
    latest_.fill(std::make_shared<const GivenPlay>());
}

void PhoneDesk::tell_news() const {
    if (news_) news_();
}

// Looks at all of them: how long it takes tells nothing of a secret.
PhoneDesk::Phone PhoneDesk::phone_with(const std::string& secret) const {
    Phone found;
    for (const Phone& phone : phones_) {
        if (is_same_secret(phone->secret, secret)) found = phone;
    }
    return found;
}

// What plays on the other side is stopped on this phone; a loop of its own side begins.
void PhoneDesk::set_side(int number, PhoneSide side) {
    {
        const std::lock_guard lock(mutex_);
        const auto found = std::ranges::find_if(phones_, has_number(number));
        if (found == phones_.end() || (*found)->shown.side == side) return;
        PhoneState& phone = **found;
        phone.shown.side = side;
        const GivenPlayPtr& latest = latest_for(side);
        if (latest != phone.play && (latest->play.loop || !phone.play->play.ms.empty())) {
            phone.play = latest->play.loop ? latest : std::make_shared<const GivenPlay>();
            ++phone.play_serial;
            phone.changed.notify_all();
        }
    }
    tell_news();
}

void PhoneDesk::close_phone(int number) {
    {
        const std::lock_guard lock(mutex_);
        const auto found = std::ranges::find_if(phones_, has_number(number));
        if (found == phones_.end()) return;
        (*found)->is_closed = true;
        (*found)->changed.notify_all();
        phones_.erase(found);
    }
    tell_news();
}

void PhoneDesk::close() {
    const std::lock_guard lock(mutex_);
    is_closed_ = true;
    for (const Phone& phone : phones_) {
        phone->is_closed = true;
        phone->changed.notify_all();
    }
}

std::vector<ConnectedPhone> PhoneDesk::phones() const {
    const std::lock_guard lock(mutex_);
    const double now_s = now_s_();
    std::vector<ConnectedPhone> shown;
    for (const Phone& phone : phones_) shown.push_back(shown_now(*phone, now_s));
    return shown;
}

// How phones come to the desk: new ones, those that come back, and whether there is a place.

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

// What goes round between the program and the phones: cards, plays, answers.

namespace {

constexpr int kNotItsCard = 409;
constexpr int kTaken = 204;

}  // namespace

PhoneReply PhoneDesk::next(const NextRequest& request, double wait_s) {
    std::unique_lock lock(mutex_);
    const Phone phone = is_closed_ ? nullptr : phone_with(request.phone);
    if (!phone) return {kPhoneGone, {}};
    const double now_s = now_s_();
    const bool was_away = now_s - std::exchange(phone->asked_at_s, now_s) > kHereS;
    if (!take_token(phone->requests, kRequestsOfPhone, now_s)) return {kTooManyRequests, {}};
    if (was_away) lock.unlock(), tell_news(), lock.lock();
    const std::uint64_t poll = ++phone->polls;
    phone->changed.notify_all();
    phone->changed.wait_for(lock, std::chrono::duration<double>(wait_s), [&] {
        return phone->is_closed || phone->polls != poll || phone->card_serial != request.card ||
               phone->play_serial != request.play;
    });
    if (phone->is_closed) return {kPhoneGone, {}};
    const double then_s = now_s_();
    phone->asked_at_s = then_s;
    if (phone->play_serial != request.play) {
        phone->sent_serial = phone->play->play.ms.empty() ? 0 : phone->play_serial;
        phone->sent_at_s = then_s;
    }
    return {200, news_for(*phone, request.card, request.play, then_s)};
}

PhoneReply PhoneDesk::tell(const TellRequest& request, double handshake_s) {
    PhoneReply reply{kTaken, {}};
    {
        const std::lock_guard lock(mutex_);
        const Phone phone = is_closed_ ? nullptr : phone_with(request.phone);
        if (!phone) return {kPhoneGone, {}};
        const double now_s = now_s_();
        phone->asked_at_s = now_s;
        if (!take_token(phone->requests, kRequestsOfPhone, now_s)) return {kTooManyRequests, {}};
        if (!request.played) {
            reply = take_answer(*phone, request);
        } else if (!note_played(*phone, *request.played, now_s, handshake_s)) {
            return reply;
        }
    }
    if (reply.status == kTaken) tell_news();
    return reply;
}

PhoneReply PhoneDesk::take_answer(const PhoneState& phone, const TellRequest& request) {
    if (phone.card_id.empty() || phone.card_id != request.card) return {kNotItsCard, {}};
    if (answers_.size() >= kMostAnswers) return {kTooManyRequests, {}};
    answers_.push_back({phone.shown.number, phone.shown.nickname, request.card, request.answer});
    return {kTaken, {}};
}

std::vector<PhoneAnswer> PhoneDesk::take_answers() {
    const std::lock_guard lock(mutex_);
    return std::exchange(answers_, {});
}

void PhoneDesk::show(PhoneCards cards) {
    const std::lock_guard lock(mutex_);
    if (cards == cards_) return;
    if (cards.for_all != cards_.for_all) {
        card_for_all_ = std::make_shared<const std::string>(cards.for_all);
    }
    cards_ = std::move(cards);
    for (const Phone& phone : phones_) give_card(*phone);
}

void PhoneDesk::show_one(int number, std::string card, bool is_there) {
    const std::lock_guard lock(mutex_);
    std::string& own = cards_.for_one[number];
    own = std::move(card);
    for (const Phone& phone : phones_) {
        if (phone->shown.number != number) continue;
        if (!is_there) return give_card(*phone);
        phone->card = std::make_shared<const std::string>(own);
        phone->card_id = id_of_card(own);
    }
}

// Its serial rises only if its own card is another one.
void PhoneDesk::give_card(PhoneState& phone) const {
    const auto own = cards_.for_one.find(phone.shown.number);
    const bool is_own = own != cards_.for_one.end();
    const std::string& text = is_own ? own->second : *card_for_all_;
    if (phone.card && *phone.card == text) return;
    if (phone.card) ++phone.card_serial;
    phone.card = is_own ? std::make_shared<const std::string>(text) : card_for_all_;
    phone.card_id = id_of_card(text);
    phone.changed.notify_all();
}

const GivenPlayPtr& PhoneDesk::latest_for(PhoneSide side) const {
    return latest_[static_cast<std::size_t>(side)];
}

void PhoneDesk::play(PhonePlay play) {
    const std::lock_guard lock(mutex_);
    const auto given = std::make_shared<GivenPlay>();
    given->begun_s = now_s_();
    given->json = GivenPlay::play_fields(play.ms, play.loop);
    given->play = std::move(play);
    for (const PhoneSide side : {PhoneSide::both, PhoneSide::a, PhoneSide::b}) {
        if (is_for(given->play.side, side)) latest_[static_cast<std::size_t>(side)] = given;
    }
    for (const Phone& phone : phones_) {
        if (!is_for(given->play.side, phone->shown.side)) continue;
        phone->play = given;
        ++phone->play_serial;
        phone->changed.notify_all();
    }
}

}  // namespace tact
