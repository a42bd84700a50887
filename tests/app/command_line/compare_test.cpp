// tactspace compare: metrics against ratings, through the whole program.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/evaluation/metric.h"
#include "model/io/set/set_file.h"
#include "tests/support/five_patterns.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace compare_test {

using tact::five_patterns;
using Json = nlohmann::json;

namespace {

struct Study {
    TemporaryFolder folder;
    std::string set = folder.write("five.tactspace.json", five_patterns()).string();
    std::string ratings =
        folder.write("mean.csv", output_of({"predict", set, "--metric", "nc"})).string();

    std::string written(const std::string& name, const std::string& text) const {
        return folder.write(name, text).string();
    }

    // Their similarities in one file.
    std::string three_people() const {
        std::string lines = "participant,a,b,rating\n";
        const char* const names[] = {"v 1", "v 2", "v 3", "v 10", "v 11"};
        const int similar[] = {90, 70, 60, 50, 40, 30, 80, 20, 65, 10};
        for (int person = 0; person < 3; ++person) {
            int p = 0;
            for (int i = 0; i < 5; ++i) {
                lines += "P" + std::to_string(person) + "," + names[i] + "," + names[i] + ",99\n";
                for (int j = i + 1; j < 5; ++j, ++p) {
                    lines += "P" + std::to_string(person) + "," + names[j] + "," + names[i] + "," +
                             std::to_string(similar[p] + (person * p * 3) % 7) + "\n";
                }
            }
        }
        return written("people/all.csv", lines);
    }
};

}  // namespace

TEST_CASE("compare: ratings that are a metric's own numbers agree with it in every way") {
    const Study study;
    const Json all = Json::parse(output_of(
        {"compare", study.set, "--ratings", study.ratings, "--scale", "dissimilarity", "--json"}));
    REQUIRE(all.size() == tact::kMetricCount);
    CHECK(all[0].at("metric") == "pm");
    for (const Json& row : all) {
        for (const char* key : {"rho", "rho_low", "rho_high", "p", "K", "K_chance", "K_p"}) {
            CHECK_MESSAGE(row.contains(key), key);
        }
        CHECK(row.at("set") == "five");
        if (row.at("metric") != "nc") continue;
        CHECK(row.at("rho") == 1.0);
        CHECK(row.at("p") == 1.0 / 120.0);
        CHECK(row.at("K").get<double>() <= 1e-6);
        CHECK(row.at("reliability").is_null());
    }
}

TEST_CASE(
    "compare: --out is what would be printed, and a folder that is not there is said at once") {
    const Study study;
    const std::string out = (study.folder.path / "answer").string();
    std::vector<std::string> words{"compare",       study.set, "--ratings", study.ratings,
                                   "--rendered-by", "joy-con", "--level",   "0.5",
                                   "--metric",      "nc"};
    const Ran printed = run_program(words);
    REQUIRE(printed.exit_code == 0);
    CHECK(contains(printed.out,
                   "the patterns as a Joy-Con plays them at a level of 50 %, uncalibrated: full "
                   "scale stands for 1.00 g\n"));
    words.insert(words.end(), {"--out", out});
    CHECK(output_of(words).empty());
    CHECK(bytes_of(out) == printed.out);
    words.emplace_back("--json");
    CHECK(output_of(words).empty());
    const Json row = Json::parse(bytes_of(out)).at(0);
    CHECK(row.at("rendered_by") == "joy-con");
    CHECK(row.at("calibrated") == false);
    CHECK(row.at("full_scale_g") == 1.0);
    CHECK(row.at("level") == 0.5);
    CHECK(row.at("synthetic_patterns") == false);
    CHECK(row.at("synthetic_model") == false);
    words[words.size() - 2] = (study.folder.path / "no" / "such").string();
    CHECK(contains(refusal_of(words), "cannot be written"));
}

