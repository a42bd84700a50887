// Feeling patterns: the chosen device, what sounds on it, and the playhead that follows it.
//
// Left out  what the device makes of a pattern.
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

// The choice of devices, to and from the session.
void keep_devices(Workspace& work, const PlayState& play);
void restore_devices(Workspace& work, PlayState& play);

// Sound for this program, and the first list of devices. Without it everything plays silently.
void make_sound(const Ui& ui, Timeline& timeline, PlayState& play);
void stop_sound(Timeline& timeline, PlayState& play);  // at the end

// A controller is stilled when the window loses the keys: whatever they go to may want to use it,
// and Esc would not come here. An output of sound plays on.
void follow_focus(Ui& ui, Timeline& timeline, PlayState& play, bool focused);

// Esc, before follow_sound: silence. What play.halted says was stopped out of turn waits for it.
void take_escape(Ui& ui, Timeline& timeline, PlayState& play, bool is_pressed);

// At the start of a frame: answers, the device's clock, what comes next.
void follow_sound(Ui& ui, Workspace& work, Timeline& timeline, RenderingState& rendered,
                  PlayState& play);

// As before, but for the list of devices.
void refresh_devices(PlayState& play);

// Another device, or another channel of it; an empty id: silent. What sounds stops.
void choose_device(Ui& ui, Timeline& timeline, PlayState& play, const DeviceChoice& choice);

// What a level means has changed: nobody is startled.
void begin_softly(PlayState& play);
void tell_softened(Ui& ui, PlayState& play);  // in the next frame: it is said

// How a device was chosen the last time; as its first channel where it never was.
DeviceChoice remembered_choice(const PlayState& play, const std::string& id);

// What is known of the chosen device; none: it is not there, or none is chosen.
std::optional<DeviceInfo> chosen_device(const PlayState& play);

// "pulse, 2": the chosen device in a few words. "No device", "Silent".
std::string device_text(const PlayState& play);

// Why the chosen device does not play, or what to plug in; empty: all is well.
std::string device_trouble(const PlayState& play);

// Only an output of sound is driven in proportion; a controller is told in packets.
bool can_be_calibrated(const PlayState& play);

bool can_sound(const PlayState& play);    // at 1x
bool is_sounding(const PlayState& play);  // or rests between two patterns

// Starts the playhead, from the start where it stood at the end, or halts it; at 1x with a device
// it sounds, from the start.
void toggle_playing(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
                    PlayState& play);
void set_speed(Ui& ui, Workspace& work, Timeline& timeline, const ShownMap& shown_map,
               PlayState& play, double speed);

// A preview on headphones, where no actuator is chosen (app/play/ear_preview.h): the current
// pattern begins, and all that is played from then on, until a device is chosen.
void listen_by_ear(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play);

void toggle_alternating(PlayState& play);
bool is_alternating(const PlayState& play);

void play_once(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play,
               std::size_t index);  // silently without a device
void play_pair(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play, std::size_t first,
               std::size_t second);                      // the first, then the second
void stop_playing(Timeline& timeline, PlayState& play);  // and the playhead
void play_all(Ui& ui, Workspace& work, Timeline& timeline, PlayState& play);
// A drive signal at a level of its own, whatever the bar says: it is no pattern.
void play_signal(Ui& ui, Timeline& timeline, PlayState& play, const Drive& drive, double level);
void play_test_buzz(Ui& ui, Timeline& timeline, PlayState& play);

// Within a few ms; nothing sounds on its own after that. True: something did sound.
bool silence(Timeline& timeline, PlayState& play);

}  // namespace tact
