#include "app/window/window.h"

#include <array>
#include <utility>
#include <vector>

#include "app/document/editing.h"
#include "app/lesson/lesson.h"
#include "app/manual/manual.h"
#include "app/measured/measured.h"
#include "app/play/play.h"
#include "app/session/session.h"
#include "app/study/study.h"
#include "app/subset/subset.h"

namespace tact {

namespace {

// An actuator is measured through the sound output that drives it, so that is chosen first.
void open_calibration(App& app) {
    app.ui.dialog = kCalibrateDialog;
    if (can_be_calibrated(app.play)) return;
    app.ui.dialog = kDevicesDialog;
    say(app.ui, "Choose the sound output that drives the actuator, then Calibrate.");
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

constexpr auto kOtherCommands = std::to_array<Command>({
    {"Play", "Play or stop", special(key::kSpace), has_selection,
     [](App& app) { toggle_playing(app.ui, app.work, app.timeline, app.shown_map, app.play); },
     nullptr, "feel animate silently pause"},
    {"Play",
     "Play all in sequence",
     {},
     has_sound,
     [](App& app) { play_all(app.ui, app.work, app.timeline, app.play); },
     nullptr,
     "feel every pattern gap"},
    {"Play",
     "Level...",
     {},
     has_sound,
     [](App& app) { app.ui.field.wanted = "level_percent"; },
     nullptr,
     "strength volume louder softer percent"},
    {"Play",
     "Test buzz",
     {},
     has_sound,
     [](App& app) { play_test_buzz(app.ui, app.timeline, app.play); },
     nullptr,
     "try actuator device 150 Hz"},
    {"Play", "Back to the start", special(key::kHome), has_selection, rewind, nullptr, "rewind"},
    {"Play", "5 ms forward", plain('.'), has_selection, step_playhead<1>, nullptr, "step forward"},
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
    {"Play",
     "A|B: alternate with the partner",
     {},
     has_selection,
     [](App& app) { toggle_alternating(app.play); },
     [](const App& app) { return is_alternating(app.play); },
     "compare feel pair"},
    {"Play", "A|B: swap the two", plain('x'), has_selection, swap_alternating, nullptr,
     "exchange pair partner"},
    {"Play",
     "Play on hover in the map",
     {},
     always,
     [](App& app) { app.play.on_hover = !app.play.on_hover; },
     [](const App& app) { return app.play.on_hover; },
     "feel point space mouse"},
    {"Play",
     "Devices...",
     {},
     always,
     [](App& app) { app.ui.dialog = kDevicesDialog; },
     nullptr,
     "actuator sound card channel latency full scale output"},
    {"Play",
     "Phones...",
     {},
     always,
     [](App& app) { app.ui.dialog = kPhonesDialog; },
     nullptr,
     "phone mobile QR code scan vibrate class students rate together network"},
    {"Play",
     "Calibrate...",
     {},
     always,
     open_calibration,
     nullptr,
     "accelerometer g response resonance measure actuator calibration"},
    {"Play",
     "Refresh devices",
     {},
     always,
     [](App& app) { refresh_devices(app.ui, app.play); },
     nullptr,
     "plugged in actuator"},
    {"Play", "Show the whole pattern", plain('0'), always,
     [](App& app) { app.timeline.range = {}; }, nullptr, "zoom out time"},
    {"Play",
     "Simulate measurement...",
     {},
     has_selection,
     [](App& app) { simulate_measurement_dialog(app.ui, app.work, app.importing); },
     nullptr,
     "synthetic measured actuator resonance"},

    {"Study",
     "Plan the study...",
     {},
     has_study,
     [](App& app) { app.ui.dialog = kPlanDialog; },
     nullptr,
     "how many people power preregister preregistration simulate pilot"},
    {"Study",
     "Run a participant...",
     {},
     has_study,
     [](App& app) { begin_participant(app.ui, app.work, app.timeline, app.play, app.studying); },
     nullptr,
     "ratings people experiment trial"},
    {"Study",
     "Simulate a participant",
     {},
     has_map_of_all,
     [](App& app) {
         simulate_participant(app.ui, app.work, app.shown_map, app.play, app.studying);
     },
     nullptr,
     "synthetic ratings"},
    {"Study",
     "Use answers as the set's ratings",
     {},
     has_answers,
     [](App& app) { use_as_ratings(app.ui, app.work, app.layout, app.comparing, app.studying); },
     nullptr,
     "compare people collect"},
    {"Study",
     "Export answers as CSV...",
     {},
     has_answers,
     [](App& app) { export_study_dialog(app.ui, app.work, app.studying); },
     nullptr,
     "ratings table R Python save"},
    {"Study",
     "Folder for participants...",
     {},
     always,
     [](App& app) { choose_study_folder(app.ui, app.work, app.studying); },
     nullptr,
     "files"},

    {"Lesson",
     "Open lesson...",
     {},
     always,
     [](App& app) { open_lesson_dialog(app, "Open a lesson"); },
     nullptr,
     "teach load tactlesson"},
    {"Lesson",
     "Open course...",
     {},
     always,
     [](App& app) { open_lesson_dialog(app, "Open a course"); },
     nullptr,
     "teach load tactcourse students progress"},
    {"Lesson",
     "Course of all lessons",
     {},
     always,
     open_course_of_program,
     nullptr,
     "teach learn students progress answers score"},
    {"Lesson",
     "New lesson from this set",
     {},
     has_selection,
     begin_lesson,
     nullptr,
     "teach write steps"},
    {"Lesson",
     "Edit the lesson",
     {},
     has_lesson,
     [](App& app) { toggle_editing(lesson_context(app), app.lesson); },
     [](const App& app) { return app.lesson.editing; },
     "teach write steps text"},
    {"Lesson",
     "Add step from what is on screen",
     {},
     has_lesson,
     [](App& app) { add_step(lesson_context(app), app.lesson); },
     nullptr,
     "teach write scene"},
    {"Lesson",
     "Check the lesson",
     {},
     has_lesson,
     check_the_lesson,
     nullptr,
     "draft missing lacks"},
    {"Lesson",
     "Save lesson as...",
     {},
     has_lesson,
     [](App& app) { save_lesson_dialog(app.ui, app.work, app.lesson); },
     nullptr,
     "teach write tactlesson"},
    {"Lesson",
     "Duplicate the lesson",
     {},
     has_lesson,
     duplicate_the_lesson,
     nullptr,
     "copy write own teach"},
    {"Lesson",
     "Student sheet...",
     {},
     has_lesson,
     [](App& app) { save_sheet_dialog(app.ui, app.work, app.lesson); },
     nullptr,
     "teach print handout page html pdf"},
    {"Lesson",
     "Hand on...",
     {},
     has_lesson,
     [](App& app) { hand_on_dialog(app.ui, app.work, app.lesson); },
     nullptr,
     "teach share colleague export notes answers"},
    {"Lesson",
     "Move the card",
     {},
     has_lesson,
     [](App& app) { move_card(app.lesson); },
     nullptr,
     "dock side"},
    {"Lesson", "Leave the lesson", {}, has_lesson, leave_the_lesson, nullptr, "end tour"},

    {"Help", "Guided tour", {}, always, begin_tour, nullptr, "learn teach explain"},
    {"Help",
     "Guided tour from the start",
     {},
     always,
     tour_from_the_start,
     nullptr,
     "learn teach explain"},
    {"Help",
     "Findings of the paper",
     {},
     always,
     show_findings,
     nullptr,
     "publication checks holds fails"},
    {"Help",
     "Manual",
     {},
     always,
     [](App& app) { open_manual(app.ui, app.manual); },
     nullptr,
     "help how formats limits read documentation"},
    {"Help", "Keys and mouse", special(key::kF1), always,
     [](App& app) { app.ui.dialog = kKeysDialog; }, nullptr, "shortcuts help"},
    {"Help", "Command palette", ctrl('p'), always, [](App& app) { app.palette = {true, {}, 0}; }},
    {"Help",
     "About tactspace",
     {},
     always,
     [](App& app) { app.ui.dialog = kAboutDialog; },
     nullptr,
     "licence model source left out"},

    // Not in a menu.
    {"", "Redo", ctrl('y'), has_redo, [](App& app) { redo(app.ui, app.work); }},
    {"", "Larger text", ctrl('='), always, [](App& app) { step_text_scale(app.ui, 1.1F); }},
    {"", "Stop", special(key::kEscape), always, escape},
    {"", "Previous pattern", special(key::kUp), always,
     [](App& app) { select_next(app.work, -1); }},
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

// One row for each bundled set: a submenu of File.
template <std::size_t... kPlaces>
std::vector<Command> with_examples(std::index_sequence<kPlaces...>) {
    std::vector<Command> all(document_commands().begin(), document_commands().end());
    all.insert(all.end(), view_commands().begin(), view_commands().end());
    all.insert(all.end(), kOtherCommands.begin(), kOtherCommands.end());
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
    open_bundled_lesson(app, kBundledLessons[kPlace].path);
}

// Bundled lessons stand in their menu behind the commands that open others.
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
