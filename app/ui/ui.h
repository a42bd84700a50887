// What every pane draws with: looks, clock, keyboard, the line at the foot, and what lies over the
// panes.
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

// What may lie over the panes.
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

// What a chosen path is for.
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

// The number that is being typed in an entry: what of it outlives a frame.
struct NumberTyping {
    unsigned entry = 0;      // ImGui's name of the one with the keyboard; 0: none
    int frame = 0;           // when it was last drawn so
    std::string text;        // as it stands there
    std::string first;       // as it stood there at first: what Esc goes back to ...
    double before = 0.0;     // ... and the number that was
    std::string taken;       // as it stood when it was last taken: an arrow takes at once
    bool by_number = false;  // Tab goes on to the next number, past all else
    unsigned refused = 0;    // the entry whose last text was no good
};

// The field that keys go to, and the number that is being typed in it.
struct FieldEntry {
    std::string active;  // arrows nudge it
    std::string wanted;  // takes the keys when it is drawn next
    std::string locked;  // clicked in vain: keys meant for it do nothing else
    NumberTyping typing;
    bool tabbed_on = false;      // Tab is on its way from a number to the next one
    float wheel = 0.0F;          // turns over the focused field that are no whole step yet
    std::vector<double> before;  // in each of several patterns, when the gesture began
    std::size_t clamped = 0;     // of them: how many could not follow to where it led
    std::string nudged;          // by arrows ...
    double nudged_s = -10.0;     // ... and when: more of it soon is the same undo step
    bool nudges_on = false;      // the step that is about to be committed joins the last one
};

// The line at the foot.
// A line at the foot of the window; errors stay until replaced, the rest fades.
struct StatusLine {
    std::string text;
    bool is_error = false;
    double since_s = 0.0;  // it was said, or the mouse or a key was used for the first time since
    bool is_seen = false;  // somebody is there
    // A link behind it, and what that does; with one the line stays until it is put away.
    std::string more{};
    std::function<void()> show_more{};
};

// What a pane shows, and since when something newer is on its way.
struct ShownAge {
    std::shared_ptr<const void> of;
    bool stale = false;
    double since_s = 0.0;
};

// How far work was when it was drawn last, and since when it has been.
struct ProgressSeen {
    float share = 0.0F;
    double since_s = 0.0;
    double last_s = -100.0;
};

struct Ui {
    Theme theme;
    bool dark = true;
    float text_scale = 1.0F;     // the person's, on top of the screen's
    float content_scale = 1.0F;  // the screen's
    bool fonts_outdated = false;
    bool motion = true;
    bool as_picture = false;     // panes without what is there to be pressed
    bool presenting = false;     // for a class: without hints and links
    bool keyboard_mode = false;  // Tab moves between widgets, until the mouse is used again
    FileChooser chooser;
    ChooserPurpose chooser_purpose = ChooserPurpose::open_document;
    Dialog dialog = Dialog::none;
    bool escape_taken = false;  // Esc has silenced something in this frame: it closes nothing
    std::optional<Question> question;  // over everything else
    StatusLine status;
    // What may not be done in the middle of what is being drawn: a shortcut while something is
    // dragged or typed, an action of a row while rows are drawn. It is done in the same frame,
    // after the panels, or after the dialogs.
    std::vector<std::function<void()>> waiting;
    double time_s = 0.0;         // of the current frame
    double frame_s = 0.0;        // since the last one; short after a rest
    double hover_since_s = 0.0;  // when the mouse came to rest
    bool has_pressed = false;    // since then: no tooltip over what was just pressed
    bool quit = false;
    WidgetRects rects;
    std::function<void()> wake;  // draws a frame soon; from any thread
    FieldEntry field;
    std::set<std::string> dismissed_hints;
    std::map<std::string, ShownAge> ages;          // by pane
    std::map<std::string, ProgressSeen> progress;  // by what is under way
};

// Says something at the foot of the window; complaints stay until something else is said.
void say(Ui& ui, const std::string& text);
void complain(Ui& ui, const std::string& text);

// Whether what is shown, of an earlier state, is to look so: not before it is 0.3 s behind, as a
// pane that follows a drag is always a little behind. A picture says it at once.
bool looks_stale(Ui& ui, const std::string& pane, std::shared_ptr<const void> shown, bool stale);
// Until the next of them is to look so, s.
double aging_wake_s(const Ui& ui);

// Looks, as of the next frame.
void set_text_scale(Ui& ui, float scale);
void step_text_scale(Ui& ui, float factor);
void set_theme(Ui& ui, bool dark);

}  // namespace tact