TEST_CASE("compare: a set whose model was fitted to what nobody said says so, as --model does") {
    const Study study;
    auto loaded = *tact::read_set_file(study.set);
    loaded.set.model.nc_weight = 0.3;
    loaded.set.model_origin = {"Trained on drawn.", true, false};
    REQUIRE(tact::write_set_file(study.set, loaded.set));
    const std::vector<std::string> words{"compare", study.set,  "--ratings", study.ratings,
                                         "--json",  "--metric", "pm"};
    const Ran ran = run_program(words);
    REQUIRE(ran.exit_code == 0);
    CHECK(Json::parse(ran.out).at(0).at("synthetic_model") == true);
    CHECK(contains(ran.err, "nobody was asked"));
}

TEST_CASE("compare: twins that were computed are said to be, also where a device plays them" *
          doctest::test_suite("long")) {
    const Study study;
    const std::string out = (study.folder.path / "twins.tactspace.json").string();
    output_of({"measure", study.set, "--simulate", "--out", out});
    for (const bool is_played : {false, true}) {
        std::vector<std::string> words{"compare", out,        "--ratings", study.ratings,
                                       "--only",  "measured", "--metric",  "nc"};
        if (is_played) words.insert(words.end(), {"--rendered-by", "joy-con"});
        CHECK(contains(output_of(words),
                       "SYNTHETIC: some or all of these patterns were measured by nobody\n"));
        words.emplace_back("--json");
        const Json row = Json::parse(output_of(words)).at(0);
        CHECK(row.at("synthetic_patterns") == true);
        CHECK(row.at("only") == "measured");
        words[5] = "intended";
        CHECK(Json::parse(output_of(words)).at(0).at("synthetic_patterns") == false);
    }
}

TEST_CASE("compare: a table for people, with remarks apart, the same for any number of threads") {
    const Study study;
    const Ran ran = run_program(
        {"compare", study.set, "--ratings", study.ratings, "--metric", "pm", "nc", "oc"});
    CHECK(ran.exit_code == 0);
    CHECK(ran.out.starts_with("five: 5 patterns, 10 of 10 pairs rated\n"));
    CHECK(contains(ran.out, "\nmetric "));
    CHECK(contains(ran.out, "\nnc      1.000"));
    CHECK(contains(ran.out, "any ratings fit in 3 dimensions"));
    CHECK(contains(ran.err, "mean.csv: taken as dissimilarities"));
    CHECK(output_of({"compare", study.set, "--ratings", study.ratings, "--metric", "pm", "nc", "oc",
                     "--threads", "1"}) == ran.out);
    const std::string only =
        output_of({"compare", study.set, "--ratings", study.ratings, "--metric", "oc"});
    CHECK(contains(only, "\noc "));
    CHECK_FALSE(contains(only, "\npm "));
}

TEST_CASE("compare: participants in one file or in many, and how far they agree") {
    const Study study;
    const std::string file = study.three_people();
    const Ran ran =
        run_program({"compare", study.set, "--ratings", file, "--metric", "pm", "--json"});
    CHECK(contains(ran.err, "taken as similarities from 0 to 100"));
    const Json all = Json::parse(ran.out);
    CHECK(all[0].at("reliability").get<double>() > 0.9);
    CHECK(contains(output_of({"compare", study.set, "--metric", "pm", "--ratings", file}),
                   "rated, 3 participants\n"));
    // Alike is not unlike: the other scale turns every rho.
    const Json turned = Json::parse(output_of({"compare", study.set, "--ratings", file, "--scale",
                                               "dissimilarity", "--metric", "pm", "--json"}));
    CHECK(std::abs(all[0].at("rho").get<double>() + turned[0].at("rho").get<double>()) <= 1e-12);
}

