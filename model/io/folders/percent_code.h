// Bytes as text: names of files are bytes, JSON is UTF-8. "%" and two hexadecimal digits stand for
// a byte that is no ASCII, and for "%" itself.
#pragma once

#include <optional>
#include <string>

namespace tact {

std::string percent_encoded(const std::string& bytes);

// None for a text that is not written so.
std::optional<std::string> percent_decoded(const std::string& text);

}  // namespace tact
