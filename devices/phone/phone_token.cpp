#include "devices/phone/phone_token.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <span>

namespace tact {

namespace {

constexpr std::string_view kSecretLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

bool fill_randomly(std::span<unsigned char> bytes) {
    while (!bytes.empty()) {
        const auto count = getrandom(bytes.data(), bytes.size(), 0);
        if (count < 0 && errno != EINTR) return false;
        if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

}  // namespace

Expected<std::string> random_secret() {
    std::array<unsigned char, 16> bytes{};
    if (!fill_randomly(bytes)) return Error{"the system gives no random numbers: try again"};
    std::string text;
    std::uint32_t bits = 0;
    unsigned count = 0;
    for (const unsigned char byte : bytes) {
        bits = (bits << 8U) | byte;
        for (count += 8; count >= 6; count -= 6) {
            text += kSecretLetters[(bits >> (count - 6)) & 63U];
        }
    }
    return text += kSecretLetters[(bits << (6 - count)) & 63U];
}

bool is_secret(std::string_view text) {
    return text.size() == kSecretLength &&
           text.find_first_not_of(kSecretLetters) == std::string_view::npos;
}

bool is_same_secret(std::string_view one, std::string_view other) {
    if (one.size() != other.size()) return false;
    unsigned difference = 0;
    for (std::size_t k = 0; k < one.size(); ++k) {
        difference |= static_cast<unsigned char>(one[k] ^ other[k]);
    }
    // Read as if it could change, so that the compiler leaves no loop early.
    volatile unsigned kept = difference;
    return kept == 0;
}

}  // namespace tact
