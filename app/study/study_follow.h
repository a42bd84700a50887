// Studies of the window: the folder of participants, the run of one, and what they said so far.
//
// Left out  drawing: app/panels/study_*.cpp.
#pragma once

#include <filesystem>
#include <string>

#include "app/study/study_state.h"
#include "app/window/app.h"

namespace tact {

std::shared_ptr<StudyState> make_study();

// Before the program ends: the job, sound, and the file of a run, which is complete as it is.
void stop_study(App& app);

// The device of the window, where there is one, becomes that of the study; a run keeps the one that
// it began with.
void use_device(StudyState& study, const std::shared_ptr<Device>& device);
// At the end: a study would keep it longer than its library lives.
void release_device(StudyState& study);

// The view in place of the panes, and back.
void open_study(App& app);
void close_study(App& app);

// Where participants' files are: chosen, or beside the document, or of a document without a file
// in the state folder. Empty without a home.
std::filesystem::path study_folder(const App& app);
std::filesystem::path study_folder(const App& app, const SavedFrom& place);  // as if it were there
void choose_study_folder(App& app);
void set_study_folder(App& app, const std::filesystem::path& folder);

// The document has been saved from there: its participants come along, if it had no file and they
// no place but the state folder, and stay in sight else. Says so behind what is said.
void keep_participants(App& app, const SavedFrom& place_before);

// "P1", "P2", ... after a prefix, whichever has no file yet.
std::string unused_code(const App& app, const std::string& prefix = "");

// A new participant from the consent on; one with a file from where it was left.
void begin_participant(App& app);
void resume_participant(App& app, const StudyRecord& record);

// Answers as PM's prediction of the map on screen would have them, noise added, labelled synthetic.
void simulate_participant(App& app);

// What the participant did: the run goes on, and what it asks for is done.
void act(App& app, const StudyEvent& event);

// Who is counted, as the ratings of the document: one step. The CSV of all of them.
void use_as_ratings(App& app);
void export_study_dialog(App& app);
void export_study(App& app, const std::filesystem::path& file);

// Each frame: time passes for the run; the participants' files are read again where need be.
void follow_study(App& app);
bool is_study_running(const App& app);
bool is_study_playing(const App& app);  // its button fills while it does
// How strong full scale is, in words: what is known of the device's strength.
std::string study_calibration(const App& app);

// What a participant's file begins with, of the document as it is.
StudyHeader study_header(const App& app, const std::string& code);

// The patterns that take part, how long each is, and the longest of them.
std::vector<std::string> study_names(const App& app);
std::vector<double> study_durations_s(const PatternSet& set, const std::vector<std::string>& names);
double study_duration_s(const App& app);

// When the next frame is needed without input; infinite: not at all.
double study_wake_s(const App& app);

}  // namespace tact
