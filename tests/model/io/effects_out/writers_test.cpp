// Numbers of small files, worked out by hand or taken from the tests of the formats' owners.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include "model/io/effects_out/stepped.h"
#include "model/io/formats/read_effects.h"
#include "model/io/formats/write_effect.h"
#include "model/text/json_fields.h"

namespace writers_test {

using namespace tact;

namespace {

WrittenEffect written(TargetFormat format, const Pattern& pattern,
                      const std::string& name = "one") {
    return write_effect(format, pattern, {name, bundled_actuator(traits(format).map)});
}

Json json_of(const WrittenEffect& effect) {
    const auto document = parse_json(effect.text, "a.json");
    REQUIRE_MESSAGE(document, (document ? "" : document.error().message));
    return *document;
}

bool has_remark(const WrittenEffect& effect, const std::string& words) {
    const auto has = [&](const std::string& remark) { return remark.find(words) != remark.npos; };
    return std::ranges::any_of(effect.remarks, has) || std::ranges::any_of(effect.coarse, has);
}

Pattern tone(double hz, double amplitude_g = 0.5, double duration_s = 1.0) {
    Pattern pattern;
    pattern.amplitude_g = amplitude_g;
    pattern.carriers.front().frequency_hz = hz;
    pattern.duration_s = duration_s;
    return pattern;
}

// Bends often enough for any limit on points.
Pattern zigzag(int points, double step_s) {
    Pattern pattern = tone(150.0);
    for (int k = 0; k < points; ++k) {
        pattern.amplitude_curve.push_back({k * step_s, k % 2 == 0 ? 0.0 : 0.5 + 0.003 * k});
    }
    pattern.duration_s = (points - 1) * step_s;
    return pattern;
}

}  // namespace

TEST_CASE("writers: amplitudes in steps are those of Meta's converter") {
    const SteppedAmplitudes three = stepped({{0.0, 0.0}, {3.0, 1.0}}, 3.0, 1.0);
    CHECK(three.timings_ms == std::vector<int>{1000, 1000, 1000});
    CHECK(three.amplitudes == std::vector<int>{1, 127, 255});
    const SteppedAmplitudes longer = stepped({{0.0, 0.0}, {3.5, 1.0}}, 3.5, 1.0);
    CHECK(longer.timings_ms == std::vector<int>{1000, 1000, 1000, 500});
    CHECK(longer.amplitudes == std::vector<int>{1, 101, 204, 255});
}

TEST_CASE("writers: a point on a straight line does not change its steps") {
    CHECK(stepped({{0.0, 0.0}, {0.5, 0.5}, {1.0, 1.0}}, 1.0, 0.1).amplitudes ==
          stepped({{0.0, 0.0}, {1.0, 1.0}}, 1.0, 0.1).amplitudes);
}

TEST_CASE("writers: steps are 0 in rests alone") {
    const AmplitudeCurve beats{{0.0, 1.0}, {0.02, 1.0}, {0.02, 0.0}, {0.04, 0.0}, {0.06, 0.9}};
    const SteppedAmplitudes steps = stepped(beats, 0.06, 0.01);
    CHECK(steps.timings_ms == std::vector<int>{20, 20, 10, 10});
    CHECK(steps.amplitudes == std::vector<int>{255, 0, 1, 229});
}

TEST_CASE("writers: timings are whole ms and silence is 0, as they were read") {
    // As a file of pulses of Hapticlabs' kind has them, shorter and longer than 10 ms.
    const std::vector<int> timings{12, 30, 11, 30, 11, 30, 40};
    const std::vector<int> amplitudes{80, 0, 160, 0, 240, 0, 120};
    const std::string pulses =
        Json{{"timings", timings}, {"amplitudes", amplitudes}, {"repeat", -1}}.dump();
    const auto read = read_effects(pulses, "pulses.json");
    REQUIRE(read);
    const Pattern& pattern = read->effects.front().pattern;
    const Json again = json_of(written(TargetFormat::android_timings, pattern));
    CHECK(again.at("timings") == Json(timings));
    CHECK(again.at("amplitudes") == Json(amplitudes));
    const Json hla = json_of(written(TargetFormat::hla, pattern));
    CHECK(hla.at("Timings") == Json(timings));
    CHECK(hla.at("Amplitudes") == Json(amplitudes));
    const WrittenEffect xml = written(TargetFormat::android_xml, pattern);
    const auto back = read_effects(xml.text, "pulses.xml");
    REQUIRE(back);
    const AmplitudeCurve& kept = back->effects.front().pattern.amplitude_curve;
    REQUIRE(kept.size() == pattern.amplitude_curve.size());
    for (std::size_t k = 0; k < kept.size(); ++k) {
        CAPTURE(k);
        CHECK(kept[k].time_s == doctest::Approx(pattern.amplitude_curve[k].time_s).epsilon(1e-12));
        CHECK(kept[k].value == doctest::Approx(pattern.amplitude_curve[k].value).epsilon(1e-12));
    }
}

TEST_CASE("writers: HJIF leaves out carriers that its own reader refuses, and says so") {
    Pattern pattern = tone(100.0);
    pattern.carriers.push_back({900.0, 1.0, 0.0});
    pattern.frequency_curve = {{0.0, 200.0}, {1.0, 400.0}};  // the second one is at 1.8 to 3.6 kHz
    const WrittenEffect all = written(TargetFormat::hjif, pattern);
    CHECK(has_remark(all, "a carrier of 3600 Hz is left out"));
    auto back = read_effects(all.text, "a.hjif");
    REQUIRE(back);
    CHECK(back->effects.front().pattern.carriers.size() == 1);
    CHECK(envelope_g(back->effects.front().pattern, 0.5) == doctest::Approx(0.5));
    pattern.frequency_curve = {{0.0, 100.0}, {1.0, 200.0}};  // it crosses 1 kHz at 0.111 s
    const WrittenEffect part = written(TargetFormat::hjif, pattern);
    CHECK(has_remark(part, "a carrier that rises to 1800 Hz is silent above 1,000 Hz"));
    back = read_effects(part.text, "a.hjif");
    REQUIRE(back);
    CHECK(envelope_g(back->effects.front().pattern, 0.05) == doctest::Approx(0.5 * std::sqrt(2.0)));
    CHECK(envelope_g(back->effects.front().pattern, 0.5) == doctest::Approx(0.5));
    CHECK(first_carrier_hz(back->effects.front().pattern, 0.5) == doctest::Approx(150.0));
}

TEST_CASE("writers: HJIF has all keys that the standard requires, and whole Hz and ticks") {
    Pattern pattern = tone(72.4);
    pattern.carriers.push_back({200.0, 0.5, 0.0});
    pattern.transients = {{0.10003, 0.4, 90.0, 0.022, TransientShape::sine}};
    const WrittenEffect effect = written(TargetFormat::hjif, pattern);
    const Json hjif = json_of(effect);
    CHECK(hjif.at("version") == "2023");
    CHECK(hjif.at("profile") == "Main");
    CHECK(hjif.at("level") == 1);
    CHECK(hjif.at("timescale") == 40000);
    CHECK(hjif.at("date").is_string());
    CHECK(hjif.at("description").is_string());
    CHECK(hjif.at("avatars") == Json::array());
    CHECK(hjif.at("syncs") == Json::array());
    const Json& perception = hjif.at("perceptions").at(0);
    CHECK(perception.at("avatar_id") == 0);
    for (const char* key : {"id", "description", "perception_modality", "reference_devices",
                            "effect_library", "channels"}) {
        CHECK(perception.contains(key));
    }
    const Json& channel = perception.at("channels").at(0);
    for (const char* key : {"id", "description", "gain", "mixing_coefficient", "body_part_mask"}) {
        CHECK(channel.contains(key));
    }
    const Json& bands = channel.at("bands");
    REQUIRE(bands.size() == 3);
    CHECK(bands[0].at("band_type") == "VectorialWave");
    CHECK(bands[2].at("band_type") == "Transient");
    for (const Json& band : bands) {
        CHECK(band.at("lower_frequency_limit").is_number_integer());
        CHECK(band.at("upper_frequency_limit").is_number_integer());
        for (const Json& one : band.at("effects")) {
            CHECK(one.at("position").is_number_integer());
            for (const Json& frame : one.at("keyframes")) {
                CHECK(frame.at("relative_position").is_number_integer());
                if (!frame.contains("frequency_modulation")) continue;
                CHECK(frame.at("frequency_modulation").is_number_integer());
            }
        }
    }
    CHECK(has_remark(effect, "frequencies are whole Hz, times whole ticks of 25 us"));
    for (int k = 0; k < 6; ++k) pattern.carriers.push_back({100.0 + k, 0.1, 0.0});
    CHECK(json_of(written(TargetFormat::hjif, pattern)).at("level") == 2);
}

TEST_CASE("writers: curves of AHAP have 16 points at most, each begins where the last one ended") {
    const Json ahap = json_of(written(TargetFormat::ahap, zigzag(40, 0.05)));
    std::vector<Json> curves;
    for (const Json& entry : ahap.at("Pattern")) {
        if (entry.contains("ParameterCurve")) curves.push_back(entry.at("ParameterCurve"));
    }
    REQUIRE(curves.size() == 3);
    double end_s = 0.0;
    double value = 0.0;
    for (const Json& curve : curves) {
        const Json& points = curve.at("ParameterCurveControlPoints");
        CHECK(points.size() <= 16);
        CHECK(points.front().at("Time") == 0.0);
        CHECK(points.front().at("ParameterValue") == value);
        CHECK(curve.at("Time").get<double>() == doctest::Approx(end_s));
        end_s = curve.at("Time").get<double>() + points.back().at("Time").get<double>();
        value = points.back().at("ParameterValue");
    }
    CHECK(end_s == doctest::Approx(1.95));
}

TEST_CASE("writers: events of AHAP last 30 s at most") {
    const Json ahap = json_of(written(TargetFormat::ahap, tone(150.0, 0.3, 45.0)));
    REQUIRE(ahap.at("Pattern").size() == 2);
    CHECK(ahap.at("Pattern")[0].at("Event").at("EventDuration") == 30.0);
    CHECK(ahap.at("Pattern")[1].at("Event").at("Time") == 30.0);
    CHECK(ahap.at("Pattern")[1].at("Event").at("EventDuration") == 15.0);
}

TEST_CASE(
    "writers: transients of AHAP pass where nothing continuous sounds, beside it they do not") {
    Pattern pattern = tone(150.0, 0.3);
    pattern.rhythm = {"xx--xxxx", 0.125};
    pattern.transients = {{0.3, 0.4, 150.0, 0.022, TransientShape::sine}};
    const WrittenEffect rest = written(TargetFormat::ahap, pattern);
    CHECK_FALSE(has_remark(rest, "weaker beneath the intensity control"));
    const auto back = read_effects(rest.text, "a.ahap");
    REQUIRE(back);
    REQUIRE(back->effects[0].pattern.transients.size() == 1);
    CHECK(back->effects[0].pattern.transients[0].amplitude_g == doctest::Approx(0.4));
    CHECK(envelope_g(back->effects[0].pattern, 0.3) == 0.0);
    CHECK(envelope_g(back->effects[0].pattern, 0.2) == doctest::Approx(0.3));
    CHECK(envelope_g(back->effects[0].pattern, 0.6) == doctest::Approx(0.3));
    pattern.transients[0].time_s = 0.6;
    pattern.transients[0].amplitude_g = 0.9;
    pattern.amplitude_curve = {{0.0, 0.9}, {1.0, 1.0}};
    CHECK(has_remark(written(TargetFormat::ahap, pattern),
                     "1 transient: weaker beneath the intensity control"));
}

TEST_CASE(
    "writers: Android's envelopes have 16 points at most, 20 ms apart, and say what it costs") {
    const WrittenEffect effect = written(TargetFormat::android_xml, zigzag(80, 0.007));
    pugi::xml_document xml;
    REQUIRE(xml.load_string(effect.text.c_str()));
    const auto envelope = xml.child("vibration-effect").child("waveform-envelope-effect");
    int points = 0;
    int total_ms = 0;
    for (const auto& point : envelope.children("control-point")) {
        ++points;
        total_ms += point.attribute("durationMs").as_int();
        CHECK(point.attribute("durationMs").as_int() >= 20);
        CHECK(point.attribute("frequencyHz").as_double() == 150.0);
    }
    CHECK(points == 16);
    CHECK(total_ms == 553);
    CHECK(has_remark(effect, "80 points thinned to 17, at least 20 ms apart"));
    const WrittenEffect kotlin = written(TargetFormat::android_kotlin, zigzag(80, 0.007), "my 1");
    CHECK(kotlin.remarks == effect.remarks);
    CHECK(kotlin.text.find("val `my_1`: VibrationEffect") != std::string::npos);
    CHECK(kotlin.text.find("    .setInitialFrequencyHz(150f)\n") != std::string::npos);
    CHECK(kotlin.text.find("    .build()\n") != std::string::npos);
}

TEST_CASE("writers: an Android envelope begins in silence, and rises as soon as its points may") {
    Pattern falls = tone(150.0);
    falls.amplitude_curve = {{0.0, 1.0}, {falls.duration_s, 0.2}};
    for (const Pattern& pattern : {tone(150.0), falls}) {
        pugi::xml_document xml;
        REQUIRE(xml.load_string(written(TargetFormat::android_xml, pattern).text.c_str()));
        const auto first =
            xml.child("vibration-effect").child("waveform-envelope-effect").child("control-point");
        CHECK(first.attribute("durationMs").as_int() == 20);
        CHECK(first.attribute("amplitude").as_double() > 0.9 * pattern.amplitude_g);
    }
}

TEST_CASE("writers: a rhythm of more notes than Android has points for is not only ramps") {
    Pattern pattern = tone(150.0);
    pattern.rhythm = {"x---x-", 0.05};
    pattern.duration_s = 0.3;
    const WrittenEffect few = written(TargetFormat::android_xml, pattern);
    CHECK(few.coarse == std::vector<std::string>{"4 jumps become ramps of 20 ms or more"});
    pattern.duration_s = 3.0;
    const WrittenEffect many = written(TargetFormat::android_xml, pattern);
    CHECK(has_remark(many, "jumps become ramps of 20 ms or more"));
    CHECK(has_remark(many, "points thinned to 17, at least 20 ms apart"));
}

TEST_CASE("writers: events of .he have 4 to 16 points and last 5 s at most") {
    for (const Pattern& pattern :
         {zigzag(300, 0.04), tone(150.0, 0.4, 12.0), tone(90.0, 1.0, 0.02)}) {
        const Json he = json_of(written(TargetFormat::he, pattern));
        const Json& events = he.at("PatternList")[0].at("Pattern");
        CHECK(events.size() <= 128);
        for (const Json& entry : events) {
            const Json& event = entry.at("Event");
            CHECK(event.at("Duration").get<int>() <= 5000);
            const Json& curve = event.at("Parameters").at("Curve");
            CHECK(curve.size() >= 4);
            CHECK(curve.size() <= 16);
            for (const Json& point : curve) {
                CHECK(point.at("Time").is_number_integer());
                CHECK(point.at("Frequency").is_number_integer());
            }
            CHECK(curve.back().at("Time") == event.at("Duration"));
        }
    }
}

TEST_CASE("writers: OpenXR's points begin at 0 ns and rise, also at a jump") {
    Pattern pattern = tone(127.5, 0.5, 0.5);
    pattern.amplitude_curve = {{0.0, 1.0}, {0.25, 1.0}, {0.25, 0.5}, {0.5, 0.5}};
    pattern.transients = {{0.1, 0.3, 55.0, 0.0364, TransientShape::sine}};
    const std::string text = written(TargetFormat::openxr, pattern, "2 taps").text;
    const auto has = [&](const std::string& words) { return text.find(words) != text.npos; };
    CHECK(
        has("effect_2_taps_amplitude[] = {\n    {0, 0.5f},\n    {250000000, 0.5f},\n"
            "    {250000001, 0.25f},\n    {500000000, 0.25f},\n};"));
    CHECK(has("effect_2_taps_frequency[] = {\n    {0, 0.5f},\n    {500000000, 0.5f},\n};"));
    CHECK(has("_transients[] = {\n    {100000000, 0."));
    CHECK(has(".amplitudePointCount = 4,"));
    CHECK(has(".transientCount = 1,"));
    CHECK(has(".minFrequencyHz = 55.0f,"));
    CHECK(has(".maxFrequencyHz = 200.0f,"));
}

TEST_CASE("writers: .hla names its track and joins equal steps") {
    const Json hla = json_of(written(TargetFormat::hla, tone(165.0, 1.0, 0.105), "buzz"));
    CHECK(hla.at("TrackName") == "buzz");
    CHECK(hla.at("Duration") == 105);
    CHECK(hla.at("Timings") == Json::array({105}));
    CHECK(hla.at("Amplitudes") == Json::array({255}));
}

TEST_CASE("writers: each loss is said in words") {
    Pattern pattern = tone(150.0);
    pattern.carriers = {{150.0, 1.0, 0.0}, {230.0, 0.4, 0.0}};
    CHECK(has_remark(written(TargetFormat::haptic, pattern), "2 carriers merged into 150 Hz"));
    CHECK(has_remark(written(TargetFormat::haptic, tone(420.0)),
                     "420 Hz is out of the band, written as 200 Hz"));
    CHECK(has_remark(written(TargetFormat::haptic, tone(150.0, 2.0)),
                     "louder than full scale: scaled by 0.5"));
    CHECK(has_remark(written(TargetFormat::android_timings, tone(150.0)),
                     "150 Hz left out: the device has its own frequency"));
    pattern = tone(150.0);
    pattern.modulation.frequency_hz = 4.0;
    CHECK(has_remark(written(TargetFormat::pulsar, pattern),
                     "modulation of 4 Hz is drawn into the amplitude"));
    pattern.modulation.frequency_hz = 80.0;
    CHECK(has_remark(written(TargetFormat::pulsar, pattern), "too fast for an envelope"));
    pattern = tone(150.0);
    pattern.transients = {{0.5, 0.8, 420.0, 0.1, TransientShape::sine}};
    const WrittenEffect effect = written(TargetFormat::haptic, pattern);
    CHECK(has_remark(effect, "1 transient: another frequency, the first 165 Hz in place of 420"));
    CHECK(has_remark(effect, "1 transient: another length, the first 12.1 ms in place of 100"));
    CHECK(has_remark(effect, "1 transient: sine and square exchanged"));
    CHECK(has_remark(effect, "what is beneath 1 transient is ducked to 0.5 by its player"));
    CHECK(has_remark(written(TargetFormat::android_xml, pattern),
                     "a transient is written as a pulse of the amplitude"));
    pattern.carriers[0].phase_rad = 1.0;
    CHECK(has_remark(written(TargetFormat::he, pattern), "the phase of its carrier is left out"));
}

TEST_CASE("writers: carriers are as loud as they are together, beats of up to 25 Hz and all") {
    Pattern pattern = tone(150.0, 0.1);
    pattern.carriers = {{150.0, 3.0, 0.0}, {230.0, 4.0, 0.0}};
    auto read = read_effects(written(TargetFormat::pulsar, pattern).text, "a.json");
    REQUIRE(read);
    CHECK(envelope_g(read->effects[0].pattern, 0.5) == doctest::Approx(0.5));
    CHECK(read->effects[0].pattern.carriers[0].frequency_hz == doctest::Approx(230.0));
    pattern.carriers[1] = {154.0, 3.0, 0.0};
    read = read_effects(written(TargetFormat::pulsar, pattern).text, "a.json");
    REQUIRE(read);
    CHECK(envelope_g(read->effects[0].pattern, 0.25) == doctest::Approx(0.6).epsilon(0.01));
    CHECK(envelope_g(read->effects[0].pattern, 0.125) < 0.04);
}

TEST_CASE("writers: a slow modulation is met within 1 % where the format has points enough") {
    Pattern pattern = tone(150.0, 0.5);
    pattern.modulation.frequency_hz = 4.0;
    const auto read = read_effects(written(TargetFormat::pulsar, pattern).text, "a.json");
    REQUIRE(read);
    for (double t_s = 0.0; t_s < 1.0; t_s += 0.007) {
        const double own = 0.5 * std::abs(std::sin(2.0 * 3.14159265358979 * 4.0 * t_s));
        CHECK(std::abs(envelope_g(read->effects[0].pattern, t_s) - own) < 0.008);
    }
}

TEST_CASE("writers: every format of the table has its key") {
    for (std::size_t k = 0; k < target_formats().size(); ++k) {
        CHECK(target_format_of(target_formats()[k].key) == static_cast<TargetFormat>(k));
    }
    CHECK_FALSE(target_format_of("mp3"));
}

}  // namespace writers_test
