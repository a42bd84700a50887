#include "model/io/set/set_file.h"

#include <doctest/doctest.h>

#include "model/io/set/load.h"
#include "tests/support/misspelt_keys.h"
#include "tests/support/set_texts.h"
#include "tests/support/temporary_folder.h"

namespace set_file_test {

using namespace tact;
namespace fs = std::filesystem;

namespace {

PatternSet parsed(const std::string& text) {
    auto set = parse_set(text, "s.json", {});
    REQUIRE_MESSAGE(set, (set ? "" : set.error().message));
    return *std::move(set);
}

// A document with these fields.
std::string with_set(const std::string& fields) {
    return R"({"tactspace": 1, "patterns": [])" + fields + "}";
}

Pattern pattern_in(const std::string& fields) {
    return std::get<Pattern>(parsed(with_pattern(fields)).vibrations.at(0).source);
}

// A set in which nothing has its default value.
PatternSet unusual_set() {
    PatternSet set;
    set.name = "\u9707\u52a8 \"quoted\" \\ \n \u0001";
    set.duration_s = 0.75;
    Pattern pattern;
    pattern.amplitude_g = 1.0 / 3.0;
    pattern.carriers = {{70.0, 0.5, 0.25}, {210.5, -0.5, -1e-9}};
    pattern.modulation = {ModulationKind::am, 4.125, 0.625};
    pattern.rhythm = {"x=--x-", 0.0625};
    pattern.attack_s = 0.01;
    pattern.release_s = 0.02;
    pattern.duration_s = 60.0;
    set.vibrations.push_back({"one two", pattern, true, "#0072B2", "a note", {}});
    set.vibrations.push_back({"\u0436\u0443\u0436", Pattern{}, false, "", "", {}});
    set.ratings.push_back(
        {"20 people", {"one two", "\u0436\u0443\u0436", "gone"}, {0.1, -2.0, 1e-300}, {}});
    set.model.coding.excitatory_layers = 2;
    set.model.nc_weight = 0.1;
    set.study = {{"one two"}, 3,       2,      7,     StudyOrder::adaptive,
                 0.5,         1.5,     20,     0.25,  "audio/ALSA/ears",
                 {75.0, 1},   "Feel.", "Yes.", {0, 3}};
    set.told_apart.push_back({"phone \u9707",
                              "Kim",
                              "2026-11-28T21:12:53Z",
                              0xfedcba9876543210U,
                              true,
                              {{{"one two", "gone", 1.0 / 3.0, 2, true}, 1, 5.25}},
                              {"one two", "gone"},
                              {"0123456789abcdef", ""}});
    return set;
}

}  // namespace

TEST_CASE("set file: everything a set can hold survives, to the last bit") {
    const PatternSet set = unusual_set();
    CHECK(parsed(print_set(set)) == set);
    CHECK(parsed(print_set({})) == PatternSet{});
}

TEST_CASE("set file: missing keys take the defaults, a pattern's duration the set's") {
    CHECK(pattern_in("") == Pattern{});
    CHECK(parsed(R"({"patterns": []})") == PatternSet{});
    CHECK(parsed(R"({"tactspace": 1})") == PatternSet{});
    const PatternSet set = parsed(R"({"tactspace": 1, "duration_s": 2, "patterns": [{"name": "a"},
        {"name": "b", "duration_s": 0.5}]})");
    CHECK(std::get<Pattern>(set.vibrations[0].source).duration_s == 2.0);
    CHECK(std::get<Pattern>(set.vibrations[1].source).duration_s == 0.5);
    const Pattern carrier =
        pattern_in(R"(, "carriers": [{"weight": 2}], "modulation": {"frequency_hz": 4})");
    CHECK(carrier.carriers == std::vector<Carrier>{{150.0, 2.0, 0.0}});
    CHECK(carrier.modulation == Modulation{ModulationKind::product, 4.0, 1.0});
}

