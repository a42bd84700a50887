// tactspace study: simulated participants and collected ratings, through the whole program.
#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace study_command_test {

using Json = nlohmann::json;

namespace {

constexpr const char* kSet = R"({"tactspace": 1, "name": "five", "duration_s": 0.1, "patterns": [
    {"name": "v 1", "amplitude_g": 1.6}, {"name": "v 2", "carriers": [{"frequency_hz": 150}]},
    {"name": "v 3", "carriers": [{"frequency_hz": 250}]}, {"name": "v 4", "amplitude_g": 0.3},
    {"name": "v 5", "carriers": [{"frequency_hz": 40}]}],
    "study": {"repetitions": 3, "attention_pairs": 2}})";

constexpr const char* kTruth =
    ",v 1,v 2,v 3,v 4,v 5\nv 1,0,10,20,30,40\nv 2,10,0,50,60,70\nv 3,20,50,0,80,90\n"
    "v 4,30,60,80,0,100\nv 5,40,70,90,100,0\n";

struct Study {
    TemporaryFolder folder;
    std::string set = folder.write("five.json", kSet).string();
    std::string truth = folder.write("truth.csv", kTruth).string();
    std::string people = (folder.path / "people").string();

    Ran simulated(std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"study",  set,    "--simulate",    "6",
                                           "--out",  people, "--from-matrix", truth,
                                           "--seed", "3"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_program(arguments);
    }
    Json collected(std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"study", set, "--collect", people, "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return Json::parse(output_of(arguments));
    }
};

}  // namespace

TEST_CASE("study: simulated without noise, collected, compared: the matrix they were made from") {
    const Study study;
    const Ran ran = study.simulated({"--noise", "0"});
    CHECK_MESSAGE(ran.exit_code == 0, ran.err);
    CHECK(contains(ran.err, "6 synthetic participants"));
    CHECK(contains(bytes_of(study.people + "/S01.jsonl"), "\"synthetic\":true"));
    const std::string csv = (study.folder.path / "ratings.csv").string();
    const std::string matrix = (study.folder.path / "mean.csv").string();
    const Json all = study.collected({"--out", csv, "--matrix", matrix});
    CHECK(all.at("synthetic") == true);
    CHECK(all.at("counted") == 6);
    CHECK(all.at("ceiling_of_mean").get<double>() > 0.98);
    CHECK(all.at("labels").size() == 5);
    // Each has their own use of the scale, which moves all pairs alike.
    const auto mean = all.at("condensed").get<std::vector<double>>();
    for (std::size_t p = 1; p < mean.size(); ++p) CHECK(mean[p] > mean[p - 1]);
    CHECK(cells_of(bytes_of(csv)).size() == 1 + 6 * (10 * 3 + 2));
    const std::vector<double> from_matrix = condensed_in(bytes_of(matrix));
    for (const std::string& file : {csv, matrix}) {
        const Ran compared =
            run_program({"compare", study.set, "--ratings", file, "--metric", "pm", "--json"});
        CHECK_MESSAGE(compared.exit_code == 0, compared.err);
        CHECK(Json::parse(compared.out)[0].at("synthetic") == true);
    }
    for (std::size_t p = 0; p < mean.size(); ++p) CHECK(from_matrix[p] == mean[p]);
}

TEST_CASE("study: the same seed makes the same participants, and none is written over") {
    const Study one;
    const Study two;
    REQUIRE(one.simulated().exit_code == 0);
    REQUIRE(two.simulated().exit_code == 0);
    CHECK(bytes_of(one.people + "/S04.jsonl") == bytes_of(two.people + "/S04.jsonl"));
    CHECK(bytes_of(one.people + "/S04.jsonl") != bytes_of(one.people + "/S05.jsonl"));
    const Ran again = one.simulated();
    CHECK(again.exit_code == 1);
    CHECK(contains(again.err, "is there already"));
}

