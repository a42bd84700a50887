// The interface of a frame: theme, places of widgets, keys, dialogs and questions.
#pragma once

#include <imgui.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "viz/drawing/geometry.h"
#include "viz/drawing/theme.h"

struct ImGuiWindow;

namespace tact {

// The content of a folder, for a person to choose from.
//
// Output    folders and files by name, with the time of their last change; or an error as a
//           sentence
// Left out  hidden files, sizes.

struct FolderEntry {
    std::string name;
    bool is_folder = false;
    std::string changed{};  // "2026-11-23 18:40", local time; empty: not known

    bool operator==(const FolderEntry&) const = default;
};

struct FolderListing {
    std::filesystem::path folder;
    std::vector<FolderEntry> entries;  // folders first, then in natural order: 2 before 10
    std::string fault;                 // the reason why there are no rows, a sentence
};

// Leaves out hidden files, and files without one of the extensions (".wav"; empty: all files).
FolderListing list_folder(const std::filesystem::path& folder,
                          const std::vector<std::string>& extensions);

// Whether the name has one of the extensions, case ignored; true without extensions.
bool has_extension(const std::string& name, const std::vector<std::string>& extensions);

// The home folder; the root if the environment does not tell.
std::filesystem::path home_folder();

// False also for a path that cannot be read.
bool is_folder(const std::filesystem::path& path);

// A dialog to open or save a file, or to save into a folder, which may be new.
//
// Typing always goes into the name field, so that the keyboard is enough: up and down walk through
// the folder, Enter opens, Backspace in the empty field goes to the parent, Esc leaves; a typed
// path may be absolute, relative or start with ~. Ctrl+Enter takes the folder itself. Tab goes to
// the buttons.
//
// Input     a folder to start in and the kinds of file wanted
// Output    the chosen path, once
// Left out  hidden files, sizes, several files at once, making folders of folders.

struct Ui;

enum class ChooserUse { open, save, save_folder };

struct FileChooser {
    // The caller's wishes; to be set before show().
    ChooserUse use = ChooserUse::open;
    std::string title = "Open";
    std::vector<std::string> extensions;        // the first is added to a name saved without an
                                                // extension
    bool folders_too = false;                   // a folder may be the answer
    std::vector<std::string> file_names;        // files that go into the folder of save_folder
    std::vector<std::filesystem::path> recent;  // recently used folders

    // The present state of the dialog.
    bool is_open = false;
    bool appears = false;  // opened since the last frame
    FolderListing listing;
    std::string name;                   // as typed
    std::string offered;                // offered by the caller: returns after each change of
                                        // folder
    std::optional<std::size_t> cursor;  // row of the listing
    bool scroll_to_cursor = false;
    bool focus_name = false;
    std::string remark;               // error of the last attempt
    bool makes_folder = false;        // the name is that of a folder to be made here
    std::filesystem::path replacing;  // exists; waits for confirmation
};

// Opens the dialog in the next frame. A missing folder is replaced by the home folder.
void show(FileChooser& chooser, const std::filesystem::path& folder, const std::string& name = "");

// Draws the dialog if it is open. Returns the path in the frame in which it is chosen.
std::optional<std::filesystem::path> draw_file_chooser(Ui& ui);

// A question over the window: a sentence, and answers; one must be chosen before anything else.
//
// The keyboard is enough: arrows and Tab move along the answers, Enter takes the marked one, Esc
// the last one, which changes nothing.
//
// Left out  a queue of questions: a new one replaces the open one as if Esc had been pressed.

struct Ui;

struct Answer {
    std::string label;            // a verb
    std::function<void()> run{};  // null: nothing happens
};

struct Question {
    std::string title;
    std::string text;
    std::vector<Answer> answers;  // the first is safe, and marked; the last changes nothing
    std::size_t marked = 0;
};

// Replaces any open dialog.
void ask(Ui& ui, Question question);

// A message that has no other place; it stays until it is read.
void tell(Ui& ui, const std::string& title, const std::string& text);

void draw_question(Ui& ui);

// Tab: from control to control, in reading order.
//
// ImGui's own Tab knows only text fields, and one window at a time. Here every noted item that can
// be pressed or typed in is a stop, over all panes, or within the topmost popup. Ctrl+Tab goes to
// the next pane; after a click into a number, or typing one, Tab goes to the next number. Enter
// presses the item with the focus; arrows move within a list, whose rows are one stop.
//
// Left out  menus (Alt), and sliders that have an entry beside them.

struct Ui;

struct TabStop {
    ImGuiWindow* window;
    unsigned id;
    float left, top, right, bottom;  // on the screen, px
    bool is_typed_in;
};

// Requests of this frame's keys, and the stops that they apply to.
struct TabOrder {
    std::vector<TabStop> stops;     // of this frame
    std::vector<unsigned> numbers;  // stops that are entries of numbers
    int step = 0;                   // 1: forward, -1: back
    bool by_pane = false;
    bool is_on_button = false;  // Enter presses that, and nothing else
    bool has_begun = false;     // Tab continues from the last used stop; false: from the first one
    unsigned over = 0;          // ImGui's id of the topmost popup; 0: none
};

// Makes the last ImGui item a stop, if it can be one.
void note_stop(TabOrder& order);

// Ends a frame: moves the focus, and draws its frame.
void move_focus(Ui& ui);

// Places of items on the screen: for Tab, for a lesson that points at one, and for tests that click
// on the real window.
//
// Input     TACTSPACE_WIDGET_RECTS, the file that is rewritten after each frame that changed
// Output    one line per item: name, left, top, right, bottom in pixels, then its value

struct WidgetRects {
    std::filesystem::path file;  // empty: no file is written
    TabOrder tab_order;
    std::string watched;  // the place of each name in this frame
    std::optional<Rect> watched_at;
    std::string lines;
    std::string written;
};

// The file named by the environment.
WidgetRects widget_rects_wanted();

void note_rect(WidgetRects& rects, const std::string& name, ImVec2 min, ImVec2 max,
               const std::string& value = {});

// Notes the rectangle of the last ImGui item.
void note_item(WidgetRects& rects, const std::string& name, const std::string& value = {});

// Ends a frame: rewrites the file if any place or value changed.
void write_rects(WidgetRects& rects);

// Shared by all panes that draw: looks, clock, keyboard, status line, and popups.

// A dialog over the panes. A room declares its own, and draws it while it is that of Ui.
struct Dialog {
    const char* title = "";       // tells it from the others
    bool is_of_document = false;  // it holds data of the document, and closes with it

