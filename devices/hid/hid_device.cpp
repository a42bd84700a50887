#include "devices/hid/hid_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "devices/device/drive.h"
#include "devices/device/halt.h"
#include "devices/device/playback.h"
#include "devices/hid/patient_port.h"
#include "model/common/distributions.h"

namespace tact {

namespace {

constexpr auto kRefresh = std::chrono::milliseconds(50);
constexpr auto kPresenceCheck = std::chrono::milliseconds(500);
constexpr auto kUnrestCheck = std::chrono::milliseconds(50);
constexpr auto kReopenedAfter = std::chrono::milliseconds(150);
constexpr auto kMadeReady = std::chrono::milliseconds(20);  // before what waits begins
constexpr auto kLastTries = std::chrono::seconds(1);        // at the end of the program
constexpr std::size_t kKeptLateness = 100'000;
constexpr double kLongestCountedS = 1e9;  // what is longer does not fit a clock, and never ends

std::chrono::nanoseconds nanoseconds(double seconds) {
    return std::chrono::nanoseconds(std::llround(seconds * 1e9));
}

double seconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double>(time).count();
}

double largest(const Drive& drive) {
    double peak = 0.0;
    for (const double sample : drive.samples) peak = std::max(peak, std::abs(sample));
    return peak;
}

}  // namespace

HidDevice::HidDevice(HidActuator actuator, HidPorts ports)
    : actuator_(std::move(actuator)), ports_(std::move(ports)) {
    status_.name = actuator_.name;
    status_.connected = true;
    thread_ = std::jthread([this](const std::stop_token& quit) { run(quit); });
}

HidDevice::~HidDevice() {
    *hurries_ = true;
    stop();
    thread_.request_stop();
    thread_.join();
}

Expected<Done> HidDevice::play(const Drive& drive, bool loop) {
    return ask({drive, loop, std::nullopt});
}

Expected<Done> HidDevice::play_after(const Drive& drive, double rest_s) {
    return ask({drive, false, std::max(0.0, rest_s)});
}

Expected<Done> HidDevice::ask(Play play) {
    const std::lock_guard lock(mutex_);
    if (!status_.connected) return Error{status_.trouble};
    const bool waits = play.rest_s && status_.playing && !stop_;
    (waits && next_ ? behind_ : next_) = std::move(play);
    changed_.notify_one();
    if (waits) return Done{};
    behind_.reset();
    change_.reset();
    tells_end_ = false;
    status_.playing = true;
    status_.position_s = 0.0;
    status_.clipped = false;
    status_.is_warm = false;
    status_.trouble.clear();
    return Done{};
}

// Whether there is something else to do than what plays.
bool HidDevice::is_interrupted() const { return stop_ || (next_ && !next_->rest_s); }

void HidDevice::change(const Drive& drive) {
    const std::lock_guard lock(mutex_);
    if (next_ && next_->loop) next_->drive = drive;
    if (!next_ && status_.playing && !stop_) change_ = drive;
}

void HidDevice::set_level(double level) {
    const std::lock_guard lock(mutex_);
    level_ = kept_level(level);
}

void HidDevice::stop() {
    const std::lock_guard lock(mutex_);
    next_.reset();
    behind_.reset();
    change_.reset();
    stop_ = true;
    changed_.notify_one();
}

DeviceStatus HidDevice::status() {
    const std::lock_guard lock(mutex_);
    DeviceStatus status = status_;
    status_.peak = 0.0;
    if (std::exchange(tells_end_, false)) status.playing = false;
    if (status.playing && duration_s_ > 0.0 && (!next_ || next_->rest_s)) {
        const double since_s = std::max(0.0, seconds(Clock::now() - begun_at_));
        status.position_s = loops_ ? std::fmod(since_s, duration_s_) : since_s;
        status.position_s = std::min(status.position_s, duration_s_);
    }
    return status;
}

SendStatistics HidDevice::statistics() const {
    const std::lock_guard lock(mutex_);
    SendStatistics statistics = statistics_;
    if (late_s_.empty()) return statistics;
    std::vector<double> sorted = late_s_;
    std::ranges::sort(sorted);
    statistics.median_late_s = quantile(sorted, 0.5);
    statistics.p99_late_s = quantile(sorted, 0.99);
    statistics.worst_late_s = sorted.back();
    return statistics;
}

