// tactspace plan: a study before it is run, and a study held against its plan; what a study leaves
// for other programs.
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "model/io/studies_out/psych_ds.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace plan_command_test {

using Json = nlohmann::json;

namespace {

constexpr const char* kSet = R"({"tactspace": 1, "name": "six", "duration_s": 0.1, "patterns": [
    {"name": "v 1", "amplitude_g": 1.6}, {"name": "v 2", "carriers": [{"frequency_hz": 150}]},
    {"name": "v 3", "carriers": [{"frequency_hz": 250}]}, {"name": "v 4", "amplitude_g": 0.3},
    {"name": "v 5", "carriers": [{"frequency_hz": 40}]}, {"name": "v 6", "amplitude_g": 0.8}],
    "study": {"repetitions": 2, "attention_pairs": 3}})";

struct Planned {
    TemporaryFolder folder;
    std::string set = folder.write("six.json", kSet).string();

    std::string at(const std::string& name) const { return (folder.path / name).string(); }
    Ran plan(const std::vector<std::string>& more) const {
        std::vector<std::string> all{"plan", set, "--studies", "20"};
        all.insert(all.end(), more.begin(), more.end());
        return run_program(all);
    }
    void simulate(const std::string& people) const {
        REQUIRE(run_program({"study", set, "--simulate", people, "--out", at("people"), "--noise",
                             "15", "--seed", "4"})
                    .exit_code == 0);
    }
    std::string report(const std::vector<std::string>& more) const {
        std::vector<std::string> all{
            "study",    set,          "--collect", at("people"),
            "--report", at("report"), "--planned", at("plan/preregistration.json")};
        all.insert(all.end(), more.begin(), more.end());
        const Ran ran = run_program(all);
        REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
        return bytes_of(at("report/report.html"));
    }
};

}  // namespace

TEST_CASE("plan: how many people, said as a simulation and with what was assumed") {
    const Planned planned;
    const Ran ran = planned.plan({"--people", "3,6", "--csv", planned.at("t.csv")});
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    CHECK(contains(ran.out, "SIMULATED: nobody was asked"));
    CHECK(contains(ran.out, "a guess"));
    CHECK(contains(ran.out, "6 patterns, 15 pairs a person, 2 times each"));
    const std::string csv = bytes_of(planned.at("t.csv"));
    CHECK(std::ranges::count(csv, '\n') == 3);
    const Ran stated = planned.plan({"--people", "4", "--rho", "0.8", "--reliability", "0.6",
                                     "--pairs", "10", "--rival", "rmse", "--json"});
    REQUIRE_MESSAGE(stated.exit_code == 0, stated.err);
    const Json json = Json::parse(stated.out);
    CHECK(json.at("simulated") == true);
    CHECK(json.at("assumed").at("source") == "stated");
    CHECK(json.at("rival") == "rmse");
    CHECK(json.at("pairs") == 10);
    REQUIRE(json.at("studies").size() == 1);
    CHECK(json.at("studies")[0].at("power").contains("both"));
    CHECK(Json::parse(planned.plan({"--people", "2..30", "--json"}).out).at("studies").size() == 8);
}

TEST_CASE("plan: a pilot tells what people are like; its labels go on") {
    const Planned planned;
    planned.simulate("4");
    const Ran ran = planned.plan({"--people", "5", "--pilot", planned.at("people"), "--json"});
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    const Json json = Json::parse(ran.out);
    CHECK(json.at("assumed").at("source") ==
          "a pilot of 4 people; SYNTHETIC: nobody was asked for some or all of these");
    CHECK(json.at("assumed").at("reliability") > 0.3);
    CHECK(json.at("synthetic") == true);
}

TEST_CASE("plan: patterns that decide are written as a set of these") {
    const Planned planned;
    const std::string out = planned.at("decide.tactspace.json");
    const Ran ran = planned.plan({"--people", "3", "--decide", "4", "--out", out});
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    CHECK(contains(ran.out, "patterns on which pm and msm disagree most"));
    CHECK(Json::parse(bytes_of(out)).at("patterns").size() == 4);
}

