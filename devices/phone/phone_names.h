// Nicknames that people type into a phone, as they are shown to a whole room.
//
// Output    UTF-8 of at most 24 characters, without what is not seen or steers what shows it:
//           controls, overrides of the direction, characters without width, bytes that are no
//           UTF-8; white space as single spaces, none at the ends
// Source    Unicode 15: general categories Cc, Cf, Zs; default ignorable characters
// Left out  letters that look alike; the count is of code points
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

namespace tact {

inline constexpr std::size_t kMostNicknameCharacters = 24;

// "Phone" if nothing is left.
std::string cleaned_nickname(std::string_view typed);

// "Kim", then "Kim 2", "Kim 3"; cut before the number where it would be too long with it.
std::string unique_nickname(const std::string& wanted, const std::set<std::string>& taken);

}  // namespace tact