TEST_CASE("set file: a saved set is short: defaults are left out") {
    PatternSet set;
    set.name = "n";
    set.vibrations.push_back({"a", Pattern{}, false, "", "", {}});
    CHECK(print_set(set) == R"({
  "tactspace": 1,
  "name": "n",
  "duration_s": 1.0,
  "patterns": [
    {
      "name": "a",
      "amplitude_g": 1.0,
      "carriers": [
        {
          "frequency_hz": 150.0,
          "weight": 1.0
        }
      ]
    }
  ]
}
)");
}

TEST_CASE("set file: a misspelt key is refused, in the model and the study's design, too") {
    const auto fault_of = [](const std::string& text) {
        const auto set = parse_set(text, "s.json", {});
        return set ? std::string() : set.error().message;
    };
    check_misspelt_keys_refused(print_set(unusual_set()), fault_of, {"/map_places"});
    CHECK(fault_of(with_set(R"(, "model": {"nc_wieght": 2})")) ==
          "s.json: /model: does not know \"nc_wieght\"; the nearest key is \"nc_weight\"");
}

TEST_CASE("set file: keys of other versions are kept at every level") {
    const PatternSet set = parsed(R"({"tactspace": 1, "future": [1, null, {"deep": true}],
        "patterns": [{"name": "a", "new": 1,
            "carriers": [{"frequency_hz": 70}, {"frequency_hz": 80, "colour": "red"}],
            "modulation": {"shape": "square"}, "rhythm": {"text": "x-", "swing": 0.1}}],
        "ratings": [{"name": "r", "labels": [], "condensed": [], "who": "us"}],
        "model": {"taste": 1, "coding": {"skin": "old", "inhibitory": {"ring": 2}},
                  "channel_weight": {"krause": 1}},
        "study": {"music": "soft", "attention": {"blinks": 3}}})");
    const std::string text = print_set(set);
    CHECK(parsed(text) == set);
    for (const char* part : {"\"future\"", "\"deep\": true", "\"new\": 1", "\"colour\": \"red\"",
                             "\"shape\": \"square\"", "\"swing\": 0.1", "\"who\": \"us\"",
                             "\"taste\": 1", "\"skin\": \"old\"", "\"ring\": 2", "\"krause\": 1",
                             "\"music\": \"soft\"", "\"blinks\": 3"}) {
        CAPTURE(part);
        CHECK(contains(text, part));
    }
    PatternSet edited = set;
    std::get<Pattern>(edited.vibrations[0].source).carriers.pop_back();
    CHECK_FALSE(contains(print_set(edited), "\"red\""));
    CHECK(contains(print_set(edited), "\"square\""));
}

TEST_CASE("set file: wrong types are refused with their JSON path") {
    CHECK(set_fault(R"({"tactspace": 1, "patterns": [{"name": "a"}, {"name": "b", "carriers":
        [{"frequency_hz": "abc"}]}]})") ==
          "s.json: /patterns/1/carriers/0/frequency_hz: expected a number from 0.1 to 1000, got "
          "\"abc\"");
    const auto place = [](const std::string& text) {
        const std::string message = set_fault(text);
        return message.substr(8, message.find(": expected") - 8);
    };
    CHECK(place("[]") == "/");
    CHECK(place(with_set(R"(, "name": 1)")) == "/name");
    CHECK(place(with_set(R"(, "duration_s": null)")) == "/duration_s");
    CHECK(place(with_set(R"(, "ratings": {})")) == "/ratings");
    CHECK(place(with_set(R"(, "model": [])")) == "/model");
    CHECK(place(R"({"tactspace": 1, "patterns": {}})") == "/patterns");
    CHECK(place(R"({"tactspace": 1, "patterns": [3]})") == "/patterns/0");
    CHECK(place(R"({"tactspace": "1"})") == "/tactspace");
    CHECK(place(R"({"tactspace": 0})") == "/tactspace");
    CHECK(place(with_pattern(R"(, "locked": 1)")) == "/patterns/0/locked");
    CHECK(place(with_pattern(R"(, "colour": "blue")")) == "/patterns/0/colour");
    CHECK(place(with_pattern(R"(, "mark": "star")")) == "/patterns/0/mark");
    CHECK(place(with_pattern(R"(, "note": [])")) == "/patterns/0/note");
    CHECK(place(with_pattern(R"(, "rhythm": "x-")")) == "/patterns/0/rhythm");
    CHECK(place(with_pattern(R"(, "modulation": {"kind": "fm"})")) ==
          "/patterns/0/modulation/kind");
    CHECK(place(with_pattern(R"(, "carriers": [])")) == "/patterns/0/carriers");
    CHECK(place(with_pattern(R"(, "waveform": 3)")) == "/patterns/0/waveform");
}

