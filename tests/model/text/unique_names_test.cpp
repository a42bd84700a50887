#include "model/text/names.h"

#include <doctest/doctest.h>

namespace unique_names_test {

using namespace tact;

TEST_CASE("equal names: the first that comes again is found, with where it was") {
    CHECK_FALSE(first_equal({}));
    CHECK_FALSE(first_equal({"a", "A", "a ", ""}));
    CHECK(first_equal({"x", "a", "b", "a", "x"}) == std::pair<std::size_t, std::size_t>{1, 3});
    CHECK(first_equal({"", ""}) == std::pair<std::size_t, std::size_t>{0, 1});
}

}  // namespace unique_names_test
