// Asking people: design, trials, answers.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/compare/compare.h"
#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/map/map.h"
#include "app/play/play.h"
#include "app/screen/screen.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "devices/device/device.h"
#include "devices/device/memory_device.h"
#include "model/evaluation/individuals.h"
#include "model/io/people/study_file.h"
#include "model/map/mds.h"
#include "model/set/pattern_set.h"
#include "model/study/agreement.h"
#include "model/study/study_record.h"
#include "model/study/study_results.h"
#include "viz/drawing/geometry.h"

namespace tact {

// One participant's way through a study: state and event in, state and what is to be done out.
//
// Source    Lim & Park 2023, section 6.1: training with every pattern at least once, then pairs;
//           the slider opens after both were felt; replays without limit; a gap between vibrations.
// Input     what the person did, and the time, s, which never runs backwards
// Output    at most one of each: a pattern to play, silence, a line for the participant's file. The
//           next trial comes only with the word that the line is on the disk. A play counts when
//           it has come to its end, whole. One that is asked for in the gap waits for its end,
//           which the device keeps.
// Left out  sound, files, drawing

enum class StudyPage { consent, instructions, training, trial, sorting, rest, finished };

struct StudyRun {
    StudyRecord record;              // what is on the disk
    std::vector<double> duration_s;  // of every pattern
    StudyPage page = StudyPage::consent;
    bool is_asking = false;   // whether to leave, over the page
    bool is_waiting = false;  // for the disk
    std::string trouble;      // why it did not take the last line

    std::vector<std::size_t> training;  // patterns by button
    std::vector<int> felt;              // how often, by button

    std::vector<Trial> trials;         // of the full design
    Trial trial;                       // on the screen
    PairAnswer given;                  // to it so far: how its sides were felt
    bool feels_again = false;          // the last play was not whole, and does not count
    int cut_short = 0;                 // plays in a row that were not whole
    int cut_short_in_all = 0;          // of this sitting
    int broken_in_training = 0;        // of these
    std::optional<double> similarity;  // where the slider was put

    int asked_groups = 0;           // of the round of sorting on the screen; 0: free
    Sorting groups;                 // so far
    SortingAnswer felt_in_round;    // how the round's patterns were felt
    std::vector<int> felt_sorting;  // whole plays of each pattern in this sitting

    std::optional<std::size_t> playing;  // position of the pattern
    std::size_t playing_button = 0;
    double playing_until_s = 0.0;
    double quiet_until_s = 0.0;      // the gap
    double rest_s = 0.0;             // how long that is
    bool was_silenced = false;       // nothing keeps the gap but the clock
    double shown_s = 0.0;            // since when the trial is on the screen, pauses taken off
    double asked_s = 0.0;            // since when is_asking
    std::size_t answers_before = 0;  // of an earlier sitting
};

// What the person, the clock or the disk did.
struct StudyEvent {
    enum class What {
        tick,   // time passed
        go_on,  // to the next page; with a trial: the answer is given
        play,   // the pattern behind button `index`: 0 left, 1 right; of the training; of sorting
        rate,   // the slider is at `value`
        put,    // pattern `index` into group `value`; kUnsorted: back
        plays_on,   // what plays takes `value` seconds more
        cut_short,  // it stopped before its end
        ask,        // whether to leave
        stay,       // rather not
        leave,      // the answers so far are kept
        saved,      // the line is on the disk
        not_saved   // it is not; `text` says why
    };
    What what = What::tick;
    std::size_t index = 0;
    double value = 0.0;
    std::string text{};
    std::string at{};                    // the time of day, UTC, for what is written
    Play played{.is_to_the_end = true};  // what plays, if it has come to its end by now
};

struct StudyActions {
    std::optional<std::size_t> play;  // position of a pattern ...
    double rest_s = 0.0;              // ... so long after the end of the last one, at the soonest
    bool silence = false;
    bool begin_file = false;          // with the header
    std::optional<std::string> line;  // into the file
    bool left = false;                // the run is over
};

struct StudyStep {
    StudyRun run;
    StudyActions actions;
};

// The run of a record: of one without a file yet (`header.begun` empty) from the consent, of
// another from where it was left.
StudyRun study_run(StudyRecord record, std::vector<double> duration_s);

StudyStep stepped(StudyRun run, const StudyEvent& event, double now_s);

// Whether a button answers now: nothing plays, nor waits for the end of the gap.
bool may_play(const StudyRun& run, double now_s);
// Both were felt to the end: the slider is open.
bool may_rate(const StudyRun& run, double now_s);
// What Enter does now would be done.
bool may_go_on(const StudyRun& run, double now_s);
// When something changes by itself, such as a gap that ends; infinite: nothing does.
double next_change_s(const StudyRun& run, double now_s);

// This many plays in a row that were cut short are not for the participant to mend.
inline constexpr int kCallAfter = 3;

// Patterns to sort that were not felt whole in this sitting.
std::size_t unfelt_count(const StudyRun& run);

// Groups of the round that have patterns, and what is still to be sorted.
std::size_t filled_groups(const StudyRun& run);
std::size_t unsorted_count(const StudyRun& run);

// Minutes to the end, by the pace of the latest trials, or by the expected pace.
double minutes_left(const StudyRun& run);

// What the window knows of studies: the experimenter's view, who took part, and who is at it now.

// What is to be made of the participants' files; asked for by number, as the disk has no revision.
struct StudyQuestion {
    std::uint64_t number = 0;
    std::filesystem::path folder;
    StudyKind kind = StudyKind::pairwise;
    CollectRule rule;
    // Its fingerprint is made where the answers are read: of a large set it takes longer than a
    // frame may. As of the last undo step.
    std::shared_ptr<const PatternSet> set;

