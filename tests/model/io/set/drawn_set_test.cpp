#include <doctest/doctest.h>

#include <filesystem>

#include "model/io/set/set_file.h"
#include "model/pattern/same_vibration.h"
#include "tests/support/set_texts.h"
#include "tests/support/temporary_folder.h"

namespace drawn_set_test {

using namespace tact;

namespace {

std::string refusal_of(const std::string& fields) {
    const auto set = parse_set(with_pattern(fields), "s.json", {});
    return set ? "" : set.error().message;
}

Pattern drawn() {
    Pattern pattern;
    pattern.duration_s = 0.7;
    pattern.amplitude_curve = {{0.0, 1.0 / 3.0}, {0.1, 1.0}, {0.1, 0.25}, {0.7, 0.0}};
    pattern.frequency_curve = {{1e-300, 1000.0 / 7.0}, {0.69999999999999996, 0.1}};
    pattern.transients = {{0.65, 1.0 / 9.0, 77.7, 0.25, TransientShape::square},
                          {0.1, 50.0, 300.0, 0.001, TransientShape::sine}};
    return pattern;
}

PatternSet set_with(const Pattern& pattern) {
    PatternSet set;
    set.vibrations.push_back({"drawn", pattern, false, "", "", {}});
    return set;
}

}  // namespace

TEST_CASE("drawn sets: curves and transients survive, to the last bit") {
    const PatternSet set = set_with(drawn());
    const auto again = parse_set(print_set(set), "s.json", {});
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(*again == set);
}

TEST_CASE("drawn sets: what is not drawn is not written, and the format is the old one") {
    const std::string text = print_set(set_with(Pattern{}));
    CHECK(text.find("curve") == text.npos);
    CHECK(text.find("transients") == text.npos);
    CHECK(print_set(set_with(drawn())).find("\"tactspace\": 1") != text.npos);
}

TEST_CASE("drawn sets: kinds of notes, beats and bars survive, to the last bit") {
    Pattern pattern;
    pattern.rhythm = {
        "A=B-x5--", 0.1, {{'A', {1.0 / 3.0, 1.25}}, {'B', {1.0, 0.7}}, {'Q', {}}}, {3, 4}};
    const PatternSet set = set_with(pattern);
    const auto again = parse_set(print_set(set), "s.json", {});
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(*again == set);
    CHECK(print_set(*again) == print_set(set));
    // Neither is written where it says nothing.
    pattern.rhythm = {"x-x-", 0.1};
    const std::string plain = print_set(set_with(pattern));
    for (const char* key : {"notes", "steps_a_beat", "beats_a_bar", "bpm"}) {
        CHECK(plain.find("\"" + std::string(key) + "\"") == plain.npos);
    }
}

TEST_CASE("drawn sets: a tempo stands for the length of a step") {
    const auto unit_s = [](const std::string& rhythm) {
        const auto set = parse_set(with_pattern(", \"rhythm\": " + rhythm), "s.json", {});
        REQUIRE_MESSAGE(set, (set ? "" : set.error().message));
        return std::get<Pattern>(set->vibrations[0].source).rhythm.unit_s;
    };
    CHECK(unit_s(R"({"text": "x-", "bpm": 120})") == 0.125);
    CHECK(unit_s(R"({"text": "x-", "bpm": 120, "steps_a_beat": 3})") == doctest::Approx(1.0 / 6.0));
    CHECK(unit_s(R"({"text": "x-", "bpm": 120, "unit_s": 0.125})") == 0.125);
    CHECK(refusal_of(R"(, "rhythm": {"text": "x-", "bpm": 100, "unit_s": 0.125})")
              .find("/rhythm/bpm: expected either unit_s or bpm, or the 120 that unit_s makes, got "
                    "100") != std::string::npos);
    CHECK(refusal_of(R"(, "rhythm": {"text": "x-", "bpm": 0})")
              .find("/rhythm/bpm: expected a number "
                    "from 1.5 to 15000, got 0") != std::string::npos);
    CHECK(refusal_of(R"(, "rhythm": {"text": "A", "notes": {"A": {"velocity": 2}}})")
              .find("/rhythm/notes/A/velocity: expected a number from 0 to 1, got 2") !=
          std::string::npos);
    CHECK(refusal_of(R"(, "rhythm": {"text": "A", "notes": {"A": {"pitch": 0}}})")
              .find("/rhythm/notes/A/pitch: expected a number from 0.1 to 10, got 0") !=
          std::string::npos);
}

TEST_CASE("drawn sets: what is refused is told with its place") {
    CHECK(refusal_of(R"(, "amplitude_curve": [{"time_s": 0, "value": 1.5}])") ==
          "s.json: /patterns/0/amplitude_curve/0/value: expected a number from 0 to 1, got 1.5");
    CHECK(refusal_of(R"(, "amplitude_curve": [{"time_s": 1.5, "value": 1}])") ==
          "s.json: /patterns/0/amplitude_curve/0/time_s: expected a time within the pattern, "
          "0 to 1 s, got 1.5");
    CHECK(refusal_of(R"(, "frequency_curve": [{"time_s": 0.5, "frequency_hz": 9},
                         {"time_s": 0.25, "frequency_hz": 9}])")
              .starts_with("s.json: /patterns/0/frequency_curve/1/time_s: expected a time not "
                           "before the last point's 0.5 s"));
    CHECK(refusal_of(R"(, "frequency_curve": [{"time_s": 0.5}])") ==
          "s.json: /patterns/0/frequency_curve/0/frequency_hz: expected a number, it is missing");
    CHECK(refusal_of(R"(, "transients": [{"time_s": 0.5}, {}])") ==
          "s.json: /patterns/0/transients/1/time_s: expected a number, it is missing");
    CHECK(refusal_of(R"(, "transients": [{"time_s": 0.5, "shape": "saw"}])")
              .starts_with("s.json: /patterns/0/transients/0/shape: "));
    CHECK(refusal_of(R"(, "transients": [{"time_s": 0.5, "duration_s": 2}])")
              .starts_with("s.json: /patterns/0/transients/0/duration_s: "));
    std::string many = R"({"time_s": 0.5, "value": 1})";
    for (std::size_t k = 0; k < limits::kMaxCurvePoints; ++k)
        many += R"(, {"time_s": 0.5, "value": 1})";
    CHECK(refusal_of(R"(, "amplitude_curve": [)" + many + "]")
              .starts_with("s.json: /patterns/0/amplitude_curve: "));
}