TEST_CASE("set file: numbers out of range are refused with their JSON path") {
    for (const char* field :
         {R"("amplitude_g": -1)", R"("amplitude_g": 51)", R"("carriers": [{"frequency_hz": 0}])",
          R"("carriers": [{"frequency_hz": 1001}])", R"("carriers": [{"weight": 11}])",
          R"("modulation": {"frequency_hz": -1})", R"("modulation": {"depth": 1.1})",
          R"("rhythm": {"unit_s": 0})", R"("attack_s": 11)", R"("duration_s": 0)",
          R"("duration_s": 61)", R"("release_s": 1e300)",
          R"("carriers": [{},{},{},{},{},{},{},{},{}])"}) {
        CAPTURE(field);
        CHECK(
            set_fault(with_pattern(std::string(", ") + field)).starts_with("s.json: /patterns/0/"));
    }
    CHECK(contains(set_fault(with_pattern(R"(, "rhythm": {"text": "x-q"})")),
                   "s.json: /patterns/0/rhythm/text: expected a rhythm (step 3"));
    CHECK(contains(set_fault(with_set(R"(, "duration_s": NaN)")), "line 1, column"));
    std::string many = R"({"tactspace": 1, "patterns": [)";
    for (int k = 0; k < 10'001; ++k) many += (k == 0 ? "" : ",") + std::string("{}");
    CHECK(contains(set_fault(many + "]}"), "/patterns: expected an array of 0 to 10000"));
}

TEST_CASE("set file: a study that was saved before three identical pairs were usual has its one") {
    CHECK(parsed(with_set(R"(, "study": {"repetitions": 2})")).study.attention_pairs == 1);
    CHECK(parsed(with_set("")).study.attention_pairs == kAttentionPairs);
    PatternSet set = parsed(with_set(""));
    for (const int pairs : {0, 1, kAttentionPairs}) {
        set.study.attention_pairs = pairs;
        CHECK(parsed(print_set(set)).study.attention_pairs == pairs);
        set.study.repetitions = 7;
        CHECK(parsed(print_set(set)).study.attention_pairs == pairs);
        set.study.repetitions = StudyDesign{}.repetitions;
    }
}

TEST_CASE("set file: a study's design is refused where it makes no study") {
    for (const char* field :
         {R"("repetitions": 0)", R"("attention_pairs": 101)", R"("gap_s": -1)", R"("order": "odd")",
          R"("masking": 2)", R"("attention": {"above": 101})", R"("patterns": [3])",
          R"("groups": [-1])", R"("seed": 1.5)"}) {
        CAPTURE(field);
        const std::string study = std::string(R"(, "study": {)") + field + "}";
        CHECK(set_fault(with_set(study)).starts_with("s.json: /study/"));
    }
}

TEST_CASE("set file: two equal names are refused, and both are named") {
    CHECK(set_fault(
              R"({"tactspace": 1, "patterns": [{"name": "a"}, {"name": "b"}, {"name": "a"}]})") ==
          "s.json: /patterns/2/name: \"a\" is the name of /patterns/0 too, expected names that "
          "differ");
    CHECK(
        contains(set_fault(with_set(R"(, "ratings": [{"labels": ["x", "x"], "condensed": [1]}])")),
                 "/ratings/0/labels/1: \"x\""));
}

TEST_CASE("set file: a pattern without a name gets one, with a remark") {
    const TemporaryFolder folder;
    const auto loaded = read_set_file(
        folder.write("s.json", R"({"tactspace": 1, "patterns": [{"name": "a"}, {}]})"));
    REQUIRE(loaded);
    CHECK(loaded->set.vibrations[1].name == "pattern 2");
    REQUIRE(loaded->remarks.size() == 1);
    CHECK(contains(loaded->remarks[0], "/patterns/1 has no name"));
}

TEST_CASE("set file: a newer format is refused, whatever else it holds") {
    CHECK(set_fault(R"({"patterns": 7, "tactspace": 2})") ==
          "s.json: made by a newer version (format 2); this program reads format 1");
}

TEST_CASE("set file: damaged and foreign files are refused") {
    const std::string whole = print_set(unusual_set());
    for (std::size_t length = 0; length + 2 < whole.size(); length += 7) {
        CHECK(set_fault(whole.substr(0, length)).starts_with("s.json, line "));
    }
    CHECK(contains(set_fault(with_set(", \"x\": " + std::string(200'000, '['))),
                   "at most 100 levels"));
    CHECK(contains(set_fault(R"({"name": "npm"})"), "is not a set of tactspace"));
    const auto missing = read_set_file("no/such.tactspace.json");
    REQUIRE_FALSE(missing);
    CHECK(missing.error().message == "no/such.tactspace.json: there is no such file");
}

TEST_CASE("set file: Windows line ends and a byte-order mark are accepted") {
    std::string text = print_set(unusual_set());
    for (std::size_t k = 0; (k = text.find('\n', k)) != text.npos; k += 2) text.insert(k, 1, '\r');
    CHECK(parsed("\xEF\xBB\xBF" + text) == unusual_set());
}

TEST_CASE("set file: ratings have a value for each pair of labels") {
    const auto ratings = [](const std::string& fields) {
        return with_set(", \"ratings\": [{" + fields + "}]");
    };
    CHECK(parsed(ratings(R"("labels": ["a", "b", "c"], "condensed": [1, 2, 3])"))
              .ratings[0]
              .condensed == std::vector<double>{1.0, 2.0, 3.0});
    CHECK(set_fault(ratings(R"("labels": ["a", "b", "c"], "condensed": [1, 2])")) ==
          "s.json: /ratings/0/condensed: expected 3 values, one for each pair of 3 labels, got 2");
    CHECK(contains(set_fault(ratings(R"("labels": ["a", "b"], "condensed": ["1"])")),
                   "/ratings/0/condensed/0: expected a number, got"));
    CHECK(contains(set_fault(ratings(R"("labels": ["a", 2], "condensed": [1])")),
                   "/ratings/0/labels/1"));
}

TEST_CASE("set file: a pair that was not rated survives as null") {
    PatternSet set = unusual_set();
    set.ratings[0].condensed[1] = kUnrated;
    set.ratings[0].file = "study.csv";
    const std::string text = print_set(set);
    CHECK(contains(text, "null"));
    CHECK(parsed(text) == set);
}

TEST_CASE("set file: what could not be read again is not written, and the old file stays whole") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("s.json", "old");
    const auto refused = [&](const PatternSet& set) {
        const auto written = write_set_file(file, set);
        REQUIRE_FALSE(written);
        CHECK(bytes_of(file) == "old");
        CHECK(file_count(folder.path) == 1);
        return written.error().message;
    };
    PatternSet set = unusual_set();
    set.vibrations[1].name = set.vibrations[0].name;
    CHECK(contains(refused(set), "/patterns/1/name: \"one two\""));
    set = unusual_set();
    std::get<Pattern>(set.vibrations[0].source).amplitude_g = 1e6;
    CHECK(contains(refused(set), "/patterns/0/amplitude_g"));
    CHECK_FALSE(write_set_file(file / "below.json", unusual_set()));
    CHECK_FALSE(write_set_file(folder.path / "none" / "s.json", unusual_set()));
    CHECK(bytes_of(file) == "old");
    CHECK(write_set_file(file, unusual_set()));
    CHECK(read_set_file(file)->set == unusual_set());
}

TEST_CASE("set file: a set of which a pair was not rated is saved, and the old one replaced") {
    const TemporaryFolder folder;
    const fs::path file = folder.write("s.json", "old");
    PatternSet set = unusual_set();
    set.ratings[0].condensed[1] = kUnrated;
    const auto written = write_set_file(file, set);
    REQUIRE_MESSAGE(written, (written ? "" : written.error().message));
    CHECK(read_set_file(file)->set == set);
}

}  // namespace set_file_test
