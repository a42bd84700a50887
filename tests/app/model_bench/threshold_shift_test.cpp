// Shifts of thresholds: by the same everywhere, back to the digit, and what nothing reaches.
#include "app/model_bench/parts.h"

#include <doctest/doctest.h>

#include "model/physiology/neural_coding.h"
#include "tests/support/physiology_program.h"

namespace threshold_shift_test {

using namespace tact;

namespace {

const Curve& pacinian() { return default_tables().threshold[index_of(Receptor::pacinian)]; }

const Curve& pacinian_of(const Program& program) {
    return program.app.work.document.set.model.coding.tables
        .threshold[index_of(Receptor::pacinian)];
}

}  // namespace

TEST_CASE("threshold shift: 20 dB is ten times the displacement, at every frequency") {
    const Curve deaf = shifted(pacinian(), pacinian(), 20.0);
    for (const double f : {3.0, 40.0, 250.0}) {
        CHECK(at(deaf, f) == doctest::Approx(at(pacinian(), f) + 1.0));
    }
    CHECK(shift_db(deaf, pacinian()).value() == doctest::Approx(20.0));
    CHECK(shifted(deaf, pacinian(), 0.0) == pacinian());
    CHECK(shift_db(pacinian(), pacinian()) == 0.0);
}

TEST_CASE("threshold shift: a curve edited by hand keeps its shape") {
    Curve edited = pacinian();
    edited.value[2] += 0.5;
    CHECK_FALSE(shift_db(edited, pacinian()));
    const Curve moved = shifted(edited, pacinian(), 6.0);
    CHECK(moved.value[2] - moved.value[1] == doctest::Approx(edited.value[2] - edited.value[1]));
}

TEST_CASE("threshold shift: a type that is removed fires at nothing, the others as before") {
    Pattern strong;
    strong.amplitude_g = 5.0;
    strong.carriers[0].frequency_hz = 250.0;
    NeuralCodingParams params;
    const NeuralCode whole = neural_code(render(strong), params);
    Curve& curve = params.tables.threshold[index_of(Receptor::pacinian)];
    curve = removed(curve);
    CHECK(is_removed(curve));
    const NeuralCode without = neural_code(render(strong), params);
    CHECK(whole.activation[index_of(Receptor::pacinian)].radius_mm > 0.0);
    CHECK(without.activation[index_of(Receptor::pacinian)].radius_mm == 0.0);
    for (const int count : without.central_count[index_of(Receptor::pacinian)]) CHECK(count == 0);
    CHECK(without.activation[index_of(Receptor::meissner)] ==
          whole.activation[index_of(Receptor::meissner)]);
}

TEST_CASE("threshold presets: each says that it is a guess") {
    for (const ThresholdPreset& preset : kThresholdPresets) {
        CHECK(std::string(preset.words).starts_with("A guess"));
        for (const double db : preset.db) {
            CHECK((db >= kThresholdShiftDb.low && db <= kThresholdShiftDb.high));
        }
    }
}

TEST_CASE("spectrum: a threshold dragged upwards is one undo step, and rises by what was dragged" *
          doctest::test_suite("long")) {
    PhysiologyProgram program;
    program.app.physiology.view.open = Stage::spectrum;
    program.wait_for_stages();
    const Place plot = program.at("plot:spectrum");
    // Somewhere in the plot the mouse is on the curve: tried from the top down.
    const float x = plot.min.x + 0.5F * (plot.max.x - plot.min.x);
    const Curve before = pacinian_of(program);
    for (float y = plot.min.y + 20.0F; y < plot.max.y - 40.0F; y += 5.0F) {
        program.drag({x, y}, {x, y - 12.0F}, 3);
        if (!(pacinian_of(program) == before)) break;
        if (program.app.work.document.history.undo_label() != nullptr)
            undo(program.app.ui, program.app.work);
    }
    REQUIRE_FALSE(pacinian_of(program) == before);
    const double db = shift_db(pacinian_of(program), before).value();
    CHECK(db > 0.0);
    REQUIRE(program.app.work.document.history.undo_label() != nullptr);
    CHECK(*program.app.work.document.history.undo_label() == "Move threshold of Pacinian");
    undo(program.app.ui, program.app.work);
    CHECK(pacinian_of(program) == before);
}

}  // namespace threshold_shift_test
