// A question over the window: a sentence, and answers; one must be chosen before anything else.
//
// The keyboard is enough: arrows and Tab move along the answers, Enter takes the marked one, Esc
// the last one, which changes nothing.
//
// Left out  a queue of questions: a new one replaces the open one as if Esc had been pressed.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tact {

struct Ui;

struct Answer {
    std::string label;            // a verb
    std::function<void()> run{};  // null: nothing happens
};

struct Question {
    std::string title;
    std::string text;
    std::vector<Answer> answers;  // the first is safe, and marked; the last changes nothing
    std::size_t marked = 0;
};

// Replaces any open dialog.
void ask(Ui& ui, Question question);

// A message that has no other place; it stays until it is read.
void tell(Ui& ui, const std::string& title, const std::string& text);

void draw_question(Ui& ui);

}  // namespace tact
