// What is false, or no longer true, of who was asked, what was felt and what was measured: the part
// of a value that goes wherever its numbers go.
//
// Output    words beside a number, phrases for a title, sentences for a text, and the corner of a
//           table, where programs that take names from the first row and column read past it
// Exact     mark_in(corner_text(mark)) == mark; corners of earlier versions are understood, too
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tact {

struct NumberMark {
    bool synthetic = false;           // nobody was asked, for some of the ratings at least
    bool rehearsal = false;           // nothing was felt
    bool synthetic_model = false;     // trained on synthetic ratings
    bool synthetic_patterns = false;  // measured by nobody, some at least
    bool uncalibrated = false;        // what full scale is in g was guessed
    bool stale = false;               // some of the patterns are others than were felt
    std::size_t left_out = 0;         // participants who do not count
    std::size_t rehearsals = 0;       // of these

    bool operator==(const NumberMark&) const = default;
};

// What is to be said of numbers that rest on both. Who is left out of both counts once.
NumberMark operator|(NumberMark a, const NumberMark& b);

// "synthetic, stale": of a single quantity of people; empty where nothing is to be said.
std::string words_of(const NumberMark& mark);

// "2 participants left out, 1 rehearsal among them"; empty where everyone counts.
std::string left_out_text(const NumberMark& mark);

// "by a model trained on synthetic ratings, of synthetic patterns": for titles.
std::string phrase_of(const NumberMark& mark);

// "SYNTHETIC: nobody was asked for some or all of these", a sentence each.
std::vector<std::string> sentences_of(const NumberMark& mark);

// All of them as the corner of a table; and what a corner says.
std::string corner_text(const NumberMark& mark);
NumberMark mark_in(std::string_view corner);

}  // namespace tact
