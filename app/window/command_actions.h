// Actions of commands that need more than one room, and the conditions for them.
#pragma once

#include "app/window/app.h"

namespace tact {

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
// Opens a lesson, or a file that can be a set; asks about unsaved changes of an open lesson.
void open_file(App& app, const std::filesystem::path& path);
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

}  // namespace tact
