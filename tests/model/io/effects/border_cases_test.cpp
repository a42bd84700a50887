// Small files of effects that once came in as something else, or not at all: each in the words of
// its outcome. Texts made for this purpose.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/model/io/effects/effects_of.h"

namespace border_cases_test {

using namespace tact;

namespace {

struct Case {
    const char* name;
    std::string text;
    std::string fault;                 // empty: it is read ...
    std::vector<std::string> remarks;  // ... and says these words
    double duration_s = 0.0;
};

const std::string kEntry = R"(<waveform-entry durationMs="10" amplitude="100"/>)";
const std::string kWaveform = "<waveform-effect>" + kEntry + "</waveform-effect>";
const std::string kPoint = R"(<control-point amplitude="1" frequencyHz="100" durationMs="20"/>)";
const std::string kEnvelope = "<waveform-envelope-effect>" + kPoint + "</waveform-envelope-effect>";
const std::string kPrimitive = R"(<primitive-effect name="click"/>)";
const std::string kVendor = "<vendor-effect>AAAA</vendor-effect>";

std::string vibration(const std::string& inside) {
    return "<vibration-effect>" + inside + "</vibration-effect>";
}

std::string repeating(const std::string& preamble, const std::string& part) {
    return vibration("<repeating-effect><preamble>" + preamble + "</preamble><repeating>" + part +
                     "</repeating></repeating-effect>");
}

std::string ahap(const std::string& time, const std::string& intensity) {
    return R"({"Pattern": [{"Event": {"Time": )" + time +
           R"(, "EventType": "HapticTransient", "EventParameters": [
           {"ParameterID": "HapticIntensity", "ParameterValue": )" +
           intensity + "}]}}]}";
}

std::vector<Case> cases() {
    return {
        {"u: a line before JSON",
         "\r\n\n"
         R"({"timings": [100, 50], "amplitudes": [255, 128]})",
         "",
         {},
         0.15},
        {"u: AHAP in ms", ahap("150", "1"), "", {"all whole: these may be ms"}, 60.0},
        {"u: AHAP in percent", ahap("0", "80"), "", {"of up to 80", "may be percent"}, 0.022},
        {"u: AHAP as it is", ahap("0.5", "1"), "", {}, 0.522},
        {"u: timings in s",
         R"({"timings": [0.1, 0.2], "amplitudes": [255, 0]})",
         "may be seconds",
         {}},
        {"u: timings as shares",
         R"({"timings": [100, 50], "amplitudes": [0.5, 1]})",
         "may be shares of 1",
         {}},
        {"u: lists of two lengths",
         R"({"timings": [100, 50], "amplitudes": [255]})",
         "expected as many as there are timings",
         {}},
        {"o: a curve in percent",
         R"({"MetaData": {"Version": 1.0}, "Channels": [{"Pattern": [{"Event": {"Type": "continuous",
             "StartTime": 0, "Duration": 54, "Parameters": {"Frequency": 30, "Intensity": 38, "Curve": [
             {"Time": 0, "Frequency": 0, "Intensity": 0}, {"Time": 1, "Frequency": 0, "Intensity": 80},
             {"Time": 40, "Frequency": 0, "Intensity": 0.5}, {"Time": 54, "Frequency": 0, "Intensity": 0}
             ]}}}]}]})",
         "Curve/1/Intensity: expected a number from 0 to 1, got 80",
         {}},
        {"o: no pattern",
         R"({"MetaData": {"Version": 1.0}, "Channels": [{"Parameters": {}}]})",
         "expected at least one event",
         {}},
        {"x: a line before XML", "\n" + vibration(kWaveform), "", {}, 0.01},
        {"x: a declaration and comments",
         "<?xml version=\"1.0\"?>\n<!-- a -->\n" + vibration("<!-- b -->" + kWaveform) +
             "\n<!-- c -->\n",
         "",
         {},
         0.01},
        {"x: entries that repeat",
         repeating(kEntry, kEntry + kEntry),
         "",
         {"repeats for ever", "165 Hz are guessed"},
         0.03},
        {"x: an envelope that repeats",
         repeating(kEntry, kEnvelope),
         "",
         {"repeats for ever"},
         0.03},
        {"x: two envelopes that repeat",
         repeating(kEntry, kEnvelope + kEnvelope),
         "repeating: expected one effect, got several",
         {}},
        {"x: nothing that repeats", vibration("<repeating-effect/>"), "expected <repeating>", {}},
        {"x: two roots",
         vibration(kWaveform) + vibration(kWaveform),
         "expected one <vibration-effect> and nothing else, got \"vibration-effect\"",
         {}},
        {"x: text behind the root",
         vibration(kWaveform) + " more",
         "expected one <vibration-effect> and nothing else, got \"more\"",
         {}},
        {"x: an attribute of nothing",
         vibration(
             R"(<waveform-effect><waveform-entry durationMs="1" amplitude="1" x="2"/></waveform-effect>)"),
         "waveform-entry: expected no attribute \"x\"",
         {}},
        {"x: an attribute of the root",
         "<vibration-effect a=\"1\">" + kWaveform + "</vibration-effect>",
         "expected no attribute \"a\"",
         {}},
        {"x: primitives",
         vibration(kPrimitive + kPrimitive),
         "",
         {"click: the course is assumed, every device has its own"},
         0.04},
        {"x: a primitive beside another effect",
         vibration(kPrimitive + kWaveform),
         "expected <primitive-effect> alone, got \"waveform-effect\"",
         {}},
        {"x: a primitive within another effect",
         repeating(kEntry, kPrimitive),
         "repeating: expected waveform-envelope-effect",
         {}},
        {"x: a vendor's effect", vibration(kVendor), "this one's course is the device's own", {}},
        {"x: some of several",
         "<vibration-select>" + vibration(kVendor) + vibration(kWaveform) + "</vibration-select>",
         "",
         {"1 of its vibrations are left out: their courses are the device's own"},
         0.01},
        {"x: none of several",
         "<vibration-select>" + vibration(kVendor) + "</vibration-select>",
         "this one's course is the device's own",
         {}},
        {"x: the old name",
         "<vibration>" + kWaveform + "</vibration>",
         "got \"vibration\", as older versions of Android have it",
         {}},
    };
}

}  // namespace

TEST_CASE("border: every small file has its outcome, in words") {
    for (const Case& one : cases()) {
        CAPTURE(one.name);
        const std::string got = fault(one.text);
        CAPTURE(got);
        if (!one.fault.empty()) {
            CHECK(got.find(one.fault) != got.npos);
            continue;
        }
        REQUIRE(got.empty());
        const Effect effect = only(one.text);
        CHECK(effect.pattern.duration_s == doctest::Approx(one.duration_s));
        for (const std::string& words : one.remarks) CHECK(has_remark(effect, words));
        if (one.remarks.empty()) CHECK_FALSE(has_remark(effect, "may be"));
    }
}

}  // namespace border_cases_test
