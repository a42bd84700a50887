#include "model/set/vibration_search.h"

#include <doctest/doctest.h>

namespace vibration_search_test {

using namespace tact;

TEST_CASE("search: the tags that a note names find its vibration, as whole words") {
    Vibration vibration;
    vibration.name = "Afterglow";
    vibration.note = "A phrase that dissolves. Tags: Bold, Two beats. From a.json (Pulsar).";
    for (const char* found : {"after", "bold", "BOLD beats", "two", "bold 1s"}) {
        CAPTURE(found);
        CHECK(VibrationSearch(found).finds(vibration));
    }
    for (const char* missed : {"bol", "pulsar", "dissolves", "bold soft", "tags:"}) {
        CAPTURE(missed);
        CHECK_FALSE(VibrationSearch(missed).finds(vibration));
    }
    vibration.note = "Tags: last";
    CHECK(VibrationSearch("last").finds(vibration));
}

}  // namespace vibration_search_test
