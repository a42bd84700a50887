#include "model/io/formats/ahap/ahap_pair.h"

#include <algorithm>

#include "model/io/formats/ahap/ahap.h"
#include "model/pattern/curves.h"

namespace tact {

namespace {

// A name as an effect has it, without ".ahap".
std::string_view without_ending(const char* ending) {
    const std::string_view whole = ending;
    return whole.substr(0, whole.rfind('.'));
}

}  // namespace

std::optional<std::string> second_of_pair(std::string_view path) {
    const std::string_view ending = kContinuousEnding;
    if (!path.ends_with(ending)) return std::nullopt;
    return std::string(path.substr(0, path.size() - ending.size())) + kTransientsEnding;
}

std::optional<EffectsRead> joined_pair(const EffectsRead& continuous,
                                       const EffectsRead& transients) {
    const auto is_one_ahap = [](const EffectsRead& read) {
        return read.format == kAhapFormats.data() && read.effects.size() == 1;
    };
    if (!is_one_ahap(continuous) || !is_one_ahap(transients)) return std::nullopt;
    const Effect& first = continuous.effects.front();
    const Effect& second = transients.effects.front();
    const bool silent = peak_value(second.pattern.amplitude_curve) == 0.0;
    const std::string_view ending = without_ending(kContinuousEnding);
    const bool named = first.name.ends_with(ending);
    if (!silent || !named || first.project != second.project) return std::nullopt;
    EffectsRead pair = continuous;
    Effect& effect = pair.effects.front();
    effect.name.erase(effect.name.size() - ending.size());
    std::vector<Transient>& all = effect.pattern.transients;
    add_bursts(all, second.pattern.transients);
    if (all.size() > limits::kMaxTransients) return std::nullopt;
    std::ranges::stable_sort(all, {}, &Transient::time_s);
    const double end_s = std::max(effect.pattern.duration_s, second.pattern.duration_s);
    AmplitudeCurve& curve = effect.pattern.amplitude_curve;
    // A curve is held behind its last point: silent from the first one's end on.
    const double own_end_s = effect.pattern.duration_s;
    if (end_s > own_end_s && curve.back().value > 0.0) {
        const bool jump = curve.size() > 1 && curve[curve.size() - 2].time_s == own_end_s;
        if (jump) curve.pop_back();
        if (curve.size() == limits::kMaxCurvePoints) return std::nullopt;
        curve.push_back({own_end_s, 0.0});
    }
    effect.pattern.duration_s = end_s;
    for (const std::string& remark : second.remarks) remark_once(effect.remarks, remark);
    const bool sounds =
        !effect.pattern.transients.empty() ||
        effect.pattern.amplitude_g * peak_value(effect.pattern.amplitude_curve) > 0.0;
    if (sounds) {  // though one of the two does not
        std::erase_if(effect.remarks,
                      [](const std::string& one) { return one.starts_with("it is silent"); });
    }
    return pair;
}

}  // namespace tact
