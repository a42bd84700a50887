// Playing patterns: the chosen device, the queue that plays on it, and the playhead that follows.
//
// Left out  the device's rendering of a pattern.
#pragma once

#include <optional>
#include <string>

#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/play/play_state.h"
#include "app/rendering/rendering_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

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

// Plays a preview on headphones if no actuator is chosen (app/play/ear_preview.h): first the
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