TEST_CASE("compare: every table ends in what it was made by, and --methods is for a paper") {
    const Study study;
    const std::string file = study.three_people();
    const std::string text = output_of({"compare", study.set, "--ratings", file, "--metric", "pm",
                                        "nc", "oc", "--given", "level", "duration", "--methods"});
    // Five patterns: all orders are tried.
    CHECK(contains(text, "p: Mantel, one-sided, all orders of the patterns\n"));
    CHECK(contains(text, "no p of this table is corrected for 3 metrics\n"));
    CHECK(contains(text, "bootstrap over patterns, all ways to draw them, maps not made again"));
    CHECK(contains(text, "jackknife of 3, Student's t of 2"));
    CHECK(contains(text, "Holm: p corrected for 2 differences\n"));
    CHECK(contains(text, "(Nili et al. 2014)"));
    CHECK(contains(text, "\n(ceiling) "));
    CHECK(contains(text, "\none person    the best there could be has a mean rho of "));
    CHECK(contains(text, "\n(that alone) "));
    CHECK(contains(text, "\nReferences\nBorg, I. & Leutner, D. (1985)."));
    CHECK(run_program({"compare", study.set, "--ratings", file, "--methods", "--json"}).exit_code ==
          2);
}

TEST_CASE("compare: tables for other programs have a row an observation, and say whose it is") {
    const Study study;
    const std::string file = study.three_people();
    const auto at = [&study](const char* name) { return (study.folder.path / name).string(); };
    const std::vector<std::string> words{"compare",
                                         study.set,
                                         "--ratings",
                                         file,
                                         "--metric",
                                         "pm",
                                         "nc",
                                         "--csv",
                                         at("metrics.csv"),
                                         "--people-csv",
                                         at("p.csv"),
                                         "--given",
                                         "level",
                                         "--json",
                                         "--differences-csv",
                                         at("differences.csv")};
    const Json rows = Json::parse(output_of(words));
    const auto metrics = cells_of(bytes_of(at("metrics.csv")));
    REQUIRE(metrics.size() == 3);
    const auto cell = [](const std::vector<std::vector<std::string>>& table, std::size_t row,
                         const std::string& name) {
        const auto found = std::ranges::find(table[0], name);
        REQUIRE_MESSAGE(found != table[0].end(), name);
        return table[row][static_cast<std::size_t>(found - table[0].begin())];
    };
    for (std::size_t m = 0; m < 2; ++m) {
        CHECK(metrics[m + 1].size() == metrics[0].size());
        CHECK(std::stod(cell(metrics, m + 1, "rho")) == rows[m].at("rho").get<double>());
        CHECK(std::stod(cell(metrics, m + 1, "rho_given_level")) ==
              rows[m].at("given").at("level").at("rho").get<double>());
        // Three people and five patterns may leave an error unknown: then the reason is there.
        const Json& people = rows[m].at("rho_resampled").at("people");
        CHECK(people.at("se").is_null() == people.contains("not_known"));
        const std::string error = cell(metrics, m + 1, "rho_people_se");
        CHECK((people.at("se").is_null() ? error.empty()
                                         : std::stod(error) == people.at("se").get<double>()));
        CHECK(cell(metrics, m + 1, "rho_people_not_known") == people.value("not_known", ""));
        CHECK(cell(metrics, m + 1, "participants") == "3");
        CHECK(cell(metrics, m + 1, "synthetic") == "0");
    }
    const auto people = cells_of(bytes_of(at("p.csv")));
    REQUIRE(people.size() == 1 + 3 * 2);
    CHECK(cell(people, 1, "participant") == "P0");
    CHECK(cell(people, 2, "metric") == "nc");
    const auto differences = cells_of(bytes_of(at("differences.csv")));
    REQUIRE(differences.size() == 1 + 3);
    CHECK(cell(differences, 3, "resampled") == "both");
    CHECK(std::stod(cell(differences, 1, "rho_difference")) ==
          rows[0].at("rho").get<double>() - rows[1].at("rho").get<double>());
    const Json& both = rows[1].at("pm_less_this").at("both");
    CHECK(both.at("p").is_null() == both.contains("not_known"));
    CHECK(cell(differences, 3, "not_known") == both.value("not_known", ""));
    CHECK_FALSE(rows[0].contains("pm_less_this"));
}

