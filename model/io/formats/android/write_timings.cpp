// Android's timings and amplitudes as JSON, and Hapticlabs' .hla, which has the same two.
//
// Source    VibrationEffect.createWaveform: whole ms, 0 to 255; Hapticlabs' documentation of .hla;
//           slopes: model/io/effects_out/stepped.h
// Output    no frequency: the device has its own; each transient as a pulse; flat stretches are
//           kept to the ms, slopes are in steps of 1, 2, 5 or 10 ms, the shortest of which there
//           are not too many

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <numeric>

#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/stepped.h"
#include "model/io/formats/android/android.h"
#include "model/text/json_fields.h"
#include "model/text/numbers.h"
#include "model/text/utf8.h"

namespace tact {

namespace {

constexpr std::array kSlopeStepsMs{1, 2, 5, 10};
constexpr std::size_t kMostSteps = 10'000;  // of slopes: an effect is handed to a player whole
// Where the greatest amplitude is 1, readers cannot know 0 to 255 from shares of 1.
void lift_faintest(SteppedAmplitudes& steps, std::vector<std::string>& coarse) {
    if (std::ranges::max(steps.amplitudes) != 1) return;
    for (int& amplitude : steps.amplitudes) amplitude *= 2;
    coarse.emplace_back("the greatest amplitude is 2 of 255: 1 would be read as a share of 1");
}

// With the shortest steps of slopes of which there are not too many.
SteppedAmplitudes android_steps(const Pattern& pattern, const ActuatorMap& map,
                                WrittenEffect& written) {
    const PlainCurves curves = with_pulses(as_curves(pattern, written), written.remarks);
    const Shares shares = as_shares(curves, map, written);
    remark_left_out_hz(curves.frequency, written.remarks);
    for (const int step_ms : kSlopeStepsMs) {
        SteppedAmplitudes steps = stepped(shares.amplitude, curves.duration_s, 1e-3 * step_ms);
        if (steps.amplitudes.size() > kMostSteps && step_ms < kSlopeStepsMs.back()) continue;
        lift_faintest(steps, written.coarse);
        written.coarse.push_back("amplitude is in whole ms, slopes in steps of " +
                                 std::to_string(step_ms) + " ms, and in steps of 1/255");
        return steps;
    }
    return {};
}

}  // namespace

WrittenEffect write_android_timings(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    const SteppedAmplitudes steps = android_steps(pattern, target.map, written);
    written.text =
        text_of_json(
            Json{{"timings", steps.timings_ms}, {"amplitudes", steps.amplitudes}, {"repeat", -1}}) +
        "\n";
    return written;
}

WrittenEffect write_hla(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    const SteppedAmplitudes steps = android_steps(pattern, target.map, written);
    const int total_ms = std::accumulate(steps.timings_ms.begin(), steps.timings_ms.end(), 0);
    written.text = text_of_json(Json{{"ProjectName", "tactspace"},
                                     {"TrackName", valid_utf8(target.name)},
                                     {"Duration", total_ms},
                                     {"Timings", steps.timings_ms},
                                     {"Amplitudes", steps.amplitudes},
                                     {"Repeat", -1},
                                     {"RequiredAudioFiles", Json::array()},
                                     {"Audios", Json::array()}}) +
                   "\n";
    return written;
}

}  // namespace tact
