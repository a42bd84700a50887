// Sound, controllers, the bar under the menus.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/map/map.h"
#include "app/rendering/rendering.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "devices/calibration/calibration.h"
#include "devices/device/device.h"
#include "devices/device/drive.h"
#include "model/set/pattern_set.h"
#include "viz/drawing/geometry.h"

namespace tact {

// The playing pattern, its device, and the state of the transport bar.

class AudioHost;    // devices/audio/audio_host.h
class PhoneDevice;  // devices/phone/phone_device.h
class PhoneServer;  // devices/phone/phone_server.h

// The settings that a drive depends on, besides the vibration.
struct DrivenBy {
    std::shared_ptr<const Calibration> calibration;  // null: no calibration
    double full_scale_g = kFullScaleG;
    bool is_protected = true;  // used if there is no calibration: devices/device/protection.h
    bool for_ear = false;      // two octaves up: app/play/parts.h

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
    bool for_ear = false;      // headphones were chosen, for this run only

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

// The calibration of the chosen device: remembered with the device, read when needed, and used to
// make drives.
//
// Left out  measuring: app/calibrate/calibrate.h.

// Reads the calibration file when the chosen device changes, reports an error once, and sets the
// actuator of the rendering report to match.
void follow_calibration(Ui& ui, Workspace& work, RenderingState& rendered, PlayState& play);

// The file for measurements made in the window; empty: none.
std::filesystem::path calibration_folder(const Workspace& work);

// Opens the chooser in the folder of the calibration in use, or in the folder for measurements.
void load_calibration_dialog(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                             PlayState& play);
void use_calibration(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                     // empty: no calibration from now on
                     PlayState& play, const std::filesystem::path& path);

// "Calibrated: coil, 2026-11-21, 20-500 Hz"; empty if the device is not calibrated.
std::string calibration_text(const PlayState& play);

// The present settings of the window.
DrivenBy driven_by(const PlayState& play);

// The drive that makes the chosen device play `vibration`. With a calibration, one minute of it
// takes a good part of a second, so no thread that draws may call it.
DriveRequest drive_request(const PlayState& play, const Vibration& vibration);
MadeDrive made_drive(const DriveRequest& request);

// Esc stops the device at once, on the thread that notices the key first: a window that draws
// slowly, or hangs, must not keep an actuator running.

class EmergencyStop {
  public:
    // The device that plays now; null: none.
    void watch(std::shared_ptr<Device> device) {
        const std::lock_guard lock(mutex_);
        device_ = std::move(device);
    }

    // From any thread. In devices that play, Device::stop() uses atomics or a lock.
    void stop() {
        const std::lock_guard lock(mutex_);
        if (!device_) return;
        has_stopped_ = true;
        device_->stop();
    }

    // Whether a device was stopped since the last call.
    bool take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(has_stopped_, false);
    }

