// Layers: their sum is the equation's, and no phase between two of them decides a number.
#include "model/set/layers.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "model/algebra/one_pattern.h"
#include "model/export/export_target.h"
#include "model/export/exported_set.h"
#include "model/io/set/set_file.h"
#include "model/subset/confusable.h"
#include "tests/support/golden.h"

namespace layers_test {

using namespace tact;

namespace {

Pattern tone(double amplitude_g, double frequency_hz, double duration_s) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers = {{frequency_hz, 1.0, 0.0}};
    pattern.duration_s = duration_s;
    return pattern;
}

Pattern ticks(std::vector<double> times_s, double duration_s) {
    Pattern pattern = tone(0.0, 150.0, duration_s);
    for (const double time_s : times_s) pattern.transients.push_back({time_s, 0.8, 200.0, 0.022});
    return pattern;
}

Layer layer(Pattern pattern, double gain = 1.0, double offset_s = 0.0) {
    return {"", std::move(pattern), gain, offset_s};
}

Layer recording(std::vector<double> samples_g) {
    Measurement measurement;
    measurement.waveform = std::make_shared<const Waveform>(Waveform{kModelRateHz, samples_g});
    return {"taken", measurement};
}

LayeredPattern layered_of(const golden::Json& rows) {
    LayeredPattern layered;
    for (const golden::Json& row : rows) {
        Pattern pattern = tone(row.at("amplitude_g"), 1.0, row.at("duration_s"));
        pattern.carriers.clear();
        for (const double hz : row.at("carriers_hz")) pattern.carriers.push_back({hz, 1.0, 0.0});
        pattern.modulation.frequency_hz = row.at("modulation_hz");
        for (const golden::Json& one : row.at("transients")) {
            pattern.transients.push_back({one[0], one[1], one[2], one[3]});
        }
        Layer made = layer(pattern, row.at("gain"), row.at("offset_s"));
        made.mute = row.at("mute");
        made.solo = row.at("solo");
        layered.layers.push_back(made);
    }
    return layered;
}

double energy(const Waveform& waveform, double from_s, double to_s) {
    double sum = 0.0;
    for (std::size_t n = sample_count(from_s, kModelRateHz); n < sample_count(to_s, kModelRateHz);
         ++n) {
        sum += waveform.samples_g[n] * waveform.samples_g[n];
    }
    return sum;
}

PatternSet set_of(std::vector<LayeredPattern> all) {
    PatternSet set;
    for (LayeredPattern& one : all) {
        Vibration vibration;
        vibration.name = "p" + std::to_string(set.vibrations.size() + 1);
        vibration.source = std::move(one);
        set.vibrations.push_back(std::move(vibration));
    }
    return set;
}

}  // namespace

TEST_CASE("layers: the sum is that of an independent rendering") {
    for (const golden::Json& row : golden::read("layers.json", "layers")) {
        CAPTURE(row.at("name").get<std::string>());
        const LayeredPattern layered = layered_of(row.at("layers"));
        REQUIRE(fault_of(layered).empty());
        const std::vector<double> samples = render(layered).samples_g;
        REQUIRE(samples.size() == row.at("samples").get<std::size_t>());
        double squares = 0.0;
        for (const double sample : samples) squares += sample * sample;
        CHECK(squares == doctest::Approx(row.at("squares").get<double>()).epsilon(1e-9));
        const std::vector<double> expected = row.at("every_61st");
        for (std::size_t k = 0; k < expected.size(); ++k) {
            CHECK(std::abs(samples[61 * k] - expected[k]) < 1e-9);
        }
    }
}

