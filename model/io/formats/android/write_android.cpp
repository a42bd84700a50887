// Envelopes of Android 16: XML, and the builder's calls as Kotlin. What consists of primitives, as
// it was read, is a composition of them instead. What is flat between jumps and at the frequency
// that readers take for effects without one is a waveform of whole ms instead: it loses nothing
// there, where an envelope would have ramps.
//
// Source    VibrationEffect.WaveformEnvelopeBuilder (API 36): points of amplitude, Hz and the ms to
//           get there, from amplitude 0 on. Devices have at least 16 points of at least 20 ms each;
//           the platform splits segments longer than the device's longest, 1 s at least. What is
//           outside of the device's band is not played at all: moved into the map's. The XML's
//           parser is not public, hence the Kotlin. VibrationEffect.createWaveform (API 26).

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/io/effects_out/knots.h"
#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/stepped.h"
#include "model/io/effects_out/written_text.h"
#include "model/io/formats/android/android.h"
#include "model/io/formats/android/android_primitives.h"
#include "model/pattern/curves.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::size_t kMostControlPoints = 16;
constexpr double kShortestSegmentS = 0.020;
constexpr Range kOwnHz{163.0, 167.0};  // 165 Hz is what readers take where none is said

struct ControlPoint {
    double amplitude = 0.0;
    double frequency_hz = 0.0;
    std::int64_t duration_ms = 0;
};

struct AndroidEnvelope {
    double initial_hz = 0.0;
    std::vector<ControlPoint> points;
    SteppedAmplitudes steps;  // in its place, where there are any
};

bool is_at_own_hz(const FrequencyCurve& curve) {
    return std::ranges::all_of(
        curve, [](const FrequencyPoint& point) { return kOwnHz.contains(point.frequency_hz); });
}

AndroidEnvelope android_envelope(const Pattern& pattern, const ActuatorMap& map,
                                 WrittenEffect& written) {
    std::vector<std::string>& remarks = written.remarks;
    PlainCurves curves = with_pulses(as_curves(pattern, written), remarks);
    const double full_g = map.full_scale_g * map.continuous_gain;
    const double peak = full_g > 0.0 ? peak_value(curves.amplitude) / full_g : 0.0;
    const double scale = scale_to_full(peak, remarks);
    for (AmplitudePoint& point : curves.amplitude) {
        point.value = full_g > 0.0 ? std::min(scale * point.value / full_g, 1.0) : 0.0;
    }
    if (!(full_g > 0.0)) remarks.push_back("the actuator plays nothing continuous: silent");
    if (is_staircase(curves.amplitude) && is_at_own_hz(curves.frequency)) {
        remarks.push_back("written as a waveform: the device has its own frequency");
        written.coarse.push_back("amplitude is in whole ms and in steps of 1/255");
        return {0.0, {}, stepped(curves.amplitude, curves.duration_s, kShortestSegmentS)};
    }
    const FrequencyCurve hz = in_band(curves.frequency, map.frequency_hz, remarks);
    KnotRules rules;
    rules.most = kMostControlPoints + 1;  // the first one is where the player begins
    rules.least_gap_s = kShortestSegmentS;
    rules.frequency_unit = std::max(map.frequency_hz.high - map.frequency_hz.low, 1.0);
    rules.from_silence = true;
    rules.felt = [full_g](const Knot& knot) {
        return FeltTone{full_g * knot.amplitude, knot.frequency};
    };
    const FittedKnots fit =
        fitted_knots(curves.amplitude, heights_of(hz), curves.duration_s, rules);
    remark_fit(fit, rules, written.coarse);
    AndroidEnvelope envelope{fit.knots.front().frequency, {}, {}};
    for (std::size_t k = 1; k < fit.knots.size(); ++k) {
        const Knot& to = fit.knots[k];
        const double length_s = to.time_s - fit.knots[k - 1].time_s;
        envelope.points.push_back({to.amplitude, to.frequency, std::llround(1e3 * length_s)});
    }
    return envelope;
}

std::string kotlin_float(double value) { return significant_digits(value, 9) + "f"; }

std::string xml_of(const SteppedAmplitudes& steps) {
    std::string text = "<vibration-effect>\n    <waveform-effect>\n";
    for (std::size_t k = 0; k < steps.amplitudes.size(); ++k) {
        text += "        <waveform-entry durationMs=\"" + std::to_string(steps.timings_ms[k]) +
                "\" amplitude=\"" + std::to_string(steps.amplitudes[k]) + "\"/>\n";
    }
    return text + "    </waveform-effect>\n</vibration-effect>\n";
}