TEST_CASE("plan: what cannot be planned is one sentence, and nothing is written") {
    const Planned planned;
    for (const auto& [options, words] :
         std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"--people", "0..5"}, "--people: expected"},
             {{"--people", "9..5"}, "--people: expected"},
             {{"--people", "five"}, "--people: expected"},
             {{"--people", "5,,6"}, "--people: expected"},
             {{"--pairs", "16"}, "the 15 pairs"},
             {{"--pairs", "some"}, "--pairs: expected"},
             {{"--rival", "pm"}, "another metric than pm"},
             {{"--decide", "7"}, "at most the 6 patterns"},
             {{"--people", "3,4", "--preregister", planned.at("plan")},
              "one number of --people"}}) {
        const Ran ran = planned.plan(options);
        CHECK(ran.exit_code == 1);
        CHECK_MESSAGE(contains(ran.err, words), ran.err);
        CHECK(ran.out.empty());
    }
    CHECK_FALSE(std::filesystem::exists(planned.at("plan")));
}

TEST_CASE("plan: a study is held against its preregistration, which is written once" *
          doctest::test_suite("long")) {
    const Planned planned;
    const std::vector<std::string> freeze{"--people", "4", "--preregister", planned.at("plan")};
    REQUIRE(planned.plan(freeze).exit_code == 0);
    const std::string page = bytes_of(planned.at("plan/preregistration.html"));
    CHECK(contains(page, "before anybody was asked"));
    CHECK(contains(page, "The rho of pm is above that of msm"));
    const Ran again = planned.plan(freeze);
    CHECK(again.exit_code == 1);
    CHECK(contains(again.err, "written once"));
    planned.simulate("4");
    CHECK(contains(planned.report({}), "Everything was done as it was planned"));
    // Someone is left out by hand: one fewer counts, too.
    const std::string other = planned.report({"--exclude", "S02"});
    CHECK(contains(other, "2 things depart"));
    CHECK(contains(other, "left out by hand"));
    // The set was edited since.
    std::string edited = kSet;
    edited.replace(edited.find("1.6"), 3, "1.5");
    planned.folder.write("six.json", edited);
    const Ran none =
        run_program({"study", planned.set, "--collect", planned.at("people"), "--report",
                     planned.at("report"), "--planned", planned.at("nowhere.json")});
    CHECK(none.exit_code == 1);
    CHECK(contains(none.err, "nowhere.json"));
}

TEST_CASE("study: a dataset that an archive reads, and matrices that NumPy reads" *
          doctest::test_suite("long")) {
    for (const bool is_sorting : {false, true}) {
        const Planned planned;
        std::vector<std::string> simulate{"study", planned.set, "--simulate",
                                          "3",     "--out",     planned.at("people")};
        std::vector<std::string> collect{
            "study",      planned.set,      "--collect", planned.at("people"),
            "--psych-ds", planned.at("ds"), "--rdms",    planned.at("r.npz")};
        for (auto* command : {&simulate, &collect}) {
            if (is_sorting) command->push_back("--sorting");
            const Ran ran = run_program(*command);
            REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
        }
        std::vector<tact::DatasetFile> files;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(planned.at("ds"))) {
            if (!entry.is_regular_file()) continue;
            const auto path = std::filesystem::relative(entry.path(), planned.at("ds"));
            files.push_back({path.generic_string(), bytes_of(entry.path().string())});
        }
        CHECK(files.size() == 5);
        CHECK(tact::psych_ds_faults(files).empty());
        // No column is described by nothing but its own name.
        const auto about =
            std::ranges::find(files, "dataset_description.json", &tact::DatasetFile::path);
        for (const Json& one : Json::parse(about->text).at("variableMeasured")) {
            CHECK_MESSAGE(one.at("description") != one.at("name"), one.at("name"));
        }
        const Ran again = run_program(collect);
        CHECK(again.exit_code == 1);
        CHECK(contains(again.err, "empty or not there"));
        const Ran numpy = run_program(
            {}, "exec /usr/bin/python3 -c \"import numpy; a = numpy.load('" + planned.at("r.npz") +
                    "'); assert a['dissimilarities'].shape == (3, 15); "
                    "assert list(a['patterns'])[1] == 'v 2'; assert a['synthetic'] == 1\"");
        CHECK_MESSAGE(numpy.exit_code == 0, numpy.err);
    }
}

