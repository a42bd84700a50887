// Edits of recordings and of layers: laws on samples, and one sentence for what cannot be.
#include "model/algebra/source_edits.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "model/algebra/set_edits.h"
#include "model/set/layers.h"

namespace source_edits_test {

using namespace tact;

namespace {

const PhysiologyTables& tables() {
    static const PatternSet set;
    return set.model.coding.tables;
}

Vibration named(VibrationSource source) {
    Vibration vibration;
    vibration.name = "buzz";
    vibration.source = std::move(source);
    return vibration;
}

Measurement noise(unsigned seed, std::size_t samples) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, 0.3);
    Waveform waveform;
    for (std::size_t n = 0; n < samples; ++n) waveform.samples_g.push_back(normal(random));
    Measurement measurement;
    measurement.waveform = std::make_shared<const Waveform>(std::move(waveform));
    measurement.path = "/somewhere/noise.wav";
    measurement.measures = "hum";
    return measurement;
}

Pattern tone(double frequency_hz, double duration_s = 0.3) {
    Pattern pattern;
    pattern.carriers = {{frequency_hz, 1.0, 0.0}};
    pattern.duration_s = duration_s;
    return pattern;
}

LayeredPattern two_layers() {
    Pattern beat = tone(60.0);
    beat.rhythm = {"x--", 0.1};
    Pattern ticks = tone(150.0, 0.2);
    ticks.amplitude_g = 0.0;
    ticks.transients = {{0.01, 0.5, 200.0, 0.02}, {0.1, 0.7, 100.0, 0.03}};
    return {{{"bed", beat, 0.8}, {"ticks", ticks, 1.0, 0.25}}};
}

VibrationSource after(const VibrationSource& source, const Edit& edit) {
    const Expected<VibrationSource> result =
        edited_source(named(source), std::span(&edit, 1), tables());
    REQUIRE_MESSAGE(result, (result ? "" : result.error().message));
    return *result;
}

std::string refusal(const VibrationSource& source, const Edit& edit) {
    const Expected<VibrationSource> result =
        edited_source(named(source), std::span(&edit, 1), tables());
    return result ? "" : result.error().message;
}

std::vector<double> samples(const VibrationSource& source) {
    return waveform_of(named(source)).samples_g;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    REQUIRE(a.size() == b.size());
    double largest = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) largest = std::max(largest, std::abs(a[n] - b[n]));
    return largest;
}

}  // namespace

TEST_CASE("source edits: a recording keeps the laws of the algebra, on samples") {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const VibrationSource whole = noise(seed, 500 + 37 * seed);
        const std::vector<double> before = samples(whole);
        const VibrationSource turned = after(whole, {EditKind::reverse});
        CHECK(samples(after(turned, {EditKind::reverse})) == before);
        CHECK(samples(turned).front() == before.back());
        const std::vector<double> thrice = samples(after(whole, {EditKind::repeat, 3.0}));
        REQUIRE(thrice.size() == 3 * before.size());
        CHECK(std::equal(before.begin(), before.end(),
                         thrice.begin() + static_cast<std::ptrdiff_t>(before.size())));
        const VibrationSource joined = after(whole, {EditKind::join, 0.0, noise(seed + 99, 60)});
        CHECK(samples(joined).size() == before.size() + 60);
        CHECK(peak_g(waveform_of(named(after(whole, {EditKind::normalise, 2.5})))) ==
              doctest::Approx(2.5));
        const std::vector<double> faded = samples(after(whole, {EditKind::fade_in, 0.02}));
        CHECK(faded[0] == 0.0);
        CHECK(faded[100] == doctest::Approx(0.5 * before[100]));
        CHECK(faded[300] == before[300]);
    }
}

TEST_CASE("source edits: silence of a recording is what lies 40 dB below its peak") {
    Waveform waveform;
    waveform.samples_g = {0.0, 0.009, -0.5, 0.0, 1.0, 0.02, -0.01, 0.0};
    Measurement measurement;
    measurement.waveform = std::make_shared<const Waveform>(waveform);
    const std::vector<double> trimmed = samples(after(measurement, {EditKind::trim}));
    CHECK(trimmed == std::vector<double>{-0.5, 0.0, 1.0, 0.02});
    measurement.waveform = std::make_shared<const Waveform>(Waveform{kModelRateHz, {0.0, 0.0}});
    CHECK(samples(after(measurement, {EditKind::trim})).size() == 2);
}

TEST_CASE("source edits: an edited recording has no file, measures nothing, and stays synthetic") {
    Measurement recording = noise(1, 400);
    recording.synthetic = true;
    const auto made = std::get<Measurement>(after(recording, {EditKind::reverse}));
    CHECK(made.path.empty());
    CHECK(made.measures.empty());
    CHECK(made.synthetic);
    const Measurement real = noise(2, 400);
    CHECK(std::get<Measurement>(after(real, {EditKind::join, 0.0, recording})).synthetic);
    CHECK(!std::get<Measurement>(after(real, {EditKind::join, 0.0, tone(50.0)})).synthetic);
}

