// The finite decimal number that a text begins with.
//
// Exact     the double that is nearest to the decimal, whatever the locale
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace tact {

struct LeadingNumber {
    double value = 0.0;
    std::size_t length = 0;  // in bytes
};

// "-1.5e3", without a plus sign, blanks or a base before it. None: the text begins with something
// else ("inf" and "nan" among it), or with what no double holds, such as 1e400 or 1e-400.
std::optional<LeadingNumber> leading_number(std::string_view text);

// The same, for systems whose C++ library reads no double (libc++ up to 19): by the C library below
// it, which takes more for a number. In the locale "C" alone.
std::optional<LeadingNumber> leading_number_by_c(std::string_view text);

}  // namespace tact