TEST_CASE("compare: a nuisance is one by name, or a matrix with the patterns' names") {
    const Study study;
    const std::string oc =
        study.written("own oc.csv", output_of({"predict", study.set, "--metric", "oc"}));
    const Json rows =
        Json::parse(output_of({"compare", study.set, "--ratings", study.three_people(), "--metric",
                               "oc", "nc", "--given", oc, "--json"}));
    // Nothing is left of what is given; what prints ties as ties is the metric itself.
    CHECK(rows[0].at("given").at("own oc").at("rho").is_null());
    CHECK(rows[0].at("given").at("own oc").at("rho_alone") == rows[0].at("rho"));
    CHECK_FALSE(rows[1].at("given").at("own oc").at("rho").is_null());
    CHECK(contains(refusal_of({"compare", study.set, "--ratings", study.ratings, "--scale",
                               "dissimilarity", "--given", "size"}),
                   "size: there is no such file"));
}

TEST_CASE("compare --paper-mode: a K that is missing says why") {
    const Study study;
    const std::string alike = study.written(
        "alike.json",
        five_patterns(R"(, "ratings": [{"name": "us", "labels": ["v 11", "v 10", "v 3",
            "v 2", "v 1"], "condensed": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]}])"));
    for (const Json& row : Json::parse(output_of({"compare", alike, "--paper-mode", "--json"}))) {
        if (!row.at("K").is_null()) continue;
        const std::string key = row.at("metric");
        CHECK_MESSAGE(contains(output_of({"compare", alike, "--paper-mode", "--metric", key}),
                               "\n" + key + ": no K"),
                      key);
    }
}

TEST_CASE("compare: several sets, each with its ratings, and their means") {
    const Study study;
    const std::string flat =
        study.written("flat.csv",
                      ",v 1,v 2,v 3,v 10,v 11\nv 1,0,1,2,3,4\nv 2,1,0,5,6,7\nv 3,2,5,0,8,9\n"
                      "v 10,3,6,8,0,10\nv 11,4,7,9,10,0\n");
    const std::vector<std::string> arguments{
        "compare", study.set, study.set, "--metric", "pm", "nc", "--ratings", study.ratings, flat};
    auto with = arguments;
    with.push_back("--json");
    const Json all = Json::parse(output_of(with));
    const std::size_t metrics = all.size() / 3;
    REQUIRE(all.size() == 3 * metrics);
    for (std::size_t k = 0; k < metrics; ++k) {
        const double mean =
            (all[k].at("rho").get<double>() + all[metrics + k].at("rho").get<double>()) / 2.0;
        CHECK(all[2 * metrics + k].at("mean_of_sets") == 2);
        CHECK(std::abs(all[2 * metrics + k].at("rho").get<double>() - mean) <= 1e-12);
    }
    CHECK(contains(output_of(arguments), "\nmeans over 2 sets; undefined ones are left out\n"));
    with = arguments;
    with.push_back("--paper-mode");
    CHECK(contains(output_of(with),
                   "\nmeans over 2 sets, as in Table 2: of |rho|, undefined ones as 0"));
    CHECK(refusal_of({"compare", study.set, study.set, "--ratings", flat}) ==
          "tactspace: expected a file or a folder of ratings for each of the 2 sets, got 1\n");
}

TEST_CASE("compare: ratings in the set file serve where none are named") {
    const Study study;
    const std::string own = study.written(
        "own.json", five_patterns(R"(, "ratings": [{"name": "us", "labels": ["v 11", "v 10", "v 3",
            "v 2", "v 1"], "condensed": [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]}])"));
    CHECK(output_of({"compare", own, "--metric", "oc"})
              .starts_with("five: 5 patterns, 10 of 10 pairs rated\n"));
    CHECK(refusal_of({"compare", study.set}) ==
          "tactspace: " + study.set + ": has no ratings of its own, expected --ratings FILE\n");
}