void HidDevice::run(const std::stop_token& quit) {
    rank_before_drawing();
    while (!quit.stop_requested()) {
        if (const std::optional<Play> play = next_play(quit)) {
            take_up(*play, quit);
        } else {
            if (owes_rest_) put_to_rest(quit);
            watch();
        }
        const std::lock_guard lock(mutex_);
        if (!next_) status_.playing = false;
    }
}

// None: nothing is asked for, for some time.
std::optional<HidDevice::Play> HidDevice::next_play(const std::stop_token& quit) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, quit, owes_rest_ ? kUnrestCheck : kPresenceCheck,
                      [this] { return next_.has_value(); });
    if (next_) {
        stop_ = false;  // asked for before, or it would be there no more
        begins_at_ = after_rest(next_->rest_s.value_or(0.0));
    }
    return std::exchange(next_, std::exchange(behind_, std::nullopt));
}

// While it is played on nobody else may: two would send in turn.
void HidDevice::take_up(const Play& play, const std::stop_token& quit) {
    const Expected<ActuatorLock> alone = ports_.claim(actuator_);
    if (!alone) {
        const std::lock_guard lock(mutex_);
        status_.trouble = alone.error().message;
        return;
    }
    if (const auto is_ready = ready(); !is_ready) return lose(is_ready.error().message);
    perform(play, quit);
}

// Opens the controller and wakes it, where that is not done yet.
Expected<Done> HidDevice::ready() {
    if (port_) return Done{};
    Expected<Done> allowed = ports_.may_be_opened(actuator_);
    if (!allowed) return allowed;
    Expected<HidPort> opened = ports_.open(actuator_.path);
    if (!opened) return opened.error();
    HidPort port = patient_port(*std::move(opened), kWritePatience, hurries_);
    Expected<Encoder> encode = begin_protocol(actuator_, port);
    if (!encode) return encode.error();
    port_ = std::move(port);
    encode_ = *std::move(encode);
    last_sent_.clear();
    last_sent_at_ = Clock::now();
    port_->set_emergency_packet(encode_(RumbleFrame{}, 0));
    return Done{};
}

void HidDevice::perform(const Play& play, const std::stop_token& quit) {
    halts_ = halts();
    // A play begins at its level.
    risen_ = level_for(play.drive);
    RumblePlan plan(play.drive, traits(actuator_.kind).language, frame_hop_s(actuator_), risen_);
    if (plan.size() > 0) plan.rumble(0);
    // Interrupted while it waits it drives nothing.
    const bool begins = wait_until(begins_at_ - kMadeReady, quit);
    begin_notes(play);
    risen_at_ = Clock::now();
    if (begins && plan.size() > 0) {
        note_rest(ledger_, seconds(Clock::now() - rests_since_));
        if (!send_frames(play, plan, quit)) rests_since_ = Clock::now();
        note_driven(ledger_, seconds(rests_since_ - begins_at_));
    }
    tell_end();
    end_in_silence(quit);
}

void HidDevice::begin_notes(const Play& play) {
    const std::lock_guard lock(mutex_);
    duration_s_ = 0.0;
    status_.clipped = largest(play.drive) * level_ > 1.0;
    status_.is_warm = false;
    statistics_ = {};
    late_s_.clear();
}

// Nobody has to be told of what was stopped.
void HidDevice::tell_end() {
    const std::lock_guard lock(mutex_);
    tells_end_ = next_ && next_->rest_s && !stop_;
    if (tells_end_) duration_s_ = 0.0;
    status_.playing = next_.has_value();
}

// The level as it is now, as far as this drive may be played.
double HidDevice::level_for(const Drive& drive) {
    const std::lock_guard lock(mutex_);
    const double kept = kept_level(level_, drive.largest_level);
    status_.clipped = status_.clipped || kept < level_;
    return kept;
}

// One click is no blow, here as at an output of sound: a lower level is there at once.
double HidDevice::risen_to(double level) {
    const Clock::time_point now = Clock::now();
    risen_ = std::min(level, risen_ + seconds(now - std::exchange(risen_at_, now)) / kRiseS);
    return risen_;
}

