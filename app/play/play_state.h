// What is being felt, on which device, and how the transport bar was left.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/query.h"
#include "devices/calibration/calibration.h"
#include "devices/device/device.h"
#include "devices/device/device_info.h"
#include "devices/device/drive.h"
#include "model/set/pattern_set.h"

namespace tact {

class AudioHost;    // devices/audio/audio_host.h
class PhoneDevice;  // devices/phone/phone_device.h
class PhoneServer;  // devices/phone/phone_server.h

// What a drive is made by, besides the vibration.
struct DrivenBy {
    std::shared_ptr<const Calibration> calibration;  // null: none
    double full_scale_g = kFullScaleG;
    bool is_protected = true;  // without a calibration: devices/device/protection.h
    bool for_ear = false;      // two octaves up: app/play/ear_preview.h

    bool operator==(const DrivenBy&) const = default;
};

// Patterns to be felt, one after the other; of the test buzz none.
struct Sounding {
    std::vector<std::string> names;
    std::size_t at = 0;                     // of names: the one that sounds
    bool repeats = false;                   // from the first after the last
    bool loops = false;                     // the only one, without a gap
    bool follows = false;                   // the pattern in the editor, as it is edited
    bool selects = false;                   // each becomes the current one
    std::optional<double> rests_until_s{};  // between two of them
    Vibration as_played{};                  // the one that sounds, as it was when it began
    DrivenBy driven_by{};                   // ... and what its drive was made by
    double position_s = 0.0;                // in the last frame
    std::optional<double> level{};          // of its own, in the place of the bar's
    bool is_prepared = true;                // its drive is there; false: still being computed
    bool while_held = false;                // until the mouse lets go of as_played
    bool has_begun = false;                 // on the device: another drive is a change of it
    std::uint64_t first_drive = 0;          // number of the request that it began with
    bool next_was_asked = false;            // of the device, to begin after this one by itself
    std::optional<Vibration> next{};        // what it takes
    DrivenBy next_by{};                     // ... and what the drive of that is made by
    std::uint64_t next_drive = 0;           // number of its request, until the device has it
};

using Listing = std::vector<DeviceInfo>;

// A vibration as the chosen device is to be driven for it.
struct DriveRequest {
    std::uint64_t number = 0;
    Vibration vibration;
    DrivenBy by;
    bool loops = false;
};

struct MadeDrive {
    DriveRequest request;
    Drive drive;
    std::string remark;  // a sentence on what the actuator cannot do of it; empty: it can
};

// An output is rendered so far ahead in the window: an edit is to be heard within 50 ms. Where that
// leaves gaps it is doubled, up to kBufferS; a study and a measurement, which must have none, begin
// with that.
inline constexpr double kLiveBufferS = 0.02;

inline constexpr double kFirstLevel = 0.1;  // of every start: nobody is startled

struct PlayState {
    // Remembered from one start to the next (app/session/session.h).
    DeviceChoice choice;                // no id: silent
    std::vector<DeviceChoice> choices;  // of other devices, for when they are chosen again
    double full_scale_g = kFullScaleG;
    bool on_hover = false;  // a pattern pointed at in the map is felt

    bool is_protected = true;  // the actuator, where no calibration says what it bears
    bool for_ear = false;      // the choice is of headphones, and of this run: ear_preview.h

    double level = kFirstLevel;
    bool was_softened = false;  // to that again, and it is still to be said
    bool alternates = false;    // A|B: the current pattern and its partner, in turn
    double gap_s = 0.5;         // between two patterns

    std::shared_ptr<AudioHost> audio;  // null: no sound in this program, as in tests and pictures
    Query<int, Listing> list_job;      // asked for by number
    int lists_asked = 0;
    std::shared_ptr<const Listing> found;      // by that job; null: not yet
    std::shared_ptr<const Listing> listed_of;  // the found ones that `listed` was made of
    std::shared_ptr<const Listing> listed;     // with the phones, which no job has to look for

    std::shared_ptr<PhoneServer> phones;      // null: no page is served to phones
    std::weak_ptr<PhoneDevice> phone_device;  // `device`, where that is the phones
    double phone_full_scale_g = 1.0;          // the loudest pattern's peak: full strength on them
    std::string cards_fault;                  // why it has no sound cards; empty: it may have

    std::shared_ptr<Device> device;  // the chosen one, where it is there; studies use it, too
    DeviceChoice opened;             // as which it was opened
    std::string opened_place;        // ... and where that sounds
    std::shared_ptr<const Calibration> calibration;  // null: strengths in g are not known
    std::string calibration_read;                    // the file it is from, or that was no good
    Query<DriveRequest, MadeDrive> drive_job;        // of calibrated ones
    std::uint64_t drives_asked = 0;
    std::uint64_t drive_taken = 0;  // number of the last one
    DeviceStatus status;            // of this frame
    std::string told_trouble;       // at the foot of the window ...
    std::string complaint;          // ... where it stays until something is felt again
    std::string told_held;          // there too: what plays before have left of this one
    std::optional<Sounding> sounding;
    std::optional<std::size_t> hovered_in_map;  // in this frame
    std::string felt_on_hover;                  // until another one is pointed at
    double edited_s = 0.0;                      // of the steady clock: the last edit that was sent
    bool hold_taken = false;                    // by what the mouse is pressed on, until it lets go
    double meter = 0.0;                         // of full scale; falls slowly
    bool clip_light = false;                    // until it is clicked
    double live_buffer_s = kLiveBufferS;        // until the program ends
    double whole_buffer_s = kBufferS;           // where nothing that sounds may have gaps
    bool held = false;                          // a study is under way: its device stays
    bool gapless = false;                       // nothing that sounds may have gaps
    bool focused = true;                        // the window, in the last frame
    bool halted = false;  // Esc has stopped the device; the frame that takes it is still to come
};

}  // namespace tact