TEST_CASE("drawn sets: what is unknown of a point stays with it, and goes with its curve") {
    const std::string text =
        with_pattern(R"(, "amplitude_curve": [{"time_s": 0.5, "value": 1, "tension": 3}])");
    auto set = parse_set(text, "s.json", {});
    REQUIRE(set);
    CHECK(print_set(*set).find("tension") != std::string::npos);
    std::get<Pattern>(set->vibrations[0].source).amplitude_curve.clear();
    const std::string cleared = print_set(*set);
    CHECK(cleared.find("amplitude_curve") == std::string::npos);
    CHECK(parse_set(cleared, "s.json", {}));
}

TEST_CASE("drawn sets: transients over a vibration are joined, which an older set says once") {
    const auto remarks = [](const std::string& fields) {
        TemporaryFolder folder;
        const std::filesystem::path file = folder.write("s.tactspace.json", with_pattern(fields));
        auto loaded = read_set_file(file);
        REQUIRE(loaded);
        const std::vector<std::string> told = loaded->remarks;
        REQUIRE(write_set_file(file, loaded->set));
        const auto again = read_set_file(file);
        REQUIRE(again);
        CHECK(again->set == loaded->set);
        CHECK(again->remarks.empty());  // it is said until the set is saved
        return told;
    };
    const std::string over = R"(, "transients": [{"time_s": 0.5}])";
    REQUIRE(remarks(over).size() == 1);
    CHECK(remarks(over)[0].find("1 pattern has transients over a vibration; they are joined") !=
          std::string::npos);
    CHECK(remarks(over + R"(, "accents": "added")").empty());
    CHECK(remarks(over + R"(, "amplitude_g": 0)").empty());
    CHECK(remarks(over + R"(, "rhythm": {"text": "x-", "unit_s": 0.5})").empty());
    CHECK(set_fault(with_pattern(over + R"(, "accents": "on top")"))
              .starts_with("s.json: /patterns/0/accents: expected \"joined\" or \"added\""));
}

