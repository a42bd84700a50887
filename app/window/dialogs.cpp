#include "app/window/window.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>
#include <vector>

#include "app/ask/ask.h"
#include "app/calibrate/calibrate.h"
#include "app/compare/compare.h"
#include "app/course/course.h"
#include "app/document/editing.h"
#include "app/export/export.h"
#include "app/generate/generate.h"
#include "app/lesson/lesson.h"
#include "app/library/library.h"
#include "app/measured/measured.h"
#include "app/model_bench/model_bench.h"
#include "app/opening/opening.h"
#include "app/patterns/patterns.h"
#include "app/planning/planning.h"
#include "app/play/play.h"
#include "app/sounds/sounds.h"
#include "app/study/study.h"
#include "app/subset/subset.h"
#include "app/tables/tables.h"
#include "app/transform/transform.h"
#include "app/ui/ui.h"
#include "app/ui/widgets.h"
#include "model/io/lesson/lesson_file.h"
#include "model/io/recordings/recording.h"
#include "model/text/atomic_file.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr const char* kAboutText =
    "tactspace predicts which vibrations people will tell apart. It implements the physiology-"
    "based model PM of Lim & Park, \"Can a Computer Tell Differences between Vibrations?\" (CHI "
    "2023).\n\n"
    "Where the paper leaves a choice open, one was made here; the manual (Help > Manual) lists "
    "them. The "
    "slopes and thresholds of the receptors are rebuilt from published rates, as the "
    "original figures were not available. The model knows one fingertip, a 0.5 mm probe, no "
    "adaptation, no noise and no differences between people; it was validated at 1 s.\n\n"
    "Source under the MIT licence. A binary linked with FFTW falls under the GPL: "
    "whoever hands one out offers its source, a page in the folder \"source\" beside it.";

// Keys that are not in a menu; they stand before the commands of their group.
struct Gesture {
    const char* group;
    const char* keys;
    const char* what;
};
constexpr auto kGestures = std::to_array<Gesture>({
    {"Edit", "Ctrl+Y", "Edit > Redo, too"},
    {"Patterns", "Up, Down", "the pattern before, the next one"},
    {"Patterns", "Double click on a row", "rename the pattern"},
    {"Patterns", "Hold a row, a point, a candidate (0.25 s)", "feel it while you hold it"},
    {"Patterns", "1 to 9", "play a picked pattern, by its number in Subset"},
    {"Numbers", "Left, Right (Shift: five steps; Alt: a tenth)", "nudge the field with the ring"},
    {"Numbers", "*2, /4, -10%, +3dB",
     "change what is there; +0.1 is the number itself; 0,8 and 250 ms, too"},
    {"Numbers", "Enter, Tab, Esc",
     "take the number, take it and go to the next, leave it as it was"},
    {"Plots", "Wheel, Ctrl+wheel", "move through time, zoom; all plots follow"},
    {"Map", "Drag, wheel, right drag", "turn, zoom, move"},
    {"Map", "A click on D1, D2, D3", "look along an axis"},
    {"Map", "Double click on a point", "play that pattern"},
    {"Map", "Shift+drag, Ctrl+Shift+drag; Ctrl+click", "select by a box, by a lasso; add one"},
    {"Map", "Alt+drag of a point, or the Move tool", "put it there: its pattern is searched"},
    {"Map", "Ctrl+drag from a point to another", "even steps between the two"},
    {"Window", "Esc", "silences everything, at once; leaves what is open"},
    {"Window", "F1; F1 again", "this list; the manual"},
    {"Window", "Tab, Shift+Tab, Enter", "go through the widgets by keyboard"},
    {"Window", "Space in a dialog", "presses what has the ring, as Enter does"},
    {"Window", "Ctrl+Tab", "from pane to pane"},
    {"Window", "Double click on a title", "maximise the pane; Esc puts it back"},
    {"Window", "Drop files or a folder", "open them"},
    {"Lesson", "Page Up, Page Down", "a step back, on; so do a clicker's keys"},
    {"Lesson", "Arrows, Enter, Space; B; 1 to 9; M; N",
     "presenting: steps; blank screen; count hands; move the card; speaker's notes"},
    {"Lesson", "Shift+arrows", "move the cross in the map, where a place is asked for"},
    {"Lesson", "Alt+Page Up, Alt+Page Down", "move the step that is written"},
});

void draw_about(App& app) {
    if (!begin_dialog(app.ui, kAboutDialog)) return;
    coloured_text(app.ui.theme.dim_text, "Version " TACT_VERSION);
    ImGui::Spacing();
    ImGui::TextWrapped("%s", kAboutText);
    end_dialog(app.ui);
}

