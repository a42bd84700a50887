#include "model/map/random_stress.h"

#include <doctest/doctest.h>

#include <cmath>

namespace random_stress_test {

using namespace tact;

TEST_CASE("random stress: seven patterns without structure fit in space, twelve do not") {
    struct Printed {
        std::size_t objects;
        double mean;
    };
    for (const Printed& printed :
         {Printed{7, .013}, Printed{8, .059}, Printed{12, .136}, Printed{14, .158}}) {
        CAPTURE(printed.objects);
        const RandomStress stress = random_stress(printed.objects, 3, {60, 10, 4, 0});
        // Both sides are means of draws, of maps from other starts.
        CHECK(std::abs(stress.mean - printed.mean) <= 0.008);
        CHECK(stress.middle.low <= stress.mean);
        CHECK(stress.mean <= stress.middle.high);
    }
}

TEST_CASE("random stress: falls with dimensions, rises with patterns, 0 where any order fits") {
    const RandomStressParams few{20, 3, 4, 0};
    CHECK(random_stress(12, 2, few).mean > random_stress(12, 3, few).mean);
    CHECK(random_stress(16, 3, few).mean > random_stress(12, 3, few).mean);
    CHECK(random_stress(4, 3, few).mean == 0.0);
    CHECK(random_stress(0, 3, few).mean == 0.0);
    CHECK(random_stress(9, 3, {10, 3, 4, 1}).mean == random_stress(9, 3, {10, 3, 4, 3}).mean);
}

}  // namespace random_stress_test
