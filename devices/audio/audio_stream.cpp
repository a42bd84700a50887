#include "devices/audio/audio_stream.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <thread>
#include <utility>

#include "devices/audio/audio_host.h"
#include "devices/device/drive.h"
#include "devices/device/halt.h"

namespace tact {

namespace {

// A fresh PulseAudio sink was seen to start 1.3 s late.
constexpr double kStallS = 3.0;
constexpr double kLongestPollS = 0.1;
constexpr auto kClosePatience = std::chrono::seconds(1);
// Between two patterns the card stays open: the next one starts at once. Where they are to be so
// far apart, so much longer: what keeps the pause is the stream.
constexpr double kLingerS = 1.5;
constexpr auto kCutPatience = std::chrono::milliseconds(200);

}  // namespace

std::uint64_t AudioStream::ask() {
    const std::lock_guard lock(mutex_);
    trouble_.clear();
    halts_ = halts();
    const std::uint64_t serial = ++asked_;
    superseded_ = serial;
    plays_ = {{serial}};
    has_told_end_ = false;
    return serial;
}

// Behind what plays. An end that was told is not told twice.
std::uint64_t AudioStream::ask_after() {
    const std::lock_guard lock(mutex_);
    const bool is_over = plays_.empty() || has_told_end_ || plays_.front().serial <= stopped_;
    if (is_over) {
        trouble_.clear();
        halts_ = halts();
        plays_.clear();
    }
    has_told_end_ = false;
    plays_.push_back({++asked_});
    return plays_.back().serial;
}

void AudioStream::keep_change(const Drive& drive) {
    const std::lock_guard lock(mutex_);
    change_ = {drive, asked_.load()};
}

// A change that came while the one before it was made ready takes the place of that.
void AudioStream::change() {
    std::optional<Change> change;
    {
        const std::lock_guard lock(mutex_);
        change = std::exchange(change_, std::nullopt);
    }
    const auto is_over = [&] {
        return change->serial <= stopped_.load() || change->serial < superseded_.load();
    };
    if (!change || is_over() || !port_ || !clip_) return;
    if (clip_->serial != change->serial || !clip_->loop) return;
    const Drive& drive = change->drive;
    auto clip = std::make_unique<Clip>(clip_of(drive, playback_.layout.rate_hz, true));
    clip->serial = change->serial;
    start(std::move(clip), static_cast<double>(drive.samples.size()) / drive.rate_hz);
    if (is_over()) playback_.wanted.store(nullptr);
}

void AudioStream::set_level(double level) {
    playback_.level.store(static_cast<float>(kept_level(level)), std::memory_order_relaxed);
}

void AudioStream::stop() {
    stopped_.store(asked_.load());
    playback_.wanted.store(nullptr);
    playback_.cut.store(Cut::asked);
}

DeviceStatus AudioStream::status() {
    DeviceStatus status;
    status.name = place_.name;
    status.connected = connected_.load();
    status.peak = static_cast<double>(playback_.peak.exchange(0.0F));
    const std::lock_guard lock(mutex_);
    status.trouble = trouble_;
    if (plays_.empty()) return status;
    status = status_of(plays_.front(), std::move(status));
    has_told_end_ = !status.playing && plays_.size() == 1;
    if (!status.playing && plays_.size() > 1) plays_.erase(plays_.begin());
    return status;
}

DeviceStatus AudioStream::status_of(const Asked& asked, DeviceStatus status) {
    if (playback_.begun.load() >= asked.serial) {
        const PlayNotes& notes = notes_of(playback_, asked.serial);
        status.clipped = notes.clipped.load();
        status.dropouts = notes.dropouts.load();
        status.kept = static_cast<double>(notes.kept.load());
        status.is_warm = notes.is_warm.load();
    }
    if (stopped_.load() >= asked.serial || !status.trouble.empty()) return status;
    status.playing = true;
    if (playback_.begun.load() < asked.serial) return status;
    const PlayNotes& notes = notes_of(playback_, asked.serial);
    const double now_s = steady_s() - place_.latency_offset_s;
    const double since_s = now_s - notes.origin_s.load() - asked.lead_s;
    const bool has_ended = playback_.ended.load() >= asked.serial;
    // Rendered is not yet felt.
    const bool is_felt = !has_ended || now_s < notes.end_s.load();
    if (asked.looping) {
        status.playing = is_felt;
        // Before the first round is heard it cannot be at its end.
        if (asked.duration_s <= 0.0 || (since_s < 0.0 && notes.rounds.load() == 0)) return status;
        const double rest_s = std::fmod(since_s, asked.duration_s);
        status.position_s = rest_s < 0.0 ? rest_s + asked.duration_s : rest_s;
        return status;
    }
    status.position_s = std::clamp(since_s, 0.0, asked.duration_s);
    status.playing = !has_ended || (is_felt && since_s < asked.duration_s);
    return status;
}

bool AudioStream::play(AudioHost& host, const Drive& drive, bool loop, std::uint64_t serial,
                       std::optional<double> rest_s) {
    rest_before_halts();
    if (serial <= stopped_.load() || serial < superseded_.load()) return port_.has_value();
    if (rest_s && has_one_waiting()) {
        behind_ = Behind{drive, serial, *rest_s};
        return true;
    }
    behind_.reset();
    linger_s_ = kLingerS + rest_s.value_or(0.0);
    if (port_) settle_cut();
    const bool is_new = !port_;
    if (!port_) {
        note_rest(playback_.ledger, steady_s() - polled_at_s_);  // no callback runs
        const Expected<Done> opened = open(host);
        connected_ = static_cast<bool>(opened);
        if (!opened) {
            tell(opened.error().message);
            return false;
        }
    }
    begin(drive, loop, serial, rest_s, is_new);
    return true;
}

// The callback knows one clip besides the one that plays: a further one comes when that has begun.
bool AudioStream::has_one_waiting() const {
    return port_ && clip_ && playback_.begun.load() < clip_->serial &&
           clip_->serial > stopped_.load();
}

void AudioStream::take_behind() {
    if (!behind_ || has_one_waiting()) return;
    const Behind next = *std::exchange(behind_, std::nullopt);
    if (next.serial <= stopped_.load() || next.serial < superseded_.load()) return;
    linger_s_ = kLingerS + next.rest_s;
    begin(next.drive, false, next.serial, next.rest_s, false);
}

void AudioStream::begin(const Drive& drive, bool loop, std::uint64_t serial,
                        std::optional<double> rest_s, bool is_new) {
    const double rate_hz = playback_.layout.rate_hz;
    auto clip = std::make_unique<Clip>(rest_s && clip_ ? clip_after(drive, rate_hz, *rest_s, *clip_)
                                                       : clip_of(drive, rate_hz, loop));
    if (is_new && rest_s) wait_out(*clip, *rest_s);
    clip->serial = serial;
    const double duration_s = static_cast<double>(drive.samples.size()) / drive.rate_hz;
    start(std::move(clip), duration_s - drive.lead_s - drive.tail_s);
    // Stopped while it was being made ready.
    if (serial <= stopped_.load()) playback_.wanted.store(nullptr);
}

// What is left of a pause that began on a stream which is closed: never shorter than asked for, and
// longer by what opening it takes.
void AudioStream::wait_out(Clip& clip, double rest_s) const {
    const double left_s = last_end_s_ + rest_s - steady_s() - playback_.layout.latency_s;
    clip.waits = true;
    clip.rest_frames = std::llround(std::max(0.0, left_s) * playback_.layout.rate_hz);
}

// A stop that is still to be answered would take the next clip along.
void AudioStream::settle_cut() {
    const auto until = std::chrono::steady_clock::now() + kCutPatience;
    while (playback_.cut == Cut::asked && std::chrono::steady_clock::now() < until) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (playback_.cut != Cut::none) close();
}

void AudioStream::start(std::unique_ptr<const Clip> clip, double duration_s) {
    {
        const std::lock_guard lock(mutex_);
        for (Asked& asked : plays_) {
            if (asked.serial == clip->serial) {
                asked = {clip->serial, duration_s, clip->lead_s, clip->loop};
            }
        }
    }
    playback_.wanted.store(clip.get());
    if (clip_) retired_.push_back({std::move(clip_), playback_.calls.load()});
    clip_ = std::move(clip);
}

// A call that was under way when a clip was replaced may still have taken it up; the second one
// after that has not.
void AudioStream::free_clips() {
    // In this order: what a later call takes up or lets go is then seen in one of the three.
    const std::uint64_t calls = playback_.calls.load();
    const Clip* held = playback_.held.load();
    const Clip* under = playback_.held_under.load();
    std::erase_if(retired_, [&](const Retired& retired) {
        const bool is_held = retired.clip.get() == held || retired.clip.get() == under;
        return !is_held && calls >= retired.at_call + 2;
    });
}

// By what sounds, whatever name it was chosen by: an output of a sound server has several.
Expected<Done> AudioStream::claim_channels() {
    const std::string& output = place_.server_output;
    const std::string id = output.empty() ? place_.id : "server " + output;
    locks_.clear();
    for (std::size_t channel = 0; channel < place_.channels; ++channel) {
        if (!place_.everywhere && channel != place_.channel) continue;
        Expected<ActuatorLock> lock =
            ActuatorLock::of(id + " " + std::to_string(channel), place_.name);
        if (!lock) return locks_.clear(), lock.error();
        locks_.push_back(*std::move(lock));
    }
    return Done{};
}

// No callback runs: all of it may be made again.
void AudioStream::lay_out(double rate_hz) {
    playback_.layout = {rate_hz, place_.channels, place_.channel, kCeiling, place_.everywhere};
    playback_.own = {};
    playback_.wanted = nullptr;
    playback_.held = nullptr;
    playback_.quiet_frames = 0;
    playback_.cut = Cut::none;
}

// From now on callbacks are counted, and missed.
void AudioStream::note_calls() {
    seen_calls_ = playback_.calls;
    polled_at_s_ = steady_s();
    stalled_s_ = 0.0;
}

// In time that this thread was awake: a program that was halted has not lost its card.
bool AudioStream::has_stalled() {
    const std::uint64_t calls = playback_.calls.load();
    const double now_s = steady_s();
    stalled_s_ += std::clamp(now_s - polled_at_s_, 0.0, kLongestPollS);
    if (calls != seen_calls_) stalled_s_ = 0.0;
    seen_calls_ = calls;
    polled_at_s_ = now_s;
    return stalled_s_ > kStallS;
}

// The word first: a library may wait for a server that was killed.
StreamState AudioStream::lose(const std::string& why) {
    if (is_sounding()) {
        connected_ = false;
        tell(place_.name + why);
    }
    if (!port_->may_hang) return close(), StreamState::closed;
    const auto closed = std::make_shared<std::promise<void>>();
    std::future<void> is_closed = closed->get_future();
    std::thread([port = *std::exchange(port_, std::nullopt), closed] {
        port.close();
        closed->set_value();
    }).detach();
    if (is_closed.wait_for(kClosePatience) != std::future_status::ready) return StreamState::stuck;
    close();
    return StreamState::closed;
}

// A halted program renders nothing, and a server may then repeat its last sound for good. A play
// from before the halt does not come back when the program continues.
void AudioStream::rest_if_halted() {
    if (halts() == halts_.load() || !is_sounding()) return;
    tell(place_.name + kHalted);  // first: what ends without a word is followed by the next one
    stop();
}

bool AudioStream::is_sounding() const {
    if (!port_ || !clip_ || playback_.ended.load() >= clip_->serial) return false;
    return playback_.begun.load() >= clip_->serial || clip_->serial > stopped_.load();
}

StreamState AudioStream::poll() {
    if (!port_) return StreamState::closed;
    rest_if_halted();
    if (playback_.cut == Cut::done) {
        close();
        return StreamState::closed;
    }
    if (!port_->is_active() || has_stalled()) {
        // The callback may have cut it since.
        if (playback_.cut == Cut::done) return close(), StreamState::closed;
        return lose(" is gone: it stopped taking sound, and nothing plays until it is back");
    }
    free_clips();
    take_behind();
    if (is_sounding()) last_end_s_ = steady_s() + playback_.layout.latency_s;
    const double quiet_s =
        static_cast<double>(playback_.quiet_frames.load()) / playback_.layout.rate_hz;
    const double enough_s = released_ ? kPadS + playback_.layout.latency_s : linger_s_;
    if (is_sounding() || quiet_s < enough_s) return StreamState::open;
    close();
    return StreamState::closed;
}

void AudioStream::release() {
    released_ = true;
    stop();
}

// What is left to be played is silence: no need to wait for it.
void AudioStream::close() {
    if (port_) port_->close();
    port_.reset();
    playback_.wanted = nullptr;
    clip_.reset();
    behind_.reset();
    retired_.clear();
    locks_.clear();
}

void AudioStream::tell(const std::string& trouble) {
    const std::lock_guard lock(mutex_);
    trouble_ = trouble;
}

}  // namespace tact
