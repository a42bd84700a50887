// On-off times in ms for navigator.vibrate, as a JSON array.
//
// Source    on_off.h; limits of Chrome: 99 times, 10,000 ms each
// Output    no amplitude, but in the share of time that the motor runs, and no frequency. Where 99
//           times do not hold it, pulses within a burst become longer, up to four times; then what
//           they hold is kept from the beginning on.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "model/io/effects_out/on_off.h"
#include "model/io/effects_out/shares.h"
#include "model/io/effects_out/stepped.h"
#include "model/io/formats/vibrate/vibrate.h"
#include "model/text/numbers.h"

namespace tact {

namespace {

constexpr int kCoarsest = 4;  // pulses of 60 ms: longer ones are felt one by one

// Times that one entry holds, with 0 ms of the other state between.
std::vector<int> within_limit(const std::vector<int>& ms) {
    std::vector<int> entries;
    for (int length_ms : ms) {
        for (; length_ms > kLongestVibrateMs; length_ms -= kLongestVibrateMs) {
            entries.insert(entries.end(), {kLongestVibrateMs, 0});
        }
        entries.push_back(length_ms);
    }
    return entries;
}

bool has_shares(const SteppedAmplitudes& steps) {
    return std::ranges::any_of(steps.amplitudes,
                               [](int amplitude) { return amplitude > 0 && amplitude < 255; });
}

void remark_on(const OnOff& on_off, std::vector<std::string>& remarks) {
    if (on_off.lengthened > 0) {
        const auto count = static_cast<std::size_t>(on_off.lengthened);
        remarks.push_back(
            (count == 1 ? "a part of less than 15 ms is"
                        : grouped_digits(count) + " parts of less than 15 ms are") +
            std::string(" played for 15 ms, which a motor needs to be felt (a guess)"));
    }
    if (on_off.floor_lost_s > 0.0) {
        remarks.push_back(significant_digits(on_off.floor_lost_s, 3) +
                          " s are left out, which are too weak or too close to others to be felt");
    }
}

// With the shortest pulses that 99 times hold; the beginning of what is longer even so.
std::vector<int> fitting_entries(const SteppedAmplitudes& steps,
                                 std::vector<std::string>& remarks) {
    OnOff on_off = on_off_of(steps);
    std::vector<int> entries = within_limit(on_off.ms);
    int coarser = 1;
    const int coarsest = has_shares(steps) ? kCoarsest : 1;
    while (entries.size() > kMostVibrateEntries && coarser < coarsest) {
        on_off = on_off_of(steps, ++coarser);
        entries = within_limit(on_off.ms);
    }
    remark_on(on_off, remarks);
    if (coarser > 1) {
        remarks.push_back("pulses are up to " + std::to_string(coarser) +
                          " times as long as usual: browsers take 99 times");
    }
    if (entries.size() <= kMostVibrateEntries) return entries;
    const double whole_s = 1e-3 * std::accumulate(entries.begin(), entries.end(), 0.0);
    entries.resize(kMostVibrateEntries);
    const double kept_s = 1e-3 * std::accumulate(entries.begin(), entries.end(), 0.0);
    remarks.push_back("the first " + significant_digits(kept_s, 3) + " of " +
                      significant_digits(whole_s, 3) + " s are kept: browsers take 99 times");
    return entries;
}

}  // namespace

WrittenEffect write_vibrate(const Pattern& pattern, const EffectTarget& target) {
    WrittenEffect written;
    PlainCurves curves = with_pulses(as_curves(pattern, written), written.remarks);
    remark_left_out_hz(curves.frequency, written.remarks);
    curves.frequency = {{0.0, target.map.frequency_hz.low}};  // it is no longer asked for
    const Shares shares = as_shares(curves, target.map, written);
    const SteppedAmplitudes steps = stepped(shares.amplitude, curves.duration_s, 1e-3);
    if (has_shares(steps)) {
        written.remarks.emplace_back("amplitude becomes the share of time that the motor runs");
    }
    written.text = text_of_json(Json(fitting_entries(steps, written.remarks))) + "\n";
    return written;
}

}  // namespace tact
