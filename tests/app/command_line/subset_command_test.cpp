// tactspace subset: what it prints, and what it refuses.
#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/rendering/rendering.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/subset/set_subset.h"
#include "tests/support/places.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace subset_command_test {

using Json = nlohmann::json;

namespace {

// Five patterns of 0.1 s, as DTW is quadratic.
constexpr const char* kShortSet = R"({"tactspace": 1, "duration_s": 0.1, "patterns": [
    {"name": "a", "amplitude_g": 1.6, "carriers": [{"frequency_hz": 70}]},
    {"name": "b", "carriers": [{"frequency_hz": 150}], "modulation": {"frequency_hz": 20}},
    {"name": "c", "carriers": [{"frequency_hz": 250}], "rhythm": {"text": "x-", "unit_s": 0.02}},
    {"name": "d|e", "amplitude_g": 0.3, "carriers": [{"frequency_hz": 40}], "locked": true},
    {"name": "f", "carriers": [{"frequency_hz": 70}, {"frequency_hz": 210}], "dropped": true}]})";

struct ShortSet {
    TemporaryFolder folder;
    std::string path = folder.write("short.tactspace.json", kShortSet).string();

    tact::PatternSet set() const { return tact::read_set_file(path)->set; }
};

}  // namespace

TEST_CASE("subset command: JSON is the model's answer, with the locks of the set") {
    const ShortSet short_set;
    const Json json = Json::parse(output_of(
        {"subset", short_set.path, "-k", "3", "--json", "--alternatives", "2", "--curve"}));
    const tact::PatternSet set = short_set.set();
    const auto problem = tact::subset_problem(set, 3, tact::SubsetObjective::max_min);
    const auto prediction = *tact::predict(tact::model_waveforms(set), set.model);
    const auto answer = *tact::most_distinct_subset(prediction.pm, problem);
    std::vector<std::string> names;
    for (const std::size_t k : answer.best.members) names.push_back(set.vibrations[k].name);
    CHECK(json.at("patterns") == names);
    CHECK(json.at("objective") == "max-min");
    CHECK(json.at("optimal") == true);
    CHECK(json.at("weakest").at("dissimilarity") == answer.best.weakest_dissimilarity);
    CHECK(json.at("weakest").at("a") == set.vibrations[answer.best.weakest.first].name);
    CHECK(json.at("weakest").at("b") == set.vibrations[answer.best.weakest.second].name);
    CHECK(json.at("sum") == answer.best.sum);
    CHECK(std::ranges::count(names, "d|e") == 1);
    CHECK(std::ranges::count(names, "f") == 0);
    CHECK(json.at("alternatives").size() == 2);
    CHECK(json.at("curve").size() == 3);  // 2, 3, 4: one of the five is dropped
}

TEST_CASE("subset command: a matrix from a file decides, its rows in any order") {
    const ShortSet short_set;
    const std::string matrix =
        short_set.folder
            .write("m.csv",
                   ",f,d|e,c,b,a\nf,0,1,2,3,4\nd|e,1,0,5,6,7\nc,2,5,0,8,9\nb,3,6,8,0,1\n"
                   "a,4,7,9,1,0\n")
            .string();
    const Json json =
        Json::parse(output_of({"subset", short_set.path, "-k", "3", "--matrix", matrix, "--json"}));
    CHECK(json.at("patterns") == std::vector<std::string>{"a", "c", "d|e"});
    CHECK(json.at("weakest").at("dissimilarity") == 5.0);
}

TEST_CASE("subset command: commas that may be thousands are decimal ones where somebody says so") {
    const ShortSet short_set;
    const std::string matrix =
        short_set.folder
            .write("m.csv",
                   ";f;d|e;c;b;a\nf;0;1,111;2,222;3,333;4,444\nd|e;1,111;0;5,555;6,666;7,777\n"
                   "c;2,222;5,555;0;8,888;9,999\nb;3,333;6,666;8,888;0;1,234\n"
                   "a;4,444;7,777;9,999;1,234;0\n")
            .string();
    std::vector<std::string> words{"subset",   short_set.path, "-k",    "3",
                                   "--matrix", matrix,         "--json"};
    CHECK(run_program(words).exit_code == 1);
    words.insert(words.end(), {"--decimal", "comma", "--separator", "semicolon"});
    CHECK(Json::parse(output_of(words)).at("weakest").at("dissimilarity") == 5.555);
}

