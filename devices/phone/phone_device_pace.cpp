// When a device of phones sends what: its thread.
#include <algorithm>
#include <cmath>
#include <utility>

#include "devices/device/bounds.h"
#include "devices/device/halt.h"
#include "devices/phone/on_off_times.h"
#include "devices/phone/phone_device.h"
#include "model/io/effects_out/on_off.h"

namespace tact {

namespace {

using PaceClock = std::chrono::steady_clock;

constexpr auto kHaltCheck = std::chrono::milliseconds(20);
constexpr double kLongestPaceS = 1e6;  // what is longer does not end while a phone is there

PaceClock::duration pace_of(double seconds) {
    const double kept_s = std::clamp(seconds, -kLongestPaceS, kLongestPaceS);
    return std::chrono::nanoseconds(std::llround(1e9 * kept_s));
}

std::int64_t pace_ms(PaceClock::duration time) {
    return std::chrono::round<std::chrono::milliseconds>(time).count();
}

}  // namespace

void PhoneDevice::run(const std::stop_token& quit) {
    std::unique_lock lock(mutex_);
    while (!quit.stop_requested()) {
        step(Clock::now());
        if (!now_ && waiting_.empty()) {
            changed_.wait(lock, quit, [this] { return now_ || !waiting_.empty(); });
            continue;
        }
        const Clock::time_point moment = next_moment(Clock::now());
        changed_.wait_until(lock, quit, moment, [this] { return is_new_; });
    }
}

void PhoneDevice::step(Clock::time_point now) {
    if (now_ && halts() != halts_) {
        waiting_.clear();
        trouble_ = std::string("Phones") + kHalted;
        end(now, true);
    }
    if (now_ && !is_new_ && now >= end_of_play()) {
        const double whole_s = duration_s();
        const bool is_cut = kept_s(whole_s, now_->loop, now_->drive.longest_s) < whole_s;
        tells_end_ = !waiting_.empty();
        end(end_of_play(), is_cut || now_->loop);
    }
    if (!waiting_.empty() && !now_ && now >= waiting_begins()) {
        const Clock::time_point at = waiting_begins();
        Play next = std::move(waiting_.front());
        waiting_.erase(waiting_.begin());
        begin(std::move(next), std::max(at, now - kHaltCheck));
    }
    if (now_ && (is_new_ || (is_due_ && now >= sent_at_ + pace_of(kResentS)))) send(now);
}

// When there is something to do, or a halt to be looked for.
PhoneDevice::Clock::time_point PhoneDevice::next_moment(Clock::time_point now) const {
    Clock::time_point moment = now + kHaltCheck;
    if (now_) moment = std::min(moment, end_of_play());
    if (now_ && is_due_) moment = std::min(moment, sent_at_ + pace_of(kResentS));
    if (!now_ && !waiting_.empty()) moment = std::min(moment, waiting_begins());
    return moment;
}

PhoneDevice::Clock::time_point PhoneDevice::waiting_begins() const {
    const Play& next = waiting_.front();
    return ended_at_ + pace_of(next.rest_s - next.drive.lead_s);
}

void PhoneDevice::begin(Play play, Clock::time_point at) {
    now_ = std::move(play);
    now_->begins = at;
    is_new_ = true;
    peak_from_s_ = 0.0;
    halts_ = halts();
}

// The end of what is meant: what follows is counted from there.
void PhoneDevice::end(Clock::time_point at, bool is_cut) {
    last_position_s_ = position_s(at);
    if (is_cut) door_.play({{}, false, now_->side});
    ended_at_ = at;
    now_.reset();
    is_new_ = is_due_ = false;
}

double PhoneDevice::duration_s() const {
    const Drive& drive = now_->drive;
    return drive.rate_hz > 0.0 ? static_cast<double>(drive.samples.size()) / drive.rate_hz : 0.0;
}

PhoneDevice::Clock::time_point PhoneDevice::end_of_play() const {
    const Drive& drive = now_->drive;
    const double whole_s = duration_s();
    const double tail_s = now_->loop ? 0.0 : std::clamp(drive.tail_s, 0.0, whole_s);
    return now_->begins + pace_of(kept_s(whole_s - tail_s, now_->loop, drive.longest_s));
}

// What is left of the play, as it is at its present level.
void PhoneDevice::send(Clock::time_point now) {
    const Drive& drive = now_->drive;
    const double level = kept_level(level_, drive.largest_level);
    clipped_ = level < level_;
    const auto whole_ms = static_cast<std::int64_t>(std::ceil(1000.0 * duration_s()));
    auto ms = padded_on_off(on_off_of_drive(drive.samples, drive.rate_hz, level).ms,
                            now_->loop ? whole_ms : 0);
    const bool is_begun = !std::exchange(is_new_, false);
    if (is_begun)
        ms = on_off_from(ms, std::max(std::int64_t{0}, pace_ms(now - now_->begins)), now_->loop);
    door_.play({std::move(ms), now_->loop, now_->side});
    is_due_ = false;
    sent_at_ = now;
}

}  // namespace tact