  private:
    std::mutex mutex_;
    std::shared_ptr<Device> device_;
    bool has_stopped_ = false;
};

// Playing while working: edits of the playing pattern, the item under the pressed mouse, and two
// patterns in turn.

// At the end of a frame: a playing loop takes up this frame's edits without a restart, and a
// playing drive follows protection, full scale and calibration.
// An item pressed for kHoldS repeats until the mouse is released. The report uses the bar's level
// if it describes the present playback.
void hear_changes(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                  PlayState& play);

// The two patterns of A|B, by name: those that play in turn, or those that would.
std::optional<std::pair<std::string, std::string>> alternating_pair(const Workspace& work,
                                                                    const ShownMap& shown_map,
                                                                    const PlayState& play);
// Makes the partner the current pattern, and the other way round; playing continues.
void swap_pair(Workspace& work, const ShownMap& shown_map, PlayState& play);

// Panels of playing: the bar under the menus, the tab and the dialog of devices.

void draw_device_panel(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                       const PlayState& play);
inline constexpr Dialog kCalibrateDialog{.title = "Calibrate"};  // drawn by app/calibrate
inline constexpr Dialog kDevicesDialog{.title = "Devices"};
void draw_devices(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                  PlayState& play);
float transport_height(const Ui& ui);
void draw_transport_bar(Ui& ui, Workspace& work, Timeline& timeline, ShownMap& shown_map,
                        const RenderingState& rendered, PlayState& play, const Rect& area);

// Part of the bar: device, level, meter, clip light. Without `meter`, meter and light are left out;
// without `wide`, most of the device's name. The level is always there.
struct SoundParts {
    bool meter = true;
    bool wide = true;
};
void draw_sound_controls(Ui& ui, Timeline& timeline, PlayState& play, SoundParts parts);
float sound_controls_width(const Ui& ui, const PlayState& play, SoundParts parts);

// Playing patterns: the chosen device, the queue that plays on it, and the playhead that follows.
//
// Left out  the device's rendering of a pattern.

// Write the choice of devices to the session, and read it.
void keep_devices(Workspace& work, const PlayState& play);
void restore_devices(Workspace& work, PlayState& play);

// Starts sound for this program, and the first search for devices. Without it, playing is silent.
void make_sound(const Ui& ui, Timeline& timeline, PlayState& play);
void stop_sound(Timeline& timeline, PlayState& play);  // at the end

// Stops a controller when the window loses the keyboard: another program may want to use it, and
// Esc would not arrive here. An output of sound plays on.
void follow_focus(Ui& ui, Timeline& timeline, PlayState& play, bool focused);

// Esc, before follow_sound: stops playing, also what another thread has stopped already
// (play.halted).
void take_escape(Ui& ui, Timeline& timeline, PlayState& play, bool is_pressed);

// At the start of a frame: takes answers of jobs and the device's clock, and starts the next
// pattern.
void follow_sound(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                  PlayState& play);

// Searches for devices again.
void refresh_devices(const Ui& ui, PlayState& play);

// Chooses another device or channel; an empty id: silent. Stops playing.
void choose_device(Ui& ui, Timeline& timeline, PlayState& play, const DeviceChoice& choice);

// Lowers the level to that of the start, because its meaning has changed.
void begin_softly(PlayState& play);
void tell_softened(Ui& ui, PlayState& play);  // in the next frame

// The last settings of a device; its first channel if it was never chosen.
DeviceChoice remembered_choice(const PlayState& play, const std::string& id);

// The chosen device; nullopt: it is not connected, or no device is chosen.
std::optional<DeviceInfo> chosen_device(const PlayState& play);

// The chosen device in a few words: "pulse, 2", "No device", "Silent".
std::string device_text(const PlayState& play);

// The reason why the chosen device does not play, or an advice to plug it in; empty: it can play.
std::string device_trouble(const PlayState& play);

// Only an output of sound plays any waveform; a controller gets packets.
bool can_be_calibrated(const PlayState& play);

bool can_sound(const PlayState& play);    // at 1x
bool is_sounding(const PlayState& play);  // or rests between two patterns

// Starts or stops the playhead, from the beginning if it stood at the end. At 1x with a device,
// playing starts from the beginning.
void toggle_playing(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                    PlayState& play);
void set_speed(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
               PlayState& play, double speed);

// Plays a preview on headphones if no actuator is chosen: first the
// current pattern, then everything that is played, until a device is chosen.
void listen_by_ear(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play);

void toggle_alternating(PlayState& play);
bool is_alternating(const PlayState& play);

void play_once(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play,
               std::size_t index);  // silent without a device
void play_pair(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play, std::size_t first,
               std::size_t second);                      // the first, then the second
void stop_playing(Timeline& timeline, PlayState& play);  // stops the playhead, too
void play_all(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play);
// Plays a drive signal at its own level, not the bar's: it is not a pattern.
void play_signal(Ui& ui, Timeline& timeline, PlayState& play, const Drive& drive, double level);
void play_test_buzz(Ui& ui, Timeline& timeline, PlayState& play);

// Stops within a few ms; only the person can start playing again. True: something was playing.
bool silence(Timeline& timeline, PlayState& play);

}  // namespace tact
