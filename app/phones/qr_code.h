// An address as a QR code, which a phone's camera reads.
//
// Source    ISO/IEC 18004, by libqrencode; the quiet zone of four modules around it is the
// standard's Valid     addresses of at most some hundred characters
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tact {

inline constexpr std::size_t kQuietModules = 4;

struct QrCode {
    std::size_t side = 0;    // modules, without the quiet zone; 0: the text is too long
    std::vector<bool> dark;  // row by row

    bool operator==(const QrCode&) const = default;
};

QrCode qr_code(const std::string& text);

// Lines of half blocks with the quiet zone, two modules a line. `coloured`: with a terminal's codes
// for black on white, as cameras expect it; otherwise what is light is drawn, which fits terminals
// of light text on a dark ground.
std::string lines_of(const QrCode& code, bool coloured);

}  // namespace tact