std::string list_of(const std::vector<int>& numbers) {
    std::string text;
    for (const int number : numbers) text += (text.empty() ? "" : ", ") + std::to_string(number);
    return text;
}

std::string as_camel_case(const std::string& name) {
    std::string text = identifier(name);
    if (text.front() >= 'A' && text.front() <= 'Z') {
        text.front() = static_cast<char>(text.front() - 'A' + 'a');
    }
    return text;
}

// Pauses before each, whole ms.
std::vector<std::int64_t> pauses_ms(const std::vector<PlayedPrimitive>& all) {
    std::vector<std::int64_t> pauses;
    double end_s = 0.0;
    for (const PlayedPrimitive& one : all) {
        pauses.push_back(std::llround(1e3 * (one.start_s - end_s)));
        end_s = one.end_s;
    }
    return pauses;
}

std::string xml_of(const std::vector<PlayedPrimitive>& all) {
    const std::vector<std::int64_t> pauses = pauses_ms(all);
    std::string text = "<vibration-effect>\n";
    for (std::size_t k = 0; k < all.size(); ++k) {
        text += "    <primitive-effect name=\"" + std::string(all[k].course->name) + "\"";
        if (all[k].scale < 1.0) {
            text += " scale=\"" + significant_digits(all[k].scale, 4) + "\"";
        }
        if (pauses[k] > 0) text += " delayMs=\"" + std::to_string(pauses[k]) + "\"";
        text += "/>\n";
    }
    return text + "</vibration-effect>\n";
}

std::string kotlin_of(const std::vector<PlayedPrimitive>& all) {
    const std::vector<std::int64_t> pauses = pauses_ms(all);
    const std::string composition = "VibrationEffect.Composition.";
    std::string text = "startComposition()\n";
    for (std::size_t k = 0; k < all.size(); ++k) {
        std::string name(all[k].course->name);
        for (char& letter : name) {
            if (letter != '_') letter = static_cast<char>(letter - 'a' + 'A');
        }
        text += "    .addPrimitive(" + composition + "PRIMITIVE_" + name + ", " +
                significant_digits(all[k].scale, 4) + "f, " + std::to_string(pauses[k]) + ")\n";
    }
    return text + "    .compose()\n";
}

void remark_primitives(WrittenEffect& written) {
    written.remarks.push_back("written as primitives: every device plays its own course of them");
    written.coarse.push_back("delays are in whole ms");
}

}  // namespace

WrittenEffect write_android_xml(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    if (const auto primitives = as_primitives(pattern, target.map)) {
        remark_primitives(written);
        written.text = xml_of(*primitives);
        return written;
    }
    const AndroidEnvelope envelope = android_envelope(pattern, target.map, written);
    if (!envelope.steps.amplitudes.empty()) {
        written.text = xml_of(envelope.steps);
        return written;
    }
    written.text = "<vibration-effect>\n    <waveform-envelope-effect initialFrequencyHz=\"" +
                   shortest_digits(envelope.initial_hz) + "\">\n";
    for (const ControlPoint& point : envelope.points) {
        written.text += "        <control-point amplitude=\"" + shortest_digits(point.amplitude) +
                        "\" frequencyHz=\"" + shortest_digits(point.frequency_hz) +
                        "\" durationMs=\"" + std::to_string(point.duration_ms) + "\"/>\n";
    }
    written.text += "    </waveform-envelope-effect>\n</vibration-effect>\n";
    return written;
}

WrittenEffect write_android_kotlin(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    const std::string head = "import android.os.VibrationEffect\n\nval `" +
                             as_camel_case(target.name) + "`: VibrationEffect = VibrationEffect.";
    if (const auto primitives = as_primitives(pattern, target.map)) {
        remark_primitives(written);
        written.text = head + kotlin_of(*primitives);
        return written;
    }
    const AndroidEnvelope envelope = android_envelope(pattern, target.map, written);
    if (!envelope.steps.amplitudes.empty()) {
        written.text = head + "createWaveform(\n    longArrayOf(" +
                       list_of(envelope.steps.timings_ms) + "),\n    intArrayOf(" +
                       list_of(envelope.steps.amplitudes) + "),\n    -1\n)\n";
        return written;
    }
    written.text = head + "WaveformEnvelopeBuilder()\n" + "    .setInitialFrequencyHz(" +
                   kotlin_float(envelope.initial_hz) + ")\n";
    for (const ControlPoint& point : envelope.points) {
        written.text += "    .addControlPoint(" + kotlin_float(point.amplitude) + ", " +
                        kotlin_float(point.frequency_hz) + ", " +
                        std::to_string(point.duration_ms) + ")\n";
    }
    written.text += "    .build()\n";
    return written;
}

}  // namespace tact