TEST_CASE("study: who answers blindly is left out, unless the rule says otherwise") {
    const Study study;
    REQUIRE(study.simulated({"--inattentive", "0.34", "--attention", "5"}).exit_code == 0);
    const Json strict = study.collected();
    CHECK(strict.at("counted") == 4);
    CHECK(strict.at("participants")[5].at("excluded").is_string());
    CHECK(study.collected({"--above", "0", "--failures", "5"}).at("counted") == 6);
    const std::string text = output_of({"study", study.set, "--collect", study.people});
    CHECK(
        text.starts_with("pairs rated by 4 of 6 participants, 2 participants left out; "
                         "SYNTHETIC: nobody was asked\n"));
    CHECK(contains(text, "S06 is not counted: identical patterns rated "));
    const std::string csv = (study.folder.path / "all.csv").string();
    study.collected({"--everyone", "--out", csv});
    CHECK(contains(bytes_of(csv), "\nS06,1,"));
    // The others of the same file do not count for the metrics either, unless by name.
    const std::vector<std::string> compare{"compare",  study.set, "--ratings", csv,
                                           "--metric", "rmse",    "--json"};
    const Json row = Json::parse(output_of(compare))[0];
    CHECK(row.at("participants") == 4);
    CHECK(row.at("left_out").size() == 2);
    CHECK(row.at("left_out")[1].at("participant") == "S06");
    CHECK(row.at("synthetic") == true);
    auto with = compare;
    with.insert(with.end(), {"--include", "S06"});
    CHECK(Json::parse(output_of(with))[0].at("participants") == 5);
    const Ran folder = run_program(
        {"compare", study.set, "--ratings", study.people, "--metric", "rmse", "--json"});
    CHECK(Json::parse(folder.out)[0].at("participants") == 4);
    CHECK(contains(folder.err, "S06 is not counted: identical patterns rated "));
    const Json trained =
        Json::parse(output_of({"train", study.set, "--ratings", csv, "--step", "0.5", "--json"}));
    CHECK(trained.at("sets")[0].at("participants") == 4);
    CHECK(trained.at("synthetic") == true);
    CHECK(study.collected({"--include", "S05", "S06"}).at("counted") == 6);
    CHECK(study.collected({"--exclude", "S01"}).at("counted") == 3);
}

TEST_CASE("study: adaptive and sorting studies are told apart from the full design") {
    const Study study;
    REQUIRE(study.simulated({"--adaptive", "--repetitions", "1"}).exit_code == 0);
    CHECK(study.collected().at("order") == "adaptive");
    CHECK(contains(output_of({"study", study.set, "--collect", study.people}), "adaptive order"));
    const Study sorting;
    REQUIRE(sorting.simulated({"--sorting"}).exit_code == 0);
    CHECK(contains(refusal_of({"study", sorting.set, "--collect", sorting.people}), "--sorting"));
    const Json sorted = sorting.collected({"--sorting"});
    CHECK(sorted.at("kind") == "sorting");
    CHECK(sorted.at("condensed").size() == 10);
}

TEST_CASE("study: what cannot be done is said in a sentence") {
    const Study study;
    CHECK(run_program({"study", study.set}).exit_code == 2);
    CHECK(run_program({"study", study.set, "--simulate", "2", "--collect", "x"}).exit_code == 2);
    CHECK(run_program({"study", study.set, "--simulate", "2"}).exit_code == 2);
    CHECK(contains(refusal_of({"study", study.set, "--collect", study.people}), "cannot be read"));
    const std::string odd = study.folder.write("odd.csv", "1,2\n3,4\n").string();
    CHECK(contains(refusal_of({"study", study.set, "--simulate", "2", "--out", study.people,
                               "--from-map", odd}),
                   "got none of \"v 1\""));
    REQUIRE(study.simulated().exit_code == 0);
    const std::string other =
        study.folder
            .write("other.json", R"({"tactspace": 1, "patterns": [{"name": "x"},
            {"name": "y"}, {"name": "z"}]})")
            .string();
    CHECK(contains(refusal_of({"study", other, "--collect", study.people}),
                   "has answers about \"v 1\", expected patterns of the set"));
}

TEST_CASE("study: who is excluded with a reason stays so for all commands, until included again") {
    const Study study;
    REQUIRE(study.simulated({"--noise", "0"}).exit_code == 0);
    const std::string set = study.set;
    const std::string people = study.people;
    const auto compared = [&](std::vector<std::string> more) {
        std::vector<std::string> all{"compare",  set,    "--ratings", people,
                                     "--metric", "rmse", "--json"};
        all.insert(all.end(), more.begin(), more.end());
        return run_program(all);
    };
    const Ran excluded = compared({"--exclude", "S02", "--because", "asleep"});
    REQUIRE_MESSAGE(excluded.exit_code == 0, excluded.err);
    CHECK(contains(excluded.err, "S02 is recorded as excluded in "));
    const Json row = Json::parse(compared({}).out)[0];
    CHECK(row.at("participants") == 5);
    CHECK(row.at("left_out")[0].at("why") == "excluded by name: asleep");
    CHECK(study.collected().at("counted") == 5);
    const Json trained =
        Json::parse(output_of({"train", set, "--ratings", people, "--step", "0.5", "--json"}));
    CHECK(trained.at("sets")[0].at("participants") == 5);
    // Without a reason it is so this once.
    CHECK(study.collected({"--exclude", "S03"}).at("counted") == 4);
    CHECK(study.collected().at("counted") == 5);
    CHECK(study.collected({"--include", "S02"}).at("counted") == 6);
    CHECK(Json::parse(compared({}).out)[0].at("participants") == 6);
    const Ran reason_alone = run_program({"study", set, "--collect", people, "--because", "x"});
    CHECK(reason_alone.exit_code == 2);
    CHECK(contains(reason_alone.err, "--because requires --exclude"));
}

