#include "app/phones/qr_code.h"

#include <qrencode.h>

#include <array>
#include <memory>

namespace tact {

namespace {

// The quiet zone is light, and so is what lies beyond it.
bool is_light(const QrCode& code, std::size_t row, std::size_t column) {
    const bool inside = row >= kQuietModules && row < kQuietModules + code.side &&
                        column >= kQuietModules && column < kQuietModules + code.side;
    if (!inside) return true;
    return !code.dark[(row - kQuietModules) * code.side + column - kQuietModules];
}

}  // namespace

QrCode qr_code(const std::string& text) {
    const std::unique_ptr<QRcode, decltype(&QRcode_free)> made(
        QRcode_encodeString8bit(text.c_str(), 0, QR_ECLEVEL_M), &QRcode_free);
    if (!made) return {};
    QrCode code;
    code.side = static_cast<std::size_t>(made->width);
    code.dark.reserve(code.side * code.side);
    for (std::size_t k = 0; k < code.side * code.side; ++k) {
        code.dark.push_back((made->data[k] & 1U) != 0);
    }
    return code;
}

std::string lines_of(const QrCode& code, bool coloured) {
    constexpr std::array kBlocks{" ", "\u2584", "\u2580", "\u2588"};  // none, lower, upper, both
    if (code.side == 0) return {};
    const std::size_t side = code.side + 2 * kQuietModules;
    std::string text;
    for (std::size_t row = 0; row < side; row += 2) {
        if (coloured) text += "\033[97;40m";
        for (std::size_t column = 0; column < side; ++column) {
            const bool upper = is_light(code, row, column);
            // An odd number of rows: below the last one nothing is drawn.
            const bool lower = row + 1 < side && is_light(code, row + 1, column);
            text += kBlocks[(upper ? 2U : 0U) + (lower ? 1U : 0U)];
        }
        if (coloured) text += "\033[0m";
        text += "\n";
    }
    return text;
}

}  // namespace tact