// The new drive continues from where the loop is; if it is shorter, as if it had always played.
void HidDevice::take_change(Pass& pass, RumblePlan& plan) {
    std::optional<Drive> change;
    double level = 0.0;
    {
        const std::lock_guard lock(mutex_);
        change = std::exchange(change_, std::nullopt);
        level = level_;
    }
    if (!change) return;
    const double hop_s = frame_hop_s(actuator_);
    const double kept = kept_level(level, change->largest_level);
    plan = RumblePlan(*std::move(change), traits(actuator_.kind).language, hop_s, risen_to(kept));
    const double since_s = std::max(0.0, seconds(Clock::now() - pass.begin));
    const double at_s = std::fmod(since_s, pass.duration_s);
    const Drive& drive = plan.drive();
    pass.duration_s = static_cast<double>(drive.samples.size()) / drive.rate_hz;
    const double kept_s = std::fmod(at_s, pass.duration_s);
    pass.begin = Clock::now() - nanoseconds(kept_s);
    pass.frame = static_cast<std::size_t>(kept_s / hop_s);
    const std::lock_guard lock(mutex_);
    begun_at_ = pass.begin;
    duration_s_ = pass.duration_s;
}

// In a play that does not end, the count of frames continues from pass to pass. False: interrupted.
bool HidDevice::send_frames(const Play& play, RumblePlan& plan, const std::stop_token& quit) {
    const double hop_s = frame_hop_s(actuator_);
    Pass pass;
    pass.duration_s = static_cast<double>(plan.drive().samples.size()) / plan.drive().rate_hz;
    const auto most_s = [&] {
        const Drive& drive = plan.drive();
        return std::min(drive.longest_s, left_s(ledger_, drive.rest_after_s));
    };
    const double on_end_s = kept_s(pass.duration_s, play.loop, most_s());
    plan.rumble(0);
    pass.begin = std::max({Clock::now() + std::chrono::milliseconds(5), soonest(), begins_at_});
    begins_at_ = pass.begin;
    {
        const std::lock_guard lock(mutex_);
        begun_at_ = pass.begin;
        duration_s_ = std::min(pass.duration_s, on_end_s);
        loops_ = play.loop;
    }
    const auto deadline = [&](std::size_t k) {
        const std::size_t whole = k / plan.size();
        const auto round = static_cast<double>(whole);
        const auto hops = static_cast<double>(k % plan.size());
        return pass.begin + nanoseconds(round * pass.duration_s + hops * hop_s);
    };
    // What the loop is changed into has a limit of its own, from the start of the play.
    const auto begun = pass.begin;
    const auto end = [&] {
        const double now_s = kept_s(pass.duration_s, play.loop, most_s());
        return now_s < kLongestCountedS ? begun + nanoseconds(now_s) : Clock::time_point::max();
    };
    std::size_t& k = pass.frame;
    for (; play.loop || k < plan.size(); ++k) {
        if (play.loop) take_change(pass, plan);
        if (plan.size() == 0) break;
        const auto moment = std::max({deadline(k), soonest(), Clock::now()});
        std::size_t skipped = 0;
        for (; deadline(k + 1) <= moment && (play.loop || k < plan.size()); ++k) ++skipped;
        {
            const std::lock_guard lock(mutex_);
            statistics_.skipped += skipped;
        }
        if ((!play.loop && k >= plan.size()) || moment >= end()) break;
        prepare(plan, k % plan.size(), moment);
        if (!wait_until(moment, quit) || was_halted()) return false;
        note_lateness(deadline(k));
        if (!send_if_due(plan, k % plan.size())) return false;
    }
    if (!wait_until(end(), quit)) return false;
    rests_since_ = end();
    const double asked_s = kept_s(pass.duration_s, play.loop, plan.drive().longest_s);
    const std::lock_guard lock(mutex_);
    status_.is_warm = seconds(Clock::now() - begun) < asked_s - hop_s;
    return true;
}

// Makes frame k, and as many after it as the time until its deadline is good for: later ones may
// take longer than a period.
void HidDevice::prepare(RumblePlan& plan, std::size_t k, Clock::time_point deadline) {
    Clock::duration longest{};
    for (; k < plan.size(); ++k) {
        const Clock::time_point begin = Clock::now();
        plan.rumble(k);
        longest = std::max(longest, Clock::now() - begin);
        if (Clock::now() + 2 * longest > deadline) return;
    }
}

