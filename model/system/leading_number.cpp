#include "model/system/leading_number.h"

#include <charconv>
#include <cmath>

namespace tact {

std::optional<LeadingNumber> leading_number(std::string_view text) {
    LeadingNumber number;
    const char* const begin = text.data();
    const auto [end, fault] = std::from_chars(begin, begin + text.size(), number.value);
    if (fault != std::errc{} || !std::isfinite(number.value)) return std::nullopt;
    number.length = static_cast<std::size_t>(end - begin);
    return number;
}

}  // namespace tact
