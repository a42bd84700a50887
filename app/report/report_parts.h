// The sections of a report. Private to the report.
#pragma once

#include <string>

#include "app/report/report.h"

namespace tact {

// The name of a vibration as html; the picked ones are marked by a ring.
std::string name_html(const Report& report, std::size_t place);
bool is_picked(const Report& report, std::size_t place);

// Names beside each other, as many as a group has room for.
std::string names_html(const Report& report, const std::vector<std::size_t>& places);
std::string pair_html(const Report& report, const ConfusablePair& pair);
// "And 12 more pairs."; empty: there are no more.
std::string and_more(std::size_t count, const std::string& what);

// "PM 34.5".
std::string value_text(const Report& report, double dissimilarity);

// A number that stands out, and what it is; `words` are html.
std::string tile(const std::string& number, const std::string& words);

std::string map_section(const Report& report);
std::string groups_section(const Report& report);
std::string alike_section(const Report& report);   // report_library.cpp; empty: not asked for
std::string closest_html(const Report& report);    // of large sets: a line a pair
std::string unfelt_section(const Report& report);  // empty: all are felt
// The matrix of more patterns than a table has room for; `most`: the largest value.
std::string matrix_picture(const Report& report, double most);
std::string closer_section(const Report& report);
std::string subset_section(const Report& report);
std::string patterns_section(const Report& report);  // report_patterns.cpp
std::string matrix_section(const Report& report);    // report_matrix.cpp
std::string assumed_section(const Report& report);   // report_assumed.cpp

// The first sentence of a note, which says where a pattern is from.
std::string first_sentence(const std::string& note);

// CSS of all of them.
std::string report_style();
std::string shade_styles();  // of the matrix's cells

}  // namespace tact
