// Secrets that a stranger cannot guess: of the page's address, and of each phone.
//
// Source    getrandom(2); base64url of RFC 4648, without padding
// Output    128 random bits as 22 characters
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "model/common/expected.h"

namespace tact {

inline constexpr std::size_t kSecretLength = 22;

// An Error if the system gives no random numbers.
Expected<std::string> random_secret();

// Whether a text has the form of a secret.
bool is_secret(std::string_view text);

// Takes as long for texts that differ early as for those that differ late: how much of a guess was
// right does not show.
bool is_same_secret(std::string_view one, std::string_view other);

}  // namespace tact
