// The textbook beside the model: the model's numbers are recomputed here, in other ways.
#include "model/textbook/textbook_beside.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/textbook/textbook.h"

namespace textbook_beside_test {

using namespace tact;

namespace {

struct Tone {
    Waveform waveform;
    NeuralCodingParams params;
    NeuralCodingStages stages;
    PerReceptor<Firing> firing;

    BesideInput input() const { return {waveform, stages, params.tables, firing}; }
};

Tone tone(double frequency_hz, double amplitude_g) {
    Tone made;
    made.waveform.rate_hz = 10'000.0;
    for (int n = 0; n < 10'000; ++n) {
        made.waveform.samples_g.push_back(
            amplitude_g * std::sin(2.0 * std::numbers::pi * frequency_hz * n / 10'000.0));
    }
    made.stages = neural_coding_stages(made.waveform, made.params, KeepLayers::none);
    made.firing = firing_of(made.stages, made.params);
    return made;
}

const BesideFact* of(const std::vector<BesideFact>& facts, const std::string& id,
                     std::optional<Receptor> receptor = std::nullopt) {
    for (const BesideFact& one : facts) {
        if (one.fact->id == id && (!receptor || one.receptor == receptor)) return &one;
    }
    return nullptr;
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

Pattern carrying(std::vector<double> frequencies_hz, double amplitude_g) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers.clear();
    for (const double hz : frequencies_hz) pattern.carriers.push_back({.frequency_hz = hz});
    return pattern;
}

}  // namespace

TEST_CASE("beside: a 30 Hz tone fires many times a cycle, far above where fibres level off") {
    const Tone low = tone(30.0, 0.8);
    const auto facts = beside_the_model("spikes", low.input());
    const BesideFact* cycles = of(facts, "impulses a cycle", Receptor::meissner);
    REQUIRE(cycles != nullptr);
    CHECK(cycles->parts);
    const auto counts = spikes_under_probe(low.stages.channel[index_of(Receptor::meissner)]);
    int all = 0;
    for (const int count : counts) all += count;
    // The busiest 133 ms have at least the mean rate.
    CHECK(*cycles->model >= doctest::Approx(all / 30.0).epsilon(0.01));
    const BesideFact* highest = of(facts, "highest rate FA1");
    REQUIRE(highest != nullptr);
    CHECK(*highest->model == doctest::Approx(all));  // in one second
    CHECK(*highest->measured ==
          doctest::Approx(51.6 + (102.6 - 51.6) * std::log(30.0 / 20.0) / std::log(50.0 / 20.0)));
    CHECK(highest->parts);
    // Merkel cells follow the filter's leak: no measured fact is compared with that.
    CHECK(low.firing[index_of(Receptor::merkel)] == Firing::leaks);
    for (const BesideFact& one : facts) CHECK(one.receptor != Receptor::merkel);
}

TEST_CASE("beside: a faint tone keeps to what was measured, and silence has nothing beside it") {
    const Tone faint = tone(200.0, 0.03);
    const auto facts = beside_the_model("spikes", faint.input());
    const BesideFact* cycles = of(facts, "impulses a cycle", Receptor::pacinian);
    REQUIRE(cycles != nullptr);
    CHECK(cycles->parts == (*cycles->model > kManyACycle));
    const Tone silence = tone(200.0, 0.0);
    for (const char* stage : {"spikes", "central", "brain"}) {
        CHECK(beside_the_model(stage, silence.input()).empty());
    }
}

TEST_CASE("beside: densities are those of Table 1 in the fact's unit; the monkey's are others") {
    const Tone any = tone(100.0, 1.0);
    const auto facts = beside_the_model("receptors", any.input());
    CHECK(*of(facts, "fingertip density")->model == doctest::Approx(240.0));
    CHECK_FALSE(of(facts, "fingertip density")->parts);
    CHECK(*of(facts, "monkey density SA1")->model == doctest::Approx(70.0));
    CHECK(of(facts, "monkey density SA1")->parts);
    CHECK(*of(facts, "ruffini density")->model == doctest::Approx(0.1));
    CHECK_FALSE(of(facts, "ruffini density")->parts);
    CHECK(*of(facts, "share of SA2")->model == doctest::Approx(100.0 * 0.1 / 2.4));
    // Facts from memory appear in no stage.
    CHECK(of(facts, "density FA2") == nullptr);
    CHECK(of(facts, "density SA2") == nullptr);
}

TEST_CASE("beside: Ruffini's rarity stands wherever Ruffini fires, and nowhere else") {
    for (const double amplitude_g : {0.01, 0.3, 1.0, 2.0}) {
        const Tone one = tone(100.0, amplitude_g);
        const bool fires = one.firing[index_of(Receptor::ruffini)] == Firing::fires;
        for (const char* stage : {"receptors", "spikes"}) {
            const auto facts = where_the_model_parts(stage, one.input());
            CHECK((of(facts, "ruffini found") != nullptr) == fires);
        }
    }
    CHECK(tone(100.0, 1.0).firing[index_of(Receptor::ruffini)] == Firing::fires);
}

TEST_CASE("beside: of the thresholds, Ruffini's alone is lowest where no fibre of its kind is") {
    const Tone any = tone(30.0, 0.8);
    const auto facts = beside_the_model("spectrum", any.input());
    CHECK(*of(facts, "best band FA1")->model == doctest::Approx(50.0));
    CHECK_FALSE(of(facts, "best band FA1")->parts);
    // Flat from 250 to 300 Hz: their geometric mean.
    CHECK(*of(facts, "best band FA2")->model == doctest::Approx(std::sqrt(250.0 * 300.0)));
    CHECK_FALSE(of(facts, "best band FA2")->parts);
    CHECK(of(facts, "best band SA2")->parts);
    CHECK_FALSE(of(facts, "most sensitive at")->parts);
    // 11.7 dB at 40 Hz, -20 dB at 250 Hz.
    CHECK(*of(facts, "fall of the threshold")->model ==
          doctest::Approx(31.7 / std::log2(250.0 / 40.0)));
    CHECK(*of(facts, "least amplitude felt")->measured == doctest::Approx(14.51));
    CHECK_FALSE(of(facts, "least amplitude felt")->parts);
    CHECK(of(facts, "flutter") != nullptr);
    CHECK(of(beside_the_model("spectrum", tone(200.0, 0.5).input()), "flutter") == nullptr);
}

TEST_CASE("beside: a model moved by 10 dB parts from the least amplitude that is felt") {
    Tone moved = tone(100.0, 1.0);
    for (Curve& curve : moved.params.tables.threshold) {
        for (double& value : curve.value) value += 0.5;
    }
    CHECK(of(where_the_model_parts("spectrum", moved.input()), "least amplitude felt") != nullptr);
}

TEST_CASE("beside: lines name what parts first, one for each source, with its species") {
    const Tone low = tone(30.0, 0.8);
    const auto lines = lines_of(beside_the_model("receptors", low.input()));
    bool agreed = false;
    for (const BesideLine& line : lines) {
        CHECK_FALSE((agreed && line.parts));
        agreed = agreed || !line.parts;
        CHECK(holds(line.text, "("));
        CHECK((holds(line.text, "human") || holds(line.text, "monkey")));
    }
    const auto monkey = std::ranges::find_if(
        lines, [](const BesideLine& line) { return holds(line.text, "Darian-Smith"); });
    REQUIRE(monkey != lines.end());
    CHECK(monkey->text ==
          "density: Meissner 178, Merkel 134, Pacinian 13 fibres/cm\u00b2 (Darian-Smith & Kenins "
          "1980, monkey); here 140, 70, 20");
}

TEST_CASE("noticed: 40 against 250 Hz is told at once, 100 against 110 Hz hardly") {
    const std::string far = noticed_text(carrying({40.0}, 0.5), carrying({250.0}, 1.0));
    CHECK(far ==
          "People: 40 against 250 Hz, 6.25 times; people tell these apart at once (just "
          "noticeable: 18 to 25 %, Israr and others 2006, human).");
    CHECK(tell_by_frequency(carrying({250.0}, 0.5), carrying({40.0}, 1.0)));
    const std::string near = noticed_text(carrying({110.0}, 1.0), carrying({100.0}, 1.0));
    CHECK(holds(near, "110 against 100 Hz, 10 %; most people do not notice"));
    CHECK_FALSE(tell_by_frequency(carrying({110.0}, 1.0), carrying({100.0}, 1.0)));
    CHECK(holds(noticed_text(carrying({100.0}, 1.0), carrying({120.0}, 1.0)), "just notice"));
    CHECK(
        holds(noticed_text(carrying({100.0}, 1.0), carrying({140.0}, 1.0)), "people notice that"));
}

TEST_CASE("noticed: amplitudes count at one frequency; nothing is said of more than one carrier") {
    const std::string half = noticed_text(carrying({150.0}, 1.0), carrying({150.0}, 0.5));
    CHECK(holds(half, "1 against 0.5 g, 6.02 dB; people tell these apart at once"));
    CHECK(holds(noticed_text(carrying({150.0}, 1.0), carrying({150.0}, 0.9)), "do not notice"));
    CHECK(noticed_text(carrying({150.0}, 1.0), carrying({150.0}, 1.0)).empty());
    CHECK(noticed_text(carrying({150.0}, 1.0), carrying({150.0}, 0.0)).empty());
    CHECK(noticed_text(carrying({150.0, 40.0}, 1.0), carrying({90.0}, 1.0)).empty());
    Pattern swept = carrying({150.0}, 1.0);
    swept.frequency_curve = {{0.0, 150.0}, {1.0, 250.0}};
    CHECK(noticed_text(swept, carrying({90.0}, 1.0)).empty());
}

}  // namespace textbook_beside_test
