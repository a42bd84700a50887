// Studies of the window: the folder of participants, the run of one, and what they said so far.
//
// Left out  drawing: app/study/study_panels.h.
#pragma once

#include <filesystem>
#include <string>

#include "app/compare/compare_state.h"
#include "app/document/workspace.h"
#include "app/map/map_state.h"
#include "app/play/play_state.h"
#include "app/study/study_state.h"
#include "app/timeline/timeline.h"
#include "app/ui/layout.h"
#include "app/ui/ui.h"

namespace tact {

// Before the program ends: actuator and noise stop. The file of a run is complete.
void stop_study(StudyState& studying);

// The device of the window, where there is one, becomes that of the study; a run keeps the one that
// it began with.
void use_device(StudyState& study, const std::shared_ptr<Device>& device);
// At the end: a study would keep it longer than its library lives.
void release_device(StudyState& study);

// The view in place of the panes, and back.
void open_study(Layout& layout, StudyState& studying);
void close_study(StudyState& studying);

// Where participants' files are: chosen, or beside the document, or of a document without a file
// in the state folder. Empty without a home.
std::filesystem::path study_folder(const Workspace& work, const StudyState& studying);
std::filesystem::path study_folder(const Workspace& work, const StudyState& studying,
                                   const SavedFrom& place);  // as if it were there
void choose_study_folder(Ui& ui, const Workspace& work, const StudyState& studying);
void set_study_folder(const Workspace& work, StudyState& studying,
                      const std::filesystem::path& folder);

// The document has been saved from there: its participants come along, if it had no file and they
// no place but the state folder, and stay in sight else. Says so behind what is said.
void keep_participants(Ui& ui, const Workspace& work, StudyState& studying,
                       const SavedFrom& place_before);

// "P1", "P2", ... after a prefix, whichever has no file yet.
// Whether another participant's file has this code's name, which different codes may share.
bool is_code_taken(const Workspace& work, const StudyState& studying, const std::string& code);

std::string unused_code(const Workspace& work, const StudyState& studying,
                        const std::string& prefix = "");

// Why nobody can begin, and why nobody can be simulated, as sentences; empty: they can.
std::string participant_obstacle(const Workspace& work, const PlayState& play,
                                 const StudyState& studying);
std::string simulation_obstacle(const Workspace& work, const StudyState& studying,
                                const ShownMap& shown_map);

// A new participant from the consent on; one with a file from where it was left.
void begin_participant(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                       StudyState& studying);
void resume_participant(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                        StudyState& studying, const StudyRecord& record);

// Answers as PM's prediction of the map on screen would have them, noise added, labelled synthetic.
void simulate_participant(Ui& ui, const Workspace& work, const ShownMap& shown_map,
                          const PlayState& play, StudyState& studying);

// What the participant did: the run continues, and what it asks for is done.
void act(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
         const StudyEvent& event);

// Who is counted, as the ratings of the document: one step. The CSV of all of them.
void use_as_ratings(Ui& ui, Workspace& work, Layout& layout, Comparing& comparing,
                    StudyState& studying);
void export_study_dialog(Ui& ui, const Workspace& work, const StudyState& studying);
void export_study(Ui& ui, const StudyState& studying, const std::filesystem::path& file);

// Each frame: time passes for the run; the participants' files are read again where need be.
void follow_study(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying);
bool is_study_running(const StudyState& studying);
bool is_study_playing(const StudyState& studying);  // its button fills while it does
// How strong full scale is, in words: what is known of the device's strength.
std::string study_calibration(const PlayState& play);

// The beginning of a participant's file, from the present document.
StudyHeader study_header(const Workspace& work, const PlayState& play, const StudyState& studying,
                         const std::string& code);

// The patterns that take part, how long each is, and the longest of them.
std::vector<std::string> study_names(const Workspace& work);
std::vector<double> study_durations_s(const PatternSet& set, const std::vector<std::string>& names);
double study_duration_s(const Workspace& work);

// When the next frame is needed without input; infinite: not at all.
double study_wake_s(const Ui& ui, const StudyState& studying);

}  // namespace tact
