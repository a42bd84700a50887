// Numbers as text: digits that read back as the same number, whatever the locale.
#pragma once

#include <cstdint>
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

// A number with this many significant digits and never an exponent: "2414" with three.
std::string plain_digits(double value, int digits);

// A number with this many digits after the point; "-" for NaN.
std::string fixed_digits(double value, int digits);

// Whole number with a comma every three digits, as people read it: 11,025.
std::string grouped_digits(std::uint64_t number);

// With the word for one or for many: 1 person, 2,000 people.
std::string counted(std::size_t count, const char* one, const char* many);

// The functions below are for the window and its pages: minus is a true minus sign, and a number
// that is not finite is "–". A terminal and files take the plain forms above.

// Digits with a hyphen in front: a true minus is as wide as a plus and is not taken for a hyphen.
std::string with_true_minus(std::string digits);

// This many digits after the point: "0.870", "−0.11", never "−0.00".
std::string with_decimals(double value, int decimals);

// This many significant digits, zeros included, without an exponent: "31.2", "0.0304".
std::string significant(double value, int digits = 3);

// The same with a comma every three digits: "61.8", "499,500".
std::string grouped(double value, int digits = 3);

// A measured share: two significant digits below 10 %, whole percent above: "0.43 %", "48 %".
// Rounding never makes it none or all: "< 0.001 %", "99.7 %", "> 99.9 %".
std::string percent(double share);

// Two shares, the unit once: "48 to 85 %".
std::string percent_range(double low, double high);

// A share that somebody has set, or one share more than another: "12.5 %".
std::string exact_percent(double share);

// A share of work, rounded down: at "100 %" it is done.
std::string percent_done(double share);

// A duration: "0.8 s", "42 s", "4 min 42 s", "1 h 02 min".
std::string duration_text(double seconds);

}  // namespace tact