    bool operator==(const Dialog& other) const { return std::string_view(title) == other.title; }
};
inline constexpr Dialog kNoDialog{};

// The entry in which a number is typed: its state between frames.
struct NumberTyping {
    unsigned entry = 0;      // ImGui's id of the entry with the keyboard; 0: none
    int frame = 0;           // time of its last frame
    std::string text;        // its present text
    std::string first;       // its text at first, to which Esc returns ...
    double before = 0.0;     // ... and its number
    std::string taken;       // its text when it was last accepted: an arrow accepts at once
    bool by_number = false;  // Tab goes to the next number, past everything else
    unsigned refused = 0;    // the entry whose last text was refused
};

// The field with the keyboard, and the number typed in it.
struct FieldEntry {
    std::string active;  // arrows nudge it
    std::string wanted;  // gets the keyboard when it is drawn next
    std::string locked;  // a locked field was clicked: keys meant for it have no other effect
    NumberTyping typing;
    bool tabbed_on = false;      // Tab is moving from a number to the next one
    float wheel = 0.0F;          // turns of the wheel over the focused field, below one step
    std::vector<double> before;  // its value in each of several patterns, when the gesture began
    std::size_t clamped = 0;     // the number of patterns that could not follow
    std::string nudged;          // by arrows ...
    double nudged_s = -10.0;     // ... and the time: another one soon after is the same undo step
    bool nudges_on = false;      // the step that is committed next merges with the last one
};

// The line at the bottom of the window; errors stay until replaced, other messages fade.
struct StatusLine {
    std::string text;
    bool is_error = false;
    double since_s = 0.0;  // time of the message, or of the first input after it
    bool is_seen = false;  // a person was active since then
    // A link behind it, and its action; with a link the line stays until it is closed.
    std::string more{};
    std::function<void()> show_more{};
};

// The result shown in a pane, and the time since a newer one is computed.
struct ShownAge {
    std::shared_ptr<const void> of;
    bool stale = false;
    double since_s = 0.0;
};

// The share of work when it was drawn last, and the time at which it began.
struct ProgressSeen {
    float share = 0.0F;
    double since_s = 0.0;
    double last_s = -100.0;
};

struct Ui {
    Theme theme;
    bool dark = true;
    float text_scale = 1.0F;     // the person's, multiplied by the screen's
    float content_scale = 1.0F;  // the screen's
    bool fonts_outdated = false;
    bool motion = true;
    bool as_picture = false;     // for a picture: panes without buttons and links
    bool presenting = false;     // for a class: without hints and links
    bool for_fingers = false;    // targets are as large as a finger needs
    bool keyboard_mode = false;  // Tab moves between widgets, until the mouse is used again
    FileChooser chooser;
    std::function<void(const std::filesystem::path&)> take_chosen;  // the chooser's answer
    Dialog dialog{};
    bool escape_taken = false;         // Esc has stopped a device in this frame, and closes nothing
    std::optional<Question> question;  // over everything else
    StatusLine status;
    // Work that must not run while panes are drawn: a shortcut during a drag or typing, an action
    // of a row among its rows. It runs in the same frame, after the panels or after the dialogs.
    std::vector<std::function<void()>> waiting;
    double time_s = 0.0;         // time of this frame
    double frame_s = 0.0;        // since the last frame; short after a rest
    double hover_since_s = 0.0;  // time at which the mouse came to rest
    bool has_pressed = false;    // since it came to rest: no tooltip over the pressed item
    bool quit = false;
    WidgetRects rects;
    std::function<void()> wake;  // draws a frame soon; from any thread. Empty: no jobs
    // Lets a person pick files in a dialog of the browser's, which come as if dropped; empty where
    // the program sees all files itself.
    std::function<void()> pick_files;
    // This frame's words for a screen reader, a line each: a card, a question, what panes tell.
    std::string reading;
    FieldEntry field;
    std::set<std::string> dismissed_hints;
    std::map<std::string, ShownAge> ages;          // by pane
    std::map<std::string, ProgressSeen> progress;  // by the name of the work
};

// Whether rooms ask on their own in the background: in a window. A picture has all its answers.
inline bool has_jobs(const Ui& ui) { return ui.wake != nullptr; }

inline void read_out(Ui& ui, const std::string& words) { ui.reading += words + '\n'; }

// Show a message in the status line; complaints stay until the next message.
void say(Ui& ui, const std::string& text);
void complain(Ui& ui, const std::string& text);

// Whether an outdated result is to look so: only after 0.3 s, as a pane always lags a little during
// a drag. In a picture at once.
bool looks_stale(Ui& ui, const std::string& pane, std::shared_ptr<const void> shown, bool stale);
// Seconds until the next of them is to look so.
double aging_wake_s(const Ui& ui);

// Looks of the next frame.
void set_text_scale(Ui& ui, float scale);
void step_text_scale(Ui& ui, float factor);
void set_theme(Ui& ui, bool dark);

// Asking for a file or a folder, with what happens with the answer.

struct FileQuestion {
    ChooserUse use = ChooserUse::open;
    std::string title{};
    std::vector<std::string> extensions{};  // ".wav"; empty: all files
    bool folders_too = false;
    std::vector<std::string> file_names{};  // files that go into the folder of save_folder
    // Gets the chosen path, frames later: what it holds by reference lives as long as `ui`.
    std::function<void(const std::filesystem::path&)> take{};
};

// Opens the dialog in a folder (if missing: the home folder), with a name offered.
void ask_for_file(Ui& ui, const FileQuestion& question, const std::filesystem::path& folder,
                  const std::string& name = {});

// Begin and end of every dialog over the window.

// The place of a dialog in the window.
enum class DialogSide {
    middle,
    right  // clear of the map, which the dialog is about
};

// Begins a dialog over the window. If true, everything up to begin_foot() scrolls when the window
// is too low for it, and one of the functions below must end the dialog.
bool begin_dialog(const Ui& ui, const char* title, float width_px = 620.0F,
                  DialogSide side = DialogSide::middle);
// The same for that of Ui; false for any other.
bool begin_dialog(const Ui& ui, const Dialog& dialog, float width_px = 620.0F,
                  DialogSide side = DialogSide::middle);

// Begins the part that always stays visible: buttons, and the values they apply to.
void begin_foot(const Ui& ui);

// Replaces ImGui::EndPopup(), after begin_foot().
void end_foot();

// Ends a dialog without an answer, before begin_foot(), because another one replaces it.
void give_way(Ui& ui);

// The largest height of the scrolling part, for a list in it that scrolls by itself.
float dialog_room_px();

// Presses the item with the focus of Tab, as Enter does: a button, a link, a choice; text fields
// take Enter themselves.
void press_focused(const Ui& ui);

// Style for the begin of a window that should look like a dialog.
ImFont* push_dialog_head(const Theme& theme);  // the previous font
void pop_dialog_head(ImFont* before);

// For any popup: a dialog, a menu, a list.
bool is_popup_open();

// Draws the frames of everything over the panes, at the end of a frame.
void draw_shadows(const Theme& theme);

// The last line of a dialog, with Close; Esc and Enter do the same.
void end_dialog(Ui& ui);

// The buttons at the end of a dialog. True if the person chose `action`, also with Enter; either
// button closes the dialog.
bool draw_ends(Ui& ui, const char* action, bool enabled);

// The answer of a file chooser to the text in its name field: a path, another folder, or an error.
//
// Output    the chosen path; nullopt: the chooser asks, goes to a folder, or states in its remark
//           what is missing
// Errors    errors of the file system are remarks, too

// Goes to another folder, with the name that the caller offers.
void go_to_folder(FileChooser& chooser, const std::filesystem::path& folder);

// Enter with the present name.
std::optional<std::filesystem::path> accept_name(FileChooser& chooser);

// Chooses the folder itself, if that is allowed.
std::optional<std::filesystem::path> accept_folder(FileChooser& chooser);

// Makes the named folder here and goes into it.
void make_folder(FileChooser& chooser);

// The reason why nothing can be opened or saved yet; empty: it can.
const char* lack_of_name(const FileChooser& chooser);

// "No .wav, .csv here."; empty if there is such a file.
std::string lack_of_files(const FileChooser& chooser);

}  // namespace tact