TEST_CASE("layers: one layer is its pattern to the last bit") {
    Pattern pattern = tone(0.7, 83.0, 0.61);
    pattern.rhythm = {"x=5-", 0.07};
    pattern.modulation = {ModulationKind::am, 6.0, 0.5};
    pattern.transients = {{0.05, 0.9, 170.0, 0.03}, {0.6, 0.9, 170.0, 0.03}};
    const LayeredPattern one{{layer(pattern)}};
    for (const double rate_hz : {kModelRateHz, 48'000.0}) {
        CHECK(render(one, rate_hz) == render(pattern, rate_hz));
    }
    CHECK(std::get<Pattern>(without_needless_layers(one)) == pattern);
    CHECK(std::get<Pattern>(without_needless_layers(as_layers(pattern))) == pattern);
    // What the layer does to it keeps it a layer.
    CHECK(std::holds_alternative<LayeredPattern>(without_needless_layers({{layer(pattern, 0.5)}})));
    const Layer late = layer(pattern, 1.0, 0.1);
    CHECK(std::holds_alternative<LayeredPattern>(without_needless_layers({{late}})));
}

TEST_CASE("layers: muting one moves nothing, and all mute is silence as long") {
    LayeredPattern layered{{layer(tone(1.0, 60.0, 0.2)), layer(tone(1.0, 90.0, 0.5), 1.0, 0.3)}};
    const double whole_s = duration_s(layered);
    CHECK(whole_s == doctest::Approx(0.8));
    layered.layers[1].mute = true;
    CHECK(duration_s(layered) == whole_s);
    CHECK(peak_g(render(layered)) > 0.0);
    layered.layers[0].mute = true;
    CHECK(peak_g(render(layered)) == 0.0);
    layered.layers[1].solo = true;  // solo counts more than mute
    CHECK(energy(render(layered), 0.0, 0.3) == 0.0);
    CHECK(energy(render(layered), 0.3, 0.8) > 0.0);
}

TEST_CASE("layers: a tick over another layer adds its energy, whatever the ms at which it comes") {
    const Pattern bed = tone(0.5, 100.0, 0.6);
    const Pattern tick = ticks({0.0}, 0.022);
    const double of_tick = energy(render(tick), 0.0, 0.022);
    for (int ms = 0; ms < 10; ++ms) {
        const double at_s = 0.2 + 0.001 * ms;
        const LayeredPattern layered{{layer(bed), layer(tick, 1.0, at_s)}};
        const double below = energy(render(bed), at_s, at_s + 0.022);
        const double level = energy(render(layered), at_s, at_s + 0.022);
        CHECK(level == doctest::Approx(below + of_tick).epsilon(0.01));
    }
}

TEST_CASE("layers: a recording sounds at any rate, and its labels stay") {
    const LayeredPattern layered{{layer(tone(0.2, 50.0, 0.1)), recording({0.0, 0.5, -0.5, 0.1})}};
    const Waveform sum = render(layered);
    CHECK(sum.samples_g[2] == render(tone(0.2, 50.0, 0.1)).samples_g[2] - 0.5);
    CHECK(render(layered, 20'000.0).samples_g.size() == 2000);
    PatternSet set = set_of({layered});
    CHECK(!is_synthetic(set.vibrations[0]));
    std::get<Measurement>(std::get<LayeredPattern>(set.vibrations[0].source).layers[1].source)
        .synthetic = true;
    CHECK(is_synthetic(set.vibrations[0]));
    CHECK(recordings_in(set.vibrations[0]).size() == 1);
    CHECK(patterns_in(set.vibrations[0]).size() == 1);
    CHECK(flattened(layered).waveform->samples_g == sum.samples_g);
}

TEST_CASE("layers: a set file holds them to the last bit, with what it does not know of them") {
    LayeredPattern layered{
        {layer(tone(1.0 / 3.0, 60.0, 0.2)), layer(ticks({0.1}, 0.9), 0.7, 0.05)}};
    layered.layers[0].name = "bed";
    layered.layers[1].mute = true;
    layered.layers[1].solo = true;
    const PatternSet set = set_of({layered});
    const auto again = parse_set(print_set(set), "s.json", {});
    REQUIRE_MESSAGE(again, (again ? "" : again.error().message));
    CHECK(*again == set);
    const std::string with_more = R"({"tactspace": 1, "patterns": [{"name": "a", "layers":
        [{"name": "bed", "amplitude_g": 1, "tension": 3}, {"transients": [{"time_s": 0.1, "x": 2}]}]}]})";
    const auto known = parse_set(with_more, "s.json", {});
    REQUIRE_MESSAGE(known, (known ? "" : known.error().message));
    const std::string text = print_set(*known);
    CHECK(text.find("\"tension\": 3") != text.npos);
    CHECK(text.find("\"x\": 2") != text.npos);
    CHECK(vibrations_fingerprint(*known) == vibrations_fingerprint(*parse_set(text, "s.json", {})));
}

