// One question, one answer, where people come in: window and command line train on and compare with
// what a set says of its people, who are partly simulated, felt another version of a pattern, and
// left some patterns out. Every bit of what they say is compared.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/compare/compare.h"
#include "app/model_bench/model_bench.h"
#include "app/rendering/rendering.h"
#include "model/io/set/load.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/felt_versions.h"
#include "model/set/set_ratings.h"
#include "model/tasks/set_people.h"
#include "model/tasks/set_training.h"
#include "tests/support/patience.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace same_people_test {

using namespace tact;
using Json = nlohmann::json;

namespace {

constexpr const char* kEdited = "p2";
constexpr const char* kSimulatedOne = "S1";

// Six patterns of which p6 was not rated by anyone; the first two have a synthetic twin each.
PatternSet rated_set() {
    PatternSet set = short_patterns(6);
    set.name = "rated";
    std::get<Pattern>(set.vibrations[0].source).rhythm.text = "x-";
    std::get<Pattern>(set.vibrations[1].source).amplitude_g = 0.4;
    std::get<Pattern>(set.vibrations[2].source).amplitude_g = 0.0;  // some metrics lack its pairs
    std::get<Pattern>(set.vibrations[3].source).duration_s = 0.14;
    set.model.coding.spike_cap = 40;
    RatingStudy study{names_of(set), true, {}, {{kSimulatedOne, true}}};
    const std::vector<double> said{3, 14, 15, 9, 2, 6, 5, 35, 8, 97, 93, 23, 84, 62, 64};
    for (const char* name : {"P1", "P2", "P2", kSimulatedOne}) {
        std::vector<double> one = said;
        for (std::size_t k = 0; k < one.size(); ++k) {
            const auto so_far = static_cast<double>(study.judgements.size());
            one[k] += so_far * static_cast<double>(k % 4);
        }
        for (std::size_t i = 0; i < 5; ++i) one[pair_index(6, i, 5)] = kNoRating;
        study.judgements.push_back({name, one});
    }
    set.ratings = kept_ratings(study, "people.csv");
    note_versions(set.ratings, study, set);
    for (Ratings& ratings : set.ratings) ratings.versions[1] = "another";
    return set;
}

struct Rated {
    TemporaryFolder folder;
    std::string file = (folder.path / "rated.tactspace.json").string();
    std::unique_ptr<Program> program;

    Rated() {
        const auto plain = (folder.path / "plain.tactspace.json").string();
        REQUIRE(write_set_file(plain, rated_set()));
        std::string with_one = (folder.path / "one.tactspace.json").string();
        (void)output_of({"measure", plain, "--simulate", "--pattern", "p1", "--out", with_one});
        (void)output_of({"measure", with_one, "--simulate", "--pattern", "p2", "--out", file});
        const auto loaded = load_set(file);
        REQUIRE(loaded);
        REQUIRE(loaded->set.vibrations.size() == 8);
        program = std::make_unique<Program>(loaded->set);
        begin_jobs(app());
    }

    App& app() { return program->app; }

    template <class Arrived>
    void wait(const Arrived& arrived) {
        const auto until = end_of_patience();
        do {
            REQUIRE(std::chrono::steady_clock::now() < until);
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            program->frame();
        } while (!arrived());
    }

    const FoundTraining& trained(TrainingObjective objective, bool leaves_out) {
        TrainingState& training = app().model_bench.training;
        training.units = 2;
        training.objective = objective;
        training.leave_out_participants = leaves_out;
        begin_training(app().ui, app().work, app().model_bench);
        wait([&] { return !is_training(app().model_bench); });
        program->settle();
        REQUIRE(training.found);
        REQUIRE(training.found->fault.empty());
        return *training.found;
    }

    const Comparison& compared() {
        app().layout.bench = BenchTab::compare;
        program->compute_map();
        wait([&] {
            return !shown_comparison(app().work, app().shown_map, app().comparing).is_stale;
        });
        return *app().comparing.comparison;
    }
};

Json without_date(const std::string& model_file) {
    Json json = Json::parse(model_file);
    json.at("training").erase("date");
    return json;
}

bool is_same(const Json& said, double number) {
    return said.is_null() ? std::isnan(number) : said.get<double>() == number;
}

}  // namespace

TEST_CASE("same answers: who of a set counts, and what they felt") {
    const PatternSet set = rated_set();
    const auto people = set_people(set);
    REQUIRE(people);
    CHECK(people->left_out.empty());  // kept by somebody who included them
    CHECK(people->study.edited == std::vector<std::string>{kEdited});
    CHECK(unrated_patterns(people->study) == std::vector<std::string>{"p6"});
    CountRule rule;
    rule.exclude = {kSimulatedOne};
    const auto without = set_people(set, rule);
    REQUIRE(without);
    CHECK(without->left_out.size() == 1);
    CHECK(without->study.judgements.size() == 3);
    rule.exclude = {"nobody"};
    CHECK_FALSE(set_people(set, rule));
    CHECK_FALSE(set_people(short_patterns(3)));
}