TEST_CASE(
    "subset command: as a device plays them other patterns are distinct; those meant are kept") {
    const ShortSet short_set;
    const std::string out = (short_set.folder.path / "part.tactspace.json").string();
    const std::vector<std::string> words{"subset",        short_set.path, "-k",      "3",
                                         "--rendered-by", "dualshock-4",  "--level", "0.4"};
    std::vector<std::string> as_json = words;
    as_json.insert(as_json.end(), {"--json", "--out", out});
    const Json json = Json::parse(output_of(as_json));
    const tact::PatternSet set = short_set.set();
    tact::RenderedBy by{*tact::actuator_kind_named("dualshock-4")};
    by.level = 0.4;
    const tact::PatternSet played = tact::rendered_set(set, by)->played;
    const auto prediction = *tact::predict(tact::model_waveforms(played), set.model);
    const auto answer = *tact::most_distinct_subset(
        prediction.pm, tact::subset_problem(set, 3, tact::SubsetObjective::max_min));
    CHECK(json.at("weakest").at("dissimilarity") == answer.best.weakest_dissimilarity);
    CHECK(json.at("sum") == answer.best.sum);
    CHECK(json.at("rendered_by") == "dualshock-4");
    CHECK(json.at("level") == 0.4);
    const tact::PatternSet part = tact::read_set_file(out)->set;
    for (const tact::Vibration& vibration : part.vibrations) {
        CHECK(vibration == set.vibrations[*tact::place_named(set, vibration.name)]);
    }
    CHECK(output_of(words).starts_with(
        "the patterns as a DualShock 4 plays them at a level of 40 %, uncalibrated: full scale "
        "stands for 1.00 g; how fast its motors turn and how soon is a guess\n"));
    std::vector<std::string> by_ratings = words;
    by_ratings.insert(by_ratings.end(), {"--ratings", "any.csv"});
    CHECK(contains(refusal_of(by_ratings), "--rendered-by is for a metric"));
    const Ran none = run_program({"subset", short_set.path, "-k", "2", "--only", "measured"});
    CHECK(none.exit_code == 1);
    CHECK(contains(none.err, "has no pattern"));
}

TEST_CASE(
    "subset command: what nobody feels is left out and named, unless it is included or kept") {
    const TemporaryFolder folder;
    const std::string path = folder
                                 .write("faint.tactspace.json",
                                        R"({"tactspace": 1, "duration_s": 0.1, "patterns": [
    {"name": "a", "carriers": [{"frequency_hz": 60}]},
    {"name": "nothing", "amplitude_g": 0, "carriers": [{"frequency_hz": 250}]},
    {"name": "c", "carriers": [{"frequency_hz": 250}]},
    {"name": "d", "amplitude_g": 0.5, "carriers": [{"frequency_hz": 150}]}]})")
                                 .string();
    const auto picked = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"subset", path, "--json"};
        words.insert(words.end(), more.begin(), more.end());
        return Json::parse(output_of(words));
    };
    const Json without = picked({"-k", "3", "--curve"});
    CHECK(without.at("patterns") == std::vector<std::string>{"a", "c", "d"});
    CHECK(without.at("left_out_unfelt") == std::vector<std::string>{"nothing"});
    CHECK(without.at("curve").back().at("k") == 3);
    CHECK(contains(output_of({"subset", path, "-k", "3"}),
                   "1 not felt pattern left out (--include-unfelt): nothing"));
    CHECK(picked({"-k", "4", "--include-unfelt"}).at("patterns").size() == 4);
    CHECK_FALSE(picked({"-k", "4", "--include-unfelt"}).contains("left_out_unfelt"));
    CHECK(picked({"-k", "2", "--keep", "nothing"}).at("patterns").dump().find("nothing") !=
          std::string::npos);
    CHECK(picked({"-k", "3", "--metric", "rmse"}).at("left_out_unfelt").size() == 1);
    CHECK(contains(refusal_of({"subset", path, "-k", "4"}),
                   "4 to pick of 3: expected at most as many; 1 not felt pattern left out"));
    const std::string page = (folder.path / "page.html").string();
    const Json report =
        Json::parse(output_of({"report", path, "-k", "3", "--out", page, "--json"}));
    CHECK(report.at("picked") == std::vector<std::string>{"a", "c", "d"});
    CHECK(report.at("left_out_unfelt") == std::vector<std::string>{"nothing"});
    CHECK(contains(bytes_of(page), "1 not felt pattern left out."));
}