TEST_CASE("layers: what is refused of them is told with its place") {
    const auto refusal = [](const std::string& layers) {
        const auto set =
            parse_set(R"({"tactspace": 1, "patterns": [{"name": "a", "layers": )" + layers + "}]}",
                      "s.json", {});
        return set ? std::string() : set.error().message;
    };
    CHECK(refusal("[]").starts_with("s.json: /patterns/0/layers: expected"));
    CHECK(refusal("[{}, {}, {}, {}, {}]").starts_with("s.json: /patterns/0/layers: expected"));
    CHECK(refusal(R"([{"gain": -1}])") ==
          "s.json: /patterns/0/layers/0/gain: expected a number from 0 to 10, got -1");
    CHECK(refusal(R"([{"offset_s": 61}])") ==
          "s.json: /patterns/0/layers/0/offset_s: expected a number from 0 to 60, got 61");
    CHECK(refusal(R"([{"amplitude_g": 99}])")
              .starts_with("s.json: /patterns/0/layers/0/amplitude_g"));
    CHECK(
        refusal(R"([{"offset_s": 59.5}])") ==
        "s.json: /patterns/0/layers of \"a\": expected layers that end within 60 s, the last ends "
        "at 60.5 s");
}

TEST_CASE("layers: one bed and ticks are one pattern exactly, several beds are traced and say so") {
    Pattern bed = tone(0.4, 95.0, 0.3);
    bed.rhythm = {"x=7-", 0.05};
    bed.frequency_curve = {{0.05, 80.0}, {0.2, 160.0}};
    bed.carriers = {{95.0, 1.0, 0.4}, {190.0, 0.5, 0.0}};
    const LayeredPattern exact{{layer(bed, 0.5, 0.2), layer(ticks({0.0, 0.8}, 1.0), 1.0)}};
    const OnePattern one = as_one_pattern(exact);
    CHECK(one.remarks.empty());
    const Waveform expected = render(exact);
    const Waveform got = render(one.pattern);
    REQUIRE(got.samples_g.size() == expected.samples_g.size());
    for (std::size_t n = 0; n < got.samples_g.size(); ++n) {
        REQUIRE(std::abs(got.samples_g[n] - expected.samples_g[n]) < 1e-9);
    }
    const LayeredPattern both{{layer(tone(1.0, 60.0, 0.5)), layer(tone(1.0, 200.0, 0.5))}};
    const OnePattern traced = as_one_pattern(both);
    REQUIRE(traced.remarks.size() == 3);
    CHECK(traced.remarks[0] == "layer 1: merged with the others, 50 % of their energy");
    CHECK(traced.remarks[1] == "layer 2: merged with the others, 50 % of their energy");
    CHECK(traced.remarks[2].starts_with("layers that sound at once are traced as one carrier"));
    CHECK(traced.pattern.duration_s == doctest::Approx(0.5));
    Pattern beating = tone(1.0, 60.0, 0.5);
    beating.modulation.frequency_hz = 3.0;
    CHECK(as_one_pattern({{layer(beating, 1.0, 0.1)}}).remarks.size() == 1);
    CHECK(peak_g(render(as_one_pattern({{layer(bed, 0.0)}}).pattern)) == 0.0);
}

