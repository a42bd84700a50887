// A game controller that plays a drive signal, packet by packet.
//
// A thread of its own opens the controller at the first play, and sends. Frame k of a pass has its
// deadline k hops after the beginning of the pass, whatever happened to those before it. Between
// any two packets lies at least the period that the controller stands: over the seam of a loop,
// from one play to the next, before and between neutral ones. What goes out is the frame of that
// moment; those that the wait has passed by are skipped rather than queued, as the controller has
// no clock to catch up with. A packet goes out when it differs from the last, or after 50 ms, so
// that the controller does not think it forgotten. A play ends, by itself, by stop() or with the
// device, with five neutral packets: the first of them comes a period after the last packet at the
// latest. Where they are not taken they are sent again and again, as long as the controller is
// there, and at once when it is back; a write that does not return is left to itself. From the
// first packet of a play to the last the controller is this program's alone; how strong and for how
// long a drive may be holds here as for an output (devices/device/drive.h), and for plays in turn
// (devices/device/ledger.h).
//
// Source    the pace of the drivers that rumble_packets.h names
// Left out  two plays at a time; the time that a packet takes through the air. What opens a
//           controller goes by its answers, what a crash says last (emergency_packet.h) by nothing.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "devices/device/actuator_lock.h"
#include "devices/device/device.h"
#include "devices/device/ledger.h"
#include "devices/hid/hid_actuator.h"
#include "devices/hid/hid_port.h"
#include "devices/hid/hid_protocol.h"
#include "devices/rumble/rumble_plan.h"

namespace tact {

// How the packets of the last play went out.
struct SendStatistics {
    std::size_t sent = 0;
    std::size_t skipped = 0;  // frames whose time was over
    double median_late_s = 0.0;
    double p99_late_s = 0.0;
    double worst_late_s = 0.0;

    bool operator==(const SendStatistics&) const = default;
};

// Neutral packets that end a play: one may be lost.
inline constexpr int kNeutralPackets = 5;

// The way to the controllers: the real one, unless a test has its own.
struct HidPorts {
    std::function<std::vector<HidActuator>()> list = hid_actuators;
    std::function<Expected<Done>(const HidActuator&)> may_be_opened = tact::may_be_opened;
    std::function<Expected<HidPort>(const std::string& path)> open = open_hid_port;
    std::function<Expected<ActuatorLock>(const HidActuator&)> claim = [](const HidActuator& which) {
        return ActuatorLock::of(lasting_id(which), which.name);
    };
};

class HidDevice final : public Device {
  public:
    // Opens nothing yet.
    explicit HidDevice(HidActuator actuator, HidPorts ports = {});
    ~HidDevice() override;  // after the neutral packets
    HidDevice(const HidDevice&) = delete;
    HidDevice& operator=(const HidDevice&) = delete;

    // Does not wait for the controller: what happens then is in the status.
    Expected<Done> play(const Drive& drive, bool loop) override;
    // Its first packet goes out at that moment, where a period has passed by then: the neutral ones
    // before it leave the room.
    Expected<Done> play_after(const Drive& drive, double rest_s) override;
    // Heard with the next packet: between two of them a controller has no steps of its own.
    void change(const Drive& drive) override;
    void set_level(double level) override;
    void stop() override;
    DeviceStatus status() override;

    SendStatistics statistics() const;

  private:
    using Clock = std::chrono::steady_clock;

    struct Play {
        Drive drive;
        bool loop = false;
        std::optional<double> rest_s{};  // after the end of the one before it, which it waits for
    };

    // One time through a drive: frame k of it is k hops after its beginning.
    struct Pass {
        Clock::time_point begin;  // of the first one; the others follow at once
        double duration_s = 0.0;
        std::size_t frame = 0;  // to be sent next
    };

    Expected<Done> ask(Play play);
    bool is_interrupted() const;
    void run(const std::stop_token& quit);
    std::optional<Play> next_play(const std::stop_token& quit);
    void take_change(Pass& pass, RumblePlan& plan);
    void take_up(const Play& play, const std::stop_token& quit);
    Expected<Done> ready();
    void perform(const Play& play, const std::stop_token& quit);
    double level_for(const Drive& drive);
    double risen_to(double level);
    bool send_frames(const Play& play, RumblePlan& plan, const std::stop_token& quit);
    static void prepare(RumblePlan& plan, std::size_t k, Clock::time_point deadline);
    Clock::time_point soonest() const;
    Clock::time_point after_rest(double rest_s) const;
    bool leaves_room(int neutral);
    void begin_notes(const Play& play);
    void tell_end();
    bool wait_until(Clock::time_point moment, const std::stop_token& quit);
    void note_lateness(Clock::time_point deadline);
    bool send_if_due(RumblePlan& plan, std::size_t k);
    bool send(const RumbleFrame& frame);
    bool write(const RumbleFrame& frame);
    void end_in_silence(const std::stop_token& quit);
    bool is_given_up(int refused, Clock::time_point since, const std::stop_token& quit);
    void put_to_rest(const std::stop_token& quit);
    bool was_halted();
    void fail(const std::string& why);
    void lose(const std::string& why);
    void watch();
    bool is_back();

    HidActuator actuator_;  // after the constructor the thread's own
    HidPorts ports_;
    std::shared_ptr<std::atomic<bool>> hurries_ = std::make_shared<std::atomic<bool>>(false);

    // The thread's own.
    std::optional<HidPort> port_;
    Encoder encode_;
    int counter_ = 0;
    Packet last_sent_;
    Clock::time_point last_sent_at_;  // when the port had taken it, or not
    bool owes_rest_ = false;          // it was told to vibrate, and not yet to be still
    double risen_ = 0.0;              // the level as it goes out: it rises within kRiseS, and ...
    Clock::time_point risen_at_;      // ... that was then
    std::uint64_t halts_ = 0;         // of the program, at the beginning of the play
    Ledger ledger_;                   // of all plays until ...
    Clock::time_point rests_since_;   // ... the end of the last one
    Clock::time_point begins_at_;     // what is about to be played, at the soonest

    mutable std::mutex mutex_;  // guards all of these
    std::condition_variable_any changed_;
    std::optional<Play> next_;
    std::optional<Play> behind_;   // ... and after that, where it still waits itself
    std::optional<Drive> change_;  // what plays, if that is a loop
    bool stop_ = false;
    bool tells_end_ = false;  // by the next status, as another one waits already
    double level_ = 1.0;
    DeviceStatus status_;
    Clock::time_point begun_at_;
    double duration_s_ = 0.0;
    bool loops_ = false;
    SendStatistics statistics_;
    std::vector<double> late_s_;

    std::jthread thread_;  // last: starts when all else is there
};

// The controllers that there are, in a list of devices, and the one that a list has.
std::vector<DeviceInfo> controllers();
Expected<std::unique_ptr<Device>> open_controller(const DeviceInfo& device);

}  // namespace tact