std::vector<std::filesystem::path> recent_folders(const Session& session) {
    constexpr std::size_t kMost = 6;
    std::vector<std::filesystem::path> folders;
    for (const RecentFile& file : recent_files(session)) {
        const std::filesystem::path folder = file.path.parent_path();
        const bool is_known = std::ranges::find(folders, folder) != folders.end();
        if (folders.size() < kMost && !is_known && is_folder(folder)) folders.push_back(folder);
    }
    return folders;
}

void draw_chooser(App& app) {
    if (app.ui.chooser.appears) app.ui.chooser.recent = recent_folders(app.work.session);
    const auto chosen = draw_file_chooser(app.ui);
    if (!chosen) return;
    // It may ask for another file.
    const auto take = std::exchange(app.ui.take_chosen, nullptr);
    if (take) take(*chosen);
}

}  // namespace

std::span<const KeyRow> keys_and_mouse() {
    static const std::vector<KeyRow> all = [] {
        std::vector<KeyRow> rows;
        for (const Command& command : commands()) {
            const std::string keys = shortcut_text(command.shortcut);
            if (keys.empty() || *command.menu == '\0') continue;
            // With Shift the direction is reversed, in the same row.
            if (!rows.empty() && keys == "Shift+" + std::string(rows.back().keys)) {
                rows.back().keys += ", " + keys;
                rows.back().what += ", " + lower_case(command.name);
                continue;
            }
            rows.push_back({command.menu, keys, menu_path(command)});
        }
        for (const auto& [group, keys, what] : kGestures) {
            const auto last = std::find_if(rows.rbegin(), rows.rend(),
                                           [&](const KeyRow& row) { return row.group == group; });
            rows.insert(last == rows.rend() ? rows.end() : last.base(), {group, keys, what});
        }
        return rows;
    }();
    return all;
}

void draw_dialogs(App& app) {
    if (app.ui.question) return draw_question(app.ui);
    draw_chooser(app);
    if (const auto to = std::exchange(app.exports.animation_to, {}); !to.empty()) {
        export_animation(app, to);
    }
    draw_exports(app.ui, app.work, app.exports);
    draw_paper_dialog(app.ui, app.work, app.comparing.foreign, app.exports.paper);
    if (!app.exports.animation) draw_paper_progress(app.ui, app.exports.paper);
    draw_effect_maps_dialog(app.ui, app.work);
    if (std::exchange(app.exports.cancel_asked, false)) cancel_animation(app);
    draw_import_dialogs(app.ui, app.work, app.importing);
    if (const auto file = std::exchange(app.importing.columns_of, {}); !file.empty()) {
        open_table(app.ui, app.work, app.table, file, TableKind::recording);
    }
    draw_table_dialog(app.ui, app.work, app.layout, app.table, app.importing);
    draw_sounds_dialog(app.ui, app.work, app.sounds);
    draw_about(app);
    draw_keys_dialog(app.ui, app.manual, keys_and_mouse());
    draw_generate_dialog(app.ui, app.work, app.generating);
    draw_pad_dialog(app.ui, app.work, app.pad);
    draw_transform_dialog(app.ui, app.work, app.transform);
    draw_steps_dialog(app.ui, app.work, app.steps);
    draw_tapping_dialog(app.ui, app.work, app.pattern_panes.tapping);
    draw_leave_out_dialog(app.ui, app.work, app.studying);
    draw_plan_dialog(app.ui, app.work, app.planning);
    draw_workspace_dialog(app.ui, app.layout, app.workspaces);
    draw_conduct_dialog(app.ui, app.studying);
    if (const auto lesson = draw_course_dialog(app.ui, app.course)) {
        begin_lesson_of_course(app, *lesson);
    }
    draw_devices(app.ui, app.work, app.timeline, app.rendered, app.play);
    act_on_phones(classroom_of(app),
                  draw_phones_dialog(app.ui, app.work, app.timeline, app.play, app.phones));
    draw_calibrate(app.ui, app.work, app.timeline, app.rendered, app.play, app.calibrating);
}

bool is_in_the_middle(const App& app) {
    return is_study_running(app.studying) || app.ui.dialog != kNoDialog || app.ui.chooser.is_open ||
           app.palette.open || app.ui.question || is_popup_open();
}

void drop_paths(App& app, const std::vector<std::filesystem::path>& paths) {
    if (is_in_the_middle(app)) {
        return complain(app.ui,
                        "Nothing was opened: finish what is on the screen, then drop again.");
    }
    const bool tables = !paths.empty() && std::ranges::all_of(paths, [](const auto& path) {
        return extension_of(path) == ".csv";
    });
    if (tables) return read_tables(app.ui, app.work, app.table, paths, true);
    if (are_sounds(paths)) return open_sounds(app.ui, app.work, app.sounds, paths);
    if (paths.size() == 1) return open_file(app, paths[0]);
    open_paths(app.ui, app.work, app.opening, paths, true);
}

}  // namespace tact
