// Text from a file or a person, as it is shown to people: on a terminal, in tables, messages,
// pages, pictures and titles.
//
// A character that would steer what shows it becomes its number, "\u001b": C0 and C1 controls,
// marks and overrides of the direction of writing, separators of lines. JSON reads the same text
// back from that. Bytes that are not UTF-8 become U+FFFD.
//
// Source    ECMA-48; Unicode 15, bidirectional controls (UAX 9)
// Left out  letters that look alike
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tact {

// Whether a character steers what shows it, instead of being seen.
bool is_steering(char32_t character);

// Whether any character of the text is such a one.
bool has_steering(std::string_view text);

// "\u001b"
std::string number_of_character(char32_t character);

// On one line: a name, a path, a sentence.
std::string shown_text(std::string_view text);

// The same with its lines and tabs as they are: what is a text of several lines.
std::string shown_lines(std::string_view text);

std::vector<std::string> shown_texts(std::vector<std::string> texts);

// With one character in place of each that steers.
std::string without_steering(std::string_view text, char instead);

}  // namespace tact