// The earliest time of the next packet: a period after the last one.
HidDevice::Clock::time_point HidDevice::soonest() const {
    return last_sent_at_ + nanoseconds(packet_period_s(actuator_));
}

// False when there is something else to do.
bool HidDevice::wait_until(Clock::time_point moment, const std::stop_token& quit) {
    std::unique_lock lock(mutex_);
    const auto interrupted = [this] { return is_interrupted(); };
    if (changed_.wait_until(lock, quit, moment, interrupted)) return false;
    return !quit.stop_requested();
}

void HidDevice::note_lateness(Clock::time_point deadline) {
    const std::lock_guard lock(mutex_);
    if (late_s_.size() < kKeptLateness) late_s_.push_back(seconds(Clock::now() - deadline));
}

// False when the controller is lost.
bool HidDevice::send_if_due(RumblePlan& plan, std::size_t k) {
    plan.set_level(risen_to(level_for(plan.drive())));
    const RumbleFrame now = plan.rumble(k);
    {
        const std::lock_guard lock(mutex_);
        status_.peak = std::max({status_.peak, now.low, now.high});
    }
    const bool same = encode_(now, 0) == last_sent_;
    if (same && Clock::now() - last_sent_at_ < kRefresh) return true;
    return send(now);
}

bool HidDevice::send(const RumbleFrame& frame) {
    owes_rest_ = true;
    bool taken = write(frame);
    // Through the air one may be refused for the moment.
    if (!taken && port_->is_there()) taken = write(frame);
    ++counter_;
    last_sent_ = encode_(frame, 0);
    if (!taken) {
        port_->is_there() ? fail(actuator_.name + " takes no packets any more: connect it again")
                          : lose(actuator_.name + " was unplugged, or is out of reach");
        return false;
    }
    const std::lock_guard lock(mutex_);
    ++statistics_.sent;
    return true;
}

bool HidDevice::was_halted() {
    if (halts() == halts_) return false;
    fail(actuator_.name + kHalted);
    return true;
}

// The one place that writes, after the gap that there has to be.
bool HidDevice::write(const RumbleFrame& frame) {
    std::this_thread::sleep_until(soonest());
    const bool taken = port_->write(encode_(frame, counter_));
    last_sent_at_ = Clock::now();
    return taken;
}

// Whether what is to be played next ends this one as well: at once, or as its moment comes.
bool HidDevice::leaves_room(int neutral) {
    const std::lock_guard lock(mutex_);
    if (!next_ || !next_->rest_s) return next_ && neutral > 0;
    const auto period = nanoseconds(packet_period_s(actuator_));
    return std::max(soonest(), Clock::now()) + period > after_rest(*next_->rest_s);
}

HidDevice::Clock::time_point HidDevice::after_rest(double rest_s) const {
    return rests_since_ + nanoseconds(std::min(rest_s, kLongestCountedS));
}

// Also when the program ends: hence no waiting by a condition that is true already.
void HidDevice::end_in_silence(const std::stop_token& quit) {
    const Clock::time_point since = Clock::now();
    int refused = 0;
    for (int k = 0; port_ && k < kNeutralPackets;) {
        if (!quit.stop_requested() && leaves_room(k + refused)) return;
        const bool taken = write(RumbleFrame{});
        last_sent_ = encode_(RumbleFrame{}, 0);
        if (taken) {
            ++counter_;
            ++k;
        } else if (is_given_up(++refused, since, quit)) {
            return;
        }
        const std::lock_guard lock(mutex_);
        statistics_.sent += taken ? 1 : 0;
        status_.playing = next_.has_value();
    }
    if (port_) owes_rest_ = false;
}

// Whether this port is of no use any more, or there is no time. The old node of a controller
// plugged in again meanwhile refuses everything: the new one is opened.
bool HidDevice::is_given_up(int refused, Clock::time_point since, const std::stop_token& quit) {
    if (!port_->is_there()) {
        lose(actuator_.name + " was unplugged, or is out of reach");
        return true;
    }
    if (refused == 1 && status().trouble.empty()) {
        fail(actuator_.name + " takes no packets any more: connect it again");
    }
    const Clock::duration tried = Clock::now() - since;
    if (quit.stop_requested()) return tried > kLastTries;
    if (refused > 1 && tried > kReopenedAfter) port_.reset();
    return !port_;
}

}  // namespace tact
