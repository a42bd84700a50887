// A question over the window: a sentence, and answers of which one is to be chosen before anything
// else is done.
//
// Everything goes by keyboard: arrows and Tab move along the answers, Enter takes the marked one,
// Esc the last one, which changes nothing.
//
// Left out  questions one after the other: a newer one takes the place of the older, as if that
//           had been left by Esc.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tact {

struct Ui;

struct Answer {
    std::string label;            // a verb: what is then done
    std::function<void()> run{};  // none: nothing is
};

struct Question {
    std::string title;
    std::string text;
    std::vector<Answer>
        answers;  // the first is the safe one, and marked; the last leaves all as is
    std::size_t marked = 0;
};

// In the place of any dialog that is open.
void ask(Ui& ui, Question question);

// What is to be known and has no other place; it stays until it is read.
void tell(Ui& ui, const std::string& title, const std::string& text);

void draw_question(Ui& ui);

}  // namespace tact
