#include "app/window/commands.h"
#include "app/window/session_layout.h"

#include <algorithm>
#include <array>

#include "app/compare/bench_follow.h"
#include "app/document/editing.h"
#include "app/document/files.h"
#include "app/document/rating_files.h"
#include "app/document/shown_side.h"
#include "app/export/exports.h"
#include "app/generate/generating.h"
#include "app/measured/import_follow.h"
#include "app/play/playing.h"
#include "app/study/study_follow.h"
#include "app/subset/subset_export.h"
#include "app/subset/subset_follow.h"
#include "app/tour/tour.h"
#include "app/window/animation.h"

namespace tact {

namespace {

bool always(const App&) { return true; }
bool has_selection(const App& app) { return current_vibration(app) != nullptr; }

bool has_answers(const App& app) {
    const auto& answers = app.study->answers;
    return answers && answers->results;
}

bool has_subset(const App& app) { return shown_pick(app) != nullptr; }

void step_selection(App& app, int step) {
    const std::vector<std::size_t> listed = listed_indices(app);
    if (listed.empty()) return;
    const auto last = static_cast<int>(listed.size()) - 1;
    // From a pattern that the search hides, on to the next one in the list.
    const auto from = std::ranges::lower_bound(listed, app.selection.current);
    const bool hidden = from == listed.end() || *from != app.selection.current;
    const int place = static_cast<int>(from - listed.begin()) - (hidden && step > 0 ? 1 : 0);
    const int next = std::clamp(place + step, 0, last);
    select_only(app, listed[static_cast<std::size_t>(next)]);
    app.selection.scroll_to_current = true;
}

void start_rename(App& app) {
    app.set_panel.renaming = app.selection.current;
    app.set_panel.rename_begun = false;
    app.set_panel.rename_text = current_vibration(app)->name;
    app.selection.scroll_to_current = true;
}

template <int kSteps>
void step_playhead(App& app) {
    app.playhead = stepped(app.playhead, kSteps, shown_duration_s(app));
}

template <int kSlower>
void set_speed_to(App& app) {
    set_speed(app, 1.0 / kSlower);
}

template <int kSlower>
bool has_speed(const App& app) {
    return app.playhead.speed == 1.0 / kSlower;
}

void rewind(App& app) {
    app.playhead.at_s = 0.0;
    app.playhead.playing = false;
}

void escape(App& app) {
    if (app.escape_taken) return;
    if (app.palette.open) {
        app.palette.open = false;
    } else if (app.exports.animation) {
        cancel_animation(app);
    } else if (app.tour.step) {
        leave_tour(app);
    } else if (app.playhead.playing) {
        app.playhead.playing = false;
    } else if (app.physiology.explained) {
        app.physiology.explained.reset();
    } else if (app.physiology.open) {
        app.physiology.open.reset();
    } else if (app.layout.maximised) {
        app.layout.maximised.reset();
    } else if (app.study->is_open) {
        close_study(app);
    } else {
        app.selection.others.clear();
        app.status = {};
    }
}

template <Side kSide>
void show_the_side(App& app) {
    show_side(app, kSide);
}

template <Side kSide>
bool shows_side(const App& app) {
    return shown_side(app) == kSide;
}

template <int kPercent>
void set_text_scale(App& app) {
    app.text_scale = static_cast<float>(kPercent) / 100.0F;
    app.fonts_outdated = true;
}

void step_text_scale(App& app, float factor) {
    app.text_scale = std::clamp(app.text_scale * factor, 0.75F, 2.0F);
    app.fonts_outdated = true;
}

void set_theme(App& app, bool dark) {
    app.dark = dark;
    app.fonts_outdated = true;  // the theme is made anew with them
}

void design_layout(App& app) {
    close_study(app);
    app.layout = Layout{};
}

void physiology_layout(App& app) {
    close_study(app);
    app.layout = Layout{};
    app.layout.left = 0.18F;
    app.layout.right = 0.24F;
}

template <BenchTab kTab>
void show_bench(App& app) {
    close_study(app);
    app.bench = kTab;
}

void show_training(App& app) {
    show_bench<BenchTab::model>(app);
    app.model_panel.view = ModelView::training;
}

void space_layout(App& app) {
    close_study(app);
    app.layout = Layout{};
    app.layout.right = 0.52F;
    app.layout.right_split = 0.72F;
}

constexpr Shortcut ctrl(char32_t sign, bool shift = false) {
    return {sign, key::kUnknown, true, shift};
}
constexpr Shortcut plain(char32_t sign) { return {sign, key::kUnknown, false, false}; }
constexpr Shortcut special(int code) { return {0, code, false, false}; }

const auto kCommands = std::to_array<Command>({
    {"File", "New set", {}, always, new_document},
    {"File", "Open...", ctrl('o'), always, open_dialog, nullptr, "load import folder wav txt"},
    {"File", "Open the example set", {}, always, open_example, nullptr, "twelve patterns PM 2023"},
    {"File", "Save", ctrl('s'), always, save},
    {"File", "Save as...", ctrl('s', true), always, save_dialog},
    {"File", "Load ratings...", {}, has_selection, load_ratings_dialog, nullptr,
     "people study participants compare csv"},
    {"File", "Import recordings...", {}, has_selection, import_recordings_dialog, nullptr,
     "measured accelerometer csv wav acceleration"},
    {"File", "Export view...", ctrl('e'), always, export_view_dialog, nullptr,
     "picture image png svg save"},
    {"File", "Export subset...", {}, has_subset, export_subset_dialog, nullptr,
     "report picked distinct set table map"},
    {"File", "Export stage as CSV...", {}, has_selection, export_stages_dialog, nullptr,
     "stages table numbers save"},
    {"File", "Export animation...", {}, has_selection, export_animation_dialog, nullptr,
     "film video frames png save"},
    {"File", "Quit", ctrl('q'), always, quit},

    {"Edit", "Undo", ctrl('z'), [](const App& app) { return app.history.undo_label() != nullptr; },
     undo},
    {"Edit", "Redo", ctrl('z', true),
     [](const App& app) { return app.history.redo_label() != nullptr; }, redo},
    {"Edit", "New pattern", ctrl('n'), always, add_pattern, nullptr, "add vibration"},
    {"Edit", "Duplicate", ctrl('d'), has_selection, duplicate_selected},
    {"Edit", "Generate candidates...", ctrl('g'), always, open_generate, nullptr,
     "design space factorial sample sobol latin hypercube levels"},
    {"Edit", "Rename", special(key::kF1 + 1), has_selection, start_rename},
    {"Edit", "Lock or unlock", ctrl('l'), has_selection, toggle_locked},
    {"Edit", "Drop from subsets or not", ctrl('l', true), has_selection, toggle_dropped, nullptr,
     "exclude must not pick"},
    {"Edit", "Copy", ctrl('c'), has_selection, copy_selected},
    {"Edit", "Paste", ctrl('v'), always, paste},
    {"Edit", "Select all", ctrl('a'), has_selection, select_all},
    {"Edit", "Delete", special(key::kDelete), has_selection, remove_selected, nullptr, "remove"},

    {"View", "Design", plain('1'), always, design_layout, nullptr, "layout columns"},
    {"View", "Physiology", plain('2'), always, physiology_layout, nullptr, "layout waveform"},
    {"View", "Space", plain('3'), always, space_layout, nullptr, "layout map"},
    {"View",
     "Reset view of the space",
     {},
     always,
     [](App& app) { app.camera = SpaceCamera{}; },
     nullptr,
     "camera"},
    {"View",
     "Dark",
     {},
     always,
     [](App& app) { set_theme(app, true); },
     [](const App& app) { return app.dark; },
     "theme"},
    {"View",
     "Light",
     {},
     always,
     [](App& app) { set_theme(app, false); },
     [](const App& app) { return !app.dark; },
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
     [](App& app) { app.bench = BenchTab::subset; },
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
     [](App& app) { app.bench = BenchTab::device; }, nullptr,
     "rendering actuator controller joy-con energy lost"},
    {"View", "Intended and measured", {}, always, show_the_side<Side::both>,
     shows_side<Side::both>, "both recordings twins"},
    {"View", "Intended only", {}, always, show_the_side<Side::intended>,
     shows_side<Side::intended>, "IPS map patterns"},
    {"View", "Measured only", {}, always, show_the_side<Side::measured>,
     shows_side<Side::measured>, "MPS map recordings twins"},
    {"View", "Larger text", ctrl('+'), always, [](App& app) { step_text_scale(app, 1.1F); },
     nullptr, "zoom scale"},
    {"View", "Smaller text", ctrl('-'), always, [](App& app) { step_text_scale(app, 1.0F / 1.1F); },
     nullptr, "zoom scale"},
    {"View", "Text as large as the screen says", ctrl('0'), always, set_text_scale<100>},
    {"View",
     "Motion",
     {},
     always,
     [](App& app) { app.motion = !app.motion; },
     [](const App& app) { return app.motion; },
     "animation"},
    {"View", "Bring hints back", {}, always, [](App& app) { app.session.dismissed_hints.clear(); }},

    {"Play", "Play or stop", special(key::kSpace), has_selection, toggle_playing, nullptr,
     "feel animate silently pause"},
    {"Play", "Play all in sequence", {}, can_sound, play_all, nullptr, "feel every pattern gap"},
    {"Play", "Test buzz", {}, can_sound, play_test_buzz, nullptr, "try actuator device 150 Hz"},
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
     [](App& app) { app.playhead.loop = !app.playhead.loop; },
     [](const App& app) { return app.playhead.loop; },
     "repeat"},
    {"Play", "A|B: alternate with the partner", {}, has_selection, toggle_alternating,
     is_alternating, "compare feel pair"},
    {"Play",
     "Play on hover in the map",
     {},
     always,
     [](App& app) { app.play.on_hover = !app.play.on_hover; },
     [](const App& app) { return app.play.on_hover; },
     "feel point space mouse"},
    {"Play", "Devices...", {}, always, [](App& app) { app.dialog = Dialog::devices; }, nullptr,
     "actuator sound card channel latency full scale output"},
    {"Play", "Refresh devices", {}, always, refresh_devices, nullptr, "plugged in actuator"},
    {"Play",
     "Show the whole pattern",
     {},
     always,
     [](App& app) { app.time_range = {}; },
     nullptr,
     "zoom out time"},
    {"Play", "Simulate measurement...", {}, has_selection, simulate_measurement_dialog, nullptr,
     "synthetic measured actuator resonance"},

    {"Study", "Design and participants", plain('5'), always, open_study,
     [](const App& app) { return app.study->is_open; }, "ratings people experiment"},
    {"Study", "Run a participant...", {}, has_selection, begin_participant, nullptr,
     "ratings people experiment trial"},
    {"Study", "Simulate a participant", {}, has_selection, simulate_participant, nullptr,
     "synthetic ratings"},
    {"Study", "Use answers as the set's ratings", {}, has_answers, use_as_ratings, nullptr,
     "compare people collect"},
    {"Study", "Export answers as CSV...", {}, has_answers, export_study_dialog, nullptr,
     "ratings table R Python save"},
    {"Study", "Folder for participants...", {}, always, choose_study_folder, nullptr, "files"},

    {"Help", "Guided tour", {}, has_selection, start_tour, nullptr, "learn teach explain"},
    {"Help", "Guided tour from the start", {}, has_selection,
     [](App& app) {
         app.tour.left_at = 0;
         start_tour(app);
     },
     nullptr, "learn teach explain"},
    {"Help", "Findings of the paper", {}, always,
     [](App& app) {
         show_bench<BenchTab::compare>(app);
         app.compare.view = CompareView::findings;
     },
     nullptr, "publication checks holds fails"},
    {"Help", "Keys and mouse", special(key::kF1), always,
     [](App& app) { app.dialog = Dialog::keys; }, nullptr, "shortcuts help"},
    {"Help", "Command palette", ctrl('p'), always, [](App& app) { app.palette = {true, {}, 0}; }},
    {"Help",
     "About tactspace",
     {},
     always,
     [](App& app) { app.dialog = Dialog::about; },
     nullptr,
     "licence model source left out"},

    // Not in a menu.
    {"", "Redo", ctrl('y'), [](const App& app) { return app.history.redo_label() != nullptr; },
     redo},
    {"", "Larger text", ctrl('='), always, [](App& app) { step_text_scale(app, 1.1F); }},
    {"", "Stop", special(key::kEscape), always, escape},
    {"", "Previous pattern", special(key::kUp), always, [](App& app) { step_selection(app, -1); }},
    {"", "Next pattern", special(key::kDown), always, [](App& app) { step_selection(app, 1); }},
});

}  // namespace

std::span<const Command> commands() { return kCommands; }

}  // namespace tact
