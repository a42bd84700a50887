// The variants of the model, and the choice of each judge. Their results are the page "findings
// --variants".
#include "app/command_line/agreement/agreement.h"

#include <doctest/doctest.h>

#include <utility>

namespace model_variants_test {

using namespace tact;

TEST_CASE("model variants: the published one first, and each other differs from it as it says") {
    const std::vector<ModelVariant> all = model_variants();
    REQUIRE(all.size() == 9);
    CHECK(all[0].name == "as published");
    CHECK(all[0].model == PerceptualModelParams{});
    double last = 0.0;
    for (std::size_t k = 1; k <= 6; ++k) {
        PerceptualModelParams free = all[k].model;
        CHECK(free.envelope.waiting_cost > last);
        last = std::exchange(free.envelope.waiting_cost, 0.0);
        CHECK(free == PerceptualModelParams{});
    }
    CHECK(all[6].name == "waiting costs 1");
    for (const std::size_t k : {7UL, 8UL}) {
        PerceptualModelParams one = all[k].model;
        CHECK(one.coding.tables.threshold == aosp_thresholds());
        CHECK(one.envelope.waiting_cost == (k == 7 ? 0.0 : 0.1));
    }
}

TEST_CASE("model variants: each judge chooses the best by its own count, of equals the first") {
    const auto one = [](const char* name, double morse_pm, std::size_t hold) {
        VariantOutcome outcome;
        outcome.name = name;
        outcome.morse_pm = morse_pm;
        outcome.hold = hold;
        return outcome;
    };
    const std::vector<VariantOutcome> all{one("a", 0.7, 3), one("b", 0.8, 3), one("c", 0.8, 2)};
    CHECK(chosen_by_morse(all).name == "b");
    CHECK(chosen_by_findings(all).name == "a");
}

TEST_CASE("model variants: nothing when stopped") {
    std::stop_source stop;
    stop.request_stop();
    VariantOptions options;
    options.stop = stop.get_token();
    CHECK_FALSE(check_variants(options));
}

}  // namespace model_variants_test
