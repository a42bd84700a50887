#include "app/window/window.h"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "app/ask/ask.h"
#include "app/candidates/candidates.h"
#include "app/compare/compare.h"
#include "app/document/editing.h"
#include "app/export/export.h"
#include "app/layers/layers.h"
#include "app/lesson/lesson.h"
#include "app/map/map.h"
#include "app/opening/opening.h"
#include "app/patterns/patterns.h"
#include "app/pictures/pictures.h"
#include "app/play/play.h"
#include "app/study/study.h"
#include "app/subset/subset.h"
#include "app/wave_strip/wave_strip.h"
#include "model/io/lesson/course_file.h"
#include "model/io/lesson/lesson_file.h"
#include "model/set/layers.h"

namespace tact {

void remove_chosen_or_selected(App& app) {
    if (remove_chosen(app.ui, app.work, app.pattern_panes.strip)) return;
    remove_selected(app.ui, app.work);
}

void copy_notes_or_selected(App& app) {
    if (!copy_notes(app.ui, app.work, app.pattern_panes.strip)) copy_selected(app.ui, app.work);
}

void paste_notes_or_patterns(App& app) {
    const double at_s = app.timeline.playhead.at_s;
    if (!paste_notes(app.ui, app.work, app.pattern_panes.strip, at_s)) paste(app.ui, app.work);
}

void double_notes_or_selected(App& app) {
    if (repeat_notes(app.ui, app.work, app.pattern_panes.strip, 2)) return;
    duplicate_selected(app.ui, app.work);
}

void choose_all(App& app) {
    if (!choose_all_notes(app.ui, app.work, app.pattern_panes.strip)) select_all(app.work);
}

bool has_chosen_notes(const App& app) {
    return has_chosen_notes(app.work, app.pattern_panes.strip);
}

bool has_layers(const App& app) { return current_layers(app.work) != nullptr; }

bool can_add_layer(const App& app) {
    const Vibration* current = current_vibration(app.work);
    const LayeredPattern* layered = current_layers(app.work);
    const std::size_t count = layered == nullptr ? 1 : layered->layers.size();
    return current != nullptr && !current->locked && count < limits::kMaxLayers;
}

bool can_layer_selected(const App& app) { return can_be_layered(app.work); }

bool has_selection(const App& app) { return current_vibration(app.work) != nullptr; }

bool has_unread_files(const App& app) { return !app.opening.left_out.empty(); }

bool has_effects(const App& app) { return !actuators_of(app.work.document.set).empty(); }

bool has_answers(const App& app) {
    const auto& answers = app.studying.answers;
    return answers && answers->results;
}

bool has_subset(const App& app) { return shown_pick(app.shown_map, app.picking) != nullptr; }

bool has_pairs(const App& app) { return app.work.document.set.vibrations.size() > 1; }

bool has_editable_pattern(const App& app) { return editable_layer(app.work) != nullptr; }

bool has_neighbours(const App& app) { return can_vary(app.work); }

bool has_corners(const App& app) { return pad_corners(app.work).size() >= 2; }

bool has_missing(const App& app) {
    const auto there =
        std::ranges::count(app.work.document.set.vibrations, false, &Vibration::dropped);
    return there > 0 && there < app.picking.count;
}

bool has_exact_map(const App& app) {
    return has_pairs(app) && map_state(app.work, app.shown_map) == MapState::exact;
}

bool has_exact_subset(const App& app) {
    const Pick* pick = shown_pick(app.shown_map, app.picking);
    return pick != nullptr && !is_unsettled(*pick);
}

bool has_study(const App& app) {
    return participant_obstacle(app.work, app.play, app.studying).empty();
}

bool has_map_of_all(const App& app) {
    return simulation_obstacle(app.work, app.studying, app.shown_map).empty();
}

void start_rename(App& app) {
    // Names are typed in the list, which the table replaces.
    if (app.layout.arrangement == Arrangement::select) show_workspace(app, Arrangement::design);
    if (app.layout.maximised != Pane::patterns) app.layout.maximised.reset();
    app.in_use.pane = Pane::patterns;
    const std::vector<std::size_t> rows = listed_indices(app.work);
    if (std::ranges::find(rows, app.work.selection.current) == rows.end()) {
        app.work.selection.search.clear();
        app.work.selection.only_picked = false;
    }
    begin_rename(app.work, app.pattern_panes, app.work.selection.current);
    app.work.selection.scroll_to_current = true;
}

void open_effect_export(App& app) {
    std::vector<std::string> picked;
    if (const Subset* subset = shown_subset(app.shown_map, app.picking)) {
        const PatternSet& set = *shown_pick(app.shown_map, app.picking)->request.map->request.set;
        for (const std::size_t member : subset->members) {
            picked.push_back(set.vibrations[member].name);
        }
    }
    export_effects_dialog(app.ui, app.work, app.shown_map, picked,
                          static_cast<std::size_t>(app.picking.count), app.picking.objective,
                          app.exports.effects);
}

void swap_alternating(App& app) { swap_pair(app.work, app.shown_map, app.play); }

void rewind(App& app) {
    app.timeline.playhead.at_s = 0.0;
    app.timeline.playhead.playing = false;
}

void escape(App& app) {
    if (app.ui.escape_taken) return;
    if (app.palette.open) {
        app.palette.open = false;
    } else if (is_opening(app.opening)) {
        cancel_opening(app.ui, app.opening);
    } else if (app.exports.animation) {
        cancel_animation(app);
    } else if (app.lesson.step && app.lesson.editing) {
        say(app.ui, "Esc ends no lesson that is being written. Lesson > Leave the lesson does.");
    } else if (app.lesson.step) {
        leave_the_lesson(app);
    } else if (is_filling(app.proposals)) {
        stop_filling(app.proposals);
    } else if (app.proposals.put.job.asked()) {
        stop_putting(app.proposals);
    } else if (!app.proposals.varied.empty()) {
        stop_varying(app.proposals);
    } else if (app.timeline.playhead.playing) {
        app.timeline.playhead.playing = false;
    } else if (app.physiology.view.explained) {
        app.physiology.view.explained.reset();
    } else if (app.physiology.view.open) {
        app.physiology.view.open.reset();
    } else if (has_chosen_notes(app)) {
        app.pattern_panes.strip.notes = {};
    } else if (app.layout.maximised) {
        app.layout.maximised.reset();
    } else if (app.studying.is_open) {
        close_study(app.studying);
    } else {
        app.work.selection.others.clear();
        app.ui.status = {};
    }
}

void show_workspace(App& app, Arrangement arrangement) {
    close_study(app.studying);
    show_arrangement(arrangement, app.layout, app.workspaces);
}

bool is_workspace(const App& app, Arrangement arrangement) {
    return !app.studying.is_open && app.workspaces.shown.empty() &&
           app.layout.arrangement == arrangement;
}

void reset_workspace(App& app) {
    close_study(app.studying);
    app.workspaces.shown.clear();
    app.layout = first_layout(app.layout.arrangement);
}

void maximise_or_restore(App& app) {
    auto& maximised = app.layout.maximised;
    maximised = maximised ? std::nullopt : std::optional(app.in_use.pane);
}

bool has_bars(const App& app) { return !app.layout.maximised && !app.studying.is_open; }

void show_tab(App& app, BenchTab tab) {
    close_study(app.studying);
    if (app.layout.maximised != Pane::matrix) app.layout.maximised.reset();
    app.layout.bench = tab;
}

void fold_physiology(App& app, Fold fold) {
    close_study(app.studying);
    app.layout.physiology = fold;
    app.layout.maximised.reset();
    if (fold == Fold::open) app.in_use.pane = Pane::physiology;
}

void show_training(App& app) {
    show_tab(app, BenchTab::model);
    app.model_bench.panel.view = ModelView::training;
}

void show_findings(App& app) {
    show_tab(app, BenchTab::compare);
    app.comparing.panel.view = CompareView::findings;
}

namespace {

// Runs between the panels and the end of the frame: another set replaces the document.
template <class Then>
void once_lesson_may_go(App& app, Then then) {
    app.ui.waiting.emplace_back(
        [&app, then] { before_lesson_goes(lesson_context(app), app.lesson, then); });
}

}  // namespace

void begin_tour(App& app) {
    once_lesson_may_go(app, [&app] { start_tour(lesson_context(app), app.lesson); });
}

void begin_lesson(App& app) {
    once_lesson_may_go(app, [&app] { new_lesson(lesson_context(app), app.lesson); });
}

void open_bundled_lesson(App& app, const char* path) {
    once_lesson_may_go(app, [&app, path] {
        start_bundled_lesson(lesson_context(app), app.lesson, path);
        if (app.lesson.key == path) ask_where_to_begin(lesson_context(app), app.lesson);
    });
}

void open_file(App& app, const std::filesystem::path& path) {
    if (is_course_file(path)) {
        return open_course_file(app.ui, app.work.session, app.course, path);
    }
    if (!is_lesson_file(path)) return open_paths(app.ui, app.work, app.opening, {path});
    once_lesson_may_go(app, [&app, path] { open_lesson(lesson_context(app), app.lesson, path); });
}

void open_dialog(App& app) {
    ask_for_vibrations(app.ui, app.work,
                       "Open a set, a recording, an effect file, or a folder of them",
                       [&app](const std::filesystem::path& path) { open_file(app, path); });
}

void open_lesson_dialog(App& app, const char* title) {
    ask_for_file(app.ui,
                 {.title = title,
                  .extensions = {".json"},
                  .take = [&app](const std::filesystem::path& path) { open_file(app, path); }},
                 app.work.document.path.parent_path());
}

void open_course_of_program(App& app) { open_bundled_course(app.ui, app.work.session, app.course); }

void begin_lesson_of_course(App& app, std::size_t which) {
    once_lesson_may_go(app, [&app, which] {
        begin_course_lesson(lesson_context(app), app.lesson, app.course, which);
    });
}

void duplicate_the_lesson(App& app) {
    app.ui.waiting.emplace_back([&app] { duplicate_lesson(lesson_context(app), app.lesson); });
}

void check_the_lesson(App& app) { check_lesson(app.ui, app.work, app.lesson); }

void present(App& app) {
    app.ui.waiting.emplace_back([&app] { toggle_presenting(lesson_context(app), app.lesson); });
}

void leave_the_lesson(App& app) {
    once_lesson_may_go(app, [&app] { leave_lesson(lesson_context(app), app.lesson); });
}

bool has_lesson(const App& app) { return app.lesson.step && !app.lesson.is_of_set; }

bool has_undo(const App& app) { return app.work.document.history.undo_label() != nullptr; }

bool has_redo(const App& app) { return app.work.document.history.redo_label() != nullptr; }

bool has_sound(const App& app) { return can_sound(app.play); }

const char* what_lacks(const App& app, const Command& command) {
    struct Lack {
        bool (*has)(const App&);
        const char* words;
    };
    constexpr std::array kLacks{
        Lack{has_selection, "the set is empty"},
        Lack{has_effects, "nothing here came from an effect file"},
        Lack{has_unread_files, "all files were read"},
        Lack{has_answers, "nobody has answered yet"},
        Lack{has_subset, "nothing is picked yet"},
        Lack{has_pairs, "needs two patterns"},
        Lack{has_editable_pattern, "needs a pattern that is no recording and not locked"},
        Lack{has_chosen_notes, "choose notes of the strip first, with the tool of notes (B)"},
        Lack{has_layers, "this pattern has no layers"},
        Lack{can_add_layer, "needs a pattern that is not locked and has fewer than four layers"},
        Lack{can_layer_selected, "select two to four patterns first"},
        Lack{has_neighbours, "needs three patterns, and one that can be edited"},
        Lack{has_corners, "select two to four patterns first"},
        Lack{has_missing, "no pattern is missing: raise the number to pick first"},
        Lack{has_exact_map, "the map is not exact yet"},
        Lack{has_exact_subset, "no exact subset is picked yet"},
        Lack{has_map_of_all, "needs a map of three patterns"},
        Lack{has_study, "needs three patterns, rounds that fit, and a level above 0"},
        Lack{has_lesson, "no lesson is open"},
        Lack{has_undo, "nothing to undo"},
        Lack{has_redo, "nothing to redo"},
        Lack{has_sound, "no device to play on"},
        Lack{has_bars, "no other pane gives way here"}};
    if (command.enabled(app)) return nullptr;
    const auto found = std::ranges::find(kLacks, command.enabled, &Lack::has);
    return found == kLacks.end() ? "not now" : found->words;
}

// All digits, and only exact values: a pasted preview would lose its label.
void copy_shown_table(App& app) {
    const auto& map = app.shown_map.transition.shown;
    if (!map || map_state(app.work, app.shown_map) != MapState::exact) {
        return say(app.ui, "Not copied: the map is not exact yet, and its numbers would change.");
    }
    const bool selects = app.layout.arrangement == Arrangement::select;
    const auto& comparison = app.comparing.comparison;
    const auto copy = [&app](const std::string& csv, const std::string& what) {
        ImGui::SetClipboardText(csv.c_str());
        say(app.ui, "Copied " + what + " as CSV");
    };
    if (app.layout.bench == BenchTab::candidates || selects) {
        copy(candidates_csv(app.work.document.set,
                            candidate_rows(app.work, app.shown_map, app.candidates)),
             "the table of candidates");
    } else if (app.layout.bench == BenchTab::compare && comparison &&
               comparison->request.map == map) {
        copy(comparison_csv(*comparison), "the table of metrics");
    } else {
        copy(matrix_csv(*map), "the matrix of PM");
    }
}

void tour_from_the_start(App& app) {
    app.lesson.left_at.erase(kTourLesson);
    begin_tour(app);
}

}  // namespace tact
