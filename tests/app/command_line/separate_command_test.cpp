// tactspace separate: what it prints, and what it refuses.
#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "app/rendering/rendering.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/subset/separation.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace separate_command_test {

using Json = nlohmann::json;

namespace {

// Patterns of 0.1 s, as DTW is quadratic; the first two are nearly alike.
constexpr const char* kShortSet = R"({"tactspace": 1, "duration_s": 0.1, "patterns": [
    {"name": "a,1", "carriers": [{"frequency_hz": 150}]},
    {"name": "b", "carriers": [{"frequency_hz": 155}]},
    {"name": "c", "amplitude_g": 1.6, "carriers": [{"frequency_hz": 60}]},
    {"name": "d", "carriers": [{"frequency_hz": 250}], "modulation": {"frequency_hz": 20}},
    {"name": "e", "amplitude_g": 0.5, "carriers": [{"frequency_hz": 80}], "locked": true}]})";

struct ShortSet {
    TemporaryFolder folder;
    std::string path = folder.write("short.tactspace.json", kShortSet).string();
    tact::PatternSet set = tact::read_set_file(path)->set;
    tact::Prediction prediction = *tact::predict(tact::model_waveforms(set), set.model);

    Json separated(std::vector<std::string> more) const {
        std::vector<std::string> words{"separate", path, "--json"};
        words.insert(words.end(), more.begin(), more.end());
        return Json::parse(output_of(words));
    }
    std::string refusal(std::vector<std::string> more) const {
        std::vector<std::string> words{"separate", path};
        words.insert(words.end(), more.begin(), more.end());
        return refusal_of(words);
    }
};

// What the model says of one of the patterns, as the command prints it.
Json changes_of(const ShortSet& short_set, std::size_t place, double threshold,
                const tact::SeparationOptions& options = {}) {
    Json changes = Json::array();
    const auto& all = short_set.set.vibrations;
    const auto found =
        tact::separations(short_set.set, short_set.prediction, place, threshold, options);
    for (const tact::Separation& one : *found) {
        changes.push_back(
            {{"pattern", all[place].name},
             {"parameter", tact::traits(one.parameter).key},
             {"from", one.from},
             {"to", one.to},
             {"felt_steps", one.steps},
             {"nearest", {{"pattern", all[one.nearest_to].name}, {"dissimilarity", one.nearest}}}});
    }
    return changes;
}

// As the command goes by where no threshold is given: that of the set with the change.
tact::SeparationOptions closest_five() {
    tact::SeparationOptions options;
    options.share = 0.05;
    return options;
}

}  // namespace

TEST_CASE("separate command: JSON is the model's answer, farther than the pair is now") {
    const ShortSet short_set;
    const Json json = short_set.separated({"--pair", "a,1,b", "--change", "b"});
    CHECK(json.at("pair") == std::vector<std::string>{"a,1", "b"});
    const double apart = short_set.prediction.pm(0, 1);
    CHECK(json.at("dissimilarity") == apart);
    CHECK(json.at("threshold") ==
          std::max(apart, tact::threshold_at(short_set.prediction.pm, 0.05)));
    REQUIRE_FALSE(json.at("changes").empty());
    CHECK(json.at("changes") == changes_of(short_set, 1, json.at("threshold"), closest_five()));
}

TEST_CASE("separate command: either may change unless it is locked, the smallest step first") {
    const ShortSet short_set;
    const Json both = short_set.separated({"--pair", "a,1,b"});
    const double threshold = both.at("threshold");
    CHECK(both.at("changes").size() ==
          changes_of(short_set, 0, threshold, closest_five()).size() +
              changes_of(short_set, 1, threshold, closest_five()).size());
    const Json others = short_set.separated({"--pair", "c,e"});
    for (const Json& change : others.at("changes")) {
        CHECK(change.at("pattern") == "c");
    }
}

TEST_CASE("separate command: among some alone, and farther than a threshold of one's own") {
    const ShortSet short_set;
    const Json json =
        short_set.separated({"--pair", "c,b", "--change", "c", "--among", "d", "--threshold", "6"});
    CHECK(json.at("threshold") == 6.0);
    tact::SeparationOptions options;
    options.from = {1, 2, 3};
    CHECK(json.at("changes") == changes_of(short_set, 2, 6.0, options));
}

