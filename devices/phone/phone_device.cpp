#include "devices/phone/phone_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "devices/device/bounds.h"

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

}  // namespace tact