    bool operator==(const StudyQuestion&) const = default;
};

// Everything the experimenter's view shows of them.
struct StudyAnswers {
    StudyQuestion question;
    std::vector<StudyRecord> records;  // of the kind asked for
    std::vector<StudyRecord> others;   // of the other kind
    std::optional<StudyResults> results;
    std::string fault;  // why there are no results
    bool is_of_other_patterns = false;
    std::optional<StudyHeader> founder;   // whose design is that of the study
    std::vector<Dissimilarity> matrices;  // of every record
    PerceptualSpace mean_map;             // three dimensions
    std::vector<PerceptualSpace> maps;    // of every record
    std::optional<MapSettling> settling;  // of the latest one, in adaptive order
    InterRater raters;                    // of those who count, as the next
    OrderEffects effects;
    IndividualWeights weights;  // of a common map
};

// Where participants' files are to be, as chosen for one document.
struct ChosenFolder {
    std::filesystem::path path;
    std::uint64_t document_number = 0;  // 0: none was chosen
};

enum class StudyShow { matrix, map };

// Who is about to be left out, and why: while the reason is typed.
struct LeavingOut {
    std::string code;
    std::string because;
};

// What is known of the device that a run is felt by.
struct StudyActuator {
    bool is_there = false;        // when the run began; otherwise it is a rehearsal
    std::vector<Drive> drives;    // of every pattern of the run, turned down ...
    double turned_down_db = 0.0;  // ... all alike, so that none is too strong
    std::vector<double> peaks;    // of the drives, at a level of 1
    double level = 1.0;
    double ceiling = 1.0;             // above it the device turns a play down
    std::string remark;               // on what the actuator cannot do; empty: it can
    std::string fault;                // why the run paused; a sentence
    std::string known_trouble;        // of the device, that has been told
    std::uint64_t seen_dropouts = 0;  // by the device's count
    int dropouts = 0;                 // in the play that is under way
};

struct StudyState {
    bool is_open = false;  // the view, in place of the panes
    StudyKind kind = StudyKind::pairwise;
    ChosenFolder folder;
    std::optional<StudyRun> run;            // fills the window
    std::optional<StudyLog> log;            // its file
    std::shared_ptr<const PatternSet> set;  // as it was when the run began
    Query<StudyQuestion, StudyAnswers> job;
    std::shared_ptr<const StudyAnswers> answers;
    StudyQuestion asked;
    std::uint64_t folder_revision = 1;  // raised when a file was written, or may have been
    std::optional<std::size_t> shown;   // a participant; none: the mean
    StudyShow show = StudyShow::matrix;
    CollectRule rule;  // but for the attention, which is the design's
    LeavingOut leaving_out;

    std::string rounds_text;  // of sorting, while being typed
    std::string edited_text;  // id of the words being edited; empty: none