TEST_CASE("subset command: past its time the word does not appear") {
    const ShortSet short_set;
    const std::string text = output_of({"subset", short_set.path, "-k", "3", "--time-limit", "0"});
    CHECK(text.find("optimal") == std::string::npos);
    CHECK(text.find("time ran out") != std::string::npos);
    CHECK(output_of({"subset", short_set.path, "-k", "3"}).find("optimal: no other") !=
          std::string::npos);
}

TEST_CASE("subset command: --out is a set that can be picked from, --report a page with a map") {
    const ShortSet short_set;
    const std::string out = (short_set.folder.path / "part.tactspace.json").string();
    const std::filesystem::path report = short_set.folder.path / "report";
    output_of({"subset", short_set.path, "-k", "3", "--out", out, "--report", report.string(),
               "--sensitivity", "3"});
    CHECK(tact::read_set_file(out)->set.vibrations.size() == 3);
    const Json again = Json::parse(output_of({"subset", out, "-k", "2", "--json"}));
    CHECK(again.at("patterns").size() == 2);
    const std::string page = bytes_of(report / "report.html");
    CHECK(contains(page, "<h2>The 3 most distinct</h2>"));
    CHECK(contains(page, "Kept beforehand: <span class=\"name picked\">d|e</span>."));
    CHECK(contains(page, "In 3 draws of what is uncertain in the model"));
    CHECK(bytes_of(report / "map.svg").find("<svg") != std::string::npos);
    CHECK(tact::read_set_file(report / "subset.tactspace.json")->set ==
          tact::read_set_file(out)->set);
}

TEST_CASE("subset command: names that are none, and wishes that cannot be, are refused") {
    const ShortSet short_set;
    const auto refusal = [&](std::vector<std::string> more) {
        std::vector<std::string> words{"subset", short_set.path, "-k", "3"};
        words.insert(words.end(), more.begin(), more.end());
        return refusal_of(words);
    };
    CHECK(refusal({"--keep", "z"}) ==
          "tactspace: --keep: there is no pattern \"z\", expected one of a, b, c, d|e, f\n");
    CHECK(refusal({"--keep", "a", "--drop", "a"}) ==
          "tactspace: --drop: \"a\" is to be kept as well\n");
    CHECK(refusal({"--drop", "a", "--drop", "b"}) ==
          "tactspace: 3 to pick of 2: expected at most as many\n");
    CHECK(refusal({"--metric", "nc", "--sensitivity", "5"}) ==
          "tactspace: --sensitivity is for pm: only PM has the model's parameters\n");
    const std::string matrix = short_set.folder.write("m.csv", ",a,b\na,0,1\nb,1,0\n").string();
    CHECK(refusal({"--matrix", matrix}).find("expected a row \"c\"") != std::string::npos);
    CHECK(run_program({"subset", short_set.path}).exit_code == 2);
    CHECK(run_program({"subset", short_set.path, "-k", "3", "--objective", "best"}).exit_code == 2);
}

TEST_CASE("set file: a dropped pattern is kept dropped; none is locked and dropped") {
    const ShortSet short_set;
    const tact::PatternSet set = short_set.set();
    CHECK(set.vibrations[4].dropped);
    const auto again = tact::parse_set(tact::print_set(set), "again", {});
    REQUIRE(again);
    CHECK(*again == set);
    const auto both = tact::parse_set(
        R"({"tactspace": 1, "patterns": [{"name": "a", "locked": true, "dropped": true}]})", "both",
        {});
    REQUIRE_FALSE(both);
    CHECK(both.error().message ==
          "both: /patterns/0/dropped: expected false for a locked pattern, got true");
}

}  // namespace subset_command_test
