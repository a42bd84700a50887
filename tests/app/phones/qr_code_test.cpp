// The code that cameras read: its three corners, its quiet zone, and its lines for a terminal.
#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "app/phones/phones.h"

namespace qr_code_test {

using namespace tact;

namespace {

const std::string kAddress = "http://192.168.1.23:43211/AAAAAAAAAAAAAAAAAAAAAA/";

// A finder pattern of ISO/IEC 18004: dark, light, a dark core of three.
bool is_finder(const QrCode& code, std::size_t row, std::size_t column) {
    for (std::size_t y = 0; y < 7; ++y) {
        for (std::size_t x = 0; x < 7; ++x) {
            const bool edge = x == 0 || x == 6 || y == 0 || y == 6;
            const bool core = x >= 2 && x <= 4 && y >= 2 && y <= 4;
            if (code.dark[(row + y) * code.side + column + x] != (edge || core)) return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("QR code: three corners are marked, the fourth is not") {
    const QrCode code = qr_code(kAddress);
    REQUIRE(code.side > 20);
    CHECK((code.side - 17) % 4 == 0);
    const std::size_t far = code.side - 7;
    CHECK(is_finder(code, 0, 0));
    CHECK(is_finder(code, 0, far));
    CHECK(is_finder(code, far, 0));
    CHECK_FALSE(is_finder(code, far, far));
    CHECK(code != qr_code(kAddress + "x"));
}

TEST_CASE("QR code: a text that is too long for any code gives no code") {
    CHECK(qr_code(std::string(5000, 'x')).side == 0);
    CHECK(lines_of(qr_code(std::string(5000, 'x')), false).empty());
}

TEST_CASE("QR code: as lines it has the quiet zone around it, and two rows a line") {
    const QrCode code = qr_code(kAddress);
    const std::string lines = lines_of(code, false);
    const std::size_t side = code.side + 2 * kQuietModules;
    CHECK(static_cast<std::size_t>(std::count(lines.begin(), lines.end(), '\n')) == (side + 1) / 2);
    std::string quiet;
    for (std::size_t k = 0; k < side; ++k) quiet += "\u2588";
    CHECK(lines.starts_with(quiet + "\n" + quiet + "\n"));
    CHECK(lines_of(code, true).find("\033[97;40m") == 0);
}

}  // namespace qr_code_test