TEST_CASE("study: rules on how people answer are named by the commands, with who fell by them") {
    const Study study;
    REQUIRE(study.simulated({"--inattentive", "0.17"}).exit_code == 0);
    const Ran ran = run_program({"compare", study.set, "--ratings", study.people, "--metric",
                                 "rmse", "--repeat-rho", "0.3", "--too-fast", "2"});
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    CHECK(contains(ran.err, "rule: own repetitions agree with rho 0.3 at least; S06 fell by it"));
    CHECK(contains(ran.err, "in under 2 s; nobody falls by it"));
    // What knows nothing of times refuses instead of letting all pass.
    const std::string csv = study.folder.write("r.csv", "a,b,rating\nv 1,v 2,3\n").string();
    CHECK(contains(refusal_of({"compare", study.set, "--ratings", csv, "--too-fast", "2"}),
                   "expected the folder of a study"));
}

TEST_CASE("study: nobody is added to a folder by another design, and what is other is named") {
    const Study study;
    REQUIRE(study.simulated().exit_code == 0);
    std::filesystem::remove(study.people + "/S06.jsonl");
    const Ran other = study.simulated({"--repetitions", "2"});
    CHECK(other.exit_code == 1);
    CHECK(contains(other.err, "repetitions 2, not 3"));
    CHECK(!std::filesystem::exists(study.people + "/S06.jsonl"));
    // One who is there all the same does not count.
    const std::string aside = (study.folder.path / "aside").string();
    REQUIRE(run_program({"study", study.set, "--simulate", "6", "--out", aside, "--from-matrix",
                         study.truth, "--repetitions", "2"})
                .exit_code == 0);
    std::filesystem::copy(aside + "/S06.jsonl", study.people + "/S06.jsonl");
    const Json all = study.collected();
    CHECK(all.at("counted") == 5);
    CHECK(contains(all.at("participants")[5].at("excluded").get<std::string>(),
                   "another study than S01's: repetitions 2, not 3"));
    CHECK(study.collected({"--include", "S06"}).at("counted") == 6);
    const std::string report = (study.folder.path / "report").string();
    REQUIRE(run_program({"study", study.set, "--collect", study.people, "--report", report})
                .exit_code == 0);
    CHECK(contains(bytes_of(report + "/report.html"), "repetitions 2, not 3"));
    const Ran compared =
        run_program({"compare", study.set, "--ratings", study.people, "--metric", "pm"});
    CHECK(contains(compared.out, "repetitions 2, not 3"));
}

TEST_CASE("study: help and plan say what identical pairs are worth") {
    CHECK(contains(run_program({"study", "--help"}).out, "20 % pass 1, 0.78 % pass 3"));
}

TEST_CASE("study: whoever compares or trains is told that rated patterns were edited since") {
    const Study study;
    REQUIRE(study.simulated().exit_code == 0);
    const std::vector<std::string> compare{"compare",    study.set,  "--ratings",
                                           study.people, "--metric", "rmse"};
    CHECK_FALSE(contains(output_of(compare), "CHANGED"));
    std::string text = kSet;
    text.replace(text.find("0.3"), 3, "0.2");
    study.folder.write("five.json", text);
    CHECK(contains(output_of(compare), "CHANGED: some or all of these patterns are others"));
    const Json trained = Json::parse(
        output_of({"train", study.set, "--ratings", study.people, "--step", "0.5", "--json"}));
    CHECK(trained.at("sets")[0].at("changed_since_felt") == true);
}

TEST_CASE("study: ratings of what is gone are left out by all commands, and that is said") {
    const Study study;
    REQUIRE(study.simulated().exit_code == 0);
    const std::string csv = (study.folder.path / "ratings.csv").string();
    study.collected({"--out", csv});
    std::string text = kSet;
    const auto first = text.find("{\"name\": \"v 1\"");
    text.erase(first, text.find("{\"name\": \"v 2\"") - first);
    text.replace(text.find("0.3"), 3, "0.2");  // and v 4 is another
    study.folder.write("five.json", text);
    for (const std::string& from : {study.people, csv}) {
        const Json row = Json::parse(
            output_of({"compare", study.set, "--ratings", from, "--metric", "rmse", "--json"}))[0];
        CHECK(row.at("gone_since_felt") == Json{"v 1"});
    }
    const Ran compared =
        run_program({"compare", study.set, "--ratings", study.people, "--metric", "rmse"});
    CHECK(contains(compared.out, "1 pattern was edited since it was rated: \"v 4\""));
    CHECK(contains(compared.out, "left out: \"v 1\""));
    const Json picked = Json::parse(
        output_of({"subset", study.set, "-k", "2", "--ratings", study.people, "--json"}));
    CHECK(picked.at("edited_since_felt") == Json{"v 4"});
    CHECK(picked.at("gone_since_felt") == Json{"v 1"});
    const std::string map = (study.folder.path / "map.csv").string();
    REQUIRE(run_program({"space", study.set, "--ratings", study.people, "--out", map}).exit_code ==
            0);
    CHECK(contains(bytes_of(map), "edited since it was rated"));
}

}  // namespace study_command_test
