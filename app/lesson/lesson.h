// The tour and lessons: steps, card, questions, presenting, writing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/document/editing.h"
#include "app/document/workspace.h"
#include "app/jobs/jobs.h"
#include "app/map/map.h"
#include "app/physiology/physiology.h"
#include "app/screen/screen.h"
#include "app/session/session.h"
#include "app/timeline/timeline.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "app/writing/writing.h"
#include "model/common/expected.h"
#include "model/lesson/lesson_numbers.h"
#include "viz/drawing/geometry.h"
#include "viz/space/space_camera.h"

namespace tact {

// The open lesson, its current step, and the view it has replaced.

// The parts of the view that a lesson changes, as they were before it.
struct ViewBeforeLesson {
    Layout layout;
    std::size_t current = 0;
    std::string pinned;
    Playhead playhead;
    TimeRange time_range;
    std::optional<Stage> open;
    SpaceCamera camera;
    float text_scale = 1.0F;
    int dimensions = 3;  // map dimensions
};

// The person's document while a lesson shows its set in place of it.
struct SetAside {
    EditedDocument document;
    DocumentEffects effects;
    Selection selection;
    Side side = Side::both;
    std::uint64_t number = 0;  // document number
};

using MapPlace = std::array<double, 2>;  // in a flat map

// The class's answers to a step's question.
struct Tally {
    std::array<int, limits::kMaxOptions> votes{};
    std::array<int, limits::kMaxOptions> elsewhere{};  // votes from phones, included in `votes`
    std::optional<MapPlace> place{};                   // the place chosen for the pattern
    bool revealed = false;

    bool operator==(const Tally&) const = default;
};

// The edge of the window at which the card stands.
enum class DockSide { right, bottom, left, top };

// The width of a card at the left or right edge, grown until all its words are visible.
struct CardGrowth {
    std::size_t step = 0;
    DockSide dock = DockSide::right;
    ImVec2 area{};  // window size
    float font_px = 0.0F;
    float width_px = 0.0F;
};

struct LessonAsked {
    std::shared_ptr<const Lesson> lesson;
    bool with_pairs = false;  // pairs take longer, so they come second

    bool operator==(const LessonAsked&) const = default;
};

struct LessonAnswered {
    std::shared_ptr<const Lesson> of;
    bool with_pairs = false;
    LessonAnswers answers;
};

inline constexpr float kPresentScale = 1.25F;  // text scale, on a screen of 1280 x 720

struct LessonState {
    std::shared_ptr<const Lesson> lesson;  // open; kept after it is left
    std::shared_ptr<const Lesson> shown;   // the same, in the shown language
    std::string language;                  // code of the wanted language; empty: the lesson's first
    std::filesystem::path path;            // its file; empty: no file
    std::string key;                       // path of its file or asset; empty: neither
    bool is_tour = false;
    bool is_of_set = false;  // made from the open set for presenting, without a set of its own
    std::optional<std::size_t> step;  // current step; nullopt: not running
    // The steps at which lessons were left before their end, by key; never a first step.
    std::map<std::string, std::size_t> left_at;
    ViewBeforeLesson before;
    std::optional<SetAside> aside;
    std::uint64_t document_number = 0;  // number of the shown set, while the lesson is open
    std::vector<Tally> tallies;         // one per step
    Query<LessonAsked, LessonAnswered> job;
    std::shared_ptr<const LessonAnswered> answered;

    // The edited lesson and its autosave.
    bool is_written = false;                  // it was or is edited
    std::shared_ptr<const Lesson> saved;      // last version begun, read or written
    std::shared_ptr<const Lesson> unsaved;    // version to be saved; null: nothing is unsaved ...
    std::shared_ptr<const Lesson> looked_at;  // ... for this lesson
    std::uint64_t looked_revision = 0;        // ... and this revision of the document
    bool keep_pending = false;
    double keep_due_s = 0.0;
    double unkept_since_s = 0.0;                // time of the first pending change
    std::future<std::string> autosave_write{};  // a running autosave; its value is the error
    std::string autosave_error;                 // error of the autosave
    std::filesystem::path kept_in;              // the last file with unsaved changes

