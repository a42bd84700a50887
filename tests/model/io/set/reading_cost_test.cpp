// What files that refer to themselves, and large ones, cost to read.
#include <doctest/doctest.h>

#include <ctime>
#include <functional>
#include <string>

#include "model/io/formats/read_effects.h"
#include "model/io/people/ratings_file.h"
#include "model/io/people/study_file.h"
#include "model/io/set/set_file.h"
#include "model/text/names.h"

namespace reading_cost_test {

using namespace tact;

namespace {

std::string list(std::size_t count, const std::function<std::string(std::size_t)>& one) {
    std::string text = "[";
    for (std::size_t k = 0; k < count; ++k) text += (k == 0 ? "" : ",") + one(k);
    return text + "]";
}

std::string text_of(std::size_t number) { return std::to_string(number); }

// Channels of references, each to one effect of many keyframes.
std::string hjif(std::size_t keys, std::size_t references, std::size_t channels = 1,
                 const std::string& band = "VectorialWave") {
    const std::string frames = list(keys, [](std::size_t k) {
        return R"({"relative_position":)" + text_of(k) +
               R"(,"amplitude_modulation":0.5,"frequency_modulation":100})";
    });
    const std::string calls = list(references, [](std::size_t k) {
        return R"({"effect_type":"Reference","id":1,"position":)" + text_of(20 * k) + "}";
    });
    const std::string all = list(channels, [&](std::size_t) {
        return R"({"bands":[{"band_type":")" + band + R"(","effects":)" + calls + "}]}";
    });
    return R"({"version":"2023","timescale":1000,"perceptions":[{"effect_library":[{"id":1,"keyframes":)" +
           frames + R"(}],"channels":)" + all + "}]}";
}

// Events that lie under one control of many points: all of it, or the part of each.
std::string ahap(std::size_t events, std::size_t points, bool at_once) {
    const std::string over = list(points, [](std::size_t k) {
        return R"({"Time":)" + text_of(k) + R"(,"ParameterValue":0.)" + text_of(1 + k % 9) + "}";
    });
    std::string all = R"([{"ParameterCurve":{"ParameterID":"HapticIntensityControl","Time":0,)"
                      R"("ParameterCurveControlPoints":)" +
                      over + "}}";
    for (std::size_t k = 0; k < events; ++k) {
        all += R"(,{"Event":{"EventType":"HapticContinuous","Time":)" + text_of(at_once ? 0 : k) +
               R"(,"EventDuration":)" + (at_once ? text_of(points) : "0.5") + "}}";
    }
    return R"({"Version":1,"Pattern":)" + all + "]}";
}

// Each event has a parameter that nobody else has.
std::string ahap_of_many_parameters(std::size_t events) {
    return R"({"Pattern":)" +
           list(events,
                [](std::size_t k) {
                    return R"({"Event":{"EventType":"HapticTransient","Time":)" + text_of(k % 50) +
                           R"(,"EventParameters":[{"ParameterID":"own )" + text_of(k) +
                           R"(","ParameterValue":1}]}})";
                }) +
           "}";
}

std::string set_of(std::size_t patterns) {
    return R"({"tactspace":1,"patterns":)" +
           list(patterns,
                [](std::size_t k) {
                    return R"({"name":"p)" + text_of(k) + R"(","rhythm":{"text":"x--x"}})";
                }) +
           "}";
}

std::string ratings(std::size_t labels, std::size_t people, std::size_t passes) {
    std::string text = "participant,a,b,rating\n";
    for (std::size_t k = 1; k < labels; ++k) text += "p0,l0,l" + text_of(k) + ",1\n";
    for (std::size_t p = 0; p < people; ++p) {
        for (std::size_t n = 0; n < passes; ++n) text += "p" + text_of(p) + ",l1,l2,3\n";
    }
    return text;
}

