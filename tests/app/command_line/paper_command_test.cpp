// tactspace paper: Table 2 of one's own sets, with both bookkeepings, maps, and scripts that agree.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace paper_command_test {

using Json = nlohmann::json;

namespace {

constexpr const char* kPatterns = R"(, "duration_s": 0.1, "patterns": [
    {"name": "v 1", "amplitude_g": 1.6}, {"name": "v, 2", "amplitude_g": 0.3},
    {"name": "v 3", "carriers": [{"frequency_hz": 250}]},
    {"name": "v 4", "carriers": [{"frequency_hz": 40}]}, {"name": "v 5", "amplitude_g": 0.8},
    {"name": "unrated"}],
    "study": {"repetitions": 1, "patterns": ["v 1", "v, 2", "v 3", "v 4", "v 5"]}})";

struct TwoSets {
    TemporaryFolder folder;
    std::vector<std::string> sets;
    std::vector<std::string> people;

    TwoSets() {
        for (const char* name : {"one", "two"}) {
            sets.push_back(
                folder
                    .write(std::string(name) + ".json",
                           std::string(R"({"tactspace": 1, "name": ")") + name + "\"" + kPatterns)
                    .string());
            people.push_back(at(std::string(name) + " people"));
            REQUIRE(run_program({"study", sets.back(), "--simulate", "3", "--out", people.back(),
                                 "--noise", "20", "--seed", name == std::string("one") ? "1" : "2"})
                        .exit_code == 0);
        }
    }
    std::string at(const std::string& name) const { return (folder.path / name).string(); }
    std::string out() const { return at("paper"); }
    Ran paper(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{"paper",   sets[0],   sets[1], "--ratings",
                                     people[0], people[1], "--out", out()};
        all.insert(all.end(), more.begin(), more.end());
        return run_program(all);
    }
};

Ran shell(const std::string& line) { return run_program({}, "exec " + line); }

void check_scripts(const std::string& folder, int expected) {
    if (shell("/usr/bin/python3 -c 'import numpy'").exit_code == 0) {
        const Ran ran = shell("/usr/bin/python3 '" + folder + "/table2.py'");
        CHECK_MESSAGE(ran.exit_code == expected, ran.out << ran.err);
    }
    if (shell("Rscript --version").exit_code == 0) {
        const Ran ran = shell("Rscript '" + folder + "/table2.R'");
        CHECK_MESSAGE(ran.exit_code == expected, ran.out << ran.err);
    }
}

}  // namespace

TEST_CASE(
    "paper: Table 2 is that of compare, its averages by both bookkeepings, and scripts agree" *
    doctest::test_suite("long")) {
    const TwoSets two;
    const Ran ran = two.paper();
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    const std::string table = bytes_of(two.out() + "/table2.csv");
    // Seven metrics of two sets, and their averages.
    CHECK(std::ranges::count(table, '\n') == 1 + 3 * 7);
    const Json compared =
        Json::parse(output_of({"compare", two.sets[0], two.sets[1], "--ratings", two.people[0],
                               two.people[1], "--metric", "pm", "rmse", "--paper-mode", "--json"}));
    for (const Json& row : compared) {
        if (!row.contains("mean_of_sets")) continue;
        const std::string line = "average," + row.at("metric").get<std::string>() + ",";
        const std::size_t at = table.find(line);
        REQUIRE(at != table.npos);
        CHECK(std::abs(std::stod(table.substr(at + line.size())) - row.at("rho").get<double>()) <
              1e-12);
    }
    const std::string page = bytes_of(two.out() + "/paper.html");
    for (const char* words : {"SYNTHETIC", "cannot be reproduced", "References", "FA1",
                              "one: ", "Lines join patterns that differ in "}) {
        CHECK_MESSAGE(contains(page, words), words);
    }
    // A map of people and of each metric that has one, in two formats.
    std::size_t pictures = 0;
    for (const auto& entry : std::filesystem::directory_iterator(two.out() + "/figures")) {
        pictures += entry.path().extension() == ".svg" ? 1 : 0;
    }
    CHECK(pictures > 8);
    // Each of the publication's is there in both formats, and whole on the page.
    for (const char* figure :
         {"figure-4", "figure-5", "figure-6a", "figure-6b", "figure-7", "maps-1", "maps-2"}) {
        CAPTURE(figure);
        CHECK(bytes_of(two.out() + "/figures/" + figure + ".png").starts_with("\x89PNG"));
        CHECK(contains(bytes_of(two.out() + "/figures/" + figure + ".svg"), "</svg>"));
        CHECK(contains(page, std::string("<figure id=\"") + figure + "\">"));
    }
    check_scripts(two.out(), 0);
    // A number that is another is found.
    std::string other = table;
    const std::size_t digit = other.find(",0.") + 3;
    other[digit] = other[digit] == '9' ? '8' : '9';
    two.folder.write("paper/table2.csv", other);
    check_scripts(two.out(), 1);
    // Nothing is written over.
    const Ran again = two.paper();
    CHECK(again.exit_code == 1);
    CHECK(contains(again.err, "empty or not there"));
}

TEST_CASE("paper: without ratings it says so, and makes no folder") {
    const TwoSets two;
    const Ran ran = run_program({"paper", two.sets[0], "--out", two.out()});
    CHECK(ran.exit_code == 1);
    CHECK(contains(ran.err, "ratings"));
    CHECK_FALSE(std::filesystem::exists(two.out()));
}

}  // namespace paper_command_test
