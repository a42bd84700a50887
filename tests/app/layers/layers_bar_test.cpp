// Layers in the window: what the editor does it does with the open one, and each press is a step.
#include "app/layers/layers.h"
#include "app/window/window.h"
#include "model/io/set/set_file.h"
#include "model/set/layers.h"
#include "model/text/names.h"
#include "tests/support/program.h"

namespace layers_bar_test {

using namespace tact;

namespace {

const LayeredPattern& layers(const Program& program, std::size_t index = 0) {
    return std::get<LayeredPattern>(program.app.work.document.set.vibrations[index].source);
}

const Pattern& pattern_of_layer(const Program& program, std::size_t k) {
    return std::get<Pattern>(layers(program).layers[k].source);
}

// The editor under the map, over their whole width.
struct WithBand : Program {
    explicit WithBand(std::size_t patterns) : Program(short_patterns(patterns)) {
        fold_physiology(app, Fold::closed);
        settle();
    }
};

const Command& command(std::string_view name) {
    const auto found = std::ranges::find(commands(), name, &Command::name);
    REQUIRE(found != commands().end());
    return *found;
}

void run_command(Program& program, std::string_view name) {
    REQUIRE(command(name).enabled(program.app));
    command(name).run(program.app);
    program.settle();
}

}  // namespace

TEST_CASE("layers: a layer is added, opened in the editor, and taken back in one step") {
    WithBand program(2);
    const Pattern bed = program.pattern(0);
    CHECK_FALSE(program.shows("layer:1"));
    program.click("button:add layer");
    REQUIRE(layers(program).layers.size() == 2);
    CHECK(pattern_of_layer(program, 0) == bed);
    CHECK(layers(program).layers[0].name == "bed");
    CHECK(pattern_of_layer(program, 1).duration_s == bed.duration_s);
    CHECK(open_layer(program.app.work) == 1);
    CHECK(program.at("layer:2").value == "layer 2, open");
    undo(program.app.ui, program.app.work);
    program.settle();
    CHECK(program.pattern(0) == bed);
    CHECK_FALSE(program.shows("layer:1"));
}

TEST_CASE("layers: the editor changes the open layer alone") {
    WithBand program(2);
    program.click("button:add layer");
    const Pattern bed = pattern_of_layer(program, 0);
    edit_patterns(program.app.work, [](Pattern& pattern) { pattern.amplitude_g = 0.25; });
    CHECK(pattern_of_layer(program, 1).amplitude_g == 0.25);
    CHECK(pattern_of_layer(program, 0) == bed);
    program.click("layer:1");
    CHECK(open_layer(program.app.work) == 0);
    CHECK(*shown_pattern(program.app.work) == bed);
    edit_patterns(program.app.work, [](Pattern& pattern) { pattern.amplitude_g = 0.75; });
    CHECK(pattern_of_layer(program, 0).amplitude_g == 0.75);
    CHECK(pattern_of_layer(program, 1).amplitude_g == 0.25);
    // The strip is of the open layer, and the others lie beneath it.
    program.settle();
    CHECK(program.at("strip:ghost").value == "beneath: the other layers");
    // Another pattern begins with its own first layer, and this one is as it was left.
    select_only(program.app.work, 1);
    program.settle();
    CHECK_FALSE(program.shows("layer:1"));
    CHECK(shown_name(program.app.work) == "p2");
}

TEST_CASE("layers: mute, solo, gain and begin are steps, and what is heard") {
    WithBand program(1);
    program.click("button:add layer");
    const double whole_g = peak_g(waveform_of(program.app.work.document.set.vibrations[0]));
    program.click("layer mute:2");
    CHECK(layers(program).layers[1].mute);
    CHECK(peak_g(waveform_of(program.app.work.document.set.vibrations[0])) < whole_g);
    CHECK(program.at("layer mute:2").value == "on");
    program.click("layer solo:2");
    CHECK(layers(program).layers[1].solo);
    edit_layer(program.app.work, 1, [](Layer& layer) {
        layer.gain = 0.5;
        layer.offset_s = 0.1;
    });
    CHECK(duration_s(layers(program)) ==
          doctest::Approx(0.1 + duration_s(layers(program).layers[1])));
    // What a file would refuse is not taken.
    edit_layer(program.app.work, 1, [](Layer& layer) { layer.offset_s = 60.0; });
    CHECK(layers(program).layers[1].offset_s == 0.1);
    undo(program.app.ui, program.app.work);
    undo(program.app.ui, program.app.work);
    undo(program.app.ui, program.app.work);
    CHECK_FALSE(layers(program).layers[1].mute);
}

TEST_CASE("layers: four at most, the last one left is a pattern again") {
    WithBand program(1);
    const Pattern bed = program.pattern(0);
    for (int k = 0; k < 3; ++k) program.click("button:add layer");
    CHECK(layers(program).layers.size() == 4);
    CHECK_FALSE(command("Add a layer").enabled(program.app));
    program.click("button:add layer");
    CHECK(layers(program).layers.size() == 4);
    for (int k = 0; k < 3; ++k) program.click("layer remove:2");
    CHECK(program.pattern(0) == bed);
}

TEST_CASE("layers: a click on the open one folds the others, a locked pattern keeps all") {
    WithBand program(1);
    program.click("button:add layer");
    const float before_px = program.at("strip:amplitude").min.y;
    program.click("layer:2");
    CHECK_FALSE(program.shows("layer:1"));
    CHECK(program.at("strip:amplitude").min.y < before_px);
    program.click("layer:2");
    CHECK(program.shows("layer:1"));
    toggle_locked(program.app.ui, program.app.work);
    const LayeredPattern kept = layers(program);
    program.settle();
    program.click("layer mute:1");
    program.click("layer remove:1");
    CHECK(layers(program) == kept);
}

TEST_CASE("layers: selected patterns become layers, and layers patterns") {
    WithBand program(3);
    CHECK_FALSE(command("Make layers of the selected patterns").enabled(program.app));
    select_all(program.app.work);
    const PatternSet before = program.app.work.document.set;
    run_command(program, "Make layers of the selected patterns");
    const auto& set = program.app.work.document.set;
    REQUIRE(set.vibrations.size() == 4);
    CHECK(set.vibrations[3].name == "p1 + p2 + p3");
    CHECK(layers(program, 3).layers[1].name == "p2");
    const std::vector<double> sum = waveform_of(set.vibrations[3]).samples_g;
    double expected = 0.0;
    for (const Vibration& one : before.vibrations) expected += waveform_of(one).samples_g[37];
    CHECK(sum[37] == doctest::Approx(expected));
    run_command(program, "Split layers into patterns");
    REQUIRE(set.vibrations.size() == 7);
    CHECK(set.vibrations[4].name == "p1 + p2 + p3, p1");
    for (std::size_t k = 0; k < 3; ++k) {
        CHECK(set.vibrations[4 + k].source == before.vibrations[k].source);
    }
}

TEST_CASE("layers: names stay as long as a file may hold") {
    WithBand program(2);
    const std::string longest(kMaxNameBytes, 'n');
    rename_vibration(program.app.ui, program.app.work, 0, longest);
    select_all(program.app.work);
    run_command(program, "Make layers of the selected patterns");
    run_command(program, "Split layers into patterns");
    for (const Vibration& one : program.app.work.document.set.vibrations) {
        CHECK(one.name.size() <= kMaxNameBytes);
    }
    CHECK(parse_set(print_set(program.app.work.document.set), "s.json", {}));
}

TEST_CASE("layers: a narrow editor has the button among its numbers, and a row a layer") {
    Program program(short_patterns(2));
    program.click("button:add layer");
    REQUIRE(layers(program).layers.size() == 2);
    const Place& pane = program.at("pane:Editor");
    for (const char* name : {"layer:1", "layer:2", "layer remove:2", "entry:layer_offset_ms"}) {
        CAPTURE(name);
        REQUIRE(program.shows(name));
        CHECK(program.at(name).min.x >= pane.min.x);
        CHECK(program.at(name).max.x <= pane.max.x);
    }
}

}  // namespace layers_bar_test