    bool presenting = false;
    bool blank = false;
    bool editing = false;
    History<Lesson> history{};    // edits of the lesson
    std::uint64_t edited_at = 0;  // the document's revision at the last edit
    TextBox box;                  // the text field being edited
    bool shows_source = false;
    std::u32string lacking;  // characters of the step's texts that no installed font has
    DockSide dock = DockSide::right;
    float card_share = 0.24F;  // share of the window's width; of its height while editing
    float low_card_px = 0.0F;  // height of its words at the top or bottom; 0: not known yet
    CardGrowth grown;
    float present_scale = kPresentScale;      // text scale while presenting
    bool hands_on = false;                    // the next sheet is for a teacher
    std::filesystem::path sheet_to;           // path of a requested student sheet ...
    std::vector<std::string> sheet_pictures;  // ... and the pictures of its steps drawn so far
    std::string told;                         // last line for the speaker
    double presenting_since_s = 0.0;          // on the program's clock
    std::optional<bool> notes_wanted;  // a second window; nullopt: if there is a second screen
    bool shows_notes = false;          // the window is open
};

// A running lesson: it drives the real program through its steps with a set of its own, and
// restores document and view at the end.
//
// Input     a lesson; or the tour, the first of the lessons that come with the program

// Everything that a lesson drives.
struct LessonContext {
    Ui& ui;
    Workspace& work;
    Layout& layout;
    Timeline& timeline;
    ShownMap& shown_map;
    Physiology& physiology;
};

struct BundledLesson {
    const char* path;  // below assets/
    const char* name;  // the name inside the lesson
};

inline constexpr const char* kTourLesson = "lessons/tour.tactlesson.json";
inline constexpr std::array<BundledLesson, 8> kBundledLessons{{
    {"lessons/thresholds.tactlesson.json", "Thresholds by frequency"},
    {"lessons/pacinian_meissner.tactlesson.json", "Pacinian against Meissner"},
    {"lessons/twins.tactlesson.json", "Amplitude twins, and where they part"},
    {"lessons/beats.tactlesson.json", "Beats and amplitude modulation"},
    {"lessons/gaps.tactlesson.json", "Gaps, and the window of 10 ms"},
    {"lessons/why.tactlesson.json", "Why PM puts these two apart"},
    {"lessons/pipeline.tactlesson.json", "From two patterns to one distance"},
    {"lessons/mds.tactlesson.json", "How a perceptual space is made"},
}};

// A lesson that comes with the program.
std::shared_ptr<const Lesson> bundled_lesson(const char* path);

// The present view, to be restored when the lesson is left.
ViewBeforeLesson view_of(const LessonContext& context);

// Shows the lesson's set in place of the document, which is set aside, and goes to the first step.
void start_lesson(const LessonContext& context, LessonState& state,
                  std::shared_ptr<const Lesson> lesson, const std::filesystem::path& path);

// Starts a lesson that comes with the program, by its path below assets/.
void start_bundled_lesson(const LessonContext& context, LessonState& state, const char* path);

// Continues the tour at the step at which it was left, or starts it.
void start_tour(const LessonContext& context, LessonState& state);

// Asks whether to continue at the step at which this lesson was left before.
void ask_where_to_begin(const LessonContext& context, LessonState& state);

// The steps at which lessons were left, by key; the running lesson counts as left now.
std::map<std::string, std::size_t> places_left(const LessonState& state);

void open_lesson(const LessonContext& context, LessonState& state,
                 const std::filesystem::path& path);

void go_to_step(const LessonContext& context, LessonState& state, std::size_t step);

// Replaces the open lesson by this one, in the wanted language.
void show_lesson(LessonState& state, std::shared_ptr<const Lesson> lesson);

// The wanted language from now on, for every lesson that has it.
void choose_language(Ui& ui, LessonState& state, const std::string& code);

// Index of the shown language among the lesson's.
std::size_t shown_language(const LessonState& state);

// Restores the document and the view. Unsaved text of the lesson goes to a file of its own; if that
// cannot be written, the lesson stays open: false.
bool leave_lesson(const LessonContext& context, LessonState& state);

// Ends the lesson if another document was opened; unsaved changes of the document set aside go to a
// file of their own.
void follow_document(const LessonContext& context, LessonState& state);

// Steps name patterns, so they follow renaming.
void follow_renaming(LessonState& state, const Renaming& renaming);

// The lesson's numbers are computed in the background.
void follow_lesson(const Ui& ui, LessonState& state);
const LessonAnswers* answers_of(const LessonState& state);

// The current step, in the shown language; null if no lesson is running.
const LessonStep* step_of(const LessonState& state);

std::optional<Stage> stage_of_view(const std::string& view);
bool shows_map(const LessonStep& step);

// The card of a step: text, question, the class's answers, and buttons. It stands beside the panes,
// never over them.
//
// Output    the card's place and the rest of the window, which do not overlap

struct LessonPlaces {
    Rect card;  // empty: no lesson is running
    Rect rest;
};

// Fonts of the card: larger while presenting, for the last row of the class.
struct LessonFonts {
    ImFont* text;
    ImFont* head;
    ImFont* small;
};
LessonFonts lesson_fonts(const Ui& ui, const LessonState& state);

// Pure, for tests.
LessonPlaces lesson_places(const Ui& ui, const LessonState& state, const Rect& area);

void draw_lesson_card(const LessonContext& context, LessonState& state, const LessonPlaces& places);

// An outline around the item that the step points at, as drawn in this frame.
void watch_pointed(Ui& ui, const LessonState& state);
void draw_pointed(const Ui& ui, const Rect& within);

// Reveals a hidden answer, or goes to the next step. `back`: goes to the step before.
void step_on(const LessonContext& context, LessonState& state);
void step_back(const LessonContext& context, LessonState& state);

// All text of the lesson in the shown language: decides which glyphs are loaded.
std::string drawn_text(const LessonState& state);

// Loads fonts again if a step has characters that they lack; characters that no font has stay
// lacking.
void follow_glyphs(Ui& ui, LessonState& state);

// Moves the card to the next edge of the window.
void move_card(LessonState& state);

// Writing a lesson in the program: steps made from the screen, their texts and order.
//
// Output    the lesson as a new value; files change only when it is saved

// A step that shows the present view.
LessonStep step_from_screen(const LessonContext& context);

// Starts a lesson of the open document, with one step that shows the present view, in the editor.
void new_lesson(const LessonContext& context, LessonState& state);

// The same with a lesson that was written before for the open set.
void write_on_document(const LessonContext& context, LessonState& state,
                       std::shared_ptr<const Lesson> lesson);

void toggle_editing(const LessonContext& context, LessonState& state);

// One step of undo; with `joins` it merges with the last one of the same name. Texts of the step
// are in the shown language.
void change_lesson(const LessonContext& context, LessonState& state, Lesson lesson,
                   const std::string& what, bool joins = false);
void change_step(const LessonContext& context, LessonState& state, const LessonStep& step,
                 const std::string& what, bool joins = false);

void undo_lesson(const LessonContext& context, LessonState& state);
void redo_lesson(const LessonContext& context, LessonState& state);

// Ctrl+Z belongs to the lesson until the document changes.
bool was_lesson_edited_last(const Workspace& work, const LessonState& state);

// Takes pattern, partner, stage, times and camera of the current step from the screen.
void show_screen(const LessonContext& context, LessonState& state);
void take_camera(const LessonContext& context, LessonState& state, bool taken);

// Adds a step behind the current one, and goes to it.
void add_step(const LessonContext& context, LessonState& state);
void remove_step(const LessonContext& context, LessonState& state);
void move_step(const LessonContext& context, LessonState& state, int by);

// Name and description of the lesson, in the shown language.
void change_name(const LessonContext& context, LessonState& state, const LessonWords& shown,
                 bool joins = false);

// Replaces the lesson by a copy, "NAME copy", which is in no file yet. Unsaved changes of the
// lesson are in the copy.
void duplicate_lesson(const LessonContext& context, LessonState& state);

// Adds a language and shows it, to be written in.
void add_language(const LessonContext& context, LessonState& state, const std::string& code);
// Removes the shown language with all its texts, unless it is the first.
void remove_language(const LessonContext& context, LessonState& state);

// The lesson with its set as the document has it.
Lesson lesson_to_save(const Workspace& work, const LessonState& state);
void save_lesson_dialog(Ui& ui, Workspace& work, LessonState& state);
// An incomplete lesson is saved as a draft. False: it could not be saved.
bool save_lesson(Ui& ui, Workspace& work, LessonState& state, const std::filesystem::path& path);

// Tells what is still missing before a class can see the lesson.
void check_lesson(Ui& ui, const Workspace& work, const LessonState& state);

void save_sheet_dialog(Ui& ui, const Workspace& work, LessonState& state);
// A sheet for another teacher, with notes, answers and the lesson file inside.
void hand_on_dialog(Ui& ui, const Workspace& work, LessonState& state);

// Autosave of lessons: an unsaved lesson is written beside the document's autosave, the person is
// asked before another lesson replaces it, and otherwise it gets a file of its own.
//
// A lesson is unsaved if it was edited and differs from the last version begun, read or written.
// The set of a lesson that was begun from the document is the document's, and saved with it.

// The lesson to be saved; null: everything is saved.
std::shared_ptr<const Lesson> unsaved_lesson(const Workspace& work, const LessonState& state);

// Marks the lesson as saved, or as just begun.
void note_lesson_saved(const Workspace& work, LessonState& state);

// Once a frame: writes the autosave in the background when it is due.
void autosave_lesson_if_due(Ui& ui, Workspace& work, LessonState& state);
bool is_autosaving(const LessonState& state);

// Writes the autosave at once.
Expected<Done> keep_lesson(const Workspace& work, LessonState& state);

// Forgets unsaved changes: they are kept for the next start, or not wanted.
void let_lesson_go(LessonState& state);

// Moves unsaved changes to a lesson file of their own, which heads the recent ones, and sets
// `state.kept_in`. False: the file cannot be written, and the lesson has to stay open.
bool set_lesson_aside(const LessonContext& context, LessonState& state,
                      const std::shared_ptr<const Lesson>& unsaved);

// Calls `then` at once, or if something is unsaved, asks first and calls it once that is saved or
// kept as a draft.
void before_lesson_goes(const LessonContext& context, LessonState& state,
                        std::function<void()> then);

// Reopens the lesson that the last run left unsaved, in the editor.
void resume_lesson(const LessonContext& context, LessonState& state, LessonDraft draft);

// Placing a pattern in the map oneself: the map hides it until the answer is revealed, then shows
// the distance between the two places.
//
// Input     the left mouse button in the map, or Shift and the arrows; the map is flat meanwhile
// Output    a cross at the chosen place, and a line to the model's place

// Whether the current step asks for a place.
bool asks_for_place(const LessonState& state);

// The part of it that the map shows.
void mark_place(const LessonState& state, const ShownMap& shown_map, MapMarks& marks);

// Takes the clicks and keys of the map.
void take_place(LessonState& state, const SpacePaneAction& done);
bool nudge_place(LessonState& state, const ShownMap& shown_map, const KeyPress& press);

// Distance from the model's place, as a share of the map's width: the largest distance between two
// points. Nullopt without a place or a map.
std::optional<double> place_off_by(const LessonState& state, const ShownMap& shown_map);
std::string place_text(const LessonState& state, const ShownMap& shown_map);

// Without votes, the pattern nearest to the place counts as one vote.
void count_place(LessonState& state, const ShownMap& shown_map);

// Predict, then reveal: a question of a step, the class's votes by number keys, the answer.
//
// Output    right if an answer of the model has the most votes

// The question of the step; null if it has none, or one that cannot be answered yet, which only the
// editor shows.
const LessonQuestion* question_of(const LessonState& state);

// Whether the step has a question whose answer is still hidden.
bool hides_answer(const LessonState& state);

void draw_lesson_question(const LessonContext& context, LessonState& state,
                          const LessonQuestion& question);

// Adds a vote for an option, from 0; ignored once the answer is revealed. False: the option does
// not exist.
bool vote(LessonState& state, std::size_t option);

// The question in words with numbers, for people who answer on their own devices.
struct QuestionInWords {
    std::string ask;
    std::vector<std::string> options;
    bool is_revealed = false;
    std::vector<std::size_t> right;
    std::string reveal;  // part of the answer
};
// Nullopt without a question, or while the model still computes its answer.
std::optional<QuestionInWords> question_in_words(const LessonState& state);

// All votes from phones for the step's question; they count in addition to hands.
void count_elsewhere(LessonState& state, const std::vector<int>& votes);

struct LessonScore {
    int asked = 0;  // revealed, with votes
    int right = 0;
};

LessonScore score_of(const LessonState& state);

// A lesson on paper, as one page that needs no other file: for students to fill in, or for another
// teacher, with notes and answers beside the steps and the lesson file inside.
//
// Input     the lesson, its numbers and answers, a picture of each step
// Output    HTML (app/report/report.h): steps with pictures and texts, questions with room for an
//           answer, the answers on a separate page, the sources
// Exact     same input, same bytes.

struct LessonSheet {
    const Lesson& lesson;
    const LessonAnswers& answers;
    std::vector<std::string> pictures{};  // SVG of each step; empty: no picture
    std::string program{};                // "tactspace 0.1.0"
    // For a teacher: the lesson file, which the page contains; empty: for students.
    std::string lesson_file{};
};

std::string lesson_sheet(const LessonSheet& sheet);

// The lesson as a file that needs no other: with its set, and all its languages. An Error if the
// set has recordings, whose waveforms a lesson file cannot hold.
Expected<std::string> whole_lesson_file(Lesson lesson);

// A lesson on a projector: the whole screen, large text, a clicker's keys, a blank screen, a
// visible pointer, and notes for the speaker.
//
// Input     Page Up, Page Down, arrows, Enter, Space, Backspace, Home, End; B or full stop blanks;
//           P plays or halts; M moves the card; N shows the speaker's notes in a second window;
//           number keys vote; Esc and F5 leave

// Presents the running lesson, or the last open one, or the tour; called again, returns to the
// window.
// A lesson of the open set: one step for the map, and one for each pattern that counts. It names
// patterns of the document, and has no set of its own.
Lesson lesson_of_set(const Workspace& work);

// Presents the running lesson, or the open set, or the tour if the set is empty. A lesson of the
// set ends with presenting.
void toggle_presenting(const LessonContext& context, LessonState& state);

bool is_presenting(const LessonState& state);

// Magnification against a screen of 1280 x 720, at most 4: a class sees the screen as a whole,
// whatever its number of pixels and the distance of its owner.
float presented_growth(ImVec2 screen_px);

// Handles the keys that belong to lessons; leaves the rest of the program's.
std::vector<KeyPress> take_lesson_keys(const LessonContext& context, LessonState& state,
                                       std::span<const KeyPress> pressed);

// Drawn over everything: the blank screen, and a ring around the moving mouse.
void draw_over_presentation(Ui& ui, const LessonState& state);

// Notes that only the speaker sees: the step's note, its answer, the next title and the elapsed
// time, in a second window or as a line of the terminal.

struct SpeakerNotes {
    std::string count;   // "3 of 18"
    std::string title;   // the step's title
    std::string note;    // empty: no note
    std::string answer;  // answer to its question
    std::string next;    // the next step's title; empty: last step
    int minutes = 0;     // elapsed time of presenting

    bool operator==(const SpeakerNotes&) const = default;
};

// Nullopt unless presenting.
std::optional<SpeakerNotes> speaker_notes(const LessonState& state, double now_s);

// One line, with its numbers.
std::string speaker_line(const LessonState& state);

void draw_speaker_notes(const Theme& theme, const SpeakerNotes& notes);

// The second window: shown on a second screen, or on request.
bool wants_notes_window(const LessonState& state, bool second_screen);
SideContent notes_window(const SpeakerNotes& notes, bool dark);

// N: shows or hides the notes.
void toggle_notes(LessonState& state);

// Seconds until the elapsed minutes in the notes change.
double notes_wake_s(const LessonState& state, double now_s);

}  // namespace tact
