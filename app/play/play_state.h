// The playing pattern, its device, and the state of the transport bar.
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

// The settings that a drive depends on, besides the vibration.
struct DrivenBy {
    std::shared_ptr<const Calibration> calibration;  // null: no calibration
    double full_scale_g = kFullScaleG;
    bool is_protected = true;  // used if there is no calibration: devices/device/protection.h
    bool for_ear = false;      // two octaves up: app/play/ear_preview.h

    bool operator==(const DrivenBy&) const = default;
};

// A queue of patterns to be played one after the other; empty for the test buzz.
struct Sounding {
    std::vector<std::string> names;
    std::size_t at = 0;                     // index of the playing name
    bool repeats = false;                   // continues with the first after the last
    bool loops = false;                     // a single pattern, without a gap
    bool follows = false;                   // the pattern in the editor, with its edits
    bool selects = false;                   // each in turn becomes the current pattern
    std::optional<double> rests_until_s{};  // end of the rest between two patterns
    Vibration as_played{};                  // the playing pattern, as it was at its start
    DrivenBy driven_by{};                   // ... and the settings of its drive
    double position_s = 0.0;                // position in the last frame
    std::optional<double> level{};          // a level that overrides the bar's
    bool is_prepared = true;                // the drive has been computed
    bool while_held = false;                // repeats as_played until the mouse is released
    bool has_begun = false;                 // it plays on the device: another drive changes it
    std::uint64_t first_drive = 0;          // number of the request that started it
    bool next_was_asked = false;            // the device has the next pattern, and starts it
    std::optional<Vibration> next{};        // the pattern in it
    DrivenBy next_by{};                     // ... and the settings of its drive
    std::uint64_t next_drive = 0;           // number of its request, until the device has it
};

using Listing = std::vector<DeviceInfo>;

// A request for the drive that makes the chosen device play a vibration.
struct DriveRequest {
    std::uint64_t number = 0;
    Vibration vibration;
    DrivenBy by;
    bool loops = false;
};

struct MadeDrive {
    DriveRequest request;
    Drive drive;
    std::string remark;  // a sentence on what the actuator cannot play; empty: it can play all
};

// The window renders an output this far ahead, so that an edit is felt within 50 ms. If gaps occur
// it is doubled, up to kBufferS; a study and a measurement, which must not have gaps, begin with
// kBufferS.
inline constexpr double kLiveBufferS = 0.02;

inline constexpr double kFirstLevel = 0.1;  // at every start, so that the first buzz startles
                                            // nobody

struct PlayState {
    // Saved in the session (app/session/session.h).
    DeviceChoice choice;                // no id: silent
    std::vector<DeviceChoice> choices;  // settings of other devices, for the next time they are
                                        // chosen
    double full_scale_g = kFullScaleG;
    bool on_hover = false;  // plays the pattern under the mouse in the map

    bool is_protected = true;  // limits the drive if no calibration gives the actuator's limits
    bool for_ear = false;      // headphones were chosen, for this run only: ear_preview.h

    double level = kFirstLevel;
    bool was_softened = false;  // the level was lowered, and the person is not told yet
    bool alternates = false;    // A|B: the current pattern and its partner, in turn
    double gap_s = 0.5;         // rest between two patterns

    std::shared_ptr<AudioHost> audio;  // null: no sound in this program, as in tests and pictures
    Query<int, Listing> list_job;      // requested by number
    int lists_asked = 0;
    std::shared_ptr<const Listing> found;      // result of that job; null: not yet
    std::shared_ptr<const Listing> listed_of;  // the `found` from which `listed` was made
    std::shared_ptr<const Listing> listed;     // with the phones, which no job has to look for

    std::shared_ptr<PhoneServer> phones;      // null: no page is served to phones
    std::weak_ptr<PhoneDevice> phone_device;  // `device`, if it is the phones
    double phone_full_scale_g = 1.0;          // peak of the loudest pattern, which gets full
                                              // strength on phones
    std::string cards_fault;                  // the reason why there are no sound cards; empty:
                                              // there may be some

    std::shared_ptr<Device> device;  // the chosen device, if connected; studies use it, too
    DeviceChoice opened;             // the choice with which it was opened
    std::string opened_place;        // ... and the output behind it
    std::shared_ptr<const Calibration> calibration;  // null: strengths in g are unknown
    std::string calibration_read;                    // path of its file, also of one with an error
    Query<DriveRequest, MadeDrive> drive_job;        // drives for calibrated devices
    std::uint64_t drives_asked = 0;
    std::uint64_t drive_taken = 0;  // number of the last one
    DeviceStatus status;            // in this frame
    std::string told_trouble;       // in the status line ...
    std::string complaint;          // ... where it stays until a pattern plays
    std::string told_held;          // also there: the actuator's limits, used up by earlier plays
    std::optional<Sounding> sounding;
    std::optional<std::size_t> hovered_in_map;  // in this frame
    std::string felt_on_hover;                  // until the mouse is over another pattern
    double edited_s = 0.0;                      // on the steady clock: time of the last edit sent
    bool hold_taken = false;                    // by the item under the pressed mouse, until it is
                                                // released
    double meter = 0.0;                         // share of full scale; falls slowly
    bool clip_light = false;                    // until it is clicked
    double live_buffer_s = kLiveBufferS;        // until the program ends
    double whole_buffer_s = kBufferS;           // for playback that must not have gaps
    bool held = false;                          // a study is running: its device stays
    bool gapless = false;                       // the current playback must not have gaps
    bool focused = true;                        // the window has the keyboard, as of the last frame
    bool halted = false;  // Esc has stopped the device, and no frame has handled it yet
};

}  // namespace tact