    // On the consent page.
    std::string code;
    std::string age;
    std::string gender;
    std::string hand;
    bool agrees = false;

    std::optional<std::size_t> held;      // pattern, in sorting: by the mouse or the keyboard
    std::optional<MapSettling> settling;  // of the run, in adaptive order, as of its last pause
    std::size_t pressed_button = 0;       // last: 0 left, 1 right
    std::shared_ptr<Device> device = std::make_shared<MemoryDevice>(false);  // never null
    bool has_window_device = false;   // it is the one that the window plays on
    StudyActuator actuator;           // of the run
    std::shared_ptr<Device> masking;  // on the participant's headphones; null: nothing is
    std::string masking_fault;        // a sentence; empty: it sounds, or is not asked for
    bool masks = false;
};

// Studies of the window: the folder of participants, the run of one, and what they said so far.

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
void choose_study_folder(Ui& ui, const Workspace& work, StudyState& studying);
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

// What a participant sees: one page at a time, over the whole window.
//
// Everything goes by keyboard as well, and the keys are on the page.

// The page of the run; there must be one.
void draw_study_pages(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                      std::span<const KeyPress> pressed);

// How much larger than on an ordinary screen a page is, so that it is read at arm's length in a
// window of this size; in eighths, as fonts are made again for each.
float wanted_page_scale(const Ui& ui, ImVec2 window_px);

// After kCallAfter plays in a row that were cut short.
inline constexpr const char* kCallText =
    "It is cut short again and again: please call the experimenter.";

// Content of pages, in the middle of `area`; each takes its own keys.
void draw_training_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                        const Rect& area, std::span<const KeyPress> pressed);
void draw_trial_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                     const Rect& area, std::span<const KeyPress> pressed);
void draw_sorting_page(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                       const Rect& area, std::span<const KeyPress> pressed);

// A large button with its key beneath; filled as far as its pattern has played. True when pressed.
struct FeelButton {
    const char* id;  // noted under this name
    std::string label;
    std::string key;  // shown small; may be empty
    bool is_playing = false;
    int times = 0;  // felt before
    bool is_enabled = true;
};
bool draw_feel_button(Ui& ui, const StudyState& studying, const Rect& area,
                      const FeelButton& button);

// The button at the foot of a page that leads to the next, and its size.
ImVec2 go_on_size(const Theme& theme);
void draw_go_on(Ui& ui, const Workspace& work, const PlayState& play, StudyState& studying,
                const Rect& area, const char* label);

// Share of the pattern that has played, 0 to 1.
float played_share(const Ui& ui, const StudyState& studying);

// A sign was typed, without Ctrl and the like.
bool was_typed(std::span<const KeyPress> pressed, char32_t sign);

// Words in the middle of a page.
void centred_text(const ImFont* font, ImU32 colour, const Rect& area, float y,
                  const std::string& text);

// The view of studies: what people are asked, who took part, what they said.

void draw_study_design(Ui& ui, Workspace& work, const PlayState& play, StudyState& studying);
void draw_study_people(Ui& ui, Workspace& work, Layout& layout, Timeline& timeline,
                       const ShownMap& shown_map, Comparing& comparing, PlayState& play,
                       StudyState& studying);
void draw_people_table(Ui& ui, const Workspace& work, Timeline& timeline, PlayState& play,
                       StudyState& studying, const StudyAnswers& answers);
void draw_study_answers(Ui& ui, const Workspace& work, ShownMap& shown_map, StudyState& studying);

// Who counts, decided by hand: someone left out with a reason, which the study's folder keeps, and
// rules on how people answered.

// Asks for the reason first.
void ask_to_leave_out(Ui& ui, StudyState& studying, const std::string& code);
void count_again(Ui& ui, const Workspace& work, StudyState& studying, const std::string& code);

inline constexpr Dialog kLeaveOutDialog{.title = "Leave a participant out", .is_of_document = true};
inline constexpr Dialog kConductDialog{.title = "Rules on how people answered"};
void draw_leave_out_dialog(Ui& ui, const Workspace& work, StudyState& studying);
void draw_conduct_dialog(Ui& ui, StudyState& studying);

// "3 rules...": how many are on, for the link that opens the dialog.
std::string conduct_summary(const ConductRule& rule);

}  // namespace tact