TEST_CASE("study: packed for another program, asked there, and who counts is decided here" *
          doctest::test_suite("long")) {
    const Planned planned;
    const auto study = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"study", planned.set});
        return run_program(more);
    };
    for (const char* program : {"jspsych", "psychopy"}) {
        const Ran ran =
            study({"--pack", program, "--participants", "3", "--out", planned.at(program)});
        REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    }
    // Each participant has the trials that the window would ask: 15 pairs twice, 3 of identical.
    const std::string trials = bytes_of(planned.at("psychopy/trials.csv"));
    CHECK(std::ranges::count(trials, '\n') == 1 + 3 * 33);
    CHECK(contains(bytes_of(planned.at("jspsych/study.js")), "\"P03\""));
    CHECK(std::filesystem::exists(planned.at("jspsych/stimuli/04-v 4.wav")));
    CHECK(study({"--pack", "psychopy", "--out", planned.at("psychopy")}).exit_code == 1);
    // The script asks; without a screen it simulates, which stays marked.
    for (const char* person : {"P01", "P02"}) {
        const Ran asked =
            run_program({}, "exec /usr/bin/python3 '" + planned.at("psychopy/experiment.py") +
                                "' " + person + " --simulate");
        REQUIRE_MESSAGE(asked.exit_code == 0, asked.err);
    }
    const Ran unpacked =
        study({"--unpack", planned.at("psychopy/answers"), "--out", planned.at("back")});
    REQUIRE_MESSAGE(unpacked.exit_code == 0, unpacked.err);
    const Ran collected = study({"--collect", planned.at("back"), "--json"});
    REQUIRE_MESSAGE(collected.exit_code == 0, collected.err);
    CHECK(contains(collected.out, "P02"));
    CHECK(contains(collected.out, "\"synthetic\":true"));
    CHECK_FALSE(contains(collected.err, "have changed"));
    // Who misses identical pairs is left out, as anybody is.
    std::string answers = bytes_of(planned.at("psychopy/answers/P01.csv"));
    std::string missed;
    std::istringstream lines(answers);
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.back() == '\r') line.pop_back();
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
        if (cells.at(7) == "1") cells.at(5) = "10";
        cells.at(0) = cells.at(0) == "participant" ? cells.at(0) : "P09";
        for (std::size_t k = 0; k < cells.size(); ++k) missed += (k == 0 ? "" : ",") + cells[k];
        missed += "\n";
    }
    planned.folder.write("missed.csv", missed);
    REQUIRE(study({"--unpack", planned.at("missed.csv"), "--out", planned.at("back")}).exit_code ==
            0);
    const Ran again = study({"--collect", planned.at("back")});
    CHECK_MESSAGE(contains(again.out, "pairs rated by 2 of 3 participants"), again.out);
    // Twice the same participant, or a stranger's pattern, is refused with its line.
    CHECK(study({"--unpack", planned.at("missed.csv"), "--out", planned.at("back")}).exit_code ==
          1);
    missed.replace(missed.find("v 1"), 3, "v 9");
    planned.folder.write("missed.csv", missed);
    const Ran strange =
        study({"--unpack", planned.at("missed.csv"), "--out", planned.at("elsewhere")});
    CHECK(strange.exit_code == 1);
    CHECK_MESSAGE(contains(strange.err, "missed.csv:"), strange.err);
    CHECK_FALSE(std::filesystem::exists(planned.at("elsewhere")));
}

}  // namespace plan_command_test