TEST_CASE("same answers: the parameters that agree best with people" *
          doctest::test_suite("long")) {
    Rated rated;
    for (const bool leaves_out : {false, true}) {
        for (const auto objective :
             {TrainingObjective::mean_rho, TrainingObjective::mean_absolute_rho}) {
            CAPTURE(leaves_out);
            const FoundTraining& window = rated.trained(objective, leaves_out);
            const auto out = (rated.folder.path / "found.json").string();
            std::vector<std::string> words{
                "train", rated.file,    "--step",
                "0.5",   "--objective", kObjectiveNames[static_cast<std::size_t>(objective)],
                "--out", out,           "--json"};
            if (leaves_out) words.insert(words.end(), {"--leave-out", "participants"});
            const Json terminal = Json::parse(output_of(words));
            const auto written = read_model_file(out);
            REQUIRE(written);
            REQUIRE(written->training);
            const auto saved = (rated.folder.path / "saved.json").string();
            save_trained(rated.app().ui, rated.app().model_bench, saved);
            // With fingerprints of the waves and the ratings.
            CHECK(without_date(bytes_of(saved)) == without_date(bytes_of(out)));
            CHECK(written->model == window.training.model);
            TrainRequest request;
            request.leave_out = leaves_out ? LeaveOut::participants : LeaveOut::nothing;
            request.sets = {{"rated", {}, *window.request.sets.front().study}};
            Json said = Json::parse(json_of({window.training, window.record}, request).dump());
            said["sets"][0]["name"] = window.record.sets.front().name;
            for (const auto& [key, value] : said.items()) {
                CAPTURE(key);
                if (key != "sets") CHECK(terminal.at(key) == value);
            }
            for (const auto& [key, value] : said.at("sets")[0].items()) {
                CAPTURE(key);
                CHECK(terminal.at("sets")[0].at(key) == value);
            }
            CHECK(terminal.at("sets")[0].at("edited_since_felt") == Json{kEdited});
            CHECK(window.request.sets.front().study->edited == std::vector<std::string>{kEdited});
        }
    }
}

TEST_CASE("same answers: metrics with people, one of one's own, and as a device plays" *
          doctest::test_suite("long")) {
    for (const bool is_rendered : {false, true}) {
        CAPTURE(is_rendered);
        Rated rated;
        rated.app().rendered.on = is_rendered;
        rated.app().rendered.by = RenderedBy{ActuatorKind::dualshock_4};
        std::string csv;
        const std::vector<std::string> names = names_of(rated.app().work.document.set);
        for (const std::string& name : names) csv += "," + name;
        for (std::size_t i = 0; i < names.size(); ++i) {
            csv += "\n" + names[i];
            for (std::size_t j = 0; j < names.size(); ++j) {
                const auto [low, high] = std::minmax(i, j);
                csv += "," + std::to_string(i == j ? 0 : 1 + (3 * low + high * high) % 17);
            }
        }
        const auto mine = rated.folder.write("mine.csv", csv + "\n");
        add_metric(rated.app().ui, rated.app().comparing, mine);
        const Comparison& window = rated.compared();
        REQUIRE(window.people);
        REQUIRE(window.failed == std::vector<std::string>());
        std::vector<std::string> words{"compare", rated.file, "--metric-from", mine.string(),
                                       "--json"};
        if (is_rendered)
            words.insert(words.end(), {"--rendered-by", traits(ActuatorKind::dualshock_4).key});
        const Json rows = Json::parse(output_of(words));
        REQUIRE(rows.size() == window.metrics.size());
        for (std::size_t m = 0; m < rows.size(); ++m) {
            const ComparedMetric& metric = window.metrics[m];
            CAPTURE(metric.key);
            const Json& row = rows[m];
            CHECK(row.at("metric") == metric.key);
            const Evaluation& e = *metric.evaluation;
            CHECK(is_same(row.at("rho"), e.rho));
            CHECK(is_same(row.at("rho_low"), e.rho_interval.low));
            CHECK(is_same(row.at("rho_high"), e.rho_interval.high));
            CHECK(is_same(row.at("p"), e.rho_p));
            CHECK(is_same(row.at("tau_b"), e.tau_b));
            CHECK(is_same(row.at("K"), e.k));
            CHECK(is_same(row.at("K_p"), e.k_p));
            CHECK(row.at("participants") == window.people->said.participants);
            CHECK(row.at("unrated_patterns") == window.people->said.unrated);
            CHECK(row.at("edited_since_felt") == window.people->said.edited);
            CHECK(row.value("changed_since_felt", false) == mark_of(window).stale);
        }
    }
}

}  // namespace same_people_test
