#include "model/physiology/mechanoreceptor.h"

#include "assets/assets.h"
#include "model/physiology/log_curve.h"
#include "tests/support/golden.h"

namespace mechanoreceptor_test {

using namespace tact;
using golden::Json;

TEST_CASE("mechanoreceptor: tables equal the independent program's, at and between knots") {
    const Json receptors = golden::read("tables.json").at("receptors");
    for (const Receptor receptor : kReceptors) {
        const Json& points = receptors.at(traits(receptor).afferent);
        REQUIRE(points.size() > 10);
        for (const Json& point : points) {
            const double f_hz = point.at("f_hz");
            CAPTURE(f_hz);
            const std::size_t c = index_of(receptor);
            CHECK(std::abs(at(default_tables().slope[c], f_hz) - double(point.at("slope"))) <=
                  1e-9);
            CHECK(std::abs(at(default_tables().threshold[c], f_hz) -
                           double(point.at("threshold_log10_um"))) <= 1e-9);
        }
    }
}

TEST_CASE("mechanoreceptor: grid intervals are those of the paper, to its digits") {
    CHECK(std::abs(grid_interval_mm(Receptor::meissner) - 0.845) <= 5e-4);
    CHECK(std::abs(grid_interval_mm(Receptor::pacinian) - 2.236) <= 5e-4);
    CHECK(std::abs(grid_interval_mm(Receptor::merkel) - 1.195) <= 5e-4);
    CHECK(std::abs(grid_interval_mm(Receptor::ruffini) - 3.162) <= 5e-4);
}

TEST_CASE("mechanoreceptor: a curve is constant beyond its outermost knots") {
    const Curve curve{{10.0, 100.0}, {1.0, 3.0}};
    CHECK(at(curve, 1.0) == 1.0);
    CHECK(at(curve, 1000.0) == 3.0);
    CHECK(std::abs(at(curve, std::sqrt(1000.0)) - 2.0) <= 1e-12);
}

TEST_CASE(
    "mechanoreceptor: the second thresholds are ours, moved together onto what its source feels") {
    const auto& own = default_tables().threshold;
    const auto& moved = aosp_thresholds();
    REQUIRE(moved[0].frequency_hz.size() == 42);
    double sum = 0.0;
    for (const double f_hz : moved[0].frequency_hz) {
        CAPTURE(f_hz);
        const double by = at(moved[0], f_hz) - at(own[0], f_hz);
        for (const Receptor receptor : kReceptors) {
            const std::size_t c = index_of(receptor);
            CHECK(std::abs(at(moved[c], f_hz) - at(own[c], f_hz) - by) <= 1.01e-4);  // four digits
        }
        if (f_hz <= 400.0) sum += by * by;
    }
    CHECK(std::abs(20.0 * std::sqrt(sum / 41.0) - 1.97) <= 0.005);
    // 31.9 dB below 1 g at 100 Hz.
    const double least = std::min(
        {at(moved[0], 100.0), at(moved[1], 100.0), at(moved[2], 100.0), at(moved[3], 100.0)});
    const double um = 1e6 * 9.80665 * std::pow(10.0, -31.9 / 20.0) /
                      std::pow(2.0 * 3.14159265358979 * 100.0, 2.0);
    CHECK(std::abs(least - std::log10(um)) <= 1e-4);
}

TEST_CASE("mechanoreceptor: a damaged table is refused with its line") {
    const std::string slopes(asset("physiology/firing_rate_slopes.csv"));
    const std::string thresholds(asset("physiology/absolute_thresholds.csv"));
    REQUIRE(parse_tables(slopes, thresholds));

    const auto refusal = [&](const std::string& csv) {
        const auto answer = parse_tables(csv, thresholds);
        REQUIRE_FALSE(answer);
        return answer.error().message;
    };
    const std::string head = "receptor,frequency_hz,slope_imp_per_s_per_log10um\n";
    CHECK(refusal("receptor,frequency_hz\n") ==
          "slope table, line 1: expected a column slope_imp_per_s_per_log10um");
    CHECK(refusal(head + "FA1,10,abc\n") ==
          "slope table, line 2: expected a number as slope_imp_per_s_per_log10um");
    CHECK(refusal(head + "FA1,10,nan\n").find("line 2") != std::string::npos);
    CHECK(refusal(head + "FA1,10,1\nFA1,5,1\n") ==
          "slope table, line 3: expected frequencies that ascend");
    CHECK(refusal(head + "FA9,10,1\n").find("FA1, FA2, SA1, SA2") != std::string::npos);
    CHECK(refusal(head + "FA1,10,1\n") == "slope table: expected at least one line for FA2");
}

TEST_CASE("mechanoreceptor: each table is read by itself, and equals its half of both") {
    const auto slopes = parse_slopes(std::string(asset("physiology/firing_rate_slopes.csv")));
    const auto thresholds =
        parse_thresholds(std::string(asset("physiology/absolute_thresholds.csv")));
    REQUIRE(slopes);
    REQUIRE(thresholds);
    CHECK(*slopes == default_tables().slope);
    CHECK(*thresholds == default_tables().threshold);
    CHECK_FALSE(parse_slopes(std::string(asset("physiology/absolute_thresholds.csv"))));
    CHECK_FALSE(parse_thresholds(std::string(asset("physiology/firing_rate_slopes.csv"))));
}

TEST_CASE("mechanoreceptor: a table in other units is refused, and dB are called so") {
    const std::string slopes = "receptor,frequency_hz,slope_imp_per_s_per_log10um\n";
    const std::string thresholds = "receptor,frequency_hz,threshold_log10_um_peak\n";
    const auto said = [](const auto& answer) {
        REQUIRE_FALSE(answer);
        return answer.error().message;
    };
    CHECK(said(parse_thresholds(thresholds + "FA2,250,-20\n")) ==
          "threshold table, line 2: expected log10 of um peak from -4 to 6 (beyond them it looks "
          "like dB, which are 20 times that), got -20");
    CHECK(said(parse_thresholds(thresholds + "FA1,10,30\n")).find("dB") != std::string::npos);
    CHECK(said(parse_slopes(slopes + "FA1,10,1e308\n")) ==
          "slope table, line 2: expected impulses/s per log10 um from 0 to 10000, got 1e308");
    CHECK(said(parse_slopes(slopes + "FA1,10,-0.5\n")).find("from 0") != std::string::npos);
    for (const char* end : {"-4", "6"}) {
        const std::string both_ends = thresholds + "FA1,10," + end + "\nFA2,10," + end +
                                      "\nSA1,10," + end + "\nSA2,10," + end + "\n";
        CHECK(parse_thresholds(both_ends));
    }
}

TEST_CASE("mechanoreceptor: logarithms taken before change no bit of a curve") {
    const Curve two{{10.0, 100.0}, {1.0, 3.0}};
    for (const Curve& curve : {default_tables().slope[0], default_tables().threshold[1], two}) {
        const LogCurve prepared = log_curve(curve);
        for (double f_hz = 0.5; f_hz < 600.0; f_hz *= 1.013) {
            CHECK(at(prepared, log_frequency(f_hz)) == at(curve, f_hz));
        }
        for (const double knot_hz : curve.frequency_hz) {
            CHECK(at(prepared, log_frequency(knot_hz)) == at(curve, knot_hz));
        }
    }
}

}  // namespace mechanoreceptor_test
