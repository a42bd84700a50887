// tactspace study --report: the folder that goes with a paper, and what its scripts find in it.
#include <algorithm>
#include <nlohmann/json.hpp>

#include "model/text/csv.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace study_report_test {

using Json = nlohmann::json;

namespace {

constexpr const char* kSet = R"({"tactspace": 1, "name": "five", "duration_s": 0.1, "patterns": [
    {"name": "v 1", "amplitude_g": 1.6}, {"name": "v, 2", "carriers": [{"frequency_hz": 150}]},
    {"name": "v 3", "carriers": [{"frequency_hz": 250}]}, {"name": "v 4", "amplitude_g": 0.3},
    {"name": "v 5", "carriers": [{"frequency_hz": 40}]}, {"name": "unrated"}],
    "study": {"repetitions": 2, "attention_pairs": 3,
              "patterns": ["v 1", "v, 2", "v 3", "v 4", "v 5"]}})";

constexpr const char* kFiles[] = {"participants.csv", "answers.csv", "reliability.csv",
                                  "pairs.csv",        "table.csv",   "maps.csv",
                                  "differences.csv",  "weights.csv", "dimensions.csv"};

struct Reported {
    TemporaryFolder folder;
    std::string set = folder.write("five.json", kSet).string();
    std::string people = (folder.path / "five study").string();  // where the window has them
    std::string report = (folder.path / "report").string();

    Ran simulated(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{"study", set,      "--simulate", "5",       "--out",
                                     people,  "--seed", "3",          "--noise", "25"};
        all.insert(all.end(), more.begin(), more.end());
        return run_program(all);
    }
    Ran reported(const std::vector<std::string>& more = {}) const {
        std::vector<std::string> all{"study", set, "--report", report};
        all.insert(all.end(), more.begin(), more.end());
        return run_program(all);
    }
    std::string file(const std::string& name) const { return bytes_of(report + "/" + name); }
};

using Cells = std::vector<std::vector<std::string>>;

Cells table_of(const std::string& text) {
    tact::CsvReader reader{text, 1, ','};
    Cells rows;
    for (tact::CsvRecord row = next_record(reader); row.line > 0; row = next_record(reader)) {
        rows.push_back(row.fields);
    }
    return rows;
}

// Another program than this one, where it is there.
Ran shell(const std::string& line) { return run_program({}, "exec " + line); }

std::vector<std::string> interpreters() {
    std::vector<std::string> found;
    if (shell("/usr/bin/python3 -c 'import numpy'").exit_code == 0) {
        found.emplace_back("/usr/bin/python3 '");
    }
    if (shell("Rscript --version").exit_code == 0) found.emplace_back("Rscript '");
    return found;
}

// By each of the two scripts: whether it finds the numbers again, and what it says.
void check_reproduced(const Reported& study, bool agrees) {
    for (const std::string& interpreter : interpreters()) {
        const char* ending = interpreter.starts_with("R") ? "R'" : "py'";
        const Ran ran = shell(interpreter + study.report + "/reproduce." + ending);
        CHECK_MESSAGE(ran.exit_code == (agrees ? 0 : 1), (ran.out + ran.err));
        CHECK_MESSAGE(contains(ran.out, agrees ? "\nall agree\n" : "DIFFERS"), (ran.out + ran.err));
    }
}

}  // namespace

