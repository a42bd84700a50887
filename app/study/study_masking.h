// Pink noise on the participant's headphones while a study runs, so that the actuator is felt and
// not heard.
//
// Input     the level and the output of the study's design
// Output    noise on all channels of that output and of no other; a run whose noise stops by itself
//           pauses and says why, and tries again when the participant continues
// Left out  whether anybody wears the headphones, and how loud they are.
#pragma once

#include <string>

#include "app/document/workspace.h"
#include "app/play/play_state.h"
#include "app/study/study_state.h"
#include "app/ui/ui.h"
#include "devices/device/device_info.h"
#include "model/common/expected.h"

namespace tact {

// How often a run looks whether the noise is still there, while nothing else happens.
inline constexpr double kMaskingLookS = 0.25;

// Where the noise goes. An Error says what is to be plugged in or chosen: the actuator's own output
// cannot be chosen, even if it is the only one.
Expected<DeviceInfo> masking_output(const PlayState& play, const std::string& headphones);

// Whether the actuator sounds there too, by whichever name.
bool is_actuators(const PlayState& play, const DeviceInfo& output);

void begin_masking(const PlayState& play, StudyState& studying, const StudyDesign& design);
void stop_masking(StudyState& state);

// Each frame.
void follow_masking(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying);

// For the participant's file: "pink noise at 30 % of full scale on PulseAudio", "none: there is no
// sound output"; empty where the design asks for none.
std::string masking_words(const StudyState& studying, const StudyDesign& design);

}  // namespace tact
