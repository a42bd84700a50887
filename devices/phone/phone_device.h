// The phones of a room as one actuator: a drive goes out as on-off times, which every phone's
// browser plays by itself (navigator.vibrate).
//
// A thread of its own sends what is new: the beginning of a play, what is left of it where its
// level or its loop changed (each kResentS at the soonest), its stop. What follows another play
// begins on that thread, to the millisecond; the way through the air is the same for both.
//
// Input     on-off times at a level: model/io/effects_out/on_off.h
// Valid     level, largest level and longest time as devices/device/drive.h has them
// Left out  rest_after_s, limits of rms and travel: the firmware of a phone protects its motor. The
//           way to the phones is not taken off the position: each has its own
//           (ConnectedPhone::latency_s)
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

#include "devices/device/device.h"
#include "devices/phone/phone_server.h"

namespace tact {

inline constexpr double kResentS = 0.1;
inline constexpr const char* kPhonesId = "phones";          // of all of them, in a list of devices
inline constexpr const char* kThisPhoneId = "phones/this";  // of the one that shows the page
inline bool is_phone(std::string_view id) { return id == kPhonesId || id == kThisPhoneId; }
inline constexpr const char* kNoPhone = "No phone that can vibrate is connected: scan the code";

// What a list of devices says of one of these.
DeviceInfo phone_info(const char* id, const char* name);

// The way to the phones: a server, unless a test has its own.
struct PhoneDoor {
    std::function<void(PhonePlay)> play;
    std::function<std::vector<ConnectedPhone>()> phones;
    // False: what is due is done by whoever asks for the status, on the only thread of a page.
    bool has_thread = true;
};

class PhoneDevice final : public Device {
  public:
    // Plays on phones of that side; both: on all.
    explicit PhoneDevice(const std::shared_ptr<PhoneServer>& server,
                         PhoneSide side = PhoneSide::both);
    explicit PhoneDevice(PhoneDoor door, PhoneSide side = PhoneSide::both);
    ~PhoneDevice() override;  // stops
    PhoneDevice(const PhoneDevice&) = delete;
    PhoneDevice& operator=(const PhoneDevice&) = delete;

    // Plays that begin from now on.
    void set_side(PhoneSide side);

    // Does not wait for the phones.
    Expected<Done> play(const Drive& drive, bool loop) override;
    Expected<Done> play_after(const Drive& drive, double rest_s) override;
    void change(const Drive& drive) override;
    void set_level(double level) override;
    void stop() override;
    DeviceStatus status() override;

  private:
    using Clock = std::chrono::steady_clock;

    struct Play {
        Drive drive;
        bool loop = false;
        PhoneSide side = PhoneSide::both;
        Clock::time_point begins{};
        double rest_s = 0.0;  // after the play before it, of one that waits
    };

    bool is_anyone_there(PhoneSide side) const;
    void run(const std::stop_token& quit);
    void step(Clock::time_point now);
    Clock::time_point next_moment(Clock::time_point now) const;
    Clock::time_point waiting_begins() const;
    void begin(Play play, Clock::time_point at);
    void end(Clock::time_point at, bool is_cut);
    void send(Clock::time_point now);
    double duration_s() const;
    Clock::time_point end_of_play() const;
    double position_s(Clock::time_point now) const;
    double peak_since_last(double position_s);

    const PhoneDoor door_;

    mutable std::mutex mutex_;  // guards all of these
    std::condition_variable_any changed_;
    PhoneSide side_;
    std::optional<Play> now_;
    std::vector<Play> waiting_;  // at most two, in their order
    bool is_new_ = false;        // what plays was not sent yet at all ...
    bool is_due_ = false;        // ... or not as it is now
    Clock::time_point sent_at_{};
    Clock::time_point ended_at_{};  // the last play, its tail left out
    double last_position_s_ = 0.0;
    double peak_from_s_ = 0.0;
    double level_ = 1.0;
    bool clipped_ = false;
    bool tells_end_ = false;   // by the next status, as another play follows
    std::uint64_t halts_ = 0;  // of the program, at the beginning of the play
    std::string trouble_;      // why the last play ended by itself

    std::jthread thread_;  // last: starts when all else is there
};

}  // namespace tact
