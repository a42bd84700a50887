// tactspace report: the page that it writes, what it says beside it, and what it refuses.
#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/subset/close_groups.h"
#include "model/subset/subset.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace report_command_test {

using Json = nlohmann::json;

namespace {

// Patterns of 0.1 s, as DTW is quadratic; the first two are nearly alike.
constexpr const char* kShortSet = R"({"tactspace": 1, "duration_s": 0.1, "patterns": [
    {"name": "a,1", "carriers": [{"frequency_hz": 150}]},
    {"name": "b", "carriers": [{"frequency_hz": 155}]},
    {"name": "<c>", "amplitude_g": 1.6, "carriers": [{"frequency_hz": 60}]},
    {"name": "d", "carriers": [{"frequency_hz": 250}], "modulation": {"frequency_hz": 20}},
    {"name": "e", "amplitude_g": 0.5, "carriers": [{"frequency_hz": 80}], "locked": true}]})";

struct ShortSet {
    TemporaryFolder folder;
    std::string path = folder.write("short.tactspace.json", kShortSet).string();
    std::string page = (folder.path / "page.html").string();
    tact::PatternSet set = tact::read_set_file(path)->set;
    tact::Dissimilarity pm = tact::predict(tact::model_waveforms(set), set.model)->pm;

    std::vector<std::string> words(const std::vector<std::string>& more) const {
        std::vector<std::string> all{"report", path, "--out", page};
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }
    Json reported(std::vector<std::string> more) const {
        more.emplace_back("--json");
        return Json::parse(output_of(words(more)));
    }
};

Json names_of(const tact::PatternSet& set, const std::vector<std::size_t>& places) {
    Json names = Json::array();
    for (const std::size_t place : places) names.push_back(set.vibrations[place].name);
    return names;
}

}  // namespace

TEST_CASE("report command: groups and verdicts are of felt steps, others closer than the picked") {
    const ShortSet short_set;
    const Json json = short_set.reported({});
    // Half of five, and the locked one is among them.
    const auto answer = *tact::most_distinct_subset(short_set.pm, {.count = 3, .keep = {4}});
    const double threshold = answer.best.weakest_dissimilarity;
    CHECK(json.at("picked") == names_of(short_set.set, answer.best.members));
    CHECK(json.at("closer_below") == threshold);
    CHECK(json.at("closer_than") == "your 3");
    const tact::CloseGroups closer = tact::groups_below(short_set.pm, threshold);
    REQUIRE_FALSE(closer.groups.empty());
    REQUIRE(json.at("closer_groups").size() == closer.groups.size());
    for (std::size_t k = 0; k < closer.groups.size(); ++k) {
        CHECK(json.at("closer_groups")[k] == names_of(short_set.set, closer.groups[k].members));
    }
    // Nobody feels the difference of 150 and 155 Hz; all others are at least two steps apart.
    CHECK(json.at("groups") == Json::parse(R"([["a,1", "b"]])"));
    CHECK(json.at("distinct") == 4);
    CHECK(json.at("nearest").at("a,1").at("verdict") == "same");
    CHECK(json.at("nearest").at("e").at("verdict") == "clear");
    CHECK(json.at("nearest").at("a,1").at("pattern") == "b");
    const std::string page = bytes_of(short_set.page);
    CHECK(contains(page, "&lt;c&gt;"));
    CHECK_FALSE(contains(page, "<c>"));
    CHECK(contains(page, "the weakest pair of the 3 most distinct, proven"));
}

TEST_CASE(
    "report command: a value or a pair that is known decides what is listed as closer, and is "
    "said") {
    const ShortSet short_set;
    CHECK(short_set.reported({"--confused-at", "2.5"}).at("closer_below") == 2.5);
    CHECK(contains(bytes_of(short_set.page), "below <b>2.5</b>, a value that was given"));
    const Json json = short_set.reported({"--confused-at", "a,1,d", "-k", "2"});
    CHECK(json.at("closer_below") == short_set.pm(0, 3));
    CHECK(json.at("picked").size() == 2);
    CHECK(contains(bytes_of(short_set.page), "as far apart as a,1 and d, a pair that was given"));
    const std::string text = output_of(short_set.words({"--confused-at", "0"}));
    CHECK(contains(text, "closer than PM 0, below PM 0, a value that was given: 0 of 10 pairs"));
}

TEST_CASE("report command: what plays the patterns goes with the page and the answer") {
    const ShortSet short_set;
    const Json json = short_set.reported({"--rendered-by", "dualshock-4", "--sure", "2"});
    CHECK(json.at("rendered_by") == "dualshock-4");
    CHECK(json.at("closer_below") != short_set.reported({}).at("closer_below"));
    output_of(short_set.words({"--rendered-by", "dualshock-4", "--sure", "2"}));
    const std::string page = bytes_of(short_set.page);
    CHECK(contains(page,
                   "as a DualShock 4 plays them, uncalibrated: full scale stands for 1.00 g; "
                   "how fast its motors turn and how soon is a guess"));
    CHECK(contains(page, "In 2 draws of what is uncertain"));
}

TEST_CASE("report command: what cannot be is refused before a page is written") {
    const ShortSet short_set;
    const auto refusal = [&](const std::vector<std::string>& more) {
        return refusal_of(short_set.words(more));
    };
    CHECK(contains(refusal({"--confused-at", "b,z"}), "--closer-than: there is no pattern \"z\""));
    CHECK(contains(refusal({"--confused-at", "near"}), "--closer-than: expected"));
    CHECK(contains(refusal({"--confused-at=-1"}), "--closer-than: expected a PM of 0 or more"));
    CHECK(contains(refusal({"-k", "6"}), "6 to pick of 5"));
    CHECK_FALSE(std::filesystem::exists(short_set.page));
    CHECK(contains(refusal_of({"report", short_set.path, "--out", "/nowhere/page.html"}),
                   "/nowhere/page.html"));
    CHECK(run_program({"report", short_set.path}).exit_code != 0);
}

}  // namespace report_command_test