TEST_CASE("source edits: two beds mixed are layers that sum up to both") {
    const VibrationSource both = after(tone(60.0), {EditKind::mix, 0.0, tone(200.0, 0.2), "hum"});
    // Carriers under the same notes and curves stay one pattern; these are not equally long.
    const auto* layered = std::get_if<LayeredPattern>(&both);
    REQUIRE(layered != nullptr);
    CHECK(layered->layers[0].name == "buzz");
    CHECK(layered->layers[1].name == "hum");
    const std::vector<double> sum = samples(both);
    std::vector<double> expected = samples(tone(60.0));
    const std::vector<double> second = samples(tone(200.0, 0.2));
    for (std::size_t n = 0; n < second.size(); ++n) expected[n] += second[n];
    CHECK(sum == expected);
    CHECK(std::holds_alternative<Pattern>(after(tone(60.0), {EditKind::mix, 0.0, tone(200.0)})));
    const VibrationSource with_noise = after(noise(1, 900), {EditKind::mix, 0.0, tone(60.0), "t"});
    CHECK(std::get<LayeredPattern>(with_noise).layers.size() == 2);
    VibrationSource many = two_layers();
    many = after(many, {EditKind::mix, 0.0, two_layers(), "more"});
    CHECK(std::get<LayeredPattern>(many).layers.size() == 4);
    CHECK(refusal(many, {EditKind::mix, 0.0, tone(9.0), "fifth"}) ==
          "mix: expected 1 to 4 layers, got 5");
}

TEST_CASE("source edits: layers turned twice, stretched there and back, are as before") {
    const VibrationSource layers = two_layers();
    const VibrationSource turned = after(layers, {EditKind::reverse});
    CHECK(std::get<LayeredPattern>(turned).layers[0].offset_s == doctest::Approx(0.15));
    CHECK(std::get<LayeredPattern>(turned).layers[1].offset_s == 0.0);
    const VibrationSource again = after(turned, {EditKind::reverse});
    CHECK(largest_difference(samples(again), samples(layers)) < 1e-9);
    VibrationSource longer = after(layers, {EditKind::stretch, 1.5});
    CHECK(own_duration_s(named(longer)) == doctest::Approx(1.5 * 0.45));
    longer = after(longer, {EditKind::stretch, 1.0 / 1.5});
    CHECK(largest_difference(samples(longer), samples(layers)) < 1e-9);
    CHECK(peak_g(waveform_of(named(after(layers, {EditKind::normalise, 0.5})))) ==
          doctest::Approx(0.5));
    const VibrationSource higher = after(layers, {EditKind::transpose, 2.0});
    const auto& bed = std::get<Pattern>(std::get<LayeredPattern>(higher).layers[0].source);
    CHECK(bed.carriers[0].frequency_hz == 120.0);
}

TEST_CASE("source edits: what cannot be says so in one sentence, with the layer's name") {
    CHECK(refusal(noise(1, 300), {EditKind::stretch, 2.0}) ==
          "stretch: expected a pattern made of parameters, got a recording");
    CHECK(refusal(noise(1, 300), {EditKind::fade_in, 2.0}) ==
          "fade-in: expected at most the recording's 0.03 s, got 2 s");
    CHECK(refusal(noise(1, 300'000), {EditKind::repeat, 3.0}) ==
          "repeat: expected at most 60 s, it would last 90 s");
    CHECK(refusal(two_layers(), {EditKind::trim}) ==
          "trim: expected a pattern without layers: edit its layers one by one");
    LayeredPattern with_noise = two_layers();
    with_noise.layers.push_back({"wind", noise(3, 100)});
    CHECK(refusal(with_noise, {EditKind::transpose, 2.0}) ==
          "transpose: layer \"wind\": expected a pattern made of parameters, got a recording");
    CHECK(refusal(two_layers(), {EditKind::join}) == "join: expected another pattern");
}

TEST_CASE("source edits: within a set, of all that is not locked") {
    PatternSet set;
    set.vibrations = {named(noise(1, 300)), named(two_layers()), named(tone(80.0))};
    set.vibrations[1].name = "alarm";
    set.vibrations[2].name = "hum";
    const std::vector<NamedEdit> turn{{EditKind::reverse}};
    const auto all = with_edits_of_all(set, turn);
    REQUIRE(all);
    CHECK(all->left.empty());
    const std::vector<NamedEdit> longer{{EditKind::stretch, 2.0}};
    const auto some = with_edits_of_all(set, longer);
    REQUIRE(some);
    REQUIRE(some->left.size() == 1);
    CHECK(some->left[0] ==
          "\"buzz\", stretch: expected a pattern made of parameters, got a recording");
    const std::vector<NamedEdit> mix{{EditKind::mix, 0.0, "buzz"}};
    const auto mixed = with_edits(set, std::vector<std::string>{"hum"}, mix);
    REQUIRE(mixed);
    const auto& layers = std::get<LayeredPattern>(mixed->vibrations[2].source).layers;
    CHECK(layers[0].name == "hum");
    CHECK(layers[1].name == "buzz");
}

}  // namespace source_edits_test