TEST_CASE("drawn sets: added transients are the samples of both, in any phase") {
    Pattern pattern;
    pattern.duration_s = 0.3;
    pattern.carriers = {{100.0, 1.0, 0.0}};
    pattern.transients = {{0.1034, 0.7, 210.0, 0.02}};
    pattern.accents = Accents::added;
    Pattern ticks = pattern;
    ticks.amplitude_g = 0.0;
    Pattern bed = pattern;
    bed.transients.clear();
    const std::vector<double> sum = render(pattern).samples_g;
    const std::vector<double> under = render(bed).samples_g;
    const std::vector<double> over = render(ticks).samples_g;
    for (std::size_t n = 0; n < sum.size(); ++n) REQUIRE(sum[n] == under[n] + over[n]);
    Pattern joined = pattern;
    joined.accents = Accents::joined;
    CHECK(render(joined).samples_g != sum);
    CHECK(essence(joined) != essence(pattern));
    CHECK(std::get<Pattern>(
              parse_set(print_set(set_with(pattern)), "s.json", {})->vibrations[0].source) ==
          pattern);
}

TEST_CASE(
    "drawn sets: a pitch makes another fingerprint, bars and a letter without a note do not") {
    Pattern pattern;
    pattern.rhythm = {"A=x-", 0.1, {{'A', {0.5, 1.5}}}};
    const std::uint64_t own = vibrations_fingerprint(set_with(pattern));
    Pattern counted = pattern;
    counted.rhythm.meter = {3, 4};
    counted.rhythm.kinds['Q'] = {0.2, 2.0};
    CHECK(vibrations_fingerprint(set_with(counted)) == own);
    Pattern higher = pattern;
    higher.rhythm.kinds['A'].pitch = 1.6;
    CHECK(vibrations_fingerprint(set_with(higher)) != own);
    Pattern weaker = pattern;
    weaker.rhythm.kinds['A'].velocity = 0.4;
    CHECK(vibrations_fingerprint(set_with(weaker)) != own);
}

TEST_CASE("drawn sets: each number of what is drawn makes another fingerprint") {
    const std::uint64_t plain = vibrations_fingerprint(set_with(Pattern{}));
    const std::uint64_t number = vibrations_fingerprint(set_with(drawn()));
    CHECK(number != plain);
    const auto differs = [&](auto change) {
        Pattern pattern = drawn();
        change(pattern);
        return vibrations_fingerprint(set_with(pattern)) != number && pattern != drawn();
    };
    CHECK(differs([](Pattern& p) { p.amplitude_curve[1].value = 0.5; }));
    CHECK(differs([](Pattern& p) { p.amplitude_curve[3].time_s = 0.6; }));
    CHECK(differs([](Pattern& p) { p.frequency_curve[1].frequency_hz = 0.2; }));
    CHECK(differs([](Pattern& p) { p.frequency_curve[1].time_s = 0.6; }));
    CHECK(differs([](Pattern& p) { p.transients[0].shape = TransientShape::sine; }));
    CHECK(differs([](Pattern& p) { p.transients[0].duration_s = 0.1; }));
    CHECK(differs([](Pattern& p) { p.transients.pop_back(); }));
}

}  // namespace drawn_set_test
