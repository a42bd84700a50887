#include "model/io/folders/percent_code.h"

#include <charconv>
#include <string_view>

namespace tact {

std::optional<std::string> percent_decoded(const std::string& text) {
    std::string bytes;
    for (std::size_t k = 0; k < text.size(); ++k) {
        unsigned byte = 0;
        const char* digits = text.data() + k + 1;
        if (text[k] != '%') {
            bytes += text[k];
            continue;
        }
        if (k + 2 >= text.size() || std::from_chars(digits, digits + 2, byte, 16).ptr != digits + 2)
            return std::nullopt;
        bytes += static_cast<char>(byte);
        k += 2;
    }
    return bytes;
}

std::string percent_encoded(const std::string& bytes) {
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80 && c != '%') {
            text += c;
        } else {
            text += {'%', kDigits[byte / 16], kDigits[byte % 16]};
        }
    }
    return text;
}

}  // namespace tact