TEST_CASE("study report: all tables, a page and scripts, every one with its labels") {
    const Reported study;
    REQUIRE(study.simulated().exit_code == 0);
    const Ran ran = study.reported({"--exclude", "S02", "--because", "fell \"asleep\", twice"});
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    for (const char* name : kFiles) {
        CAPTURE(name);
        const auto cells = table_of(study.file(name));
        REQUIRE(cells.size() > 1);
        const auto column = std::ranges::find(cells[0], "synthetic") - cells[0].begin();
        REQUIRE(column < std::ssize(cells[0]));
        for (std::size_t k = 1; k < cells.size(); ++k) {
            CHECK(cells[k][static_cast<std::size_t>(column)] == "1");
        }
    }
    CHECK(contains(study.file("participants.csv"),
                   "S02,0,\"excluded by name: fell \"\"asleep\"\", twice\",1,"));
    CHECK(table_of(study.file("participants.csv")).size() == 1 + 5);
    CHECK(table_of(study.file("answers.csv")).size() == 1 + 5 * (10 * 2 + 3));
    CHECK(table_of(study.file("pairs.csv")).size() == 1 + 10);
    CHECK(contains(study.file("maps.csv"), "\npeople,\"v, 2\","));
    const std::string page = study.file("report.html");
    CHECK(contains(page, "SYNTHETIC: nobody was asked for some or all of these"));
    CHECK(contains(page, "fell &quot;asleep&quot;, twice"));
    CHECK(contains(page, "1 of 6 patterns were not rated and are left out: &quot;unrated&quot;"));
    CHECK(contains(page, "Krippendorff"));
    // A star each of those who count.
    std::size_t stars = 0;
    for (std::size_t at = page.find("class=\"star\""); at != page.npos;
         at = page.find("class=\"star\"", at + 1)) {
        ++stars;
    }
    CHECK(stars == 4);
    CHECK(table_of(study.file("weights.csv")).size() == 1 + 4);
    CHECK(table_of(study.file("dimensions.csv")).size() == 1 + 5);
}

TEST_CASE("study report: the table is that of compare, and compare reads the folder" *
          doctest::test_suite("long")) {
    const Reported study;
    REQUIRE(study.simulated({"--inattentive", "0.2"}).exit_code == 0);
    REQUIRE(study.reported().exit_code == 0);
    const auto table = table_of(study.file("table.csv"));
    for (const std::string& ratings : {study.people, study.report}) {
        const Json rows =
            Json::parse(output_of({"compare", study.set, "--ratings", ratings, "--json"}));
        REQUIRE(rows.size() + 1 == table.size());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            CHECK(table[k + 1][0] == rows[k].at("metric").get<std::string>());
            CHECK(rows[k].at("participants") == 4);
            CHECK(rows[k].at("left_out").size() == 1);
            CHECK(rows[k].at("synthetic") == true);
            CHECK(std::stod(table[k + 1][1]) == rows[k].at("rho").get<double>());
            CHECK(rows[k].at("alpha").is_number());
        }
    }
}

TEST_CASE("study report: its scripts find every number again, and notice one that is another" *
          doctest::test_suite("long")) {
    const Reported study;
    REQUIRE(study.simulated().exit_code == 0);
    REQUIRE(study.reported({"--scaling", "standard"}).exit_code == 0);
    check_reproduced(study, true);
    if (shell("Rscript -e 'library(lme4)'").exit_code == 0) {
        const Ran mixed = shell("Rscript '" + study.report + "/mixed.R'");
        CHECK_MESSAGE(mixed.exit_code == 0, mixed.err);
        CHECK(contains(mixed.out, "SYNTHETIC"));
        CHECK(contains(mixed.out, "slope of pm"));
        CHECK(
            shell("Rscript '" + study.report + "/mixed.R' '" + study.report + "' none").exit_code !=
            0);
    }
    // A rating that was changed by hand.
    std::string answers = study.file("answers.csv");
    const std::size_t line = answers.find("\nS03,2,");
    REQUIRE(line != answers.npos);
    const std::size_t end = answers.rfind(',', answers.find('\n', line + 1));
    answers.replace(end + 1, answers.find('\n', line + 1) - end - 1, "-300");
    study.folder.write("report/answers.csv", answers);
    check_reproduced(study, false);
}

TEST_CASE("study report: of people who sorted, too" * doctest::test_suite("long")) {
    const Reported study;
    REQUIRE(study.simulated({"--sorting"}).exit_code == 0);
    const Ran ran = study.reported({"--sorting"});
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    CHECK(contains(study.file("report.html"), "by sorting them"));
    check_reproduced(study, true);
    const Ran compared =
        run_program({"compare", study.set, "--ratings", study.report, "--metric", "pm", "--json"});
    REQUIRE_MESSAGE(compared.exit_code == 0, compared.err);
    CHECK(Json::parse(compared.out)[0].at("participants") == 5);
}

TEST_CASE("study report: without participants it says where it looked, and makes nothing") {
    const Reported study;
    const Ran ran = study.reported();
    CHECK(ran.exit_code == 1);
    CHECK(contains(ran.err, "five study"));
    CHECK_FALSE(std::filesystem::exists(study.report));
}

}  // namespace study_report_test
