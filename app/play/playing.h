// Feeling patterns: the chosen device, what sounds on it, and the playhead that follows it.
//
// Left out  what the device makes of a pattern.
#pragma once

#include <optional>
#include <string>

#include "app/window/app.h"

namespace tact {

// The choice of devices, to and from the session.
void keep_devices(App& app);
void restore_devices(App& app);

// Sound for this program, and the first list of devices. Without it everything plays silently.
void make_sound(App& app);
void stop_sound(App& app);  // at the end

// A controller is stilled when the window loses the keys: whatever they go to may want to use it,
// and Esc would not come here. An output of sound plays on.
void follow_focus(App& app, bool focused);

// Esc, before follow_sound: silence. What play.halted says was stopped out of turn waits for it.
void take_escape(App& app, bool is_pressed);

// At the start of a frame: answers, the device's clock, what comes next.
void follow_sound(App& app);

// As before, but for the list of devices.
void refresh_devices(App& app);

// Another device, or another channel of it; an empty id: silent. What sounds stops.
void choose_device(App& app, const DeviceChoice& choice);

// How a device was chosen the last time; as its first channel where it never was.
DeviceChoice remembered_choice(const App& app, const std::string& id);

// What is known of the chosen device; none: it is not there, or none is chosen.
std::optional<DeviceInfo> chosen_device(const App& app);

// "pulse, 2": the chosen device in a few words. "No device", "Silent".
std::string device_text(const App& app);

// Why the chosen device does not play, or what to plug in; empty: all is well.
std::string device_trouble(const App& app);

// Only an output of sound is driven in proportion; a controller is told in packets.
bool can_be_calibrated(const App& app);

bool can_sound(const App& app);    // at 1x
bool is_sounding(const App& app);  // or rests between two patterns

// Starts the playhead, from the start where it stood at the end, or halts it; at 1x with a device
// it sounds, from the start.
void toggle_playing(App& app);
void set_speed(App& app, double speed);

void toggle_alternating(App& app);
bool is_alternating(const App& app);

void play_once(App& app, std::size_t index);                      // silently without a device
void play_pair(App& app, std::size_t first, std::size_t second);  // the first, then the second
void stop_playing(App& app);                                      // and the playhead
void play_all(App& app);
// A drive signal at a level of its own, whatever the bar says: it is no pattern.
void play_signal(App& app, const Drive& drive, double level);
void play_test_buzz(App& app);

// Within a few ms; nothing sounds on its own after that. True: something did sound.
bool silence(App& app);

}  // namespace tact
