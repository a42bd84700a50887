#include "devices/phone/phone_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "devices/device/drive.h"
#include "devices/device/halt.h"
#include "devices/phone/on_off_times.h"
#include "model/io/effects_out/on_off.h"

namespace tact {

namespace {

constexpr std::size_t kMostWaiting = 2;

double seconds_of(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

}  // namespace

DeviceInfo phone_info(const char* id, const char* name) {
    DeviceInfo info;
    info.id = id;
    info.kind = DeviceKind::phone;
    info.name = name;
    info.interface = "web vibration: on-off times alone, no strength and no frequency";
    return info;
}

PhoneDevice::PhoneDevice(const std::shared_ptr<PhoneServer>& server, PhoneSide side)
    : PhoneDevice(PhoneDoor{[server](PhonePlay play) { server->play(std::move(play)); },
                            [server] { return server->phones(); }},
                  side) {}

PhoneDevice::PhoneDevice(PhoneDoor door, PhoneSide side) : door_(std::move(door)), side_(side) {
    if (!door_.has_thread) return;
    thread_ = std::jthread([this](const std::stop_token& quit) { run(quit); });
}

PhoneDevice::~PhoneDevice() {
    stop();
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

bool PhoneDevice::is_anyone_there(PhoneSide side) const {
    return std::ranges::any_of(door_.phones(), [side](const ConnectedPhone& phone) {
        return phone.is_here && phone.vibrates && is_for(side, phone.side);
    });
}

void PhoneDevice::set_side(PhoneSide side) {
    const std::lock_guard lock(mutex_);
    side_ = side;
}

Expected<Done> PhoneDevice::play(const Drive& drive, bool loop) {
    const std::lock_guard lock(mutex_);
    if (!is_anyone_there(side_)) return Error{kNoPhone};
    // Phones of the other side are to be still as well.
    if (now_ && now_->side != side_) door_.play({{}, false, now_->side});
    waiting_.clear();
    tells_end_ = false;
    trouble_.clear();
    begin({drive, loop, side_}, Clock::now());
    changed_.notify_one();
    return Done{};
}

Expected<Done> PhoneDevice::play_after(const Drive& drive, double rest_s) {
    const std::lock_guard lock(mutex_);
    if (!is_anyone_there(side_)) return Error{kNoPhone};
    if (waiting_.size() == kMostWaiting) waiting_.pop_back();
    waiting_.push_back({drive, false, side_, {}, std::isnan(rest_s) ? 0.0 : std::max(0.0, rest_s)});
    trouble_.clear();
    changed_.notify_one();
    return Done{};
}

void PhoneDevice::change(const Drive& drive) {
    const std::lock_guard lock(mutex_);
    if (!now_ || !now_->loop) return;
    now_->drive = drive;
    is_due_ = true;
    changed_.notify_one();
}

void PhoneDevice::set_level(double level) {
    const std::lock_guard lock(mutex_);
    if (kept_level(level) == level_) return;
    level_ = kept_level(level);
    is_due_ = now_.has_value();
    changed_.notify_one();
}

void PhoneDevice::stop() {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
    tells_end_ = false;
    if (now_) end(Clock::now(), true);
    changed_.notify_one();
}

DeviceStatus PhoneDevice::status() {
    const std::lock_guard lock(mutex_);
    if (!door_.has_thread) step(Clock::now());
    DeviceStatus status;
    status.name = "Phones";
    status.connected = is_anyone_there(side_);
    status.playing = (now_ || !waiting_.empty()) && !std::exchange(tells_end_, false);
    status.clipped = clipped_;
    status.trouble = status.connected ? trouble_ : kNoPhone;
    status.position_s = now_ ? position_s(Clock::now()) : last_position_s_;
    if (now_) status.peak = peak_since_last(status.position_s);
    return status;
}

double PhoneDevice::position_s(Clock::time_point now) const {
    const Drive& drive = now_->drive;
    const double since_s = std::max(0.0, seconds_of(now - now_->begins));
    const double whole_s = duration_s();
    const double meant_s = std::max(0.0, whole_s - drive.lead_s - drive.tail_s);
    const double at_s = now_->loop && whole_s > 0.0 ? std::fmod(since_s, whole_s) : since_s;
    return std::clamp(at_s - drive.lead_s, 0.0, meant_s);
}

// The largest of the drive between the last status and this one; all of it where a loop began
// again meanwhile.
double PhoneDevice::peak_since_last(double position_s) {
    const Drive& drive = now_->drive;
    const auto sample = [&](double at_s) {
        const double at = std::max(0.0, (at_s + drive.lead_s) * drive.rate_hz);
        return std::min(drive.samples.size(), static_cast<std::size_t>(at));
    };
    double from_s = std::exchange(peak_from_s_, position_s);
    if (from_s > position_s) from_s = 0.0;
    double peak = 0.0;
    for (std::size_t k = sample(from_s); k < sample(position_s); ++k) {
        if (std::isfinite(drive.samples[k])) peak = std::max(peak, std::abs(drive.samples[k]));
    }
    return std::min(1.0, peak * kept_level(level_, drive.largest_level));
}

// When a device of phones sends what: its thread.

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