TEST_CASE("separate command: where a device plays them, a change parts what is felt of them") {
    const ShortSet short_set;
    tact::RenderedBy by{*tact::actuator_kind_named("joy-con")};
    by.level = 0.5;
    const auto pm_of = [&by](const tact::PatternSet& set) {
        const tact::PatternSet played = tact::rendered_set(set, by)->played;
        return tact::predict(tact::model_waveforms(played), set.model)->pm;
    };
    const Json json = short_set.separated(
        {"--pair", "a,1,b", "--change", "b", "--rendered-by", "joy-con", "--level", "0.5"});
    const tact::Dissimilarity now = pm_of(short_set.set);
    CHECK(json.at("dissimilarity") == now(0, 1));
    CHECK(json.at("threshold") == std::max(now(0, 1), tact::threshold_at(now, 0.05)));
    CHECK(json.at("rendered_by") == "joy-con");
    CHECK(json.at("level") == 0.5);
    REQUIRE_FALSE(json.at("changes").empty());
    for (const Json& change : json.at("changes")) {
        tact::PatternSet changed = short_set.set;
        auto& pattern = std::get<tact::Pattern>(changed.vibrations[1].source);
        for (const tact::PatternParameter parameter : tact::kPatternParameters) {
            if (change.at("parameter") != tact::traits(parameter).key) continue;
            pattern = tact::with_value(pattern, parameter, change.at("to"));
        }
        const tact::Dissimilarity then = pm_of(changed);
        double nearest = then(1, 0);
        for (const std::size_t k : {std::size_t{2}, std::size_t{3}, std::size_t{4}}) {
            nearest = std::min(nearest, then(1, k));
        }
        CHECK(change.at("nearest").at("dissimilarity") == nearest);
        CHECK(nearest > json.at("threshold").get<double>());
    }
}

TEST_CASE("separate command: --out is what would be printed, labels and all" *
          doctest::test_suite("long")) {
    const ShortSet short_set;
    const std::string out = (short_set.folder.path / "answer.txt").string();
    const std::vector<std::string> words{"separate", short_set.path, "--pair",        "c,d",
                                         "--only",   "intended",     "--rendered-by", "joy-con"};
    const std::string printed = output_of(words);
    CHECK(
        printed.starts_with("the patterns as a Joy-Con plays them, uncalibrated: full scale stands "
                            "for 1.00 g\nonly the "
                            "intended patterns\nPM of c and d"));
    std::vector<std::string> to_file = words;
    to_file.insert(to_file.end(), {"--out", out});
    CHECK(output_of(to_file).empty());
    CHECK(bytes_of(out) == printed);
    to_file.back() = short_set.folder.path.string();
    CHECK(contains(refusal_of(to_file), "cannot be written"));
}

TEST_CASE("separate command: text has a line for each change, or says that there is none") {
    const ShortSet short_set;
    const std::string text = output_of({"separate", short_set.path, "--pair", "a,1,b"});
    CHECK(text.find("PM of a,1 and b") != std::string::npos);
    CHECK(text.find("parameter") != std::string::npos);
    const std::string none =
        output_of({"separate", short_set.path, "--pair", "a,1,b", "--threshold", "1000"});
    CHECK(none.find("no change of a single number is enough") != std::string::npos);
}

TEST_CASE("separate command: names that are none, and wishes that cannot be, are refused") {
    const ShortSet short_set;
    CHECK(short_set.refusal({"--pair", "c,z"}) ==
          "tactspace: --pair: there is no pattern \"z\", expected one of a,1, b, c, d, e\n");
    CHECK(short_set.refusal({"--pair", "c"}) ==
          "tactspace: --pair: expected two patterns with a comma between, got \"c\"\n");
    CHECK(short_set.refusal({"--pair", "c,c"}) ==
          "tactspace: --pair: expected two patterns with a comma between, got \"c,c\"\n");
    CHECK(short_set.refusal({"--pair", "c,d", "--change", "b"}) ==
          "tactspace: --change: expected the one of the pair that is to be changed, a pattern made "
          "of parameters, got \"b\"\n");
    CHECK(short_set.refusal({"--pair", "c,d", "--among", "z"}).starts_with("tactspace: --among: "));
    CHECK(run_program({"separate", short_set.path}).exit_code == 2);
    CHECK(run_program(
              {"separate", short_set.path, "--pair", "c,d", "--closest", "5", "--threshold", "3"})
              .exit_code == 2);
}

}  // namespace separate_command_test
