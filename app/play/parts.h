// Parts that the files of this room share.
#pragma once

#include <optional>

#include "app/document/workspace.h"
#include "app/map/map.h"
#include "app/play/play.h"
#include "app/rendering/rendering.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// A|B in the transport bar: plays two patterns in turn, and names them.

// In px; does not depend on the names.
float alternate_width(const Ui& ui, bool names);

// `names`: shows both patterns' marks and names, or dashes if there are fewer than two.
void draw_alternate(Ui& ui, const Workspace& work, const ShownMap& shown_map, PlayState& play,
                    bool names);

// Patterns heard instead of felt: a preview on headphones, if no actuator is connected.
//
// All frequencies are two octaves higher, where the ear is as sensitive as the skin: 100 Hz sounds
// as 400 Hz. Strengths, rhythm and modulation are unchanged. The output is never saved as the
// device of an actuator, and the level starts as low as everywhere.
//
// Left out  recordings, which are heard unchanged, with a remark.

inline constexpr double kEarFactor = 4.0;
inline constexpr const char* kEarWords =
    "preview for the ear, two octaves up, not what the skin gets";

Pattern for_ear(Pattern pattern);
LayeredPattern for_ear(LayeredPattern layered);

// The system's default output; nullopt: it has none.
std::optional<DeviceInfo> ear_output(const PlayState& play);

// The way of the playing pattern to the device: its drive is computed at once or in the background,
// then started or exchanged.

// The bar's level, or that of a signal with its own level.
double level_now(const PlayState& play);

// Starts play.sounding with its first drive; later calls exchange the drive.
void play_drive(Ui& ui, Timeline& timeline, PlayState& play, const Drive& drive, bool loop);

// Whether computing its drive takes at most a few milliseconds, so that no job is needed.
bool is_made_at_once(const DriveRequest& request);

// At once, or when the drive is ready; until then the old one plays.
void play_vibration(Ui& ui, Timeline& timeline, PlayState& play, const Vibration& vibration);

// Gives `next` to the device, which starts it after the present pattern and the rest; at once, or
// when its drive is ready.
void play_next(Ui& ui, Timeline& timeline, PlayState& play, const Vibration& next);

// Takes the job's answer if it is for the next pattern; true: it was.
bool take_next_drive(Ui& ui, Timeline& timeline, PlayState& play);

// Takes the job's answer if it is for the playing pattern; true: it was.
bool take_drive(Ui& ui, Timeline& timeline, PlayState& play);

// The report uses the bar's level if it describes the present playback.
void follow_level(Workspace& work, RenderingState& rendered, const PlayState& play);

}  // namespace tact
