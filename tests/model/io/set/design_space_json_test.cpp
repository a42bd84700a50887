#include "model/io/set/design_space_json.h"

#include <doctest/doctest.h>

#include "model/io/set/set_file.h"
#include "model/io/set/spec_file.h"
#include "tests/support/temporary_folder.h"

namespace design_space_json_test {

using namespace tact;

namespace {

std::string with_generator(const std::string& fields) {
    return R"({"tactspace": 1, "duration_s": 0.5, "patterns": [], "generator": )" + fields + "}";
}

PatternSet parsed(const std::string& text) {
    auto set = parse_set(text, "s.json", {});
    REQUIRE_MESSAGE(set, (set ? "" : set.error().message));
    return *std::move(set);
}

std::string fault(const std::string& fields) {
    const auto set = parse_set(with_generator(fields), "s.json", {});
    REQUIRE_FALSE(set);
    return set.error().message;
}

// Nothing has its default value.
DesignSpace unusual_space() {
    DesignSpace space;
    space.amplitude_g = std::vector<double>{0.1, 1.0 / 3.0};
    space.carriers = {{Span{60.0, 300.5, 7, true, 0.5}, fixed(1.0)},
                      {fixed(200.0), std::vector<double>{0.5, 0.25}}};
    space.mix = Span{0.1, 0.9, 4, false, 0.0};
    space.kinds = {ModulationKind::am, ModulationKind::product};
    space.modulation_hz = std::vector<double>{0.0, 4.0};
    space.depth = Span{0.0, 1.0, 2, false, 0.0};
    space.rhythms = {"", "x=x-"};
    space.unit_s = std::vector<double>{0.1, 0.2};
    space.attack_s = fixed(0.01);
    space.release_s = Span{0.0, 0.1, 3, false, 0.01};
    space.duration_s = std::vector<double>{0.25, 1.0};
    space.design = Design::latin_hypercube;
    space.samples = 77;
    space.seed = 123;
    space.constraints = {Range{40.0, 400.0}, 123.5, -3.0};
    return space;
}

}  // namespace

TEST_CASE("generator: everything it can hold survives a set file") {
    PatternSet set;
    set.duration_s = 0.5;
    for (const DesignSpace& space : {DesignSpace{}, unusual_space()}) {
        set.generator = space;
        CHECK(parsed(print_set(set)) == set);
    }
    set.generator.reset();
    CHECK(print_set(set).find("generator") == std::string::npos);
}

TEST_CASE("generator: missing keys take the defaults, the duration the set's") {
    DesignSpace expected;
    expected.duration_s = fixed(0.5);
    CHECK(parsed(with_generator("{}")).generator == expected);
    expected.constraints.displacement_um = 250.0;
    CHECK(parsed(with_generator(R"({"constraints": {"displacement_mm": 0.25}})")).generator ==
          expected);
}

TEST_CASE("generator: generated patterns are told from others in the file") {
    const PatternSet set = parsed(
        R"({"tactspace": 1, "patterns": [{"name": "a"}, {"name": "b", "generated": true}]})");
    CHECK_FALSE(set.vibrations[0].generated);
    CHECK(set.vibrations[1].generated);
    CHECK(parsed(print_set(set)) == set);
}

TEST_CASE("generator: keys of other versions are kept at every level") {
    const PatternSet set = parsed(with_generator(R"({"future": 1,
        "amplitude_g": {"from": 0, "to": 1, "curve": 2},
        "carriers": [{"colour": "red"}, {"frequency_hz": {"from": 60, "to": 90, "why": 3}}],
        "modulation": {"shape": 4}, "rhythm": {"swing": 5}, "constraints": {"noise": 6}})"));
    const std::string text = print_set(set);
    CHECK(parsed(text) == set);
    for (const char* part : {"\"future\": 1", "\"curve\": 2", "\"colour\": \"red\"", "\"why\": 3",
                             "\"shape\": 4", "\"swing\": 5", "\"noise\": 6"}) {
        CHECK_MESSAGE(contains(text, part), part);
    }
}

TEST_CASE("generator: what is wrong is told with its place") {
    const std::pair<const char*, const char*> cases[] = {
        {"[]", "/generator: expected an object, got an array of 0"},
        {R"({"design": "grid"})",
         R"(/generator/design: expected "factorial" or "latin-hypercube" or "sobol", got "grid")"},
        {R"({"samples": 0})", "/generator/samples: expected a whole number from 1 to 10000, got 0"},
        {R"({"amplitude_g": "loud"})",
         "/generator/amplitude_g: expected a number, an array of levels or a range with "
         "\"from\" and \"to\", got \"loud\""},
        {R"({"amplitude_g": []})", "/generator/amplitude_g: expected an array of 1 to 1000"},
        {R"({"amplitude_g": [1, 60]})",
         "/generator/amplitude_g/1: expected a number from 0 to 50, got 60"},
        {R"({"amplitude_g": {"to": 2}})",
         "/generator/amplitude_g: expected a range with \"from\" and \"to\", got an object"},
        {R"({"amplitude_g": {"from": 3, "to": 2}})",
         "/generator/amplitude_g/to: expected a number not below \"from\", got 2"},
        {R"({"amplitude_g": {"from": 0, "to": 2, "spacing": "log"}})",
         "/generator/amplitude_g/from: expected a number above 0 for the spacing \"log\""},
        {R"({"amplitude_g": {"to": 2, "spacing": "log"}})", "/generator/amplitude_g: expected"},
        {R"({"carriers": [{"frequency_hz": [0]}]})",
         "/generator/carriers/0/frequency_hz/0: expected a number from 0.1 to 1000, got 0"},
        {R"({"mix": 0.5})", "/generator/mix: expected two carriers to mix, got 0.5"},
        {R"({"modulation": {"kinds": ["fm"]}})",
         R"(/generator/modulation/kinds/0: expected "product" or "am", got "fm")"},
        {R"({"rhythm": {"texts": ["x", "=x"]}})",
         "/generator/rhythm/texts/1: expected a rhythm (step 1 is =, which must follow x or =)"},
        {R"({"constraints": {"band_hz": [400, 40]}})",
         "/generator/constraints/band_hz/1: expected a number not below the first, got 40"},
        {R"({"constraints": {"displacement_um": 1, "displacement_mm": 1}})",
         "/generator/constraints/displacement_mm: expected one limit"}};
    for (const auto& [fields, words] : cases) {
        CHECK_MESSAGE(contains(fault(fields), words), fault(fields));
    }
}

TEST_CASE("spec file: a generator alone is a set without patterns") {
    const TemporaryFolder folder;
    const auto alone = read_spec_file(
        folder.write("icons.json", R"({"amplitude_g": [1, 2], "duration_s": 0.5, "amp": 3})"));
    REQUIRE(alone);
    CHECK(alone->set.name == "icons");
    CHECK(alone->set.duration_s == 0.5);
    CHECK(alone->set.vibrations.empty());
    REQUIRE(alone->set.generator);
    CHECK(alone->set.generator->amplitude_g == Values(std::vector<double>{1.0, 2.0}));
    REQUIRE(alone->remarks.size() == 1);
    CHECK(contains(alone->remarks[0], "/amp means nothing to a generator"));

    const auto none = read_spec_file(folder.write("set.json", R"({"patterns": []})"));
    REQUIRE_FALSE(none);
    CHECK(contains(none.error().message, "has no \"generator\""));
    CHECK_FALSE(read_spec_file(folder.path / "missing.json"));
    CHECK_FALSE(read_spec_file(folder.write("list.json", "[1]")));
}

}  // namespace design_space_json_test
