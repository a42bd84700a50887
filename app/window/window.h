// The window: frame, panes, menus, commands, pictures of the whole.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/export/export.h"
#include "app/manual/manual.h"
#include "app/map/map.h"
#include "app/physiology/physiology.h"
#include "app/pictures/pictures.h"
#include "app/screen/screen.h"
#include "app/window/app.h"
#include "devices/calibration/rendering.h"
#include "model/common/expected.h"
#include "viz/drawing/geometry.h"
#include "viz/picture/picture.h"

namespace tact {

// Pictures of the program: a view, and an animation as numbered pictures.
//
// They are drawn between the window's frames, because ImGui draws one thing at a time; an animation
// draws one picture between two frames, so that the window keeps answering.
//
// Input     the program as it is when an export begins; later edits are not in it
// Output    whole files, also of a cancelled export; the status line tells where

void export_animation(App& app, const std::filesystem::path& folder);
void cancel_animation(App& app);

// One step of a lesson as SVG, as the program would open on it.
std::string step_picture(const Lesson& lesson, std::size_t step);

// Whether continue_exports() has a picture to draw. It draws one, and must be called between two
// frames.
bool is_exporting(const App& app);
void continue_exports(App& app);

// Places of the panes: list, map and answers side by side with the editor below the last two, or
// three columns, two of them split. Bars between the panes change their shares.

// All panes, or the one that fills the window.
void draw_columns(App& app, const Rect& area);

// A lesson on the whole screen: its card, and only the pane that the step shows.
void draw_presentation(App& app);

// The view of studies, in place of the panes.
void draw_study_columns(App& app, const Rect& area);

// The place of the middle column, for popups beside it.
Rect physiology_area(const App& app, const Rect& columns);

// One pane with its title and content.
void draw_pane_of(App& app, Pane pane, const Rect& area);

// Controls drawn over a pane.
std::string name_of_pane(const App& app, Pane pane);

// Marks that all rooms draw over the map.
MapMarks map_marks(App& app);

// Actions of commands that need more than one room, and the conditions for them.

inline bool always(const App&) { return true; }
bool has_selection(const App& app);
bool has_effects(const App& app);
bool has_unread_files(const App& app);
bool has_answers(const App& app);
bool has_subset(const App& app);
bool has_pairs(const App& app);
bool has_editable_pattern(const App& app);
bool has_neighbours(const App& app);
bool has_corners(const App& app);
bool has_missing(const App& app);
bool has_exact_map(const App& app);
bool has_exact_subset(const App& app);
bool has_study(const App& app);
bool has_map_of_all(const App& app);

bool has_chosen_notes(const App& app);
bool has_layers(const App& app);
bool can_add_layer(const App& app);
bool can_layer_selected(const App& app);

// For the notes chosen on the strip; without any, for the selected patterns.
void remove_chosen_or_selected(App& app);
void copy_notes_or_selected(App& app);
void paste_notes_or_patterns(App& app);
void double_notes_or_selected(App& app);
void choose_all(App& app);

void start_rename(App& app);
void open_effect_export(App& app);
void swap_alternating(App& app);
void rewind(App& app);
void escape(App& app);
void show_workspace(App& app, Arrangement arrangement);
bool is_workspace(const App& app, Arrangement arrangement);
void reset_workspace(App& app);
void maximise_or_restore(App& app);
// Whether panes stand side by side, with bars between them.
bool has_bars(const App& app);
void fold_physiology(App& app, Fold fold);
void show_tab(App& app, BenchTab tab);
void show_training(App& app);
void show_findings(App& app);
void begin_tour(App& app);
void present(App& app);
void leave_the_lesson(App& app);
void begin_lesson(App& app);
// The program, its version and licences.
inline constexpr Dialog kAboutDialog{.title = "About tactspace"};

// Opens a lesson, or a file that can be a set; asks about unsaved changes of an open lesson.
void open_file(App& app, const std::filesystem::path& path);
// Ask for a file to open.
void open_dialog(App& app);
void open_lesson_dialog(App& app, const char* title);
void open_bundled_lesson(App& app, const char* path);
void open_course_of_program(App& app);
void begin_lesson_of_course(App& app, std::size_t which);
void check_the_lesson(App& app);
void duplicate_the_lesson(App& app);
bool has_lesson(const App& app);
bool has_undo(const App& app);
bool has_redo(const App& app);
bool has_sound(const App& app);
void tour_from_the_start(App& app);
void copy_shown_table(App& app);

// All commands of the program in one table, from which menus, shortcuts and the command palette are
// made.

struct Shortcut {
    char32_t sign = 0;         // the sign that the key writes: layouts differ in its place
    int code = key::kUnknown;  // for keys that write no sign
    bool ctrl = false;
    bool shift = false;
};

constexpr Shortcut ctrl(char32_t sign, bool shift = false) {
    return {sign, key::kUnknown, true, shift};
}
constexpr Shortcut plain(char32_t sign) { return {sign, key::kUnknown, false, false}; }
constexpr Shortcut special(int code, bool shift = false) { return {0, code, false, shift}; }

struct Command {
    const char* menu;  // "Edit"
    const char* name;
    Shortcut shortcut;
    bool (*enabled)(const App&);
    void (*run)(App&);
    bool (*checked)(const App&) = nullptr;
    const char* words = "";  // more words by which the palette finds it
};

inline constexpr const char* kExampleMenu = "Example sets";  // within File

std::span<const Command> commands();
std::span<const Command> document_commands();  // the order of menus: File, Edit ...
std::span<const Command> view_commands();      // ... and View

// Runs it, and notes its name for crash reports.
void carry_out(App& app, const Command& command);

// The reason why it is disabled; null: it can run.
const char* what_lacks(const App& app, const Command& command);

// "Ctrl+Shift+Z"; empty without one.
std::string shortcut_text(const Shortcut& shortcut);

// The name; for Undo and Redo with the step's label.
std::string item_text(const App& app, const Command& command);

// Its place: "View > Map > Frame the selection in the space".
std::string menu_path(const Command& command);

// Runs the commands of this frame's key presses. While text is being typed, only Ctrl combinations
// that text fields do not use.
void run_shortcuts(App& app, std::span<const KeyPress> pressed);

void draw_menus(App& app);

// A right click that nothing else in the pane takes: a menu for the pane as a whole.
void draw_pane_menu(App& app, Pane pane);

// Commands that begin a group in their menu, below a line.
std::span<const std::string_view> menu_groups();

// The command palette: every command, found by a few letters of its name.
void draw_palette(App& app, std::span<const KeyPress> pressed);

// Dialogs over the window: files, keys, about, and those of every room.

void draw_dialogs(App& app);

// The list of keys for F1 and the manual.
std::span<const KeyRow> keys_and_mouse();

// Whether a question or a participant comes first: opening another set would replace the data
// behind them.
bool is_in_the_middle(const App& app);

// Opens dropped files: tables of ratings or of accelerations go to the open set, other files are
// opened.
void drop_paths(App& app, const std::vector<std::filesystem::path>& paths);

// One frame of the program: input, answers of the jobs, menus, panes, dialogs.

// Carries changes of the document to everything that holds patterns by name, or files beside the
// document. Part of each frame.
void follow_changes(App& app);

// Draws everything into the current ImGui frame. `time_s` never decreases.
void draw_frame(App& app, std::span<const KeyPress> pressed, double time_s);

// The panes without side effects, for a picture: no input, no playing, no jobs, no autosave.
void draw_still_window(App& app);

// Another frame is needed without input, because something moves.
bool wants_another_frame(const App& app);

// Seconds until the next frame is needed without input: for progress, a fading status line, the
// autosave. Infinite: no frame is needed.
double next_wake_s(const App& app);

// The full map is being computed: its progress should be drawn from time to time.
bool is_computing(const App& app);

// The same for a comparison with people, or a check of findings.
bool is_comparing(const App& app);

// An App with theme and layout, ready for start_session(); make_theme() makes its fonts.
App make_app();

// Theme, fonts and style for the current ImGui context, scaled by app.ui.content_scale x
// app.ui.text_scale, and larger for a participant. The atlas must be empty.
void make_theme(App& app);

// The program with its window on the screen: opens it on the sets, or without any on the last
// session; returns when it is closed.
Expected<Done> run_main_window(const std::vector<std::filesystem::path>& sets);

// Background jobs of all rooms: collected together, and begun again for another document.

// Collects the results since the last frame.
void collect_results(App& app);

// If another document is open than in the frame before, every room is reset: no result, selection
// or text of the old document appears under the name of the new one. Settings of the person stay:
// looks, layout, devices, the open tabs.
void follow_another_document(App& app);

// The state of the window between runs: sizes of panes, camera, looks, device, and the open
// document.

// Opens the paths, or restores the last session, or shows the example set. An Error if the paths
// cannot be opened.
Expected<Done> start_session(App& app, const std::vector<std::filesystem::path>& paths);

// Sizes of the panes and the camera, to and from the session.
void keep_layout(App& app);
void restore_layout(App& app);

void end_session(App& app);

// The program ends in the middle of a frame: unsaved changes are kept for the next start. An Error:
// they are lost.
Expected<Done> keep_before_end(App& app);

// Whether the window may close: unsaved changes are kept for the next start. If they cannot be
// kept, the window stays and asks. A running study ends first; its answers are on the disk.
bool may_close(App& app);
// The same if a person closes the window: the first time, a message tells that unsaved changes are
// kept.
bool close_window(App& app);
void quit(App& app);

// A notice on errors of the session at the start, and on recovered changes.
void tell_of_start(App& app);

// Pictures of the window or of one of its panes: as it would open on a set, or as it is.
//
// Exact     same input, same bytes.

// A copy of the program that does not change while pictures of it are drawn.
struct ViewSnapshot {
    App app;
    std::vector<WindowScroll> scrolled{};  // scroll positions of its panes
};

// Content of a fresh view; places in set.vibrations.
struct ViewChoice {
    PictureView view = PictureView::window;
    std::size_t pattern = 0;
    std::optional<std::size_t> pinned{};      // for comparison
    std::optional<Stage> stage{};             // shown large
    bool tilted = false;                      // the receptors' maps
    bool textbook = false;                    // measured facts over the stages
    int threads = 0;                          // 0: all cores
    int dimensions = 3;                       // of the map
    std::optional<RenderedBy> rendered_by{};  // results for the patterns as a device plays them
};

// The program as it would open on the set, with all results that the view shows.
std::shared_ptr<ViewSnapshot> opened_view(const PatternSet& set, const ViewChoice& choice);

// A copy of the program in the current ImGui context, without jobs, files, hints and effects of the
// mouse.
std::shared_ptr<ViewSnapshot> snapshot_of(const App& app);

// Draws one of the two above, with its playhead at the time.
Picture view_picture(ViewSnapshot& still, PictureView view, double at_s, const PictureSize& size);

}  // namespace tact
