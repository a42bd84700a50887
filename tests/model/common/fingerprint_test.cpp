#include "model/common/fingerprint.h"

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <vector>

namespace fingerprint_test {

using namespace tact;

namespace {

std::uint64_t of_bytes(const std::vector<std::uint8_t>& bytes) {
    return mixed(0, std::span<const std::uint8_t>(bytes));
}

}  // namespace

TEST_CASE("fingerprint: any bit changes it, wherever it stands") {
    // 19 bytes: the last word is not full.
    std::vector<std::uint8_t> bytes(19, 0x5a);
    std::set<std::uint64_t> seen{of_bytes(bytes)};
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1U << bit % 8));
        seen.insert(of_bytes(bytes));
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1U << bit % 8));
    }
    CHECK(seen.size() == 8 * bytes.size() + 1);
}

TEST_CASE("fingerprint: zeros at the end count, and so does where an array ends") {
    CHECK(of_bytes({1}) != of_bytes({1, 0}));
    CHECK(of_bytes({}) != 0);
    const std::array<double, 3> values{1.0, 2.0, 3.0};
    const std::span all(values);
    CHECK(mixed(mixed(0, all.first(1)), all.subspan(1)) !=
          mixed(mixed(0, all.first(2)), all.subspan(2)));
}

TEST_CASE("fingerprint: the order of values counts") {
    CHECK(of_bytes({1, 2}) != of_bytes({2, 1}));
    CHECK(mixed(mixed(0, 1), 2) != mixed(mixed(0, 2), 1));
}

}  // namespace fingerprint_test
