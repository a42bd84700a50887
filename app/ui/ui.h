// Shared by all panes that draw: looks, clock, keyboard, status line, and popups.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/ui/file_chooser.h"
#include "app/ui/question.h"
#include "app/ui/widget_rects.h"
#include "viz/drawing/theme.h"

namespace tact {

// Dialogs over the panes.
enum class Dialog {
    none,
    about,
    keys,
    devices,
    effect_maps,
    calibrate,
    export_view,
    export_animation,
    export_effects,
    paper,
    from_sound,
    generate,
    import_recordings,
    open_table,
    simulate_measurement,
    steps,
    tap_rhythm,
    transform,
    pad,
    leave_out,
    plan,
    phones,
    save_workspace,
    conduct_rules,
    course
};

// The purpose of a chosen path.
enum class ChooserPurpose {
    open_document,
    open_library,
    add_to_set,
    save_document,
    load_tables,
    load_ratings,
    add_metric,
    open_table,
    load_calibration,
    load_model,
    save_model,
    add_training_set,
    save_calibration_signal,
    open_calibration_recording,
    import_recordings,
    from_sound,
    study_folder,
    export_study,
    preregister,
    export_view,
    export_subset,
    export_report,
    export_effects,
    paper_set,
    paper_folder,
    export_stages,
    export_animation,
    open_lesson,
    save_lesson,
    lesson_sheet,
    course_answers
};

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
    ChooserPurpose chooser_purpose = ChooserPurpose::open_document;
    Dialog dialog = Dialog::none;
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

}  // namespace tact
