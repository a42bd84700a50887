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

#include "model/common/expected.h"

namespace tact {

inline constexpr std::size_t kMostNicknameCharacters = 24;

// "Phone" if nothing is left.
std::string cleaned_nickname(std::string_view typed);

// "Kim", then "Kim 2", "Kim 3"; cut before the number where it would be too long with it.
std::string unique_nickname(const std::string& wanted, const std::set<std::string>& taken);

// Secrets that a stranger cannot guess: of the page's address, and of each phone.
//
// Source    getrandom(2); base64url of RFC 4648, without padding
// Output    128 random bits as 22 characters

inline constexpr std::size_t kSecretLength = 22;

// An Error if the system gives no random numbers.
Expected<std::string> random_secret();

// Whether a text has the form of a secret.
bool is_secret(std::string_view text);

// Takes as long for texts that differ early as for those that differ late: how much of a guess was
// right does not show.
bool is_same_secret(std::string_view one, std::string_view other);

}  // namespace tact
