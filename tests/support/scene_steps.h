// What a person does in the window, step by step, until it shows what came of it.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "app/study/study.h"
#include "tests/support/program.h"

namespace tact {

// Draws frames until then, or until the end of patience.
void wait_until(Program& program, const std::function<bool()>& is_so);

// Runs a command of the palette. Throws if no command has that name.
void run(Program& program, std::string_view name);

// What has no room on a small screen cannot be pressed there.
void click_if_there(Program& program, const std::string& name);

void right_click(Program& program, const std::string& name);
void rest_on(Program& program, const std::string& name);

// As a window does between frames.
void make_fonts(Program& program);

// A participant's page is larger.
void remake_fonts(Program& program);

void wait_for_lesson(Program& program);

// With its numbers.
void open_tour(Program& program);

void begin_presenting(Program& program);
void show_bench(Program& program, BenchTab tab);
void show_subset(Program& program, SubsetView view);
void show_compare(Program& program, CompareView view);
void show_model(Program& program, ModelView view);
void show_dialog(Program& program, Dialog dialog);
void maximise(Program& program, Pane pane);
void wait_for_comparison(Program& program);
void show_why(Program& program);

// Files of participants, as long as the program of the scenes runs.
void open_people(Program& program, StudyKind kind);

void wait_for_answers(Program& program);

// Three who answer as the model predicts, with noise.
void show_answers(Program& program, StudyKind kind, StudyShow show);

// With the answers of those three.
void compare_with_people(Program& program);

// Somebody is in the middle of it: both were felt, and some are sorted.
void show_participant(Program& program, StudyKind kind, StudyPage page);

}  // namespace tact
