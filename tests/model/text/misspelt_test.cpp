#include "model/text/json_fields.h"

#include <doctest/doctest.h>

#include <array>
#include <string>

namespace misspelt_test {

using namespace tact;

namespace {

constexpr std::array<std::string_view, 4> kKnown{"nc_weight", "oc_weight", "name", "hz"};

std::string meant(std::string_view word) {
    return std::string(misspelt(word, kKnown).value_or("nothing"));
}

}  // namespace

TEST_CASE("misspelt: a letter more, less, other, or two exchanged, in either case") {
    CHECK(meant("nc_weigth") == "nc_weight");
    CHECK(meant("nc_wieght") == "nc_weight");
    CHECK(meant("nc_wight") == "nc_weight");
    CHECK(meant("nc_weightt") == "nc_weight");
    CHECK(meant("oc-weight") == "oc_weight");
    CHECK(meant("NC_Weight") == "nc_weight");
    CHECK(meant("nmae") == "name");
    CHECK(meant("names") == "name");
}

TEST_CASE("misspelt: another word is none that was meant") {
    CHECK(meant("colour") == "nothing");
    CHECK(meant("nose") == "nothing");  // two slips in four letters
    CHECK(meant("kz") == "nothing");    // any two words of two letters are alike
    CHECK(meant("") == "nothing");
    CHECK(meant(std::string(1'000'000, 'n')) == "nothing");
    CHECK(misspelt("name", {}) == std::nullopt);
}

}  // namespace misspelt_test
