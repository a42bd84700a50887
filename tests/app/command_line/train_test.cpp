// tactspace train: parameters fitted to ratings, through the whole program.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/support/five_patterns.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace train_test {

using tact::five_patterns;
using Json = nlohmann::json;

namespace {

// Ratings that are the predictions of a model with planted parameters.
struct Planted {
    TemporaryFolder folder;
    std::string set = folder.write("five.tactspace.json", five_patterns()).string();
    std::string planted =
        folder
            .write("planted.tactspace.json",
                   five_patterns(R"(, "model": {"coding": {"excitatory_layers": 1},
                            "channel_weight": {"meissner": 1, "pacinian": 0.5, "ruffini": 0.5},
                            "nc_weight": 1, "oc_weight": 0.5})"))
            .string();
    std::string ratings = folder.write("said.csv", output_of({"predict", planted})).string();
    std::string out = (folder.path / "params.json").string();
};

}  // namespace

TEST_CASE("train: parameters planted in ratings are found, written and used by other commands") {
    const Planted study;
    const Json found =
        Json::parse(output_of({"train", study.set, "--ratings", study.ratings, "--scale",
                               "dissimilarity", "--step", "0.5", "--out", study.out, "--json"}));
    CHECK(found.at("value") == 1.0);
    CHECK(found.at("sets")[0].at("rho_after") == 1.0);
    CHECK(found.at("value_before").get<double>() < 1.0);
    CHECK(found.at("combinations") == 25 * 729);
    CHECK(found.at("ties").size() == found.at("equally_good_classes"));
    const Json file = Json::parse(bytes_of(study.out));
    CHECK(file.at("tactspace_model") == 1);
    CHECK(file.at("training").at("program").get<std::string>().starts_with("tactspace "));
    CHECK(file.at("training").at("sets")[0].at("name") == "five");
    CHECK(file.at("training").at("value") == 1.0);
    const Json compared =
        Json::parse(output_of({"compare", study.set, "--ratings", study.ratings, "--scale",
                               "dissimilarity", "--metric", "pm", "--model", study.out, "--json"}));
    CHECK(compared[0].at("rho") == 1.0);
}

TEST_CASE("train: a table for people, the same for any number of threads") {
    const Planted study;
    const std::vector<std::string> arguments{"train",   study.set,       "--ratings", study.ratings,
                                             "--scale", "dissimilarity", "--step",    "0.5"};
    const Ran ran = run_program(arguments);
    CHECK(ran.exit_code == 0);
    CHECK(ran.out.starts_with("mean rho 1.000, before "));
    CHECK(contains(ran.out, "searched 18,225 combinations, "));
    CHECK(contains(ran.out, "\ntrained "));
    CHECK(contains(ran.out, "\nfive "));
    auto alone = arguments;
    alone.insert(alone.end(), {"--threads", "1"});
    CHECK(output_of(alone) == ran.out);
}

TEST_CASE("train: leaves each of several sets out, and tries on it what fitted the others") {
    const Planted study;
    const Json found = Json::parse(
        output_of({"train", study.set, study.planted, "--ratings", study.ratings, study.ratings,
                   "--scale", "dissimilarity", "--step", "0.5", "--leave-out", "sets", "--json"}));
    REQUIRE(found.at("without_set").size() == 2);
    for (const Json& left_out : found.at("without_set")) CHECK(left_out.at("rho_after") == 1.0);
}

TEST_CASE("train: leaves each pattern out with its pairs, and says on what it was tried") {
    const Planted study;
    const std::string csv = (study.folder.path / "t.csv").string();
    std::vector<std::string> words{
        "train",  study.set, "--ratings", study.ratings, "--scale",     "dissimilarity",
        "--step", "0.5",     "--csv",     csv,           "--leave-out", "patterns"};
    const std::string text = output_of(words);
    CHECK(contains(text, "\nwithout pattern  "));
    CHECK(contains(text, "tried on the pairs with a vibration that the fit has not seen"));
    CHECK(contains(text, "nothing is drawn or resampled"));
    words.emplace_back("--json");
    const Json found = Json::parse(output_of(words));
    REQUIRE(found.at("without_pattern").size() == 5);
    const auto rows = cells_of(bytes_of(csv));
    REQUIRE(rows.size() == 1 + 1 + 5);
    for (std::size_t k = 0; k < 5; ++k) {
        const Json& one = found.at("without_pattern")[k];
        CHECK(one.at("value") == 1.0);
        CHECK(rows[k + 2][0] == "pattern");
        CHECK(rows[k + 2][1] == one.at("name").get<std::string>());
        CHECK(std::stod(rows[k + 2].back()) == one.at("rho_after").get<double>());
    }
}

TEST_CASE("train: says what is missing, and writes nothing then") {
    const Planted study;
    CHECK(contains(refusal_of({"train", study.set, "--out", study.out}),
                   "has no ratings of its own, expected --ratings FILE"));
    CHECK(contains(
        run_program({"train", study.set, "--ratings", study.ratings, "--leave-out", "sets"}).err,
        "expected several sets with ratings to leave one out, got one"));
    CHECK(contains(
        run_program({"train", study.set, "--ratings", study.ratings, "--leave-out", "participants"})
            .err,
        "expected ratings of several participants to leave one out"));
    const Ran step = run_program({"train", study.set, "--step", "0.3"});
    CHECK(step.exit_code == 2);
    CHECK(contains(step.err, "such as 0.1, got 0.3"));
    CHECK(contains(refusal_of({"predict", study.set, "--model", study.set}),
                   "is no file of model parameters"));
    CHECK_FALSE(std::filesystem::exists(study.out));
}

}  // namespace train_test
