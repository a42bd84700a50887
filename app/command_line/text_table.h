// Tables for people at a terminal, and for programs.
#pragma once

#include <string>
#include <vector>

namespace tact {

using TextRow = std::vector<std::string>;

// Rows of equally many cells: the first column flush left, the others flush right, two blanks
// between. No blanks at the ends of lines.
std::string aligned(const std::vector<TextRow>& rows);

// "-0.11 to 0.78"; "-" for NaN.
std::string range_text(double low, double high, int digits);

// A line of CSV with its end, quoted where it has to be.
std::string csv_line(const TextRow& row);

// The shortest digits that read back as the same; nothing for NaN, which R and pandas read as
// missing.
std::string csv_number(double value);

}  // namespace tact