// `trial`: of all of them; empty: numbered.
std::string study(std::size_t answers, const std::string& trial = "") {
    std::string text =
        R"({"tactspace_study":1,"kind":"pairwise","participant":{"code":"S01"},"patterns":["a","b","c"]})"
        "\n";
    for (std::size_t k = 0; k < answers; ++k) {
        const std::string number = trial.empty() ? std::to_string(k + 1) : trial;
        text += R"({"trial":)" + number + R"(,"left":"c","right":")" + (k % 2 == 0 ? "a" : "b") +
                R"(","rating":1})"
                "\n";
    }
    return text;
}

std::string fault_of(const std::string& text, Budget& budget) {
    const auto read = read_effects(text, "bomb", {}, budget);
    return read ? "" : read.error().message;
}

std::string fault_of(const std::string& text) {
    Budget budget;
    return fault_of(text, budget);
}

Expected<LoadedRatings> rated(const std::string& text) {
    return parse_ratings(text, "r.csv", RatingScale::dissimilarity, {});
}

double cpu_s(const std::function<void()>& work) {
    const std::clock_t begin = std::clock();
    work();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != text.npos;
}

}  // namespace

TEST_CASE("reading: references of HJIF are paid before they are followed") {
    const std::size_t all = Budget{}.points;
    Budget budget;
    // A hundred times what an effect may have; the first that is too many ends it.
    CHECK(contains(fault_of(hjif(1000, 10'000), budget), "100,000 points in an effect, got more"));
    CHECK(all - budget.points <= 100'000);
    CHECK(contains(fault_of(hjif(1000, 10'000, 1, "Transient")), "points in an effect, got more"));
    CHECK(contains(fault_of(hjif(1000, 10'000, 1, "Curve")), "points in an effect, got more"));
}

TEST_CASE("reading: many small effects of one file are paid from one budget") {
    // 40 channels of 40 x 500 points: each is an effect that may be.
    CHECK(fault_of(hjif(500, 40)).empty());
    CHECK(contains(fault_of(hjif(500, 40, 40)), "make too many of those that are written"));
    CHECK(fault_of(hjif(2, 40, 40)).empty());
}

TEST_CASE("reading: ordinary references go on as they did") {
    const auto once = read_effects(hjif(20, 1), "one.hjif");
    const auto twice = read_effects(hjif(20, 2), "two.hjif");
    REQUIRE(once);
    REQUIRE(twice);
    CHECK(once->effects.front().pattern.duration_s == doctest::Approx(0.019));
    CHECK(twice->effects.front().pattern.duration_s == doctest::Approx(0.039));
}

TEST_CASE("reading: each event of AHAP has its part of a control, and no more") {
    CHECK(contains(fault_of(ahap(1000, 1000, true)), "points in an effect, got more"));
    CHECK(fault_of(ahap(1000, 1000, false)).empty());
    // Many events under many points, one after the other: 4 x 10^6 if each had them all.
    CHECK(fault_of(ahap(2000, 2000, false)).empty());
}

TEST_CASE("reading: of many remarks a hundred are kept") {
    const auto read = read_effects(ahap_of_many_parameters(5000), "many.ahap");
    REQUIRE(read);
    CHECK(read->effects.front().remarks.size() <= 105);
}

TEST_CASE("reading: a stop ends it with a sentence and nothing is made") {
    std::stop_source source;
    source.request_stop();
    Budget budget;
    budget.stop = source.get_token();
    CHECK(contains(fault_of(hjif(20, 2), budget), "reading was cancelled"));
    budget = {};
    budget.until = Budget::Clock::now() - std::chrono::seconds(1);
    CHECK(contains(fault_of(hjif(20, 2), budget), "expected a file that reads faster"));
}

TEST_CASE("reading: passes through pairs that nobody rated are paid before they are made") {
    // 500 labels: each of 1,000 passes would have 124,750 places, a gigabyte of 20 kB.
    const auto read = rated(ratings(500, 100, 10));
    REQUIRE_FALSE(read);
    CHECK(contains(read.error().message, "passes through 124,750 pairs, got 1,000"));
    CHECK(rated(ratings(100, 100, 10)));
}

TEST_CASE("reading: a participant's file has as many answers to a pair as the table has") {
    CHECK(parse_study(study(200), "s.jsonl"));
    const auto often = parse_study(study(202), "s.jsonl");
    REQUIRE_FALSE(often);
    CHECK(often.error().message ==
          "s.jsonl:202: expected at most 100 ratings of a pair by a participant");
    const auto far = parse_study(study(1, "99999999"), "s.jsonl");
    REQUIRE_FALSE(far);
    CHECK(contains(far.error().message, "s.jsonl:2: /trial: expected a whole number from 1 to"));
}

TEST_CASE("reading: a name has a thousand bytes, at every door") {
    const std::string good(kMaxNameBytes, 'n');
    const std::string bad(kMaxNameBytes + 1, 'n');
    const auto set = [](const std::string& name) {
        return parse_set(R"({"tactspace":1,"patterns":[{"name":")" + name + "\"}]}", "s", {});
    };
    CHECK(set(good));
    REQUIRE_FALSE(set(bad));
    CHECK(set(bad).error().message ==
          "s: /patterns/0/name: expected a text of at most 1,000 bytes, got 1,001");
    const auto table = [](const std::string& who, const std::string& name) {
        return rated("participant,a,b,rating\n" + who + "," + name + ",y,1\n");
    };
    CHECK(table(good, good));
    CHECK_FALSE(table(bad, good));
    CHECK_FALSE(table(good, bad));
    const std::string note(20'001, 'n');
    CHECK_FALSE(
        parse_set(R"({"tactspace":1,"patterns":[{"name":"a","note":")" + note + "\"}]}", "s", {}));
    // A number behind a name that is full keeps to it.
    PatternSet twice;
    twice.vibrations.emplace_back().name = good;
    CHECK(unused_name(twice, good).size() <= kMaxNameBytes);
    UnusedNames names;
    CHECK(names.unused(good) == good);
    CHECK(names.unused(good).size() == kMaxNameBytes);
}

// Four times the text may take four times the time, and three times that on a busy machine; what is
// too short to be measured is let go.
void check_linear(const std::string& door, const std::function<void(std::size_t)>& read,
                  std::size_t size) {
    const double small_s = cpu_s([&] { read(size); });
    const double large_s = cpu_s([&] { read(4 * size); });
    INFO(door << ": " << small_s << " s, four times as large: " << large_s << " s");
    CHECK(large_s <= 12.0 * small_s + 0.25);
}

TEST_CASE("reading: time follows the bytes of large files, whatever they refer to" *
          doctest::test_suite("long")) {
    const auto effects = [](const std::string& text) { (void)fault_of(text); };
    check_linear(
        "hjif", [&](std::size_t n) { effects(hjif(n, n)); }, 20'000);
    check_linear(
        "hjif channels", [&](std::size_t n) { effects(hjif(10, 10, n)); }, 5'000);
    check_linear(
        "ahap, at once", [&](std::size_t n) { effects(ahap(n, n, true)); }, 10'000);
    check_linear(
        "ahap, in turns", [&](std::size_t n) { effects(ahap(n, n, false)); }, 10'000);
    check_linear(
        "ahap remarks", [&](std::size_t n) { effects(ahap_of_many_parameters(n)); }, 100'000);
    check_linear(
        "set", [](std::size_t n) { (void)parse_set(set_of(n), "s", {}); }, 2'500);
    check_linear(
        "ratings", [](std::size_t n) { (void)rated(ratings(500, n, 100)); }, 250);
    check_linear(
        "study", [](std::size_t n) { (void)parse_study(study(n), "s"); }, 25'000);
}

}  // namespace reading_cost_test
