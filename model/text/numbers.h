// Numbers as text: digits that read back as the same number, whatever the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tact {

// Without the blanks around it.
std::string_view trimmed(std::string_view text);

// The finite number that a text consists of, blanks around it and a plus sign allowed; none for
// anything else, NaN and infinity among it.
std::optional<double> finite_number_in(std::string_view text);

// As few digits as read back as the same number.
void append_digits(std::string& text, double value);
std::string shortest_digits(double value);

// A number with this many significant digits, without trailing zeros: "0.25", "1.2e-05".
std::string significant_digits(double value, int digits);

// `count` steps as the number that a person would write: 33 times 0.05 is 1.65, where the product
// of the two is 1.6500000000000001.
double multiple_of(double step, double count);

// Whole number with a comma every three digits, as people read it: 11,025.
std::string grouped_digits(std::size_t number);

// With the word for one or for many: 1 person, 2,000 people.
std::string counted(std::size_t count, const char* one, const char* many);

}  // namespace tact
