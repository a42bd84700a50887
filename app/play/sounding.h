// The way of the playing pattern to the device: its drive is computed at once or in the background,
// then started or exchanged.
#pragma once

#include "app/play/play_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

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

}  // namespace tact
