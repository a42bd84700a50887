// The actuator of a run: what it is driven with, whether a play was felt to its end, and what is
// done when it goes.
//
// The patterns are driven as they are to each other: where the strongest is too strong for the
// output at the chosen level, all of them are turned down alike, before the first trial. A limiter
// that turned down only that one would make another set of them.
//
// Output    a run whose actuator goes pauses and says why; what was playing does not count
// Left out  what the skin got: a device tells what it was given and what it could not send.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/play/play_state.h"
#include "app/study/study_state.h"
#include "app/ui/ui.h"

namespace tact {

// The device chosen now, for the patterns of a study.
StudyActuator study_actuator(const PlayState& play, const StudyState& studying,
                             const PatternSet& set, const std::vector<std::string>& names);

// Its name, calibration and level, and by how much the set is turned down, as the participant's
// file has them; without the masking.
StudyDevice study_device(const PlayState& play, const StudyState& studying,
                         const StudyActuator& actuator);

// For the experimenter, before the first trial: what the patterns are not felt as. Empty: nothing.
std::string strength_words(const StudyActuator& actuator);

// How the play that is under way went, as far as it got.
Play play_so_far(const StudyState& state, const DeviceStatus& status);

// The device refused to play, or went: the run pauses and says so.
void lose_actuator(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                   const std::string& trouble);

// Each frame, and before anything is done: the play that is under way takes as long as the device
// takes, and ends when the device does.
void follow_actuator(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying);

}  // namespace tact
