// The dialog on a study's plan, in the program's real frames: the numbers of the command line, what
// is frozen, and what goes stale.
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/document/editing.h"
#include "app/planning/planning.h"
#include "model/io/set/set_file.h"
#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/scene_steps.h"
#include "tests/support/temporary_folder.h"

namespace plan_dialog_test {

using namespace tact;

namespace {

struct Planning {
    Program program{short_patterns(5)};

    Planning() {
        program.app.planning.choice.first = 3;
        program.app.planning.choice.last = 4;
        run(program, "Plan the study...");
    }

    void simulate() {
        program.click("button:simulate plan");
        wait_until(program, [this] { return !is_planning(program.app.planning); });
        program.settle();
    }
};

}  // namespace

TEST_CASE("plan dialog: its numbers are those of the command line" * doctest::test_suite("long")) {
    Planning planning;
    planning.simulate();
    const TemporaryFolder folder;
    const auto set = (folder.path / "set.tactspace.json").string();
    REQUIRE(write_set_file(set, planning.program.app.work.document.set));
    const auto told = nlohmann::json::parse(output_of(
        {"plan", set, "--people", "3..4", "--rho", "0.67", "--reliability", "0.4", "--json"}));
    const auto live = planning.program.app.planning.job.latest();
    REQUIRE(live->plan);
    REQUIRE(live->plan->studies.size() == told.at("studies").size());
    for (std::size_t k = 0; k < live->plan->studies.size(); ++k) {
        const PlannedStudy& one = live->plan->studies[k];
        const auto& row = told.at("studies")[k];
        CHECK(one.people == row.at("people").get<std::size_t>());
        CHECK(one.rho_sd == row.at("rho_sd").get<double>());
        CHECK(one.power[0] == row.at("power").at(kResampledNames[0]).get<double>());
    }
    CHECK(planning.program.shows("plan row:3"));
    CHECK(planning.program.at("plan:verdict").value.find("Msm") != std::string::npos);
}

TEST_CASE("plan dialog: frozen with the number of people that was chosen, and once" *
          doctest::test_suite("long")) {
    Planning planning;
    planning.simulate();
    Program& program = planning.program;
    const TemporaryFolder folder;
    preregister(program.app.ui, program.app.work, program.app.planning, folder.path / "plan");
    CHECK_FALSE(std::filesystem::exists(folder.path / "plan"));  // no row is chosen yet
    program.click("plan row:4");
    preregister(program.app.ui, program.app.work, program.app.planning, folder.path / "plan");
    const auto frozen =
        nlohmann::json::parse(bytes_of(folder.path / "plan" / "preregistration.json"));
    CHECK(frozen.at("people") == 4);
    const std::string before = bytes_of(folder.path / "plan" / "preregistration.json");
    program.app.planning.chosen = 0;
    preregister(program.app.ui, program.app.work, program.app.planning, folder.path / "plan");
    CHECK(program.app.ui.status.is_error);
    CHECK(bytes_of(folder.path / "plan" / "preregistration.json") == before);
}

TEST_CASE(
    "plan dialog: another choice or document makes the answer stale, deciding patterns are "
    "asked about" *
    doctest::test_suite("long")) {
    Planning planning;
    Program& program = planning.program;
    program.app.planning.choice.all_patterns = false;
    program.app.planning.choice.decide = 4;
    program.settle();
    planning.simulate();
    CHECK(is_plan_current(program.app.work, program.app.planning));
    program.click("link:use planned patterns");
    CHECK(program.app.work.document.set.study.patterns.size() == 4);
    CHECK_FALSE(is_plan_current(program.app.work, program.app.planning));
    undo(program.app.ui, program.app.work);
    CHECK(program.app.work.document.set.study.patterns.empty());
    program.app.planning.choice.rival = Metric::rmse;
    CHECK_FALSE(is_plan_current(program.app.work, program.app.planning));
}

TEST_CASE("plan dialog: too few patterns are no study, and a sentence says so") {
    Program program(short_patterns(2));
    run(program, "Plan the study...");
    CHECK_FALSE(plan_obstacle(program.app.work).empty());
    program.click("button:simulate plan");  // it is not enabled
    CHECK_FALSE(is_planning(program.app.planning));
}

}  // namespace plan_dialog_test
