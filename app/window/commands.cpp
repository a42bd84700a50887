#include "app/window/commands.h"

#include <array>
#include <utility>
#include <vector>

#include "app/ask/maybes_follow.h"
#include "app/ask/steps_follow.h"
#include "app/compare/compare_follow.h"
#include "app/document/editing.h"
#include "app/document/files.h"
#include "app/document/rating_files.h"
#include "app/document/shown_side.h"
#include "app/export/exports.h"
#include "app/generate/generating.h"
#include "app/lesson/lesson_card.h"
#include "app/lesson/lesson_edit.h"
#include "app/lesson/presenting.h"
#include "app/manual/open_manual.h"
#include "app/measured/import_follow.h"
#include "app/patterns/set_panel.h"
#include "app/patterns/tapping.h"
#include "app/play/listening.h"
#include "app/play/playing.h"
#include "app/session/crash_report.h"
#include "app/study/study_follow.h"
#include "app/subset/picked_list.h"
#include "app/subset/subset_export.h"
#include "app/subset/subset_follow.h"
#include "app/wave_strip/wave_strip.h"
#include "app/window/command_actions.h"
#include "app/window/session_layout.h"

namespace tact {

namespace {

bool always(const App&) { return true; }

template <GripKind kKind>
void add_at_playhead(App& app) {
    add_at(app.ui, app.work, app.pattern_panes.strip, kKind, app.timeline.playhead.at_s);
}

template <int kStep>
void choose_next_point(App& app) {
    choose_next(app.ui, app.work, app.pattern_panes.strip, kStep);
}

template <int kSteps>
void step_playhead(App& app) {
    app.timeline.playhead = stepped(app.timeline.playhead, kSteps, shown_duration_s(app.work));
}

template <int kSlower>
void set_speed_to(App& app) {
    set_speed(app.ui, app.work, app.timeline, app.shown_map, app.play, 1.0 / kSlower);
}

template <int kSlower>
bool has_speed(const App& app) {
    return app.timeline.playhead.speed == 1.0 / kSlower;
}

template <std::size_t kNumber>
void play_picked_at(App& app) {
    play_picked(app.ui, app.work, app.timeline, app.shown_map, app.play, app.picking, kNumber);
}

template <Side kSide>
void show_the_side(App& app) {
    show_side(app.work, kSide);
}

template <Side kSide>
bool shows_side(const App& app) {
    return shown_side(app.work) == kSide;
}

template <BenchTab kTab>
void show_bench(App& app) {
    show_tab(app, kTab);
}

constexpr Shortcut ctrl(char32_t sign, bool shift = false) {
    return {sign, key::kUnknown, true, shift};
}
constexpr Shortcut plain(char32_t sign) { return {sign, key::kUnknown, false, false}; }
constexpr Shortcut special(int code) { return {0, code, false, false}; }

const auto kCommands = std::to_array<Command>({
    {"File", "New set", {}, always, [](App& app) { new_document(app.ui, app.work); }},
    {"File", "Open...", ctrl('o'), always, [](App& app) { open_dialog(app.ui, app.work); }, nullptr, "load import folder wav txt ahap haptic hjif haps he hla"},
    {"File", "Add to set...", {}, always, [](App& app) { add_dialog(app.ui, app.work); }, nullptr, "import append effects ahap haptic folder"},
    {"File", "Save", ctrl('s'), always, [](App& app) { save(app.ui, app.work); }},
    {"File", "Save as...", ctrl('s', true), always, [](App& app) { save_dialog(app.ui, app.work); }},
    {"File", "Load ratings...", {}, has_selection, [](App& app) { load_ratings_dialog(app.ui, app.work); }, nullptr,
     "people study participants compare csv"},
    {"File", "Import recordings...", {}, has_selection, [](App& app) { import_recordings_dialog(app.ui, app.work); }, nullptr,
     "measured accelerometer csv wav acceleration"},
    {"File", "Actuator maps...", {}, has_effects, [](App& app) { app.ui.dialog = Dialog::effect_maps; }, nullptr,
     "effects read by quest core haptics hz g import ahap haptic"},
    {"File", "Export view...", ctrl('e'), always, [](App& app) { export_view_dialog(app.ui); }, nullptr,
     "picture image png svg save"},
    {"File", "Export subset...", {}, has_subset, [](App& app) { export_subset_dialog(app.ui, app.work, app.shown_map, app.picking); }, nullptr,
     "picked distinct set table map"},
    {"File", "Export report...", {}, has_pairs, [](App& app) { export_report_dialog(app.ui, app.work); }, nullptr,
     "page html groups confuse distinct players client print"},
    {"File", "Export vibrations...", {}, has_selection, open_effect_export, nullptr,
     "ahap haptic hjif android pulsar richtap he hla openxr wav csv phone kotlin loss"},
    {"File", "Export stage as CSV...", {}, has_selection, [](App& app) { export_stages_dialog(app.ui, app.work, app.rendered, app.physiology); }, nullptr,
     "stages table numbers save"},
    {"File", "Export animation...", {}, has_selection, [](App& app) { export_animation_dialog(app.ui, app.work, app.exports); }, nullptr,
     "film video frames png save"},
    {"File", "Quit", ctrl('q'), always, quit},

    {"Edit", "Undo", ctrl('z'), [](const App& app) { return app.work.history.undo_label() != nullptr; },
     [](App& app) { undo(app.ui, app.work); }},
    {"Edit", "Redo", ctrl('z', true),
     [](const App& app) { return app.work.history.redo_label() != nullptr; }, [](App& app) { redo(app.ui, app.work); }},
    {"Edit", "New pattern", ctrl('n'), always, [](App& app) { add_pattern(app.ui, app.work); }, nullptr, "add vibration"},
    {"Edit", "Duplicate", ctrl('d'), has_selection, [](App& app) { duplicate_selected(app.ui, app.work); }},
    {"Edit", "Generate candidates...", ctrl('g'), always, [](App& app) { open_generate(app.ui, app.work, app.generating); }, nullptr,
     "design space factorial sample sobol latin hypercube levels"},
    {"Edit", "Steps between...", {}, has_pairs, [](App& app) { open_steps(app.ui, app.work, app.steps, {}, {}); }, nullptr,
     "even morph between interpolate two path series"},
    {"Edit", "Vary", plain('v'), has_editable_pattern, [](App& app) { vary(app.ui, app.work, app.maybes); }, nullptr,
     "neighbours variants alternatives others like it ghosts"},
    {"Edit", "Tap a rhythm...", plain('t'), has_editable_pattern, [](App& app) { open_tapping(app.ui, app.pattern_panes.tapping); }, nullptr, "beat notes hand"},
    {"Edit", "Add a point of amplitude at the playhead", {}, has_editable_pattern, add_at_playhead<GripKind::level>, nullptr, "curve envelope draw"},
    {"Edit", "Add a point of frequency at the playhead", {}, has_editable_pattern, add_at_playhead<GripKind::frequency>, nullptr, "curve sweep draw"},
    {"Edit", "Add a transient at the playhead", {}, has_editable_pattern, add_at_playhead<GripKind::transient>, nullptr, "burst click tick"},
    {"Edit", "Next point of the pattern", plain('n'), has_editable_pattern, choose_next_point<1>, nullptr, "transient curve choose"},
    {"Edit", "Point before", {'n', key::kUnknown, false, true}, has_editable_pattern, choose_next_point<-1>, nullptr, "transient curve choose previous"},
    {"Edit", "Rename", special(key::kF1 + 1), has_selection, start_rename},
    {"Edit", "Lock or unlock", ctrl('l'), has_selection, [](App& app) { toggle_locked(app.ui, app.work); }},
    {"Edit", "Drop from subsets or not", ctrl('l', true), has_selection, [](App& app) { toggle_dropped(app.ui, app.work); }, nullptr,
     "exclude must not pick"},
    {"Edit", "Copy", ctrl('c'), has_selection, [](App& app) { copy_selected(app.ui, app.work); }},
    {"Edit", "Copy picture", ctrl('c', true), always, [](App& app) { app.exports.copy_asked = true; }, nullptr,
     "clipboard image view slides png"},
    {"Edit", "Paste", ctrl('v'), always, [](App& app) { paste(app.ui, app.work); }},
    {"Edit", "Select all", ctrl('a'), has_selection, [](App& app) { select_all(app.work); }},
    {"Edit", "Delete", special(key::kDelete), has_selection, remove_chosen_or_selected, nullptr, "remove"},

    {"View", "Design", ctrl('1'), always, design_layout, nullptr, "layout columns"},
    {"View", "Physiology", ctrl('2'), always, physiology_layout, nullptr, "layout waveform"},
    {"View", "Space", ctrl('3'), always, space_layout, nullptr, "layout map"},
    {"View",
     "Reset view of the space",
     {},
     always,
     [](App& app) { app.shown_map.camera = SpaceCamera{}; },
     nullptr,
     "camera"},
    {"View", "Frame the selection in the space", plain('f'), has_selection, [](App& app) { app.shown_map.frame_asked = true; }, nullptr,
     "zoom camera map focus"},
    {"View", "Lock the view of the space", {}, always, [](App& app) { app.shown_map.camera.locked = !app.shown_map.camera.locked; },
     [](const App& app) { return app.shown_map.camera.locked; }, "camera map turn"},
    {"View",
     "Dark",
     {},
     always,
     [](App& app) { set_theme(app.ui, true); },
     [](const App& app) { return app.ui.dark; },
     "theme"},
    {"View",
     "Light",
     {},
     always,
     [](App& app) { set_theme(app.ui, false); },
     [](const App& app) { return !app.ui.dark; },
     "theme"},
    {"View",
     "Matrix",
     {},
     always,
     show_bench<BenchTab::matrix>,
     nullptr,
     "dissimilarity heat map"},
    {"View",
     "Subset",
     {},
     always,
     [](App& app) { app.layout.bench = BenchTab::subset; },
     nullptr,
     "pick most distinct confusable separate stable"},
    {"View", "Compare with people", {}, always,
     show_bench<BenchTab::compare>, nullptr, "ratings metrics rho table"},
    {"View", "Shepard diagram", {}, always, show_bench<BenchTab::shepard>,
     nullptr, "stress fit map"},
    {"View", "Why are these two different?", {}, always,
     show_bench<BenchTab::why>, nullptr, "pair channels explain"},
    {"View",
     "Model bench",
     {},
     always,
     show_bench<BenchTab::model>,
     nullptr,
     "parameters weights layers thresholds"},
    {"View", "Train on ratings", {}, always, show_training, nullptr,
     "fit parameters people optimum search model"},
    {"View", "What a device makes of it", {}, always,
     [](App& app) { app.layout.bench = BenchTab::device; }, nullptr,
     "rendering actuator controller joy-con energy lost"},
    {"View", "Intended and measured", {}, always, show_the_side<Side::both>,
     shows_side<Side::both>, "both recordings twins"},
    {"View", "Intended only", {}, always, show_the_side<Side::intended>,
     shows_side<Side::intended>, "IPS map patterns"},
    {"View", "Measured only", {}, always, show_the_side<Side::measured>,
     shows_side<Side::measured>, "MPS map recordings twins"},
    {"View", "Present", special(key::kF1 + 4), always, present,
     [](const App& app) { return is_presenting(app.lesson); }, "lecture projector full screen slides clicker tour lesson"},
    {"View", "Larger text", ctrl('+'), always, [](App& app) { step_text_scale(app.ui, 1.1F); },
     nullptr, "zoom scale"},
    {"View", "Smaller text", ctrl('-'), always, [](App& app) { step_text_scale(app.ui, 1.0F / 1.1F); },
     nullptr, "zoom scale"},
    {"View", "Text as large as the screen says", ctrl('0'), always, [](App& app) { set_text_scale(app.ui, 1.0F); }},
    {"View",
     "Motion",
     {},
     always,
     [](App& app) { app.ui.motion = !app.ui.motion; },
     [](const App& app) { return app.ui.motion; },
     "animation"},
    {"View", "Bring hints back", {}, always, [](App& app) { app.ui.dismissed_hints.clear(); }},

    {"Play", "Play or stop", special(key::kSpace), has_selection, [](App& app) { toggle_playing(app.ui, app.work, app.timeline, app.shown_map, app.play); }, nullptr,
     "feel animate silently pause"},
    {"Play", "Play all in sequence", {}, [](const App& app) { return can_sound(app.play); }, [](App& app) { play_all(app.ui, app.work, app.timeline, app.play); }, nullptr, "feel every pattern gap"},
    {"Play", "Test buzz", {}, [](const App& app) { return can_sound(app.play); }, [](App& app) { play_test_buzz(app.ui, app.timeline, app.play); }, nullptr, "try actuator device 150 Hz"},
    {"Play", "Back to the start", special(key::kHome), has_selection, rewind, nullptr, "rewind"},
    {"Play", "5 ms on", plain('.'), has_selection, step_playhead<1>, nullptr, "step forward"},
    {"Play", "5 ms back", plain(','), has_selection, step_playhead<-1>, nullptr, "step back"},
    {"Play", "In real time", {}, always, set_speed_to<1>, has_speed<1>, "speed"},
    {"Play", "Ten times slower", {}, always, set_speed_to<10>, has_speed<10>, "speed slow motion"},
    {"Play",
     "A hundred times slower",
     {},
     always,
     set_speed_to<100>,
     has_speed<100>,
     "speed slow motion"},
    {"Play",
     "Loop",
     {},
     always,
     [](App& app) { app.timeline.playhead.loop = !app.timeline.playhead.loop; },
     [](const App& app) { return app.timeline.playhead.loop; },
     "repeat"},
    {"Play", "A|B: alternate with the partner", {}, has_selection, [](App& app) { toggle_alternating(app.play); },
     [](const App& app) { return is_alternating(app.play); }, "compare feel pair"},
    {"Play", "A|B: swap the two", plain('x'), has_selection, swap_alternating, nullptr, "exchange pair partner"},
    {"Play",
     "Play on hover in the map",
     {},
     always,
     [](App& app) { app.play.on_hover = !app.play.on_hover; },
     [](const App& app) { return app.play.on_hover; },
     "feel point space mouse"},
    {"Play", "Devices...", {}, always, [](App& app) { app.ui.dialog = Dialog::devices; }, nullptr,
     "actuator sound card channel latency full scale output"},
    {"Play", "Refresh devices", {}, always, [](App& app) { refresh_devices(app.play); }, nullptr, "plugged in actuator"},
    {"Play",
     "Show the whole pattern",
     {},
     always,
     [](App& app) { app.timeline.range = {}; },
     nullptr,
     "zoom out time"},
    {"Play", "Simulate measurement...", {}, has_selection, [](App& app) { simulate_measurement_dialog(app.ui, app.work, app.importing); }, nullptr,
     "synthetic measured actuator resonance"},

    {"Study", "Design and participants", ctrl('5'), always, [](App& app) { open_study(app.layout, app.studying); },
     [](const App& app) { return app.studying.is_open; }, "ratings people experiment"},
    {"Study", "Run a participant...", {}, has_selection, [](App& app) { begin_participant(app.ui, app.work, app.timeline, app.play, app.studying); }, nullptr,
     "ratings people experiment trial"},
    {"Study", "Simulate a participant", {}, has_selection, [](App& app) { simulate_participant(app.ui, app.work, app.shown_map, app.play, app.studying); }, nullptr,
     "synthetic ratings"},
    {"Study", "Use answers as the set's ratings", {}, has_answers, [](App& app) { use_as_ratings(app.ui, app.work, app.layout, app.comparing, app.studying); }, nullptr,
     "compare people collect"},
    {"Study", "Export answers as CSV...", {}, has_answers, [](App& app) { export_study_dialog(app.ui, app.work, app.studying); }, nullptr,
     "ratings table R Python save"},
    {"Study", "Folder for participants...", {}, always, [](App& app) { choose_study_folder(app.ui, app.work, app.studying); }, nullptr, "files"},

    {"Lesson", "Open lesson...", {}, always, [](App& app) { open_lesson_dialog(app.ui, app.work); }, nullptr, "teach load tactlesson"},
    {"Lesson", "New lesson from this set", {}, has_selection, [](App& app) { new_lesson(hands_of(app), app.lesson); }, nullptr, "teach write steps"},
    {"Lesson", "Edit the lesson", {}, has_lesson, [](App& app) { toggle_editing(hands_of(app), app.lesson); },
     [](const App& app) { return app.lesson.editing; }, "teach write steps text"},
    {"Lesson", "Add step from what is on screen", {}, has_lesson, [](App& app) { add_step(hands_of(app), app.lesson); }, nullptr, "teach write scene"},
    {"Lesson", "Save lesson as...", {}, has_lesson, [](App& app) { save_lesson_dialog(app.ui, app.work, app.lesson); }, nullptr, "teach write tactlesson"},
    {"Lesson", "Student sheet...", {}, has_lesson, [](App& app) { save_sheet_dialog(app.ui, app.work, app.lesson); }, nullptr, "teach print handout page html"},
    {"Lesson", "Move the card", {}, has_lesson, [](App& app) { move_card(app.lesson); }, nullptr, "dock side"},
    {"Lesson", "Leave the lesson", {}, has_lesson, leave_the_lesson, nullptr, "end tour"},

    {"Help", "Guided tour", {}, always, begin_tour, nullptr, "learn teach explain"},
    {"Help", "Guided tour from the start", {}, always,
     tour_from_the_start,
     nullptr, "learn teach explain"},
    {"Help", "Findings of the paper", {}, always,
     show_findings,
     nullptr, "publication checks holds fails"},
    {"Help", "Manual", {}, always, [](App& app) { open_manual(app.ui, app.manual); }, nullptr,
     "help how formats limits read documentation"},
    {"Help", "Keys and mouse", special(key::kF1), always,
     [](App& app) { app.ui.dialog = Dialog::keys; }, nullptr, "shortcuts help"},
    {"Help", "Command palette", ctrl('p'), always, [](App& app) { app.palette = {true, {}, 0}; }},
    {"Help",
     "About tactspace",
     {},
     always,
     [](App& app) { app.ui.dialog = Dialog::about; },
     nullptr,
     "licence model source left out"},

    // Not in a menu.
    {"", "Redo", ctrl('y'), [](const App& app) { return app.work.history.redo_label() != nullptr; },
     [](App& app) { redo(app.ui, app.work); }},
    {"", "Larger text", ctrl('='), always, [](App& app) { step_text_scale(app.ui, 1.1F); }},
    {"", "Stop", special(key::kEscape), always, escape},
    {"", "Previous pattern", special(key::kUp), always, [](App& app) { select_next(app.work, -1); }},
    {"", "Play picked pattern 1", plain('1'), has_selection, play_picked_at<1>},
    {"", "Play picked pattern 2", plain('2'), has_selection, play_picked_at<2>},
    {"", "Play picked pattern 3", plain('3'), has_selection, play_picked_at<3>},
    {"", "Play picked pattern 4", plain('4'), has_selection, play_picked_at<4>},
    {"", "Play picked pattern 5", plain('5'), has_selection, play_picked_at<5>},
    {"", "Play picked pattern 6", plain('6'), has_selection, play_picked_at<6>},
    {"", "Play picked pattern 7", plain('7'), has_selection, play_picked_at<7>},
    {"", "Play picked pattern 8", plain('8'), has_selection, play_picked_at<8>},
    {"", "Play picked pattern 9", plain('9'), has_selection, play_picked_at<9>},
    {"", "Next pattern", special(key::kDown), always, [](App& app) { select_next(app.work, 1); }},
});

template <std::size_t kPlace>
void open_example_at(App& app) {
    open_example_set(app.ui, app.work, kExampleSets[kPlace]);
}

// A row for each set that comes with the program: a menu of its own within File.
template <std::size_t... kPlaces>
std::vector<Command> with_examples(std::index_sequence<kPlaces...>) {
    std::vector<Command> all(kCommands.begin(), kCommands.end());
    (all.push_back({kExampleMenu,
                    kExampleSets[kPlaces].name,
                    {},
                    always,
                    open_example_at<kPlaces>,
                    nullptr,
                    "open bundled"}),
     ...);
    return all;
}

template <std::size_t kPlace>
void open_lesson_at(App& app) {
    app.ui.waiting.emplace_back([&app] {
        start_lesson(hands_of(app), app.lesson, bundled_lesson(kBundledLessons[kPlace].path), {});
    });
}

// The lessons that come with the program stand in their menu behind what opens others.
template <std::size_t... kPlaces>
std::vector<Command> with_lessons(std::vector<Command> all, std::index_sequence<kPlaces...>) {
    (all.push_back({"Lesson",
                    kBundledLessons[kPlaces].name,
                    {},
                    always,
                    open_lesson_at<kPlaces>,
                    nullptr,
                    "teach lecture class"}),
     ...);
    return all;
}

}  // namespace

std::span<const Command> commands() {
    static const std::vector<Command> all =
        with_lessons(with_examples(std::make_index_sequence<kExampleSets.size()>()),
                     std::make_index_sequence<kBundledLessons.size()>());
    return all;
}

void carry_out(App& app, const Command& command) {
    note_command(command.name);
    command.run(app);
}

}  // namespace tact