TEST_CASE("compare: ratings of other patterns are refused by name") {
    const Study study;
    const auto refusal = [&](const std::string& text) {
        const std::string file = study.written("odd.csv", text);
        const std::string sentence =
            refusal_of({"compare", study.set, "--ratings", file, "--scale", "dissimilarity"});
        const std::string head = "tactspace: " + file + ": ";
        CHECK_MESSAGE(sentence.starts_with(head), sentence);
        return sentence.substr(std::min(head.size(), sentence.size()));
    };
    CHECK(refusal("a,b,rating\nv 1,v 2,3\n") ==
          "expected ratings of at least three patterns of the set, got those of 2\n");
    const Json some = Json::parse(
        output_of({"compare", study.set, "--metric", "rmse", "--json", "--ratings",
                   study.written("some.csv", "a,b,rating\nv 1,v 2,3\nv 3,v 10,4\nv 1,v 3,9\n"),
                   "--scale", "dissimilarity"}));
    CHECK(some[0].at("unrated_patterns") == Json::array({"v 11"}));
    CHECK(refusal("1,2,3\n") == "expected ratings of 5 patterns, as many as the set has, got 3\n");
    CHECK(contains(refusal_of({"compare", study.set, "--ratings",
                               study.written("same.csv", "1,1,1,1,1,1,1,1,1,1\n"), "--scale",
                               "dissimilarity"}),
                   "five: expected ratings that differ, got the same for every rated pair"));
    CHECK(run_program({"compare", study.set, "--ratings", study.ratings, "--scale", "odd"})
              .exit_code == 2);
}

TEST_CASE("compare: a metric of one's own stands beside the others, marked wherever it is named") {
    const Study study;
    const std::string mine =
        study.written("mine.csv", output_of({"predict", study.set, "--metric", "rmse"}));
    const std::string python = study.written("own.py",
                                             "import math\n"
                                             "def spectral(x, y, rate_hz):\n"
                                             "    assert len(x) == len(y) and rate_hz == 10000\n"
                                             "    print('words of its own')\n"
                                             "    return abs(math.hypot(*x) - math.hypot(*y))\n"
                                             "def broken(x, y, rate_hz): return 1 / 0\n"
                                             "def below(x, y, rate_hz): return -1.0\n"
                                             "number = 3\n");
    const std::string csv = (study.folder.path / "metrics.csv").string();
    const std::string people = study.three_people();
    const std::vector<std::string> words{
        "compare",  study.set, "--ratings",     people, "--metric",      "pm",
        "--metric", "rmse",    "--metric-from", mine,   "--metric-from", python + ":spectral",
        "--csv",    csv};
    const Ran ran = run_program(words);
    REQUIRE_MESSAGE(ran.exit_code == 0, ran.err);
    CHECK(contains(ran.out, "mine (foreign): from " + mine + ", not of this program"));
    CHECK(
        contains(ran.out, "spectral (foreign): from " + python + ":spectral, not of this program"));
    CHECK_FALSE(contains(ran.out, "words of its own"));
    CHECK(contains(bytes_of(csv), "mine (foreign)"));
    std::vector<std::string> as_json = words;
    as_json.push_back("--json");
    const Json rows = Json::parse(output_of(as_json));
    REQUIRE(rows.size() == 4);
    CHECK(rows[2].at("foreign") == mine);
    CHECK_FALSE(rows[1].contains("foreign"));
    // Its own numbers in a file are the metric itself, in every statistic.
    for (const char* key : {"rho", "p", "tau_b", "K", "stress1", "rho_low", "rho_person"}) {
        CHECK_MESSAGE(rows[2].at(key) == rows[1].at(key), key);
    }
    CHECK(rows[2].contains("pm_less_this"));
    const auto refusal = [&](const std::string& from) {
        const Ran refused =
            run_program({"compare", study.set, "--ratings", people, "--metric-from", from});
        CHECK(refused.exit_code == 1);
        CHECK(refused.out.empty());
        return refused.err;
    };
    CHECK(contains(refusal(python + ":broken"), ":broken: ZeroDivisionError: division by zero"));
    CHECK(
        contains(refusal(python + ":below"),
                 ":below: ValueError: patterns 1 and 2: expected a number of 0 or more, got -1.0"));
    CHECK(contains(refusal(python + ":number"), "expected a function of this name, got int"));
    CHECK(contains(refusal((study.folder.path / "none.py").string() + ":f"),
                   "none.py: there is no such file"));
    CHECK(contains(refusal(study.written("other.csv", "a,b\n0,1\n1,0\n")), "other.csv"));
}

}  // namespace compare_test
