#include "devices/device/ledger.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/text/numbers.h"

namespace tact {

namespace {

// The sum of a single pass, up to a time within it.
double sum_until(const Load& load, double time_s) {
    if (time_s <= 0.0) return 0.0;
    if (time_s >= load.length_s) return load.sums_s.back();
    const double blocks = time_s / kLedgerBlockS;
    const auto whole = std::min(static_cast<std::size_t>(blocks), load.sums_s.size() - 2);
    const double begin_s = static_cast<double>(whole) * kLedgerBlockS;
    const double width_s = std::min(kLedgerBlockS, load.length_s - begin_s);
    const double share = std::min(1.0, (time_s - begin_s) / width_s);
    return load.sums_s[whole] + share * (load.sums_s[whole + 1] - load.sums_s[whole]);
}

// The sum of its repetition, from its first pass on.
double sum_of_rounds(const Load& load, double time_s) {
    const double rounds = std::floor(time_s / load.length_s);
    return rounds * load.sums_s.back() + sum_until(load, time_s - rounds * load.length_s);
}

}  // namespace

Load load_of(std::span<const float> samples, double rate_hz) {
    Load load;
    load.length_s = static_cast<double>(samples.size()) / rate_hz;
    double sum_s = 0.0;
    for (std::size_t n = 0; n < samples.size(); ++n) {
        sum_s += static_cast<double>(samples[n]) * static_cast<double>(samples[n]) / rate_hz;
        const double end_s = static_cast<double>(n + 1) / rate_hz;
        const double block_s = static_cast<double>(load.sums_s.size()) * kLedgerBlockS;
        if (end_s >= block_s - 1e-9 || n + 1 == samples.size()) load.sums_s.push_back(sum_s);
    }
    return load;
}

std::string words_on_held(double kept, bool is_warm) {
    if (is_warm) {
        return "ended early: the actuator was driven for as long on end as it may be, and needs a "
               "rest as long";
    }
    if (kept >= 1.0) return {};
    return "was held back to " + percent_done(kept) +
           " of its level: with what was played just before, the actuator would have got more in "
           "one second, or moved farther, than it may";
}

bool note(Ledger& ledger, double sample, double duration_s, bool is_driven) {
    ledger.square_s += sample * sample * duration_s;
    ledger.filled_s += duration_s;
    if (ledger.filled_s < kLedgerBlockS - 1e-9) return false;
    if (is_driven) {
        note_driven(ledger, kLedgerBlockS);
    } else {
        ledger.driven_s = std::max(0.0, ledger.driven_s - kLedgerBlockS);
    }
    ledger.squares_s[ledger.next] = ledger.square_s;
    ledger.next = (ledger.next + 1) % kLedgerBlocks;
    ledger.square_s = 0.0;
    ledger.filled_s = std::max(0.0, ledger.filled_s - kLedgerBlockS);
    return true;
}

void note_motion(Ledger& ledger, double duration_s, const MotionStretch& drive,
                 const MotionStretch& under) {
    ledger.motion = at_rest_after(ledger.motion, ledger.f0_hz, duration_s);
    for (const MotionStretch* each : {&under, &drive}) {
        if (each->travel == nullptr || each->travel->motions.empty()) continue;
        const Motion more = driven_by(*each->travel, each->from_s, each->to_s, each->level);
        ledger.motion.x_mm += more.x_mm;
        ledger.motion.v_mm_s += more.v_mm_s;
        ledger.f0_hz = each->travel->f0_hz;
    }
}

void note_driven(Ledger& ledger, double driven_s) { ledger.driven_s += std::max(0.0, driven_s); }

void note_rest(Ledger& ledger, double rest_s) {
    ledger.driven_s = std::max(0.0, ledger.driven_s - std::max(0.0, rest_s));
    ledger.motion = at_rest_after(ledger.motion, ledger.f0_hz, rest_s);
    const double blocks = std::ceil(std::clamp(rest_s, 0.0, 1.0) / kLedgerBlockS - 1e-6);
    // A block more or less: what was given counts as less long ago rather than longer.
    for (double block = 1.0; block < blocks; block += 1.0) {
        ledger.squares_s[ledger.next] = std::exchange(ledger.square_s, 0.0);
        ledger.next = (ledger.next + 1) % kLedgerBlocks;
    }
}

double left_s(const Ledger& ledger, double rest_after_s) {
    return std::max(0.0, rest_after_s - ledger.driven_s);
}

double allowed_level(const Ledger& ledger, const Load& load, double from_s, bool loop,
                     double rms_limit) {
    if (!(rms_limit > 0.0) || !(load.length_s > 0.0)) return 1.0;
    const double most_s = rms_limit * rms_limit;
    const double share = std::min(1.0, ledger.filled_s / kLedgerBlockS);
    const auto until = [&](double time_s) {
        return loop ? sum_of_rounds(load, time_s) : sum_until(load, time_s);
    };
    const double before_s = until(from_s);
    double square = 1.0;
    double given_s = ledger.square_s;  // within a window's part that has passed
    // Windows that end ever sooner, and reach ever farther back.
    for (std::size_t back = 0; back + 1 < kLedgerBlocks; ++back) {
        const std::size_t newest = ledger.next + 2 * kLedgerBlocks - 1 - back;
        const double oldest_s = ledger.squares_s[newest % kLedgerBlocks];
        const auto ahead = static_cast<double>(kLedgerBlocks - 1 - back) * kLedgerBlockS;
        const double given_within_s = given_s + (1.0 - share) * oldest_s;
        const double coming_s = until(from_s + ahead) - before_s;
        if (given_within_s > 0.0 && coming_s > 0.0) {
            square = std::min(square, std::max(0.0, most_s - given_within_s) / coming_s);
        }
        given_s += oldest_s;
    }
    return std::sqrt(square);
}

}  // namespace tact
