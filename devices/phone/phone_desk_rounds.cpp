// What goes round between the program and the phones: cards, plays, answers.
#include <algorithm>
#include <chrono>
#include <utility>

#include "devices/phone/phone_desk.h"

namespace tact {

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
