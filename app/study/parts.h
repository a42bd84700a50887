// Parts that the files of this room share.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "app/document/workspace.h"
#include "app/play/play.h"
#include "app/study/study.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "devices/device/device.h"
#include "model/common/expected.h"
#include "model/study/study_design.h"

namespace tact {

// The actuator of a run: what it is driven with, whether a play was felt to its end, and what is
// done when it goes.
//
// The patterns are driven as they are to each other: where the strongest is too strong for the
// output at the chosen level, all of them are turned down alike, before the first trial. A limiter
// that turned down only that one would make another set of them.
//
// Output    a run whose actuator goes pauses and says why; what was playing does not count
// Left out  what the skin got: a device tells what it was given and what it could not send.

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

// What participants' files say, read and evaluated in the background.

// The work of the job. Nothing when stopped.
std::optional<StudyAnswers> read_answers(const StudyQuestion& question, std::stop_token stop,
                                         std::atomic<float>& progress);

// How a study asks: the numbers of its design that are typed, with their words and bounds; and what
// of the design the first participant has fixed, as what is asked otherwise is another study.
//
// Left out  the comparison of two designs: model/study/study_record.h

// A number of the design.
struct StudyNumber {
    DescribedField<StudyDesign> row;
    bool of_pairs = true;  // sorting has none of it
};

std::span<const StudyNumber> study_numbers();

// What the study now asks otherwise than the folder's first participant was asked, as phrases; by
// the participants as they were last read.
std::vector<std::string> design_changes(const Workspace& work, const StudyState& studying);

// "Another study than that of this folder's first participant: repetitions 2, not 4."
std::string another_study_words(const std::vector<std::string>& changes);

// The words; empty where nothing has changed.
std::string design_obstacle(const Workspace& work, const StudyState& studying);

// The two ways on: participants go into a folder beside, which has nobody yet, or participants of
// the design as it now is; or the design is again as it was, in one undo step.
void begin_another_study(Ui& ui, const Workspace& work, StudyState& studying);
void take_design_back(Ui& ui, Workspace& work, const StudyState& studying);

// Pink noise on the participant's headphones while a study runs, so that the actuator is felt and
// not heard.
//
// Input     the level and the output of the study's design
// Output    noise on all channels of that output and of no other; a run whose noise stops by itself
//           pauses and says why, and tries again when the participant continues
// Left out  whether anybody wears the headphones, and how loud they are.

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
