// Which parameters the Model bench says a set has, and where they come from.
#include <doctest/doctest.h>

#include "app/model_bench/model_bench.h"
#include "model/io/set/set_file.h"
#include "model/perceptual_model/perceptual_model.h"
#include "model/set/set_ratings.h"
#include "model/training/training.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace model_choice_test {

using namespace tact;

TEST_CASE(
    "model bench: a kept model that was fitted to what nobody said says so where it is chosen") {
    const TemporaryFolder folder;
    Program program(short_patterns(3));
    App& app = program.app;
    app.work.session.folder = folder.path / "state";
    ModelFile content;
    content.model.nc_weight = 0.3;
    content.training = TrainingRecord{};
    TrainedOn drawn;
    drawn.name = "drawn";
    drawn.participants = 20;
    drawn.mark.synthetic = true;
    content.training->sets = {drawn};
    const auto file = folder.path / "mine.model.json";
    REQUIRE(write_model_file(file, content));
    load_model(app.ui, app.work, app.model_bench, file);
    const std::string nobody = "trained on synthetic ratings: nobody was asked";
    CHECK(contains(app.ui.status.text, nobody));
    app.layout.maximised = Pane::matrix;
    app.layout.bench = BenchTab::model;
    program.settle();
    CHECK(program.at("model:choice").value == "mine, synthetic ratings");
    CHECK(program.at("model:synthetic").value == nobody);
    CHECK(contains(program.at("model:provenance").value, "20 people, synthetic: nobody was asked"));
    program.click("model:choice");
    CHECK(program.at("model option:mine").value == "mine, synthetic ratings");
}

TEST_CASE(
    "model bench: a set that was saved says on another machine what its model was trained on") {
    const TemporaryFolder folder;
    PatternSet set = short_patterns(3);
    set.model.nc_weight = 0.3;
    set.model_origin = {"Trained on drawn.", true, false};
    Program program(*parse_set(print_set(set), "a colleague's", folder.path));
    App& app = program.app;
    app.work.session.folder = folder.path / "state";  // nothing is kept in it
    app.layout.maximised = Pane::matrix;
    app.layout.bench = BenchTab::model;
    program.settle();
    CHECK(program.at("model:provenance").value == "Trained on drawn.");
    CHECK(contains(program.at("model:synthetic").value, "nobody was asked"));
    app.work.document.edit().model.oc_weight = 0.1;
    model_changed(app.work);
    program.settle();
    CHECK(program.at("model:choice").value == "Changed by hand");
    CHECK(program.at("model:provenance").value == "Trained on drawn. Changed by hand since.");
    CHECK(program.shows("model:synthetic"));
    use_model(app.ui, app.work, {}, "the paper's parameters");
    program.settle();
    CHECK(!program.shows("model:provenance"));
    CHECK(!program.shows("model:synthetic"));
    CHECK(app.work.document.set.model_origin == ModelOrigin{});
}

}  // namespace model_choice_test
