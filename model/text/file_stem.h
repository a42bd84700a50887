// Names of patterns and people as names of files.
//
// Left out  names that differ in case only, which some file systems take for one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tact {

inline constexpr std::size_t kLongestStem = 120;  // bytes; file systems have 255 with the ending

// A name as a file's, without its ending: UTF-8, never empty nor hidden; what file systems refuse,
// and what would steer the terminal that lists it, becomes "-". A longer one is cut between
// characters and gets a number of the whole, so that names that differ behind the cut differ here,
// too.
std::string file_stem(std::string_view name);

}  // namespace tact
