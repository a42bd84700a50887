// The parameters of the model bench, in the program's real frames.
#include <doctest/doctest.h>

#include "tests/support/program.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace model_panel_test {

using namespace tact;

TEST_CASE("model bench: a weight is changed, marked, undone, and brought back by one click") {
    ProgramWithStages program(short_patterns(3));
    program.app.layout.maximised = Pane::matrix;
    program.frame();
    program.click("tab:Model");
    const Place bar = program.at("slider:weight_FA1");
    program.drag({bar.middle().x, bar.middle().y}, {bar.max.x - 3.0F, bar.middle().y}, 3);
    CHECK(program.app.work.document.set.model.channel_weight[0] == 1.0);
    CHECK(program.at("model:changed").value == "1");
    program.wait_for_stages();
    CHECK(program.app.physiology.stages->request.model.channel_weight[0] == 1.0);
    program.press('z', true);
    CHECK(program.app.work.document.set.model == PerceptualModelParams{});
    program.press('z', true, true);
    program.click("reset:weight_FA1");
    CHECK(program.app.work.document.set.model == PerceptualModelParams{});
    program.click("choice:skin_input acceleration");
    CHECK(program.app.work.document.set.model.coding.skin_input == SkinInput::acceleration);
    program.click("reset:model");
    CHECK(program.app.work.document.set.model == PerceptualModelParams{});
    CHECK_FALSE(program.shows("model:changed"));
}

TEST_CASE("model bench: each control that was changed counts once, and no row moves") {
    Program program(short_patterns(2));
    program.app.layout.maximised = Pane::matrix;
    program.app.layout.bench = BenchTab::model;
    program.resize({1600.0F, 2400.0F}, 1.0F);  // all of it in view
    const auto tops = [&program] {
        std::map<std::string, float> all;
        for (const char* row : {"excitatory_layers", "weight_FA1", "spike_cap", "waiting_cost"}) {
            all[row] = program.at(std::string("entry:") + row).min.y;
        }
        return all;
    };
    const auto before = tops();
    program.click("choice:thresholds AOSP");
    CHECK(program.at("model:changed").value == "1");
    CHECK(tops() == before);
    program.click("choice:share own");
    CHECK(program.at("model:changed").value == "2");
    CHECK(tops() == before);
}

TEST_CASE("model bench: a layer and a half is refused, and what was not taken is framed") {
    Program program(short_patterns(2));
    program.app.layout.maximised = Pane::matrix;
    program.app.layout.bench = BenchTab::model;
    program.resize({1600.0F, 2400.0F}, 1.0F);
    const auto& model = program.app.work.document.set.model;
    const auto enter = [&program](const char* row, const char* text) {
        program.click(std::string("entry:") + row);
        program.type(text);
        program.press_key(key::kEnter);
        program.settle();
        return program.app.ui.field.typing.refused != 0;
    };
    CHECK(enter("excitatory_layers", "2.7"));
    CHECK(model.coding.excitatory_layers == 3);
    CHECK(contains(program.app.ui.status.text, "is no whole number"));
    CHECK(enter("weight_FA1", "1e308"));
    CHECK(enter("weight_FA1", "-5"));
    CHECK(model.channel_weight[0] == 0.0);
    CHECK(enter("weight_FA1", "1e-320"));
    CHECK(model.channel_weight[0] == 0.0);
    CHECK_FALSE(enter("weight_FA1", "0.5"));
}

TEST_CASE("model panel: shares far below a thousandth are slid like others, by their logarithm") {
    Program program(short_patterns(2));
    program.app.layout.maximised = Pane::matrix;
    program.app.layout.bench = BenchTab::model;
    program.resize({1600.0F, 2400.0F}, 1.0F);  // all of it in view
    const double& share = program.app.work.document.set.model.coding.silent_energy_fraction;
    const auto slide_to = [&](float part) {
        const Place bar = program.at("slider:silent_energy_fraction");
        program.window.move(
            {bar.min.x + part * (bar.max.x - bar.min.x), 0.5F * (bar.min.y + bar.max.y)});
        program.window.button(true);
        program.frame();
        program.window.button(false);
        program.settle();
    };
    slide_to(0.5F);  // 1e-15 to 1e-3
    CHECK(std::abs(std::log10(share) + 9.0) < 0.1);
    slide_to(0.999F);
    CHECK(share == 1e-3);
    slide_to(0.0F);
    CHECK(share == 1e-15);
}

TEST_CASE("model panel: felt steps are said with their source, typed in dB, undone in one step") {
    Program program(short_patterns(2));
    program.app.layout.maximised = Pane::matrix;
    program.app.layout.bench = BenchTab::model;
    program.resize({1600.0F, 4000.0F}, 1.0F);  // all of it in view
    for (const PatternParameter parameter : kPatternParameters) {
        CAPTURE(traits(parameter).key);
        CHECK(program.shows(std::string("slider:felt_step_") + traits(parameter).key));
        CHECK_FALSE(std::string(traits(parameter).step_source).empty());
    }
    const FeltSteps& steps = program.app.work.document.set.felt_steps;
    const FeltSteps usual = steps;
    program.click("entry:felt_step_amplitude_g");
    program.type("6 dB");
    program.press_key(key::kEnter);
    const auto amplitude = static_cast<std::size_t>(PatternParameter::amplitude);
    CHECK(steps.size[amplitude] == doctest::Approx(1.9953).epsilon(1e-4));
    undo(program.app.ui, program.app.work);
    CHECK(steps == usual);
}

}  // namespace model_panel_test
