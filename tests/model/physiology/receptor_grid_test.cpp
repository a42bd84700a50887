#include "model/physiology/receptor_grid.h"

#include <numbers>
#include <numeric>

#include "tests/support/golden.h"

namespace receptor_grid_test {

using namespace tact;

TEST_CASE("receptor grid: a strong 150 Hz tone activates 61 Pacinian receptors on 11 x 11") {
    const Activation tone{150.91, 100.0, 9.4969};
    const ReceptorGrid grid = receptor_grid(tone, Receptor::pacinian, 1.0, FireSharing::total);
    CHECK(2 * grid.half_width + 1 == 11);
    CHECK(grid.activated == 61);
    CHECK(grid.receptors.size() == 61);
}

TEST_CASE("receptor grid: at least the centre is there, and it is silent when nothing drives it") {
    const ReceptorGrid grid = receptor_grid({}, Receptor::merkel, 1.0, FireSharing::total);
    REQUIRE(grid.receptors.size() == 1);
    CHECK(grid.half_width == 0);
    CHECK(grid.receptors[0].fires == 0.0);
}

TEST_CASE("receptor grid: sharing keeps the total N f0 T; own rates do not exceed it") {
    const Activation a{200.0, 90.0, 6.0};
    const double duration_s = 2.5;
    const auto sum_of = [&](FireSharing share) {
        const ReceptorGrid grid = receptor_grid(a, Receptor::meissner, duration_s, share);
        double sum = 0.0;
        for (const GridReceptor& receptor : grid.receptors) sum += receptor.fires;
        return std::pair{sum, static_cast<double>(grid.activated) * a.rate_hz * duration_s};
    };
    const auto [total, owed] = sum_of(FireSharing::total);
    CHECK(std::abs(total - owed) <= 1e-9 * owed);
    const auto [own, most] = sum_of(FireSharing::own);
    CHECK(own < most);
}

TEST_CASE("receptor grid: receptors out of reach are not listed but still counted") {
    const Activation a{200.0, 90.0, 8.0};
    const auto whole = receptor_grid(a, Receptor::meissner, 1.0, FireSharing::total);
    const auto near = receptor_grid(a, Receptor::meissner, 1.0, FireSharing::total, 2);
    CHECK(near.activated == whole.activated);
    CHECK(near.receptors.size() == 13);  // 1 + 4 + 8 places within two steps
    const auto centre_of = [](const ReceptorGrid& grid) {
        for (const GridReceptor& r : grid.receptors) {
            if (r.column == 0 && r.row == 0) return r.fires;
        }
        return -1.0;
    };
    CHECK(centre_of(near) == centre_of(whole));
}

TEST_CASE("receptor grid: a whole fingertip has as many receptors as its area and their density") {
    const Activation a{5000.0, 90.0, kFingertipMm};
    for (const Receptor receptor : kReceptors) {
        const ReceptorGrid grid = receptor_grid(a, receptor, 1.0, FireSharing::total);
        const double expected =
            std::numbers::pi * kFingertipMm * kFingertipMm * traits(receptor).density_per_mm2;
        CHECK(std::abs(static_cast<double>(grid.activated) - expected) <= 0.05 * expected);
        CHECK(grid.receptors.size() == grid.activated);
    }
}

}  // namespace receptor_grid_test