TEST_CASE("layers: HJIF holds beds at once, which come back as layers of the same sum") {
    Vibration vibration;
    vibration.name = "two beds";
    LayeredPattern layered;
    Pattern notes = tone(0.5, 220.0, 0.5);
    notes.rhythm = {"x-x=", 0.125};
    layered.layers = {layer(tone(0.3, 60.0, 0.8)), layer(notes, 0.8, 0.25),
                      layer(ticks({0.1, 0.6}, 0.7))};
    layered.layers[0].name = "hum";
    vibration.source = layered;
    const auto target = export_target_named("hjif");
    REQUIRE(target);
    const ExportedPattern out = exported(vibration, *target);
    const auto* back = std::get_if<LayeredPattern>(&out.back);
    REQUIRE(back != nullptr);
    REQUIRE(back->layers.size() == 2);
    CHECK(back->layers[0].name == "hum");
    CHECK(back->layers[1].name == "layer 2");
    // Whole Hz and ticks of 25 us hold it, so that only the ticks' length differs.
    LayeredPattern beds = layered;
    beds.layers.pop_back();
    LayeredPattern back_beds = *back;
    for (Layer& one : back_beds.layers) std::get<Pattern>(one.source).transients.clear();
    const std::vector<double> meant = render(beds).samples_g;
    const std::vector<double> got = render(back_beds).samples_g;
    REQUIRE(got.size() >= meant.size());
    for (std::size_t n = 0; n < meant.size(); ++n) REQUIRE(std::abs(got[n] - meant[n]) < 1e-9);
    CHECK(std::get<Pattern>(back->layers[0].source).transients.size() == 2);
    // Two of one course are carriers of one pattern in a file, which is the same sum.
    LayeredPattern alike;
    alike.layers = {layer(tone(0.3, 60.0, 0.8)), layer(tone(0.2, 200.0, 0.8))};
    vibration.source = alike;
    const ExportedPattern one_course = exported(vibration, *target);
    CHECK(one_course.error);
    CHECK(one_course.remarks.back() == "its 2 layers come back as fewer, as some have one course");
    const auto* carriers = std::get_if<Pattern>(&one_course.back);
    REQUIRE(carriers != nullptr);
    CHECK(carriers->carriers.size() == 2);
    const std::vector<double> of_layers = render(alike).samples_g;
    const std::vector<double> of_carriers = render(*carriers).samples_g;
    for (std::size_t n = 0; n < of_layers.size(); ++n) {
        REQUIRE(std::abs(of_layers[n] - of_carriers[n]) < 1e-9);
    }
    // With a third one beside them, there are two left.
    alike.layers.push_back(layer(notes, 0.8, 0.25));
    vibration.source = alike;
    const ExportedPattern three = exported(vibration, *target);
    const auto* two = std::get_if<LayeredPattern>(&three.back);
    REQUIRE(two != nullptr);
    CHECK(two->layers.size() == 2);
    vibration.source = layered;
    // Another format says of each layer what it was of the whole.
    const auto ahap = export_target_named("ahap");
    REQUIRE(ahap);
    const ExportedPattern merged = exported(vibration, *ahap);
    CHECK(std::ranges::any_of(merged.remarks, [](const std::string& remark) {
        return remark.starts_with("hum: merged with the others, ");
    }));
    CHECK(std::holds_alternative<Pattern>(merged.back));
}

TEST_CASE("layers: felt steps are those of the layers, and of what they are at all") {
    const auto two = [](double first_g, double offset_s) {
        return LayeredPattern{
            {layer(tone(first_g, 60.0, 0.5)), layer(ticks({0.1}, 0.4), 1.0, offset_s)}};
    };
    const PatternSet set =
        set_of({two(1.0, 0.0), two(1.001, 0.0), two(1.2, 0.0), two(5.0, 0.0), two(1.0, 0.05)});
    CHECK(pair_verdict(set, 0, 1) == PairVerdict::same);
    CHECK(pair_verdict(set, 0, 2) == PairVerdict::close);
    CHECK(pair_verdict(set, 0, 3) == PairVerdict::clear);
    CHECK(pair_verdict(set, 0, 4) == PairVerdict::shape);
    // A gain of 2 is twice the amplitude.
    LayeredPattern louder = two(0.5, 0.0);
    louder.layers[0].gain = 2.0;
    const PatternSet alike = set_of({two(1.0, 0.0), louder});
    CHECK(pair_verdict(alike, 0, 1) == PairVerdict::same);
}

}  // namespace layers_test
