#include "devices/phone/phone_desk.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "devices/phone/phone_token.h"

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

}  // namespace tact
