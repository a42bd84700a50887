// How the pattern that sounds gets to the device: its drive, made at once or beside the window,
// begun or changed.
#pragma once

#include "app/play/play_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"

namespace tact {

// As the bar says, but for a signal that has a level of its own.
double level_now(const PlayState& play);

// Something is to sound (play.sounding). The first drive of it begins, the next ones change it.
void play_drive(Ui& ui, Timeline& timeline, PlayState& play, const Drive& drive, bool loop);

// Whether its drive takes a few milliseconds at most: then no job computes it.
bool is_made_at_once(const DriveRequest& request);

// At once, or when its drive is computed; until then what sounded goes on.
void play_vibration(Ui& ui, Timeline& timeline, PlayState& play, const Vibration& vibration);

// `next` waits on the device for the end of what sounds, and for the pause after it; at once, or
// when its drive is computed.
void play_next(Ui& ui, Timeline& timeline, PlayState& play, const Vibration& next);

// Takes what was being computed for that; true: it did.
bool take_next_drive(Ui& ui, Timeline& timeline, PlayState& play);

// Takes what was being computed for the one that sounds; true: it did.
bool take_drive(Ui& ui, Timeline& timeline, PlayState& play);

}  // namespace tact
