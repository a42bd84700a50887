// XR_EXT_haptic_parametric of OpenXR, as initialisers in C.
//
// Source    the extension's specification: points of 0 to 1 at ns from the first one at 0, 2 to 500
//           of each curve, at most 500 transients, those within 1 ms are merged; 0 and 1 of
//           frequency are minFrequencyHz and maxFrequencyHz, straight between.
// Guessed   that times have to rise: the second point of a jump is 1 ns later.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/written_text.h"
#include "model/io/formats/openxr/openxr.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr std::size_t kMostXrPoints = 500;
constexpr std::size_t kMostXrTaps = 500;

std::int64_t whole_ns(double t_s) { return std::llround(t_s * 1e9); }

std::string c_float(double value) {
    std::string text = significant_digits(value, 9);
    if (text.find_first_of(".e") == text.npos) text += ".0";
    return text + "f";
}

std::string point_array(const std::string& name, const AmplitudeCurve& curve) {
    std::string text = "static const XrHapticParametricPointEXT " + name + "[] = {\n";
    std::int64_t last_ns = -1;
    for (const AmplitudePoint& point : curve) {
        last_ns = std::max(whole_ns(point.time_s), last_ns + 1);
        text += "    {" + std::to_string(last_ns) + ", " + c_float(point.value) + "},\n";
    }
    return text + "};\n";
}

std::string tap_array(const std::string& name, const std::vector<TapShares>& taps) {
    std::string text = "static const XrHapticParametricTransientEXT " + name + "[] = {\n";
    for (const TapShares& tap : taps) {
        text += "    {" + std::to_string(whole_ns(tap.time_s)) + ", " + c_float(tap.amplitude) +
                ", " + c_float(tap.frequency) + "},\n";
    }
    return text + "};\n";
}

void remark_merged_taps(const std::vector<TapShares>& taps, std::vector<std::string>& remarks) {
    std::size_t close = 0;
    for (std::size_t k = 1; k < taps.size(); ++k) {
        if (taps[k].time_s - taps[k - 1].time_s < 0.001) ++close;
    }
    if (close == 0) return;
    remarks.push_back(transients_text(close) + ": merged with one less than 1 ms before");
}

std::string structure(const std::string& name, const Shares& shares, Range band_hz) {
    const auto count = [](std::size_t n) { return std::to_string(n); };
    const std::string taps = shares.taps.empty() ? "NULL" : name + "_transients";
    return "static const XrHapticParametricVibrationEXT " + name + " = {\n" +
           "    .type = XR_TYPE_HAPTIC_PARAMETRIC_VIBRATION_EXT,\n    .next = NULL,\n" +
           "    .amplitudePointCount = " + count(shares.amplitude.size()) + ",\n" +
           "    .amplitudePoints = " + name + "_amplitude,\n" +
           "    .frequencyPointCount = " + count(shares.frequency.size()) + ",\n" +
           "    .frequencyPoints = " + name + "_frequency,\n" +
           "    .transientCount = " + count(shares.taps.size()) + ",\n" +
           "    .transients = " + taps + ",\n" + "    .minFrequencyHz = " + c_float(band_hz.low) +
           ",\n" + "    .maxFrequencyHz = " + c_float(band_hz.high) + ",\n" +
           "    .streamFrameType = XR_HAPTIC_PARAMETRIC_STREAM_FRAME_TYPE_NONE_EXT,\n};\n";
}

}  // namespace

WrittenEffect write_openxr(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    ActuatorMap map = target.map;
    map.frequency_law = FrequencyLaw::linear;
    Shares shares = as_shares(as_curves(pattern, written), map, written);
    if (shares.frequency.front().time_s > 0.0) {
        shares.frequency.insert(shares.frequency.begin(), {0.0, shares.frequency.front().value});
    }
    if (shares.frequency.size() == 1) {
        shares.frequency.push_back({shares.duration_s, shares.frequency.front().value});
    }
    thin_shares(shares, kMostXrPoints, map, written.coarse);
    keep_strongest(shares.taps, kMostXrTaps, written.remarks);
    remark_merged_taps(shares.taps, written.remarks);
    const std::string name = identifier(target.name);
    written.text = point_array(name + "_amplitude", shares.amplitude) +
                   point_array(name + "_frequency", shares.frequency);
    if (!shares.taps.empty()) written.text += tap_array(name + "_transients", shares.taps);
    written.text += structure(name, shares, map.frequency_hz);
    return written;
}

}  // namespace tact
